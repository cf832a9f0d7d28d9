//! Sections of declarations (LANGUAGE §8 rule 8).

use crate::edit::Sink;
use crate::pen::Pen;
use crate::pieces::{Piece, Pieces};
use crate::read::each_child;
use crate::width::display_width;
use ladder_syntax::SyntaxKind::{self, *};
use ladder_syntax::{Line, LineKind, Parse};
use std::ops::Range;

/// How far a declaration stands in.
const INDENT: u32 = 4;

/// The parts of a declaration, and with them the columns of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Widths {
    names: u32,
    /// `AT` and the address; 0 without.
    address: u32,
    /// The type.
    ty: u32,
    has_value: bool,
}

/// Where the parts of a section's declarations begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Columns {
    at: u32,
    colon: u32,
    assign: u32,
}

/// Writes a section that is whole and without mistakes.
pub(crate) fn write<S: Sink>(text: &str, parse: &Parse, lines: Range<usize>, pen: &mut Pen<'_, S>) {
    let columns = columns(text, parse, lines.clone());
    let mut blank_before = false;
    for index in lines.clone() {
        let line = &parse.lines()[index];
        let start = usize::from(parse.line_start(index));
        let end = start + line.len as usize;
        let blank = line.kind == LineKind::Blank;
        if blank && blank_before {
            continue;
        }
        blank_before = blank;
        match line.kind {
            LineKind::Declaration => declaration(text, line, start, columns, pen),
            LineKind::SectionHeader | LineKind::SectionEnd => words(text, line, start, pen),
            LineKind::Comment => comments(line, start, 0, pen),
            _ => {}
        }
        match line_end_of(text, start, end) {
            Some(line_end) => pen.keep(line_end, end),
            None if index + 1 < lines.end => pen.line_end(line_end_near(text, end)),
            None => {}
        }
    }
}

/// A line of words with comments behind it: the first or last line of a section or of a block definition.
pub(crate) fn words<S: Sink>(text: &str, line: &Line, start: usize, pen: &mut Pen<'_, S>) {
    let mut pieces = Pieces::new(text, start, false, |piece| write_piece(pen, piece));
    let mut behind = start;
    each_child(line, start, |kind, node, from, to| {
        if kind.is_trivia() {
            return;
        }
        match node {
            Some(node) => pieces.node(node, from),
            None => pieces.token(kind, from, to, line.green()),
        }
        behind = to;
    });
    comments(line, start, behind, pen);
}

/// The comments of a line that stand behind a place: two blanks before each, but none before the first of a
/// line that holds only comments (`behind` 0).
pub(crate) fn comments<S: Sink>(line: &Line, start: usize, behind: usize, pen: &mut Pen<'_, S>) {
    let mut first = behind == 0;
    each_child(line, start, |kind, _, from, to| {
        if kind == COMMENT && from >= behind {
            if !first {
                pen.blanks(2);
            }
            first = false;
            pen.keep(from, to);
        }
    });
}

fn write_piece<S: Sink>(pen: &mut Pen<'_, S>, piece: Piece) {
    pen.blanks(piece.blanks);
    if piece.capitals {
        pen.keep_in_capitals(piece.start, piece.end);
    } else {
        pen.keep(piece.start, piece.end);
    }
}

fn columns(text: &str, parse: &Parse, lines: Range<usize>) -> Columns {
    let mut widest = Widths::default();
    for index in lines {
        let line = &parse.lines()[index];
        if line.kind == LineKind::Declaration {
            let widths = measure(text, line, parse.line_start(index).into());
            widest.names = widest.names.max(widths.names);
            widest.address = widest.address.max(widths.address);
            if widths.has_value {
                widest.ty = widest.ty.max(widths.ty);
            }
        }
    }
    let at = INDENT + widest.names + 1;
    let colon = if widest.address > 0 {
        at + widest.address + 1
    } else {
        at
    };
    Columns {
        at,
        colon,
        assign: colon + 2 + widest.ty + 1,
    }
}

fn measure(text: &str, line: &Line, start: usize) -> Widths {
    let mut widths = Widths::default();
    each_child(line, start, |kind, node, from, _| {
        let Some(node) = node else { return };
        let mut width = 0;
        Pieces::new(text, from, false, |piece| {
            width += piece.blanks + display_width(&text[piece.start..piece.end]);
        })
        .node(node, from);
        match kind {
            NAME_LIST => widths.names = width,
            AT_CLAUSE => widths.address = width,
            TYPE_REF => widths.ty = width,
            INITIAL_VALUE => widths.has_value = true,
            _ => {}
        }
    });
    widths
}

fn declaration<S: Sink>(text: &str, line: &Line, start: usize, columns: Columns, pen: &mut Pen<'_, S>) {
    let mut column = 0;
    let mut behind = start;
    each_child(line, start, |kind: SyntaxKind, node, from, to| {
        let place = match kind {
            NAME_LIST => INDENT,
            AT_CLAUSE => columns.at,
            COLON => columns.colon,
            TYPE_REF => columns.colon + 2,
            INITIAL_VALUE => columns.assign,
            SEMICOLON => column,
            _ => return,
        };
        pen.blanks(place - column);
        column = place;
        if let Some(node) = node {
            Pieces::new(text, from, false, |piece| {
                column += piece.blanks + display_width(&text[piece.start..piece.end]);
                write_piece(pen, piece);
            })
            .node(node, from);
        } else {
            pen.keep(from, to);
            column += 1;
        }
        behind = to;
    });
    comments(line, start, behind, pen);
}

/// Where the line end begins that a line has behind it, if it has one.
pub(crate) fn line_end_of(text: &str, start: usize, end: usize) -> Option<usize> {
    let line = &text[start..end];
    let length = if line.ends_with("\r\n") {
        2
    } else if line.ends_with(['\n', '\r']) {
        1
    } else {
        return None;
    };
    Some(end - length)
}

/// The line end of the physical line around a place; where the last line has none, the one before it.
pub(crate) fn line_end_near(text: &str, at: usize) -> &str {
    let at_end = |from: usize| {
        let rest = &text[from..];
        if rest.starts_with("\r\n") {
            &rest[..2]
        } else {
            &rest[..1]
        }
    };
    if let Some(n) = text[at..].find(['\n', '\r']) {
        return at_end(at + n);
    }
    match text[..at].rfind(['\n', '\r']) {
        Some(n) if n > 0 && text[..=n].ends_with("\r\n") => "\r\n",
        Some(n) => at_end(n),
        None => "\n",
    }
}
