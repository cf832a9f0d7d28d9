//! What a function with EN has without power: 0, where it is compiled as Beremiz and OpenPLC do. Variables that take its result
//! keep theirs.

use super::blocks::{Class, is_enable};
use super::body::Body;
use super::initial::zero;
use crate::graph::{End, Kind};
use crate::model::Type;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Invalid, Path};
use ladder_instructions::Op;

impl Body<'_> {
    /// Puts 0 into the tag of a result that other blocks take, above the block that makes it.
    pub(super) fn begin_with_nothing(&mut self, node: usize, end: End, tag: &Path) -> Result<(), Invalid> {
        let is_rail = |end: &End| self.graph.nodes[end.node].kind == Kind::LeftRail;
        let mut pins = self.graph.nodes[node].inputs.iter();
        let may_be_low = pins.any(|pin| is_enable(&pin.name) && !pin.from.iter().any(is_rail));
        let uses = self.facts.uses.get(&end).map_or(&[][..], Vec::as_slice);
        let is_variable = |user: &usize| matches!(self.graph.nodes[*user].kind, Kind::Variable(..));
        if !self.shared.is_compiled || !may_be_low || uses.iter().all(is_variable) {
            return Ok(());
        }
        let ty = self.out_type(end).or_else(|| self.type_taken(end));
        let Some(zero) = ty.and_then(|ty| zero(self.shared, &ty)) else {
            self.note(
                node,
                "without power at EN its result is as it was here, and nothing there",
            );
            return Ok(());
        };
        self.flush();
        let origin = self.reading.origin(self.graph.nodes[node].place);
        let block = Block::of(Op::Mov, [Expression::from(tag), zero.into()])?;
        self.push(Circuit::Element(Element::of(block, Some(origin))));
        Ok(())
    }

    /// The type of the variable that takes a value in the end: what is made of numbers alone has that of its place.
    pub(super) fn type_taken(&self, end: End) -> Option<Type> {
        let mut waiting = vec![end];
        for _ in 0..self.graph.nodes.len() {
            let end = waiting.pop()?;
            for user in self.facts.uses.get(&end).into_iter().flatten() {
                let found = match &self.graph.nodes[*user].kind {
                    Kind::Variable(text, _) => self.operand(text).ok().and_then(|operand| operand.ty),
                    Kind::Block { .. } if matches!(self.class(*user), Some(Class::Value(_))) => {
                        let outputs = 0..self.graph.nodes[*user].outputs.len();
                        waiting.extend(outputs.map(|output| End { node: *user, output }));
                        None
                    }
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
