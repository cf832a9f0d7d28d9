//! Finding a tag by typing some of its name.

use super::plant::Plant;
use ladder_simulator::Point;

/// This many are offered.
const OFFERED: usize = 100;

/// A list of tags that match what was typed.
#[derive(Debug)]
pub(super) struct Picker {
    pub(super) purpose: Purpose,
    pub(super) text: String,
    /// The best match first.
    pub(super) matches: Vec<Point>,
    /// The match that Enter takes.
    pub(super) chosen: usize,
    /// Offered first while nothing is typed.
    near: Vec<Point>,
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
        self.matches.get(self.chosen)
    }

    fn search(&mut self, plant: &Plant) {
        self.chosen = 0;
        let simulation = plant.simulation();
        let wanted = self.text.trim().to_lowercase();
        if wanted.is_empty() {
            self.matches.clone_from(&self.near);
            let others = simulation
                .points()
                .iter()
                .filter(|point| self.near.iter().all(|near| near.name != point.name));
            self.matches.extend(others.take(OFFERED).cloned());
            return;
        }
        let mut found: Vec<(Likeness, usize, &Point)> = simulation
            .points()
            .iter()
            .enumerate()
            .filter_map(|(index, point)| Some((likeness(&point.name, &wanted)?, index, point)))
            .collect();
        found.sort_by_key(|(likeness, index, _)| (*likeness, *index));
        found.truncate(OFFERED);
        self.matches = found.into_iter().map(|(_, _, point)| point.clone()).collect();
        // Elements of long arrays, bits of words and system tags are not in the list of all tags.
        if wanted.contains('[') {
            let more = simulation.search(self.text.trim()).into_iter();
            let known = self.matches.len();
            let new = |point: &Point| self.matches[..known].iter().all(|found| found.name != point.name);
            let more: Vec<Point> = more.filter(new).take(OFFERED - known).collect();
            self.matches.extend(more);
        }
        if let Ok(point) = simulation.resolve(self.text.trim())
            && self.matches.iter().all(|found| found.name != point.name)
        {
            self.matches.insert(0, point);
        }
    }
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
