//! EN and ENO: what a function has without power, which is 0 where it is compiled as Beremiz and OpenPLC do, while variables that take
//! its result keep theirs; and the ENO of a block with a state, which is what came to its EN.

use super::blocks::{Class, is_enable, is_enable_out};
use super::body::Body;
use super::draw::Target;
use super::initial::zero;
use super::prepare::Seen;
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
        // What takes its own result reads what that was before.
        let is_own = uses.contains(&node);
        let ty = self.out_type(end).or_else(|| self.type_taken(end));
        let Some(zero) = ty.and_then(|ty| zero(self.shared, &ty)).filter(|_| !is_own) else {
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

    /// A tag with what comes to EN of a timer, a counter or their like, where something takes ENO.
    pub(super) fn enabled(&mut self, node: usize, seen: &mut Seen) {
        let Some((pin, end)) = self.enable_taken(node) else {
            return;
        };
        if !self.tags.results.contains_key(&end) {
            self.prepare_power(node, pin, seen);
            let tag = match self.tags.holders.get(&end) {
                Some(tag) => tag.clone(),
                None => self.helper("enabled", "BOOL", "what comes to EN"),
            };
            self.put_power(Target::Pin(node, pin, tag.clone()));
            self.tags.results.insert(end, tag);
        }
    }

    /// The pin EN of such a block, and its ENO, where something takes that.
    pub(super) fn enable_taken(&self, node: usize) -> Option<(usize, End)> {
        if !matches!(self.class(node), Some(Class::Standard(_))) {
            return None;
        }
        let drawn = &self.graph.nodes[node];
        let pin = drawn.inputs.iter().position(|pin| is_enable(&pin.name))?;
        let output = drawn
            .outputs
            .iter()
            .position(|output| is_enable_out(&output.name))?;
        let end = End { node, output };
        self.facts.uses.contains_key(&end).then_some((pin, end))
    }

    /// Whether a variable takes the ENO of a block whose EN is wired: compiled, it is written only while that is high.
    pub(super) fn takes_own_enable(&self, node: usize) -> bool {
        let pin = self.graph.nodes[node].inputs.first();
        let Some([end]) = pin.map(|pin| &pin.from[..]) else {
            return false;
        };
        let source = &self.graph.nodes[end.node];
        let has_enable = source.inputs.iter().any(|pin| is_enable(&pin.name));
        let takes_enable = source
            .outputs
            .get(end.output)
            .is_some_and(|output| is_enable_out(&output.name));
        self.shared.is_compiled && has_enable && takes_enable
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
