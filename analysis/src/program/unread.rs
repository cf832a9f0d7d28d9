//! Unread parts (LANGUAGE §5.9): blocks in the place of what no reader of another system understands. None of it runs, and what
//! it may write is not known: that is for each who says something of the program.

use super::{Block, BlockKind, Network, ParameterKind, Program, Role, Tag, TagId};
use crate::values::types::Type;
use rustc_hash::FxHashSet;
use std::borrow::Cow;

/// What the definition of a block says that is an unread part.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Unread {
    /// What it may write and when it runs.
    pub directive: UnreadDirective,
    /// The text of the definition without its name and the white space that means nothing.
    pub text: String,
    /// Whether the text of the other system is in the definition.
    pub has_foreign_text: bool,
}

/// What a comment says that makes a block an unread part: `unread, at any time, writes control, data`.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct UnreadDirective {
    /// It runs in another task: between any two networks, besides its places.
    pub at_any_time: bool,
    /// The tags that it may write, or parts of them, as they are written. None: it is not known which.
    pub writes: Option<Vec<String>>,
}

impl UnreadDirective {
    /// Reads what is after the word `unread`. None: it is none of the forms.
    pub fn read(after: &str) -> Option<UnreadDirective> {
        let mut rest = after.trim();
        let mut told = UnreadDirective::default();
        let next = |rest: &'_ str| -> Option<Option<String>> {
            match rest.trim() {
                "" => Some(None),
                rest => Some(Some(rest.strip_prefix(',')?.trim().to_owned())),
            }
        };
        let Some(mut form) = next(rest)? else {
            return Some(told);
        };
        if let Some(after) = form.strip_prefix("at any time") {
            told.at_any_time = true;
            let Some(after) = next(after)? else {
                return Some(told);
            };
            form = after;
        }
        rest = form.strip_prefix("writes")?;
        if !rest.is_empty() && !rest.starts_with(char::is_whitespace) {
            return None;
        }
        let names: Vec<String> = match rest.trim() {
            "" => Vec::new(),
            rest => outside_brackets(rest)
                .map(|name| name.trim().to_owned())
                .collect(),
        };
        if !names.iter().all(|name| is_path(name)) {
            return None;
        }
        told.writes = Some(names);
        Some(told)
    }
}

/// The parts of a list between the commas that are in no brackets.
fn outside_brackets(list: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0u32;
    list.split(move |c: char| {
        match c {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    })
}

/// Whether a text may name a tag or a part of one.
fn is_path(text: &str) -> bool {
    let begins = |c: char| c.is_alphabetic() || c == '_' || c == '%';
    let goes_on = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']' | ',' | ' ' | '-' | '%');
    let root = root_of(text);
    text.starts_with(begins) && text.chars().all(goes_on) && !root.contains([' ', ',', '-', ']'])
}

/// The name of the tag that a path begins with.
pub fn root_of(path: &str) -> &str {
    if path.starts_with('%') {
        return path;
    }
    path.split(['.', '[']).next().unwrap_or(path)
}

/// A text without white space that means nothing: between words one blank is left, in quotes all of it.
pub fn without_blanks(text: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut out = String::with_capacity(text.len());
    let mut quote = None;
    let mut is_pending = false;
    for c in text.chars() {
        if quote.is_none() && c.is_whitespace() {
            is_pending = true;
            continue;
        }
        if std::mem::take(&mut is_pending) && is_word(c) && out.ends_with(is_word) {
            out.push(' ');
        }
        match quote {
            Some(open) if open == c => quote = None,
            None if matches!(c, '\'' | '"') => quote = Some(c),
            _ => {}
        }
        out.push(c);
    }
    out
}

impl Program {
    /// The blocks that are unread parts, with their numbers.
    pub fn unread_parts(&self) -> impl Iterator<Item = (usize, &str, &Unread)> {
        let blocks = self.blocks.iter().enumerate();
        blocks
            .filter_map(|(number, block)| Some((number, unread_name(&block.name), block.unread.as_deref()?)))
    }

    /// What everyone says who runs, tests, compares, proves or explains a program with unread parts. None: it has none.
    pub fn unread_note(&self) -> Option<String> {
        unread_note(self.unread_parts().map(|(_, name, _)| name))
    }

    /// The tags that are seen in a network, by which an unread part there may read and write them.
    pub fn visible_in(&self, network: usize) -> Vec<TagId> {
        let body = self
            .blocks
            .iter()
            .position(|block| block.networks.contains(&network));
        let file = self.networks.get(network).map_or(0, |it| it.location.file);
        self.visible(body, file)
    }

    /// The tags that are seen in the main program.
    pub fn visible_in_main(&self) -> Vec<TagId> {
        self.visible(None, 0)
    }

    fn visible(&self, body: Option<usize>, file: u32) -> Vec<TagId> {
        let inside = self.instances.iter().flat_map(|instance| &instance.tags);
        let inside: FxHashSet<TagId> = inside.map(|(_, own)| *own).collect();
        let is_seen = |tag: &Tag| match tag.block {
            Some(block) => Some(block) == body,
            None => tag.shared || (body.is_none() && tag.location.file == file),
        };
        let all = (0u32..).map(TagId).zip(&self.tags);
        let own = all.filter(|(id, tag)| !inside.contains(id) && is_seen(tag));
        let mut seen: Vec<TagId> = own.map(|(id, _)| id).collect();
        // What is seen of a state of a block, all of it may be called to change.
        let mut known: FxHashSet<TagId> = seen.iter().copied().collect();
        loop {
            let before = seen.len();
            for instance in &self.instances {
                if known.contains(&instance.tag) {
                    let inside = instance.tags.iter().map(|(_, own)| *own);
                    seen.extend(inside.filter(|tag| known.insert(*tag)));
                }
            }
            if seen.len() == before {
                return seen;
            }
        }
    }

    /// Which of some tags an unread part may write that says so of all it sees: neither constants nor inputs.
    pub fn may_be_written(&self, tag: TagId) -> bool {
        let facts = &self.tags[tag.0 as usize];
        let is_input = facts.role == Role::Input
            && (facts.address.is_some() || !facts.shared || is_input_by_name(&facts.name));
        let is_en = facts.block.is_some_and(|block| self.blocks[block].en == tag);
        !facts.constant && !is_input && !is_en
    }

    /// Which of some tags a path of a list means: the part that it names, or where that is not a tag of its own, what it is in.
    pub fn named_by(&self, path: &str, among: &[TagId]) -> Vec<TagId> {
        let whole = path.to_ascii_lowercase();
        // An index says which element: the whole array counts.
        let mut prefix = whole.split('[').next().unwrap_or_default().trim_end();
        loop {
            let is_of = |tag: &TagId| {
                let tag = &self.tags[tag.0 as usize];
                let names = std::iter::once(&tag.name).chain(&tag.address);
                names
                    .into_iter()
                    .any(|name| is_part(&name.to_ascii_lowercase(), prefix))
            };
            let found: Vec<TagId> = among.iter().copied().filter(is_of).collect();
            if !found.is_empty() {
                return found;
            }
            match prefix.rfind('.') {
                Some(dot) if !prefix.starts_with('%') => prefix = &prefix[..dot],
                _ => return self.by_other_name(path, among),
            }
        }
    }

    fn by_other_name(&self, path: &str, among: &[TagId]) -> Vec<TagId> {
        let root = root_of(path);
        let names = self.other_names.iter();
        let names = names.filter(|other| other.name.eq_ignore_ascii_case(root));
        names
            .map(|other| other.tag)
            .filter(|tag| among.contains(tag))
            .collect()
    }

    /// The unread parts that may write a tag, or a part of one, by its name.
    pub fn unread_writers(&self, name: &str) -> Vec<&str> {
        let name = name.to_ascii_lowercase();
        let is_it = |tag: &TagId| {
            let tag = self.tags[tag.0 as usize].name.to_ascii_lowercase();
            is_part(&tag, &name) || is_part(&name, tag.split("[]").next().unwrap_or(&tag))
        };
        let may_write = |unread: &Unread, tags: &[TagId]| match &unread.directive.writes {
            None => tags.iter().any(|tag| is_it(tag) && self.may_be_written(*tag)),
            Some(paths) => paths
                .iter()
                .any(|path| self.named_by(path, tags).iter().any(is_it)),
        };
        let mut writers: Vec<&str> = Vec::new();
        for (number, part, unread) in self.unread_parts() {
            let is_call = |block: &&Block| matches!(block.kind, BlockKind::User(index) if index == number);
            let is_given = |block: &Block| {
                let parameters = &self.blocks[number].parameters;
                let written = block.arguments.iter().filter(|bound| {
                    let kind = bound
                        .parameter
                        .and_then(|n| parameters.get(n))
                        .map(|(_, kind)| *kind);
                    kind != Some(ParameterKind::Input)
                });
                written
                    .filter_map(|bound| bound.argument.root())
                    .any(|tag| is_it(&tag))
            };
            let in_network = |(at, network): (usize, &Network)| {
                let mut calls = network.blocks.iter().filter(is_call).peekable();
                calls.peek().is_some() && (calls.any(is_given) || may_write(unread, &self.visible_in(at)))
            };
            let anywhere = unread.directive.at_any_time && may_write(unread, &self.visible_in_main());
            if anywhere || self.networks.iter().enumerate().any(in_network) {
                writers.push(part);
            }
        }
        writers
    }

    /// Whether a tag keeps the state of a block.
    pub fn is_instance(&self, tag: TagId) -> bool {
        matches!(self.tags[tag.0 as usize].ty, Type::Compound(id) if id.block().is_some())
    }
}

/// Whether a name without a declaration says that it is an input: `I1`.
fn is_input_by_name(name: &str) -> bool {
    let number = name.strip_prefix(['I', 'i']);
    number.is_some_and(|number| !number.is_empty() && number.chars().all(|c| c.is_ascii_digit()))
}

/// Whether a tag is what a path names, or a part of it. A tag of another file has that file before its name.
fn is_part(tag: &str, path: &str) -> bool {
    let is_after = |rest: &str| rest.is_empty() || rest.starts_with(['.', '[']);
    let begins = |tag: &str| tag.strip_prefix(path).is_some_and(is_after);
    begins(tag) || tag.split_once('.').is_some_and(|(_, rest)| begins(rest))
}

/// A block that is an unread part as sentences name it: without the `$`.
pub fn unread_name(block: &str) -> &str {
    block.strip_prefix('$').unwrap_or(block)
}

/// The note about unread parts of these names. None: there are none.
pub fn unread_note<'n>(names: impl Iterator<Item = &'n str>) -> Option<String> {
    let names: Vec<Cow<'_, str>> = names.map(|name| Cow::Owned(format!("`{name}`"))).collect();
    Some(match names.as_slice() {
        [] => return None,
        [one] => format!("the unread part {one} is not run, and what it may write is not known"),
        [rest @ .., last] => format!(
            "the unread parts {} and {last} are not run, and what they may write is not known",
            rest.join(", ")
        ),
    })
}
