//! The list of proposals while it is being made.

use super::item::{Completion, CompletionKind, Completions, Snippet, Topic};
use super::likeness::{Likeness, likeness};
use crate::typing::Typing;
use ladder_syntax::TextRange;

/// This many are proposed at once. A longer list helps no one, and a large program has thousands of tags.
pub(super) const MOST: usize = 128;

/// Proposals for the word at a place.
pub(super) struct Proposals<'t> {
    prefix: &'t str,
    word: TextRange,
    /// What is on the line in front of the word.
    before: &'t str,
    /// How each is like what is written, its place in the order of the proposals, and itself.
    found: Vec<((Likeness, Order), Completion)>,
}

/// The order of two proposals: how well they fit, then a second thought, then their names where that is of use.
pub(super) type Order = (u8, u8);

impl<'t> Proposals<'t> {
    pub(super) fn new(typing: &'t Typing<'_>) -> Proposals<'t> {
        Proposals {
            prefix: typing.prefix(),
            word: typing.absolute(typing.word.clone()),
            before: &typing.text[..typing.word.start],
            found: Vec::new(),
        }
    }

    /// How a name is like what is written; none if it cannot be meant.
    pub(super) fn likeness(&self, name: &str) -> Option<Likeness> {
        likeness(name, self.prefix)
    }

    /// Adds a proposal at its place in the order, after those of the same place that were added before. Its filter is the name
    /// by which it is found.
    pub(super) fn add_at(&mut self, order: Order, item: Completion) {
        if let Some(likeness) = self.likeness(&item.filter) {
            self.add_like(likeness, order, item);
        }
    }

    /// As `add_at`, of what is known to be meant.
    ///
    /// Every filter begins as it is written, to the letter: editors rank by how well the two agree, each in its own way, before they
    /// ask for the server's order. Where all agree alike that order holds.
    pub(super) fn add_like(&mut self, likeness: Likeness, order: Order, mut item: Completion) {
        let written = match likeness {
            Likeness::Whole | Likeness::Beginning => self.prefix.chars().count(),
            Likeness::Word | Likeness::Inside | Likeness::Scattered => 0,
        };
        let rest: String = item.filter.chars().skip(written).collect();
        item.filter = format!("{}{rest}", self.prefix);
        self.found.push(((likeness, order), item));
    }

    /// Adds a word that takes the place of the one that is written.
    pub(super) fn word(
        &mut self,
        order: Order,
        kind: CompletionKind,
        label: &str,
        detail: &str,
        topic: Topic,
    ) {
        self.snippet(order, kind, label, detail, Snippet::plain_text(label), topic);
    }

    /// As `word`, with a text of its own.
    pub(super) fn snippet(
        &mut self,
        order: Order,
        kind: CompletionKind,
        label: &str,
        detail: &str,
        text: Snippet,
        topic: Topic,
    ) {
        self.add_at(
            order,
            Completion {
                label: label.to_owned(),
                detail: detail.to_owned(),
                kind,
                range: self.word,
                filter: label.to_owned(),
                text,
                topic,
            },
        );
    }

    /// The list. `before` and `after` are what each word gets around it.
    pub(super) fn finish(mut self, before: &str, after: &Snippet) -> Completions {
        let mut found = std::mem::take(&mut self.found);
        found.sort_by_key(|(order, _)| *order);
        // With one letter more, names that do not begin so are other ones.
        let begins = |likeness: Likeness| likeness <= Likeness::Beginning;
        let cut = found.len() > MOST || found.iter().any(|((likeness, _), _)| !begins(*likeness));
        found.truncate(MOST);
        let mut items: Vec<Completion> = found.into_iter().map(|(_, item)| item).collect();
        for item in &mut items {
            // An editor compares with what is in the whole range up to the cursor.
            let more = usize::from(
                self.word
                    .start()
                    .checked_sub(item.range.start())
                    .unwrap_or_default(),
            );
            item.filter
                .insert_str(0, &self.before[self.before.len() - more..]);
        }
        if !before.is_empty() || *after != Snippet::default() {
            for item in &mut items {
                let word = std::mem::take(&mut item.text);
                item.text = Snippet::default().text(before).append(word).append(after.clone());
            }
        }
        Completions { items, cut }
    }
}
