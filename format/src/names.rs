//! Names of another system as names of ladder text.

use ladder_syntax::{Name, is_declaration_keyword, is_identifier, is_reserved};
use std::collections::{HashMap, HashSet};

/// Spells names so that ladder text can hold them, each in one way and no two alike.
#[derive(Debug, Clone, Default)]
pub struct Names {
    spelled: HashMap<String, String>,
    taken: HashSet<Name>,
    /// The number with which the search for the next name begins that is like one that is taken.
    next: HashMap<Name, u64>,
}

impl Names {
    /// The name as it is, where ladder text can hold it and no other name took it; else the nearest that can be:
    /// letters, digits and `_` stay, what else there is becomes `_`, and a number after it tells two apart.
    pub fn spell(&mut self, original: &str) -> &str {
        if !self.spelled.contains_key(original) {
            let spelling = self.free(nearest(original));
            self.spelled.insert(original.to_owned(), spelling);
        }
        &self.spelled[original]
    }

    /// Takes a name that the importer makes itself, or the next free one that is like it.
    pub fn fresh(&mut self, like: &str) -> String {
        self.free(nearest(like))
    }

    /// The names that are spelled otherwise than they were, sorted.
    pub fn changed(&self) -> Vec<(&str, &str)> {
        let mut changed: Vec<(&str, &str)> = self
            .spelled
            .iter()
            .filter(|(original, spelling)| original != spelling)
            .map(|(original, spelling)| (original.as_str(), spelling.as_str()))
            .collect();
        changed.sort_unstable();
        changed
    }

    fn free(&mut self, name: String) -> String {
        let key = Name::new(&name);
        if self.taken.insert(key.clone()) {
            return name;
        }
        let next = self.next.entry(key).or_insert(2);
        loop {
            let other = format!("{name}_{next}");
            *next += 1;
            if self.taken.insert(Name::new(&other)) {
                return other;
            }
        }
    }
}

fn nearest(original: &str) -> String {
    if is_identifier(original) && !is_reserved(original) && !is_declaration_keyword(original) {
        return original.to_owned();
    }
    let mut name = String::with_capacity(original.len() + 1);
    for c in original.chars() {
        name.push(if is_identifier(&format!("_{c}")) { c } else { '_' });
    }
    if !is_identifier(&name) || is_reserved(&name) || is_declaration_keyword(&name) {
        name.insert(0, '_');
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_or_are_spelled_alike() {
        let mut names = Names::default();
        let mut spell = |name: &str| names.spell(name).to_owned();
        assert_eq!(spell("Xin"), "Xin");
        assert_eq!(spell("XIN"), "XIN_2", "case makes no difference here");
        assert_eq!(spell("Xin"), "Xin");
        assert_eq!(spell("#PORTA"), "_PORTA");
        assert_eq!(spell("A LOG"), "A_LOG");
        assert_eq!(spell("7seg"), "_7seg");
        assert_eq!(spell("and"), "_and");
        assert_eq!(spell("Ton"), "_Ton", "a word of declarations");
        assert_eq!(spell("größe"), "größe");
        assert_eq!(spell(""), "_");
        assert_eq!(names.changed().len(), 7);
        assert_eq!(names.fresh("Xin"), "Xin_3");
    }
}
