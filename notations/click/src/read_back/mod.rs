//! From an analysed ladder program to a program of Click.
//!
//! What the importer made is folded again: rungs and tags that it declares as helpers, blocks that bring numbers up to
//! date, texts that go into several addresses. Networks that Click cannot say stay as comments.

mod act;
mod compute;
mod condition;
mod copies;
mod drum;
mod meaning;
mod network;
mod pins;
mod text;
mod value;

use super::address::Tag;
use super::model::{self, Condition, Instruction};
use ladder_analysis::Analysis;
use ladder_analysis::program::{Location, Program, TagId};
use ladder_notation::{LineColumn, Lines, Report, WriteError};
use ladder_syntax::TextRange;
use meaning::Meaning;
use std::collections::HashMap;

/// What is worked with while networks become rungs.
struct Back<'p> {
    program: &'p Program,
    text: &'p str,
    lines: Lines,
    meanings: Vec<Meaning>,
    report: Report,
    in_subroutine: bool,
    /// So many loops are open.
    loops: usize,
    computed: Computed,
}

/// What the importer's own rungs compute.
#[derive(Default)]
struct Computed {
    /// Pins.
    conditions: HashMap<TagId, Condition>,
    /// Pointers with something added.
    pointers: HashMap<TagId, (Tag, i32)>,
    /// The data tags of the shift registers in the last rung; one without a clock has none.
    registers: Vec<Option<TagId>>,
}

/// Whether a rung is one of the importer's own.
enum Above {
    No,
    /// It is, and what it computes has been kept.
    Yes,
    /// It shifts the register with this data tag.
    Clock(TagId),
}

/// The program, with what of it Click cannot say.
///
/// # Errors
///
/// If it has errors.
pub(super) fn program(analysis: &Analysis) -> Result<(model::Program, Report), WriteError> {
    let text = analysis.context.parse.to_string();
    let program = text::program(analysis, &text)?;
    let lines = Lines::of(&text);
    let mut report = Report::default();
    let comments = text::declared(&program, &text);
    let place = |tag: &ladder_analysis::program::Tag| lines.place(&text, tag.location.range.start().into());
    let (meanings, nicknames) = meaning::meanings(&program, &comments, place, &mut report);
    let mut back = Back {
        program: &program,
        text: &text,
        lines: Lines::of(&text),
        meanings,
        report,
        in_subroutine: false,
        loops: 0,
        computed: Computed::default(),
    };
    let mut out = back.routines();
    out.nicknames = nicknames;
    meaning::without_own_copies(&mut out);
    out.seen_first = back.computed.conditions.values().cloned().collect();
    Ok((out, back.report))
}

impl Back<'_> {
    /// As a part of the program is written.
    fn written(&self, range: TextRange) -> &str {
        self.text
            .get(usize::from(range.start())..usize::from(range.end()))
            .unwrap_or("")
    }

    fn place_of(&self, location: Location) -> LineColumn {
        self.place_of_range(location.range)
    }

    fn place_of_range(&self, range: TextRange) -> LineColumn {
        self.lines.place(self.text, range.start().into())
    }
}

/// Sets the clock or the reset of the last rung's shift register.
fn pin_of_register(rungs: &mut [model::Rung], pin: impl FnOnce(&mut model::Shift)) -> bool {
    let Some(rung) = rungs.last_mut() else {
        return false;
    };
    let registers = rung
        .actions
        .iter_mut()
        .filter_map(|action| match &mut action.what {
            Instruction::Shift(shift) => Some(shift),
            _ => None,
        });
    match registers.last() {
        Some(shift) => {
            pin(shift);
            true
        }
        None => false,
    }
}
