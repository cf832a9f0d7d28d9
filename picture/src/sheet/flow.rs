//! What follows what on the pages.

use super::super::paper::Paper;
use super::super::shapes::{Anchor, At, Block, BlockKind, Extent, Form, Picture, Role, Shape};
use super::super::style::{LINE, Look, MARGIN, UNIT};
use super::super::symbol::width;
use super::super::wrap::paragraph;
use super::cut::{Along, cut, stretch};
use super::declarations::{Group, groups};
use super::pages::{FULL, Pages, SMALLEST, Strip};
use super::table::Table;
use ladder_analysis::context::Context;
use std::collections::HashMap;
use std::ops::Range;

/// Points above a network, a heading or a comment of its own.
pub(super) const APART: f32 = 14.0;
/// Pixels at the end of a wire that is cut, for its number.
const MARK: i32 = 36;
/// A network is cut into so many parts at most.
const MOST_PARTS: usize = 400;
/// Points between a network and its title.
pub(super) const CLOSE: f32 = 3.0;

/// Fills the pages: what the file says of itself, its declarations, its networks.
pub(super) fn fill(pages: &mut Pages, context: &Context, picture: &Picture) {
    let mut notes = HashMap::new();
    let mut rest: Vec<&Block> = Vec::new();
    let mut first_section = None;
    for block in &picture.blocks {
        if let BlockKind::Declarations { section, noted } = block.kind {
            first_section = first_section.or(Some(rest.len()));
            if noted && let Some(BlockKind::Comment(lines)) = rest.pop().map(|note| &note.kind) {
                first_section = first_section.map(|first| first.min(rest.len()));
                notes.insert(section, lines.as_slice());
            }
            continue;
        }
        rest.push(block);
    }
    // Comments above the first declarations are about the whole file.
    let above = first_section.unwrap_or(0);
    let is_comment = |block: &&&Block| matches!(block.kind, BlockKind::Comment(_));
    let head = rest[..above].iter().take_while(is_comment).count();
    let head = if head == above { above } else { 0 };
    for block in &rest[..head] {
        if let BlockKind::Comment(lines) = &block.kind {
            comment(pages, lines, APART);
        }
    }
    declarations(pages, &groups(context), &notes);
    networks(pages, picture, &rest[head..]);
}

/// A line of text in full size.
pub(super) fn text(pages: &Pages, look: Look, told: &str, above: f32) -> Strip {
    let mut paper = Paper::default();
    paper.text(look, (0, LINE - 4), Anchor::Start, width(told), told);
    Strip::of((paper.into_shapes(), LINE), pages.pixels(), above)
}

/// The lines of a comment, none longer than a page is wide.
fn comment_strips(pages: &Pages, lines: &[String], above: f32) -> Vec<Strip> {
    let lines = paragraph(lines, pages.columns());
    let strips = lines.iter().enumerate().map(|(number, line)| {
        let above = if number == 0 { above } else { 0.0 };
        text(pages, Look::Comment, line, above)
    });
    strips.collect()
}

fn comment(pages: &mut Pages, lines: &[String], above: f32) {
    for strip in comment_strips(pages, lines, above) {
        place(pages, strip);
    }
}

/// Places a strip, on the next page if it does not fit onto this one.
pub(super) fn place(pages: &mut Pages, strip: Strip) {
    if !pages.has_room(&[&strip]) {
        pages.turn();
    }
    pages.place(strip);
}

/// Places strips on one page, if one can hold them.
fn place_in_order(pages: &mut Pages, strips: Vec<Strip>) {
    if !pages.has_room(&strips.iter().collect::<Vec<_>>()) {
        pages.turn();
    }
    for strip in strips {
        place(pages, strip);
    }
}

fn declarations(pages: &mut Pages, groups: &[Group], notes: &HashMap<usize, &[String]>) {
    if groups.is_empty() {
        return;
    }
    let table = Table::new(groups, pages.columns());
    let wide = pages.pixels();
    let mut first = vec![
        text(pages, Look::Name, "Declarations", APART),
        Strip::of(table.header(), wide, CLOSE),
    ];
    for group in groups {
        let mut together = std::mem::take(&mut first);
        together.push(text(pages, Look::Name, &group.heading, APART / 2.0));
        let note = group.section.and_then(|section| notes.get(&section));
        if let Some(lines) = note {
            together.extend(comment_strips(pages, lines, 0.0));
        }
        let rows = group.rows.iter().flat_map(|row| table.row(row));
        let mut rows = rows.map(|row| Strip::of(row, wide, 0.0));
        together.extend(rows.next());
        if !pages.has_room(&together.iter().collect::<Vec<_>>()) {
            pages.turn();
            together.insert(0, Strip::of(table.header(), wide, 0.0));
        }
        place_in_order(pages, together);
        for row in rows {
            if !pages.has_room(&[&row]) {
                pages.turn();
                pages.place(Strip::of(table.header(), wide, 0.0));
                let goes_on = format!("{} (continued)", group.heading);
                pages.place(text(pages, Look::Name, &goes_on, APART / 2.0));
            }
            pages.place(row);
        }
    }
}

/// The networks with what is between them.
fn networks(pages: &mut Pages, picture: &Picture, blocks: &[&Block]) {
    let scale = common_scale(pages, blocks);
    let mut title: Option<&[String]> = None;
    for block in blocks {
        match &block.kind {
            BlockKind::Comment(lines) => {
                if let Some(before) = title.replace(lines) {
                    comment(pages, before, APART);
                }
            }
            BlockKind::Heading => {
                if let Some(before) = title.take() {
                    comment(pages, before, APART);
                }
                let strip = Strip {
                    shapes: picture.shapes[block.shapes.clone()].to_vec(),
                    window: window(block),
                    scale: FULL,
                    above: APART,
                };
                place(pages, strip);
            }
            BlockKind::Network { index, line } => {
                let label = Label {
                    number: index + 1,
                    line: *line,
                };
                network(
                    pages,
                    picture,
                    block,
                    label,
                    title.take().unwrap_or_default(),
                    scale,
                );
            }
            BlockKind::Declarations { .. } => {}
        }
    }
    if let Some(before) = title {
        comment(pages, before, APART);
    }
}

/// One scale for all networks that can be made to fit the page by it.
fn common_scale(pages: &Pages, blocks: &[&Block]) -> f32 {
    let networks = blocks
        .iter()
        .filter(|block| matches!(block.kind, BlockKind::Network { .. }));
    let widths = networks.map(|block| wide(&window(block)) as f32);
    let most = pages.width() / SMALLEST;
    let widest = widths.filter(|&width| width <= most).fold(1.0, f32::max);
    (pages.width() / widest).clamp(SMALLEST, FULL)
}

/// The part of the plane that a block takes, with the width of its lines.
fn window(block: &Block) -> Extent {
    Extent {
        left: MARGIN,
        top: block.rows.start - 2,
        right: block.right + 4,
        bottom: block.rows.end + 2,
    }
}

const fn wide(window: &Extent) -> i32 {
    window.right - window.left
}

/// What a network is called.
#[derive(Clone, Copy)]
struct Label {
    number: usize,
    /// The line of the file, from 1.
    line: usize,
}

impl Label {
    fn strip(self, pages: &Pages, more: &str, above: f32) -> Strip {
        let name = format!("Network {}{more}", self.number);
        let line = format!("line {}", self.line);
        let mut paper = Paper::default();
        paper.text(Look::Name, (0, LINE - 4), Anchor::Start, width(&name), &name);
        let at = (width(&name) + 2 * UNIT, LINE - 4);
        paper.text(Look::Pin, at, Anchor::Start, width(&line), &line);
        Strip::of((paper.into_shapes(), LINE), pages.pixels(), above)
    }
}

fn network(pages: &mut Pages, picture: &Picture, block: &Block, label: Label, title: &[String], scale: f32) {
    let shapes = &picture.shapes[block.shapes.clone()];
    let whole = window(block);
    let mut head = vec![label.strip(pages, "", APART)];
    head.extend(comment_strips(pages, title, 0.0));
    // What a page has left below what is above the network, unless that fills a page itself.
    let above = Pages::needed(&head.iter().collect::<Vec<_>>());
    let above = if above < pages.height() / 2.0 { above } else { 0.0 };
    let room = pages.height() - above - CLOSE - 1.0;
    let high = (whole.bottom - whole.top) as f32;
    let scale = if high * scale > room && high * SMALLEST <= room {
        room / high
    } else {
        scale
    };
    let width = whole.left..whole.right;
    let next_to = match (pages.width() / scale) as i32 {
        limit if wide(&whole) <= limit => vec![width],
        limit => cut(shapes, Along::Width, width, limit - 2 * MARK),
    };
    let below = cut(
        shapes,
        Along::Height,
        whole.top..whole.bottom,
        (room / scale) as i32,
    );
    let parts = next_to.len().saturating_mul(below.len());
    if parts > MOST_PARTS {
        let told =
            format!("Its drawing would take {parts} pages, and that of a network has at most {MOST_PARTS}.");
        head.push(text(pages, Look::Text, &told, CLOSE));
        place_in_order(pages, head);
        return;
    }
    if parts == 1 {
        head.push(Strip {
            shapes: shapes.to_vec(),
            window: whole,
            scale,
            above: CLOSE,
        });
        place_in_order(pages, head);
        return;
    }
    let tiles = tiles(shapes, &next_to, &below);
    let count = tiles.len();
    let mut tiles = tiles.into_iter().map(|(shapes, window)| Strip {
        shapes,
        window,
        scale,
        above: CLOSE,
    });
    head.extend(tiles.next());
    place_in_order(pages, head);
    for (number, tile) in tiles.enumerate() {
        let more = format!(", part {} of {count}", number + 2);
        let label = label.strip(pages, &more, APART / 2.0);
        place_in_order(pages, vec![label, tile]);
    }
}

/// The pieces of a drawing, strip by strip: what each shows, and its window. Wires that are cut have the same number at
/// both ends.
fn tiles(shapes: &[Shape], next_to: &[Range<i32>], below: &[Range<i32>]) -> Vec<(Vec<Shape>, Extent)> {
    let mut tiles = Vec::with_capacity(next_to.len() * below.len());
    for (column, columns) in next_to.iter().enumerate() {
        let is_last = column + 1 == next_to.len();
        for rows in below {
            let window = Extent {
                left: columns.start - if column > 0 { MARK } else { 0 },
                top: rows.start,
                right: columns.end + if is_last { 0 } else { MARK },
                bottom: rows.end,
            };
            tiles.push((Vec::new(), window));
        }
    }
    let mut cuts: Vec<At> = Vec::new();
    for shape in shapes {
        let extent = shape.extent();
        let columns = touched(next_to, stretch(extent, Along::Width));
        let rows = touched(below, stretch(extent, Along::Height));
        if shape.role == Role::Wire {
            let through = columns.clone().skip(1).map(|column| next_to[column].start);
            cuts.extend(through.map(|x| (x, extent.top)));
        }
        for column in columns {
            for row in rows.clone() {
                let mut shape = shape.clone();
                if let (Role::Wire, Form::Line(from, to)) = (shape.role, &mut shape.form) {
                    from.0 = from.0.max(next_to[column].start);
                    to.0 = to.0.min(next_to[column].end);
                }
                tiles[column * below.len() + row].0.push(shape);
            }
        }
    }
    cuts.sort_unstable();
    for (number, (x, y)) in cuts.into_iter().enumerate() {
        let column = next_to.partition_point(|columns| columns.start < x);
        let number = number + 1;
        let (right, left) = (format!("{number} →"), format!("→ {number}"));
        for row in touched(below, y..y) {
            let mark = |at, anchor, text: &str| Shape {
                power: Vec::new(),
                operand: None,
                look: Look::Pin,
                role: Role::Symbol,
                element: None,
                form: Form::Text {
                    at,
                    anchor,
                    width: width(text),
                    text: text.to_owned(),
                },
            };
            let before = &mut tiles[(column - 1) * below.len() + row].0;
            before.push(mark((x + 4, y + 4), Anchor::Start, &left));
            let after = &mut tiles[column * below.len() + row].0;
            after.push(mark((x - 4, y + 4), Anchor::End, &right));
        }
    }
    tiles
}

/// The pieces that something reaches into.
fn touched(pieces: &[Range<i32>], stretch: Range<i32>) -> Range<usize> {
    let first = pieces.partition_point(|piece| piece.end <= stretch.start);
    let after = pieces.partition_point(|piece| piece.start < stretch.end.max(stretch.start + 1));
    first.min(pieces.len().saturating_sub(1))..after.max(first + 1).min(pieces.len())
}
