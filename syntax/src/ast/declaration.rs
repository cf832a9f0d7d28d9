//! Sections, declarations, headers of block definitions.

use super::{AstNode, BlockHead, Expression, NodeView, TokenView, child, child_expression};
use crate::kind::SyntaxKind;

ast_node!(
    /// One declaration.
    Declaration = DECLARATION
);
ast_node!(
    /// The first line of a section.
    SectionHeader = SECTION_HEADER
);
ast_node!(
    /// The first line of a block definition.
    BlockHeader = BLOCK_HEADER
);
ast_node!(
    /// A declared type.
    TypeRef = TYPE_REF
);

impl<'g> Declaration<'g> {
    /// The declared names.
    pub fn names(&self) -> impl Iterator<Item = TokenView<'g>> + use<'g> {
        self.0
            .children()
            .filter(|n| n.kind() == SyntaxKind::NAME_LIST)
            .flat_map(NodeView::tokens)
            .filter(|t| t.kind() == SyntaxKind::IDENT)
    }

    /// The address after AT.
    pub fn address(&self) -> Option<TokenView<'g>> {
        let clause = self.0.children().find(|n| n.kind() == SyntaxKind::AT_CLAUSE)?;
        clause.tokens().find(|t| t.kind() == SyntaxKind::ADDRESS)
    }

    /// The type.
    pub fn type_ref(&self) -> Option<TypeRef<'g>> {
        child(self.0)
    }

    /// The value after `:=`.
    pub fn initial_value(&self) -> Option<Expression<'g>> {
        let value = self
            .0
            .children()
            .find(|n| n.kind() == SyntaxKind::INITIAL_VALUE)?;
        child_expression(value, 0)
    }
}

impl<'g> TypeRef<'g> {
    /// The name of the type, or of the elements' type for an array.
    pub fn name(&self) -> Option<TokenView<'g>> {
        self.0
            .tokens()
            .filter(|t| matches!(t.kind(), SyntaxKind::KEYWORD | SyntaxKind::IDENT))
            .find(|t| !["ARRAY", "OF"].iter().any(|w| w.eq_ignore_ascii_case(t.text())))
    }

    /// Whether it is an array.
    pub fn is_array(&self) -> bool {
        self.0
            .first_token()
            .is_some_and(|t| t.text().eq_ignore_ascii_case("ARRAY"))
    }

    /// The numbers in it with their signs: an array's bounds, then (or only) a string's length.
    pub fn numbers(&self) -> Vec<(bool, TokenView<'g>)> {
        let mut numbers = Vec::new();
        let mut negative = false;
        for token in self.0.tokens() {
            match token.kind() {
                SyntaxKind::MINUS => negative = true,
                SyntaxKind::LITERAL => numbers.push((std::mem::take(&mut negative), token)),
                _ => {}
            }
        }
        numbers
    }
}

impl<'g> SectionHeader<'g> {
    /// `VAR`, `VAR_INPUT`, ...
    pub fn section(&self) -> Option<TokenView<'g>> {
        self.0.tokens().find(|t| t.kind() == SyntaxKind::KEYWORD)
    }

    /// `RETAIN`, `CONSTANT`
    pub fn qualifiers(&self) -> impl Iterator<Item = TokenView<'g>> + use<'g> {
        self.0
            .tokens()
            .filter(|t| t.kind() == SyntaxKind::KEYWORD)
            .skip(1)
    }
}

impl<'g> BlockHeader<'g> {
    /// The head that shows the block's shape.
    pub fn head(&self) -> Option<BlockHead<'g>> {
        child(self.0)
    }
}
