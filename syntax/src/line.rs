//! The logical line: what is parsed on its own, and the small summary from which networks are grouped.

use crate::conflict::OpenConflicts;
use crate::error::{DeclarationProblem, SyntaxError};
use crate::kind::SyntaxKind;

/// What a logical line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineKind {
    /// At least one wire, connector or block.
    Rung,
    /// `|`, white space, comments.
    Rail,
    /// White space and comments.
    Comment,
    /// White space only.
    Blank,
    /// `VAR_INPUT`, ...
    SectionHeader,
    /// One declaration, up to its `;`.
    Declaration,
    /// `END_VAR`, `END_TYPE`.
    SectionEnd,
    /// `Motor : STRUCT`.
    StructHeader,
    /// `END_STRUCT;`.
    StructEnd,
    /// `FUNCTION_BLOCK [$Name]`.
    BlockHeader,
    /// `END_FUNCTION_BLOCK`.
    BlockEnd,
    /// Nothing but errors.
    Stray,
    /// A line of signs of a merge's conflict, or what of one is not read.
    Conflict,
}

impl LineKind {
    /// The kind of the line's node.
    pub const fn syntax_kind(self) -> SyntaxKind {
        match self {
            LineKind::Rung => SyntaxKind::RUNG,
            LineKind::Rail => SyntaxKind::RAIL_LINE,
            LineKind::Comment => SyntaxKind::COMMENT_LINE,
            LineKind::Blank => SyntaxKind::BLANK_LINE,
            LineKind::SectionHeader => SyntaxKind::SECTION_HEADER,
            LineKind::Declaration => SyntaxKind::DECLARATION,
            LineKind::SectionEnd => SyntaxKind::SECTION_END,
            LineKind::StructHeader => SyntaxKind::STRUCT_HEADER,
            LineKind::StructEnd => SyntaxKind::STRUCT_END,
            LineKind::BlockHeader => SyntaxKind::BLOCK_HEADER,
            LineKind::BlockEnd => SyntaxKind::BLOCK_END,
            LineKind::Stray => SyntaxKind::STRAY_LINE,
            LineKind::Conflict => SyntaxKind::CONFLICT_LINE,
        }
    }

    /// Rail, comment and blank lines, and those of conflicts: between the rungs of a network they do not count.
    pub const fn is_decoration(self) -> bool {
        matches!(
            self,
            LineKind::Rail | LineKind::Comment | LineKind::Blank | LineKind::Conflict
        )
    }
}

/// What surrounds a line: all that a line's parse depends on besides its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Mode {
    /// Between sections.
    #[default]
    Network,
    /// Between the header of a VAR section and its END_VAR.
    Section,
    /// Between TYPE and END_TYPE.
    Types,
    /// Between STRUCT and END_STRUCT.
    Struct {
        /// So many more are open around it, which none should be.
        around: u8,
        /// Whether the section around it is TYPE, as it should be.
        in_types: bool,
    },
}

impl Mode {
    /// Whether a section is open.
    pub const fn is_in_section(self) -> bool {
        !matches!(self, Mode::Network)
    }

    /// Whether the section that is open, if one is, is closed by END_TYPE.
    pub(crate) const fn is_in_types(self) -> bool {
        matches!(self, Mode::Types | Mode::Struct { in_types: true, .. })
    }

    /// What is wrong where the section ends without its end.
    pub(crate) const fn not_closed(self) -> DeclarationProblem {
        match self {
            Mode::Struct { .. } => DeclarationProblem::StructNotClosed,
            Mode::Types => DeclarationProblem::TypesNotClosed,
            Mode::Section | Mode::Network => DeclarationProblem::SectionNotClosed,
        }
    }

    /// Within a STRUCT that begins here.
    pub(crate) const fn opened(self) -> Mode {
        match self {
            Mode::Struct { around, in_types } => Mode::Struct {
                around: around.saturating_add(1),
                in_types,
            },
            other => Mode::Struct {
                around: 0,
                in_types: matches!(other, Mode::Types),
            },
        }
    }

    /// After the END_STRUCT that closes what is open.
    pub(crate) const fn closed(self) -> Mode {
        match self {
            Mode::Struct {
                around: 0,
                in_types: true,
            } => Mode::Types,
            Mode::Struct {
                around: 0,
                in_types: false,
            } => Mode::Section,
            Mode::Struct { around, in_types } => Mode::Struct {
                around: around - 1,
                in_types,
            },
            other => other,
        }
    }
}

/// A parsed logical line. It may begin in the middle of a physical line (after a `;` of a declaration) and may
/// span several (a comment or a declaration that does). `N` is what its [`Builder`](crate::Builder) made of its
/// tokens; in a [`Line`](crate::Line) what makes its tree when that is asked for.
#[derive(Debug, Clone)]
pub struct ReadLine<N> {
    /// What it is.
    pub kind: LineKind,
    /// The mode of the line after it.
    pub mode_after: Mode,
    /// Number of `\` on it.
    pub downs: u32,
    /// Number of `/` connectors on it.
    pub ups: u32,
    /// Length in bytes, line end included.
    pub len: u32,
    /// Its errors, counted from its start.
    pub errors: Box<[SyntaxError]>,
    /// How many physical lines end on it: none, one, or more where a comment or a declaration spans them.
    pub line_ends: u32,
    /// Whether a line end is its last token. Else another line begins on the same physical line, or the text
    /// ends.
    pub(crate) has_line_end: bool,
    /// Whether a comment is on it, or begins on it.
    pub(crate) commented: bool,
    /// Whether it belongs to a merge's conflict, ours included.
    pub(crate) in_conflict: bool,
    /// The conflicts that are open after it.
    pub(crate) open_after: OpenConflicts,
    pub(crate) node: N,
}

impl<N> ReadLine<N> {
    /// What the builder made of it.
    pub fn node(&self) -> &N {
        &self.node
    }

    /// Whether a comment is on it, or begins on it.
    pub fn is_commented(&self) -> bool {
        self.commented
    }

    /// Whether it belongs to a merge's conflict, ours included; after one that is not finished all lines do.
    pub fn is_in_conflict(&self) -> bool {
        self.in_conflict
    }

    /// The line with something else made of it.
    pub(crate) fn with_node<M>(self, node: M) -> ReadLine<M> {
        ReadLine {
            kind: self.kind,
            mode_after: self.mode_after,
            downs: self.downs,
            ups: self.ups,
            len: self.len,
            errors: self.errors,
            line_ends: self.line_ends,
            has_line_end: self.has_line_end,
            commented: self.commented,
            in_conflict: self.in_conflict,
            open_after: self.open_after,
            node,
        }
    }
}
