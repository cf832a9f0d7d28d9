//! One module a command.

pub(crate) mod check;
pub(crate) mod explain;
pub(crate) mod fmt;
#[cfg(feature = "server")]
pub(crate) mod lsp;
pub(crate) mod render;
pub(crate) mod sim;
pub(crate) mod test;
pub(crate) mod tree;
