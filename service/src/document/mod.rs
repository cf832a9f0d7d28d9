//! The texts that editors hold open.
//!
//! [`position`] converts between bytes and the positions of the protocol, [`edit`] applies a change, [`store`]
//! keeps the open documents, each as a chain of [`Revision`]s, [`neighbours`] the files next to them. A [`Kind`] tells programs
//! from other texts. Nothing here knows the protocol's types.

pub(crate) mod address;
mod byte_edit;
pub(crate) mod edit;
mod folder;
pub(crate) mod in_parallel;
mod kind;
mod library_source;
pub(crate) mod membership;
pub(crate) mod neighbours;
pub(crate) mod on_disk;
pub(crate) mod other_files;
mod other_places;
pub(crate) mod position;
pub(crate) mod positions;
mod revision;
mod seen;
mod store;
pub(crate) mod sweep;

pub(crate) use kind::Kind;
pub(crate) use other_places::OtherPlaces;
pub(crate) use revision::Revision;
pub(crate) use seen::SettingsFile;
pub(crate) use store::{ChangeRefused, Documents};
