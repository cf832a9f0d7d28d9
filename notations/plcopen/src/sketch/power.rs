//! What power goes through: contacts, coils, values, gates and comparisons.

use super::blocks::{Class, power_pins};
use super::draw::{Pencil, RAIL, Refused};
use crate::expression::{Form, Operand};
use crate::graph::{Edge, End, Kind, Modifier, Storage};
use crate::standard::Gate;

impl Pencil<'_, '_> {
    /// A coil, and whether power goes on after it as it came. What comes after other coils in the source has the power
    /// from before them.
    pub(super) fn coil(
        &mut self,
        node: usize,
        tag: &Operand,
        modifier: Modifier,
        storage: Storage,
    ) -> (Vec<String>, bool) {
        let tag = &tag.text;
        let dropped = (modifier.negated && (storage != Storage::None || modifier.edge != Edge::None))
            || (storage != Storage::None && modifier.edge != Edge::None);
        if dropped {
            self.body.note(
                node,
                "it is negated, latched or of an edge at once: only the first of these counts",
            );
        }
        let one = |text: &str| (vec![format!("{text}( {tag} )")], false);
        match (modifier.negated, storage, modifier.edge) {
            (true, ..) => (vec![format!("(/)( {tag} )")], true),
            (false, Storage::Set, _) => one("(S)"),
            (false, Storage::Reset, _) => (vec![format!("(R)( {tag} )")], true),
            (false, Storage::None, Edge::None) => (vec![format!("( )( {tag} )")], true),
            (false, Storage::None, Edge::Rising) => (vec![format!("(P)( {tag} )")], true),
            // The first scan without power counts as a fall in the standard.
            (false, Storage::None, Edge::Falling) => {
                (vec!["[NOT]".to_owned(), format!("(P)( {tag} )")], false)
            }
        }
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
                let tag = self.tag(end.node, text)?;
                let modifier = Modifier {
                    negated: !modifier.negated,
                    edge: Edge::None,
                };
                let texts = self.contact(end.node, &tag, modifier, false);
                self.series(start, texts, end.node)
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
        let operand = self.body.operand(text).map_err(|why| (end.node, why))?;
        let contact = |negated: bool| if negated { "[/]" } else { "[ ]" };
        let text = match operand.form {
            Form::Literal => match (operand.text.as_str(), negated) {
                ("TRUE" | "BOOL#TRUE" | "BOOL#1", false) | ("FALSE" | "BOOL#FALSE" | "BOOL#0", true) => {
                    return Ok(start);
                }
                ("TRUE" | "BOOL#TRUE" | "BOOL#1", true) | ("FALSE" | "BOOL#FALSE" | "BOOL#0", false) => {
                    "[ ]( SYS.OFF )".to_owned()
                }
                _ => return Err((end.node, "it is no power".to_owned())),
            },
            Form::Path => format!("{}( {} )", contact(negated), operand.text),
            Form::NotPath => format!("{}( {} )", contact(!negated), &operand.text[4..]),
            Form::Milliseconds => return Err((end.node, "it is no power".to_owned())),
            Form::Expression => {
                let tag = self.body.results.get(&end);
                let tag = tag.ok_or_else(|| (end.node, "its value is not known here".to_owned()))?;
                format!("{}( {tag} )", contact(negated))
            }
        };
        Ok(self.series(start, [text], end.node))
    }

    pub(super) fn contact(
        &mut self,
        node: usize,
        tag: &Operand,
        modifier: Modifier,
        is_at_rail: bool,
    ) -> Vec<String> {
        let (tag, is_not) = match tag.form {
            Form::NotPath => (&tag.text[4..], true),
            _ => (tag.text.as_str(), false),
        };
        if modifier.negated && modifier.edge != Edge::None {
            self.body.note(
                node,
                "it is negated and of an edge at once: the edge does not count",
            );
        }
        match (modifier.negated != is_not, modifier.edge) {
            (true, Edge::Rising | Edge::Falling) if is_not && !modifier.negated => {
                self.body
                    .note(node, "the edge of what is inverted does not count");
                vec![format!("[/]( {tag} )")]
            }
            (true, _) => vec![format!("[/]( {tag} )")],
            (false, Edge::Rising) if !modifier.negated => vec![format!("[P]( {tag} )")],
            // The first scan with the tag low counts as a fall in the standard.
            (false, Edge::Falling) if !modifier.negated && is_at_rail => {
                vec![format!("[/]( {tag} )"), "[OSR]".to_owned()]
            }
            (false, Edge::Falling) if !modifier.negated => {
                self.body.note(
                    node,
                    "the first scan with the tag low counts as a fall there, and not here",
                );
                vec![format!("[N]( {tag} )")]
            }
            (false, _) => vec![format!("[ ]( {tag} )")],
        }
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
                if let Some(point) = self.inverted(node, 0, start)? {
                    return Ok(point);
                }
                if let (true, Some(operand)) = (start != RAIL, self.body.operands.get(&(node, 0))) {
                    let text = format!("[/]( {} )", operand.text);
                    return Ok(self.series(start, [text], node));
                }
                let point = self.pin(node, 0, start)?;
                Ok(self.series(point, ["[NOT]".to_owned()], node))
            }
            _ => {
                let text = self.body.condition_text(node, class).map_err(|why| (node, why))?;
                let mut point = start;
                for pin in power_pins(self.body, node) {
                    point = self.pin(node, pin, point)?;
                }
                Ok(self.series(point, [text], node))
            }
        }
    }
}
