//! The words of entries, and of which things those are names.

use crate::outline::{Entry, Kind, Outline};
use ladder_syntax::SyntaxKind::{BLOCK_NAME, BOM, COMMENT, DOT, IDENT, NEWLINE, RAIL, WHITESPACE, WIRE};
use ladder_syntax::{Name, NodeOrToken, TextRange};
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// Which thing a name is of: in the body of which block it is, whether it is a member, and the name.
pub(super) type Identity = (Arc<str>, bool, Name);

/// A word of an entry.
pub(super) struct Word {
    pub(super) text: Name,
    /// Of a name what it is of, and where it is.
    pub(super) named: Option<(Identity, TextRange)>,
}

/// The block in whose body an entry is.
pub(super) fn block_of(entry: &Entry) -> &str {
    if entry.place.starts_with(Kind::Block.text()) {
        &entry.place
    } else {
        ""
    }
}

pub(super) fn names(words: &[Vec<Word>]) -> FxHashSet<&Identity> {
    let words = words.iter().flatten();
    words.filter_map(|word| Some(&word.named.as_ref()?.0)).collect()
}

/// All entries from top to bottom.
pub(super) fn flat(entries: &[Entry]) -> Vec<&Entry> {
    let mut all = Vec::new();
    for entry in entries {
        all.push(entry);
        all.extend(flat(&entry.inside));
    }
    all
}

/// The words of an entry itself; of one that holds others those of its first line.
pub(super) fn words(outline: &Outline, entry: &Entry) -> Vec<Word> {
    let mut words = Vec::new();
    if matches!(entry.kind, Kind::Comment | Kind::Setting | Kind::Unread) {
        return words;
    }
    let parse = &outline.context.parse;
    let scope: Arc<str> = block_of(entry).into();
    let is_in_structure = entry.place.starts_with(Kind::Structure.text());
    let mut is_after_dot = false;
    let first = parse.line_at(entry.own.start()).unwrap_or_default();
    for (line, number) in parse.lines().from(first).zip(first..) {
        let start = parse.line_start(number);
        if start >= entry.own.end() {
            break;
        }
        let tree = line.syntax();
        for token in tree.descendants_with_tokens().filter_map(NodeOrToken::into_token) {
            let kind = token.kind();
            if matches!(kind, WHITESPACE | NEWLINE | BOM | COMMENT | RAIL) {
                continue;
            }
            let text = Name::new(if kind == WIRE { "-" } else { token.text() });
            let is_member = is_after_dot || (is_in_structure && entry.names.contains(&text));
            is_after_dot = kind == DOT;
            let named = matches!(kind, IDENT | BLOCK_NAME).then(|| {
                let scope = if is_member || kind == BLOCK_NAME {
                    "".into()
                } else {
                    Arc::clone(&scope)
                };
                ((scope, is_member, text.clone()), token.text_range() + start)
            });
            words.push(Word { text, named });
        }
    }
    words
}
