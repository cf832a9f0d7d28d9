//! Networks of contacts, coils and jumps, one after the other.

use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Expression, Item, Network, Origin, Path};
use ladder_instructions::Op;

/// A part of a network.
pub(super) type Part = Circuit<Element>;

/// The networks so far, and what the next one begins with.
#[derive(Default)]
pub(super) struct Networks {
    items: Vec<Item>,
    labels: Vec<String>,
    comments: Vec<String>,
}

impl Networks {
    /// A network of parts one after the other.
    pub(super) fn push(&mut self, parts: Vec<Part>) {
        let comments = std::mem::take(&mut self.comments);
        let mut series = self.labels();
        series.extend(parts);
        if !comments.is_empty() {
            self.items.push(Item::Blank);
        }
        let drawing = Drawing::Circuit(Circuit::Series(series));
        self.items.push(Item::Network(Network { comments, drawing }));
    }

    /// A comment above the next network.
    pub(super) fn comment(&mut self, told: impl Into<String>) {
        self.comments.push(told.into());
    }

    /// A label that the next network begins with.
    pub(super) fn label(&mut self, label: String) {
        self.labels.push(label);
    }

    /// Items as they are: those of a body.
    pub(super) fn extend(&mut self, items: Vec<Item>) {
        if !self.labels.is_empty() {
            self.push(Vec::new());
        }
        self.items.extend(items);
    }

    /// All of them.
    pub(super) fn items(mut self) -> Vec<Item> {
        if !self.labels.is_empty() {
            self.comments.clear();
            self.push(Vec::new());
        }
        self.items
    }

    fn labels(&mut self) -> Vec<Part> {
        let labels = std::mem::take(&mut self.labels);
        labels
            .iter()
            .map(|label| element(Block::label(label), None))
            .collect()
    }
}

/// A block on a rung.
pub(super) const fn element(block: Block, origin: Option<Origin>) -> Part {
    Circuit::Element(Element::of(block, origin))
}

/// `[ ]( tag )`
pub(super) fn contact(tag: &str, origin: Option<Origin>) -> Part {
    element(Block::contact(Path::tag(tag)), origin)
}

/// `[/]( tag )`
pub(super) fn not(tag: &str, origin: Option<Origin>) -> Part {
    element(Block::negated_contact(Path::tag(tag)), origin)
}

/// An instruction whose operands the table allows.
pub(super) fn block(
    op: Op,
    operands: impl IntoIterator<Item = Expression>,
    origin: Option<Origin>,
) -> Result<Part, String> {
    Ok(element(Block::of(op, operands)?, origin))
}

/// What has power if one of these has; one alone needs no branches.
pub(super) fn any(mut parts: Vec<Part>) -> Part {
    match parts.pop() {
        Some(only) if parts.is_empty() => only,
        last => Circuit::Parallel(parts.into_iter().chain(last).collect()),
    }
}

/// A TIME of 0.
pub(super) fn zero() -> Result<Expression, String> {
    Ok(Expression::literal("T#0s")?)
}
