//! The language server for ladder text: what `ladder lsp` runs.
//!
//! ```text
//! client's bytes -> lsp::inlet -> tower-lsp -> lsp::guard -> lsp::backend -> one file for each feature
//!                                                                                |
//!                       document: open texts, revisions, positions <-------------+
//!                       language: asks the inner crates about a text <----------+
//!                       simulation: sessions, each on a thread of its own <------+
//!                                                                                |
//! client <- tower-lsp <- answers, and lsp::outbox: what is said without being asked
//! ```
//!
//! - `document` holds the editor's texts in ropes. A change makes a new `Revision`, which never changes again:
//!   whoever works on one works in peace, and whether it is still shown is asked at the end. A revision computes
//!   its contiguous text and its analysis once, when first asked.
//! - `language` is where the server asks about a text: findings, hovers, layout, in bytes.
//! - `simulation` runs programs for the editor, on the scan engine. It knows the custom messages, but nothing of
//!   the framework.
//! - `lsp` speaks the protocol. It is the only folder that names `tower-lsp`, and its page has the rules that
//!   keep a server on it alive, in order and answering.
//!
//! The messages are described in `docs/protocol.md`, whose examples the tests play against this code.

#![deny(clippy::print_stdout)]

mod cancel;
mod document;
mod language;
mod lsp;
mod simulation;

use std::process::ExitCode;

pub use document::position::{Position, Range};
pub use lsp::{Ending, serve};
pub use simulation::messages;

/// Threads that read, write and dispatch messages. The work itself runs on blocking threads.
const WORKERS: usize = 2;

/// Serves one client over standard input and output, until it says `exit`, closes the input, or dies.
///
/// The exit status is 0 after `shutdown`, else 1, as the protocol asks; 2 if the server could not start.
pub fn run_stdio() -> ExitCode {
    let runtime = match tokio::runtime::Builder::new_multi_thread()
        .worker_threads(WORKERS)
        .enable_all()
        .build()
    {
        Ok(runtime) => runtime,
        Err(error) => {
            eprintln!("the language server cannot start: {error}");
            return ExitCode::from(2);
        }
    };
    let ending = runtime.block_on(serve(tokio::io::stdin(), tokio::io::stdout()));
    // A read of standard input cannot be interrupted: waiting for that thread would wait for the client.
    runtime.shutdown_background();
    match ending {
        Ending::Clean => ExitCode::SUCCESS,
        Ending::Abrupt => ExitCode::FAILURE,
    }
}
