//! Drawings as people post them, read; what they become does what is drawn.

mod field;
mod forms;
mod truth;
mod unread;
mod written;
