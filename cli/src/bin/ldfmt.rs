//! The program `ldfmt`: the formatter alone, for editors and hooks that start it often.

use std::process::ExitCode;

fn main() -> ExitCode {
    ladder_cli::ldfmt()
}
