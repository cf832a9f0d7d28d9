//! What follows from texts that are opened, changed and closed: diagnostics, and what is known of the files around.

pub(crate) mod companions;
pub(crate) mod configuration;
pub(crate) mod diagnostics;
pub(crate) mod file_operations;
pub(crate) mod folders;
pub(crate) mod foreign;
pub(crate) mod misfits;
pub(crate) mod progress;
pub(crate) mod pull;
pub(crate) mod settings_file;
pub(crate) mod shown;
pub(crate) mod sync;
pub(crate) mod typed;
pub(crate) mod watch;
