//! The language server for ladder text, as a library: what a client asks and what it is answered.
//!
//! ```text
//! messages -> lsp::transport -> tower-lsp -> lsp::backend -> lsp::features, a file for each
//!                                                                       |
//!                  document: open texts, revisions, positions <---------+
//!                  language: asks the inner crates about a text <-------+
//!                  simulation: sessions, which go on by turns <---------+
//!                                                                       |
//! messages <- tower-lsp <- answers, and what lsp::documents says without being asked
//! ```
//!
//! It knows no runtime, no thread, no clock and no file: what it needs of where it runs it asks a [`Host`]. `ladder lsp` is one
//! with threads and the files of the operating system; [`EventLoop`] is one of a single thread, for a page.
//!
//! - `host` is what the server needs of where it runs.
//! - `document` holds the editor's texts in ropes. A change makes a new `Revision`, which never changes again:
//!   who works on one is not disturbed, and whether it is still shown is asked at the end. A revision computes
//!   two layers, each once, when first asked: the names of its text, and what is found in it. Most features ask
//!   for names only, and wait for no rule.
//! - `language` is where the server asks about a text: findings, hovers, layout, in bytes.
//! - `diagram_text` draws programs with characters.
//! - `simulation` runs programs for the editor, on the scan engine. It knows the custom messages, but nothing of
//!   the framework.
//! - `notation` translates programs of other systems for the editor, and reads those that are open; it knows the custom
//!   messages of that.
//! - `proof` has properties decided, if the prover is built in.
//! - [`debug`] is the debug adapter, over the same engine.
//! - `lsp` speaks the protocol. It is the only folder that names `tower-lsp`, and its page has the rules that
//!   keep a server on it alive, in order and answering.
//!
//! The messages are described in `docs/protocol.md`, whose examples the tests play against this code.

#![deny(clippy::print_stdout)]

mod busy;
mod cancel;
pub mod debug;
mod diagram_text;
mod document;
mod host;
mod language;
mod lines;
mod lsp;
mod newest;
mod notation;
pub mod probe;
mod proof;
mod scenario_run;
mod signal;
mod simulation;
pub mod typing_messages;

pub use busy::{Busy, Work};
pub use diagram_text::{DiagramText, DrawnBlock, DrawnLine, DrawnText, InkName};
pub use document::position::{Position, Range};
pub use host::{Clock, EventLoop, Host, Moment, Turns, Wait, World};
#[cfg(feature = "review")]
pub use lsp::features::compare::{Changed, Compare, CompareTheme, ComparedTexts};
pub use lsp::features::cross_reference::{CrossReference, CrossReferenced, ReferencedPlace, ReferencedTag};
pub use lsp::features::diagram::{Diagram, Drawn, DrawnPiece, PieceKind};
pub use lsp::features::fence::{DrawnFence, Fence, FencePicture, FenceWord};
pub use lsp::features::library_block::{AskedBlock, LibraryBlock};
pub use lsp::features::rule_page::{AskedPage, RulePage};
pub use lsp::{Ended, Ending, Received, serve};
pub use notation::messages as notation_messages;
pub use proof::{LeftOpen, PropertiesProved, PropertyProved, ProveProperties};
pub use scenario_run::{
    Exercised, FaultOfScenario, NetworkReached, PartSeen, PropertyViolated, RowDiffers, RunScenarios,
    ScenarioRun, ScenariosRun,
};
pub use simulation::messages;
