//! Programs from texts.

use ladder_review::Outline;

/// The entries of a text that is alone.
pub(crate) fn outline(text: &str) -> Outline {
    Outline::of_text("main.clad", text)
}
