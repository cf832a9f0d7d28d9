//! The protocol, on `tower-lsp`: the only folder that names it.
//!
//! The framework runs handlers concurrently on one task and reads messages through a bounded queue. Five rules
//! follow, and each has a test:
//!
//! 1. A notification that changes state does so in its first statement, with no `await` before it
//!    ([`sync`]): handlers are polled in the order of their messages up to their first `await`.
//! 2. No handler awaits the client. What goes out unasked is put into the [`outbox`]; requests to the client are
//!    spawned with a time limit. A few handlers that wait for answers behind a full queue would lock the server
//!    for ever.
//! 3. Work over a millisecond runs on a [`blocking`] thread, with a flag that is set when the handler is
//!    dropped, so that a cancelled request stops working.
//! 4. Every request gets exactly one answer, also after a panic ([`guard`]), also when its message cannot be
//!    decoded ([`inlet`]). Positions are clamped, unknown documents answer `null`.
//! 5. Published diagnostics name the version they belong to, and those of a text that is no longer shown are not
//!    sent.

mod asked;
mod backend;
mod blocking;
mod call_hierarchy;
mod capabilities;
mod code_action;
mod code_lens;
mod companions;
mod completion;
mod configuration;
mod convert;
mod decodable;
mod diagnostics;
mod file_operations;
mod folders;
mod folding;
mod formatting;
mod frames;
mod goto;
mod guard;
mod hover;
mod inlay_hint;
pub(crate) mod inlet;
mod links;
mod markup;
mod outbox;
mod parent;
mod progress;
mod pull;
mod references;
mod rename;
mod semantic_tokens;
mod serve;
mod settings_file;
mod shared;
mod shown;
mod signature;
mod simulate;
mod symbols;
mod sync;
mod watch;

pub(crate) use serve::serve_counting;
pub use serve::{Ending, serve};
