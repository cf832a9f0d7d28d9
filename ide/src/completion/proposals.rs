//! The list of proposals while it is being made.

use super::item::{Completion, CompletionKind, Completions, Snippet, Topic};
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
    /// How well each fits, its place in the order of the proposals, and itself.
    found: Vec<(Order, Completion)>,
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

    /// Whether a name begins as it is written.
    pub(super) fn begins(&self, name: &str) -> bool {
        // This is asked of each tag, and most differ in their first letter.
        let (letters, wanted) = (name.as_bytes(), self.prefix.as_bytes());
        if let (Some(letter), Some(wanted)) = (letters.first(), wanted.first())
            && letter.is_ascii()
            && wanted.is_ascii()
            && !letter.eq_ignore_ascii_case(wanted)
        {
            return false;
        }
        let start = letters.get(..wanted.len());
        if start.unwrap_or(letters).is_ascii() && wanted.is_ascii() {
            return start.is_some_and(|start| start.eq_ignore_ascii_case(wanted));
        }
        begins_in_any_script(name, self.prefix)
    }

    /// Whether something of this name can be meant by what is written.
    pub(super) fn may_be(&self, name: &str) -> bool {
        if self.prefix.is_empty() {
            return true;
        }
        if name.is_ascii() && self.prefix.is_ascii() {
            let mut letters = name.bytes();
            let mut wanted = self.prefix.bytes();
            return wanted.all(|c| letters.any(|letter| letter.eq_ignore_ascii_case(&c)));
        }
        let mut letters = name.chars().flat_map(char::to_lowercase);
        let mut wanted = self.prefix.chars().flat_map(char::to_lowercase);
        wanted.all(|c| letters.any(|letter| letter == c))
    }

    /// Adds a proposal at its place in the order, after those of the same place that were added before.
    pub(super) fn add_at(&mut self, order: Order, mut item: Completion) {
        if !self.may_be(&item.filter) {
            return;
        }
        // Names are compared without case, which not every editor does.
        let written = self.prefix.chars().count();
        if self.begins(&item.filter) {
            let rest: String = item.filter.chars().skip(written).collect();
            item.filter = format!("{}{rest}", self.prefix);
        }
        self.found.push((order, item));
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
        // What begins as it is written comes first.
        let mut found = std::mem::take(&mut self.found);
        found.sort_by_cached_key(|(order, item)| (!self.begins(&item.filter), *order));
        let cut = found.len() > MOST;
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

/// Whether a name begins so, where letters of other scripts than the Latin one, or with accents, are compared.
fn begins_in_any_script(name: &str, written: &str) -> bool {
    name.to_lowercase().starts_with(&written.to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::{Proposals, begins_in_any_script};
    use ladder_syntax::TextRange;

    #[test]
    fn the_first_letters_say_what_the_whole_name_says() {
        // The Kelvin sign is a k in lower case, and a capital sigma at the end of a word has a lower case of its own.
        let words = [
            "",
            "s",
            "S",
            "st",
            "START",
            "start_1",
            "stärt",
            "STÄ",
            "stÄrt_1",
            "sta",
            "ä",
            "Ä",
            "k",
            "\u{212a}",
            "\u{212a}alt",
            "kä",
            "KA",
            "σ",
            "Σ",
            "ας",
            "ΑΣ",
            "ΑΣΑ",
            "İ",
            "i",
            "ix",
            "aß",
            "aẞ",
        ];
        for prefix in words {
            let proposals = Proposals {
                prefix,
                word: TextRange::default(),
                before: "",
                found: Vec::new(),
            };
            for name in words {
                let expected = begins_in_any_script(name, prefix);
                assert_eq!(proposals.begins(name), expected, "{name} begins with {prefix}");
            }
        }
    }
}
