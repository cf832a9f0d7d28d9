//! The debug adapter: it speaks the Debug Adapter Protocol and drives the scan engine.
//!
//! ```text
//! requests -> adapter: one function for each request
//!                |
//!      target: the program, its files, its session <--> breakpoints, variables, stack, console
//!                |
//! outlet: answers, and after them events
//! ```
//!
//! - A request is answered by the thread that runs the program, between two scans or where it has stopped. A long scan
//!   is given up for `pause` and its like, so that these never wait.
//! - Every request gets exactly one answer, also after a panic. Events go out after the answer that they follow from.
//! - What is stopped in front of the first network of a scan is between two scans: what is set there counts for the
//!   next one.
//!
//! `docs/src/guide/debugging.md` is the page for people.

mod adapter;
mod asked;
mod attached;
mod breakpoint_places;
mod breakpoint_requests;
mod breakpoints;
mod capabilities;
mod condition;
mod configuration;
mod console;
mod expectations;
mod flood;
mod launch;
mod marker;
mod messages;
mod once;
mod outlet;
mod play;
mod properties;
mod running;
mod safely;
mod sources;
mod stack;
mod stepping;
mod target;
#[cfg(test)]
mod tests;
mod variables;

pub use adapter::Adapter;
pub use attached::{Launch, answer_of_none, is_urgent};
pub use messages::{NoRequest, Request};
pub use outlet::Output;
