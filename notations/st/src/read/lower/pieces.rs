//! The pieces of a chart: bodies of its actions and conditions of its transitions, which see what the others do with the same tags.

use super::super::tree::{Expression, Statement};
use super::super::uses::Uses;
use super::{Block, Body, Circuit, Drawing, Item, Lowering, Names, Network, Surroundings, UnreadParts, used};
use std::collections::HashSet;

/// A piece.
pub(in super::super) struct Piece<'a> {
    pub(in super::super) around: &'a Surroundings<'a>,
    pub(in super::super) what: What<'a>,
}

/// What a piece is.
pub(in super::super) enum What<'a> {
    /// Statements that run in some scans.
    Statements(&'a [Statement]),
    /// A condition. Its last network is what has power if it holds.
    Condition(&'a Expression),
}

/// The networks of pieces, one body each. The tags that they need are those of the first.
///
/// # Errors
///
/// Why they cannot be read.
pub(in super::super) fn lower_pieces(
    pieces: &[Piece<'_>],
    names: &mut Names,
    unread: &mut UnreadParts,
) -> Result<Vec<Body>, String> {
    let Some(first) = pieces.first() else {
        return Ok(Vec::new());
    };
    let mut uses = Uses::none(first.around.scope);
    for piece in pieces {
        match piece.what {
            What::Statements(statements) => uses.at_times(statements),
            What::Condition(condition) => uses.expression(condition),
        }
    }
    let count = unread.len();
    let mut lowering = Lowering::new(first.around, uses, names, unread);
    lowering.depth = 1;
    let mut bodies = Vec::new();
    let mut tags = Vec::new();
    let mut why = None;
    for piece in pieces {
        lowering.around = piece.around;
        match piece.what {
            What::Statements(statements) => lowering.all(statements),
            What::Condition(condition) => {
                if let Err(because) = lowering.condition_of_piece(condition) {
                    why = Some(because);
                }
            }
        }
        let next = Body {
            last_label: lowering.body.last_label,
            ..Body::default()
        };
        let mut body = std::mem::replace(&mut lowering.body, next);
        lowering.first_origin += body.origins.len() as u32;
        why = body.unread.take().or(why);
        if let Some(why) = why {
            unread.truncate(count);
            return Err(why);
        }
        if let What::Statements(statements) = piece.what {
            let mut own = Uses::none(piece.around.scope);
            own.at_times(statements);
            (body.writes, body.calls) = own.written();
        }
        tags.append(&mut body.tags);
        bodies.push(body);
    }
    let mut all = HashSet::new();
    for body in &mut bodies {
        body.used = used(&mut body.items);
        all.extend(body.used.iter().cloned());
    }
    tags.retain(|tag| tag.names.iter().any(|name| all.contains(name)));
    if let Some(first) = bodies.first_mut() {
        first.tags = tags;
    }
    Ok(bodies)
}

impl Lowering<'_, '_> {
    /// Ends with a network that has power at its end if a condition holds.
    fn condition_of_piece(&mut self, condition: &Expression) -> Result<(), String> {
        self.body.origins.push(condition.span.start);
        self.origin = Some(self.first_origin + self.body.origins.len() as u32 - 1);
        let used = self.used.len();
        let power = self.condition(condition)?;
        let labels = std::mem::take(&mut self.labels);
        let mut parts: Vec<_> = labels
            .iter()
            .map(|label| self.element(Block::label(label)))
            .collect();
        parts.extend(std::mem::take(&mut self.chain).into_iter().map(Circuit::Element));
        parts.push(self.circuit(&power));
        self.release(used);
        if !self.directives.is_empty() {
            return Err("a condition calls an instance that something else calls, too".to_owned());
        }
        self.body.items.push(Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(Circuit::Series(parts)),
        }));
        Ok(())
    }
}
