//! XML within bounds: no document types, so no entities; not too many nodes.

mod text;

use crate::{LineColumn, Lines, ReadError};
use ladder_syntax::xml::{MOST_ATTRIBUTES, is_crowded};
use roxmltree::{Document, Error, Node, ParsingOptions};
pub use text::XmlText;

/// A file with more elements, texts and attributes is not read.
const MOST_NODES: u32 = 2_000_000;

/// A file, with the places of its elements.
pub struct Xml<'t> {
    /// Its elements.
    pub document: Document<'t>,
    lines: Lines,
}

impl<'t> Xml<'t> {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// If it is not XML, or too large.
    pub fn parse(text: &'t str) -> Result<Xml<'t>, ReadError> {
        if is_crowded(text) {
            return Err(ReadError::whole(format!(
                "an element of the file has more than {MOST_ATTRIBUTES} attributes; projects do not"
            )));
        }
        let options = ParsingOptions {
            nodes_limit: MOST_NODES,
            ..ParsingOptions::default()
        };
        let document = Document::parse_with_options(text, options).map_err(|error| {
            let place = match error {
                Error::UnexpectedEndOfStream | Error::UnclosedRootNode => {
                    Lines::of(text).place(text, text.len())
                }
                _ => LineColumn {
                    line: error.pos().row,
                    column: error.pos().col,
                },
            };
            ReadError::at(place, why(&error))
        })?;
        let lines = Lines::of(text);
        Ok(Xml { document, lines })
    }

    /// Where an element begins.
    pub fn place(&self, node: Node<'_, '_>) -> LineColumn {
        self.lines.place(self.document.input_text(), node.range().start)
    }

    /// Where the [words](Element::words) of an element begin.
    pub fn place_of_words(&self, node: Node<'_, '_>) -> LineColumn {
        let mut texts = node.descendants().filter(Node::is_text);
        let first = texts.find(|text| text.text().is_some_and(|text| !text.trim().is_empty()));
        let Some(first) = first else {
            return self.place(node);
        };
        let text = self.document.input_text();
        let rest = text[first.range().start..].trim_start();
        let rest = rest.strip_prefix("<![CDATA[").unwrap_or(rest).trim_start();
        self.lines.place(text, text.len() - rest.len())
    }
}

fn why(error: &Error) -> String {
    match error {
        Error::DtdDetected => {
            "the file has a document type (`<!DOCTYPE`), which no project needs: take it out".to_owned()
        }
        Error::NodesLimitReached => format!("the file has more than {MOST_NODES} elements; projects do not"),
        Error::UnexpectedEndOfStream | Error::UnclosedRootNode => {
            "the file ends too early, as one that was not saved or copied whole: export it again".to_owned()
        }
        other => {
            let told = other.to_string();
            // The place is told apart from it.
            let told = told.rsplit_once(" at ").map_or(told.as_str(), |(told, _)| told);
            format!("this is not XML as it must be: {told}")
        }
    }
}

/// What an element has, by names without their namespaces.
pub trait Element<'a, 't: 'a>: Sized {
    /// Its name.
    fn name(&self) -> &'t str;
    /// Whether this is its name.
    fn is(&self, name: &str) -> bool;
    /// The elements in it.
    fn elements(&self) -> impl Iterator<Item = Node<'a, 't>> + use<'a, 't, Self>;
    /// The first element of this name in it.
    fn child(&self, name: &str) -> Option<Node<'a, 't>>;
    /// All elements of this name in it.
    fn children_of(&self, name: &str) -> impl Iterator<Item = Node<'a, 't>>;
    /// All that is written in it, however deep, without blanks at the ends.
    fn words(&self) -> String;
    /// Whether an attribute is `true`.
    fn flag(&self, name: &str) -> bool;
}

impl<'a, 't: 'a> Element<'a, 't> for Node<'a, 't> {
    fn name(&self) -> &'t str {
        self.tag_name().name()
    }

    fn is(&self, name: &str) -> bool {
        Element::name(self).eq_ignore_ascii_case(name)
    }

    fn elements(&self) -> impl Iterator<Item = Node<'a, 't>> + use<'a, 't> {
        self.children().filter(Node::is_element)
    }

    fn child(&self, name: &str) -> Option<Node<'a, 't>> {
        self.elements().find(|child| child.is(name))
    }

    fn children_of(&self, name: &str) -> impl Iterator<Item = Node<'a, 't>> {
        self.elements().filter(move |child| child.is(name))
    }

    fn words(&self) -> String {
        let all = self.descendants().filter(Node::is_text);
        let all: String = all.filter_map(|node| node.text()).collect();
        all.trim().to_owned()
    }

    fn flag(&self, name: &str) -> bool {
        matches!(self.attribute(name), Some("true" | "1"))
    }
}

/// What an element is and all that is in it, in one line: `step name=Start initialStep=true`. Where it is drawn is left out.
pub fn in_words(node: Node<'_, '_>) -> String {
    let is_place = |inner: &Node<'_, '_>| ["position", "relPosition"].iter().any(|name| inner.is(name));
    let mut words = Vec::new();
    for inner in node.descendants() {
        if inner.is_text() {
            let text = inner.text().unwrap_or_default();
            words.extend(text.split_whitespace().map(str::to_owned));
        } else if inner.is_element() && !is_place(&inner) {
            words.push(Element::name(&inner).to_owned());
            let told = inner
                .attributes()
                .filter(|it| !matches!(it.name(), "width" | "height"));
            words.extend(told.map(|it| format!("{}={}", it.name(), it.value())));
        }
    }
    words.join(" ")
}

/// Appends what stands for a text in a text or an attribute. What XML cannot hold at all is left out.
pub fn escape(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(c),
            '\r' => out.push_str("&#13;"),
            c => out.push(held(c)),
        }
    }
}

/// Appends a text as a section of characters. What XML cannot hold at all is left out.
pub fn section(out: &mut String, text: &str) {
    let inside: String = text.chars().map(held).collect();
    // A section ends at the first of these.
    let inside = inside.replace("]]>", "]]]]><![CDATA[>");
    out.push_str(&format!("<![CDATA[{inside}]]>"));
}

/// A character, or a blank for one that XML cannot hold.
fn held(c: char) -> char {
    let is_blank = matches!(c, '\n' | '\t');
    if (c.is_control() && !is_blank) || matches!(c, '\u{fffe}' | '\u{ffff}') {
        return ' ';
    }
    c
}
