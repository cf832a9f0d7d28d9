//! How messages come in and go out, and which thread does the work. Nothing here knows ladder programs. Each file keeps a
//! promise that the framework does not:
//!
//! - [`received`]: whatever comes, the session goes on; what is not a message is answered with what is
//!   wrong with it, and the next message is found. No message is longer than a limit.
//! - [`surrogates`]: texts with half a character in them, which editors can hold, are read.
//! - [`misread`]: a notification that makes no sense is logged.
//! - [`guard`]: each request gets exactly one answer, also after a panic; what comes after `initialize` waits for it.
//! - [`answered`]: what is to come after an answer does come after it; an answer of megabytes is made into text once.
//! - [`blocking`]: long work keeps no message waiting, ends when it is cancelled, and answers when it panics.

pub(crate) mod answered;
pub(crate) mod blocking;
pub(crate) mod guard;
mod misread;
pub(crate) mod received;
mod surrogates;
