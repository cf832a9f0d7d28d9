//! Nodes and tokens as the green tree holds them, with their places: a reference and an offset each.
//!
//! rowan's own cursor knows its parents and allocates for each node it is on. What is read downwards only, for
//! every block of every check, needs neither.

use crate::kind::SyntaxKind;
use rowan::{GreenNodeData, GreenTokenData, NodeOrToken, TextRange, TextSize};
use std::fmt;

/// A node and where it begins: counted from the line that it was taken from.
#[derive(Clone, Copy)]
pub struct NodeView<'g> {
    green: &'g GreenNodeData,
    start: TextSize,
}

/// A token and where it begins.
#[derive(Clone, Copy)]
pub struct TokenView<'g> {
    green: &'g GreenTokenData,
    start: TextSize,
}

impl<'g> NodeView<'g> {
    /// A node as the root: offsets count from its start.
    pub fn root(green: &'g GreenNodeData) -> NodeView<'g> {
        NodeView {
            green,
            start: TextSize::new(0),
        }
    }

    /// Its kind.
    pub(crate) fn kind(self) -> SyntaxKind {
        SyntaxKind::from_raw(self.green.kind())
    }

    /// Where it is.
    pub(crate) fn range(self) -> TextRange {
        TextRange::at(self.start, self.green.text_len())
    }

    /// The nodes and tokens right below it.
    pub(crate) fn parts(self) -> impl Iterator<Item = NodeOrToken<NodeView<'g>, TokenView<'g>>> + use<'g> {
        let mut at = self.start;
        self.green.children().map(move |child| {
            let start = at;
            match child {
                NodeOrToken::Node(green) => {
                    at += green.text_len();
                    NodeOrToken::Node(NodeView { green, start })
                }
                NodeOrToken::Token(green) => {
                    at += green.text_len();
                    NodeOrToken::Token(TokenView { green, start })
                }
            }
        })
    }

    /// The nodes right below it.
    pub fn children(self) -> impl Iterator<Item = NodeView<'g>> + use<'g> {
        self.parts().filter_map(NodeOrToken::into_node)
    }

    /// The tokens right below it.
    pub fn tokens(self) -> impl Iterator<Item = TokenView<'g>> + use<'g> {
        self.parts().filter_map(NodeOrToken::into_token)
    }

    /// Its first token, however deep.
    pub(crate) fn first_token(self) -> Option<TokenView<'g>> {
        self.parts().find_map(|part| match part {
            NodeOrToken::Node(node) => node.first_token(),
            NodeOrToken::Token(token) => Some(token),
        })
    }
}

impl<'g> TokenView<'g> {
    /// Its kind.
    pub fn kind(self) -> SyntaxKind {
        SyntaxKind::from_raw(self.green.kind())
    }

    /// Its text.
    pub fn text(self) -> &'g str {
        self.green.text()
    }

    /// Where it is.
    pub fn text_range(self) -> TextRange {
        TextRange::at(self.start, self.green.text_len())
    }
}

/// The text.
impl fmt::Display for NodeView<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.green)
    }
}

impl fmt::Debug for NodeView<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}@{:?}", self.kind(), self.range())
    }
}

impl fmt::Debug for TokenView<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}@{:?} {:?}", self.kind(), self.text_range(), self.text())
    }
}
