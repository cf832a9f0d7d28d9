//! What is wrong with lines of declarations, and which names are declared again: by line, so that it stays true while
//! other lines come and go.

use crate::findings::Anchored;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is wrong with the declarations of a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Misdeclared {
    /// By the numbers of the lines.
    found: BTreeMap<u32, Vec<Arc<Anchored>>>,
    /// The names in the file's own scope that are declared more than once, with the numbers of the lines that do it again.
    /// A line that the parser reports something about has no finding of its own for that.
    repeated: FxHashMap<Name, Vec<u32>>,
}

impl Misdeclared {
    /// All findings.
    pub(crate) fn found(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        self.found.values().flatten()
    }

    /// What is wrong with a line.
    pub(crate) fn find(&mut self, line: u32, found: Vec<Arc<Anchored>>) {
        if !found.is_empty() {
            self.found.insert(line, found);
        }
    }

    /// A line declares a name that another one has declared before.
    pub(crate) fn repeat(&mut self, name: Name, line: u32) {
        self.repeated.entry(name).or_default().push(line);
    }

    /// The lines that declare a name again.
    pub(crate) fn lines_repeating(&self, name: &Name) -> &[u32] {
        self.repeated.get(name).map_or(&[], Vec::as_slice)
    }

    /// Whether it says something of these lines and names.
    fn is_about(&self, lines: &[u32], names: &FxHashSet<Name>) -> bool {
        lines.iter().any(|line| self.found.contains_key(line))
            || names.iter().any(|name| self.repeated.contains_key(name))
    }

    /// Some lines, which have all declarations of these names, are gone or read anew: what they bring takes the place of what
    /// was known of them.
    pub(crate) fn exchange(self: &mut Arc<Self>, lines: &[u32], names: &FxHashSet<Name>, new: Misdeclared) {
        let brings_none = new.found.is_empty() && new.repeated.is_empty();
        if brings_none && !self.is_about(lines, names) {
            return;
        }
        let all = Arc::make_mut(self);
        for line in lines {
            all.found.remove(line);
        }
        for name in names {
            all.repeated.remove(name);
        }
        all.found.extend(new.found);
        all.repeated.extend(new.repeated);
    }
}

#[cfg(test)]
mod tests {
    use super::Misdeclared;
    use crate::diagnostic::Diagnostic;
    use crate::findings::Anchored;
    use crate::rule::Rule;
    use ladder_syntax::{Name, TextRange};
    use std::sync::Arc;

    #[test]
    fn lines_take_the_place_of_others() {
        let wrong = |line: u32| {
            let found = Diagnostic::new(Rule::BadDeclaration, TextRange::default(), "");
            vec![Arc::new(Anchored::on_line(found, line, line))]
        };
        let (a, b) = (Name::new("a"), Name::new("b"));
        let mut all = Misdeclared::default();
        all.find(2, wrong(2));
        all.find(5, wrong(5));
        all.repeat(a.clone(), 5);
        all.repeat(b.clone(), 7);
        let mut now = Arc::new(all);
        let before = Arc::clone(&now);
        now.exchange(
            &[3],
            &[Name::new("c")].into_iter().collect(),
            Misdeclared::default(),
        );
        assert!(Arc::ptr_eq(&before, &now));
        let mut new = Misdeclared::default();
        new.find(8, wrong(8));
        new.repeat(b.clone(), 8);
        now.exchange(&[5, 7], &[a.clone(), b.clone()].into_iter().collect(), new);
        assert_eq!(now.found().count(), 2);
        assert_eq!(
            (now.lines_repeating(&a), now.lines_repeating(&b)),
            (&[][..], &[8][..])
        );
        assert_eq!(before.lines_repeating(&a), [5]);
    }
}
