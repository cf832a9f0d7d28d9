//! Mistakes that the parser finds. Ranges count from the start of the logical line that holds them.

use crate::SyntaxKind;
use rowan::{TextRange, TextSize};

/// A mistake in the text, with the place where it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SyntaxError {
    /// What is wrong.
    pub kind: SyntaxErrorKind,
    /// Where: in a [`Line`](crate::Line) from its start, in [`Parse::errors`](crate::Parse::errors) from the
    /// start of the file.
    pub range: TextRange,
}

impl SyntaxError {
    pub(crate) fn new(kind: SyntaxErrorKind, range: TextRange) -> SyntaxError {
        SyntaxError { kind, range }
    }

    /// The same mistake, counted from another origin.
    #[must_use]
    pub fn shifted(&self, by: TextSize) -> SyntaxError {
        SyntaxError {
            kind: self.kind,
            range: self.range + by,
        }
    }
}

/// What the parser can complain about. The analysis turns each into a diagnostic of a rule of LANGUAGE §7.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SyntaxErrorKind {
    /// A first part or an operand list without its closing bracket. The range reaches from the opening bracket
    /// to the place where the closing one belongs.
    UnclosedBlock {
        /// The bracket that is missing.
        closing: SyntaxKind,
    },
    /// A `#` without a partner: the comment reaches to the end of the text.
    UnclosedComment,
    /// Characters that mean nothing where they stand.
    UnexpectedCharacter {
        /// They stand right behind a comment that ended inside what looks like a literal (`T# 5s #`).
        behind_comment: bool,
    },
    /// A string without its closing quote.
    UnclosedString,
    /// No value where an operand or a part of an expression must stand.
    MissingOperand,
    /// Two operands without a comma between them.
    MissingComma,
    /// An expression that is nested more deeply, or has more terms, than the tools read.
    TooComplex,
    /// A declaration that cannot be read from here on.
    BadDeclaration(DeclarationProblem),
}

/// What is wrong with a declaration, a section or a block definition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DeclarationProblem {
    /// A name is expected here.
    NameExpected,
    /// `:` and a type are expected here.
    TypeExpected,
    /// `;` is missing here.
    SemicolonMissing,
    /// An address (`%IX0.0`) is expected behind AT.
    AddressExpected,
    /// A value is expected behind `:=`.
    ValueExpected,
    /// A bracket of an array's bounds or a string's length is missing.
    BoundsExpected,
    /// `OF` and a type are expected.
    OfExpected,
    /// Something stands here that belongs to no declaration.
    Unexpected,
    /// The section above is not closed by END_VAR.
    SectionNotClosed,
    /// END_VAR without a section.
    EndWithoutSection,
    /// Something stands behind END_VAR, or another keyword that ends its line, on the same line.
    LineNotEnded,
    /// FUNCTION_BLOCK without a block's head such as `[$Name]`.
    BlockHeadExpected,
    /// A block definition that is not closed by END_FUNCTION_BLOCK.
    BlockNotClosed,
    /// END_FUNCTION_BLOCK without FUNCTION_BLOCK.
    EndWithoutBlock,
    /// A block definition inside another.
    NestedBlock,
}
