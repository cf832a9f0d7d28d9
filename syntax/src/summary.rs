//! Reads lines for what they are, and makes nothing of their tokens.

use crate::builder::Builder;
use crate::kind::SyntaxKind;
use std::ops::Range;

/// Takes nothing: what a line is, its connectors and its errors are in what the grammar returns.
pub(crate) struct Summary;

impl Builder for Summary {
    type Line = ();
    type Checkpoint = ();

    const TAKES_PLAIN_BLOCKS: bool = true;
    const SKIPS_PLAIN_DECLARATIONS: bool = true;

    fn token(&mut self, _: SyntaxKind, _: &str, _: Range<usize>) {}

    fn start_node(&mut self, _: SyntaxKind) {}

    fn checkpoint(&self) {}

    fn start_node_at(&mut self, (): (), _: SyntaxKind) {}

    fn finish_node(&mut self) {}

    fn finish_line(&mut self, _: SyntaxKind) {}
}
