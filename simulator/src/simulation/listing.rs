//! Tags in lists: which there are, what they open into, and which fit a text.

use super::Simulation;
use super::pages::parted;
use crate::groups::{Entry, Group, is_long, own, parts, range_of};
use crate::tags::{Point, UnknownTag, canonical, is_inside};
use crate::tree::{Grown, Tree};
use ladder_analysis::program::{Tag, TagId};
use ladder_analysis::values::types::Type;

/// Of an array with more elements than this a table of all tags has none.
const MOST_IN_TABLE: u64 = 64;

/// What a table has of timers, counters and bistables.
const IN_TABLE: [&str; 4] = ["ET", "CV", "Q", "Q1"];

impl Simulation {
    /// The tags of the program in the order of their first appearance: elementary tags, and an entry for each tag that opens.
    pub fn tags(&self) -> Vec<Entry> {
        self.grown().tags()
    }

    /// What a path opens into: the members of a structure or of a block's state, the elements of an array, the members of a timer
    /// that show what it does. None: the program has no such tag, or it does not open.
    pub fn opened(&self, path: &str) -> Option<Vec<Entry>> {
        let grown = self.grown();
        let part = grown.tree.part(path)?;
        grown.group(&part).map(|_| grown.entries_of(&part))
    }

    /// What a path names, if it opens.
    pub fn group(&self, path: &str) -> Option<Group> {
        let grown = self.grown();
        grown.group(&grown.tree.part(path)?)
    }

    /// The same tags, or the entries that a path opens into.
    pub fn entries(&self, path: &str) -> Vec<Entry> {
        match path {
            "" => self.tags(),
            path => self.opened(path).unwrap_or_default(),
        }
    }

    /// The same for a person to look through: a long array opens into stretches of its elements, which open likewise.
    pub fn listed(&self, path: &str) -> Vec<Entry> {
        let elements = self.stretch(path);
        let entries = elements.or_else(|| Some(parted(&self.group(path)?, self.opened(path)?)));
        entries.unwrap_or_else(|| self.entries(path))
    }

    fn grown(&self) -> Grown<'_> {
        Grown {
            tree: self.tree.get_or_init(|| Tree::of(&self.program)),
            program: &self.program,
            homes: &self.compiled.homes,
        }
    }

    /// What a table of all tags has of a tag: its elementary parts, of a timer or counter `ET`, `CV` and `Q`. Nothing of a
    /// constant, of the inside of a block's state, and of a long array.
    pub fn in_table(&self, id: TagId) -> Vec<Point> {
        let (tag, home) = (
            &self.program.tags[id.0 as usize],
            self.compiled.homes[id.0 as usize],
        );
        if tag.constant || tag.block.is_some() || is_inside(tag) || longest_array(tag) > MOST_IN_TABLE {
            return Vec::new();
        }
        if !matches!(tag.ty, Type::State(_)) {
            return parts(&self.program, tag, home).collect();
        }
        let members = IN_TABLE.iter().filter_map(|member| {
            let name = format!("{}.{member}", tag.name);
            let point = self.resolve(&name).ok()?;
            Some(Point { name, ..point })
        });
        members.collect()
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
        let Some((before, from, to)) = range_of(text) else {
            let grown = self.grown();
            let found = grown.tree.part(text).map(|part| grown.values(&part));
            return found.filter(|points| !points.is_empty()).ok_or(unknown);
        };
        // Both ends are elements.
        for end in [from, to] {
            self.resolve_all(&format!("{before}{end}]"))?;
        }
        if from > to {
            return Err(UnknownTag {
                message: format!(
                    "{}{from}..{to}] has no elements: write the smaller index first",
                    canonical(before)
                ),
            });
        }
        let elements = (from..=to).map(|index| self.resolve_all(&format!("{before}{index}]")));
        Ok(elements.flatten().flatten().collect())
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

/// How many elements the longest array around a value has.
fn longest_array(tag: &Tag) -> u64 {
    match (&tag.column, tag.ty) {
        (Some(column), _) => column.longest_array,
        (None, Type::Array { first, last, .. }) => last.abs_diff(first) + 1,
        _ => 0,
    }
}
