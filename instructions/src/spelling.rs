//! Mnemonics as numbers, so that finding one compares no strings and allocates nothing.

use crate::instruction::Instruction;
use crate::table::TABLE;

/// A mnemonic in capitals, as the digits of a number: its bytes, first letter highest. The longest mnemonics
/// (`SCANTIME`) have eight letters, which is what a `u64` holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Spelling(u64);

impl Spelling {
    /// How many letters the longest mnemonic may have.
    const LONGEST: usize = 8;

    /// The spelling between a block's brackets; none if no mnemonic can have it, being too long or not ASCII.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let text = text.trim_matches([' ', '\t']);
        let mut letters = 0;
        let mut value = 0;
        for letter in text.chars() {
            // Simple case folding (LANGUAGE §1) has two letters outside ASCII that fold into it.
            let letter = match letter {
                'ſ' => b'S',
                '\u{212a}' => b'K',
                // NUL would be a leading zero, and vanish.
                ascii if ascii.is_ascii() && ascii != '\0' => (ascii as u8).to_ascii_uppercase(),
                _ => return None,
            };
            letters += 1;
            if letters > Self::LONGEST {
                return None;
            }
            value = value << 8 | u64::from(letter);
        }
        Some(Self(value))
    }

    /// The same for a spelling of the table, which is in capitals or one blank.
    const fn of_table(text: &str) -> Self {
        let bytes = text.as_bytes();
        assert!(
            bytes.len() <= Self::LONGEST,
            "a mnemonic has at most eight letters"
        );
        let mut value = 0;
        let mut index = 0;
        while index < bytes.len() {
            assert!(!bytes[index].is_ascii_lowercase(), "the table is in capitals");
            if bytes[index] != b' ' {
                value = value << 8 | bytes[index] as u64;
            }
            index += 1;
        }
        Self(value)
    }
}

/// One spelling of one row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    /// The row's brackets, as a number that a constant function can compare.
    pub(crate) shape: u8,
    pub(crate) spelling: Spelling,
    /// Where the row is in the table.
    pub(crate) row: u8,
}

impl Entry {
    /// Rows of the same spelling keep the order of the table.
    const fn is_before(self, other: Self) -> bool {
        if self.shape != other.shape {
            return self.shape < other.shape;
        }
        if self.spelling.0 != other.spelling.0 {
            return self.spelling.0 < other.spelling.0;
        }
        self.row < other.row
    }
}

/// Every spelling, sorted by brackets and spelling.
pub(crate) static INDEX: [Entry; count()] = sorted();

const fn count() -> usize {
    let mut count = 0;
    let mut row = 0;
    while row < TABLE.len() {
        count += 1 + TABLE[row].synonyms.len() + TABLE[row].aliases.len();
        row += 1;
    }
    count
}

const fn sorted() -> [Entry; count()] {
    let mut entries = [Entry {
        shape: 0,
        spelling: Spelling(0),
        row: 0,
    }; count()];
    let mut length = 0;
    let mut row = 0;
    while row < TABLE.len() {
        let instruction = &TABLE[row];
        let spellings = 1 + instruction.synonyms.len() + instruction.aliases.len();
        let mut index = 0;
        while index < spellings {
            let spelling = Spelling::of_table(nth_spelling(instruction, index));
            let entry = Entry {
                shape: instruction.shape as u8,
                spelling,
                row: row as u8,
            };
            // Insertion keeps the list sorted; it is short, and made once, by the compiler.
            let mut place = length;
            while place > 0 && entry.is_before(entries[place - 1]) {
                entries[place] = entries[place - 1];
                place -= 1;
            }
            entries[place] = entry;
            length += 1;
            index += 1;
        }
        row += 1;
    }
    entries
}

const fn nth_spelling(instruction: &Instruction, index: usize) -> &'static str {
    if index == 0 {
        return instruction.mnemonic;
    }
    let index = index - 1;
    if index < instruction.synonyms.len() {
        return instruction.synonyms[index];
    }
    instruction.aliases[index - instruction.synonyms.len()]
}
