//! Errors that the parser finds. Ranges count from the start of the logical line that holds them.

use crate::kind::SyntaxKind;
use rowan::{TextRange, TextSize};

/// An error in the text, with the place where it is.
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

    /// The same error, counted from another origin.
    #[must_use]
    pub(crate) fn shifted(&self, by: TextSize) -> SyntaxError {
        SyntaxError {
            kind: self.kind,
            range: self.range + by,
        }
    }
}

/// What the parser can complain about. The analysis turns each into a diagnostic of a rule of LANGUAGE §7.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SyntaxErrorKind {
    /// A first part, an operand list, an index or a parenthesis without its closing bracket. The range reaches
    /// from the opening bracket to the place where the closing one belongs.
    UnclosedBlock {
        /// The bracket that is missing.
        closing: SyntaxKind,
    },
    /// A first part that ends with the bracket of another shape, as in `[TON)`. The range is the wrong bracket's.
    WrongBracket {
        /// The bracket that belongs there.
        closing: SyntaxKind,
    },
    /// A `#` without a partner: the comment reaches to the end of the text.
    UnclosedComment,
    /// Characters that mean nothing where they are.
    UnexpectedCharacter {
        /// What they are in.
        place: Surroundings,
        /// They are right after a comment that ended inside what looks like a literal (`T# 5s #`).
        after_comment: bool,
    },
    /// A string without its closing quote.
    UnclosedString,
    /// The name of a user-defined block that is not a letter, then letters, digits and single `_`, as in `$block_`.
    BadBlockName,
    /// No value where an operand or a part of an expression must be. The range is that of the next token, or
    /// empty at the end of a line.
    MissingOperand {
        /// What lacks it.
        place: OperandPlace,
    },
    /// Two operands without a comma between them.
    MissingComma,
    /// An expression that is nested more deeply, or has more terms, than the tools read.
    TooComplex,
    /// There are more things on a line, or in an operand list, than the tools read. The range is the rest, which is not
    /// read.
    TooMany(Many),
    /// A declaration that cannot be read from here on.
    BadDeclaration(DeclarationProblem),
}

impl SyntaxErrorKind {
    /// Whether it says that the end of a section or block definition was not found.
    pub(crate) const fn lacks_end(self) -> bool {
        matches!(
            self,
            SyntaxErrorKind::BadDeclaration(
                DeclarationProblem::SectionNotClosed
                    | DeclarationProblem::TypesNotClosed
                    | DeclarationProblem::StructNotClosed
                    | DeclarationProblem::BlockNotClosed
            )
        )
    }
}

/// What there can be too many of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Many {
    /// Wires, connectors, blocks, rails and comments on a line.
    Parts,
    /// Operands of a block.
    Operands,
}

impl Many {
    /// How many are read.
    pub const fn most(self) -> u32 {
        match self {
            Many::Parts => 5_000,
            Many::Operands => 1_000,
        }
    }
}

/// What something is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Surroundings {
    /// On a line, outside blocks.
    Rung,
    /// In a block's first part.
    Head,
    /// In an operand list.
    Operands,
    /// In a section or on the first or last line of a block definition.
    Declaration,
}

/// Where a value is missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OperandPlace {
    /// Between two commas, or between a comma and a parenthesis, of a list.
    List,
    /// Before or after an operator or a sign.
    Operator,
    /// Before or after `:=` or `=>`.
    Named,
    /// Between the brackets of an index.
    Index,
    /// Before or after `..`.
    Range,
    /// Between the parentheses of an expression.
    Parentheses,
    /// After the point of a member.
    Member,
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
    /// An address (`%IX0.0`) is expected after AT.
    AddressExpected,
    /// A value is expected after `:=`.
    ValueExpected,
    /// A bracket of an array's bounds or a string's length is missing.
    BoundsExpected,
    /// `OF` and a type are expected.
    OfExpected,
    /// Something is here that belongs to no declaration.
    Unexpected,
    /// The section above is not closed by END_VAR.
    SectionNotClosed,
    /// The section above is not closed by END_TYPE.
    TypesNotClosed,
    /// END_VAR, END_TYPE or END_STRUCT without what it closes.
    EndWithoutSection,
    /// END_VAR closes what TYPE began, or the other way round.
    OtherEnd,
    /// The STRUCT above is not closed by END_STRUCT.
    StructNotClosed,
    /// STRUCT among tags.
    StructOutsideTypes,
    /// STRUCT inside a STRUCT.
    NestedStruct,
    /// The list of an enumeration among tags or members.
    EnumerationOutsideTypes,
    /// A value's name is expected in the list of an enumeration.
    EnumerationValueExpected,
    /// A member's name and `:=` are expected in the values of a structure.
    MemberExpected,
    /// Something is after END_VAR, or another keyword that ends its line, on the same line.
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
