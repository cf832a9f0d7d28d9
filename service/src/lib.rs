//! The language server for ladder text, as a library: what a client asks and what it is answered.
//!
//! ```text
//! messages -> lsp::transport -> tower-lsp -> lsp::backend -> lsp::features, a file for each
//!                                                                       |
//!            ladder_documents: open texts, revisions, positions <-------+
//!            ladder_live: simulations, which go on by turns <-----------+
//!            ladder_debugger: the debugger of a simulation <------------+
//!                                                                       |
//! messages <- tower-lsp <- answers, and what lsp::documents says without being asked
//! ```
//!
//! It knows no runtime, no thread, no clock and no file: what it needs of where it runs it asks a [`Host`](ladder_host::Host).
//!
//! - `notation` translates programs of other systems for the editor; it knows the custom messages of that.
//! - `scenario_run` runs the scenarios of a file.
//! - `proof` has properties decided, if the prover is built in.
//! - `lsp` speaks the protocol. It is the only folder that names `tower-lsp`, and its page has the rules that
//!   keep a server on it alive, in order and answering.
//!
//! The messages are described in `docs/protocol.md`, whose examples the tests play against this code.

#![deny(clippy::print_stdout)]

pub mod drawing_messages;
mod lsp;
mod notation;
mod proof;
mod scenario_run;
mod signal;
pub mod typing_messages;

#[cfg(feature = "review")]
pub use lsp::features::compare::{Changed, Compare, CompareTheme, ComparedTexts};
pub use lsp::features::cross_reference::{CrossReference, CrossReferenced, ReferencedPlace, ReferencedTag};
pub use lsp::features::diagram::{Diagram, Drawn, DrawnPiece, PieceKind};
pub use lsp::features::fence::{DrawnFence, Fence, FencePicture, FenceWord};
pub use lsp::features::library_block::{AskedBlock, LibraryBlock};
pub use lsp::features::palette::{Drawable, DrawableRow, Palette};
pub use lsp::features::rule_page::{AskedPage, RulePage};
pub use lsp::{Ended, Ending, Received, serve};
pub use notation::messages as notation_messages;
pub use proof::{LeftOpen, PropertiesProved, PropertyProved, ProveProperties};
pub use scenario_run::{
    Exercised, FaultOfScenario, NetworkReached, PartSeen, PropertyViolated, RowDiffers, RunScenarios,
    ScenarioRun, ScenariosRun,
};
