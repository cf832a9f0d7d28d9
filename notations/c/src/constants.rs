//! Names of the places where tags are in the memory.

use crate::header::FAULTS;
use crate::interface::{Field, Interface};
use crate::names::{Names, identifier};
use ladder_simulator::compiled::{Bit, Home, Word};
use std::collections::BTreeMap;

/// The place of a tag.
#[derive(Debug)]
pub(crate) struct Constant {
    pub(crate) name: String,
    pub(crate) at: u32,
    /// How many places it has.
    len: u32,
    /// The tag, and its type.
    pub(crate) meaning: String,
}

/// Tags by their first places.
pub(crate) type Bank = BTreeMap<u32, Constant>;

/// The places of all tags that are bits or words.
#[derive(Debug, Default)]
pub(crate) struct Constants {
    pub(crate) bits: Bank,
    pub(crate) words: Bank,
}

impl Constants {
    /// Those of a library, whose tags are in this order: inputs, outputs, others.
    pub(crate) fn of(library: &str, interface: &Interface) -> Constants {
        let upper = library.to_ascii_uppercase();
        let mut names = Names::of_constants(library);
        for (name, _) in FAULTS {
            names.name(&format!("{upper}_FAULT_{name}"));
        }
        let mut constants = Constants::default();
        let fields = [&interface.inputs, &interface.outputs, &interface.others];
        for Field {
            name, meaning, home, ..
        } in fields.into_iter().flatten()
        {
            let (bank, at, len) = match *home {
                Home::Bits { at, len, .. } => (&mut constants.bits, at.0, len),
                Home::Words { at, len, .. } => (&mut constants.words, at.0, len),
                _ => continue,
            };
            bank.entry(at).or_insert_with(|| Constant {
                name: names.name(&format!("{upper}_{}", identifier(name))),
                at,
                len,
                meaning: meaning.clone(),
            });
        }
        constants
    }

    /// Where a bit is.
    pub(crate) fn bit(&self, bit: Bit) -> String {
        place(&self.bits, bit.0)
    }

    /// Where a word is.
    pub(crate) fn word(&self, word: Word) -> String {
        place(&self.words, word.0)
    }
}

fn place(bank: &Bank, at: u32) -> String {
    match bank.range(..=at).next_back() {
        Some((_, tag)) if tag.at == at => tag.name.clone(),
        Some((_, tag)) if at < tag.at + tag.len => format!("{} + {}", tag.name, at - tag.at),
        _ => at.to_string(),
    }
}
