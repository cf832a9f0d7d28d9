//! From the rungs of a text to a sketch.

use crate::flat::{Node, Source};
use crate::pieces::{Pieces, head_word};
use crate::sketch::{ElementKind, Sketch};
use crate::stays::directive;
use crate::width::display_width;
use ladder_instructions::{Role, Shape, lookup};
use ladder_syntax::SyntaxKind::*;
use ladder_syntax::wiring::{self, Part, PartKind};
use ladder_syntax::{Line, Network, SyntaxKind};

/// A rung cannot be drawn anew without changing what it says (LANGUAGE §8 rule 10, and the few texts whose
/// canonical form would read differently), so its network stays as it is.
pub(crate) struct Stays;

/// Where the text of an element is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Atom {
    /// Its node or token.
    pub(crate) node: u32,
    /// It is in its canonical form already, or stays in another.
    pub(crate) is_kept: bool,
}

/// Reads networks into one sketch.
#[derive(Default)]
pub(crate) struct Reader {
    pub(crate) sketch: Sketch,
    /// For each element of the sketch its text.
    pub(crate) atoms: Vec<Atom>,
    drawing: wiring::Rung,
    /// The node of each part of the drawing.
    nodes: Vec<u32>,
}

impl Reader {
    /// Puts the rungs of a network behind those that are there. On `Err` none of them is there.
    pub(crate) fn network(&mut self, source: Source<'_>, network: &Network) -> Result<(), Stays> {
        let first = self.sketch.rungs.len();
        let in_body = network.block.is_some();
        let read = source
            .rungs(network)
            .try_for_each(|line| self.rung(source, line, in_body));
        if read.is_ok() {
            self.sketch.pair(first..self.sketch.rungs.len());
        } else {
            self.forget(first);
        }
        read
    }

    /// Forgets the rungs from one on.
    pub(crate) fn forget(&mut self, first: usize) {
        self.sketch.truncate(first);
        self.atoms.truncate(self.sketch.elements.len());
    }

    /// Puts a rung behind those that are there. Comments before its first and behind its last element are no
    /// elements.
    fn rung(&mut self, source: Source<'_>, index: usize, in_body: bool) -> Result<(), Stays> {
        let text = source.text;
        let line = &source.lines.lines()[index];
        let node = source.line(index);
        self.read_drawing(node);
        let (drawing, nodes) = (&self.drawing, &self.nodes);
        let parts = &drawing.parts;
        let (Some(first), Some(last)) = (
            parts.iter().position(|part| !is_aside(part)),
            parts.iter().rposition(|part| !is_aside(part)),
        ) else {
            return Err(Stays);
        };
        if source.has_comment(index) {
            check_leading_comments(source, parts, nodes, first)?;
        }
        self.sketch.begin_rung();
        let mut push = |kind, joined, width, part: usize, is_kept| {
            self.sketch.push(kind, joined, width);
            self.atoms.push(Atom {
                node: nodes[part],
                is_kept,
            });
        };
        // The segment of the last element; none behind a bar that the wire reaches to.
        let mut segment = None;
        let mut at_bar = false;
        if begins_at_bar(parts, first) {
            push(ElementKind::LeftBar, false, 1, first - 1, true);
            at_bar = true;
        }
        let mut without_list = false;
        let mut block_before: Option<Node<'_>> = None;
        for (n, part) in parts.iter().enumerate().take(last + 1).skip(first) {
            let node = source.node(nodes[n]);
            let before = block_before.take();
            let in_segment = part.segment.is_some() && part.segment == segment;
            let joined = at_bar || in_segment || part.kind == PartKind::StrayBar;
            let mut is_kept = true;
            let mut has_list = true;
            let (kind, width) = match part.kind {
                PartKind::LeftRail => (ElementKind::LeftRail, 1),
                PartKind::RightRail => (ElementKind::RightRail, 1),
                PartKind::StrayRail | PartKind::StrayBar => (ElementKind::Stray, 1),
                PartKind::Down => (ElementKind::Down, 1),
                PartKind::Up => (ElementKind::Up, 1),
                PartKind::Comment => (ElementKind::Comment, one_line_width(&text[node.range()])?),
                PartKind::Bar => continue,
                PartKind::Junk => return Err(Stays),
                PartKind::Wire if is_between(drawing, n, first, last) => continue,
                PartKind::Wire => (ElementKind::Stub, 2),
                PartKind::Block => {
                    // A bar that goes would leave `[OSR]  ( )( y )`: a first part with its operand list.
                    if without_list && !joined && node.kind() == COIL_BLOCK {
                        return Err(Stays);
                    }
                    has_list = node.child(OPERAND_LIST).is_some();
                    let head = head_word(text, node);
                    if part.touches
                        && !has_list
                        && before.is_some_and(|before| takes_head(text, before, node))
                    {
                        return Err(Stays);
                    }
                    block_before = Some(node);
                    let width = if has_mistake(line, part) {
                        one_line_width(&text[node.range()])?
                    } else {
                        let (width, canonical) = measure(text, node, head, in_body)?;
                        is_kept = canonical;
                        width
                    };
                    (kind_of_block(node, head), width)
                }
            };
            push(kind, joined, width, n, is_kept);
            segment = part.segment;
            at_bar = part.kind == PartKind::StrayBar;
            without_list = !has_list;
        }
        if ends_at_bar(parts, last) {
            push(ElementKind::RightBar, true, 1, last + 1, true);
        }
        Ok(())
    }

    fn read_drawing(&mut self, line: Node<'_>) {
        let children = line
            .children()
            .map(|child| (child.kind(), ((child.end() - child.start()) as u32).into()));
        wiring::read_rung(children, &mut self.drawing);
        self.nodes.clear();
        let mut children = line.children();
        for part in &self.drawing.parts {
            let start = line.start() + usize::from(part.range.start());
            // An empty node cannot stand on a rung, so places tell children apart.
            let node = children.find(|child| child.start() == start);
            self.nodes.push(node.map_or(0, Node::index));
        }
    }
}

/// What stands beside the drawing: bars and comments that join nothing.
fn is_aside(part: &Part) -> bool {
    part.kind == PartKind::Bar || (part.kind == PartKind::Comment && part.segment.is_none())
}

/// A comment before the first element goes onto a line of its own; it must not become a directive there.
fn check_leading_comments(
    source: Source<'_>,
    parts: &[Part],
    nodes: &[u32],
    first: usize,
) -> Result<(), Stays> {
    let is_directive = |n: usize| {
        parts[n].kind == PartKind::Comment && directive(&source.text[source.node(nodes[n]).range()]).is_some()
    };
    if (0..first).any(is_directive) {
        Err(Stays)
    } else {
        Ok(())
    }
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
fn has_mistake<N>(line: &Line<N>, block: &Part) -> bool {
    let place = block.range;
    line.errors
        .iter()
        .any(|error| place.start() < error.range.start() && error.range.start() < place.end())
}

fn one_line_width(text: &str) -> Result<u32, Stays> {
    if text.contains(['\n', '\r']) {
        return Err(Stays);
    }
    Ok(display_width(text))
}

/// The width of a block in its canonical form, and whether it is in that form.
fn measure(text: &str, block: Node<'_>, head: Head<'_>, in_body: bool) -> Result<(u32, bool), Stays> {
    let bytes = text.as_bytes();
    let ascii = bytes[block.range()].is_ascii();
    let mut width = 0;
    let mut canonical = true;
    let mut at = block.start();
    let mut several_lines = false;
    Pieces::new(text, in_body, |piece| {
        let word = &bytes[piece.start..piece.end];
        width += piece.blanks
            + if ascii {
                word.len() as u32
            } else {
                display_width(&text[piece.start..piece.end])
            };
        several_lines |= piece.kind == COMMENT && word.iter().any(|b| matches!(b, b'\n' | b'\r'));
        canonical &= at + piece.blanks as usize == piece.start
            && (piece.blanks == 0 || bytes[at] == b' ')
            && !(piece.capitals && word.iter().any(u8::is_ascii_lowercase));
        at = piece.end;
    })
    .block(block, head);
    if several_lines {
        Err(Stays)
    } else {
        Ok((width, canonical))
    }
}

/// The word in a block's first part: a mnemonic or the name of a user-defined block.
type Head<'t> = Option<(SyntaxKind, &'t str)>;

/// Condition or acting (LANGUAGE §8 rule 5). What the table does not know acts, as do user-defined blocks.
fn kind_of_block(block: Node<'_>, head: Head<'_>) -> ElementKind {
    let word = match (block.kind(), head) {
        (LOGICAL_BLOCK, None) => return ElementKind::Condition,
        (_, None) => return ElementKind::Acting,
        (_, Some((MNEMONIC, word))) => word,
        (_, Some(_)) => return ElementKind::Acting,
    };
    let mut rows = lookup(shape(block), word);
    let row = if rows.len() > 1 {
        // `[NOT]` is a condition without operands, and acts with them.
        let operands = positional_operands(block);
        rows.find(|row| row.takes(operands))
    } else {
        rows.next()
    };
    match row.map_or(Role::Acting, |row| row.role) {
        Role::Condition => ElementKind::Condition,
        Role::Acting => ElementKind::Acting,
    }
}

/// Whether a block has taken the first part of the one that touches it for its operands, as in `[OSR]( )( y )`.
/// The wire that is missing there does not belong between the two, so they stay together for the fix.
fn takes_head(text: &str, block: Node<'_>, next: Node<'_>) -> bool {
    let Some((MNEMONIC, word)) = head_word(text, block) else {
        return false;
    };
    block.child(OPERAND_LIST).is_some()
        && next.kind() == COIL_BLOCK
        && head_word(text, next).is_some()
        && lookup(shape(block), word).any(|row| row.limit() == Some(0))
}

fn shape(block: Node<'_>) -> Shape {
    match block.kind() {
        LOGICAL_BLOCK => Shape::Logical,
        COIL_BLOCK => Shape::Coil,
        _ => Shape::Function,
    }
}

fn positional_operands(block: Node<'_>) -> usize {
    block.child(OPERAND_LIST).map_or(0, |list| {
        list.children()
            .filter(|child| child.is_node() && child.kind() != NAMED_OPERAND)
            .count()
    })
}
