//! Tags of which a computed index chooses one: elements of arrays of timers, counters and blocks. Each is a tag of its own, and
//! they are laid out at equal distances, so that one is found by a multiplication and an addition.

use super::place::Spot;
use super::{Compiler, Result};
use crate::compile_error::CompileError;
use crate::layout::{self, Borrowed, Home, MemberSlot};
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use ladder_analysis::program::{Argument, Chosen, Instance, Member, TagId};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::StateType;

/// Where the state of a timer, counter or bistable begins.
#[derive(Debug, Clone, Copy)]
pub(super) enum StateSpot {
    Fixed {
        bits: Bit,
        words: Word,
    },
    /// The words hold the slots.
    At {
        bits: Word,
        words: Word,
    },
}

impl Compiler<'_> {
    /// The tag that an index chooses.
    pub(super) fn chosen(&mut self, chosen: &Chosen) -> Result<Home> {
        let number = self.count(&chosen.number)?;
        let second = chosen.first.0 + chosen.step;
        let zero = self.homes[chosen.first.0 as usize];
        let one = match chosen.count {
            0 | 1 => zero,
            _ => self.homes[second as usize],
        };
        self.nth(number, zero, one)
            .ok_or_else(|| self.uneven(chosen.first))
    }

    /// The home after so many others, by the first two.
    pub(super) fn nth(&mut self, number: Word, zero: Home, one: Home) -> Option<Home> {
        let elements = |at, first, len, ty| Home::Borrowed(Borrowed::Elements { at, first, len, ty });
        Some(match (zero, one) {
            (Home::Bits { at, first, len }, Home::Bits { at: next, .. }) => {
                elements(self.slot(number, at.0, next.0), first, len, Scalar::Bool)
            }
            (Home::Words { at, first, len, ty }, Home::Words { at: next, .. }) => {
                elements(self.slot(number, at.0, next.0), first, len, ty)
            }
            (Home::Texts { at, first, len, max }, Home::Texts { at: next, .. }) => {
                elements(self.slot(number, at.0, next.0), first, len, Scalar::String(max))
            }
            (
                Home::State { state, bits, words },
                Home::State {
                    bits: next_bits,
                    words: next_words,
                    ..
                },
            ) => Home::Borrowed(Borrowed::State {
                state,
                bits: self.slot(number, bits.0, next_bits.0),
                words: self.slot(number, words.0, next_words.0),
            }),
            (
                Home::Borrowed(Borrowed::Elements { at, first, len, ty }),
                Home::Borrowed(Borrowed::Elements { at: next, .. }),
            ) => elements(self.slot_after(number, at, next), first, len, ty),
            (
                Home::Borrowed(Borrowed::State { state, bits, words }),
                Home::Borrowed(Borrowed::State {
                    bits: next_bits,
                    words: next_words,
                    ..
                }),
            ) => Home::Borrowed(Borrowed::State {
                state,
                bits: self.slot_after(number, bits, next_bits),
                words: self.slot_after(number, words, next_words),
            }),
            (unbound @ Home::Borrowed(Borrowed::Unbound), _) => unbound,
            _ => return None,
        })
    }

    /// The slot of one of several at equal distances.
    fn slot(&mut self, number: Word, zero: u32, one: u32) -> Word {
        let step = self.constant(i64::from(one) - i64::from(zero));
        let scaled = self.integer(IntegerOp::Mul, Scalar::Lint, number, step);
        let zero = self.constant(i64::from(zero));
        self.integer(IntegerOp::Add, Scalar::Lint, scaled, zero)
    }

    /// The same, where the slots of the first two are known only when they are reached.
    fn slot_after(&mut self, number: Word, zero: Word, one: Word) -> Word {
        if zero == one {
            return zero;
        }
        let step = self.integer(IntegerOp::Sub, Scalar::Lint, one, zero);
        let scaled = self.integer(IntegerOp::Mul, Scalar::Lint, number, step);
        self.integer(IntegerOp::Add, Scalar::Lint, scaled, zero)
    }

    /// The word that holds a slot this many after the one in a word.
    pub(super) fn slot_offset(&mut self, at: Word, by: u32) -> Word {
        if by == 0 {
            return at;
        }
        let by = self.constant(i64::from(by));
        self.integer(IntegerOp::Add, Scalar::Lint, at, by)
    }

    /// A member of a timer, counter or bistable.
    pub(super) fn member(&mut self, home: Home, member: Member) -> Spot {
        match home {
            Home::State { state, bits, words } => match layout::member(state, bits, words, member) {
                Some(MemberSlot::Bit(slot)) => Spot::Bit(slot),
                Some(MemberSlot::Word(slot)) => Spot::Word(slot),
                Some(MemberSlot::Timing { input, done }) => Spot::Timing { input, done },
                None => Spot::Bit(Bit::LOW),
            },
            Home::Borrowed(Borrowed::State { state, bits, words }) => {
                match layout::member(state, Bit(0), Word(0), member) {
                    Some(MemberSlot::Bit(slot)) => Spot::BitAt(self.slot_offset(bits, slot.0)),
                    Some(MemberSlot::Word(slot)) => Spot::WordAt(self.slot_offset(words, slot.0)),
                    Some(MemberSlot::Timing { input, done }) => Spot::TimingAt {
                        input: self.slot_offset(bits, input.0),
                        done: self.slot_offset(bits, done.0),
                    },
                    None => Spot::Bit(Bit::LOW),
                }
            }
            _ => Spot::Bit(Bit::LOW),
        }
    }

    /// The state that an argument names.
    pub(super) fn state_home(&mut self, argument: &Argument) -> Result<Option<Home>> {
        Ok(match argument {
            Argument::State(tag) => Some(self.homes[tag.0 as usize]),
            Argument::ChosenState(chosen) => Some(self.chosen(chosen)?),
            _ => None,
        })
    }

    /// Where the state of a timer, counter or bistable begins.
    pub(super) fn state_spot(&mut self, argument: &Argument) -> Result<Option<(StateType, StateSpot)>> {
        Ok(match self.state_home(argument)? {
            Some(Home::State { state, bits, words }) => Some((state, StateSpot::Fixed { bits, words })),
            Some(Home::Borrowed(Borrowed::State { state, bits, words })) => {
                Some((state, StateSpot::At { bits, words }))
            }
            _ => None,
        })
    }

    /// The tags of a block's body, as the state of the block has them that an argument names.
    pub(super) fn homes_inside(&mut self, argument: &Argument) -> Result<Option<Vec<(TagId, Home)>>> {
        let program = self.program;
        let instance = |tag: TagId| {
            let mut all = program.instances.iter();
            all.find(|instance| instance.tag == tag)
        };
        match argument {
            Argument::State(tag) => Ok(instance(*tag).map(|Instance { tags, .. }| {
                let homes = tags.iter();
                homes
                    .map(|(body, own)| (*body, self.homes[own.0 as usize]))
                    .collect()
            })),
            Argument::ChosenState(chosen) => {
                let Some(first) = instance(chosen.first) else {
                    return Ok(None);
                };
                let second = TagId(chosen.first.0 + chosen.step);
                let second = instance(second).filter(|_| chosen.count > 1).unwrap_or(first);
                let number = self.count(&chosen.number)?;
                let mut homes = Vec::with_capacity(first.tags.len());
                for ((body, zero), (_, one)) in first.tags.iter().zip(&second.tags) {
                    let (zero, one) = (self.homes[zero.0 as usize], self.homes[one.0 as usize]);
                    let home = self.nth(number, zero, one);
                    homes.push((*body, home.ok_or_else(|| self.uneven(chosen.first))?));
                }
                Ok(Some(homes))
            }
            _ => Ok(None),
        }
    }

    /// Elements of one array are laid out alike: an error in the layout, not in the program.
    fn uneven(&self, tag: TagId) -> CompileError {
        let tag = &self.program.tags[tag.0 as usize];
        CompileError {
            message: format!(
                "the simulator cannot choose among the elements of {}; please report the program",
                tag.name
            ),
            location: tag.location,
        }
    }
}
