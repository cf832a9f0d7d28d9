//! What must hold for any input, however hostile: one function for each door by which input comes in.
//!
//! ```text
//! bytes --input--> texts and edits --TARGETS--> nothing, or a panic that says what does not hold
//!
//! fuzz/fuzz_targets/*.rs   makes up bytes, and looks for a panic    (nightly, as long as one likes)
//! tests/corpora.rs         takes the bytes that are kept in fuzz/    (always)
//! ```
//!
//! Next to the targets are what they and other tests need: programs out of nothing ([`generator`]), what a program
//! does ([`trace`]), the language's definition of a network written down a second time ([`mod@reference`]), and all that an
//! editor asks ([`features`]).

mod check;
mod editor;
mod edits;
pub mod features;
mod format;
mod input;
mod messages;
mod model;
mod notations;
mod parse;
mod scenarios;
mod settings;
mod simulation;
pub mod trace;

pub use ladder_generator::{generator, reference, running, runs};

/// A door by which input comes in.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Its name: that of the folders with its inputs, and of the fuzzer's program.
    pub name: &'static str,
    /// Panics if something does not hold.
    pub check: fn(&[u8]),
}

/// All of them.
pub const TARGETS: [Target; 10] = [
    Target {
        name: "parse",
        check: parse::check,
    },
    Target {
        name: "format",
        check: format::check,
    },
    Target {
        name: "check",
        check: check::check,
    },
    Target {
        name: "editor",
        check: editor::check,
    },
    Target {
        name: "edits",
        check: edits::check,
    },
    Target {
        name: "messages",
        check: messages::check,
    },
    Target {
        name: "notations",
        check: notations::check,
    },
    Target {
        name: "scenarios",
        check: scenarios::check,
    },
    Target {
        name: "settings",
        check: settings::check,
    },
    Target {
        name: "simulation",
        check: simulation::check,
    },
];

/// Checks the input of a target.
///
/// # Panics
/// Something does not hold, or there is no such target.
pub fn check(target: &str, data: &[u8]) {
    let target = TARGETS.iter().find(|known| known.name == target);
    (target.expect("a target of this name").check)(data);
}
