//! What an editor asks of ladder text: one file for each feature.
//!
//! Plain types in and out, byte offsets, no protocol: the language server turns them into its messages. All of
//! it reads an [`Analysis`](ladder_analysis::Analysis), which is kept for each version of a document.

mod hover;
mod locate;

pub use hover::{Hover, hover};
