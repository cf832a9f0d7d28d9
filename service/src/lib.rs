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
//! - `compare` says what changed in a program since an earlier text; a page is built without it.
//! - `diagram` draws programs for a page next to their text, `diagram_text` with characters.
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
#[cfg(feature = "review")]
mod compare;
mod cross_reference;
pub mod debug;
mod diagram;
mod diagram_text;
mod document;
#[doc(hidden)]
mod fence;
mod host;
mod language;
mod library_block;
mod lines;
mod lsp;
mod newest;
mod notation;
pub mod probe;
mod proof;
mod rule_page;
mod scenario_run;
mod signal;
mod simulation;
pub mod typing_messages;

pub use busy::{Busy, Work};
#[cfg(feature = "review")]
pub use compare::{Changed, Compare, CompareTheme, ComparedTexts};
pub use cross_reference::{CrossReference, CrossReferenced, ReferencedPlace, ReferencedTag};
pub use diagram::{Diagram, Drawn, DrawnPiece, PieceKind};
pub use diagram_text::{DiagramText, DrawnBlock, DrawnLine, DrawnText, InkName};
pub use document::position::{Position, Range};
pub use fence::{DrawnFence, Fence, FencePicture, FenceWord};
pub use host::{Clock, EventLoop, Host, Moment, Turns, Wait, World};
pub use library_block::{AskedBlock, LibraryBlock};
pub use lsp::{Ended, Ending, Received, serve};
pub use notation::messages as notation_messages;
pub use proof::{LeftOpen, PropertiesProved, PropertyProved, ProveProperties};
pub use rule_page::{AskedPage, RulePage};
pub use scenario_run::{
    Exercised, FaultOfScenario, NetworkReached, PartSeen, PropertyViolated, RowDiffers, RunScenarios,
    ScenarioRun, ScenariosRun,
};
pub use simulation::messages;
