//! `ladder dap`: the debug adapter.

#[cfg(not(feature = "server"))]
use crate::features::Feature;
use clap::Args;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  ladder dap          what an editor starts when a program is debugged

An editor launches a program with a configuration such as

  {\"type\": \"ladder\", \"request\": \"launch\", \"program\": \"/plant/motor.clad\",
   \"stopOnEntry\": true, \"inputs\": {\"start\": true}, \"speed\": 1}

Exit status: 0 the session is over, 2 the adapter cannot start.";

/// Run the debug adapter over stdin and stdout
///
/// Editors start this to debug a program; it speaks the Debug Adapter Protocol. It loads a program as `ladder sim`
/// does, and writes nothing but the file of retentive tags that the program's workspace or the configuration names.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {}

#[cfg(feature = "server")]
pub(crate) fn run(_: &Arguments) -> ExitCode {
    crate::small_pages::use_small_pages();
    ladder_server::run_debug_adapter()
}

#[cfg(not(feature = "server"))]
pub(crate) fn run(_: &Arguments) -> ExitCode {
    crate::outcome::exit(Err(Feature::Server.left_out()))
}
