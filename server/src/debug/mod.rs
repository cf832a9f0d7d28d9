//! The debug adapter over standard input and output: what `ladder dap` runs.
//!
//! ```text
//! client's bytes -> wire, on a thread of its own -> serve -> the adapter
//! client <- wire <- answers and events <-------------------------+
//! ```

mod serve;
mod wire;

pub(crate) use serve::serve;
