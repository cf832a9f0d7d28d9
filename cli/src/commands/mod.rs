//! One module a command.

pub(crate) mod check;
#[cfg(feature = "pages")]
pub(crate) mod completions;
pub(crate) mod convert;
pub(crate) mod dap;
pub(crate) mod diff;
pub(crate) mod explain;
pub(crate) mod fmt;
pub(crate) mod git;
pub(crate) mod lsp;
#[cfg(feature = "pages")]
pub(crate) mod man;
pub(crate) mod merge;
pub(crate) mod new;
#[cfg(feature = "pages")]
pub(crate) mod pages;
pub(crate) mod prove;
pub(crate) mod render;
#[cfg(feature = "run")]
pub(crate) mod run;
pub(crate) mod sim;
pub(crate) mod tags;
pub(crate) mod test;
pub(crate) mod tree;
pub(crate) mod why;
