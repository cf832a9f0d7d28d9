//! `ladder lsp`: the language server.

use clap::Args;
use std::process::ExitCode;

/// Run the language server over stdin and stdout
///
/// Editors start this; it speaks the Language Server Protocol. The exit status is 0 if the editor said goodbye
/// before it left, else 1.
#[derive(Debug, Args)]
pub(crate) struct Arguments {
    /// Accepted, since many editors give it; stdin and stdout are what the server speaks over anyway
    #[arg(long = "stdio", hide = true)]
    _stdio: bool,
}

pub(crate) fn run() -> ExitCode {
    ladder_server::run_stdio()
}
