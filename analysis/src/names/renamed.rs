//! Names that lead to numbers, and few of which change with an edit.

use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// So many names are looked through one by one before all of them are put together anew.
const MOST: usize = 32;

/// Names with numbers. Copies share what they have in common.
#[derive(Debug, Clone, Default)]
pub(crate) struct Renamed {
    names: Arc<FxHashMap<Name, u32>>,
    /// What has changed of these names since.
    changed: Vec<(Name, Option<u32>)>,
}

impl Renamed {
    /// The number to which a name leads.
    pub(crate) fn get(&self, name: &Name) -> Option<u32> {
        let changed = self.changed.iter().find(|(changed, _)| changed == name);
        match changed {
            Some((_, number)) => *number,
            None => self.names.get(name).copied(),
        }
    }

    /// Adds a name before any has changed, if it is not there.
    pub(crate) fn add(&mut self, name: Name, number: u32) {
        Arc::make_mut(&mut self.names).entry(name).or_insert(number);
    }

    /// A name leads to another number, or to none any longer.
    pub(crate) fn set(&mut self, name: Name, number: Option<u32>) {
        if self.get(&name) == number {
            return;
        }
        self.changed.retain(|(changed, _)| *changed != name);
        self.changed.push((name, number));
        if self.changed.len() <= MOST {
            return;
        }
        let names = Arc::make_mut(&mut self.names);
        for (name, number) in self.changed.drain(..) {
            match number {
                Some(number) => names.insert(name, number),
                None => names.remove(&name),
            };
        }
    }
}
