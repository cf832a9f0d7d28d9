//! What is read and written in a network, as source documents write it.

use ladder_notation::LineColumn;
use ladder_notation::xml::{Element, Xml, in_words};
use roxmltree::Node;

/// Indices nest no deeper.
const DEEPEST: usize = 8;

/// Calls in calls in SCL nest no deeper: each has a few elements around it.
const DEEPEST_WORDS: usize = 100;

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
pub(super) fn text(xml: &Xml<'_>, source: Node<'_, '_>) -> (String, Vec<(usize, LineColumn)>) {
    let Some(structured) = source.child("StructuredText") else {
        return (in_words(source), Vec::new());
    };
    let mut words = Words {
        xml,
        text: String::new(),
        places: Vec::new(),
    };
    words.of(structured, 0);
    let blanks = words.text.len() - words.text.trim_start().len();
    for (at, _) in &mut words.places {
        *at = at.saturating_sub(blanks);
    }
    (words.text.trim().to_owned(), words.places)
}

/// The words of a text in SCL, and where they are in the file.
struct Words<'x, 't> {
    xml: &'x Xml<'t>,
    text: String,
    places: Vec<(usize, LineColumn)>,
}

impl Words<'_, '_> {
    fn of(&mut self, node: Node<'_, '_>, depth: usize) {
        let attribute = |name: &str| node.attribute(name).unwrap_or_default();
        let count = || attribute("Num").parse().unwrap_or(1_usize).min(200);
        self.places.push((self.text.len(), self.xml.place(node)));
        let kind = Element::name(&node);
        match kind {
            "Token" => self.text.push_str(attribute("Text")),
            "Blank" => self.text.push_str(&" ".repeat(count())),
            "NewLine" => self.text.push_str(&"\n".repeat(count())),
            "LineComment" | "Comment" => {
                // What ends a comment early is not in one.
                let told = node.words().replace("*)", "* )").replace("(*", "( *");
                self.text.push_str(&format!("(* {told} *)"));
            }
            "Text" => self.text.push_str(&node.words()),
            "ConstantValue" => self.text.push_str(&node.words()),
            // What the editor knows of a name besides.
            "ConstantType" | "TemplateValue" | "BooleanAttribute" | "IntegerAttribute"
            | "StringAttribute" => {}
            "Address" => self.text.push_str(&address(node)),
            "StructuredText" | "Access" | "Symbol" | "Constant" | "CallInfo" | "Instruction" | "Instance"
            | "Component" | "Parameter" | "NamelessParameter"
                if depth < DEEPEST_WORDS =>
            {
                self.named(node, kind);
                for inner in node.elements() {
                    self.of(inner, depth + 1);
                }
            }
            _ => self.text.push_str(&in_words(node)),
        }
    }

    /// The name of what has one: `#run`, `"Data"`, `motor`.
    fn named(&mut self, node: Node<'_, '_>, kind: &str) {
        let Some(name) = node.attribute("Name") else {
            return;
        };
        let is_plain = !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_');
        let owner = node.parent_element();
        let is_first = node.prev_sibling_element().is_none();
        // A symbol and a constant are in what has the scope.
        let scope = owner.and_then(|owner| {
            owner
                .attribute("Scope")
                .or_else(|| owner.parent_element()?.attribute("Scope"))
        });
        let is_local = scope.is_some_and(|scope| scope.starts_with("Local"));
        match kind {
            "Parameter" | "Instruction" => self.text.push_str(name),
            _ if is_local && is_first => {
                self.text.push('#');
                self.push_name(name, !is_plain);
            }
            // What is called is the instance, where there is one.
            "CallInfo" if node.child("Instance").is_some() => {}
            "CallInfo" | "Constant" => self.push_name(name, true),
            _ => self.push_name(name, is_first || !is_plain),
        }
        if let Some(slice) = node
            .attribute("SliceAccessModifier")
            .filter(|slice| *slice != "undef")
        {
            self.text.push_str(&format!(".%{}", slice.to_ascii_uppercase()));
        }
    }

    fn push_name(&mut self, name: &str, is_quoted: bool) {
        let quote = if is_quoted { "\"" } else { "" };
        self.text.push_str(&format!("{quote}{name}{quote}"));
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
