//! From the rungs of a text to a sketch.

use crate::pieces::{Pieces, head_word, kind_of, kind_of_raw, len};
use crate::sketch::{ElementKind, Sketch};
use crate::width::display_width;
use ladder_instructions::{Role, Shape, lookup};
use ladder_syntax::SyntaxKind::{self, *};
use ladder_syntax::rowan::{GreenNodeData, NodeOrToken};
use ladder_syntax::wiring::{self, Part, PartKind};
use ladder_syntax::{Line, TextRange, TextSize};

/// Why a network stays as it is.
pub(crate) struct Stays;

/// Puts the elements of a rung behind those of the sketch, and the places where they begin (from the start of
/// the line) behind `places`. Comments before the first and behind the last element are no elements.
///
/// `Err` if the rung cannot be drawn anew without changing what it says (LANGUAGE §8 rule 10, and the few
/// texts whose canonical form would read differently).
pub(crate) fn rung(
    text: &str,
    line: &Line,
    line_start: usize,
    in_body: bool,
    sketch: &mut Sketch,
    places: &mut Vec<u32>,
) -> Result<(), Stays> {
    let drawing = wiring::rung(line);
    let parts = &drawing.parts;
    let is_aside = |part: &Part| matches!(part.kind, PartKind::Bar) || is_free_comment(part);
    let (Some(first), Some(last)) = (
        parts.iter().position(|part| !is_aside(part)),
        parts.iter().rposition(|part| !is_aside(part)),
    ) else {
        return Err(Stays);
    };
    sketch.begin_rung();
    let mut children = Children::new(line.green());
    // The segment of the last element; none behind a bar that the wire reaches to.
    let mut segment = None;
    let mut at_bar = false;
    if begins_at_bar(parts, first) {
        sketch.push(ElementKind::LeftBar, false, 1);
        places.push(parts[first - 1].range.start().into());
        at_bar = true;
    }
    let mut without_list = false;
    for (index, part) in parts.iter().enumerate().take(last + 1).skip(first) {
        let place = u32::from(part.range.start());
        let slice =
            &text[line_start + usize::from(part.range.start())..line_start + usize::from(part.range.end())];
        let (kind, width) = match part.kind {
            PartKind::LeftRail => (ElementKind::LeftRail, 1),
            PartKind::RightRail => (ElementKind::RightRail, 1),
            PartKind::StrayRail | PartKind::StrayBar => (ElementKind::Stray, 1),
            PartKind::Down => (ElementKind::Down, 1),
            PartKind::Up => (ElementKind::Up, 1),
            PartKind::Comment if slice.contains(['\n', '\r']) => return Err(Stays),
            PartKind::Comment => (ElementKind::Comment, display_width(slice)),
            PartKind::Bar => continue,
            PartKind::Junk => return Err(Stays),
            PartKind::Wire => {
                if is_between(&drawing, index, first, last) {
                    continue;
                }
                (ElementKind::Stub, 2)
            }
            PartKind::Block => {
                let Some(node) = children.node_at(part.range.start()) else {
                    return Err(Stays);
                };
                // A bar that goes would leave `[OSR]  ( )( y )`: a first part with its operand list.
                let joined = part.segment.is_some() && part.segment == segment;
                if without_list && !joined && !at_bar && slice.starts_with('(') {
                    return Err(Stays);
                }
                let range = TextRange::at(part.range.start(), part.range.len());
                let width = if is_kept_as_written(line, range) {
                    if slice.contains(['\n', '\r']) {
                        return Err(Stays);
                    }
                    display_width(slice)
                } else {
                    block_width(text, node, line_start + place as usize, in_body).ok_or(Stays)?
                };
                (kind_of_block(node), width)
            }
        };
        let joined =
            at_bar || part.kind == PartKind::StrayBar || (part.segment.is_some() && part.segment == segment);
        sketch.push(kind, joined, width);
        places.push(place);
        segment = part.segment;
        at_bar = part.kind == PartKind::StrayBar;
        without_list = part.kind == PartKind::Block && children.last_has_no_list;
    }
    if ends_at_bar(parts, last) {
        sketch.push(ElementKind::RightBar, true, 1);
        places.push(parts[last + 1].range.start().into());
    }
    Ok(())
}

/// A comment that joins nothing.
fn is_free_comment(part: &Part) -> bool {
    part.kind == PartKind::Comment && part.segment.is_none()
}

/// Whether a `|` stands first on the line and touches the wire there.
fn begins_at_bar(parts: &[Part], first: usize) -> bool {
    first > 0
        && parts[first].kind == PartKind::Wire
        && parts[first].touches
        && parts[first - 1].kind == PartKind::Bar
}

/// Whether a `|` stands last on the line and touches the wire there.
fn ends_at_bar(parts: &[Part], last: usize) -> bool {
    parts[last].kind == PartKind::Wire
        && parts
            .get(last + 1)
            .is_some_and(|part| part.kind == PartKind::Bar && part.touches)
}

/// Whether a wire has something at both its ends, so that it is only the distance between them.
fn is_between(drawing: &wiring::Rung, index: usize, first: usize, last: usize) -> bool {
    let parts = &drawing.parts;
    let Some(segment) = parts[index].segment.map(|n| &drawing.segments[n as usize]) else {
        return false;
    };
    let is_stray_bar = |n: usize| parts.get(n).is_some_and(|part| part.kind == PartKind::StrayBar);
    let left = index > segment.parts.start
        || (index > 0 && parts[index].touches && is_stray_bar(index - 1))
        || (index == first && begins_at_bar(parts, index));
    let right = index + 1 < segment.parts.end
        || (parts.get(index + 1).is_some_and(|p| p.touches) && is_stray_bar(index + 1))
        || (index == last && ends_at_bar(parts, index));
    left && right
}

/// Whether a block has a mistake that formatting does not stop at; it is moved, but not touched.
pub(crate) fn is_kept_as_written(line: &Line, block: TextRange) -> bool {
    let inside = |at: TextSize| block.start() < at && at < block.end();
    line.errors.iter().any(|error| inside(error.range.start()))
}

/// The width of a block in its canonical form. None if a comment in it holds a line end.
fn block_width(text: &str, node: &GreenNodeData, start: usize, in_body: bool) -> Option<u32> {
    let mut width = 0;
    let mut one_line = true;
    Pieces::new(text, start, in_body, |piece| {
        let word = &text[piece.start..piece.end];
        one_line &= !(word.starts_with('#') && word.contains(['\n', '\r']));
        width += piece.blanks + display_width(word);
    })
    .block(node, start);
    one_line.then_some(width)
}

/// Condition or acting (LANGUAGE §8 rule 5). What the table does not know acts, as do user-defined blocks.
fn kind_of_block(node: &GreenNodeData) -> ElementKind {
    let shape = match kind_of(node) {
        LOGICAL_BLOCK => Shape::Logical,
        COIL_BLOCK => Shape::Coil,
        _ => Shape::Function,
    };
    let word = match head_word(node) {
        None => "",
        Some((MNEMONIC, word)) => word,
        Some(_) => return ElementKind::Acting,
    };
    let rows = lookup(shape, word);
    let role = match rows.len() {
        0 => Role::Acting,
        1 => rows.map(|row| row.role).next().unwrap_or(Role::Acting),
        // `[NOT]` is a condition without operands, and acts with them.
        _ => {
            let operands = positional_operands(node);
            let fitting = rows.clone().find(|row| row.takes(operands));
            fitting.map_or(Role::Acting, |row| row.role)
        }
    };
    match role {
        Role::Condition => ElementKind::Condition,
        Role::Acting => ElementKind::Acting,
    }
}

fn positional_operands(block: &GreenNodeData) -> usize {
    let list = block
        .children()
        .filter_map(NodeOrToken::into_node)
        .find(|node| kind_of(node) == OPERAND_LIST);
    list.map_or(0, |list| {
        list.children()
            .filter_map(NodeOrToken::into_node)
            .filter(|node| kind_of(node) != NAMED_OPERAND)
            .count()
    })
}

/// The children of a line in order, for someone who knows where the next one stands.
struct Children<'g> {
    rest: ladder_syntax::rowan::Children<'g>,
    at: TextSize,
    last_has_no_list: bool,
}

impl<'g> Children<'g> {
    fn new(line: &'g GreenNodeData) -> Self {
        Children {
            rest: line.children(),
            at: TextSize::new(0),
            last_has_no_list: false,
        }
    }

    /// The node that begins at a place, which must not stand before the one asked for last.
    fn node_at(&mut self, place: TextSize) -> Option<&'g GreenNodeData> {
        loop {
            let child = self.rest.next()?;
            let at = self.at;
            self.at += match child {
                NodeOrToken::Node(node) => node.text_len(),
                NodeOrToken::Token(token) => token.text_len(),
            };
            if at == place {
                let node = child.into_node()?;
                self.last_has_no_list = !node
                    .children()
                    .filter_map(NodeOrToken::into_node)
                    .any(|part| kind_of(part) == OPERAND_LIST);
                return Some(node);
            }
        }
    }
}

/// Calls `f` with every child of a line: kind, node if it is one, start and end in the text.
pub(crate) fn each_child<'g>(
    line: &'g Line,
    line_start: usize,
    mut f: impl FnMut(SyntaxKind, Option<&'g GreenNodeData>, usize, usize),
) {
    let mut at = line_start;
    for child in line.green().children() {
        let (kind, node, length) = match child {
            NodeOrToken::Node(node) => (kind_of(node), Some(node), node.text_len()),
            NodeOrToken::Token(token) => (kind_of_raw(token.kind()), None, token.text_len()),
        };
        let end = at + len(length);
        f(kind, node, at, end);
        at = end;
    }
}
