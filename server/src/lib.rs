//! The language server for ladder text: what `ladder lsp` runs.
//!
//! ```text
//! client's bytes -> lsp::transport -> tower-lsp -> lsp::backend -> lsp::features, a file for each
//!                                                                                |
//!                       document: open texts, revisions, positions <-------------+
//!                       language: asks the inner crates about a text <----------+
//!                       simulation: sessions, each on a thread of its own <------+
//!                                                                                |
//! client <- tower-lsp <- answers, and what lsp::documents says without being asked
//! ```
//!
//! - `document` holds the editor's texts in ropes. A change makes a new `Revision`, which never changes again:
//!   a thread that works on one is not disturbed, and whether it is still shown is asked at the end. A revision computes
//!   two layers, each once, when first asked: the names of its text, and what is found in it. Most features ask
//!   for names only, and wait for no rule.
//! - `language` is where the server asks about a text: findings, hovers, layout, in bytes.
//! - `diagram` draws programs for a page next to their text, `diagram_text` with characters.
//! - `simulation` runs programs for the editor, on the scan engine. It knows the custom messages, but nothing of
//!   the framework.
//! - `notation` translates programs of other systems for the editor, and reads those that are open; it knows the custom
//!   messages of that.
//! - `debug` is the debug adapter, `ladder dap`, over the same engine.
//! - `settling` gives memory back when the server has come to rest.
//! - `frames` splits what comes in into messages, for `lsp` and for `debug`.
//! - `standard_input` reads what the client sends, on a thread of its own.
//! - `recording` and `replay` keep what a client sent, and play it again.
//! - `lsp` speaks the protocol. It is the only folder that names `tower-lsp`, and its page has the rules that
//!   keep a server on it alive, in order and answering.
//!
//! The messages are described in `docs/protocol.md`, whose examples the tests play against this code.

#![deny(clippy::print_stdout)]

mod busy;
mod cancel;
mod cross_reference;
mod debug;
mod diagram;
mod diagram_text;
mod document;
#[doc(hidden)]
mod fence;
mod frames;
mod host;
mod language;
mod lsp;
mod native;
mod newest;
mod notation;
pub mod probe;
mod received;
mod recording;
mod replay;
mod rule_page;
mod serve;
mod settling;
mod signal;
mod simulation;
mod standard_input;
pub mod typing_messages;

use std::path::Path;
use std::process::ExitCode;

pub use cross_reference::{CrossReference, CrossReferenced, ReferencedPlace, ReferencedTag};
pub use diagram::{Diagram, Drawn, DrawnPiece, PieceKind};
pub use diagram_text::{DiagramText, DrawnBlock, DrawnLine, DrawnText, InkName};
pub use document::position::{Position, Range};
pub use fence::{DrawnFence, Fence, FencePicture, FenceWord};
pub use host::{Clock, EventLoop, Host, Moment, Turns, Wait, World};
pub use lsp::{Ended, Ending, Received};
pub use notation::messages as notation_messages;
pub use rule_page::{AskedPage, RulePage};
pub use serve::serve;
pub use simulation::messages;

/// Threads that read, write and dispatch messages. The work itself runs on blocking threads.
const WORKERS: usize = 2;

/// Serves one client over standard input and output, until it says `exit`, closes the input, or dies. What the client
/// sends is recorded in the file `mirror`, if one is named.
///
/// The exit status is 0 after `shutdown`, else 1, as the protocol asks; 2 if the server could not start.
pub fn run_stdio(mirror: Option<&Path>) -> ExitCode {
    let input = match standard_input::StandardInput::start() {
        Ok(input) => input,
        Err(error) => return cannot_start(&error),
    };
    let Some(mirror) = mirror else {
        return run(serve(input, tokio::io::stdout()));
    };
    match recording::Mirror::new(input, mirror) {
        Ok(input) => run(serve(input, tokio::io::stdout())),
        Err(error) => {
            eprintln!(
                "the session cannot be recorded in {}: {error}",
                ladder_workspace::shown::path(mirror)
            );
            ExitCode::from(2)
        }
    }
}

/// Serves one debugger over standard input and output, until it disconnects or closes the input.
///
/// The exit status is 0, or 2 if the adapter could not start.
pub fn run_debug_adapter() -> ExitCode {
    match debug::serve(tokio::io::stdin, std::io::stdout()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("the debug adapter cannot start: {error}");
            ExitCode::from(2)
        }
    }
}

/// Plays a recorded session, as fast as possible or so much faster than it was, and prints what the server says to
/// standard output, a message a line.
///
/// The exit status is 0, or 2 if there is no such recording.
pub fn run_replay(recorded: &Path, speed: Option<f64>) -> ExitCode {
    match recording::read(recorded) {
        Ok(pieces) => run(async move {
            replay::play(pieces, speed, std::io::stdout()).await;
            Ending::Clean
        }),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn cannot_start(error: &std::io::Error) -> ExitCode {
    eprintln!("the language server cannot start: {error}");
    ExitCode::from(2)
}

fn run(session: impl Future<Output = Ending>) -> ExitCode {
    let settling = settling::Settling::default();
    let ended = settling.clone();
    let runtime = match tokio::runtime::Builder::new_multi_thread()
        .worker_threads(WORKERS)
        .thread_keep_alive(settling::PATIENCE)
        .on_thread_stop(move || ended.thread_ended())
        .enable_all()
        .build()
    {
        Ok(runtime) => runtime,
        Err(error) => return cannot_start(&error),
    };
    runtime.spawn(settling.watch());
    let ending = runtime.block_on(session);
    // Work that is still under way is for nobody.
    runtime.shutdown_background();
    match ending {
        Ending::Clean => ExitCode::SUCCESS,
        Ending::Abrupt => ExitCode::FAILURE,
    }
}
