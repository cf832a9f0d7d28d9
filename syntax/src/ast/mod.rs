//! Typed views of the tree: each wraps a node and gives names to its parts. A part that a half-written text
//! lacks is `None`.

macro_rules! ast_node {
    ($(#[$doc:meta])* $name:ident = $($kind:ident)|+) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy)]
        pub struct $name<'g>(NodeView<'g>);

        impl<'g> AstNode<'g> for $name<'g> {
            fn cast(node: NodeView<'g>) -> Option<Self> {
                matches!(node.kind(), $(SyntaxKind::$kind)|+).then_some($name(node))
            }
            fn syntax(&self) -> NodeView<'g> {
                self.0
            }
        }
    };
}

mod block;
mod declaration;
mod expression;
mod view;

pub use block::{Block, BlockHead, BlockShape, HeadName, NamedOperand, Operand, OperandList};
pub use declaration::{
    BlockHeader, Bound, Declaration, EnumValue, SectionHeader, StructEnd, StructHeader, TypeRef,
};
pub use expression::{
    ArrayExpression, BinaryExpression, CallExpression, Expression, IndexExpression, MemberExpression,
    ParenExpression, RangeExpression, StructExpression, Subscript, UnaryExpression,
};
pub use view::{NodeView, TokenView};

use crate::kind::SyntaxKind;
use rowan::TextRange;

/// A typed view of a node.
pub trait AstNode<'g>: Sized {
    /// The view, if the node is of a kind that it fits.
    fn cast(node: NodeView<'g>) -> Option<Self>;
    /// The node.
    fn syntax(&self) -> NodeView<'g>;
    /// The node's range.
    fn range(&self) -> TextRange {
        self.syntax().range()
    }
}

fn child<'g, N: AstNode<'g>>(node: NodeView<'g>) -> Option<N> {
    node.children().find_map(N::cast)
}

fn child_expression(node: NodeView<'_>, nth: usize) -> Option<Expression<'_>> {
    node.children().filter_map(Expression::cast).nth(nth)
}

/// The expression that is before the first token of a kind; none if the token is first.
fn expression_before(node: NodeView<'_>, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression<'_>> {
    let end = node.tokens().find(|t| kind(t.kind()))?.text_range().start();
    child_expression(node, 0).filter(|e| e.range().end() <= end)
}

/// The expression that is after the first token of a kind.
fn expression_after(node: NodeView<'_>, kind: impl Fn(SyntaxKind) -> bool) -> Option<Expression<'_>> {
    let start = node.tokens().find(|t| kind(t.kind()))?.text_range().end();
    node.children()
        .filter(|n| n.range().start() >= start)
        .find_map(Expression::cast)
}
