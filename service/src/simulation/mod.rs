//! Simulations that an editor starts, steps and watches.
//!
//! [`request`] reads a command, [`messages`] are its arguments and answers, [`sessions`] knows who runs, and each
//! [`session`] goes on by turns, in which its [`runner`] drives an [`engine`]: a long run stops nobody, and a command is seen
//! between two scans. The folder knows nothing of the protocol's framework: states go out through a channel that keeps
//! only the newest.

mod action;
mod debugger;
mod debugging;
mod diagram_text;
mod drawing;
mod engine;
mod follow;
mod inquiry;
mod labels;
mod line_map;
pub mod messages;
mod picture;
mod pulse;
mod queue;
mod reasons;
mod request;
mod retention;
mod runner;
mod running_program;
mod session;
mod sessions;
mod status_text;
mod trace;
pub(crate) mod value;
mod view;

pub(crate) use action::{Action, Answer, Given, Pace};
pub(crate) use debugger::{Beginning, Debugger, Ground, Halt, ProgramFile};
pub(crate) use request::{COMMANDS, Failure, Request, argument_of};
pub(crate) use retention::Keeping;
pub(crate) use runner::REPORT;
pub(crate) use session::{Begun, Session};
pub(crate) use sessions::Sessions;
pub(crate) use status_text::status_text;
