//! Simulations that an editor starts, steps and watches.
//!
//! `request` reads a command, [`messages`] are its arguments and answers, `sessions` knows who runs, and each
//! `session` goes on by turns, in which its `runner` drives an `engine`: a long run stops nobody, and a command is seen
//! between two scans. The crate knows nothing of the protocol's framework: states go out through a channel that keeps
//! only the newest. [`diagram_text`] draws a program with characters, at rest or as it runs. What a debugger is to a simulation is
//! the trait [`Debugger`].

mod action;
mod debugger;
mod debugging;
pub mod diagram_text;
mod drawing;
mod engine;
mod follow;
mod inquiry;
mod labels;
mod line_map;
pub mod messages;
mod online;
mod picture;
mod pulse;
mod queue;
mod reasons;
mod request;
mod retention;
mod runner;
mod running_program;
mod scenes;
mod serving;
mod session;
mod sessions;
mod status_text;
mod trace;
pub mod value;
mod view;

pub use action::{Action, Answer, Given, Pace};
pub use debugger::{Beginning, Debugger, Ground, Halt, ProgramFile};
pub use request::{COMMANDS, Failure, Request, argument_of};
pub use retention::Keeping;
pub use runner::REPORT;
pub use session::{Begun, Session};
pub use sessions::Sessions;
pub use status_text::status_text;
