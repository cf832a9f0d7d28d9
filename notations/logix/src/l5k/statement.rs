//! The statements of L5K: attributes, and tags.

use crate::model::{Tag, Usage};

/// `name := value`, one after the other.
pub(super) struct Attributes<'t>(pub(super) Vec<(&'t str, &'t str)>);

impl<'t> Attributes<'t> {
    pub(super) fn of(text: &'t str) -> Attributes<'t> {
        let parts = parts(text, ',');
        let pairs = parts.into_iter().filter_map(|part| part.split_once(":="));
        Attributes(pairs.map(|(name, value)| (name.trim(), value.trim())).collect())
    }

    pub(super) fn text(&self, name: &str) -> String {
        let found = self.0.iter().find(|(own, _)| own.eq_ignore_ascii_case(name));
        found.map(|(_, value)| unquoted(value)).unwrap_or_default()
    }

    pub(super) fn told(&self) -> Option<String> {
        Some(self.text("Description")).filter(|told| !told.is_empty())
    }
}

/// A text without its quotes and their escapes.
pub(super) fn unquoted(text: &str) -> String {
    let inside = text.trim().trim_matches('"');
    inside
        .replace("$N", "\n")
        .replace("$Q", "\"")
        .replace("$\"", "\"")
        .replace("$'", "'")
}

/// What a character parts at the outermost level.
fn parts(text: &str, at: char) -> Vec<&str> {
    let mut out = Vec::new();
    let (mut start, mut open, mut quote, mut escaped) = (0, 0usize, None, false);
    for (offset, c) in text.char_indices() {
        match (quote, c) {
            (Some(_), _) if escaped => escaped = false,
            (Some(_), '$') => escaped = true,
            (Some(mark), c) if c == mark => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '(' | '[') => open += 1,
            (None, ')' | ']') => open = open.saturating_sub(1),
            (None, c) if c == at && open == 0 => {
                out.push(&text[start..offset]);
                start = offset + c.len_utf8();
            }
            _ => {}
        }
    }
    out.push(&text[start..]);
    out
}

/// A statement and the attributes in it.
pub(super) fn with_attributes(text: &str) -> (&str, Attributes<'_>) {
    match text.split_once('(') {
        Some((before, after)) => {
            let inside = parts(after, ')');
            (
                before.trim(),
                Attributes::of(inside.first().copied().unwrap_or_default()),
            )
        }
        None => (text, Attributes(Vec::new())),
    }
}

/// `name[3,5]`
pub(super) fn sizes(text: &str) -> (&str, Vec<u32>) {
    match text.split_once('[') {
        Some((name, sizes)) => {
            let sizes = sizes.trim_end_matches(']').split(',');
            (
                name.trim(),
                sizes
                    .filter_map(|size| size.trim().parse().ok())
                    .filter(|size| *size > 0)
                    .collect(),
            )
        }
        None => (text.trim(), Vec::new()),
    }
}

/// `t : TIMER (RADIX := Decimal) := [0,1000,0]`, `go OF Local:1:I.Data.3`
pub(super) fn tag(at: usize, text: &str) -> Tag {
    let (head, attributes) = with_attributes(text);
    let usage = match attributes.text("Usage").as_str() {
        "Input" => Usage::Input,
        "Output" => Usage::Output,
        "InOut" => Usage::InOut,
        _ => Usage::Local,
    };
    let mut tag = Tag {
        at,
        usage,
        required: attributes.text("Required").eq_ignore_ascii_case("Yes"),
        constant: matches!(attributes.text("Constant").as_str(), "1" | "Yes"),
        comment: attributes.told(),
        ..Tag::default()
    };
    let mut words = head.split_whitespace();
    let (name, second) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    if second == "OF" {
        name.clone_into(&mut tag.name);
        tag.alias = words.next().map(str::to_owned);
        return tag;
    }
    // The value is after the attributes, or right after the type.
    let value = match text.rsplit_once(") :=") {
        Some((_, value)) => Some(value),
        None => parts(head, '=').get(1).copied(),
    };
    let given = attributes.text("DefaultData");
    let value = value
        .map(str::trim)
        .or((!given.is_empty()).then_some(given.as_str()));
    tag.value = value.and_then(super::value);
    let head = head.split(":=").next().unwrap_or_default();
    let (name, ty) = head
        .split_once(" : ")
        .or_else(|| head.rsplit_once(':'))
        .unwrap_or((head, ""));
    let (ty, dimensions) = sizes(ty.trim());
    name.trim().clone_into(&mut tag.name);
    ty.clone_into(&mut tag.ty);
    tag.dimensions = dimensions;
    tag
}
