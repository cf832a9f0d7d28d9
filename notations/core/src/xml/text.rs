//! XML as text: elements with their attributes, indented.

use super::escape;

/// A document on its way.
#[derive(Debug, Default)]
pub struct XmlText {
    out: String,
    depth: usize,
}

impl XmlText {
    /// A document without anything in it.
    pub fn start() -> XmlText {
        XmlText {
            out: "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n".to_owned(),
            depth: 0,
        }
    }

    /// A piece that is appended to a document later, so deep within it.
    pub fn within(depth: usize) -> XmlText {
        XmlText {
            depth,
            ..XmlText::default()
        }
    }

    /// Appends a piece.
    pub fn append(&mut self, piece: &XmlText) {
        self.out.push_str(&piece.out);
    }

    /// The text of it.
    pub fn finish(self) -> String {
        self.out
    }

    fn begin(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.out.extend(std::iter::repeat_n("  ", self.depth));
        self.out.push('<');
        self.out.push_str(name);
        for (key, value) in attributes {
            self.out.push(' ');
            self.out.push_str(key);
            self.out.push_str("=\"");
            escape(&mut self.out, value);
            self.out.push('"');
        }
    }

    /// An element with nothing in it.
    pub fn empty(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.begin(name, attributes);
        self.out.push_str("/>\n");
    }

    /// An element with a text in it.
    pub fn words(&mut self, name: &str, attributes: &[(&str, &str)], words: &str) {
        self.begin(name, attributes);
        self.out.push('>');
        escape(&mut self.out, words);
        self.out.push_str("</");
        self.out.push_str(name);
        self.out.push_str(">\n");
    }

    /// An element with others in it.
    pub fn around(&mut self, name: &str, attributes: &[(&str, &str)], inside: impl FnOnce(&mut XmlText)) {
        self.begin(name, attributes);
        self.out.push_str(">\n");
        self.depth += 1;
        let start = self.out.len();
        inside(self);
        self.depth -= 1;
        if self.out.len() == start {
            // Nothing came: `<name/>`.
            self.out.truncate(start - 2);
            self.out.push_str("/>\n");
            return;
        }
        self.out.extend(std::iter::repeat_n("  ", self.depth));
        self.out.push_str("</");
        self.out.push_str(name);
        self.out.push_str(">\n");
    }
}
