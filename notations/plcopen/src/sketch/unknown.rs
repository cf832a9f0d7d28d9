//! Blocks that nothing here knows, and texts in boxes: each is an unread part, and tags hold what it may leave at its outputs.

use super::blocks::{self, Class, may_be_unread, power_pins};
use super::body::Body;
use super::units::{UNREAD, action_name};
use crate::graph::{End, Kind};
use crate::model::Type;
use crate::standard::{self, StandardBlock};
use ladder_format::program::Block;
use ladder_notation::{Outcome, Power, Turn, Unread};

impl Body<'_> {
    /// Says of an element that it is not read.
    pub(super) fn note_unread(&mut self, node: usize) {
        let why = match &self.graph.nodes[node].kind {
            Kind::Block { name, code: None, .. } => {
                format!("neither the project nor ladder text has a block `{name}`: {UNREAD}")
            }
            _ => format!("{}: {UNREAD}", self.why_no_text(node).unwrap_or("ST is not read")),
        };
        self.note(node, &why);
    }

    /// The block that says so: `[$MYSTERY]( 'a := start, q => MYSTERY_q' )`.
    pub(super) fn unread(&mut self, node: usize) -> Result<Block, String> {
        let Kind::Block { name, instance, code } = &self.graph.nodes[node].kind else {
            return Err("it is not a block".to_owned());
        };
        let because = self
            .why_no_text(node)
            .map_or_else(String::new, |why| format!(" ({why})"));
        let about = format!("{name} is not read{because}: {UNREAD}.");
        let part = |text| Unread {
            name,
            about: &about,
            text,
            writes: None,
            power: Power::Passes,
            turn: Turn::Here,
        };
        let shared = self.shared;
        let is_taken = |name: &str| shared.has_block(name);
        if let Some(code) = code {
            return Ok(self.made.unread.body(part(&code.text), is_taken));
        }
        let power = power_pins(self, node);
        let inputs = self.graph.nodes[node].inputs.iter().enumerate();
        let inputs = inputs
            .filter(|(pin, _)| !power.contains(pin))
            .filter_map(|(number, pin)| {
                let operand = self.tags.operands.get(&(node, number));
                let own = pin.from.first().map(|end| &self.graph.nodes[end.node].kind);
                match (operand, own) {
                    (Some(operand), _) => Some(format!("{} := {}", pin.name, operand.value)),
                    (None, Some(Kind::Value(text, _))) => Some(format!("{} := {text}", pin.name)),
                    (None, _) => None,
                }
            });
        let outputs = self.graph.nodes[node].outputs.iter().enumerate();
        let outputs = outputs.filter_map(|(output, pin)| {
            let tag = self.tags.results.get(&End { node, output })?;
            Some(format!("{} => {tag}", pin.name))
        });
        let operands: Vec<String> = instance.iter().cloned().chain(inputs).chain(outputs).collect();
        let mut text = operands.join(", ");
        if let Some(action) = self.made.actions.get(&action_name(name)) {
            text.push_str(&format!("\n{action}"));
        }
        Ok(self.made.unread.block(part(&text), is_taken))
    }

    /// The block that stands for an element that was refused, if it is one that something may stand for.
    pub(super) fn unread_element(&mut self, node: usize) -> Option<Block> {
        let Some(Outcome::Refused(why)) = &self.state.outcomes[node] else {
            return None;
        };
        let drawn = &self.graph.nodes[node];
        if !may_be_unread(&drawn.kind) {
            return None;
        }
        let shown = blocks::shown(drawn);
        let about = format!("{shown}: {why}; it is not run here.");
        let is_condition = match drawn.kind {
            Kind::Contact(..) | Kind::Value(..) => true,
            Kind::Block { .. } => !self.class(node).is_some_and(Class::acts),
            _ => false,
        };
        let written = match &drawn.kind {
            Kind::Coil(text, ..) | Kind::Variable(text, _) => self.variable(text).ok(),
            _ => None,
        };
        let written = written.map(|path| vec![path.root]);
        let text = match &drawn.kind {
            Kind::Block { .. } => self.wired(node).join(", "),
            Kind::Contact(text, _) | Kind::Coil(text, ..) => text.clone(),
            Kind::Value(text, _) | Kind::Variable(text, _) => text.clone(),
            _ => String::new(),
        };
        let part = Unread {
            name: &shown,
            about: &about,
            text: &text,
            writes: if is_condition {
                Some(&[])
            } else {
                written.as_deref()
            },
            power: if is_condition { Power::Ends } else { Power::Passes },
            turn: Turn::Here,
        };
        let shared = self.shared;
        Some(self.made.unread.block(part, |name| shared.has_block(name)))
    }

    /// What is wired to the pins of a block, as the source has it.
    fn wired(&self, node: usize) -> Vec<String> {
        let drawn = &self.graph.nodes[node];
        let mut all = Vec::new();
        for pin in &drawn.inputs {
            for end in &pin.from {
                if let Kind::Value(text, _) = &self.graph.nodes[end.node].kind {
                    all.push(format!("{} := {text}", pin.name));
                }
            }
        }
        for (output, pin) in drawn.outputs.iter().enumerate() {
            for user in self.facts.uses.get(&End { node, output }).into_iter().flatten() {
                if let Kind::Variable(text, _) = &self.graph.nodes[*user].kind {
                    all.push(format!("{} => {text}", pin.name));
                }
            }
        }
        all
    }

    /// Whether an element is a value that only unread parts take: it is in their texts.
    pub(super) fn is_of_unread(&self, node: usize) -> bool {
        let end = End { node, output: 0 };
        let users = self.facts.uses.get(&end).map_or(&[][..], Vec::as_slice);
        let is_value = matches!(self.graph.nodes[node].kind, Kind::Value(..));
        is_value
            && !users.is_empty()
            && users.iter().all(|user| {
                let is_unread = self.is_refused(*user) || self.class(*user) == Some(Class::Unknown);
                is_unread && self.state.seen[*user] && may_be_unread(&self.graph.nodes[*user].kind)
            })
    }

    /// The type that an output of a block that nothing knows must have for what takes it.
    pub(super) fn type_asked_of_unknown(&self, end: End) -> Option<Type> {
        if self.class(end.node) != Some(Class::Unknown) {
            return None;
        }
        let named = |name: &str| Some(Type::Named(name.to_owned()));
        let mut waiting = vec![end];
        for _ in 0..self.graph.nodes.len() {
            let end = waiting.pop()?;
            for user in self.facts.uses.get(&end).into_iter().flatten() {
                let drawn = &self.graph.nodes[*user];
                let pin = drawn.inputs.iter().find(|pin| pin.from.contains(&end))?;
                let found = match (&drawn.kind, self.class(*user)) {
                    (Kind::Contact(..) | Kind::Coil(..) | Kind::Jump(..) | Kind::Return(_), _)
                    | (_, Some(Class::Gate(_))) => named("BOOL"),
                    (Kind::Joint, _) => {
                        waiting.push(End {
                            node: *user,
                            output: 0,
                        });
                        None
                    }
                    (Kind::Block { name, .. }, Some(Class::Unit(_))) => {
                        let block = self.shared.blocks.get(&name.to_lowercase());
                        block
                            .and_then(|block| block.scope.get(&pin.name))
                            .map(|known| known.ty.clone())
                    }
                    (_, Some(Class::Standard(StandardBlock::Stateful(..)))) => {
                        let is = |name| standard::is_pin(&pin.name, name);
                        match (is("PT"), is("PV")) {
                            (true, _) => named("TIME"),
                            (_, true) => named("INT"),
                            _ => named("BOOL"),
                        }
                    }
                    (_, Some(Class::Standard(_))) => named("BOOL"),
                    _ => None,
                };
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }
}
