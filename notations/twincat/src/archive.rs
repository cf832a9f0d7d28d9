//! The objects of an archive: `<o>` with fields, `<v>` values, `<l2>` and `<a>` lists, `<n/>` nothing. A field is found by its
//! name; what an object is says its own `t`, or the `cet` of its list.

use roxmltree::Node;

/// An object, a value, a list or nothing.
#[derive(Clone, Copy)]
pub(crate) struct Object<'a> {
    pub(crate) node: Node<'a, 'a>,
    /// What the list that it is in says its elements are.
    of_list: Option<&'a str>,
}

impl<'a> Object<'a> {
    pub(crate) fn of(node: Node<'a, 'a>) -> Object<'a> {
        Object { node, of_list: None }
    }

    /// What it is: `BoxTreeBox`.
    pub(crate) fn kind(self) -> &'a str {
        self.node.attribute("t").or(self.of_list).unwrap_or_default()
    }

    /// Whether nothing is at its place.
    pub(crate) fn is_nothing(self) -> bool {
        self.node.has_tag_name("n")
    }

    /// A field. What is nothing is not there.
    pub(crate) fn field(self, name: &str) -> Option<Object<'a>> {
        let mut fields = self.node.children().filter(Node::is_element);
        let found = fields
            .find(|field| field.attribute("n") == Some(name))
            .map(Object::of);
        found.filter(|field| !field.is_nothing())
    }

    /// The elements of a list, those that are nothing too: places count.
    pub(crate) fn elements(self) -> impl Iterator<Item = Object<'a>> {
        let of_list = self.node.attribute("cet");
        self.node
            .children()
            .filter(Node::is_element)
            .map(move |node| Object { node, of_list })
    }

    /// A value without the signs around it.
    pub(crate) fn value(self) -> &'a str {
        let text = self.node.text().unwrap_or_default();
        let inside = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        inside.unwrap_or(text)
    }

    /// The text of a field; nothing is empty.
    pub(crate) fn text(self, name: &str) -> &'a str {
        self.field(name).map_or("", Object::value)
    }

    /// Whether a field is true.
    pub(crate) fn is(self, name: &str) -> bool {
        self.text(name).eq_ignore_ascii_case("true")
    }

    /// The bits that say how an operand or a box is meant.
    pub(crate) fn flags(self) -> u32 {
        let flags = self.field("Flags");
        flags.map_or(0, |flags| flags.text("Flags").trim().parse().unwrap_or(u32::MAX))
    }

    /// The names in one of a box's lists of parameters.
    pub(crate) fn names(self, list: &str) -> Vec<&'a str> {
        let names = self.field(list).and_then(|list| list.field("Names"));
        names
            .iter()
            .flat_map(|names| names.elements())
            .map(Object::value)
            .collect()
    }
}
