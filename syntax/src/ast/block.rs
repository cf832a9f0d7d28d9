//! Blocks on a rung: first part, operand list, operands.

use super::{AstNode, Expression, NodeView, TokenView, child, expression_after, expression_before};
use crate::kind::SyntaxKind;
use rowan::TextRange;

ast_node!(
    /// A block on a rung.
    Block = LOGICAL_BLOCK | COIL_BLOCK | FUNCTION_BLOCK
);
ast_node!(
    /// The first part of a block, with its brackets.
    BlockHead = BLOCK_HEAD
);
ast_node!(
    /// The parentheses with the operands.
    OperandList = OPERAND_LIST
);
ast_node!(
    /// `R := reset` or `FOUND => hit`.
    NamedOperand = NAMED_OPERAND
);

/// The brackets of a block's first part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BlockShape {
    /// `[..]`
    Logical,
    /// `(..)`
    Coil,
    /// `<..>`
    Function,
}

/// What a block's first part names.
#[derive(Debug, Clone, Copy)]
pub enum HeadName<'g> {
    /// Nothing: `[ ]`, `( )`.
    Blank,
    /// `TON`, `/`.
    Mnemonic(TokenView<'g>),
    /// `$Name` of a user-defined block.
    User(TokenView<'g>),
}

impl<'g> Block<'g> {
    /// The brackets.
    pub fn shape(&self) -> BlockShape {
        match self.0.kind() {
            SyntaxKind::LOGICAL_BLOCK => BlockShape::Logical,
            SyntaxKind::COIL_BLOCK => BlockShape::Coil,
            _ => BlockShape::Function,
        }
    }

    /// The first part.
    pub fn head(&self) -> Option<BlockHead<'g>> {
        child(self.0)
    }

    /// The operand list.
    pub fn operand_list(&self) -> Option<OperandList<'g>> {
        child(self.0)
    }

    /// The operands in the order in which they are.
    pub fn operands(&self) -> impl Iterator<Item = Operand<'g>> + use<'g> {
        self.operand_list().into_iter().flat_map(|list| list.operands())
    }
}

impl<'g> BlockHead<'g> {
    /// What it names.
    pub fn name(&self) -> HeadName<'g> {
        self.0
            .tokens()
            .find_map(|token| match token.kind() {
                SyntaxKind::MNEMONIC => Some(HeadName::Mnemonic(token)),
                SyntaxKind::BLOCK_NAME => Some(HeadName::User(token)),
                _ => None,
            })
            .unwrap_or(HeadName::Blank)
    }

    /// The shape of its brackets.
    pub fn shape(&self) -> BlockShape {
        match self.0.first_token().map(TokenView::kind) {
            Some(SyntaxKind::L_PAREN) => BlockShape::Coil,
            Some(SyntaxKind::L_ANGLE) => BlockShape::Function,
            _ => BlockShape::Logical,
        }
    }
}

impl<'g> OperandList<'g> {
    /// The operands in the order in which they are.
    pub fn operands(&self) -> impl Iterator<Item = Operand<'g>> + use<'g> {
        self.0.children().filter_map(Operand::cast)
    }
}

/// One operand of a block.
#[derive(Debug, Clone, Copy)]
pub enum Operand<'g> {
    /// By place.
    Positional(Expression<'g>),
    /// By name.
    Named(NamedOperand<'g>),
}

impl<'g> Operand<'g> {
    fn cast(node: NodeView<'g>) -> Option<Operand<'g>> {
        if node.kind() == SyntaxKind::NAMED_OPERAND {
            return Some(Operand::Named(NamedOperand(node)));
        }
        Expression::cast(node).map(Operand::Positional)
    }

    /// The operand's range, name included.
    pub fn range(&self) -> TextRange {
        match self {
            Operand::Positional(e) => e.range(),
            Operand::Named(n) => n.range(),
        }
    }

    /// The value, without a name.
    pub fn value(&self) -> Option<Expression<'g>> {
        match self {
            Operand::Positional(e) => Some(*e),
            Operand::Named(n) => n.value(),
        }
    }
}

impl<'g> NamedOperand<'g> {
    /// The name before `:=` or `=>`, if it is one.
    pub fn name(&self) -> Option<TokenView<'g>> {
        match expression_before(self.0, |kind| {
            matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW)
        }) {
            Some(Expression::Name(name)) => Some(name),
            _ => None,
        }
    }

    /// `:=` or `=>`.
    pub fn arrow(&self) -> Option<TokenView<'g>> {
        self.0
            .tokens()
            .find(|t| matches!(t.kind(), SyntaxKind::ASSIGN | SyntaxKind::ARROW))
    }

    /// The value after it.
    pub fn value(&self) -> Option<Expression<'g>> {
        expression_after(self.0, |kind| {
            matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW)
        })
    }
}
