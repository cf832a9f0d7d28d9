//! What power goes through: contacts, coils, values, gates and comparisons.

use super::blocks::{Class, power_pins};
use super::draw::{Pencil, RAIL, Refused, at, contact_on};
use crate::expression::Form;
use crate::graph::{Edge, End, Kind, Modifier, Storage};
use crate::standard::Gate;
use ladder_format::program::{Block, Path};
use ladder_instructions::Op;

impl Pencil<'_, '_> {
    /// A coil, and whether power goes on after it as it came. What comes after other coils in the source has the power
    /// from before them.
    pub(super) fn coil(
        &mut self,
        node: usize,
        tag: &Path,
        modifier: Modifier,
        storage: Storage,
    ) -> Result<(Vec<Block>, bool), Refused> {
        let dropped = (modifier.negated && (storage != Storage::None || modifier.edge != Edge::None))
            || (storage != Storage::None && modifier.edge != Edge::None);
        if dropped {
            self.body.note(
                node,
                "it is negated, latched or of an edge at once: only the first of these counts",
            );
        }
        let (op, passes_on) = match (modifier.negated, storage, modifier.edge) {
            (true, ..) => (Op::NegatedCoil, true),
            (false, Storage::Set, _) => (Op::SetCoil, false),
            (false, Storage::Reset, _) => (Op::ResetCoil, true),
            (false, Storage::None, Edge::None) => (Op::Coil, true),
            (false, Storage::None, Edge::Rising) => (Op::RisingCoil, true),
            // The first scan without power counts as a fall in the standard.
            (false, Storage::None, Edge::Falling) => {
                let coil = at(node, Block::of(Op::RisingCoil, [tag]))?;
                return Ok((vec![Block::inverter(), coil], false));
            }
        };
        Ok((vec![at(node, Block::of(op, [tag]))?], passes_on))
    }

    /// What comes to a pin, inverted, if that is one contact.
    pub(super) fn inverted(
        &mut self,
        node: usize,
        pin: usize,
        start: usize,
    ) -> Result<Option<usize>, Refused> {
        let Some(end) = self.body.invertible(node, pin) else {
            return Ok(None);
        };
        self.shown.insert(end.node);
        let graph = self.body.graph;
        let point = match &graph.nodes[end.node].kind {
            Kind::Contact(text, modifier) => {
                let modifier = Modifier {
                    negated: !modifier.negated,
                    edge: Edge::None,
                };
                let contacts = self.contact(end.node, text, modifier, false)?;
                self.series(start, contacts, end.node)
            }
            Kind::Value(text, negated) => self.value(end, text, !negated, start)?,
            _ => return Ok(None),
        };
        Ok(Some(point))
    }

    /// A value where power is wanted.
    pub(super) fn value(
        &mut self,
        end: End,
        text: &str,
        negated: bool,
        start: usize,
    ) -> Result<usize, Refused> {
        if self.body.is_refused(end.node) {
            return Ok(self.stand_in(start, end.node));
        }
        let operand = at(end.node, self.body.operand(text))?;
        let contact = match operand.form() {
            Form::Literal(_) => match operand.truth() {
                Some(truth) if truth != negated => return Ok(start),
                Some(_) => Block::contact(Path::system("OFF")),
                None => return Err((end.node, "it is no power".to_owned())),
            },
            Form::Path(tag) => contact_on(tag, negated),
            Form::NotPath(tag) => contact_on(tag, !negated),
            Form::Milliseconds => return Err((end.node, "it is no power".to_owned())),
            Form::Formula => {
                let tag = self.body.tags.results.get(&end);
                let tag = tag.ok_or_else(|| (end.node, "its value is not known here".to_owned()))?;
                contact_on(tag, negated)
            }
        };
        Ok(self.series(start, [contact], end.node))
    }

    pub(super) fn contact(
        &mut self,
        node: usize,
        text: &str,
        modifier: Modifier,
        is_at_rail: bool,
    ) -> Result<Vec<Block>, Refused> {
        let operand = at(node, self.body.operand(text))?;
        let (tag, is_not) = match (operand.form(), operand.truth()) {
            (Form::Path(tag), _) => (tag.clone(), false),
            (Form::NotPath(tag), _) => (tag.clone(), true),
            (_, Some(truth)) => (Path::system(if truth { "ON" } else { "OFF" }), false),
            _ => return Err((node, "it is no variable".to_owned())),
        };
        if modifier.negated && modifier.edge != Edge::None {
            self.body.note(
                node,
                "it is negated and of an edge at once: the edge does not count",
            );
        }
        if modifier.negated || is_not || modifier.edge == Edge::None {
            if is_not && !modifier.negated && modifier.edge != Edge::None {
                self.body
                    .note(node, "the edge of what is inverted does not count");
            }
            return Ok(vec![contact_on(tag, modifier.negated != is_not)]);
        }
        if modifier.edge == Edge::Rising {
            return Ok(vec![at(node, Block::of(Op::RisingContact, [tag]))?]);
        }
        // The first scan with the tag low counts as a fall in the standard.
        if is_at_rail {
            return Ok(vec![Block::negated_contact(tag), Block::one_shot()]);
        }
        self.body.note(
            node,
            "the first scan with the tag low counts as a fall there, and not here",
        );
        Ok(vec![at(node, Block::of(Op::FallingContact, [tag]))?])
    }

    /// A gate or a comparison.
    pub(super) fn condition(&mut self, node: usize, class: Class, start: usize) -> Result<usize, Refused> {
        if self.body.is_refused(node) {
            return Ok(self.stand_in(start, node));
        }
        let pins = 0..self.body.graph.nodes[node].inputs.len();
        let used = |pencil: &Self, pin: usize| !pencil.body.graph.nodes[node].inputs[pin].from.is_empty();
        let pins: Vec<usize> = pins.filter(|pin| used(self, *pin)).collect();
        match class {
            Class::Gate(Gate::And) => {
                let mut point = start;
                for pin in pins {
                    point = self.pin(node, pin, point)?;
                }
                Ok(point)
            }
            Class::Gate(Gate::Or) => {
                let mut points = Vec::new();
                for pin in pins {
                    points.push(self.pin(node, pin, start)?);
                }
                let point = self.point();
                self.join(points, point);
                Ok(point)
            }
            Class::Gate(_) => {
                let pin = self.body.graph.nodes[node].inputs.first();
                let is_plain = pin.is_some_and(|pin| pin.modifier == Modifier::default());
                if is_plain && let Some(point) = self.inverted(node, 0, start)? {
                    return Ok(point);
                }
                if let (true, Some(operand)) = (start != RAIL, self.body.tags.operands.get(&(node, 0))) {
                    let contact = Block::negated_contact(operand.value.clone());
                    return Ok(self.series(start, [contact], node));
                }
                let point = self.pin(node, 0, start)?;
                Ok(self.series(point, [Block::inverter()], node))
            }
            _ => {
                let block = at(node, self.body.comparison(node, class))?;
                let mut point = start;
                for pin in power_pins(self.body, node) {
                    point = self.pin(node, pin, point)?;
                }
                Ok(self.series(point, [block], node))
            }
        }
    }
}
