//! `ladder check --watch`: the same check again whenever something changes.

use super::{Arguments, Format, Round, check_files};
use crate::outcome::{Failure, Outcome};
use crate::seen::{Reads, Seen};
use crate::terminal;
use ladder_syntax::numeral::counted;

/// Checks, and checks again, until nobody reads any more. Ctrl-C ends the process as it ends any other.
pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut seen = Seen::now(&arguments.paths, Reads::Programs);
    loop {
        let for_people = matches!(arguments.format, Format::Full | Format::Concise);
        if for_people {
            terminal::clear();
        }
        let Round {
            outcome,
            nobody_reads,
            // Not for the time until a file changes.
            workspaces: _,
        } = check_files(arguments)?;
        if nobody_reads || seen.named == 0 {
            return Ok(outcome);
        }
        terminal::note(&format_args!(
            "watching {}; Ctrl-C ends this",
            counted(seen.named, "program")
        ));
        seen = seen.next(&arguments.paths, Reads::Programs);
    }
}
