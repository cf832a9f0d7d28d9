//! The one table of ladder instructions.
