//! What is read and written in a network, as source documents write it.

use ladder_notation::xml::{Element, in_words};
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

/// The text of a network: of one in SCL as it is shown there, of any other all that is in it, in words.
pub(super) fn text(source: Node<'_, '_>) -> String {
    let Some(structured) = source.child("StructuredText") else {
        return in_words(source);
    };
    let mut out = String::new();
    words(structured, &mut out, 0);
    out.trim().to_owned()
}

/// The words of a text in SCL.
fn words(node: Node<'_, '_>, out: &mut String, depth: usize) {
    let attribute = |name: &str| node.attribute(name).unwrap_or_default();
    let count = || attribute("Num").parse().unwrap_or(1_usize).min(200);
    let is_call = attribute("Scope") == "Call" || node.child("CallInfo").is_some();
    match Element::name(&node) {
        "Token" => out.push_str(attribute("Text")),
        "Blank" => out.push_str(&" ".repeat(count())),
        "NewLine" => out.push_str(&"\n".repeat(count())),
        "LineComment" | "Comment" => out.push_str(&format!("(* {} *)", node.words())),
        "Text" => out.push_str(&node.words()),
        "Access" if !is_call && (node.child("Symbol").is_some() || node.child("Constant").is_some()) => {
            out.push_str(&operand(node, 0));
        }
        "StructuredText" | "Access" | "CallInfo" | "Instruction" | "Instance" | "Component" | "Parameter"
            if depth < DEEPEST =>
        {
            out.push_str(attribute("Name"));
            for inner in node.elements() {
                words(inner, out, depth + 1);
            }
        }
        _ => out.push_str(&in_words(node)),
    }
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
