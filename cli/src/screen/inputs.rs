//! The inputs with numbers: which key switches which, and where each is in its bar.

use super::plant::Plant;
use super::values;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_format::display_width;
use ladder_simulator::Point;

/// This many have a key of their own.
const NUMBERED: usize = 9;

/// The bar takes at most this many lines.
const LINES: u16 = 2;

/// The inputs that have a key, in their order.
pub(super) fn numbered(plant: &Plant) -> &[Point] {
    let inputs = &plant.sheet.inputs;
    &inputs[..inputs.len().min(NUMBERED)]
}

/// Where the inputs are.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Flow {
    pub(super) lines: u16,
    pub(super) entries: Vec<Entry>,
    /// Some inputs have no key, or no room.
    pub(super) more: usize,
}

/// One input in the bar.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Its number, from 0.
    pub(super) index: usize,
    pub(super) line: u16,
    pub(super) column: u16,
    pub(super) width: u16,
    /// What is after its number.
    pub(super) text: String,
}

/// Puts the inputs into lines of a width.
pub(super) fn flow(plant: &Plant, width: u16) -> Flow {
    let mut entries: Vec<Entry> = Vec::new();
    let (mut line, mut column) = (0, 1);
    for (index, point) in numbered(plant).iter().enumerate() {
        let text = text(plant, point);
        // The key, a blank, the dot, a blank.
        let needed = display_width(&text) as u16 + 4;
        if column > 1 && column + needed > width {
            line += 1;
            column = 1;
        }
        if line == LINES {
            break;
        }
        entries.push(Entry {
            index,
            line,
            column,
            width: needed,
            text,
        });
        column += needed + 3;
    }
    Flow {
        lines: entries.last().map_or(0, |last| last.line + 1),
        more: plant.sheet.inputs.len() - entries.len(),
        entries,
    }
}

fn text(plant: &Plant, point: &Point) -> String {
    if point.ty == Scalar::Bool {
        return point.name.clone();
    }
    let value: Value = plant.value(point);
    // A little room, so that the others stay where they are while a number grows.
    format!("{}={:<4}", point.name, values::short(&value, point.ty))
}
