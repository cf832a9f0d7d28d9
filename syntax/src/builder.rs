//! What the grammar reports about a text, and to whom.

use crate::kind::SyntaxKind;
use std::ops::Range;

/// Takes the nodes and tokens of logical lines, in the order of the text. The grammar is written once; whether a
/// tree comes of it, a list, or only a few facts is the builder's affair.
///
/// Calls nest: every node that is started is finished, and at [`Builder::finish_line`] none is open.
pub trait Builder {
    /// What is left of a line when it ends.
    type Line;
    /// A place after what was added last, from which a node may be begun later.
    type Checkpoint: Copy;

    /// Whether [`Builder::plain_block`] may stand for all that a block holds.
    const TAKES_PLAIN_BLOCKS: bool = false;

    /// Whether nobody needs the tokens of a plain declaration: names and the name of a type, blanks, but no comments; all of it
    /// ASCII; no errors. Then none of them is added.
    const SKIPS_PLAIN_DECLARATIONS: bool = false;

    /// Adds a token: what is at a place of the text, which begins where the token before it ends.
    fn token(&mut self, kind: SyntaxKind, text: &str, place: Range<usize>);

    /// Adds a block without what it holds: at most a mnemonic in capitals, and names, members, numbers and typed
    /// literals, parted by commas; blanks, but no comments; all of it ASCII; no errors. It begins where the token
    /// before it ends. Only called of a builder that takes it.
    fn plain_block(&mut self, kind: SyntaxKind, place: Range<usize>) {
        let _ = (kind, place);
    }

    /// Begins a node.
    fn start_node(&mut self, kind: SyntaxKind);

    /// A place from which [`Builder::start_node_at`] may begin a node as long as the node that is open now is.
    fn checkpoint(&self) -> Self::Checkpoint;

    /// Begins a node that holds what was added since the checkpoint.
    fn start_node_at(&mut self, checkpoint: Self::Checkpoint, kind: SyntaxKind);

    /// Ends the node that was begun last.
    fn finish_node(&mut self);

    /// Ends the line: everything that was added since the last one belongs to a node of this kind.
    fn finish_line(&mut self, kind: SyntaxKind) -> Self::Line;
}
