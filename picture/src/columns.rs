//! Columns: where everything of a network is. As in the text (LANGUAGE §8 rules 3 and 5), but with a vertical line
//! of any number of rungs as one thing.
//!
//! First everything is as far left as its neighbours allow: a longest path through the rungs, in which each thing
//! is met once. Lines from rung to rung do not cross, so there always is an order in which everything left of a thing
//! comes before it. Then what acts moves to the right rail, by the same path from the other end.

use super::figure::Figure;
use super::grid::{Grid, Kind, Thing};
use super::nodes::{apart, joints};

/// Columns between neighbours on a rung.
const SPACING: u32 = 2;

/// A network whose things have their columns.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) grid: Grid,
    /// For each thing the column in which it begins, from 0.
    pub(super) columns: Vec<u32>,
    /// The column that the right rail would have at the least; none if nothing ends there.
    pub(super) least_rail: Option<u32>,
}

/// The columns of a network with everything as far left as possible.
pub(super) fn layout(figure: &Figure) -> Layout {
    let grid = Grid::new(figure, &joints(figure));
    if let Some(columns) = place_left(&grid) {
        return Layout::new(grid, columns);
    }
    debug_assert!(false, "lines from rung to rung cross");
    // Without joints there is an order: that in which the program is run.
    let grid = Grid::new(figure, &apart(figure));
    let columns = place_left(&grid).unwrap_or_else(|| vec![0; grid.things.len()]);
    Layout::new(grid, columns)
}

impl Layout {
    fn new(grid: Grid, columns: Vec<u32>) -> Layout {
        let is_railed = grid.things.iter().any(|thing| thing.kind == Kind::RightRail);
        let ends = grid.rungs.iter().filter_map(|slots| {
            let last = slots.last()?.thing;
            Some(match grid.things[last].kind {
                Kind::RightRail => columns[last],
                _ => columns[last] + grid.things[last].columns + SPACING,
            })
        });
        let least_rail = ends.max().filter(|_| is_railed);
        Layout {
            grid,
            columns,
            least_rail,
        }
    }

    /// Moves what acts to the right rail, which is in this column.
    pub(super) fn move_right(&mut self, rail: u32) {
        let grid = &self.grid;
        let still = find_still(grid);
        let moves = |thing: &Thing| thing.slots.iter().all(|&(rung, slot)| slot >= still[rung]);
        let moving: Vec<bool> = grid.things.iter().map(moves).collect();
        // The column after each thing, spacing aside.
        let mut after = vec![rail.saturating_sub(SPACING); grid.things.len()];
        let mut waits: Vec<usize> = Vec::with_capacity(grid.things.len());
        for thing in &grid.things {
            let has_next = |&&(rung, slot): &&(usize, usize)| slot + 1 < grid.rungs[rung].len();
            waits.push(thing.slots.iter().filter(has_next).count());
        }
        let mut ready: Vec<usize> = (0..grid.things.len())
            .filter(|&thing| moving[thing] && waits[thing] == 0)
            .collect();
        while let Some(index) = ready.pop() {
            let thing = &grid.things[index];
            let column = match thing.kind {
                Kind::RightRail => rail,
                _ => after[index].saturating_sub(thing.columns),
            };
            self.columns[index] = column;
            for &(rung, slot) in &thing.slots {
                let Some(before) = slot.checked_sub(1) else {
                    continue;
                };
                let before = grid.rungs[rung][before].thing;
                after[before] = after[before].min(column.saturating_sub(SPACING));
                waits[before] -= 1;
                if moving[before] && waits[before] == 0 {
                    ready.push(before);
                }
            }
        }
    }
}

/// The columns of all things as far left as possible; none if their order is not an order.
fn place_left(grid: &Grid) -> Option<Vec<u32>> {
    let is_railed = grid.things.iter().any(|thing| thing.kind == Kind::LeftRail);
    let margin = if is_railed { 1 + SPACING } else { 0 };
    let mut columns: Vec<u32> = Vec::with_capacity(grid.things.len());
    let mut waits: Vec<usize> = Vec::with_capacity(grid.things.len());
    for thing in &grid.things {
        let at_rail = thing.kind == Kind::LeftRail;
        columns.push(if at_rail { 0 } else { margin });
        waits.push(thing.slots.iter().filter(|(_, slot)| *slot > 0).count());
    }
    let mut ready: Vec<usize> = (0..waits.len()).filter(|&thing| waits[thing] == 0).collect();
    let mut placed = 0;
    while let Some(index) = ready.pop() {
        placed += 1;
        let thing = &grid.things[index];
        let edge = columns[index] + thing.columns + SPACING;
        for &(rung, slot) in &thing.slots {
            let Some(next) = grid.rungs[rung].get(slot + 1) else {
                continue;
            };
            columns[next.thing] = columns[next.thing].max(edge);
            waits[next.thing] -= 1;
            if waits[next.thing] == 0 {
                ready.push(next.thing);
            }
        }
    }
    (placed == grid.things.len()).then_some(columns)
}

/// For each rung how many of its things stay where they are; the others move right. An acting block does if everything
/// right of it does; a line or a comment needs something that moves directly left of it besides. The two lean on each
/// other, so the answer is the largest set that holds: begin with all that could, and take away what cannot.
fn find_still(grid: &Grid) -> Vec<usize> {
    let could = |kind| !matches!(kind, Kind::LeftRail | Kind::Condition);
    let mut still = Vec::with_capacity(grid.rungs.len());
    for slots in &grid.rungs {
        let last = slots
            .iter()
            .rposition(|slot| !could(grid.things[slot.thing].kind));
        still.push(last.map_or(0, |last| last + 1));
    }
    // What lies left of `still` on a rung has stopped; `passed_on` of it have stopped on their other rungs too.
    let mut passed_on = vec![0; grid.rungs.len()];
    let mut open: Vec<usize> = (0..grid.rungs.len()).collect();
    for (rung, slots) in grid.rungs.iter().enumerate() {
        for slot in slots.iter().skip(still[rung]) {
            if !slot.joined && !is_held(grid, slot.thing, &still) {
                stop(&grid.things[slot.thing], &mut still, &mut open);
            }
        }
    }
    while let Some(rung) = open.pop() {
        while passed_on[rung] < still[rung] {
            let thing = grid.rungs[rung][passed_on[rung]].thing;
            passed_on[rung] += 1;
            stop(&grid.things[thing], &mut still, &mut open);
        }
        if let Some(slot) = grid.rungs[rung].get(still[rung])
            && !is_held(grid, slot.thing, &still)
        {
            stop(&grid.things[slot.thing], &mut still, &mut open);
        }
    }
    still
}

/// Whether a thing may move as far as what is directly left of it goes.
fn is_held(grid: &Grid, thing: usize, still: &[usize]) -> bool {
    let thing = &grid.things[thing];
    if !matches!(thing.kind, Kind::Node | Kind::Comment) {
        return true;
    }
    let has_moving = |&(rung, slot): &(usize, usize)| grid.rungs[rung][slot].joined && slot > still[rung];
    thing.slots.iter().any(has_moving)
}

/// A thing stays, and with it all left of it on its rungs.
fn stop(thing: &Thing, still: &mut [usize], open: &mut Vec<usize>) {
    for &(rung, slot) in &thing.slots {
        if still[rung] <= slot {
            still[rung] = slot + 1;
            open.push(rung);
        }
    }
}
