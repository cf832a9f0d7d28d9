//! From the rungs of a text to a sketch.

use crate::block::{Block, Form};
use crate::flat::Source;
use crate::sketch::{ElementKind, Sketch};
use crate::stays::directive;
use crate::width::display_width;
use ladder_syntax::SyntaxKind::COIL_BLOCK;
use ladder_syntax::wiring::{self, PartKind, RungPart};
use ladder_syntax::{Network, ReadLine};

/// A rung cannot be drawn again without changing what it says (LANGUAGE §8 rule 10, and the few texts whose
/// canonical form would read differently), so its network stays as it is.
pub(crate) struct Stays;

/// Where the text of an element is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Atom {
    /// Its node or token.
    pub(crate) node: u32,
    /// Its canonical form among [`Reader::forms`]; empty if it is in that already, or stays in another.
    form: Form,
}

impl Atom {
    /// Whether its text stays.
    pub(crate) fn is_kept(&self) -> bool {
        self.form.start == self.form.end
    }
}

/// Reads networks into one sketch.
#[derive(Default)]
pub(crate) struct Reader {
    pub(crate) sketch: Sketch,
    /// For each element of the sketch its text.
    pub(crate) atoms: Vec<Atom>,
    drawing: wiring::Rung,
    /// The canonical forms of the blocks that are in another, one after the other.
    forms: String,
}

impl Reader {
    /// Puts the rungs of a network after those that are there. On `Err` none of them is there.
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

    /// The canonical form of an element whose text does not stay.
    pub(crate) fn form(&self, atom: &Atom) -> &str {
        &self.forms[atom.form.start as usize..atom.form.end as usize]
    }

    /// Forgets everything; the memory stays.
    pub(crate) fn clear(&mut self) {
        self.sketch.truncate(0);
        self.atoms.clear();
        self.forms.clear();
    }

    /// Forgets the rungs from one on.
    pub(crate) fn forget(&mut self, first: usize) {
        self.sketch.truncate(first);
        self.atoms.truncate(self.sketch.elements.len());
    }

    /// Puts a rung after those that are there. Comments before its first and after its last element are no
    /// elements.
    fn rung(&mut self, source: Source<'_>, index: usize, in_body: bool) -> Result<(), Stays> {
        let text = source.text;
        let line = &source.lines.lines()[index];
        let node = source.line(index);
        let children = node.children().map(|child| wiring::Child {
            kind: child.kind(),
            len: ((child.end() - child.start()) as u32).into(),
            number: child.index(),
        });
        wiring::read_rung(children, &mut self.drawing);
        let drawing = &self.drawing;
        let parts = &drawing.parts;
        let (Some(first), Some(last)) = (
            parts.iter().position(|part| !is_aside(part)),
            parts.iter().rposition(|part| !is_aside(part)),
        ) else {
            return Err(Stays);
        };
        // Without its bars it would be a gap.
        if wiring::bar_contacts(parts).next().is_some() {
            return Err(Stays);
        }
        if source.has_comment(index) {
            check_leading_comments(source, parts, first)?;
        }
        self.sketch.begin_rung();
        let mut push = |kind, joined, width, part: &RungPart, form| {
            self.sketch.push(kind, joined, width);
            self.atoms.push(Atom {
                node: part.child,
                form,
            });
        };
        // The segment of the last element; none after a bar that the wire reaches to.
        let mut segment = None;
        let mut at_bar = false;
        if begins_at_bar(parts, first) {
            push(ElementKind::LeftBar, false, 1, &parts[first - 1], Form::default());
            at_bar = true;
        }
        let mut without_list = false;
        let mut block_before: Option<Block<'_>> = None;
        for (n, part) in parts.iter().enumerate().take(last + 1).skip(first) {
            let node = source.node(part.child);
            let before = block_before.take();
            let in_segment = part.segment.is_some() && part.segment == segment;
            let joined = at_bar || in_segment || part.kind == PartKind::StrayBar;
            let mut form = Form::default();
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
                    let block = Block::new(text, node);
                    has_list = block.has_list();
                    if part.touches && !has_list && before.is_some_and(|before| before.takes_head_of(block)) {
                        return Err(Stays);
                    }
                    block_before = Some(block);
                    let width = if has_error(line, part) {
                        one_line_width(&text[node.range()])?
                    } else {
                        let width;
                        (width, form) = block.measure(in_body, &mut self.forms)?;
                        width
                    };
                    (block.element_kind(), width)
                }
            };
            push(kind, joined, width, part, form);
            segment = part.segment;
            at_bar = part.kind == PartKind::StrayBar;
            without_list = !has_list;
        }
        if ends_at_bar(parts, last) {
            push(ElementKind::RightBar, true, 1, &parts[last + 1], Form::default());
        }
        Ok(())
    }
}

/// What is next to the drawing: bars and comments that join nothing.
fn is_aside(part: &RungPart) -> bool {
    part.kind == PartKind::Bar || (part.kind == PartKind::Comment && part.segment.is_none())
}

/// A comment before the first element goes onto a line of its own; it must not become a directive there.
fn check_leading_comments(source: Source<'_>, parts: &[RungPart], first: usize) -> Result<(), Stays> {
    let is_directive = |part: &RungPart| {
        part.kind == PartKind::Comment && directive(&source.text[source.node(part.child).range()]).is_some()
    };
    if parts[..first].iter().any(is_directive) {
        Err(Stays)
    } else {
        Ok(())
    }
}

/// Whether a `|` is first on the line and touches the wire there.
fn begins_at_bar(parts: &[RungPart], first: usize) -> bool {
    first > 0
        && parts[first].kind == PartKind::Wire
        && parts[first].touches
        && parts[first - 1].kind == PartKind::Bar
}

/// Whether a `|` is last on the line and touches the wire there.
fn ends_at_bar(parts: &[RungPart], last: usize) -> bool {
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

/// Whether a block has an error that formatting does not stop at; it is moved, but not touched.
fn has_error<N>(line: &ReadLine<N>, block: &RungPart) -> bool {
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
