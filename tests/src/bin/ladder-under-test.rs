//! The programs `ladder` and `ldfmt` for the tests of this package: cargo gives a test only the programs of its own
//! package. Which of the two it is says the name that it is called by.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let called = std::env::args_os().next().unwrap_or_default();
    if Path::new(&called).file_stem().is_some_and(|name| name == "ldfmt") {
        ladder_cli::ldfmt()
    } else {
        ladder_cli::ladder()
    }
}
