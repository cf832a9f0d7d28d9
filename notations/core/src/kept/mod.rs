//! An XML file in which only what was changed is written again.
//!
//! ```text
//! original --read, written--> before --.
//!     '--read, edited, written--> after --merge--> the original with what after has otherwise than before
//! ```
//!
//! Before and after come from one writer, so what they have in common says the same and stays as the original has it, to the letter. What
//! the original alone has was not read, and stays.

mod order;

use crate::ReadError;
use crate::xml::Xml;
pub use order::merge_lists;
use order::{Region, regions};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// What of a file is known again by what.
#[derive(Debug, Clone, Copy)]
pub struct Rules {
    /// What tells an element from others of its name that are next to it; none: its number among them.
    pub key: fn(Node<'_, '_>) -> Option<String>,
    /// What an element says that is known again by that, in the order in which they are: rungs and lines.
    pub says: fn(Node<'_, '_>) -> Option<String>,
    /// Whether what is in an element of the original is not known again in what is written of it: it is written again if any of it is
    /// changed.
    pub is_whole: fn(own: Node<'_, '_>, written: Node<'_, '_>) -> bool,
    /// The text of an element that is changed: out of what the original has, what is written of it, and what is written now. None: it
    /// is written again with its element.
    pub text: fn(node: Node<'_, '_>, own: &str, written: &str, now: &str) -> Option<String>,
    /// The attribute with the number of an element in an order, which says nothing.
    pub number: &'static str,
    /// Attributes of which one means something only with the others.
    pub together: &'static [&'static str],
    /// Whether an element says the same as another one that is changed, in another form.
    pub repeats: fn(of: Node<'_, '_>, changed: Node<'_, '_>) -> bool,
    /// The name by which others use an element. What the writer alone has is put into the original once something changed uses it.
    pub used_by: fn(Node<'_, '_>) -> Option<String>,
}

/// Puts what is changed between two files of one writer into the one that the first is about.
///
/// # Errors
///
/// If one of them is not XML.
pub fn merge(original: &str, before: &str, after: &str, rules: &Rules) -> Result<String, ReadError> {
    let [own, old, new] = [original, before, after].map(Xml::parse);
    let (own, old, new) = (own?, old?, new?);
    let mut merge = Merge {
        rules,
        text: original,
        edits: Vec::new(),
        waiting: Vec::new(),
    };
    let roots = [&own, &old, &new].map(|xml| xml.document.root_element());
    let [own, old, new] = roots;
    merge.element(own, old, new);
    merge.put_what_is_used();
    Ok(merge.merged())
}

/// The changes of a file.
struct Merge<'a, 't> {
    rules: &'a Rules,
    text: &'t str,
    /// What is in the place of what; none overlap.
    edits: Vec<(Range<usize>, String)>,
    waiting: Vec<Waiting<'a, 't>>,
}

/// What the writer alone has.
struct Waiting<'a, 't> {
    /// Where it goes: into an element, after a part of it.
    into: Node<'a, 't>,
    after: Option<Node<'a, 't>>,
    element: String,
    /// What others use it by.
    names: Vec<String>,
}

/// An element as its file has it.
fn source<'t>(node: Node<'_, 't>) -> &'t str {
    &node.document().input_text()[node.range()]
}

fn elements<'a, 't>(node: Node<'a, 't>) -> Vec<Node<'a, 't>> {
    node.children().filter(Node::is_element).collect()
}

fn saying<'n, 'd>(
    node: Node<'n, 'd>,
    says: fn(Node<'_, '_>) -> Option<String>,
) -> Vec<(String, Node<'n, 'd>)> {
    let parts = elements(node).into_iter();
    parts.filter_map(|part| Some((says(part)?, part))).collect()
}

fn words(node: Node<'_, '_>) -> String {
    node.children().filter_map(|child| child.text()).collect()
}

/// Where the tag ends that begins an element.
fn end_of_tag(text: &str, node: Node<'_, '_>) -> usize {
    let start = node.range().start;
    let mut quote = None;
    for (at, c) in text.as_bytes()[start..].iter().enumerate() {
        match (quote, *c) {
            (None, b'>') => return start + at + 1,
            (None, b'"' | b'\'') => quote = Some(*c),
            (Some(open), c) if open == c => quote = None,
            _ => {}
        }
    }
    node.range().end
}

impl<'a, 't> Merge<'a, 't> {
    fn merged(mut self) -> String {
        // Sorting keeps the order of what is put at one place.
        self.edits.sort_by_key(|(range, _)| (range.start, range.end));
        let line_end = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
        let (mut out, mut at) = (String::with_capacity(self.text.len()), 0);
        for (range, instead) in self.edits {
            out.push_str(self.text.get(at..range.start).unwrap_or_default());
            out.push_str(&instead.replace("\r\n", "\n").replace('\n', line_end));
            at = at.max(range.end);
        }
        out.push_str(&self.text[at..]);
        out
    }

    /// An element that is in all three. Whether anything in it is changed.
    fn element(&mut self, own: Node<'a, 't>, old: Node<'_, '_>, new: Node<'_, '_>) -> bool {
        if source(old) == source(new) {
            self.note_missing(own, new);
            return false;
        }
        let has_parts = [old, new]
            .iter()
            .any(|node| node.children().any(|child| child.is_element()));
        if has_parts && (self.rules.is_whole)(own, old) {
            self.edits.push((own.range(), source(new).to_owned()));
            return true;
        }
        if !has_parts && words(old) != words(new) {
            let edit = self
                .text_of(own, old, new)
                .unwrap_or((own.range(), source(new).to_owned()));
            self.edits.push(edit);
            return true;
        }
        let before = self.edits.len();
        self.attributes(own, old, new);
        self.known_by_key(own, old, new);
        self.in_order(own, old, new);
        self.edits.len() > before
    }

    /// The text of an element that is changed, in the place of the one that is there.
    fn text_of(
        &self,
        own: Node<'_, '_>,
        old: Node<'_, '_>,
        new: Node<'_, '_>,
    ) -> Option<(Range<usize>, String)> {
        let [own_text, old_text, new_text] = [own, old, new].map(words);
        let there = own_text.trim();
        let element = &self.text[own.range()];
        let start = element.find(there).filter(|_| !there.is_empty())?;
        let text = (self.rules.text)(own, there, old_text.trim(), new_text.trim())?;
        let text = if element[..start].trim_end().ends_with("<![CDATA[") {
            text.replace("]]>", "]]]]><![CDATA[>")
        } else {
            let mut out = String::new();
            crate::xml::escape(&mut out, &text);
            out
        };
        let start = own.range().start + start;
        Some((start..start + there.len(), text))
    }

    fn attributes(&mut self, own: Node<'_, '_>, old: Node<'_, '_>, new: Node<'_, '_>) {
        let rules = self.rules;
        let is_changed = |name: &str| name != rules.number && old.attribute(name) != new.attribute(name);
        let is_one = rules.together.iter().any(|name| is_changed(name));
        let names = old.attributes().chain(new.attributes()).map(|it| it.name());
        let mut changed: Vec<&str> = names
            .filter(|name| is_changed(name) || (is_one && rules.together.contains(name)))
            .collect();
        changed.sort_unstable();
        changed.dedup();
        for name in changed {
            self.attribute(own, name, new.attribute(name));
        }
    }

    fn attribute(&mut self, own: Node<'_, '_>, name: &str, value: Option<&str>) {
        let there = own.attributes().find(|it| it.name() == name);
        let escaped = |value: &str| {
            let mut out = String::new();
            crate::xml::escape(&mut out, value);
            out
        };
        match (there, value) {
            (Some(there), Some(value)) if there.value() == value => {}
            (Some(there), Some(value)) => self.edits.push((there.range_value(), escaped(value))),
            (Some(there), None) => {
                let start = self.text[..there.range().start].trim_end().len();
                self.edits.push((start..there.range().end, String::new()));
            }
            (None, Some(value)) => {
                let end = end_of_tag(self.text, own);
                let tag = self.text[..end].trim_end_matches('>').trim_end_matches('/');
                let at = tag.trim_end().len();
                self.edits
                    .push((at..at, format!(" {name}=\"{}\"", escaped(value))));
            }
            (None, None) => {}
        }
    }

    /// What an element is known by among those in the same element.
    fn key(&self, node: Node<'_, '_>) -> (String, String) {
        let name = node.tag_name().name();
        let key = (self.rules.key)(node).unwrap_or_else(|| {
            let before = node.prev_siblings().skip(1);
            before
                .filter(|other| other.has_tag_name(name))
                .count()
                .to_string()
        });
        (name.to_owned(), key.to_uppercase())
    }

    fn parts<'n, 'd>(&self, node: Node<'n, 'd>) -> Vec<((String, String), Node<'n, 'd>)> {
        let mut parts = elements(node);
        parts.retain(|part| (self.rules.says)(*part).is_none());
        parts.into_iter().map(|part| (self.key(part), part)).collect()
    }

    fn known_by_key(&mut self, own: Node<'a, 't>, old: Node<'_, '_>, new: Node<'_, '_>) {
        let own_parts = self.parts(own);
        let [old_parts, new_parts] = [self.parts(old), self.parts(new)];
        let index = |parts: &[((String, String), Node<'_, '_>)]| {
            let mut index = HashMap::new();
            for (number, (key, _)) in parts.iter().enumerate() {
                index.entry(key.clone()).or_insert(number);
            }
            index
        };
        let (by_own, by_old, by_new) = (index(&own_parts), index(&old_parts), index(&new_parts));
        for (key, _) in &old_parts {
            if let (false, Some(there)) = (by_new.contains_key(key), by_own.get(key)) {
                self.remove(own_parts[*there].1);
            }
        }
        let mut last = None;
        for (number, (key, part)) in new_parts.iter().enumerate() {
            // Of two with one key the first is meant.
            if by_new[key] != number {
                continue;
            }
            let before = by_old.get(key).map(|old| old_parts[*old].1);
            let there = by_own.get(key).map(|own| own_parts[*own].1);
            let is_changed = match (before, there) {
                (Some(before), Some(there)) => self.element(there, before, *part),
                (Some(before), None) if source(before) == source(*part) => {
                    self.wait(own, last, *part);
                    false
                }
                (None, Some(there)) => {
                    // Both have made one of a name.
                    self.edits.push((there.range(), source(*part).to_owned()));
                    true
                }
                (_, None) => {
                    self.insert(own, last, source(*part));
                    true
                }
            };
            if is_changed {
                for other in own_parts.iter().map(|(_, other)| *other) {
                    if Some(other) != there && (self.rules.repeats)(other, *part) {
                        self.remove(other);
                    }
                }
            }
            last = there.or(last);
        }
    }

    /// Notes what the writer alone has in an element of which nothing is changed.
    fn note_missing(&mut self, own: Node<'a, 't>, written: Node<'_, '_>) {
        let parts = self.parts(written);
        if parts.is_empty() {
            return;
        }
        let own_parts: HashMap<_, _> = self.parts(own).into_iter().rev().collect();
        let mut last = None;
        for (key, part) in parts {
            match own_parts.get(&key) {
                Some(there) => {
                    self.note_missing(*there, part);
                    last = Some(*there);
                }
                None => self.wait(own, last, part),
            }
        }
    }

    fn wait(&mut self, into: Node<'a, 't>, after: Option<Node<'a, 't>>, part: Node<'_, '_>) {
        let names = part.descendants().filter_map(self.rules.used_by);
        let names: Vec<String> = names.map(|name| name.to_uppercase()).collect();
        if !names.is_empty() {
            let element = source(part).to_owned();
            self.waiting.push(Waiting {
                into,
                after,
                element,
                names,
            });
        }
    }

    /// Puts an element into another one, after this part of it.
    fn insert(&mut self, into: Node<'_, '_>, after: Option<Node<'_, '_>>, element: &str) {
        if let Some(after) = after {
            let at = after.range().end;
            let start = after.range().start;
            let indent = &self.text[self.text[..start].trim_end_matches([' ', '\t']).len()..start];
            let element = format!("\n{indent}{element}");
            self.edits.push((at..at, element));
            return;
        }
        let end = end_of_tag(self.text, into);
        if !self.text[..end].ends_with("/>") {
            self.edits.push((end..end, format!("\n{element}")));
            return;
        }
        let opened = end - 2..end;
        match self.edits.iter_mut().find(|(range, _)| *range == opened) {
            // Something was put into it before.
            Some((_, inside)) => {
                let at = inside.rfind("</").unwrap_or(inside.len());
                inside.insert_str(at, &format!("{element}\n"));
            }
            None => {
                let name = self.text[into.range().start + 1..]
                    .split(|c: char| c.is_whitespace() || c == '/')
                    .next()
                    .unwrap_or_default();
                self.edits.push((opened, format!(">\n{element}\n</{name}>")));
            }
        }
    }

    /// Puts in what the writer alone has and something changed uses.
    fn put_what_is_used(&mut self) {
        let mut seen = 0;
        let mut used: HashSet<String> = HashSet::new();
        while seen < self.edits.len() {
            for (_, text) in &self.edits[seen..] {
                let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
                used.extend(words.map(str::to_uppercase));
            }
            seen = self.edits.len();
            let waiting = std::mem::take(&mut self.waiting).into_iter();
            let (wanted, rest): (Vec<_>, Vec<_>) =
                waiting.partition(|waiting| waiting.names.iter().any(|name| used.contains(name)));
            self.waiting = rest;
            for Waiting {
                into, after, element, ..
            } in wanted
            {
                self.insert(into, after, &element);
            }
        }
    }

    /// Takes out an element with the line that it begins.
    fn remove(&mut self, node: Node<'_, '_>) {
        let range = node.range();
        let before = self.text[..range.start].trim_end_matches([' ', '\t']);
        let before = before
            .strip_suffix('\n')
            .map(|line| line.strip_suffix('\r').unwrap_or(line));
        let start = before.map_or(range.start, str::len);
        self.edits.push((start..range.end, String::new()));
    }

    /// What is known by what it says, in its order.
    fn in_order(&mut self, own: Node<'a, 't>, old: Node<'_, '_>, new: Node<'_, '_>) {
        let says = self.rules.says;
        let own_parts: Vec<(String, Node<'a, 't>)> = saying(own, says);
        let [old_parts, new_parts] = [saying(old, says), saying(new, says)];
        if old_parts.is_empty() && new_parts.is_empty() {
            return;
        }
        let told = |parts: &[(String, Node<'_, '_>)]| -> Vec<String> {
            parts.iter().map(|(says, _)| says.clone()).collect()
        };
        let bare = |parts: &[(String, Node<'_, '_>)]| -> Vec<String> {
            parts
                .iter()
                .map(|(_, part)| self.unnumbered(source(*part)))
                .collect()
        };
        let texts = [told(&own_parts), told(&old_parts)];
        let forms = [bare(&old_parts), bare(&new_parts)];
        let mut number = 0;
        let mut last = None;
        for Region { own: at, old, new } in regions(&texts, &forms) {
            let (there, before, after) = (
                &own_parts[at.clone()],
                &old_parts[old.clone()],
                &new_parts[new.clone()],
            );
            if forms[0][old.clone()] == forms[1][new.clone()] {
                for (_, part) in there {
                    self.renumber(*part, &own_parts, number);
                    number += 1;
                }
            } else if let ([(_, part)], [(_, before)], [(_, after)]) = (there, before, after) {
                let known = self.edits.len();
                self.element(*part, *before, *after);
                let mut edits = self.edits[known..].iter();
                match edits.position(|(range, _)| *range == part.range()) {
                    Some(whole) => {
                        self.edits[known + whole].1 = self.numbered(source(*after), number);
                    }
                    None => self.renumber(*part, &own_parts, number),
                }
                number += 1;
            } else {
                let mut after = after.iter().map(|(_, part)| source(*part));
                for (_, part) in there {
                    match after.next() {
                        Some(instead) => {
                            let instead = self.numbered(instead, number);
                            self.edits.push((part.range(), instead));
                            number += 1;
                        }
                        None => self.remove(*part),
                    }
                }
                let last = there.last().map(|(_, part)| *part).or(last);
                for element in after {
                    let element = self.numbered(element, number);
                    self.insert(own, last, &element);
                    number += 1;
                }
            }
            last = there.last().map(|(_, part)| *part).or(last);
        }
    }

    /// Where the number of an element is in its text.
    fn number_in(&self, element: &str) -> Option<Range<usize>> {
        let tag = &element[..element.find('>')?];
        let start = tag.find(&format!(" {}=\"", self.rules.number))? + self.rules.number.len() + 3;
        Some(start..start + tag[start..].find('"')?)
    }

    fn unnumbered(&self, element: &str) -> String {
        self.numbered(element, 0)
    }

    fn numbered(&self, element: &str, number: usize) -> String {
        let mut element = element.to_owned();
        if let Some(range) = self.number_in(&element) {
            element.replace_range(range, &number.to_string());
        }
        element
    }

    /// Renumbers an element that stays, if it had that of its place.
    fn renumber(&mut self, part: Node<'_, '_>, all: &[(String, Node<'_, '_>)], number: usize) {
        let first = all
            .first()
            .and_then(|(_, first)| first.attribute(self.rules.number));
        let place = all.iter().position(|(_, other)| *other == part);
        let has_place = part.attribute(self.rules.number) == place.map(|place| place.to_string()).as_deref();
        if first == Some("0") && has_place {
            self.attribute(part, self.rules.number, Some(&number.to_string()));
        }
    }
}
