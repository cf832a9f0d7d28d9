//! The kinds of tokens and nodes, and the language tag that rowan asks for.

/// Every kind of token and node in the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(non_camel_case_types)]
#[repr(u16)]
pub enum SyntaxKind {
    // Trivia.
    /// A run of blanks and tabs.
    WHITESPACE,
    /// One line end: LF, CRLF or a lone CR.
    NEWLINE,
    /// `# .. #`, or `# ..` to the end of the text.
    COMMENT,
    /// The byte order mark at the start of the text.
    BOM,
    /// A line of signs of a merge's conflict, or all of it that is not read; see [`crate::Conflict`].
    CONFLICT,

    // Drawing.
    /// A run of `-` outside blocks.
    WIRE,
    /// `+` outside blocks.
    RAIL_CONNECTOR,
    /// `|`.
    RAIL,
    /// `\`.
    DOWN,
    /// `/` outside blocks.
    UP,

    // Brackets.
    /// `[`
    L_BRACKET,
    /// `]`
    R_BRACKET,
    /// `(`
    L_PAREN,
    /// `)`
    R_PAREN,
    /// `<` before a function block's mnemonic.
    L_ANGLE,
    /// `>` after a function block's mnemonic.
    R_ANGLE,

    // Words and values.
    /// What is in a block's first part: `TON`, `/`.
    MNEMONIC,
    /// `$Name` in a block's first part.
    BLOCK_NAME,
    /// A name in an operand list or a declaration.
    IDENT,
    /// A section, type or block-definition keyword.
    KEYWORD,
    /// `AND OR XOR NOT MOD SHL SHR` in an expression.
    WORD_OPERATOR,
    /// A number, duration, date, typed literal, TRUE or FALSE.
    LITERAL,
    /// `'text'`.
    STRING,
    /// `%IX0.3`.
    ADDRESS,

    // Punctuation of operand lists and declarations.
    /// `,`
    COMMA,
    /// `:`
    COLON,
    /// `;`
    SEMICOLON,
    /// `:=`
    ASSIGN,
    /// `=>`
    ARROW,
    /// `.`
    DOT,
    /// `..`
    DOT_DOT,
    /// `+` in an expression.
    PLUS,
    /// `-` in an expression.
    MINUS,
    /// `*`
    STAR,
    /// `/` in an expression.
    SLASH,
    /// `^`
    CARET,
    /// `=`
    EQUAL,
    /// `<>`
    NOT_EQUAL,
    /// `<` in an expression.
    LESS,
    /// `<=`
    LESS_EQUAL,
    /// `>` in an expression.
    GREATER,
    /// `>=`
    GREATER_EQUAL,

    /// Characters that have no meaning where they are.
    ERROR,
    /// The end of the text. Never in a tree.
    EOF,

    // Nodes: the file and its logical lines.
    /// The root.
    SOURCE_FILE,
    /// A line that holds at least one wire, connector or block.
    RUNG,
    /// A line of `|`, white space and comments with at least one `|`.
    RAIL_LINE,
    /// A line of white space and comments with at least one comment.
    COMMENT_LINE,
    /// A line of white space.
    BLANK_LINE,
    /// `VAR_INPUT RETAIN`
    SECTION_HEADER,
    /// `start, stop : BOOL;`
    DECLARATION,
    /// `END_VAR`, `END_TYPE`
    SECTION_END,
    /// `Motor : STRUCT`
    STRUCT_HEADER,
    /// `END_STRUCT;`
    STRUCT_END,
    /// `FUNCTION_BLOCK [$Name]`
    BLOCK_HEADER,
    /// `END_FUNCTION_BLOCK`
    BLOCK_END,
    /// A line that holds nothing but errors.
    STRAY_LINE,
    /// A line of signs of a merge's conflict, or what of one is not read.
    CONFLICT_LINE,

    // Nodes: blocks.
    /// `[..](..)`
    LOGICAL_BLOCK,
    /// `(..)(..)`
    COIL_BLOCK,
    /// `<..>(..)`
    FUNCTION_BLOCK,
    /// The first part of a block, with its brackets.
    BLOCK_HEAD,
    /// The parentheses with the operands.
    OPERAND_LIST,
    /// `R := reset`, `FOUND => hit`.
    NAMED_OPERAND,

    // Nodes: expressions.
    /// A tag, label or function by name.
    NAME_EXPR,
    /// A direct address.
    ADDRESS_EXPR,
    /// A literal.
    LITERAL_EXPR,
    /// `t1.Q`, `word.3`
    MEMBER_EXPR,
    /// `a[i]`, `a[3..9]`, `a[i, 3]`
    INDEX_EXPR,
    /// `3..9` inside the brackets of an index.
    RANGE_EXPR,
    /// `-a`, `NOT a`
    UNARY_EXPR,
    /// `a + b`
    BINARY_EXPR,
    /// `( a )`
    PAREN_EXPR,
    /// `SQRT(a)`
    CALL_EXPR,
    /// `[1, 2, 3]` as an initial value; `4(0)` inside it is a CALL_EXPR on a literal.
    ARRAY_EXPR,
    /// `(speed := 20.0)` as an initial value; each member is a NAMED_OPERAND.
    STRUCT_EXPR,
    /// Tokens of an operand or declaration that fit nowhere.
    ERROR_NODE,

    // Nodes: declarations.
    /// `start, stop`
    NAME_LIST,
    /// `AT %IX0.0`
    AT_CLAUSE,
    /// `INT`, `STRING[80]`, `ARRAY[1..9] OF INT`, `(IDLE, FILLING)`, `INT(0..100)`
    TYPE_REF,
    /// `MIXING := 10` in the list of an enumeration.
    ENUM_VALUE,
    /// `:= 5`
    INITIAL_VALUE,
}

use SyntaxKind::{INITIAL_VALUE, SOURCE_FILE};

impl SyntaxKind {
    /// White space, line ends, comments and the byte order mark.
    pub const fn is_trivia(self) -> bool {
        matches!(
            self,
            Self::WHITESPACE | Self::NEWLINE | Self::COMMENT | Self::BOM | Self::CONFLICT
        )
    }

    /// Whether this is the kind of a block on a rung.
    pub const fn is_block(self) -> bool {
        matches!(
            self,
            SyntaxKind::LOGICAL_BLOCK | SyntaxKind::COIL_BLOCK | SyntaxKind::FUNCTION_BLOCK
        )
    }

    const ALL: [SyntaxKind; INITIAL_VALUE as usize + 1] = {
        use SyntaxKind::*;
        [
            WHITESPACE,
            NEWLINE,
            COMMENT,
            BOM,
            CONFLICT,
            WIRE,
            RAIL_CONNECTOR,
            RAIL,
            DOWN,
            UP,
            L_BRACKET,
            R_BRACKET,
            L_PAREN,
            R_PAREN,
            L_ANGLE,
            R_ANGLE,
            MNEMONIC,
            BLOCK_NAME,
            IDENT,
            KEYWORD,
            WORD_OPERATOR,
            LITERAL,
            STRING,
            ADDRESS,
            COMMA,
            COLON,
            SEMICOLON,
            ASSIGN,
            ARROW,
            DOT,
            DOT_DOT,
            PLUS,
            MINUS,
            STAR,
            SLASH,
            CARET,
            EQUAL,
            NOT_EQUAL,
            LESS,
            LESS_EQUAL,
            GREATER,
            GREATER_EQUAL,
            ERROR,
            EOF,
            SOURCE_FILE,
            RUNG,
            RAIL_LINE,
            COMMENT_LINE,
            BLANK_LINE,
            SECTION_HEADER,
            DECLARATION,
            SECTION_END,
            STRUCT_HEADER,
            STRUCT_END,
            BLOCK_HEADER,
            BLOCK_END,
            STRAY_LINE,
            CONFLICT_LINE,
            LOGICAL_BLOCK,
            COIL_BLOCK,
            FUNCTION_BLOCK,
            BLOCK_HEAD,
            OPERAND_LIST,
            NAMED_OPERAND,
            NAME_EXPR,
            ADDRESS_EXPR,
            LITERAL_EXPR,
            MEMBER_EXPR,
            INDEX_EXPR,
            RANGE_EXPR,
            UNARY_EXPR,
            BINARY_EXPR,
            PAREN_EXPR,
            CALL_EXPR,
            ARRAY_EXPR,
            STRUCT_EXPR,
            ERROR_NODE,
            NAME_LIST,
            AT_CLAUSE,
            TYPE_REF,
            ENUM_VALUE,
            INITIAL_VALUE,
        ]
    };

    /// The kind after a number that came out of a green node of this language.
    pub fn from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        Self::ALL.get(usize::from(raw.0)).copied().unwrap_or(SOURCE_FILE)
    }
}

impl From<SyntaxKind> for rowan::SyntaxKind {
    fn from(kind: SyntaxKind) -> Self {
        rowan::SyntaxKind(kind as u16)
    }
}

/// The tag that ties rowan's generic tree to [`SyntaxKind`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LadderLanguage {}

impl rowan::Language for LadderLanguage {
    type Kind = SyntaxKind;

    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        SyntaxKind::from_raw(raw)
    }

    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        kind.into()
    }
}

/// A node of the tree.
pub type SyntaxNode = rowan::SyntaxNode<LadderLanguage>;
/// A token of the tree.
pub type SyntaxToken = rowan::SyntaxToken<LadderLanguage>;

#[cfg(test)]
mod tests {
    use super::*;

    /// `ALL` is what turns a raw number back into a kind, so its order must be the enum's.
    #[test]
    fn raw_numbers_lead_back() {
        for (index, kind) in SyntaxKind::ALL.iter().enumerate() {
            assert_eq!(*kind as usize, index, "{kind:?}");
        }
    }
}
