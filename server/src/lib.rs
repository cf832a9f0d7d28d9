//! What `ladder lsp` and `ladder dap` run: the language server of [`ladder_service`] and the debug adapter of [`ladder_debugger`], with files, a clock,
//! threads, and standard input and output.
//!
//! ```text
//! client's bytes -> standard_input -> frames -> received -> ladder_service
//! client <- serve: headers <-------------------------------------+
//! ```
//!
//! - `native` is the host: a runtime, threads, the disk.
//! - `frames` splits what comes in into messages, for `serve` and for `debug`.
//! - `standard_input` reads what the client sends, on a thread of its own.
//! - `recording` and `replay` keep what a client sent, and play it again.
//! - `debug` is the debug adapter over standard input and output.
//! - `settling` gives memory back when the server has come to rest.

#![deny(clippy::print_stdout)]

mod debug;
mod frames;
mod native;
mod received;
mod recording;
mod replay;
mod serve;
mod settling;
mod standard_input;

use std::path::Path;
use std::process::ExitCode;

pub use ladder_service::Ending;
pub use serve::serve;

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
