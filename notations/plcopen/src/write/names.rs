//! Names as IEC 61131-3 has them.

use ladder_notation::is_reserved_in_iec;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// A name with the signs that are allowed there: letters and digits of ASCII, single underscores between them.
pub(crate) fn identifier(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        match c {
            c if c.is_ascii_alphanumeric() => out.push(c),
            // A direct address has a name there.
            '%' => {}
            _ if out.ends_with('_') => {}
            _ => out.push('_'),
        }
    }
    while out.ends_with('_') {
        out.pop();
    }
    if !out.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        out.insert_str(0, "n_");
    }
    if is_reserved_in_iec(&out) {
        out.push_str("_1");
    }
    out
}

/// The names of one unit, or of a project.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    /// The names that these are added to: those of a unit, while a network of it may still fail.
    outer: Option<Rc<Names>>,
    taken: HashSet<String>,
    by_tag: HashMap<Name, String>,
    refused: HashSet<Name>,
}

impl Names {
    /// The names of something inside, which are not to be those around it.
    pub(super) fn inside(&self) -> Names {
        Names {
            taken: self.taken.clone(),
            refused: self.refused.clone(),
            ..Names::default()
        }
    }

    /// No names yet, to be added to others.
    pub(super) fn added_to(outer: &Rc<Names>) -> Names {
        Names {
            outer: Some(Rc::clone(outer)),
            ..Names::default()
        }
    }

    /// Takes in what was to be added. Nothing is copied if only that held these.
    pub(super) fn add(outer: &mut Rc<Names>, mut added: Names) {
        added.outer = None;
        let own = Rc::make_mut(outer);
        own.taken.extend(added.taken);
        own.by_tag.extend(added.by_tag);
        own.refused.extend(added.refused);
    }

    fn is_taken(&self, name: &str) -> bool {
        self.taken.contains(name) || self.outer.as_ref().is_some_and(|outer| outer.is_taken(name))
    }

    /// A name like this one that nothing else has.
    pub(super) fn fresh(&mut self, like: &str) -> String {
        let like = identifier(like);
        let mut name = like.clone();
        let mut number = 1;
        while self.is_taken(&name.to_ascii_lowercase()) {
            number += 1;
            name = format!("{like}_{number}");
        }
        self.taken.insert(name.to_ascii_lowercase());
        name
    }

    /// Makes a name for a tag.
    pub(super) fn declare(&mut self, tag: &str) -> String {
        let name = self.fresh(tag);
        self.by_tag.insert(Name::new(tag), name.clone());
        name
    }

    /// Takes a name for a tag that is another's already: a global in the units that use it.
    pub(super) fn alias(&mut self, tag: &str, name: &str) {
        self.taken.insert(name.to_ascii_lowercase());
        self.by_tag.insert(Name::new(tag), name.to_owned());
    }

    /// A tag that is not declared there.
    pub(super) fn refuse(&mut self, tag: &str) {
        self.refused.insert(Name::new(tag));
    }

    /// See above.
    pub(super) fn is_refused(&self, tag: &str) -> bool {
        let outer = self.outer.as_ref();
        !self.refused.is_empty() && self.refused.contains(&Name::new(tag))
            || outer.is_some_and(|outer| outer.is_refused(tag))
    }

    /// The name of a tag.
    pub(super) fn get(&self, tag: &str) -> Option<&str> {
        let own = self.by_tag.get(&Name::new(tag)).map(String::as_str);
        own.or_else(|| self.outer.as_ref()?.get(tag))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_of_ascii() {
        for (tag, name) in [
            ("start", "start"),
            ("Größe", "Gr_e"),
            ("a__b_", "a_b"),
            ("Step", "Step_1"),
            ("2x", "n_2x"),
            ("%IX0.3", "IX0_3"),
        ] {
            assert_eq!(identifier(tag), name);
        }
    }
}
