//! What an editor asks of ladder text: one file for each feature.
//!
//! Plain types in and out, byte offsets, no protocol: the language server turns them into its messages. All of
//! it reads an [`Analysis`](ladder_analysis::Analysis), which is kept for each version of a document.

mod body;
mod completion;
mod definition;
#[cfg(test)]
mod fixture;
mod highlight;
mod hover;
mod jumps;
mod locate;
mod neighbour;
mod references;
mod symbol;
mod target;
mod typing;
mod wanted;

pub use completion::{
    Completion, CompletionKind, Completions, Snippet, Topic, card, completions, documentation,
};
pub use definition::{declaration, definition, implementation, type_definition};
pub use highlight::{Highlight, highlights};
pub use hover::{Hover, hover};
pub use neighbour::{Alone, Neighbour, Workspace, mentions};
pub use references::{Reference, references};
pub use symbol::Usage;
pub use target::Target;
