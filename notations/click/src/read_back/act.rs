//! Blocks that act, as instructions of Click.

use super::copies;
use super::value::{Refusal, stripped};
use super::{Above, Back, Meaning};
use crate::address::{Span, Tag};
use crate::bank::Bank;
use crate::model::{
    Action, Coil, Condition, Constant, CopyOptions, CounterKind, Instruction, Operand, Shift, TimerKind,
};
use crate::python_name::python_name;
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, ExprKind, Place, TagId};
use ladder_instructions::Op;

/// The instruction of a block, if it is one of the table.
pub(super) fn op(block: &Block) -> Option<Op> {
    match block.kind {
        BlockKind::Instruction(instruction) => Some(instruction.op),
        BlockKind::User(_) => None,
    }
}

/// Whether a block lets power through and does nothing else.
pub(super) fn is_condition(block: &Block) -> bool {
    use Op::{Contact as Open, Eq, FallingContact, Ge, Gt, Le, Lt, Ne, NegatedContact, RisingContact};
    matches!(
        op(block),
        Some(Open | NegatedContact | RisingContact | FallingContact | Eq | Ne | Gt | Ge | Lt | Le)
    )
}

/// The tag of the importer's own that an operand is.
pub(super) fn helper_tag(bound: Option<&Bound>) -> Option<TagId> {
    match &bound?.argument {
        Argument::Place(Place::Tag(tag), _) => Some(*tag),
        Argument::Value(expr) => match &stripped(expr).kind {
            ExprKind::Read(Place::Tag(tag)) => Some(*tag),
            _ => None,
        },
        _ => None,
    }
}

const NESTED: &str = "loops do not nest in Click: put the inner loop into a function and <CALL> it";

impl Back<'_> {
    /// What the importer says of a tag of its own, if an operand is one.
    pub(super) fn helper(&self, bound: Option<&Bound>) -> Option<(TagId, &str)> {
        let tag = helper_tag(bound)?;
        match self.meaning(tag) {
            Meaning::Helper(what) => Some((tag, what)),
            _ => None,
        }
    }

    /// Blocks one after the other as actions.
    pub(super) fn actions(&mut self, blocks: &[&Block]) -> Result<Vec<Action>, Refusal> {
        let mut out = Vec::new();
        let mut oneshot = false;
        let mut rest = blocks;
        while let [block, after @ ..] = rest {
            rest = after;
            if let Some(kept) = self.kept(block) {
                out.push(kept);
                continue;
            }
            match op(block) {
                Some(Op::OneShotRising) => {
                    oneshot = true;
                    continue;
                }
                Some(Op::Add) => {
                    if let Some((tag, _)) = self.helper(block.arguments.first()) {
                        self.offset(tag, block)?;
                        continue;
                    }
                }
                _ => {}
            }
            let (what, used) = self.instruction(block, after)?;
            let last = if used == 0 { *block } else { after[used - 1] };
            rest = &after[used..];
            let is_pulse = op(block) == Some(Op::RisingCoil);
            out.push(Action {
                place: self.place_of(block.location),
                condition: Condition::ALWAYS,
                what,
                oneshot: oneshot || is_pulse,
                comment: self.comment_after(last),
            });
        }
        Ok(copies::blocks(out))
    }

    /// What is added to a pointer.
    fn offset(&mut self, tag: TagId, block: &Block) -> Result<(), Refusal> {
        let [_, by, offset] = &block.arguments[..] else {
            return Err("Click has no such pointer".to_owned());
        };
        let by = self.tag(by)?;
        let Operand::Constant(Constant::Int(offset)) = self.operand(offset)? else {
            return Err("a fixed number is added to Click's pointers".to_owned());
        };
        let offset = i32::try_from(offset).map_err(|_| "the number is too large")?;
        self.computed.pointers.insert(tag, (by, offset));
        Ok(())
    }

    /// A block as an instruction, and how many of those after it belong to it.
    fn instruction(&mut self, block: &Block, after: &[&Block]) -> Result<(Instruction, usize), Refusal> {
        let arguments = &block.arguments[..];
        let unknown = || format!("Click has no {} like this", self.written(block.location.range));
        let Some(op) = op(block) else {
            return Ok((self.drum(block)?, 0));
        };
        let coil = |bits| Coil {
            bits,
            immediate: false,
        };
        let alone = |what| Ok((what, 0));
        if let Some(converted) = self.converted(block, after) {
            return converted;
        }
        match (op, arguments) {
            (Op::Coil, [target]) => {
                if let Some((tag, what)) = self.helper(Some(target))
                    && what.starts_with("data of ")
                {
                    let bits = what.strip_prefix("data of ").and_then(Span::in_text);
                    let bits = bits.ok_or("the comment of its data tag names no range")?;
                    self.computed.registers.push(Some(tag));
                    let (clock, reset) = (None, None);
                    return alone(Instruction::Shift(Shift { bits, clock, reset }));
                }
                alone(Instruction::Out(coil(self.bits(target)?)))
            }
            (Op::RisingCoil, [target]) => alone(Instruction::Out(coil(self.bits(target)?))),
            (Op::SetCoil, [target]) => alone(Instruction::Set(coil(self.bits(target)?))),
            (Op::Res | Op::ResetCoil, [target]) => match target.argument {
                Argument::State(tag) => {
                    let mut value = self.state(tag)?;
                    value.bank = if value.bank == Bank::T {
                        Bank::Td
                    } else {
                        Bank::Ctd
                    };
                    alone(Instruction::Copy {
                        source: Operand::Constant(Constant::Int(0)),
                        target: Operand::Tag(value),
                        options: CopyOptions::default(),
                    })
                }
                _ => alone(Instruction::Reset(coil(self.bits(target)?))),
            },
            (Op::Ton, _) => alone(self.timer(TimerKind::On, arguments)?),
            (Op::Tof, _) => alone(self.timer(TimerKind::Off, arguments)?),
            (Op::Rto, _) => alone(self.timer(TimerKind::RetentiveOn, arguments)?),
            (Op::Rtof, _) => alone(self.timer(TimerKind::RetentiveOff, arguments)?),
            (Op::Ctu, _) => alone(self.counter(CounterKind::Up, arguments)?),
            (Op::Ctd, _) => alone(self.counter(CounterKind::Down, arguments)?),
            (Op::Ctud, _) => alone(self.counter(CounterKind::UpDown, arguments)?),
            (Op::Mov | Op::Typ | Op::Concat, [target, ..]) if self.helper(Some(target)).is_some() => {
                self.through_helper(arguments, after).ok_or_else(unknown)?
            }
            (Op::Mov | Op::Typ, [target, source]) => {
                let (target, source) = (self.operand(target)?, self.operand(source)?);
                Ok(self.copy(source, target, after))
            }
            (Op::Bmov, [target, source]) => {
                let source = self.span_of(source)?;
                let start = self.span_of(target)?;
                if start.len() != source.len() && start.len() != 1 {
                    return Err(unknown());
                }
                alone(Instruction::BlockCopy {
                    source,
                    target: Tag::number(start.bank, start.first),
                    options: CopyOptions::default(),
                })
            }
            (Op::Fill, [target, source]) => alone(Instruction::Fill {
                source: self.operand(source)?,
                target: self.span_of(target)?,
                options: CopyOptions::default(),
            }),
            (Op::Pack, [target, source]) => alone(Instruction::Pack {
                source: self.span_of(source)?,
                target: self.tag(target)?,
                options: CopyOptions::default(),
            }),
            (Op::Unpack, [target, source]) => alone(Instruction::Unpack {
                source: self.tag(source)?,
                target: self.span_of(target)?,
                options: CopyOptions::default(),
            }),
            (Op::Shift, [bits, data]) => {
                let bits = self.span_of(bits)?;
                let own = Operand::Tag(Tag::number(bits.bank, bits.first));
                match self.operand(data)? {
                    data if data == own => {
                        self.computed.registers.push(None);
                        alone(Instruction::Shift(Shift {
                            bits,
                            clock: None,
                            reset: None,
                        }))
                    }
                    _ => Err(
                        "Click's shift register takes the power of its rung: use its own first bit here"
                            .to_owned(),
                    ),
                }
            }
            (Op::Search, _) => alone(self.search(arguments)?),
            (Op::Calc, [target, formula]) => alone(self.math(target, formula)?),
            (
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod | Op::And | Op::Or | Op::Xor,
                [target, parts @ ..],
            ) => alone(self.arithmetic(op, target, parts)?),
            (Op::For, [count]) => {
                self.loops += 1;
                if self.loops > 1 {
                    return Err(NESTED.to_owned());
                }
                alone(Instruction::For(self.operand(count)?))
            }
            (Op::Next, _) => {
                self.loops = self.loops.saturating_sub(1);
                if self.loops > 0 {
                    return Err(NESTED.to_owned());
                }
                alone(Instruction::Next)
            }
            (Op::Ret, _) => alone(if self.in_subroutine {
                Instruction::Return
            } else {
                Instruction::End
            }),
            (Op::Call, [function]) => match function.argument {
                Argument::Function(number) => {
                    let name = self
                        .program
                        .functions
                        .get(number)
                        .map(|function| function.name.as_str());
                    alone(Instruction::Call(python_name(name.ok_or_else(unknown)?)))
                }
                _ => Err(unknown()),
            },
            (Op::End, _) => {
                Err("Click cannot stop for good: its END ends a scan, as <RET> does here".to_owned())
            }
            _ => Err(unknown()),
        }
    }

    /// A rung of the importer's own: what it computes is kept for the rung that needs it.
    pub(super) fn above(&mut self, condition: &Condition, blocks: &[&Block]) -> Above {
        // A register that shifts downwards.
        if let [pulse, copy, enter] = blocks
            && let (Some(Op::OneShotRising), Some(Op::Bmov), Some(Op::Mov)) = (op(pulse), op(copy), op(enter))
            && let Some((tag, _)) = self.helper(enter.arguments.get(1))
        {
            return Above::Clock(tag);
        }
        let [block] = blocks else {
            return Above::No;
        };
        let first = block.arguments.first();
        match op(block) {
            Some(Op::Coil) => match self.helper(first) {
                Some((tag, what)) if !what.starts_with("data of ") => {
                    self.computed.conditions.insert(tag, condition.clone());
                    Above::Yes
                }
                _ => Above::No,
            },
            Some(Op::Shift) => match self.helper(block.arguments.get(1)) {
                Some((tag, _)) => Above::Clock(tag),
                None => Above::No,
            },
            _ => Above::No,
        }
    }
}
