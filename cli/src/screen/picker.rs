//! Finding a tag by typing some of its name.

use super::plant::Plant;
use ladder_analysis::program::{Place, Program, TagId};
use ladder_simulator::{Entry, Group, Point};
use std::collections::HashSet;

/// This many are offered.
const OFFERED: usize = 100;

/// A list of tags that match what was typed.
#[derive(Debug)]
pub(super) struct Picker {
    pub(super) purpose: Purpose,
    pub(super) text: String,
    /// The best match first; while nothing is typed the tags of the program as a tree.
    pub(super) matches: Vec<Row>,
    /// The match that Enter takes.
    pub(super) chosen: usize,
    /// Offered first while nothing is typed.
    near: Vec<Point>,
    /// The paths of those that are open.
    open: HashSet<String>,
    /// What blocks name, which is offered before what none does.
    in_blocks: HashSet<String>,
}

/// A line of the list.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub(super) entry: Entry,
    /// How many open tags it is in.
    pub(super) depth: u16,
    pub(super) is_open: bool,
}

impl Row {
    fn of(point: Point) -> Row {
        Row {
            entry: Entry::Value(point),
            depth: 0,
            is_open: false,
        }
    }

    fn is(&self, point: &Point) -> bool {
        matches!(&self.entry, Entry::Value(own) if own.name == point.name)
    }
}

/// What a tag is looked for for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// To be watched, or no more.
    Watch,
    /// To go where it is.
    Find,
}

impl Picker {
    /// A list with some tags on top.
    pub(super) fn new(purpose: Purpose, near: Vec<Point>, plant: &Plant) -> Picker {
        let mut picker = Picker {
            purpose,
            text: String::new(),
            matches: Vec::new(),
            chosen: 0,
            near,
            open: HashSet::new(),
            in_blocks: named_in_blocks(plant.simulation().program()),
        };
        picker.search(plant);
        picker
    }

    pub(super) fn put(&mut self, letter: char, plant: &Plant) {
        self.text.push(letter);
        self.search(plant);
    }

    pub(super) fn delete(&mut self, plant: &Plant) {
        self.text.pop();
        self.search(plant);
    }

    pub(super) fn clear(&mut self, plant: &Plant) {
        self.text.clear();
        self.search(plant);
    }

    pub(super) fn move_by(&mut self, lines: isize) {
        let last = self.matches.len().saturating_sub(1);
        self.chosen = self.chosen.saturating_add_signed(lines).min(last);
    }

    /// The tag that Enter takes.
    pub(super) fn choice(&self) -> Option<&Point> {
        match &self.matches.get(self.chosen)?.entry {
            Entry::Value(point) => Some(point),
            Entry::Group(_) => None,
        }
    }

    /// Whether the chosen line opens, and is open.
    pub(super) fn opens(&self) -> Option<bool> {
        let row = self.matches.get(self.chosen)?;
        matches!(row.entry, Entry::Group(_)).then_some(row.is_open)
    }

    /// Opens the chosen line or closes it. In what is open, closing is that of the line around it.
    pub(super) fn fold(&mut self, open: bool, plant: &Plant) {
        let Some(row) = self.matches.get(self.chosen) else {
            return;
        };
        let depth = row.depth;
        if !open && (!row.is_open || self.opens().is_none()) {
            let around = self.matches[..self.chosen]
                .iter()
                .rposition(|row| row.depth < depth);
            self.chosen = around.unwrap_or(self.chosen);
        }
        let Some(Row {
            entry: Entry::Group(group),
            ..
        }) = self.matches.get(self.chosen)
        else {
            return;
        };
        if open {
            self.open.insert(group.name.clone());
        } else {
            self.open.remove(&group.name);
        }
        let chosen = self.chosen;
        self.search(plant);
        self.chosen = chosen.min(self.matches.len().saturating_sub(1));
    }

    fn add(&mut self, entries: Vec<Entry>, depth: u16, plant: &Plant) {
        for entry in entries {
            let is_near = |near: &Point| matches!(&entry, Entry::Value(point) if point.name == near.name);
            if self.matches.len() >= OFFERED || self.near.iter().any(is_near) {
                continue;
            }
            let opened = match &entry {
                Entry::Group(Group { name, .. }) if self.open.contains(name) => Some(name.clone()),
                _ => None,
            };
            self.matches.push(Row {
                entry,
                depth,
                is_open: opened.is_some(),
            });
            if let Some(path) = opened {
                self.add(plant.simulation().listed(&path), depth + 1, plant);
            }
        }
    }

    /// Whether a block names a tag, or the timer, array or structure that it is a part of.
    fn is_in_block(&self, point: &Point) -> bool {
        let name = point.name.as_str();
        let ends = name.match_indices(['.', '[']).map(|(end, _)| end);
        let mut wholes = ends.map(|end| &name[..end]);
        self.in_blocks.contains(name) || wholes.any(|whole| self.in_blocks.contains(whole))
    }

    fn search(&mut self, plant: &Plant) {
        self.chosen = 0;
        let simulation = plant.simulation();
        let wanted = self.text.trim().to_lowercase();
        if wanted.is_empty() {
            self.matches = self.near.iter().cloned().map(Row::of).collect();
            self.add(simulation.entries(""), 0, plant);
            return;
        }
        let mut found: Vec<(Likeness, bool, &Point)> = simulation
            .points()
            .iter()
            .filter_map(|point| Some((likeness(&point.name, &wanted)?, !self.is_in_block(point), point)))
            .collect();
        found.sort_by_key(|(likeness, is_in_none, _)| (*likeness, *is_in_none));
        found.truncate(OFFERED);
        let found = found.into_iter().map(|(_, _, point)| Row::of(point.clone()));
        self.matches = found.collect();
        // Elements of long arrays, bits of words and system tags are not in the list of all tags.
        if wanted.contains('[') {
            let more = simulation.search(self.text.trim()).into_iter();
            let known = self.matches.len();
            let new = |point: &Point| !self.matches[..known].iter().any(|found| found.is(point));
            let more: Vec<Row> = more.filter(new).take(OFFERED - known).map(Row::of).collect();
            self.matches.extend(more);
        }
        if let Ok(point) = simulation.resolve(self.text.trim())
            && !self.matches.iter().any(|found| found.is(&point))
        {
            self.matches.insert(0, Row::of(point));
        }
    }
}

/// What the blocks of a program name.
fn named_in_blocks(program: &Program) -> HashSet<String> {
    let blocks = program.networks.iter().flat_map(|network| &network.blocks);
    let name = |tag: TagId| program.tags[tag.0 as usize].name.clone();
    let mut names = HashSet::new();
    for bound in blocks.flat_map(|block| &block.arguments) {
        names.extend(bound.argument.root().map(name));
        for (place, _) in bound.places() {
            names.extend(match place {
                Place::Member(tag, member) => Some(format!("{}.{}", name(*tag), member.name())),
                place => place.root().map(name),
            });
        }
    }
    names
}

/// How a name matches, the best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Likeness {
    Same,
    Begins,
    Holds,
    /// Its letters are in the name in this order.
    InOrder,
}

fn likeness(name: &str, wanted: &str) -> Option<Likeness> {
    let name = name.to_lowercase();
    if name == wanted {
        return Some(Likeness::Same);
    }
    if name.starts_with(wanted) {
        return Some(Likeness::Begins);
    }
    if name.contains(wanted) {
        return Some(Likeness::Holds);
    }
    let mut letters = name.chars();
    wanted
        .chars()
        .all(|letter| letters.any(|other| other == letter))
        .then_some(Likeness::InOrder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_match_comes_first() {
        for (name, wanted, found) in [
            ("Run", "run", Some(Likeness::Same)),
            ("runtime", "run", Some(Likeness::Begins)),
            ("dry_run", "run", Some(Likeness::Holds)),
            ("reserve_unit", "run", Some(Likeness::InOrder)),
            ("nur", "run", None),
        ] {
            assert_eq!(likeness(name, wanted), found, "{name}");
        }
    }
}
