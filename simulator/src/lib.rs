//! The deterministic scan engine for ladder programs.
