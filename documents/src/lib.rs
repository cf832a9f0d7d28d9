//! The texts that editors hold open.
//!
//! A change makes a new [`Revision`], which never changes again: who works on one is not disturbed, and whether it is still shown
//! is asked at the end. A revision computes two layers, each once, when first asked: the names of its text, and what is found in
//! it. Most features ask for names only, and wait for no rule.
//!
//! [`position`] converts between bytes and the positions of the protocol, [`edit`] applies a change, [`Documents`] are the open
//! texts, each as a chain of revisions, [`neighbours`] the files next to them. A [`Kind`] tells programs from other texts; an
//! [`Opened`] is a program of another system. Nothing here knows the protocol's types.

mod byte_edit;
pub mod edit;
mod folder;
pub mod in_parallel;
mod kind;
mod language;
mod library_source;
mod lines;
pub mod membership;
pub mod neighbours;
pub mod on_disk;
mod opened;
pub mod other_files;
mod other_places;
pub mod position;
pub mod positions;
mod revision;
mod seen;
mod store;
pub mod sweep;
#[cfg(test)]
mod testing;

pub use kind::Kind;
pub use ladder_workspace::address;
pub use language::Analysis;
pub use lines::Lines;
pub use opened::Opened;
pub use other_places::OtherPlaces;
pub use position::{Position, Range};
pub use revision::Revision;
pub use seen::SettingsFile;
pub use store::{ChangeRefused, Documents};
