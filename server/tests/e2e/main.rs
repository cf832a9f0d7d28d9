//! Sessions between a small client and the whole server, framework included, over a pipe in the process.

#[allow(dead_code)]
mod client;
mod features;
mod lifecycle;
mod sync;
