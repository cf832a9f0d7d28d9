//! Where a server runs: its files, its clock, and a place where its work is done.
//!
//! The language server, the simulations that it runs and the debug adapter know no runtime, no thread, no clock and no file: what
//! they need of these they ask a [`Host`]. `ladder lsp` is one with threads and the files of the operating system; [`EventLoop`]
//! is one of a single thread, for a page.

mod busy;
mod event_loop;
mod host;
pub mod newest;
#[cfg(feature = "testing")]
pub mod testing;
mod wires;

pub use busy::{Busy, Work};
pub use event_loop::EventLoop;
pub use host::{Clock, Host, Moment, Turns, Wait, World, within};
pub use wires::{Connection, Served, Wires};
