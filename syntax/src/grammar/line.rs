//! One logical line: which kind it is, and the drawing on a rung.

use super::declaration::KeywordLine;
use super::{Parser, block, declaration};
use crate::builder::Builder;
use crate::conflict::{OpenConflicts, Within};
use crate::error::{DeclarationProblem, Many, Surroundings, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::lexer;
use crate::line::{LineKind, Mode, ReadLine};
use crate::line_index::line_ends;
use rowan::TextSize;

/// What a line's parse depends on besides its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Entry {
    /// Whether a section is open.
    pub(crate) mode: Mode,
    /// A logical line ended before it on the same physical line (after a `;` or END_VAR).
    pub(crate) mid_line: bool,
    /// The conflicts that are open.
    pub(crate) open: OpenConflicts,
}

impl Entry {
    /// The start of a text.
    pub(crate) const START: Entry = Entry {
        mode: Mode::Network,
        mid_line: false,
        open: OpenConflicts { git: 0, comment: 0 },
    };
}

/// Parses the logical line that begins at `start`. `start` must not be the end of the text; at least one
/// character is taken.
pub(crate) fn line<B: Builder>(text: &str, start: usize, entry: Entry, builder: &mut B) -> ReadLine<B::Line> {
    let mut p = Parser::new(text, start, entry.open, builder);
    let mut marks = Marks::default();
    let (kind, mode_after) = logical_line(&mut p, entry, &mut marks);
    drop_swallowed(&mut p);
    ReadLine {
        kind,
        mode_after,
        downs: marks.downs,
        ups: marks.ups,
        len: (p.at - start) as u32,
        line_ends: line_ends(&text.as_bytes()[start..p.at]).count() as u32,
        has_line_end: matches!(text.as_bytes()[p.at - 1], b'\n' | b'\r'),
        commented: p.last_comment.is_some(),
        in_conflict: entry.open.any() || p.met_conflict,
        open_after: p.open,
        node: p.builder.finish_line(kind.syntax_kind()),
        errors: p.errors.into(),
    }
}

/// Where a comment is never closed, what is missing right before it may be in it: only the comment is reported.
fn drop_swallowed<B: Builder>(p: &mut Parser<'_, '_, B>) {
    if !p
        .errors
        .iter()
        .any(|e| e.kind == SyntaxErrorKind::UnclosedComment)
    {
        return;
    }
    let end = TextSize::new((p.last_end - p.start) as u32);
    p.errors.retain(|error| match error.kind {
        SyntaxErrorKind::UnclosedBlock { .. }
        | SyntaxErrorKind::MissingOperand { .. }
        | SyntaxErrorKind::BadDeclaration(_) => error.range.end() < end,
        _ => true,
    });
}

/// What was met on a line so far.
#[derive(Default)]
struct Marks {
    downs: u32,
    ups: u32,
    comment: bool,
    rail: bool,
    drawing: bool,
    error: bool,
}

fn logical_line<B: Builder>(p: &mut Parser<'_, '_, B>, entry: Entry, marks: &mut Marks) -> (LineKind, Mode) {
    const BOM: &str = "\u{feff}";
    let mode = entry.mode;
    if p.at == 0 && p.text.starts_with(BOM) {
        p.token((SyntaxKind::BOM, BOM.len()));
    }
    if !entry.mid_line && p.conflict(Within::Nothing) {
        return (LineKind::Conflict, mode);
    }
    while let Some(token) = lexer::space(p.text, p.at, p.open) {
        p.token(token);
        match token.0 {
            SyntaxKind::COMMENT => marks.comment = true,
            SyntaxKind::NEWLINE => return (empty_line(marks), mode),
            _ => {}
        }
    }
    if p.at == p.text.len() {
        return (empty_line(marks), mode);
    }
    let keyword = declaration::keyword_at(p.text, p.at);
    if mode.is_in_section() {
        let drawing = !entry.mid_line && declaration::begins_drawing(p.byte(p.at));
        match keyword {
            Some(KeywordLine::SectionEnd) => {
                if let Some(problem) = declaration::wrong_end(p, mode) {
                    misplaced(p, problem);
                }
                return declaration::section_end(p);
            }
            Some(KeywordLine::StructEnd) => {
                if !matches!(mode, Mode::Struct { .. }) {
                    misplaced(p, DeclarationProblem::EndWithoutSection);
                }
                return declaration::struct_end(p, mode);
            }
            None if !drawing => return declaration::declaration(p, mode),
            _ => misplaced(p, mode.not_closed()),
        }
    } else if let Some(KeywordLine::SectionEnd | KeywordLine::StructEnd) = keyword {
        misplaced(p, DeclarationProblem::EndWithoutSection);
        return match keyword {
            Some(KeywordLine::SectionEnd) => declaration::section_end(p),
            _ => declaration::struct_end(p, mode),
        };
    } else if entry.mid_line {
        misplaced(p, DeclarationProblem::LineNotEnded);
    }
    match keyword {
        Some(KeywordLine::Section) => declaration::section_header(p),
        Some(KeywordLine::SectionEnd | KeywordLine::StructEnd) => declaration::section_end(p),
        Some(KeywordLine::Block) => declaration::block_header(p),
        Some(KeywordLine::BlockEnd) => declaration::block_end(p),
        None => (rung(p, marks), Mode::Network),
    }
}

/// Records that the keyword or the piece of drawing that begins here does not belong here.
fn misplaced<B: Builder>(p: &mut Parser<'_, '_, B>, problem: DeclarationProblem) {
    let end = lexer::identifier_end(p.text, p.at).unwrap_or_else(|| lexer::on_rung(p.text, p.at, p.open).1);
    p.error(SyntaxErrorKind::BadDeclaration(problem), p.at, end);
}

fn empty_line(marks: &Marks) -> LineKind {
    if marks.comment {
        LineKind::Comment
    } else {
        LineKind::Blank
    }
}

/// The drawing on a line, up to its line end.
fn rung<B: Builder>(p: &mut Parser<'_, '_, B>, marks: &mut Marks) -> LineKind {
    let mut parts = 0;
    loop {
        let token = lexer::on_rung(p.text, p.at, p.open);
        if !matches!(
            token.0,
            SyntaxKind::EOF | SyntaxKind::NEWLINE | SyntaxKind::WHITESPACE
        ) {
            parts += 1;
            if parts > Many::Parts.most() {
                marks.error = true;
                rest_of_line(p);
                continue;
            }
        }
        match token.0 {
            SyntaxKind::EOF => break,
            SyntaxKind::NEWLINE => {
                p.token(token);
                break;
            }
            SyntaxKind::WHITESPACE => p.token(token),
            SyntaxKind::WIRE | SyntaxKind::RAIL_CONNECTOR => {
                marks.drawing = true;
                p.token(token);
            }
            open @ (SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN | SyntaxKind::L_ANGLE) => {
                marks.drawing = true;
                block::block(p, open);
            }
            SyntaxKind::RAIL => {
                marks.rail = true;
                p.token(token);
            }
            SyntaxKind::DOWN => {
                marks.drawing = true;
                marks.downs += 1;
                p.token(token);
            }
            SyntaxKind::UP => {
                marks.drawing = true;
                marks.ups += 1;
                p.token(token);
            }
            SyntaxKind::COMMENT => {
                marks.comment = true;
                p.token(token);
            }
            // Words, stray characters, closing brackets.
            _ => {
                marks.error = true;
                let from = p.at;
                p.token((SyntaxKind::ERROR, token.1));
                p.unexpected(Surroundings::Rung, from, token.1);
            }
        }
    }
    if marks.drawing {
        LineKind::Rung
    } else if marks.error {
        LineKind::Stray
    } else if marks.rail {
        LineKind::Rail
    } else {
        empty_line(marks)
    }
}

/// Takes what is left of a line that holds too many parts, as one error.
fn rest_of_line<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let from = p.at;
    let end = memchr::memchr2(b'\n', b'\r', &p.text.as_bytes()[from..]);
    let end = end.map_or(p.text.len(), |end| from + end);
    p.token((SyntaxKind::ERROR, end));
    p.error(SyntaxErrorKind::TooMany(Many::Parts), from, end);
}
