//! What is read and written in a network, as source documents write it.

use ladder_notation::xml::Element;
use roxmltree::Node;

/// Indices nest no deeper.
const DEEPEST: usize = 8;

/// An access as an operand.
pub(super) fn operand(node: Node<'_, '_>, depth: usize) -> String {
    if depth > DEEPEST {
        return "?".to_owned();
    }
    let scope = node.attribute("Scope").unwrap_or_default();
    if let Some(symbol) = node.child("Symbol") {
        return path(symbol, scope, depth);
    }
    if let Some(constant) = node.child("Constant") {
        if let Some(name) = constant.attribute("Name") {
            let sign = if scope.starts_with("Local") { "#" } else { "" };
            return format!("{sign}\"{name}\"");
        }
        return constant
            .child("ConstantValue")
            .map(|node| node.words())
            .unwrap_or_default();
    }
    if let Some(label) = node.child("Label") {
        return label.attribute("Name").unwrap_or_default().to_owned();
    }
    node.child("Address").map_or_else(|| "?".to_owned(), address)
}

/// The components of a symbol, or of an instance.
pub(super) fn path(symbol: Node<'_, '_>, scope: &str, depth: usize) -> String {
    let mut out = String::new();
    for (number, component) in symbol.children_of("Component").enumerate() {
        let name = component.attribute("Name").unwrap_or_default();
        if number == 0 && scope.starts_with("Local") {
            out.push('#');
        } else if number > 0 {
            out.push('.');
        }
        out.push_str(&format!("\"{name}\""));
        let indices: Vec<String> = component
            .children_of("Access")
            .map(|index| operand(index, depth + 1))
            .collect();
        if !indices.is_empty() {
            out.push_str(&format!("[{}]", indices.join(", ")));
        }
        if let Some(slice) = component
            .attribute("SliceAccessModifier")
            .filter(|slice| *slice != "undef")
        {
            out.push_str(&format!(".%{}", slice.to_ascii_uppercase()));
        }
    }
    out
}

/// An absolute address, which is counted in bits.
fn address(node: Node<'_, '_>) -> String {
    let area = match node.attribute("Area").unwrap_or_default() {
        "Input" => 'I',
        "Output" => 'Q',
        "Memory" => 'M',
        _ => return "?".to_owned(),
    };
    let bits: u32 = node
        .attribute("BitOffset")
        .and_then(|bits| bits.parse().ok())
        .unwrap_or_default();
    match node.attribute("Type").unwrap_or("Bool") {
        "Bool" => format!("%{area}{}.{}", bits / 8, bits % 8),
        "Byte" | "SInt" | "USInt" | "Char" => format!("%{area}B{}", bits / 8),
        "Word" | "Int" | "UInt" => format!("%{area}W{}", bits / 8),
        _ => format!("%{area}D{}", bits / 8),
    }
}
