//! What is next to a box: where power comes to it and leaves it, and the values of its pins.

use crate::block;
use crate::frame::Frame;
use crate::marks::{Mark, Marks};
use crate::operand::Operands;
use crate::sheet::{Sheet, is_wire};
use crate::text::is_sign;
use crate::wires::Wires;
use ladder_format::program::Block;

/// What is next to a box.
#[derive(Debug, Default)]
pub(crate) struct Sides {
    /// The line on which power comes to it.
    pub(crate) power: Option<usize>,
    /// Other lines on which a wire comes to it.
    wired: Vec<usize>,
    /// Why it cannot be read, apart from what it says.
    problem: Option<String>,
    /// What is written left and right of it, line by line from its upper edge on.
    values: Vec<(Option<String>, Option<String>)>,
}

/// What other systems draw next to a box to show its bits.
const BITS: [&str; 9] = ["EN", "DN", "TT", "CU", "CD", "OV", "UN", "ER", "UA"];

/// Wire next to a box with a value at its end is no longer.
const LONGEST: usize = 40;

impl Sides {
    pub(crate) fn of(sheet: &Sheet, marks: &mut Marks, frame: &Frame) -> Sides {
        let mut sides = Sides::default();
        let mut leaves = Vec::new();
        for line in frame.top..=frame.bottom {
            let left = value_before(sheet, marks, line, frame.left);
            if left.is_none()
                && frame
                    .left
                    .checked_sub(1)
                    .is_some_and(|before| comes(sheet, line, before))
            {
                match sides.power {
                    None => sides.power = Some(line),
                    Some(_) => sides.wired.push(line),
                }
            }
            let right = value_after(sheet, marks, line, frame.right, sides.power == Some(line));
            if right.is_none() && comes(sheet, line, frame.right + 1) {
                leaves.push(line);
            }
            sides.values.push((left, right.filter(|value| !value.is_empty())));
        }
        if let Some(line) = sides.power
            && leaves.iter().any(|leaving| *leaving != line)
        {
            sides.problem = Some("the wire leaves the box on another line than it comes on".to_owned());
        }
        sides
    }

    /// Takes the wires that bring a pin nothing but the contact of one tag from the left rail: the tag is given to it then.
    pub(crate) fn take_contacts(
        &mut self,
        frame: &Frame,
        wires: &mut Wires,
        tag: impl Fn(usize) -> Option<String>,
    ) {
        if self.wired.is_empty() {
            return;
        }
        let left = wires.left();
        self.wired.retain(|&line| {
            let mut runs = wires.on(line).iter_mut();
            let run = runs.find(|run| run.to == frame.left && Some(run.from) == left);
            let contact = run.as_ref().and_then(|run| run.only_symbol());
            let (Some(run), Some(tag)) = (run, contact.and_then(&tag)) else {
                return true;
            };
            run.things.clear();
            self.values[line - frame.top].0 = Some(tag);
            false
        });
    }

    /// The block that a box is.
    pub(crate) fn written(
        &self,
        frame: &Frame,
        name: Option<&str>,
        operands: &mut Operands,
    ) -> Result<Block, String> {
        if let Some(problem) = &self.problem {
            return Err(problem.clone());
        }
        if !self.wired.is_empty() {
            return Err(
                "wires lead to more than one pin of the box: write a tag at all but the first".to_owned(),
            );
        }
        // A type above the box, where the box itself has none.
        let boxed = block::boxed(&frame.edge, &frame.inside);
        let (boxed, name) = match (boxed, name.and_then(block::row)) {
            (Err(_), Some(row)) => (block::boxed(row.mnemonic, &frame.inside)?, None),
            (boxed, _) => (boxed?, name),
        };
        let mut given = Vec::new();
        for (number, pins) in boxed.given.into_iter().enumerate() {
            let (left, right) = self.values.get(number + 1).cloned().unwrap_or_default();
            let last = pins.len().saturating_sub(1);
            for (at, mut pin) in pins.into_iter().enumerate() {
                let next_to = match (&left, &right) {
                    (Some(value), _) if at == 0 => Some(value),
                    (_, Some(value)) if at == last => Some(value),
                    _ => None,
                };
                if let Some(value) = next_to {
                    if !pin.value.is_empty() {
                        return Err(format!(
                            "`{value}` is next to the box where it has `{}` already",
                            pin.value
                        ));
                    }
                    pin.value.clone_from(value);
                }
                given.push(pin);
            }
        }
        block::written(boxed.row, name, given, operands)
    }
}

/// Whether a wire or contact reaches a box in a column next to it.
fn comes(sheet: &Sheet, line: usize, column: usize) -> bool {
    is_wire(sheet.at(line, column)) || matches!(sheet.at(line, column), ')' | ']' | '(' | '[')
}

fn is_value(sheet: &Sheet, line: usize, column: usize) -> bool {
    let c = sheet.at(line, column);
    c.is_alphanumeric() || "_#.:%/".contains(c) || is_sign(sheet, line, column)
}

/// The value at the left of a box, with its wire: `5s──┤PT`.
fn value_before(sheet: &Sheet, marks: &mut Marks, line: usize, left: usize) -> Option<String> {
    let wire = (0..left)
        .rev()
        .take_while(|&column| is_wire(sheet.at(line, column)))
        .count();
    let end = left - wire;
    let long = (0..end)
        .rev()
        .take(LONGEST)
        .take_while(|&column| is_value(sheet, line, column))
        .count();
    let from = end - long;
    let is_free = from
        .checked_sub(1)
        .is_none_or(|before| !is_wire(sheet.at(line, before)) && !"([])".contains(sheet.at(line, before)));
    if long == 0 || !is_free {
        return None;
    }
    marks.set(line, from..left, Mark::Read);
    Some(sheet.text(line, from, end))
}

/// The value at the right of a box; or one of its bits, `(DN)`, which is passed by.
fn value_after(
    sheet: &Sheet,
    marks: &mut Marks,
    line: usize,
    right: usize,
    is_power: bool,
) -> Option<String> {
    let wire = (right + 1..sheet.width(line))
        .take_while(|&column| is_wire(sheet.at(line, column)))
        .count();
    let from = right + 1 + wire;
    let bits = BITS
        .iter()
        .find(|bit| sheet.text(line, from, from + bit.len() + 2) == format!("({bit})"));
    if let Some(bit) = bits {
        let to = from + bit.len() + 2;
        marks.set(
            line,
            right + 1..to,
            if is_power { Mark::Wire } else { Mark::Read },
        );
        // The wire from there to the rail shows nothing either.
        if !is_power {
            let more = (to..sheet.width(line))
                .take_while(|&column| is_wire(sheet.at(line, column)))
                .count();
            marks.set(line, to..to + more, Mark::Read);
            return Some(String::new());
        }
        return None;
    }
    let long = (from..sheet.width(line))
        .take(LONGEST)
        .take_while(|&column| is_value(sheet, line, column))
        .count();
    if long == 0
        || wire == 0
        || is_wire(sheet.at(line, from + long))
        || "([".contains(sheet.at(line, from + long))
    {
        return None;
    }
    marks.set(line, right + 1..from + long, Mark::Read);
    Some(sheet.text(line, from, from + long))
}
