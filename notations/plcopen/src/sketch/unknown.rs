//! Blocks that nothing here knows, and texts in boxes: each is an unread part, and tags hold what it may leave at its outputs.

use super::blocks::{Class, power_pins};
use super::body::Body;
use super::units::{UNREAD, action_name};
use crate::graph::{End, Kind};
use crate::model::Type;
use crate::standard::{self, StandardBlock};
use ladder_format::program::Block;
use ladder_notation::{Power, Turn, Unread};

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
                let operand = self.tags.operands.get(&(node, number))?;
                Some(format!("{} := {}", pin.name, operand.value))
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
