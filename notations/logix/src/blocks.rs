//! The blocks that a translated program brings along: the instructions that keep their state in a tag.

use crate::types::Elem;
use ladder_format::program::Item;
use std::collections::BTreeMap;

macro_rules! texts {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("blocks/", $name, ".clad")))),*]
    };
}

const TEXTS: &[(&str, &str)] = texts![
    "AVE",
    "BSL",
    "BSR",
    "CTD",
    "CTU",
    "ControlRES",
    "FAL",
    "CounterRES",
    "FFL",
    "FFU",
    "FOR",
    "FSC",
    "LFL",
    "LFU",
    "ONS",
    "ONSBIT",
    "OSF",
    "OSR",
    "OTEBIT",
    "RTO",
    "RTOR",
    "SCL",
    "SQI",
    "SQL",
    "SQO",
    "SRT",
    "STD",
    "TOF",
    "TON",
    "TONR",
    "TimerRES",
];

/// The block that is a coil on a computed bit.
pub(crate) const OTE_BIT: &str = "OTEBIT";
/// The one shot that remembers its rung in a computed bit.
pub(crate) const ONS_BIT: &str = "ONSBIT";

/// The blocks that a program uses.
#[derive(Debug, Default)]
pub(crate) struct Blocks {
    used: BTreeMap<String, String>,
}

impl Blocks {
    /// Notes that a block is used. Its name, without the `$`.
    pub(crate) fn plain(&mut self, name: &str) -> String {
        self.take(name, String::new(), std::borrow::ToOwned::to_owned)
    }

    /// One for arrays of this many elements of a type.
    pub(crate) fn on_array(&mut self, name: &str, size: u32, elem: Elem) -> String {
        let ty = elem.text();
        let suffix = match elem {
            Elem::Dint => size.to_string(),
            _ => format!("{}{size}", ty.trim_end_matches(']').replace('[', "")),
        };
        let (bits, lowest) = (elem.bits(), elem.wrap(1i64 << (elem.bits() - 1).min(63)));
        self.take(name, suffix.clone(), |text| {
            text.replace("{NAME}", &suffix)
                .replace("{LAST}", &(size - 1).to_string())
                .replace("{TYPE}", &ty)
                .replace("{BITS}", &bits.to_string())
                .replace("{LOWEST}", &lowest.to_string())
        })
    }

    /// One for words of a type.
    pub(crate) fn on_word(&mut self, name: &str, elem: Elem) -> String {
        let ty = elem.text();
        let suffix = if elem == Elem::Dint {
            String::new()
        } else {
            ty.clone()
        };
        self.take(name, suffix.clone(), |text| {
            text.replace("{NAME}", &suffix).replace("{TYPE}", &ty)
        })
    }

    fn take(&mut self, name: &str, suffix: String, text: impl FnOnce(&str) -> String) -> String {
        let own = TEXTS.iter().find(|(own, _)| *own == name);
        let body = own.map(|(_, body)| *body).unwrap_or_default();
        let name = format!("{name}{suffix}");
        self.used.entry(name.clone()).or_insert_with(|| text(body));
        name
    }

    /// Whether the name of a block is one of these.
    pub(crate) fn has(name: &str) -> bool {
        let own = name.trim_end_matches(|c: char| c.is_ascii_digit());
        TEXTS.iter().any(|(known, _)| own.eq_ignore_ascii_case(known))
    }

    /// The block whose name a name begins with, and what follows: the elements that it is for.
    pub(crate) fn named(name: &str) -> Option<(&'static str, &str)> {
        let known = TEXTS.iter().filter_map(|(known, _)| {
            let start = name.get(..known.len())?;
            start
                .eq_ignore_ascii_case(known)
                .then(|| (*known, &name[known.len()..]))
        });
        known.max_by_key(|(known, _)| known.len())
    }

    /// The definitions of those that are used, each as a text.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &String> {
        self.used.values()
    }

    /// Their definitions.
    pub(crate) fn items(&self) -> impl Iterator<Item = Item> {
        let items = |text: &String| [Item::Blank, Item::Text(text.clone())];
        self.texts().flat_map(items)
    }
}
