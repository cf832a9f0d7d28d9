//! The language server for ladder text.
