//! Blocks that act, as instructions of Click.

use super::value::{Refusal, stripped};
use super::{Above, Back, Meaning};
use crate::notation::click::address::{Span, Tag};
use crate::notation::click::bank::{Bank, Kind};
use crate::notation::click::calc;
use crate::notation::click::model::{
    Action, Coil, Condition, Constant, Contact, ContactKind, CopyOptions, Counter, CounterKind, Instruction,
    Math, MathKind, Operand, Relation, Search, Shift, Timer, TimerKind, Unit,
};
use ladder_analysis::program::{Argument, BinaryOperator, Block, BlockKind, Bound, ExprKind, Place, TagId};
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;
use ladder_instructions::{Op, Timing};

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
fn helper_tag(bound: Option<&Bound>) -> Option<TagId> {
    match &bound?.argument {
        Argument::Place(Place::Tag(tag), _) => Some(*tag),
        Argument::Value(expr) => match &stripped(expr).kind {
            ExprKind::Read(Place::Tag(tag)) => Some(*tag),
            _ => None,
        },
        _ => None,
    }
}

impl Back<'_> {
    /// What the importer says of a tag of its own, if an operand is one.
    pub(super) fn helper(&self, bound: Option<&Bound>) -> Option<(TagId, &str)> {
        let tag = helper_tag(bound)?;
        match self.meaning(tag) {
            Meaning::Helper(what) => Some((tag, what)),
            _ => None,
        }
    }

    /// Blocks one behind the other as actions.
    pub(super) fn actions(&mut self, blocks: &[&Block]) -> Result<Vec<Action>, Refusal> {
        let mut out = Vec::new();
        let mut oneshot = false;
        let mut rest = blocks;
        while let [block, behind @ ..] = rest {
            rest = behind;
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
            let (what, used) = self.instruction(block, behind)?;
            let last = if used == 0 { *block } else { behind[used - 1] };
            rest = &behind[used..];
            let is_pulse = op(block) == Some(Op::RisingCoil);
            out.push(Action {
                place: self.place_of(block.location),
                condition: Condition::ALWAYS,
                what,
                oneshot: oneshot || is_pulse,
                comment: self.comment_behind(last),
            });
        }
        Ok(out)
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
        self.pointers.insert(tag, (by, offset));
        Ok(())
    }

    /// A block as an instruction, and how many of those behind it belong to it.
    fn instruction(&mut self, block: &Block, behind: &[&Block]) -> Result<(Instruction, usize), Refusal> {
        let arguments = &block.arguments[..];
        let unknown = || format!("Click has no {} like this", self.written(block.location.range));
        let Some(op) = op(block) else {
            return Err("Click has no blocks of one's own".to_owned());
        };
        let coil = |bits| Coil {
            bits,
            immediate: false,
        };
        let alone = |what| Ok((what, 0));
        match (op, arguments) {
            (Op::Coil, [target]) => {
                if let Some((tag, what)) = self.helper(Some(target))
                    && what.starts_with("data of ")
                {
                    let bits = what.strip_prefix("data of ").and_then(Span::in_text);
                    let bits = bits.ok_or("the comment of its data tag names no range")?;
                    self.registers.push(tag);
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
                self.through_helper(arguments, behind).ok_or_else(unknown)?
            }
            (Op::Mov | Op::Typ, [target, source]) => {
                let (target, source) = (self.operand(target)?, self.operand(source)?);
                Ok(self.copy(source, target, behind))
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
                    data if data == own => alone(Instruction::Shift(Shift {
                        bits,
                        clock: None,
                        reset: None,
                    })),
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
            (Op::For, [count]) => alone(Instruction::For(self.operand(count)?)),
            (Op::Next, _) => alone(Instruction::Next),
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
                    alone(Instruction::Call(super::meaning::python_name(
                        name.ok_or_else(unknown)?,
                    )))
                }
                _ => Err(unknown()),
            },
            (Op::End, _) => {
                Err("Click cannot stop for good: its END ends a scan, as <RET> does here".to_owned())
            }
            _ => Err(unknown()),
        }
    }

    /// A copy; a text goes into several addresses by as many blocks.
    fn copy(&self, source: Operand, target: Operand, behind: &[&Block]) -> (Instruction, usize) {
        let options = CopyOptions::default();
        let copy = |source, target, used| {
            let options = options.clone();
            (
                Instruction::Copy {
                    source,
                    target,
                    options,
                },
                used,
            )
        };
        let (Operand::Constant(Constant::Text(text)), Operand::Tag(first)) = (&source, &target) else {
            return copy(source, target, 0);
        };
        let Some(start) = first.address().filter(|address| address.bank == Bank::Txt) else {
            return copy(source, target, 0);
        };
        let mut all = text.clone();
        let mut used = 0;
        for block in behind {
            let expected = Tag::number(Bank::Txt, start.number.saturating_add(used as u16 + 1));
            let (Some(Op::Mov), [target, source]) = (op(block), &block.arguments[..]) else {
                break;
            };
            match (self.operand(target), self.operand(source)) {
                (Ok(Operand::Tag(tag)), Ok(Operand::Constant(Constant::Text(more)))) if tag == expected => {
                    all.push_str(&more);
                    used += 1;
                }
                _ => break,
            }
        }
        copy(Operand::Constant(Constant::Text(all)), target, used)
    }

    /// What goes into a tag of the importer's own, and from there where it belongs: a filling, a packed text.
    fn through_helper(
        &self,
        arguments: &[Bound],
        behind: &[&Block],
    ) -> Option<Result<(Instruction, usize), Refusal>> {
        let (tag, _) = self.helper(arguments.first())?;
        let next = behind.first()?;
        let [target, source] = &next.arguments[..] else {
            return None;
        };
        if helper_tag(Some(source)) != Some(tag) {
            return None;
        }
        let options = CopyOptions::default();
        Some(match op(next)? {
            Op::Fill => self.operand(&arguments[1]).and_then(|source| {
                let target = self.span_of(target)?;
                Ok((
                    Instruction::Fill {
                        source,
                        target,
                        options,
                    },
                    1,
                ))
            }),
            Op::Pack => self.characters(&arguments[1..]).and_then(|source| {
                let target = self.tag(target)?;
                Ok((
                    Instruction::Pack {
                        source,
                        target,
                        options,
                    },
                    1,
                ))
            }),
            _ => return None,
        })
    }

    /// Characters one behind the other.
    fn characters(&self, arguments: &[Bound]) -> Result<Span, Refusal> {
        let numbers = arguments.iter().map(|bound| {
            let address = self
                .tag(bound)?
                .address()
                .filter(|address| address.bank == Bank::Txt);
            address
                .map(|address| address.number)
                .ok_or_else(|| "Click packs consecutive characters".to_owned())
        });
        let numbers: Vec<u16> = numbers.collect::<Result<_, Refusal>>()?;
        match (numbers.first(), numbers.last()) {
            (Some(first), Some(last)) if usize::from(last.saturating_sub(*first)) + 1 == numbers.len() => {
                Ok(Span {
                    bank: Bank::Txt,
                    first: *first,
                    last: *last,
                })
            }
            _ => Err("Click packs consecutive characters".to_owned()),
        }
    }

    fn timer(&mut self, kind: TimerKind, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [state, setpoint, pins @ ..] = arguments else {
            return Err("the timer lacks operands".to_owned());
        };
        let tag = self.tag(state)?;
        let is_unit = |bound: &&Bound| bound.operand.is_some_and(|operand| operand.name == "B");
        let (setpoint, unit) = match pins.iter().find(is_unit) {
            Some(unit) => self.setpoint_in(setpoint, unit)?,
            None => self.setpoint(setpoint)?,
        };
        let pins: Vec<Bound> = pins.iter().filter(|bound| !is_unit(bound)).cloned().collect();
        let reset = self.pins(&pins, &["R"])?.pop().flatten();
        if reset.is_some() && !kind.is_retentive() {
            return Err("Click resets retentive timers only".to_owned());
        }
        Ok(Instruction::Timer(Timer {
            kind,
            tag,
            setpoint,
            unit,
            reset,
        }))
    }

    /// A set point where the timer names its unit.
    fn setpoint_in(&self, bound: &Bound, unit: &Bound) -> Result<(Operand, Unit), Refusal> {
        let unit = time(unit).and_then(|size| {
            let mut all = Unit::ALL.iter();
            all.find(|(.., milliseconds)| *milliseconds * MILLISECOND == size)
        });
        let (unit, .., size) =
            unit.ok_or("Click's timers count milliseconds, seconds, minutes, hours or days")?;
        let setpoint = match time(bound) {
            Some(time) => Operand::Constant(Constant::Int(time / (size * MILLISECOND))),
            None => self.operand(bound)?,
        };
        Ok((setpoint, *unit))
    }

    fn setpoint(&self, bound: &Bound) -> Result<(Operand, Unit), Refusal> {
        if let Some(value) = time(bound) {
            // Where timers count milliseconds, they do so however the time is written.
            if self.program.law(self.program.networks[0].location).timing == Timing::Units {
                return Ok((
                    Operand::Constant(Constant::Int(value / MILLISECOND)),
                    Unit::Milliseconds,
                ));
            }
            let written = self.written(bound.range);
            return duration(written, value)
                .ok_or_else(|| "Click counts whole milliseconds up to 32767 days".to_owned());
        }
        // A plain number counts milliseconds here.
        if let Argument::Value(expr) = &bound.argument
            && let ExprKind::Binary(BinaryOperator::Mul, one, number) = &stripped(expr).kind
            && one.range == expr.range
        {
            return Ok((self.value(number)?, Unit::Milliseconds));
        }
        match self.operand(bound)? {
            Operand::Tag(tag) if tag.bank.kind().is_decimal() => Ok((Operand::Tag(tag), Unit::Milliseconds)),
            Operand::Constant(Constant::Int(number)) => {
                Ok((Operand::Constant(Constant::Int(number)), Unit::Milliseconds))
            }
            _ => Err("Click's set points are numbers and DS addresses".to_owned()),
        }
    }

    fn counter(&mut self, kind: CounterKind, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [state, setpoint, pins @ ..] = arguments else {
            return Err("the counter lacks operands".to_owned());
        };
        let mut pins = self.pins(pins, &["CD", "R"])?;
        let reset = pins.pop().flatten();
        let count_down = pins.pop().flatten();
        Ok(Instruction::Counter(Counter {
            kind,
            tag: self.tag(state)?,
            setpoint: self.operand(setpoint)?,
            count_down,
            reset,
        }))
    }

    /// The named operands as conditions, in this order.
    fn pins(&self, given: &[Bound], names: &[&str]) -> Result<Vec<Option<Condition>>, Refusal> {
        let name_of = |bound: &Bound| bound.operand.map_or("", |operand| operand.name);
        if let Some(odd) = given.iter().find(|bound| !names.contains(&name_of(bound))) {
            return Err(format!("Click has no pin {}", name_of(odd)));
        }
        let pin = |name: &&str| {
            let bound = given.iter().find(|bound| name_of(bound) == *name);
            bound.map(|bound| self.pin(bound)).transpose()
        };
        names.iter().map(pin).collect()
    }

    fn pin(&self, bound: &Bound) -> Result<Condition, Refusal> {
        if let Some((tag, _)) = self.helper(Some(bound)) {
            let found = self.conditions.get(&tag).cloned();
            return found.ok_or_else(|| "the rung that computes the pin is missing".to_owned());
        }
        match self.operand(bound)? {
            Operand::Tag(tag) if tag == Tag::number(Bank::Sc, 1) => Ok(Condition::ALWAYS),
            Operand::Tag(tag) => Ok(Condition::Contact(Contact {
                place: self.place_of_range(bound.range),
                kind: ContactKind::Open,
                bits: super::super::model::Bits::One(tag),
            })),
            Operand::Constant(Constant::Bit(true)) => Ok(Condition::ALWAYS),
            _ => Err("Click's pins are contacts".to_owned()),
        }
    }

    fn search(&self, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [result, relation, value, among, named @ ..] = arguments else {
            return Err("the search lacks operands".to_owned());
        };
        let relation = match relation.argument {
            Argument::Operator(op) => relation_of(op),
            _ => None,
        };
        let name_of = |bound: &Bound| bound.operand.map_or("", |operand| operand.name);
        let flag = named.iter().find(|bound| name_of(bound) == "FOUND");
        let flag = flag.ok_or("Click's search tells in a bit whether it found anything: give FOUND =>")?;
        let continuous = match named.iter().find(|bound| name_of(bound) == "NEXT") {
            None => false,
            Some(next) if self.pin(next)?.is_always() => true,
            Some(_) => return Err("a search of Click is continuous or is not: NEXT is always on".to_owned()),
        };
        Ok(Instruction::Search(Search {
            relation: relation.ok_or("the search has no relation")?,
            value: self.operand(value)?,
            among: self.span_of(among)?,
            result: self.tag(result)?,
            flag: self.tag(flag)?,
            continuous,
        }))
    }

    fn math(&self, target: &Bound, formula: &Bound) -> Result<Instruction, Refusal> {
        let Argument::Value(expr) = &formula.argument else {
            return Err("Click has no such formula".to_owned());
        };
        let formula = self.formula(expr)?;
        let target = self.operand(target)?;
        let is_hex = super::super::operand::kind(&target) == Some(Kind::Hex)
            || calc::parts(&formula).contains(&Kind::Hex);
        let kind = if is_hex { MathKind::Hex } else { MathKind::Decimal };
        Ok(Instruction::Math(Math {
            kind,
            formula,
            target,
        }))
    }

    /// `[ADD]( y, a, b )` and its like are formulas in Click.
    fn arithmetic(&self, op: Op, target: &Bound, parts: &[Bound]) -> Result<Instruction, Refusal> {
        use super::super::model::{Formula, Operator};
        let operator = match op {
            Op::Add => Operator::Add,
            Op::Sub => Operator::Subtract,
            Op::Mul => Operator::Multiply,
            Op::Div => Operator::Divide,
            Op::Mod => Operator::Modulo,
            Op::And => Operator::And,
            Op::Or => Operator::Or,
            _ => Operator::Xor,
        };
        let target = self.operand(target)?;
        let mut formula: Option<Formula> = None;
        for part in parts {
            let part = Formula::Value(self.operand(part)?);
            formula = Some(match formula {
                None => part,
                Some(before) => Formula::Binary(Box::new(before), operator, Box::new(part)),
            });
        }
        let formula = formula.ok_or("it has no operands")?;
        let kind = match super::super::operand::kind(&target) {
            Some(Kind::Hex) => MathKind::Hex,
            Some(Kind::Bit | Kind::Text) | None => return Err("Click computes with numbers".to_owned()),
            _ if matches!(op, Op::And | Op::Or | Op::Xor) => {
                return Err("Click combines the bits of WORDs only".to_owned());
            }
            _ => MathKind::Decimal,
        };
        Ok(Instruction::Math(Math {
            kind,
            formula,
            target,
        }))
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
                    self.conditions.insert(tag, condition.clone());
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

pub(super) fn relation_of(op: Op) -> Option<Relation> {
    Some(match op {
        Op::Eq => Relation::Eq,
        Op::Ne => Relation::Ne,
        Op::Lt => Relation::Lt,
        Op::Le => Relation::Le,
        Op::Gt => Relation::Gt,
        Op::Ge => Relation::Ge,
        _ => return None,
    })
}

const MILLISECOND: i64 = 1_000_000;

/// The value of an operand that is a fixed time, in nanoseconds.
fn time(bound: &Bound) -> Option<i64> {
    let Argument::Value(expr) = &bound.argument else {
        return None;
    };
    match stripped(expr).kind {
        ExprKind::Constant(Value::Int(value)) if expr.ty == Scalar::Time => Some(value),
        _ => None,
    }
}

/// A duration in the unit in which it is written, or in the largest that counts it whole.
fn duration(written: &str, nanoseconds: i64) -> Option<(Operand, Unit)> {
    let of = |number: i64, unit| Some((Operand::Constant(Constant::Int(number)), unit));
    let plain = written.to_ascii_lowercase();
    let plain = plain.trim_start_matches("time#").trim_start_matches("t#");
    let digits = plain.find(|c: char| !c.is_ascii_digit()).unwrap_or(0);
    let (number, suffix) = plain.split_at(digits);
    let row = Unit::ALL.iter().find(|(_, _, own, _)| *own == suffix);
    if let (Some((unit, ..)), Ok(number)) = (row, number.parse()) {
        return of(number, *unit);
    }
    if nanoseconds % MILLISECOND != 0 {
        return None;
    }
    let milliseconds = nanoseconds / MILLISECOND;
    let mut units = Unit::ALL.iter().rev();
    let whole =
        units.find(|(.., size)| milliseconds % size == 0 && (1..=32_767).contains(&(milliseconds / size)));
    let (unit, _, _, size) = whole?;
    of(milliseconds / size, *unit)
}
