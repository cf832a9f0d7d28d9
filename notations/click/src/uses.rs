//! What a program reads and writes, and where.

use super::address::{Span, Tag};
use super::convert;
use super::formula;
use super::model::{
    Bits, Condition, Constant, Contact, Instruction, Operand, Pointer, Program, Rung, Search, Steps,
};
use ladder_notation::LineColumn;

/// A use of memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct Use<'p> {
    pub(super) place: LineColumn,
    pub(super) what: What<'p>,
    pub(super) access: Access,
}

/// What is used.
#[derive(Debug, Clone, Copy)]
pub(super) enum What<'p> {
    One(&'p Tag),
    Many(Span),
    /// An address that is found when the program runs.
    Somewhere(&'p Pointer),
    /// This many addresses from this one on.
    From(&'p Tag, usize),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Access {
    Read,
    /// Read as a contact.
    Contact,
    Write,
    /// The bit of a timer or counter, at its own block.
    Own,
}

/// All uses, in the order of the program.
pub(super) fn uses(program: &Program) -> Vec<Use<'_>> {
    let mut out = Uses::default();
    for rung in program.routines().flat_map(|routine| &routine.rungs) {
        out.rung(rung);
    }
    out.all
}

/// What a condition reads.
pub(super) fn of_condition(condition: &Condition) -> Vec<Use<'_>> {
    let mut out = Uses::default();
    out.condition(condition);
    out.all
}

/// What an instruction uses.
pub(super) fn of_instruction(instruction: &Instruction) -> Vec<Use<'_>> {
    let mut out = Uses::default();
    out.instruction(instruction);
    out.all
}

#[derive(Default)]
struct Uses<'p> {
    place: Option<LineColumn>,
    all: Vec<Use<'p>>,
}

impl<'p> Uses<'p> {
    fn push(&mut self, what: What<'p>, access: Access) {
        self.all.push(Use {
            place: self.place.unwrap_or(LineColumn::START),
            what,
            access,
        });
    }

    fn rung(&mut self, rung: &'p Rung) {
        self.condition(&rung.condition);
        for action in &rung.actions {
            self.condition(&action.condition);
            self.place = Some(action.place);
            self.instruction(&action.what);
        }
    }

    fn condition(&mut self, condition: &'p Condition) {
        match condition {
            Condition::All(parts) | Condition::Any(parts) => {
                for part in parts {
                    self.condition(part);
                }
            }
            Condition::Contact(Contact { place, bits, .. }) => {
                self.place = Some(*place);
                self.bits(bits, Access::Contact);
            }
            Condition::Compare(comparison) => {
                self.place = Some(comparison.place);
                self.operand(&comparison.left, Access::Read);
                self.operand(&comparison.right, Access::Read);
            }
        }
    }

    fn bits(&mut self, bits: &'p Bits, access: Access) {
        match bits {
            Bits::One(tag) => self.push(What::One(tag), access),
            Bits::Many(span) => self.push(What::Many(*span), access),
        }
    }

    fn operand(&mut self, operand: &'p Operand, access: Access) {
        match operand {
            Operand::Constant(_) => {}
            Operand::Tag(tag) => self.push(What::One(tag), access),
            Operand::Pointer(pointer) => {
                self.push(What::One(&pointer.by), Access::Read);
                self.push(What::Somewhere(pointer), access);
            }
        }
    }

    /// Pins have places of their own; what follows is at the instruction's again.
    fn pin(&mut self, pin: Option<&'p Condition>) {
        let place = self.place;
        if let Some(condition) = pin {
            self.condition(condition);
        }
        self.place = place;
    }

    fn instruction(&mut self, instruction: &'p Instruction) {
        match instruction {
            Instruction::Out(coil) | Instruction::Set(coil) | Instruction::Reset(coil) => {
                self.bits(&coil.bits, Access::Write);
            }
            Instruction::Timer(timer) => {
                self.push(What::One(&timer.tag), Access::Own);
                self.operand(&timer.setpoint, Access::Read);
                self.pin(timer.reset.as_ref());
            }
            Instruction::Counter(counter) => {
                self.push(What::One(&counter.tag), Access::Own);
                self.operand(&counter.setpoint, Access::Read);
                self.pin(counter.count_down.as_ref());
                self.pin(counter.reset.as_ref());
            }
            Instruction::Copy {
                source,
                target,
                options,
            } => {
                self.operand(source, Access::Read);
                match (source, target) {
                    (_, Operand::Tag(tag)) if options.convert.is_some() => {
                        let left = tag.address().map_or(1, |address| {
                            usize::from(address.bank.last().saturating_sub(address.number)) + 1
                        });
                        let most = options
                            .convert
                            .map_or(1, |convert| convert::most(convert, source));
                        self.push(What::From(tag, most.min(left)), Access::Write);
                    }
                    (Operand::Constant(Constant::Text(text)), Operand::Tag(tag)) => {
                        self.push(What::From(tag, text.chars().count().max(1)), Access::Write);
                    }
                    _ => self.operand(target, Access::Write),
                }
            }
            Instruction::BlockCopy { source, target, .. } => {
                self.push(What::Many(*source), Access::Read);
                self.push(What::From(target, source.len()), Access::Write);
            }
            Instruction::Fill { source, target, .. } => {
                self.operand(source, Access::Read);
                self.push(What::Many(*target), Access::Write);
            }
            Instruction::Pack { source, target, .. } => {
                self.push(What::Many(*source), Access::Read);
                self.push(What::One(target), Access::Write);
            }
            Instruction::Unpack { source, target, .. } => {
                self.push(What::One(source), Access::Read);
                self.push(What::Many(*target), Access::Write);
            }
            Instruction::Shift(shift) => {
                self.pin(shift.clock.as_ref());
                self.pin(shift.reset.as_ref());
                self.push(What::Many(shift.bits), Access::Write);
            }
            Instruction::Search(Search {
                value,
                among,
                result,
                flag,
                ..
            }) => {
                self.operand(value, Access::Read);
                self.push(What::Many(*among), Access::Read);
                self.push(What::One(result), Access::Write);
                self.push(What::One(flag), Access::Write);
            }
            Instruction::Math(math) => {
                let (mut operands, mut sums) = (Vec::new(), Vec::new());
                formula::operands(&math.formula, &mut operands);
                formula::sums(&math.formula, &mut sums);
                for operand in operands {
                    self.operand(operand, Access::Read);
                }
                for span in sums {
                    self.push(What::Many(*span), Access::Read);
                }
                self.operand(&math.target, Access::Write);
            }
            Instruction::Drum(drum) => {
                drum.conditions().for_each(|condition| self.pin(Some(condition)));
                drum.jump_step
                    .iter()
                    .for_each(|step| self.operand(step, Access::Read));
                if let Steps::Times {
                    presets, accumulator, ..
                } = &drum.steps
                {
                    for preset in presets {
                        self.operand(preset, Access::Read);
                    }
                    self.push(What::One(accumulator), Access::Write);
                }
                self.push(What::One(&drum.current_step), Access::Read);
                for written in drum
                    .outputs
                    .iter()
                    .chain([&drum.current_step, &drum.completion_flag])
                {
                    self.push(What::One(written), Access::Write);
                }
            }
            Instruction::For(count) => self.operand(count, Access::Read),
            Instruction::Call(_)
            | Instruction::Next
            | Instruction::End
            | Instruction::Return
            | Instruction::Nop
            | Instruction::Kept { .. } => {}
        }
    }
}
