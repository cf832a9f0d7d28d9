//! The language server for ladder text in a page: the one of `ladder-service`, on the only thread of a worker, with files in
//! memory.
//!
//! `exports` is what JavaScript calls, [`Page`] the same in Rust. `../README.md` says how a page speaks with the worker.

#[cfg(target_family = "wasm")]
mod exports;
mod page;

pub use page::{Page, WORKSPACE};
