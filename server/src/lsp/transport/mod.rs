//! How messages come in and go out, and who does the work: nothing here knows ladder programs.
//!
//! ```text
//! bytes -> frames -> decodable -> inlet -> the framework -> guard -> backend
//! bytes <- the framework <- answers, and outbox
//! ```

pub(crate) mod blocking;
pub(crate) mod decodable;
pub(crate) mod frames;
pub(crate) mod guard;
pub(crate) mod inlet;
pub(crate) mod long_texts;
pub(crate) mod outbox;
pub(crate) mod parent;
pub(crate) mod prepared;
pub(crate) mod progress;
pub(crate) mod serve;
