//! Expressions: operands, indices, initial values.

use super::{AstNode, child, child_expression, expression_before, expression_behind, tokens};
use crate::{SyntaxKind, SyntaxNode, SyntaxToken};
use rowan::TextRange;

/// An expression. Which expressions an operand may be is for the analysis to say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Expression {
    /// A name.
    Name(SyntaxToken),
    /// `%IX0.0`
    Address(SyntaxToken),
    /// A literal or string.
    Literal(SyntaxToken),
    /// `base.member`
    Member(MemberExpression),
    /// `base[index]`
    Index(IndexExpression),
    /// `-a`, `NOT a`
    Unary(UnaryExpression),
    /// `a + b`
    Binary(BinaryExpression),
    /// `( a )`
    Paren(ParenExpression),
    /// `SQRT(a)`
    Call(CallExpression),
    /// `[1, 2]`
    Array(ArrayExpression),
    /// What could not be read.
    Error(SyntaxNode),
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

impl Expression {
    /// The view of an expression node.
    pub fn cast(node: SyntaxNode) -> Option<Expression> {
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
            Expression::Error(n) => n.text_range(),
        }
    }
}

/// Beside operators an expression holds white space, comments and what means nothing.
fn is_operator(kind: SyntaxKind) -> bool {
    !kind.is_trivia() && kind != SyntaxKind::ERROR
}

impl MemberExpression {
    /// What stands before the point.
    pub fn base(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The word or bit number behind the point.
    pub fn member(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| matches!(t.kind(), SyntaxKind::IDENT | SyntaxKind::LITERAL))
    }
}

impl IndexExpression {
    /// What stands before the bracket.
    pub fn base(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The index, if it is a single one.
    pub fn index(&self) -> Option<Expression> {
        child_expression(&self.0, 1)
    }

    /// The range, if it is one.
    pub fn range_expression(&self) -> Option<RangeExpression> {
        child(&self.0)
    }
}

impl RangeExpression {
    /// The first element's index.
    pub fn first(&self) -> Option<Expression> {
        expression_before(&self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }

    /// The last element's index.
    pub fn last(&self) -> Option<Expression> {
        expression_behind(&self.0, |kind| kind == SyntaxKind::DOT_DOT)
    }
}

impl UnaryExpression {
    /// `-` or `NOT`.
    pub fn operator(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| is_operator(t.kind()))
    }

    /// What it works on.
    pub fn operand(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }
}

impl BinaryExpression {
    /// The left side.
    pub fn left(&self) -> Option<Expression> {
        expression_before(&self.0, is_operator)
    }

    /// The operator.
    pub fn operator(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| is_operator(t.kind()))
    }

    /// The right side.
    pub fn right(&self) -> Option<Expression> {
        expression_behind(&self.0, is_operator)
    }
}

impl ParenExpression {
    /// What stands in the parentheses.
    pub fn inner(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }
}

impl CallExpression {
    /// The function's name (or the count of a repeated initial value).
    pub fn callee(&self) -> Option<Expression> {
        child_expression(&self.0, 0)
    }

    /// The arguments.
    pub fn arguments(&self) -> impl Iterator<Item = Expression> + use<> {
        self.0.children().filter_map(Expression::cast).skip(1)
    }
}

impl ArrayExpression {
    /// The values.
    pub fn values(&self) -> impl Iterator<Item = Expression> + use<> {
        self.0.children().filter_map(Expression::cast)
    }
}
