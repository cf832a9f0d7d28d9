//! Sections, declarations, headers of block definitions.

use super::{AstNode, BlockHead, Expression, child, child_expression, tokens};
use crate::{SyntaxKind, SyntaxNode, SyntaxToken};

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

impl Declaration {
    /// The declared names.
    pub fn names(&self) -> impl Iterator<Item = SyntaxToken> + use<> {
        self.0
            .children()
            .filter(|n| n.kind() == SyntaxKind::NAME_LIST)
            .flat_map(|list| tokens(&list))
            .filter(|t| t.kind() == SyntaxKind::IDENT)
    }

    /// The address behind AT.
    pub fn address(&self) -> Option<SyntaxToken> {
        let clause = self.0.children().find(|n| n.kind() == SyntaxKind::AT_CLAUSE)?;
        tokens(&clause).find(|t| t.kind() == SyntaxKind::ADDRESS)
    }

    /// The type.
    pub fn type_ref(&self) -> Option<TypeRef> {
        child(&self.0)
    }

    /// The value behind `:=`.
    pub fn initial_value(&self) -> Option<Expression> {
        let value = self
            .0
            .children()
            .find(|n| n.kind() == SyntaxKind::INITIAL_VALUE)?;
        child_expression(&value, 0)
    }
}

impl TypeRef {
    /// The name of the type, or of the elements' type for an array.
    pub fn name(&self) -> Option<SyntaxToken> {
        tokens(&self.0)
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
    pub fn numbers(&self) -> Vec<(bool, SyntaxToken)> {
        let mut numbers = Vec::new();
        let mut negative = false;
        for token in tokens(&self.0) {
            match token.kind() {
                SyntaxKind::MINUS => negative = true,
                SyntaxKind::LITERAL => numbers.push((std::mem::take(&mut negative), token)),
                _ => {}
            }
        }
        numbers
    }
}

impl SectionHeader {
    /// `VAR`, `VAR_INPUT`, ...
    pub fn section(&self) -> Option<SyntaxToken> {
        tokens(&self.0).find(|t| t.kind() == SyntaxKind::KEYWORD)
    }

    /// `RETAIN`, `CONSTANT`
    pub fn qualifiers(&self) -> impl Iterator<Item = SyntaxToken> + use<> {
        tokens(&self.0)
            .filter(|t| t.kind() == SyntaxKind::KEYWORD)
            .skip(1)
    }
}

impl BlockHeader {
    /// The head that shows the block's shape.
    pub fn head(&self) -> Option<BlockHead> {
        child(&self.0)
    }
}
