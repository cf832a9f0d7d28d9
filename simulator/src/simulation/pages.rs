//! Long arrays in lists: they open into stretches of elements, `a[1] .. a[100]`, which open into these.

use super::Simulation;
use crate::groups::{Entry, Group};

/// A list of more elements is parted.
const LONG: usize = 200;

/// A stretch has so many elements.
const STRETCH: usize = 100;

/// What is between its first and last element in its name.
const TO: &str = " .. ";

/// The elements of an array, or if they are many the stretches of them.
pub(super) fn parted(array: &Group, entries: Vec<Entry>) -> Vec<Entry> {
    if !array.is_array() || entries.len() <= LONG {
        return entries;
    }
    let stretches = entries.chunks(STRETCH).map(|elements| stretch(array, elements));
    stretches.flatten().map(Entry::Group).collect()
}

fn stretch(array: &Group, elements: &[Entry]) -> Option<Group> {
    let (first, last) = (elements.first()?, elements.last()?);
    Some(Group {
        name: format!("{}{TO}{}", name(first), name(last)),
        ty: match first {
            Entry::Value(point) => point.ty.to_string(),
            Entry::Group(group) => group.ty.clone(),
        },
        parts: elements.len() as u64,
        state: None,
        ..array.clone()
    })
}

fn name(entry: &Entry) -> &str {
    match entry {
        Entry::Value(point) => &point.name,
        Entry::Group(group) => &group.name,
    }
}

impl Simulation {
    /// The elements of a stretch. None: the text names none.
    pub(super) fn stretch(&self, text: &str) -> Option<Vec<Entry>> {
        let (first, last) = text.split_once(TO)?;
        let array = &first[..first.rfind('[')?];
        let mut entries = self.opened(array)?;
        let at = |wanted: &str| {
            let mut all = entries.iter();
            all.position(|entry| name(entry).eq_ignore_ascii_case(wanted))
        };
        let (first, last) = (at(first)?, at(last)?);
        (first <= last).then(|| entries.drain(first..=last).collect())
    }

    /// What a text names that opens: a tag or part of one, or a stretch of elements.
    pub fn listed_group(&self, text: &str) -> Option<Group> {
        if let Some((first, _)) = text.split_once(TO) {
            let array = self.group(&first[..first.rfind('[')?])?;
            return stretch(&array, &self.stretch(text)?);
        }
        self.group(text)
    }

    /// Whether something in what a list shows so is forced.
    pub fn has_forced(&self, group: &Group) -> bool {
        let is_in = |path: &str| self.forced().any(|forced| forced.is_in(path));
        if self.forced().next().is_none() || !group.name.contains(TO) {
            return is_in(&group.name);
        }
        let elements = self.stretch(&group.name).unwrap_or_default();
        elements.iter().any(|element| is_in(name(element)))
    }
}
