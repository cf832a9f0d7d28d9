//! What all of a session knows: what was agreed with the client, its documents, what it was sent, and the way to send it
//! more. `documents`, `features` and `transport` use it; it uses none of them.

pub(crate) mod agreed;
pub(crate) mod commands;
pub(crate) mod outbox;
pub(crate) mod previews;
pub(crate) mod proofs;
pub(crate) mod shared;
pub(crate) mod tokens_sent;
pub(crate) mod typing;
mod workspace_edit;
