//! Typed views of the tree: each wraps a node and gives names to its parts. A part that a half-written text
//! lacks is `None`.

macro_rules! ast_node {
    ($(#[$doc:meta])* $name:ident = $($kind:ident)|+) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        pub struct $name(SyntaxNode);

        impl AstNode for $name {
            fn cast(node: SyntaxNode) -> Option<Self> {
                matches!(node.kind(), $(SyntaxKind::$kind)|+).then_some($name(node))
            }
            fn syntax(&self) -> &SyntaxNode {
                &self.0
            }
        }
    };
}

mod block;
mod declaration;
mod expression;

pub use block::{Block, BlockHead, BlockShape, HeadName, NamedOperand, Operand, OperandList};
pub use declaration::{BlockHeader, Declaration, SectionHeader, TypeRef};
pub use expression::{
    ArrayExpression, BinaryExpression, CallExpression, Expression, IndexExpression, MemberExpression,
    ParenExpression, RangeExpression, UnaryExpression,
};

use crate::{SyntaxKind, SyntaxNode, SyntaxToken};
use rowan::TextRange;

/// A typed view of a node.
pub trait AstNode: Sized {
    /// The view, if the node is of a kind that it fits.
    fn cast(node: SyntaxNode) -> Option<Self>;
    /// The node.
    fn syntax(&self) -> &SyntaxNode;
    /// The node's range.
    fn range(&self) -> TextRange {
        self.syntax().text_range()
    }
}

fn child<N: AstNode>(node: &SyntaxNode) -> Option<N> {
    node.children().find_map(N::cast)
}

fn child_expression(node: &SyntaxNode, nth: usize) -> Option<Expression> {
    node.children().filter_map(Expression::cast).nth(nth)
}

/// The expression that stands before the first token of a kind; none if the token is first.
fn expression_before(node: &SyntaxNode, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression> {
    let end = tokens(node).find(|t| kind(t.kind()))?.text_range().start();
    child_expression(node, 0).filter(|e| e.range().end() <= end)
}

/// The expression that stands behind the first token of a kind.
fn expression_behind(node: &SyntaxNode, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression> {
    let start = tokens(node).find(|t| kind(t.kind()))?.text_range().end();
    node.children()
        .filter(|n| n.text_range().start() >= start)
        .find_map(Expression::cast)
}

fn tokens(node: &SyntaxNode) -> impl Iterator<Item = SyntaxToken> + use<> {
    node.children_with_tokens()
        .filter_map(rowan::NodeOrToken::into_token)
}
