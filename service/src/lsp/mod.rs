//! The protocol, on `tower-lsp`: the only folder that names it.
//!
//! The framework runs handlers concurrently on one task and reads messages through a bounded queue. Five rules
//! follow, and each has a test:
//!
//! 1. A notification that changes state does so in its first statement, with no `await` before it
//!    ([`sync`](documents::sync)): handlers are polled in the order of their messages up to their first `await`.
//! 2. No handler awaits the client. What goes out unasked is put into the [`outbox`](session::outbox); requests to
//!    the client are spawned with a time limit. A few handlers that wait for answers after a full queue would lock
//!    the server for ever.
//! 3. Work over a millisecond runs on a [`blocking`](transport::blocking) thread, with a flag that is set when the
//!    handler is dropped, so that a cancelled request stops working.
//! 4. Every request gets exactly one answer, also after a panic ([`guard`](transport::guard)), also when its message
//!    cannot be decoded (`received`). Positions are clamped, unknown documents answer `null`.
//! 5. Published diagnostics name the version they belong to, and those of a text that is no longer shown are not
//!    sent.
//!
//! [`transport`] moves messages, [`session`] has what all of a session knows, [`documents`] does what follows from a text that is opened, changed or closed,
//! [`features`] answers what an editor asks, a file for each request.

mod answers;
mod backend;
mod capabilities;
mod convert;
mod documents;
pub(crate) mod features;
mod finding;
mod markup;
mod serve;
mod session;
pub(crate) mod transport;

pub use serve::{Ended, Ending, serve};
pub use transport::received::Received;
