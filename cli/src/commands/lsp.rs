//! `ladder lsp`: the language server.

#[cfg(not(feature = "server"))]
use crate::features::Feature;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  ladder lsp                                    what an editor starts
  ladder lsp --mirror session.rec               the same, recorded
  ladder lsp --replay session.rec > said.jsonl  what the server said, to compare

Exit status: 0 the editor said goodbye before it left, 1 it did not, 2 the arguments or a file cannot be used.";

/// Run the language server over stdin and stdout
///
/// Editors start this; it speaks the Language Server Protocol.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Record what the editor sends in this file, with its times: the best report of an error in the server
    #[arg(long, value_name = "FILE", conflicts_with = "replay")]
    mirror: Option<PathBuf>,

    /// Play a recorded session again, and print what the server says, a message a line
    ///
    /// Each message waits until all before it are done, so that the output can be compared with another's. Files that
    /// the session reads from disk must be as they were.
    #[arg(long, value_name = "FILE")]
    replay: Option<PathBuf>,

    /// Keep the recording's clock, so much faster than it was: 1 is as it was
    #[arg(long, value_name = "FACTOR", requires = "replay", value_parser = factor)]
    speed: Option<f64>,

    /// Accepted, since many editors give it; stdin and stdout are what the server speaks over anyway
    #[arg(long = "stdio", hide = true)]
    _stdio: bool,
}

#[cfg(feature = "server")]
pub(crate) fn run(arguments: &Arguments) -> ExitCode {
    crate::small_pages::use_small_pages();
    match &arguments.replay {
        Some(recorded) => ladder_server::run_replay(recorded, arguments.speed),
        None => ladder_server::run_stdio(arguments.mirror.as_deref()),
    }
}

#[cfg(not(feature = "server"))]
pub(crate) fn run(_: &Arguments) -> ExitCode {
    crate::outcome::exit(Err(Feature::Server.left_out()))
}

fn factor(text: &str) -> Result<f64, String> {
    let factor: f64 = text.parse().map_err(|_| "write a number, such as 1 or 0.5")?;
    if (0.001..=1000.0).contains(&factor) {
        Ok(factor)
    } else {
        Err("from 0.001 to 1000".into())
    }
}
