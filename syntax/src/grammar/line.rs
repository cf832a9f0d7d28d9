//! One logical line: which kind it is, and the drawing on a rung.

use super::{Parser, block, declaration};
use crate::lexer::Context;
use crate::line::{LineKind, Mode};
use crate::{DeclarationProblem, SyntaxError, SyntaxErrorKind, SyntaxKind};
use rowan::GreenNodeBuilder;

/// What is known of a line once it is parsed. Its node went into the builder.
pub(crate) struct Parsed {
    pub(crate) kind: LineKind,
    pub(crate) end: usize,
    pub(crate) mode_after: Mode,
    pub(crate) downs: u32,
    pub(crate) ups: u32,
    pub(crate) errors: Vec<SyntaxError>,
}

/// Parses the logical line that begins at `start` and puts its node into the builder. `start` must not be the
/// end of the text; at least one character is taken.
pub(crate) fn line(text: &str, start: usize, mode: Mode, builder: &mut GreenNodeBuilder<'_>) -> Parsed {
    let checkpoint = builder.checkpoint();
    let mut p = Parser {
        text,
        start,
        at: start,
        builder,
        errors: Vec::new(),
        peeked: None,
        depth: 0,
        free_form: false,
        terms: 0,
    };
    let mut marks = Marks::default();
    let (kind, mode_after) = logical_line(&mut p, mode, &mut marks);
    p.start_node_at(checkpoint, kind.syntax_kind());
    p.finish_node();
    Parsed {
        kind,
        end: p.at,
        mode_after,
        downs: marks.downs,
        ups: marks.ups,
        errors: p.errors,
    }
}

/// What was met on a line so far.
#[derive(Default)]
struct Marks {
    downs: u32,
    ups: u32,
    comment: bool,
    rail: bool,
    drawing: bool,
    mistake: bool,
}

fn logical_line(p: &mut Parser<'_, '_, '_>, mode: Mode, marks: &mut Marks) -> (LineKind, Mode) {
    // A line that starts behind a `;` or END_VAR goes on on the same physical line.
    let at_line_start = p.at == 0 || p.text[..p.at].ends_with(['\n', '\r']);
    if p.at == 0 && p.text.starts_with('\u{feff}') {
        p.builder.token(SyntaxKind::BOM.into(), "\u{feff}");
        p.at = '\u{feff}'.len_utf8();
    }
    loop {
        match p.peek(Context::Rung) {
            SyntaxKind::WHITESPACE => p.bump(Context::Rung),
            SyntaxKind::COMMENT => {
                marks.comment = true;
                p.bump(Context::Rung);
            }
            SyntaxKind::NEWLINE => {
                p.bump(Context::Rung);
                return (empty_line(marks), mode);
            }
            SyntaxKind::EOF => return (empty_line(marks), mode),
            _ => break,
        }
    }
    if mode == Mode::Section {
        let first = p.peek(Context::Rung);
        let drawing = at_line_start
            && matches!(
                first,
                SyntaxKind::RAIL_CONNECTOR
                    | SyntaxKind::RAIL
                    | SyntaxKind::DOWN
                    | SyntaxKind::UP
                    | SyntaxKind::L_BRACKET
                    | SyntaxKind::L_ANGLE
            );
        match declaration::keyword_line(p) {
            Some(declaration::KeywordLine::SectionEnd) => {
                return declaration::section_end(p);
            }
            None if !drawing => return declaration::declaration(p),
            _ => p.error_here(
                SyntaxErrorKind::BadDeclaration(DeclarationProblem::SectionNotClosed),
                Context::Rung,
            ),
        }
    } else if !at_line_start && p.start > 0 {
        p.error_here(
            SyntaxErrorKind::BadDeclaration(DeclarationProblem::LineNotEnded),
            Context::Rung,
        );
    }
    match declaration::keyword_line(p) {
        Some(declaration::KeywordLine::Section) => declaration::section_header(p),
        Some(declaration::KeywordLine::SectionEnd) => {
            p.declaration_error(DeclarationProblem::EndWithoutSection);
            declaration::section_end(p)
        }
        Some(declaration::KeywordLine::Block) => declaration::block_header(p),
        Some(declaration::KeywordLine::BlockEnd) => declaration::block_end(p),
        None => (rung(p, marks), Mode::Network),
    }
}

fn empty_line(marks: &Marks) -> LineKind {
    if marks.comment {
        LineKind::Comment
    } else {
        LineKind::Blank
    }
}

/// The drawing on a line, up to its line end.
fn rung(p: &mut Parser<'_, '_, '_>, marks: &mut Marks) -> LineKind {
    loop {
        match p.peek(Context::Rung) {
            SyntaxKind::EOF => break,
            SyntaxKind::NEWLINE => {
                p.bump(Context::Rung);
                break;
            }
            SyntaxKind::WHITESPACE => p.bump(Context::Rung),
            SyntaxKind::COMMENT => {
                marks.comment = true;
                p.bump(Context::Rung);
            }
            SyntaxKind::RAIL => {
                marks.rail = true;
                p.bump(Context::Rung);
            }
            SyntaxKind::WIRE | SyntaxKind::RAIL_CONNECTOR => {
                marks.drawing = true;
                p.bump(Context::Rung);
            }
            SyntaxKind::DOWN => {
                marks.drawing = true;
                marks.downs += 1;
                p.bump(Context::Rung);
            }
            SyntaxKind::UP => {
                marks.drawing = true;
                marks.ups += 1;
                p.bump(Context::Rung);
            }
            open @ (SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN | SyntaxKind::L_ANGLE) => {
                marks.drawing = true;
                block::block(p, open);
            }
            _ => {
                marks.mistake = true;
                p.unexpected(Context::Rung, is_junk);
            }
        }
    }
    if marks.drawing {
        LineKind::Rung
    } else if marks.mistake {
        LineKind::Stray
    } else if marks.rail {
        LineKind::Rail
    } else {
        empty_line(marks)
    }
}

fn is_junk(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        SyntaxKind::IDENT
            | SyntaxKind::ERROR
            | SyntaxKind::R_BRACKET
            | SyntaxKind::R_PAREN
            | SyntaxKind::R_ANGLE
    )
}
