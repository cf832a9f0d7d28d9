//! What Click's editor can draw: how large a rung is, where the pins of a box begin, and what needs a contact.

use super::super::grid::COLUMNS;
use super::super::model::{Action, Bits, Condition, Instruction, Program, Rung};
use super::Found;
use super::words::Words;

/// A rung of Click has no more rows.
const ROWS: usize = 32;

pub(super) fn check(program: &Program, out: &mut Found) {
    for rung in program.routines().flat_map(|routine| &routine.rungs) {
        size(rung, out);
        for action in &rung.actions {
            inputs(rung, action, out);
            contact(rung, action, out);
        }
    }
}

/// Columns and rows that a part takes at least: what is drawn may need more.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Size {
    columns: usize,
    rows: usize,
}

impl Size {
    /// One after the other.
    fn next_to(self, other: Size) -> Size {
        Size {
            columns: self.columns + other.columns,
            rows: self.rows.max(other.rows),
        }
    }

    /// One below the other.
    fn above(self, other: Size) -> Size {
        Size {
            columns: self.columns.max(other.columns),
            rows: self.rows + other.rows,
        }
    }
}

fn size_of(condition: &Condition) -> Size {
    let row = Size { columns: 0, rows: 1 };
    match condition {
        Condition::All(parts) => parts.iter().map(size_of).fold(row, Size::next_to),
        Condition::Any(parts) if parts.is_empty() => row,
        Condition::Any(parts) => parts.iter().map(size_of).fold(Size::default(), Size::above),
        Condition::Contact(contact) => Size {
            columns: match &contact.bits {
                Bits::One(_) => 1,
                Bits::Many(span) => span.len(),
            },
            rows: 1,
        },
        Condition::Compare(_) => Size { columns: 1, rows: 1 },
    }
}

fn pins(what: &Instruction) -> impl Iterator<Item = &Condition> {
    let pins = match what {
        Instruction::Timer(timer) => [&timer.reset, &None, &None],
        Instruction::Counter(counter) => [&counter.count_down, &counter.reset, &None],
        Instruction::Shift(shift) => [&shift.clock, &shift.reset, &None],
        Instruction::Drum(drum) => [&drum.reset, &drum.jump, &drum.jog],
        _ => [&None, &None, &None],
    };
    pins.into_iter().flatten()
}

/// What fits on the sheet of one rung.
fn size(rung: &Rung, out: &mut Found) {
    let mut actions = Size::default();
    for action in &rung.actions {
        let own = pins(&action.what)
            .map(size_of)
            .fold(size_of(&action.condition), Size::above);
        actions = actions.above(own);
    }
    let Size { columns, rows } = size_of(&rung.condition).next_to(actions);
    let too_large = match (columns > COLUMNS, rows > ROWS) {
        (true, _) => format!("{columns} contacts in series, and Click draws {COLUMNS}"),
        (_, true) => format!("{rows} rows, and Click draws {ROWS}"),
        _ => return,
    };
    let message = format!("the rung is too complicated: it has {too_large}; make several rungs of it");
    out.warning(rung.place, "click-c0005", message);
}

/// A box with pins begins at the left rail, as they do.
fn inputs(rung: &Rung, action: &Action, out: &mut Found) {
    let is_branch = rung.actions.len() > 1 && !rung.condition.is_always() || !action.condition.is_always();
    if is_branch && pins(&action.what).next().is_some() {
        let message = "the inputs of this instruction come from different branches: its pins begin at the left rail, and \
                       its rung has other instructions; give it a rung of its own";
        match out.words {
            // The page has such rungs; to draw them takes more of them.
            Words::Dsl => out.info(action.place, "click-c000a", message),
            Words::Grid => out.warning(action.place, "click-c000a", message),
        }
    }
}

/// What begins at the left rail without a contact.
fn contact(rung: &Rung, action: &Action, out: &mut Found) {
    if !rung.condition.is_always() || !action.condition.is_always() {
        return;
    }
    let words = out.words;
    let says = format!(
        "Click itself wants a contact before this instruction: {} always conducts",
        words.always_on()
    );
    match (words, &action.what) {
        (
            _,
            Instruction::Call(_)
            | Instruction::For(_)
            | Instruction::Next
            | Instruction::End
            | Instruction::Return
            | Instruction::Nop
            | Instruction::Kept { .. },
        ) => {}
        (Words::Grid, _) => out.warning(action.place, "click-c0107", says),
        // `if True:` is a word of the DSL; what goes by the rise of its rung never sees one there.
        (
            Words::Dsl,
            Instruction::Timer(_) | Instruction::Counter(_) | Instruction::Shift(_) | Instruction::Drum(_),
        ) => {
            out.info(action.place, "click-c0107", says);
        }
        (Words::Dsl, _) => {}
    }
}
