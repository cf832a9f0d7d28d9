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
    /// The first line of a structure: `Motor : STRUCT`.
    StructHeader = STRUCT_HEADER
);
ast_node!(
    /// The last line of a structure: `END_STRUCT;`.
    StructEnd = STRUCT_END
);
ast_node!(
    /// A value of an enumeration: `MIXING := 10`.
    EnumValue = ENUM_VALUE
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
        names(self.0)
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
        initial_value(self.0)
    }
}

impl<'g> StructHeader<'g> {
    /// The declared names: one, where it is right.
    pub fn names(&self) -> impl Iterator<Item = TokenView<'g>> + use<'g> {
        names(self.0)
    }
}

impl<'g> StructEnd<'g> {
    /// The value after `:=`.
    pub fn initial_value(&self) -> Option<Expression<'g>> {
        initial_value(self.0)
    }
}

fn names(line: NodeView<'_>) -> impl Iterator<Item = TokenView<'_>> {
    line.children()
        .filter(|n| n.kind() == SyntaxKind::NAME_LIST)
        .flat_map(NodeView::tokens)
        .filter(|t| t.kind() == SyntaxKind::IDENT)
}

fn initial_value(line: NodeView<'_>) -> Option<Expression<'_>> {
    let value = line.children().find(|n| n.kind() == SyntaxKind::INITIAL_VALUE)?;
    child_expression(value, 0)
}

impl<'g> EnumValue<'g> {
    /// Its name.
    pub fn name(&self) -> Option<TokenView<'g>> {
        self.0.tokens().find(|t| t.kind() == SyntaxKind::IDENT)
    }

    /// The number after `:=`.
    pub fn number(&self) -> Option<Bound<'g>> {
        let after = self.0.tokens().skip_while(|t| t.kind() != SyntaxKind::ASSIGN);
        bounds_in(after).next()
    }
}

/// A bound of an array or subrange, the length of a STRING, the number of an enumeration's value.
#[derive(Debug, Clone, Copy)]
pub struct Bound<'g> {
    /// Whether a minus is before it.
    pub negative: bool,
    /// A number, or the name of a constant.
    pub token: TokenView<'g>,
}

/// The bounds among some tokens.
fn bounds_in<'g>(tokens: impl Iterator<Item = TokenView<'g>>) -> impl Iterator<Item = Bound<'g>> {
    let mut negative = false;
    tokens.filter_map(move |token| match token.kind() {
        SyntaxKind::MINUS => {
            negative = true;
            None
        }
        SyntaxKind::LITERAL | SyntaxKind::IDENT => Some(Bound {
            negative: std::mem::take(&mut negative),
            token,
        }),
        _ => None,
    })
}

impl<'g> TypeRef<'g> {
    /// The name of the type, or of the elements' type for an array.
    pub fn name(&self) -> Option<TokenView<'g>> {
        let is_word = |t: &TokenView<'g>| ["ARRAY", "OF"].iter().any(|w| w.eq_ignore_ascii_case(t.text()));
        let is_name = |t: &TokenView<'g>| {
            matches!(
                t.kind(),
                SyntaxKind::KEYWORD | SyntaxKind::IDENT | SyntaxKind::BLOCK_NAME
            )
        };
        self.of_element().find(|t| is_name(t) && !is_word(t))
    }

    /// The tokens of what the elements are, or of the whole if it is not an array.
    fn of_element(&self) -> impl Iterator<Item = TokenView<'g>> + use<'g> {
        let is_array = self.is_array();
        let is_of = |t: &TokenView<'_>| t.text().eq_ignore_ascii_case("OF");
        self.0.tokens().skip_while(move |t| is_array && !is_of(t))
    }

    /// Whether it is an array.
    pub fn is_array(&self) -> bool {
        self.0
            .first_token()
            .is_some_and(|t| t.text().eq_ignore_ascii_case("ARRAY"))
    }

    /// The bounds of an array's dimensions, two for each.
    pub fn dimensions(&self) -> Vec<Bound<'g>> {
        if !self.is_array() {
            return Vec::new();
        }
        let is_of = |t: &TokenView<'_>| t.text().eq_ignore_ascii_case("OF");
        bounds_in(self.0.tokens().skip(1).take_while(|t| !is_of(t))).collect()
    }

    /// The type of the elements, if that is an array itself.
    pub fn element(&self) -> Option<TypeRef<'g>> {
        child(self.0)
    }

    /// The numbers after the type's name: the length of a STRING, the bounds of a subrange.
    pub fn limits(&self) -> Vec<Bound<'g>> {
        let is_open = |t: &TokenView<'_>| matches!(t.kind(), SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN);
        bounds_in(self.of_element().skip_while(move |t| !is_open(t))).collect()
    }

    /// Whether it is the list of an enumeration.
    pub fn is_enumeration(&self) -> bool {
        self.0
            .first_token()
            .is_some_and(|t| t.kind() == SyntaxKind::L_PAREN)
    }

    /// The values of an enumeration.
    pub fn values(&self) -> impl Iterator<Item = EnumValue<'g>> + use<'g> {
        self.0.children().filter_map(EnumValue::cast)
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
