//! Sections of declarations (LANGUAGE §8 rule 8).

use crate::edit::Sink;
use crate::flat::{Node, Source};
use crate::pen::Pen;
use crate::pieces::{Piece, Pieces};
use crate::width::display_width;
use ladder_syntax::LineKind;
use ladder_syntax::SyntaxKind::*;
use std::ops::Range;

/// How far a declaration is in, and how much further a member of a structure.
const INDENT: u32 = 4;

/// The parts of a declaration, and with them the columns of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Widths {
    names: u32,
    /// `AT` and the address; 0 without.
    address: u32,
    /// The type.
    ty: u32,
    has_value: bool,
}

/// Where the parts of a run of declarations begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Columns {
    indent: u32,
    at: u32,
    colon: u32,
    assign: u32,
}

/// Writes a section that is whole and without errors.
pub(crate) fn write<S: Sink>(source: Source<'_>, lines: Range<usize>, pen: &mut Pen<'_, S>) {
    // The first of the blank lines after the last declaration or comment, which wait for the next one.
    let mut blank = None;
    // The columns of the run around a structure, and in one those of its members.
    let mut runs: [Option<Columns>; 2] = [None; 2];
    let mut level = 0;
    let mut may_part = false;
    for line in lines.clone() {
        let kind = source.kind(line);
        if kind == LineKind::Blank {
            runs[level] = None;
            blank = blank.or(may_part.then_some(line));
            continue;
        }
        let may_be_parted = matches!(
            kind,
            LineKind::Declaration | LineKind::StructHeader | LineKind::Comment
        );
        may_part = matches!(
            kind,
            LineKind::Declaration | LineKind::StructEnd | LineKind::Comment
        );
        if let Some(blank) = blank.take().filter(|_| may_be_parted) {
            end_line(source, blank, lines.end, pen);
        }
        let indent = INDENT * (level as u32 + 1);
        match kind {
            LineKind::Declaration | LineKind::StructHeader => {
                let columns =
                    *runs[level].get_or_insert_with(|| run_columns(source, line..lines.end, indent));
                declaration(source, line, columns, pen);
                if kind == LineKind::StructHeader {
                    level = 1;
                    runs[1] = None;
                }
            }
            LineKind::StructEnd => {
                level = 0;
                pen.blanks(INDENT);
                words(source, line, pen);
            }
            LineKind::Comment => {
                runs[level] = None;
                pen.blanks(indent);
                comment_line(source, line, pen);
            }
            _ => words(source, line, pen),
        }
        end_line(source, line, lines.end, pen);
    }
}

/// Ends a line of a section: with its own line end, or with a new one where more of the section is after it.
fn end_line<S: Sink>(source: Source<'_>, line: usize, section_end: usize, pen: &mut Pen<'_, S>) {
    let end = source.range(line).end;
    match source.line_end(line) {
        Some(line_end) => pen.keep(line_end, end),
        None if line + 1 < section_end => pen.split_line(end),
        None => {}
    }
}

/// A line of words with comments after it: the first or last line of a section or of a block definition.
pub(crate) fn words<S: Sink>(source: Source<'_>, line: usize, pen: &mut Pen<'_, S>) {
    let node = source.line(line);
    let is_word = |child: &Node<'_>| !child.kind().is_trivia();
    let after = node
        .children()
        .filter(is_word)
        .last()
        .map_or(node.start(), Node::end);
    let mut pieces = Pieces::new(source.text, false, |piece| write_piece(pen, piece));
    for child in node.children().take_while(|child| child.start() < after) {
        if is_word(&child) || child.kind() == COMMENT {
            pieces.node(child);
        }
    }
    comments_after(source, line, after, pen);
}

/// A line that holds nothing but comments, from where the pen is.
pub(crate) fn comment_line<S: Sink>(source: Source<'_>, line: usize, pen: &mut Pen<'_, S>) {
    let comments = source
        .line(line)
        .children()
        .filter(|child| child.kind() == COMMENT);
    for (n, comment) in comments.enumerate() {
        if n > 0 {
            pen.blanks(2);
        }
        pen.keep(comment.start(), comment.end());
    }
}

/// The comments of a line that are after a place, two blanks before each.
pub(crate) fn comments_after<S: Sink>(source: Source<'_>, line: usize, after: usize, pen: &mut Pen<'_, S>) {
    if !source.has_comment(line) {
        return;
    }
    for child in source.line(line).children() {
        if child.kind() == COMMENT && child.start() >= after {
            pen.blanks(2);
            pen.keep(child.start(), child.end());
        }
    }
}

/// Writes a piece with the blanks before it.
pub(crate) fn write_piece<S: Sink>(pen: &mut Pen<'_, S>, piece: Piece) {
    pen.blanks(piece.blanks);
    if piece.capitals {
        pen.keep_in_capitals(piece.start, piece.end);
    } else {
        pen.keep(piece.start, piece.end);
    }
}

/// The columns of the run of declarations that the first of some lines begins. The members of a structure do not part the run
/// that it is in.
fn run_columns(source: Source<'_>, lines: Range<usize>, indent: u32) -> Columns {
    let mut widest = Widths::default();
    let mut is_in_struct = false;
    for line in lines {
        match source.kind(line) {
            LineKind::StructEnd if is_in_struct => is_in_struct = false,
            _ if is_in_struct => continue,
            LineKind::StructHeader => is_in_struct = true,
            LineKind::Declaration => {}
            _ => break,
        }
        let widths = measure(source.text, source.line(line));
        widest.names = widest.names.max(widths.names);
        widest.address = widest.address.max(widths.address);
        if widths.has_value {
            widest.ty = widest.ty.max(widths.ty);
        }
    }
    let at = indent + widest.names + 1;
    let colon = if widest.address > 0 {
        at + widest.address + 1
    } else {
        at
    };
    Columns {
        indent,
        at,
        colon,
        assign: colon + 2 + widest.ty + 1,
    }
}

fn measure(text: &str, declaration: Node<'_>) -> Widths {
    let mut widths = Widths::default();
    for part in declaration.children() {
        let width = match part.kind() {
            NAME_LIST => &mut widths.names,
            AT_CLAUSE => &mut widths.address,
            TYPE_REF => &mut widths.ty,
            INITIAL_VALUE => {
                widths.has_value = true;
                continue;
            }
            _ => continue,
        };
        Pieces::new(text, false, |piece| {
            *width += piece.blanks + display_width(&text[piece.start..piece.end]);
        })
        .node(part);
    }
    widths
}

fn declaration<S: Sink>(source: Source<'_>, line: usize, columns: Columns, pen: &mut Pen<'_, S>) {
    let text = source.text;
    let node = source.line(line);
    let mut column = 0;
    let mut after = node.start();
    for part in node.children() {
        let place = match part.kind() {
            NAME_LIST => columns.indent,
            AT_CLAUSE => columns.at,
            COLON => columns.colon,
            // `STRUCT` is in the place of a type.
            TYPE_REF | KEYWORD => columns.colon + 2,
            INITIAL_VALUE => columns.assign,
            SEMICOLON => column,
            _ => continue,
        };
        pen.blanks(place - column);
        column = place;
        if part.is_node() {
            Pieces::new(text, false, |piece| {
                column += piece.blanks + display_width(&text[piece.start..piece.end]);
                write_piece(pen, piece);
            })
            .node(part);
        } else if part.kind() == KEYWORD {
            pen.keep_in_capitals(part.start(), part.end());
            column += display_width(&text[part.start()..part.end()]);
        } else {
            pen.keep(part.start(), part.end());
            column += 1;
        }
        after = part.end();
    }
    comments_after(source, line, after, pen);
}
