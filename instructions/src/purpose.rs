//! What an instruction is for, by the words of its title and of its documentation.

use crate::instruction::Instruction;
use crate::likeness;

/// Fewer letters are no word yet. A list that some editors open once, and then only narrow, must not be empty on the way
/// from `[T` to `[timer`.
const SHORTEST: usize = 2;

/// Shorter words than this are in every sentence.
const SHORTEST_IN_SENTENCE: usize = 3;

/// How a word leads to an instruction that is not spelled like that.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Purpose {
    /// Its title has a word that begins so, or it goes by a name that begins so elsewhere: `timer`, `XIC`.
    Title,
    /// The first sentence of its documentation has such a word.
    Sentence,
}

/// Whether an instruction is what a person looks for who has written this much of a word. Compared without case; none
/// for a single letter.
///
/// ```
/// use ladder_instructions::{Purpose, Shape, lookup, purpose};
///
/// let timer = lookup(Shape::Logical, "TON").next().unwrap();
/// assert_eq!(purpose(timer, "time"), Some(Purpose::Title));
/// assert_eq!(purpose(timer, "counter"), None);
/// ```
pub fn purpose(row: &Instruction, word: &str) -> Option<Purpose> {
    let letters = word.chars().count();
    if letters < SHORTEST {
        return None;
    }
    let elsewhere = likeness::names_elsewhere(row).any(|name| begins(name, word));
    if elsewhere || has_word(row.title, word) {
        return Some(Purpose::Title);
    }
    if letters < SHORTEST_IN_SENTENCE {
        return None;
    }
    let sentence = row.doc.split(['.', '\n']).next().unwrap_or_default();
    has_word(sentence, word).then_some(Purpose::Sentence)
}

/// Whether a word of a text begins so. Those of two letters, such as `to`, say nothing.
fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_alphanumeric())
        .any(|part| part.len() > 2 && begins(part, word))
}

/// Whether a text begins so, whatever the case.
fn begins(text: &str, start: &str) -> bool {
    let mut letters = text.chars().flat_map(char::to_lowercase);
    let mut wanted = start.chars().flat_map(char::to_lowercase);
    wanted.all(|c| letters.next() == Some(c))
}

#[cfg(test)]
mod tests {
    use super::purpose;
    use crate::table::TABLE;

    fn found(word: &str) -> String {
        let mut rows: Vec<_> = TABLE
            .iter()
            .filter_map(|row| Some((purpose(row, word)?, row.block())))
            .collect();
        rows.sort_by_key(|(how, _)| *how);
        let blocks: Vec<String> = rows.into_iter().map(|(_, block)| block).collect();
        blocks.join(" ")
    }

    #[test]
    fn what_people_look_for_is_found() {
        assert!(
            found("timer").starts_with("[TON] [TOF] [TP] [RTO] [RTOF]"),
            "{}",
            found("timer")
        );
        assert!(
            found("Count").contains("[CTU] [CTD] [CTUD]"),
            "{}",
            found("Count")
        );
        assert!(found("jump").contains("<JMP>"), "{}", found("jump"));
        assert!(found("XIC").starts_with("[ ]"), "{}", found("XIC"));
        assert!(
            found("latch").contains("(S)") || found("set").contains("(S)"),
            "{}",
            found("set")
        );
        assert!(found("ti").starts_with("[TON] [TOF] [TP]"), "{}", found("ti"));
        assert!(!found("to").contains("[LOG]"), "{}", found("to"));
        assert_eq!(found("t"), "", "a letter is in many words");
        assert_eq!(found("zzz"), "");
    }
}
