//! Boxes of blocks: four edges, with a name and operands inside.

use crate::marks::{Mark, Marks};
use crate::sheet::{Sheet, arms, is_bar, is_wire};

/// A box is no wider and no higher: so the search for them takes linear time.
const WIDEST: usize = 80;
const HIGHEST: usize = 40;

/// A box, edges included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Frame {
    pub(crate) top: usize,
    pub(crate) bottom: usize,
    pub(crate) left: usize,
    pub(crate) right: usize,
    /// What is written in the upper edge.
    pub(crate) edge: String,
    /// The lines inside.
    pub(crate) inside: Vec<String>,
}

/// All boxes, which are marked.
pub(crate) fn find(sheet: &Sheet, marks: &mut Marks) -> Vec<Frame> {
    let mut frames = Vec::new();
    for top in 0..sheet.len() {
        let mut left = 0;
        while left < sheet.width(top) {
            let found = frame(sheet, top, left).filter(|_| marks.at(top, left) == Mark::None);
            let Some(frame) = found else {
                left += 1;
                continue;
            };
            for line in frame.top..=frame.bottom {
                marks.set(line, frame.left..frame.right + 1, Mark::Frame(frames.len()));
            }
            left = frame.right + 1;
            frames.push(frame);
        }
    }
    frames
}

/// The box whose upper left corner is at a place.
fn frame(sheet: &Sheet, top: usize, left: usize) -> Option<Frame> {
    let corner = |line: usize, column: usize| {
        let c = sheet.at(line, column);
        arms(c).filter(|_| !is_bar(c))
    };
    corner(top, left).filter(|arms| arms.right && arms.down)?;
    let right = (left + 1..left + WIDEST).find(|&column| arms(sheet.at(top, column)).is_some())?;
    corner(top, right).filter(|arms| arms.left && arms.down)?;
    let edge: Vec<char> = (left + 1..right).map(|column| sheet.at(top, column)).collect();
    let in_edge = |c: &char| is_wire(*c) || c.is_alphanumeric() || " _$./:".contains(*c);
    let is_edge = |edge: &[char]| edge.len() > 1 && edge.iter().all(in_edge);
    let has_wire = |edge: &[char]| edge.iter().any(|c| is_wire(*c));
    // A name may take the whole upper edge.
    if !is_edge(&edge) || !edge.iter().any(|c| is_wire(*c) || c.is_alphabetic()) {
        return None;
    }
    let side = |line: usize, column: usize| arms(sheet.at(line, column)).is_some_and(|arms| arms.up);
    for bottom in top + 1..top + HIGHEST {
        if !side(bottom, left) || !side(bottom, right) {
            return None;
        }
        let lower: Vec<char> = (left + 1..right).map(|column| sheet.at(bottom, column)).collect();
        let closes = corner(bottom, left).is_some_and(|arms| arms.right)
            && corner(bottom, right).is_some_and(|arms| arms.left)
            && is_edge(&lower)
            && has_wire(&lower);
        if closes {
            let inside = (top + 1..bottom).map(|line| sheet.text(line, left + 1, right));
            let frame = Frame {
                top,
                bottom,
                left,
                right,
                edge: edge.iter().map(|&c| if is_wire(c) { ' ' } else { c }).collect(),
                inside: inside.collect(),
            };
            return frame.says_something(sheet).then_some(frame);
        }
    }
    None
}

impl Frame {
    /// Branches make four edges too: those have wires and contacts inside, or nothing.
    fn says_something(&self, sheet: &Sheet) -> bool {
        let lines = self.top + 1..self.bottom;
        let mut cells = lines.flat_map(|line| (self.left + 1..self.right).map(move |column| (line, column)));
        let wired = |(line, column): (usize, usize)| {
            let c = sheet.at(line, column);
            let is_run = is_wire(c) && is_wire(sheet.at(line, column + 1));
            is_run || (arms(c).is_some() && c != '+')
        };
        let says = |text: &String| text.chars().any(char::is_alphanumeric);
        !cells.any(wired) && (says(&self.edge) || self.inside.iter().any(says))
    }
}
