//! The names that a shell can complete. Any other text is taken as well: it may have brackets, or be almost a name.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::error::Error;
use clap::{Arg, Command};
use ladder_instructions::TABLE;
use std::collections::BTreeSet;
use std::ffi::OsStr;

#[derive(Debug, Clone, Copy)]
pub(super) struct Names;

impl TypedValueParser for Names {
    type Value = String;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<String, Error> {
        StringValueParser::new().parse_ref(command, argument, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let is_word = |name: &&str| name.chars().all(|c| c.is_ascii_alphanumeric());
        let mnemonics: BTreeSet<&str> = TABLE.iter().map(|row| row.mnemonic).filter(is_word).collect();
        let rules = ladder_analysis::rules::ALL.iter().map(|rule| rule.name());
        Some(Box::new(
            mnemonics.into_iter().chain(rules).map(PossibleValue::new),
        ))
    }
}
