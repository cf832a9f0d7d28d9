//! What can go wrong while a program runs (LANGUAGE §5.2, §5.5), in words for the person at the machine.

use crate::work::{CALL_DEPTH, ELEMENTS};
use ladder_analysis::program::Location;

/// A fault that was recorded.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// What is wrong and what to do.
    pub message: String,
    /// The block it happened in.
    pub location: Location,
    /// The scan it happened in, from 0.
    pub scan: u64,
    /// The simulation stopped: the watchdog, calls nested too deep, or by hand within a scan.
    pub stops: bool,
}

/// What went wrong, small enough to be kept without allocating.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Trouble {
    DivisionByZero,
    /// The same, where it ends the program after this scan.
    DivisionEnds,
    NegativeExponent(i64),
    NegativeShift(i64),
    /// A function outside its domain.
    Domain(f64),
    NotFinite,
    Index {
        index: i64,
        first: i64,
        last: i64,
    },
    Selector {
        value: i64,
        count: i64,
    },
    /// A number that the result's type cannot hold.
    OutOfRange,
    /// A text that is not a number, time or BOOL.
    Unparsable,
    /// Positions of a string function.
    Position {
        position: i64,
        length: i64,
    },
    /// Ranges of different lengths.
    Lengths {
        to: i64,
        from: i64,
    },
    /// A range that ends before it begins.
    EmptyRange {
        from: i64,
        to: i64,
    },
    Watchdog(u64),
    /// What counts are elements of arrays and characters of texts.
    Elements(u64),
    CallDepth,
    /// The caller wanted this scan to stop.
    Cancelled,
    /// The caller allows no more blocks.
    Exhausted(u64),
}

impl Trouble {
    /// The simulation does not go on after it.
    pub(crate) const fn stops(self) -> bool {
        matches!(
            self,
            Trouble::Watchdog(_)
                | Trouble::Elements(_)
                | Trouble::CallDepth
                | Trouble::Cancelled
                | Trouble::Exhausted(_)
        )
    }

    /// The block did what it does all the same.
    pub(crate) const fn is_remark(self) -> bool {
        matches!(self, Trouble::DivisionEnds)
    }

    pub(crate) fn message(self) -> String {
        match self {
            Trouble::DivisionByZero => {
                "division by zero: nothing was written; check the divisor before this block".into()
            }
            Trouble::DivisionEnds => {
                "Division by zero; halting simulation: 0 was written, and this scan is the last one; check the divisor \
                 before this block"
                    .into()
            }
            Trouble::NegativeExponent(exponent) => format!(
                "an integer cannot be raised to the negative power {exponent}: nothing was written; use a REAL or \
                 LREAL result"
            ),
            Trouble::NegativeShift(places) => format!(
                "cannot shift by {places} places: nothing was written; shift the other way with 0 or more places"
            ),
            Trouble::Domain(value) => format!(
                "the function has no result for {value:?}: nothing was written; limit the value before this block"
            ),
            Trouble::NotFinite => {
                "the result is too large for a real number: nothing was written; check the operands".into()
            }
            Trouble::Index { index, first, last } => format!(
                "index {index} is outside the array [{first}..{last}]: nothing was written; limit the index \
                 before this block"
            ),
            Trouble::Selector { value, count } => format!(
                "{value} selects none of the {count} values, which count from 0 to {}: nothing was written",
                count - 1
            ),
            Trouble::OutOfRange => {
                "the value does not fit into the type of the result: nothing was written; limit it before this \
                 block or use a wider type"
                    .into()
            }
            Trouble::Unparsable => {
                "the text cannot be read as a value of the result's type: nothing was written".into()
            }
            Trouble::Position { position, length } => format!(
                "{position} does not fit a text of {length} characters: nothing was written; check the length \
                 and positions before this block"
            ),
            Trouble::Lengths { to, from } => format!(
                "the ranges have different lengths, {to} and {from}: nothing was written; make them equal"
            ),
            Trouble::EmptyRange { from, to } => format!(
                "the range from {from} to {to} ends before it begins: nothing was written; check its ends before \
                 this block"
            ),
            Trouble::Watchdog(limit) => format!(
                "this scan has evaluated more than {limit} blocks, so the watchdog stopped the simulation here; \
                 look for a jump or loop that does not end"
            ),
            Trouble::Elements(limit) => format!(
                "this scan has done more than {limit} blocks do, so the watchdog stopped the simulation here: \
                 {ELEMENTS} elements or characters count as a block; go through fewer of them in one scan"
            ),
            Trouble::Cancelled => "the scan took long and was stopped by hand here, before its end".into(),
            Trouble::Exhausted(limit) => format!(
                "all scans together have done the work of more than {limit} blocks; run fewer scans, or make the \
                 program do less in each"
            ),
            Trouble::CallDepth => format!(
                "calls are nested deeper than {CALL_DEPTH}, so the simulation was stopped; look for a function that calls \
                 itself without end"
            ),
        }
    }
}
