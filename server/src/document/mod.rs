//! The texts that editors hold open.
//!
//! [`position`] converts between bytes and the positions of the protocol, [`edit`] applies a change, [`store`]
//! keeps the open documents, each as a chain of [`Revision`]s. Nothing here knows the protocol's types.

pub(crate) mod edit;
pub(crate) mod position;
mod revision;
mod store;

pub(crate) use revision::Revision;
pub(crate) use store::{Documents, Refused};
