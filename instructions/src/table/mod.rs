//! The table: all rows, in the order of LANGUAGE §5, one file a section.

mod arithmetic;
mod bistables;
mod bits;
mod coils;
mod comparisons;
mod contacts;
mod counters;
mod curves;
mod flow;
mod mathematics;
mod moves;
mod ports;
mod ranges;
mod selection;
mod strings;
mod timers;

use crate::instruction::Instruction;
use crate::op::Op;

/// Every instruction, in the order of LANGUAGE §5, which is the order of [`Op`].
pub static TABLE: &[Instruction] = &ROWS;

/// The sections, in the order of [`Op`].
const SECTIONS: &[&[Instruction]] = &[
    contacts::ROWS,
    comparisons::ROWS,
    moves::ROWS,
    arithmetic::ROWS,
    bits::ROWS,
    mathematics::ROWS,
    selection::ROWS,
    strings::ROWS,
    ranges::ROWS,
    curves::ROWS,
    timers::ROWS,
    counters::ROWS,
    bistables::ROWS,
    coils::ROWS,
    flow::ROWS,
    ports::ROWS,
];

static ROWS: [Instruction; Op::COUNT] = join();

/// Joins the sections. Does not compile when an [`Op`] has no row, two rows, or its row in another place:
/// [`by_op`](crate::by_op) indexes by the variant.
#[allow(clippy::large_stack_arrays, reason = "it runs in the compiler only")]
const fn join() -> [Instruction; Op::COUNT] {
    let mut rows = [SECTIONS[0][0]; Op::COUNT];
    let mut next = 0;
    let mut section = 0;
    while section < SECTIONS.len() {
        let mut row = 0;
        while row < SECTIONS[section].len() {
            assert!(
                SECTIONS[section][row].op as usize == next,
                "the rows are in the order of `Op`"
            );
            rows[next] = SECTIONS[section][row];
            next += 1;
            row += 1;
        }
        section += 1;
    }
    assert!(next == Op::COUNT, "every `Op` has its row");
    rows
}
