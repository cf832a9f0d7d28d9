//! Expressions: operands, indices, initial values.

use super::{
    AstNode, NamedOperand, NodeView, TokenView, child_expression, expression_after, expression_before,
};
use crate::kind::SyntaxKind;
use rowan::TextRange;

/// An expression. Which expressions an operand may be is for the analysis to say.
#[derive(Debug, Clone, Copy)]
pub enum Expression<'g> {
    /// A name.
    Name(TokenView<'g>),
    /// `%IX0.0`
    Address(TokenView<'g>),
    /// A literal or string.
    Literal(TokenView<'g>),
    /// `base.member`
    Member(MemberExpression<'g>),
    /// `base[index]`
    Index(IndexExpression<'g>),
    /// `-a`, `NOT a`
    Unary(UnaryExpression<'g>),
    /// `a + b`
    Binary(BinaryExpression<'g>),
    /// `( a )`
    Paren(ParenExpression<'g>),
    /// `SQRT(a)`
    Call(CallExpression<'g>),
    /// `[1, 2]`
    Array(ArrayExpression<'g>),
    /// `(speed := 20.0)`
    Struct(StructExpression<'g>),
    /// What could not be read.
    Error(NodeView<'g>),
}

ast_node!(
    /// `t1.Q`, `word.3`
    MemberExpression = MEMBER_EXPR
);
ast_node!(
    /// `a[i]`, `a[3..9]`
    IndexExpression = INDEX_EXPR
);
ast_node!(
    /// `3..9`
    RangeExpression = RANGE_EXPR
);
ast_node!(
    /// `-a`, `NOT a`
    UnaryExpression = UNARY_EXPR
);
ast_node!(
    /// `a + b`
    BinaryExpression = BINARY_EXPR
);
ast_node!(
    /// `( a )`
    ParenExpression = PAREN_EXPR
);
ast_node!(
    /// `SQRT(a)`; `4(0)` in an initial value.
    CallExpression = CALL_EXPR
);
ast_node!(
    /// `[1, 2]`
    ArrayExpression = ARRAY_EXPR
);
ast_node!(
    /// `(speed := 20.0)`
    StructExpression = STRUCT_EXPR
);

impl<'g> Expression<'g> {
    /// The view of an expression node.
    pub fn cast(node: NodeView<'g>) -> Option<Expression<'g>> {
        Some(match node.kind() {
            SyntaxKind::NAME_EXPR => Expression::Name(node.first_token()?),
            SyntaxKind::ADDRESS_EXPR => Expression::Address(node.first_token()?),
            SyntaxKind::LITERAL_EXPR => Expression::Literal(node.first_token()?),
            SyntaxKind::MEMBER_EXPR => Expression::Member(MemberExpression(node)),
            SyntaxKind::INDEX_EXPR => Expression::Index(IndexExpression(node)),
            SyntaxKind::UNARY_EXPR => Expression::Unary(UnaryExpression(node)),
            SyntaxKind::BINARY_EXPR => Expression::Binary(BinaryExpression(node)),
            SyntaxKind::PAREN_EXPR => Expression::Paren(ParenExpression(node)),
            SyntaxKind::CALL_EXPR => Expression::Call(CallExpression(node)),
            SyntaxKind::ARRAY_EXPR => Expression::Array(ArrayExpression(node)),
            SyntaxKind::STRUCT_EXPR => Expression::Struct(StructExpression(node)),
            SyntaxKind::ERROR_NODE => Expression::Error(node),
            _ => return None,
        })
    }

    /// Its range.
    pub fn range(&self) -> TextRange {
        match self {
            Expression::Name(t) | Expression::Address(t) | Expression::Literal(t) => t.text_range(),
            Expression::Member(n) => n.range(),
            Expression::Index(n) => n.range(),
            Expression::Unary(n) => n.range(),
            Expression::Binary(n) => n.range(),
            Expression::Paren(n) => n.range(),
            Expression::Call(n) => n.range(),
            Expression::Array(n) => n.range(),
            Expression::Struct(n) => n.range(),
            Expression::Error(n) => n.range(),
        }
    }
}

/// Next to operators an expression holds white space, comments and what means nothing.
fn is_operator(kind: SyntaxKind) -> bool {
    !kind.is_trivia() && kind != SyntaxKind::ERROR
}

impl<'g> MemberExpression<'g> {
    /// What is before the point.
    pub fn base(&self) -> Option<Expression<'g>> {
        child_expression(self.0, 0)
    }

    /// The word or bit number after the point.
    pub fn member(&self) -> Option<TokenView<'g>> {
        self.0
            .tokens()
            .find(|t| matches!(t.kind(), SyntaxKind::IDENT | SyntaxKind::LITERAL))
    }
}

impl<'g> IndexExpression<'g> {
    /// What is before the bracket.
    pub fn base(&self) -> Option<Expression<'g>> {
        child_expression(self.0, 0)
    }

    /// What is in the brackets.
    pub fn subscripts(&self) -> impl Iterator<Item = Subscript<'g>> + use<'g> {
        let subscript = |node| {
            let range = RangeExpression::cast(node).map(Subscript::Range);
            range.or_else(|| Expression::cast(node).map(Subscript::Index))
        };
        self.0.children().filter_map(subscript).skip(1)
    }
}

/// One of those in the brackets of an index.
#[derive(Debug, Clone, Copy)]
pub enum Subscript<'g> {
    /// `3`
    Index(Expression<'g>),
    /// `3..9`
    Range(RangeExpression<'g>),
}

impl<'g> RangeExpression<'g> {
    /// The first element's index.
    pub fn first(&self) -> Option<Expression<'g>> {
        expression_before(self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }

    /// The last element's index.
    pub fn last(&self) -> Option<Expression<'g>> {
        expression_after(self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }
}

impl<'g> UnaryExpression<'g> {
    /// `-` or `NOT`.
    pub fn operator(&self) -> Option<TokenView<'g>> {
        self.0.tokens().find(|t| is_operator(t.kind()))
    }

    /// What it works on.
    pub fn operand(&self) -> Option<Expression<'g>> {
        child_expression(self.0, 0)
    }
}

impl<'g> BinaryExpression<'g> {
    /// The left side.
    pub fn left(&self) -> Option<Expression<'g>> {
        expression_before(self.0, is_operator)
    }

    /// The operator.
    pub fn operator(&self) -> Option<TokenView<'g>> {
        self.0.tokens().find(|t| is_operator(t.kind()))
    }

    /// The right side.
    pub fn right(&self) -> Option<Expression<'g>> {
        expression_after(self.0, is_operator)
    }
}

impl<'g> ParenExpression<'g> {
    /// What is in the parentheses.
    pub fn inner(&self) -> Option<Expression<'g>> {
        child_expression(self.0, 0)
    }
}

impl<'g> CallExpression<'g> {
    /// The function's name (or the count of a repeated initial value).
    pub fn callee(&self) -> Option<Expression<'g>> {
        child_expression(self.0, 0)
    }

    /// The arguments.
    pub fn arguments(&self) -> impl Iterator<Item = Expression<'g>> + use<'g> {
        self.0.children().filter_map(Expression::cast).skip(1)
    }
}

impl<'g> StructExpression<'g> {
    /// The members with their values.
    pub fn members(&self) -> impl Iterator<Item = NamedOperand<'g>> + use<'g> {
        self.0.children().filter_map(NamedOperand::cast)
    }
}

impl<'g> ArrayExpression<'g> {
    /// The values.
    pub fn values(&self) -> impl Iterator<Item = Expression<'g>> + use<'g> {
        self.0.children().filter_map(Expression::cast)
    }
}
