//! Tags in lists: which there are, what they open into, and which fit a text.

use super::Simulation;
use crate::groups::{Entry, Group, element, is_long, own, parts, range_of};
use crate::tags::{Point, UnknownTag, canonical};
use ladder_analysis::program::{Tag, TagId};
use ladder_analysis::values::types::Type;

impl Simulation {
    /// The tags of the program in the order of their first appearance: elementary tags, the members of timers, counters and
    /// bistables that show what they do, and an entry for each array.
    pub fn entries(&self) -> Vec<Entry> {
        let mut entries = Vec::new();
        for (tag, home) in own(&self.program, &self.compiled.homes) {
            let (first, last) = match (tag.ty, &tag.column) {
                (Type::Array { first, last, .. }, None) => (first, last),
                (_, Some(_)) if is_long(tag) => continue,
                _ => {
                    entries.extend(parts(&self.program, tag, home).map(Entry::Value));
                    continue;
                }
            };
            entries.push(Entry::Group(Group {
                name: tag.name.clone(),
                ty: tag.ty.to_string(),
                role: tag.role,
                read_only: tag.constant,
                parts: last.abs_diff(first) + 1,
            }));
        }
        entries
    }

    /// Whether an array has so many elements that [`Self::points`] has none of them.
    pub fn is_long(&self, tag: TagId) -> bool {
        is_long(&self.program.tags[tag.0 as usize])
    }

    /// The values that a text names: one, as for [`Self::resolve`]; of an array all elements, or those of a range,
    /// `a[2..5]`; of a timer, counter or bistable the members that show what it does.
    ///
    /// # Errors
    /// There is no such value.
    pub fn resolve_all(&self, text: &str) -> Result<Vec<Point>, UnknownTag> {
        let resolved = self.resolve(text);
        let Err(unknown) = resolved else {
            return resolved.map(|point| vec![point]);
        };
        let (name, range) = match range_of(text) {
            Some((name, first, last)) => (name, Some((first, last))),
            None => (text.trim(), None),
        };
        let Some(index) = self.names.find(name) else {
            let parts = self.parts_of(text);
            return if parts.is_empty() { Err(unknown) } else { Ok(parts) };
        };
        let (tag, home) = (&self.program.tags[index], self.compiled.homes[index]);
        let Some((from, to)) = range else {
            let all: Vec<Point> = parts(&self.program, tag, home).collect();
            return if all.is_empty() { Err(unknown) } else { Ok(all) };
        };
        // Both ends are elements.
        for end in [from, to] {
            self.resolve(&format!("{name}[{end}]"))?;
        }
        if from > to {
            return Err(UnknownTag {
                message: format!(
                    "{}[{from}..{to}] has no elements: write the smaller index first",
                    tag.name
                ),
            });
        }
        Ok((from..=to).filter_map(|at| element(tag, home, at)).collect())
    }

    /// The values of a structure, an array of such, or an element of one.
    fn parts_of(&self, text: &str) -> Vec<Point> {
        let whole = canonical(text).to_lowercase();
        let is_part = |name: &str| {
            let rest = name.to_lowercase();
            let rest = rest.strip_prefix(&whole);
            let ended = whole.strip_suffix(']').and_then(|begun| {
                let name = name.to_lowercase();
                name.strip_prefix(begun).map(|rest| rest.starts_with(", "))
            });
            rest.is_some_and(|rest| rest.starts_with(['.', '['])) || ended == Some(true)
        };
        let root = whole.split(['.', '[']).next().unwrap_or_default().to_owned();
        let is_of_root = |tag: &Tag| {
            let name = tag.name.to_lowercase();
            let rest = name.strip_prefix(&root);
            tag.column.is_some() && rest.is_some_and(|rest| rest.starts_with(['.', '[']))
        };
        let tags = own(&self.program, &self.compiled.homes).filter(|(tag, _)| is_of_root(tag));
        tags.flat_map(|(tag, home)| parts(&self.program, tag, home))
            .filter(|point| is_part(&point.name))
            .collect()
    }

    /// Every listed value whose name holds a text, in any case; with a bracket also elements of long arrays.
    pub fn search(&self, text: &str) -> Vec<Point> {
        let wanted = text.to_lowercase();
        let fits = |point: &Point| point.name.to_lowercase().contains(&wanted);
        let mut found: Vec<Point> = self.points.iter().filter(|point| fits(point)).cloned().collect();
        if let Some((array, _)) = wanted.split_once('[') {
            for (tag, home) in own(&self.program, &self.compiled.homes) {
                if is_long(tag) && tag.name.to_lowercase().ends_with(array) {
                    found.extend(parts(&self.program, tag, home).filter(fits));
                }
            }
        }
        found
    }
}
