//! User-defined blocks (LANGUAGE §5.7). Each place where a block is has a state of its own, so it gets code of
//! its own too: the body is compiled in place, on that place's slots.

use super::arguments::Arguments;
use super::flow::{BodyExit, Kind, holds_any};
use super::place::{Slot, Spot};
use super::range::constant;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::compile_error::CompileError;
use crate::layout::{Borrowed, Home};
use crate::memory::{Bit, TextSlot};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, Network, ParameterKind, Place, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Op, Shape};
use std::collections::HashSet;

/// Blocks inside blocks; compiling them nests as deep.
pub(super) const DEEPEST: usize = 100;

impl Compiler<'_> {
    /// A user-defined block; its power is what the body leaves in ENO.
    pub(super) fn user_block(&mut self, index: usize, block: &Block, en: Bit) -> Result<Bit> {
        let program = self.program;
        let user = &program.blocks[index];
        let refused = |message: String| CompileError {
            message,
            location: block.location,
        };
        if self.regions.len() > DEEPEST {
            return Err(refused(format!(
                "{} is nested deeper than {DEEPEST} blocks",
                user.name
            )));
        }
        let arguments = Arguments::of(block);
        let given = |parameter: usize| {
            block
                .arguments
                .iter()
                .find(|bound| bound.parameter == Some(parameter))
        };
        let out = self.layout.bit();
        // Low until the body has run: a fault in an operand leaves it so.
        self.emit(Instr::Follow { out, en: Bit::LOW });
        let mut references = Vec::new();
        for (number, &(tag, kind)) in user.parameters.iter().enumerate() {
            if kind != ParameterKind::InOut {
                continue;
            }
            let bound = given(number).ok_or_else(|| arguments.mismatch())?;
            let in_body = &user.parts[number];
            let pairs: Vec<(TagId, &Argument)> = match &bound.argument {
                // An array of elementary values is one tag in the body, and one column of what it is a member of.
                Argument::Parts(parts) if in_body.is_empty() => match parts.as_slice() {
                    [part] => vec![(tag, part)],
                    _ => return Err(arguments.mismatch()),
                },
                Argument::Parts(parts) if in_body.len() == parts.len() => {
                    let tags = in_body.iter().filter_map(Place::root);
                    tags.zip(parts).collect()
                }
                Argument::Parts(_) => return Err(arguments.mismatch()),
                one => vec![(tag, one)],
            };
            for (tag, argument) in pairs {
                references.extend(self.references(tag, argument, arguments)?);
            }
        }
        let state = block.arguments.iter().find(|bound| bound.parameter.is_none());
        let owner = match state {
            Some(Bound { argument, .. }) => {
                let inside = self.homes_inside(argument)?;
                let inside = inside.ok_or_else(|| arguments.mismatch())?;
                if let Argument::State(tag) = argument {
                    self.places
                        .named
                        .push((self.standing.clone(), *tag, inside.clone()));
                }
                references.extend(inside);
                self.owner(argument)?
            }
            None => None,
        };
        for &(tag, home) in &references {
            self.homes[tag.0 as usize] = home;
        }
        if state.is_none() {
            self.own_tags(index, &references)?;
        }
        let mut inputs = Vec::new();
        for (number, &(tag, kind)) in user.parameters.iter().enumerate() {
            // A state that is a tag keeps what it is not given.
            let is_kept = state.is_some() && given(number).is_none();
            if kind == ParameterKind::Input && !is_kept {
                match user.parts[number].as_slice() {
                    [] => inputs.push((Place::Tag(tag), self.input(tag, given(number), arguments)?)),
                    parts => inputs.extend(self.whole_input(parts, given(number), arguments)?),
                }
            }
        }
        let outputs = self.outputs(index, block)?;
        if user.unread.is_some() {
            return self.unread_block((index, block), (en, out), inputs, &outputs);
        }
        for (place, value) in inputs {
            let spot = self.spot(&place)?;
            self.store(spot, value);
        }
        self.write_tag(user.en, Slot::Bit(en))?;
        self.write_tag(user.eno, Slot::Bit(en))?;

        let networks = &program.networks[user.networks.clone()];
        let framed = networks.iter().any(needs_frame);
        if framed {
            self.emit(Instr::EnterBody);
        }
        let shown = std::mem::replace(&mut self.shown[index], true);
        let elements = self.elements.len();
        self.skippable[user.networks.clone()].fill(true);
        let (step, powers) = (self.step, std::mem::take(&mut self.powers));
        self.outer_powers.push(powers);
        let kind = Kind::Body(BodyExit {
            outputs: outputs.clone(),
            framed,
            passes_on: user.shape == Shape::Function,
            hidden: shown,
            step,
        });
        let is_owned = owner.is_some();
        self.owners.extend(owner);
        self.stretch(user.networks.clone(), kind)?;
        if is_owned {
            self.owners.pop();
        }
        self.powers = self.outer_powers.pop().unwrap_or_default();
        self.step = step;
        if shown {
            // Drawn once, with the power of the first place.
            self.elements.truncate(elements);
        }
        if framed {
            self.emit(Instr::LeaveBody);
        }
        self.copy_out(&outputs);
        let Slot::Bit(eno) = self.tag_value(user.eno)? else {
            return Err(arguments.mismatch());
        };
        self.emit(Instr::Follow { out, en: eno });
        Ok(out)
    }

    /// Room for the tags of a body, but for its in-outs, which stand for others.
    fn own_tags(&mut self, index: usize, references: &[(TagId, Home)]) -> Result<()> {
        let references: HashSet<TagId> = references.iter().map(|(tag, _)| *tag).collect();
        let tags = std::mem::take(&mut self.block_tags[index]);
        for tag in &tags {
            if !references.contains(tag) {
                self.homes[tag.0 as usize] = self.body_tag(*tag)?;
            }
        }
        self.block_tags[index] = tags;
        Ok(())
    }

    /// What an in-out stands for, which is this tag of the body; of the state of a block also the tags inside.
    fn references(
        &mut self,
        inner: TagId,
        argument: &Argument,
        arguments: Arguments,
    ) -> Result<Vec<(TagId, Home)>> {
        let home = self.reference(inner, argument, arguments)?;
        self.places
            .body_in_outs
            .push((self.standing.clone(), inner, home));
        let mut references = vec![(inner, home)];
        let mut instances = self.program.instances.iter();
        if let Some(instance) = instances.find(|instance| instance.tag == inner) {
            let inside = self.homes_inside(argument)?;
            let inside = inside.ok_or_else(|| arguments.mismatch())?;
            let own = instance.tags.iter().map(|(_, own)| *own);
            references.extend(own.zip(inside.into_iter().map(|(_, home)| home)));
            let owner = self.owner(argument)?;
            self.passed_owners.extend(owner.map(|owner| (inner, owner)));
        }
        Ok(references)
    }

    /// The place that one tag of the body stands for.
    fn reference(&mut self, inner: TagId, argument: &Argument, arguments: Arguments) -> Result<Home> {
        match argument {
            Argument::State(_) | Argument::ChosenState(_) => {
                let home = self.state_home(argument)?;
                home.ok_or_else(|| arguments.mismatch())
            }
            Argument::Range(range) => {
                let home = self.homes[range.tag.0 as usize];
                let first = match self.program.tags[inner.0 as usize].ty {
                    Type::Array { first, .. } => first,
                    _ => 0,
                };
                let ends = (constant(&range.first), range.last.as_deref().and_then(constant));
                match (ends, home) {
                    (_, Home::Borrowed(_)) | ((None, _) | (_, None), _) => {
                        let len = match self.program.tags[inner.0 as usize].ty {
                            Type::Array { first, last, .. } => (last - first + 1) as u32,
                            _ => 1,
                        };
                        let (at, ty) = (self.range(range)?.start, range.element);
                        Ok(Home::Borrowed(Borrowed::Elements { at, first, len, ty }))
                    }
                    ((Some(from), Some(to)), _) => Ok(stretch_of(home, from, to, first)),
                }
            }
            Argument::Place(place, ty) => {
                let spot = self.spot(place)?;
                home_of(spot, *ty).ok_or_else(|| arguments.mismatch())
            }
            _ => Err(arguments.mismatch()),
        }
    }

    /// The values of an input that is a structure or an array.
    fn whole_input(
        &mut self,
        parts: &[Place],
        given: Option<&Bound>,
        arguments: Arguments,
    ) -> Result<Vec<(Place, Slot)>> {
        let mut inputs = Vec::with_capacity(parts.len());
        match given.map(|bound| &bound.argument) {
            Some(Argument::Parts(values)) => {
                for (part, value) in parts.iter().zip(values) {
                    let (place, _) = arguments.as_place(value)?;
                    let spot = self.spot(place)?;
                    inputs.push((part.clone(), self.load(spot)));
                }
            }
            Some(_) => return Err(arguments.mismatch()),
            None => {
                for part in parts {
                    let tag = part.root().ok_or_else(|| arguments.mismatch())?;
                    let declared = &self.program.tags[tag.0 as usize];
                    let (ty, number) = match (declared.ty, part) {
                        (Type::Array { first, element, .. }, Place::Element(_, index)) => {
                            (element, constant(index).unwrap_or(first) - first)
                        }
                        (ty, _) => (ty.scalar().ok_or_else(|| arguments.mismatch())?, 0),
                    };
                    let default = declared.initial.get(number as usize).cloned();
                    let value = self.literal(&default.unwrap_or_else(|| Value::zero(ty)));
                    inputs.push((part.clone(), value));
                }
            }
        }
        Ok(inputs)
    }

    /// An input that is left out has its default in every run.
    fn input(&mut self, tag: TagId, given: Option<&Bound>, arguments: Arguments) -> Result<Slot> {
        match given {
            Some(bound) => self.expression(arguments.as_value(&bound.argument)?),
            None => {
                let declared = &self.program.tags[tag.0 as usize];
                let Type::Scalar(ty) = declared.ty else {
                    return Err(arguments.mismatch());
                };
                let default = declared
                    .initial
                    .first()
                    .cloned()
                    .unwrap_or_else(|| Value::zero(ty));
                Ok(self.literal(&default))
            }
        }
    }

    fn write_tag(&mut self, tag: TagId, value: Slot) -> Result<()> {
        let spot = self.spot(&Place::Tag(tag))?;
        self.store(spot, value);
        Ok(())
    }

    fn tag_value(&mut self, tag: TagId) -> Result<Slot> {
        let spot = self.spot(&Place::Tag(tag))?;
        Ok(self.load(spot))
    }

    /// What the outputs are given for. Like all operands that is found before the body runs, and by what its indices
    /// are then.
    fn outputs(&mut self, index: usize, block: &Block) -> Result<Vec<Output>> {
        let program = self.program;
        let user = &program.blocks[index];
        let mut outputs = Vec::new();
        for bound in &block.arguments {
            let Some(&(tag, ParameterKind::Output)) = bound.parameter.and_then(|n| user.parameters.get(n))
            else {
                continue;
            };
            if let (Some(number), Argument::Parts(places)) = (bound.parameter, &bound.argument) {
                for (part, given) in user.parts[number].iter().zip(places) {
                    let (place, ty) = Arguments::of(block).as_place(given)?;
                    let (read, spot) = (self.spot(part)?, self.spot(place)?);
                    outputs.push(Output {
                        read,
                        from: ty,
                        spot,
                        to: ty,
                    });
                }
                continue;
            }
            let (place, to) = Arguments::of(block).as_place(&bound.argument)?;
            let from = program.tags[tag.0 as usize].ty.scalar().unwrap_or(to);
            let spot = self.spot(place)?;
            let read = self.spot(&Place::Tag(tag))?;
            outputs.push(Output { read, from, spot, to });
        }
        Ok(outputs)
    }

    /// Copies the outputs to what they are given for.
    pub(super) fn copy_out(&mut self, outputs: &[Output]) {
        for output in outputs {
            let value = self.load(output.read);
            let value = self.pass(value, output.from, output.to);
            self.store(output.spot, value);
        }
    }
}

/// An output of a block, and what it is copied to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Output {
    /// Where the body has it.
    pub(super) read: Spot,
    from: Scalar,
    pub(super) spot: Spot,
    pub(super) to: Scalar,
}

/// The elements of an array from one index to another, as an array whose first index is this.
fn stretch_of(home: Home, from: i64, to: i64, index: i64) -> Home {
    let count = (to - from + 1) as u32;
    match home {
        Home::Bits { at, first, .. } => Home::Bits {
            at: at.offset((from - first) as u32),
            first: index,
            len: count,
        },
        Home::Words { at, first, ty, .. } => Home::Words {
            at: at.offset((from - first) as u32),
            first: index,
            len: count,
            ty,
        },
        Home::Texts { at, first, max, .. } => Home::Texts {
            at: TextSlot(at.0 + (from - first) as u32),
            first: index,
            len: count,
            max,
        },
        other => other,
    }
}

/// A place as the home of a tag.
pub(super) fn home_of(spot: Spot, ty: Scalar) -> Option<Home> {
    Some(match spot {
        Spot::Bit(at) => Home::Bits { at, first: 0, len: 1 },
        Spot::Word(at) => Home::Words {
            at,
            first: 0,
            len: 1,
            ty,
        },
        Spot::Text(at) => Home::Texts {
            at,
            first: 0,
            len: 1,
            max: 0,
        },
        Spot::BitAt(at) | Spot::WordAt(at) | Spot::TextAt { at, .. } => {
            let (first, len) = (0, 1);
            Home::Borrowed(Borrowed::Elements { at, first, len, ty })
        }
        Spot::BitOf { word, bit, width } => Home::Borrowed(Borrowed::BitOf { word, bit, width }),
        Spot::BitOfAt { at, bit, width } => Home::Borrowed(Borrowed::BitOfAt { at, bit, width }),
        Spot::As { word, stored, ty } => Home::Borrowed(Borrowed::As { word, stored, ty }),
        Spot::Timing { .. } | Spot::TimingAt { .. } => return None,
    })
}

/// Whether a body's network has jumps, loops or rails of its own.
fn needs_frame(network: &Network) -> bool {
    let flow = [Op::Jmp, Op::Ret, Op::For, Op::Next, Op::Mcr];
    holds_any(network, &flow)
        || network
            .blocks
            .iter()
            .any(|block| matches!(block.kind, BlockKind::User(_)))
}
