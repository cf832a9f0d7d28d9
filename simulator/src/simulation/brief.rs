//! What a tag that opens shows while it is closed.

use super::Simulation;
use crate::groups::{Entry, Group};
use crate::members::members_of;
use crate::value_text;

/// A structure shows so many of its values.
const SHOWN: usize = 3;

/// A timer or counter shows so many of its members: the most telling ones come first.
const SHOWN_OF_STATE: usize = 2;

impl Simulation {
    /// Of a timer its most telling members, of a structure its first values: `speed=20.0 running=TRUE`. Nothing of an array. It is
    /// called so where it is shown.
    pub fn brief(&self, group: &Group, name: &str) -> String {
        if group.is_array() {
            return String::new();
        }
        let of_member = |member: &str| {
            let point = self.resolve(&format!("{name}.{member}")).ok()?;
            let value = value_text::display(&self.value(&point), point.ty);
            Some(format!("{member}={value}"))
        };
        let values: Vec<String> = match group.state {
            Some(state) => members_of(state)
                .take(SHOWN_OF_STATE)
                .filter_map(of_member)
                .collect(),
            None => {
                let entries = self.opened(name).unwrap_or_default().into_iter();
                let values = entries.filter_map(|entry| match entry {
                    Entry::Value(point) => of_member(point.name.get(name.len() + 1..)?),
                    Entry::Group(_) => None,
                });
                values.take(SHOWN).collect()
            }
        };
        values.join(" ")
    }
}
