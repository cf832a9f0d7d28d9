//! Names as Logix can hold them: letters, digits and `_`, at most 40, no `__` and no `_` at the end.

use crate::mnemonic::is_known;
use ladder_syntax::Name;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The longest name.
const LONGEST: usize = 40;

/// What a name is for: those of different kinds may be alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Kind {
    /// Tags, members, parameters.
    Tag,
    /// Types and Add-On Instructions, which share their names with instructions.
    Type,
    /// Routines.
    Routine,
    Label,
}

/// Spells names, each in one way and no two of a kind alike.
#[derive(Debug, Default)]
pub(super) struct Names {
    spelled: HashMap<(Kind, Name), String>,
    taken: HashSet<(Kind, String)>,
    /// Which number the next name gets that is like one that is taken.
    next: HashMap<(Kind, String), u32>,
    /// What is spelled otherwise than it was, in the order of the names.
    pub(super) changed: BTreeMap<String, String>,
}

impl Names {
    /// A name as Logix has it.
    pub(super) fn spell(&mut self, kind: Kind, name: &str) -> String {
        let key = (kind, Name::new(name));
        if let Some(known) = self.spelled.get(&key) {
            // Members of two types may be one name, in two spellings.
            let same = known.eq_ignore_ascii_case(name);
            return if same { name.to_owned() } else { known.clone() };
        }
        let spelled = self.fresh(kind, name);
        if spelled != name.trim_start_matches('$') {
            self.changed.insert(name.to_owned(), spelled.clone());
        }
        self.spelled.insert(key, spelled.clone());
        spelled
    }

    /// Notes that a name is spelled as another one is.
    pub(super) fn stands_for(&mut self, kind: Kind, name: &str, spelled: &str) {
        self.spelled.insert((kind, Name::new(name)), spelled.to_owned());
    }

    /// A name that nothing of the kind has.
    pub(super) fn fresh(&mut self, kind: Kind, like: &str) -> String {
        let like = nearest(like, kind);
        let mut name = like.clone();
        let key = (kind, like.to_ascii_uppercase());
        let mut number = self.next.get(&key).copied().unwrap_or(2);
        while !self.taken.insert((kind, name.to_ascii_uppercase())) {
            let end = format!("_{number}");
            let most = like.len().min(LONGEST - end.len());
            name = format!("{}{end}", like[..most].trim_end_matches('_'));
            number += 1;
            self.next.insert(key.clone(), number);
        }
        name
    }
}

fn nearest(name: &str, kind: Kind) -> String {
    let mut out = String::new();
    for c in name.chars().filter(|c| *c != '%' && *c != '$') {
        let c = if c.is_ascii_alphanumeric() { c } else { '_' };
        if !(c == '_' && out.ends_with('_')) {
            out.push(c);
        }
    }
    out.truncate(LONGEST);
    let mut out = out.trim_end_matches('_').to_owned();
    if !out.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        out.insert_str(0, if out.is_empty() { "N_own" } else { "N_" });
        out.truncate(LONGEST);
    }
    let is_word = kind == Kind::Tag
        && matches!(
            out.to_ascii_uppercase().as_str(),
            "MOD" | "AND" | "OR" | "XOR" | "NOT"
        );
    if is_word || (kind == Kind::Type && (is_known(&out) || is_type(&out))) {
        out.truncate(LONGEST - 4);
        out.push_str("_own");
    }
    out
}

/// Whether a type of that name is there already.
fn is_type(name: &str) -> bool {
    const TYPES: &[&str] = &[
        "BOOL", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "REAL", "LREAL", "STRING",
        "TIMER", "COUNTER", "CONTROL", "MESSAGE", "PID", "MODULE", "BIT",
    ];
    TYPES.iter().any(|own| own.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_spelled_as_logix_takes_them() {
        let mut names = Names::default();
        let mut spell = |name: &str| names.spell(Kind::Tag, name);
        assert_eq!(spell("Pump"), "Pump");
        assert_eq!(spell("PUMP"), "PUMP", "case makes no difference there either");
        assert_eq!(spell("größe"), "gr_e");
        assert_eq!(spell("a__b_"), "a_b");
        assert_eq!(spell("a_b"), "a_b_2");
        assert_eq!(spell("%IX0.3"), "IX0_3");
        assert_eq!(spell("ü"), "N_own");
        assert_eq!(spell("mod"), "mod_own");
        assert_eq!(names.spell(Kind::Type, "$TON"), "TON_own");
        assert_eq!(names.spell(Kind::Type, "$Motor"), "Motor");
    }
}
