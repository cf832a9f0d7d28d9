//! Instructions as blocks of ladder text.

use super::address::{Span, Tag};
use super::bank::{Bank, Kind};
use super::calc;
use super::convert;
use super::drum;
use super::model::{
    Bits, Coil, Condition, Constant, Counter, CounterKind, Instruction, Operand, Search, Shift, Timer,
    TimerKind, Unit,
};
use super::operand::{Chain, fits, kind, passes};
use super::ranges::{self, array, element, range};
use super::tags::Tags;
use ladder_format::program::{self, Block, Expression, Literal, Path};
use ladder_instructions::Op;

/// What an instruction becomes.
pub(super) struct Acts {
    /// What is after its condition.
    pub(super) chain: Chain,
    /// Rungs of their own, right above: what pins and set points need.
    pub(super) above: Vec<Above>,
    /// The same, right below: the clock and the reset of a shift register.
    pub(super) after: Vec<Above>,
}

/// A rung of the importer's own.
pub(super) struct Above {
    pub(super) condition: Condition,
    pub(super) blocks: Vec<Block>,
}

/// Why an instruction has no counterpart.
pub(super) type Refusal = String;

/// The blocks of an instruction. `oneshot`: it acts for one scan.
pub(super) fn acts(tags: &mut Tags<'_>, what: &Instruction, oneshot: bool) -> Result<Acts, Refusal> {
    let mut acts = Acts {
        chain: Chain::default(),
        above: Vec::new(),
        after: Vec::new(),
    };
    let chain = &mut acts.chain;
    match what {
        Instruction::Out(target) if oneshot && matches!(target.bits, Bits::One(_)) => {
            coil(tags, chain, Op::RisingCoil, target)?;
        }
        Instruction::Out(target) => coil(tags, chain, Op::Coil, target)?,
        Instruction::Set(target) => coil(tags, chain, Op::SetCoil, target)?,
        Instruction::Reset(target) => coil(tags, chain, Op::ResetCoil, target)?,
        Instruction::Timer(timer) => self::timer(tags, &mut acts, timer)?,
        Instruction::Counter(counter) => self::counter(tags, &mut acts, counter)?,
        Instruction::Copy {
            source,
            target,
            options,
        } => match options.convert {
            Some(convert) => convert::copy(tags, chain, (source, target), convert)?,
            None => copy(tags, chain, source, target)?,
        },
        Instruction::BlockCopy {
            source,
            target,
            options,
        } => match options.convert {
            Some(convert) => convert::block(tags, chain, (source, target), convert)?,
            None => ranges::block_copy(tags, chain, source, target)?,
        },
        Instruction::Fill { source, target, .. } => ranges::fill(tags, chain, source, target)?,
        Instruction::Pack {
            source,
            target,
            options,
        } => pack(tags, chain, (source, target), options.allow_whitespace)?,
        Instruction::Unpack { source, target, .. } => {
            array(target)?;
            chain.push(Op::Unpack, [range(target), tags.place(source)])?;
        }
        Instruction::Shift(shift) => {
            array(&shift.bits)?;
            if runs_down(&shift.bits) && shift.clock.is_none() {
                return Err("nothing says what enters it, and [SHIFT] moves bits up".to_owned());
            }
            self::shift(tags, &mut acts, shift)?;
        }
        Instruction::Search(search) => self::search(tags, chain, search)?,
        Instruction::Drum(drum) => drum::acts(tags, &mut acts, drum)?,
        Instruction::Math(math) => {
            let mut before = Chain::default();
            ranges::bring_formula(tags, &mut before, &math.formula)?;
            ranges::bring_pointed(tags, &mut before, &math.target)?;
            let computed = calc::math(tags, math)?;
            before.blocks.extend(computed.blocks);
            *chain = before;
            ranges::take_pointed(tags, chain, &math.target)?;
        }
        Instruction::Call(name) => chain.blocks.push(Block::call(name)),
        Instruction::For(count) => {
            let count = chain.value(tags, count, Some(Kind::Int))?;
            chain.push(Op::For, [count])?;
        }
        Instruction::Next => chain.push(Op::Next, program::Operand::NONE)?,
        Instruction::End | Instruction::Return => chain.blocks.push(Block::ret()),
        Instruction::Nop => {}
        Instruction::Kept { why, .. } => return Err(why.clone()),
    }
    let blocks = &mut acts.chain.blocks;
    if oneshot && !blocks.iter().any(|block| block.op() == Some(Op::RisingCoil)) {
        blocks.insert(0, Block::one_shot());
    }
    Ok(acts)
}

/// A place that the program may write by itself.
pub(super) fn written(tag: &Tag) -> Result<(), Refusal> {
    match tag.bank {
        Bank::T | Bank::Ct => Err("only its own block writes the bit of a timer or counter".to_owned()),
        Bank::Sc if matches!(tag.which, super::address::Which::Number(number) if super::tags::system(number).is_some()) => {
            Err("the controller alone writes it".to_owned())
        }
        _ => Ok(()),
    }
}

fn coil(tags: &Tags<'_>, chain: &mut Chain, op: Op, coil: &Coil) -> Result<(), Refusal> {
    let bits = match &coil.bits {
        Bits::One(tag) => {
            written(tag)?;
            tags.place(tag)
        }
        Bits::Many(span) => {
            array(span)?;
            range(span)
        }
    };
    chain.push(op, [bits])?;
    if coil.immediate {
        chain.remark = Some("outputs change at the end of the scan here".to_owned());
    }
    Ok(())
}

/// A pin as an operand: its contact if it is one, else the result of a rung above.
pub(super) fn pin(
    tags: &mut Tags<'_>,
    acts: &mut Acts,
    of: &str,
    word: &str,
    condition: &Condition,
) -> Expression {
    use super::model::ContactKind;
    if let Some(seen) = tags.seen(condition) {
        return seen;
    }
    match condition {
        Condition::Contact(contact) if contact.kind == ContactKind::Open => {
            if let Bits::One(tag) = &contact.bits {
                return tags.place(tag);
            }
        }
        condition if condition.is_always() => return Path::system("ON").into(),
        _ => {}
    }
    let helper = tags.helper(&format!("{of}_{word}"), "BOOL", format!("{word} of {of}"));
    acts.above.push(Above {
        condition: condition.clone(),
        blocks: vec![Block::coil(helper.clone())],
    });
    helper
}

fn timer(tags: &mut Tags<'_>, acts: &mut Acts, timer: &Timer) -> Result<(), Refusal> {
    let op = match timer.kind {
        TimerKind::On => Op::Ton,
        TimerKind::Off => Op::Tof,
        TimerKind::RetentiveOn => Op::Rto,
        TimerKind::RetentiveOff => Op::Rtof,
    };
    let name = state(tags, &timer.tag)?;
    let setpoint = match &timer.setpoint {
        Operand::Constant(Constant::Int(number)) => duration(*number, timer.unit)?,
        Operand::Constant(_) => return Err("a set point is a whole number or a DS address".to_owned()),
        // A plain integer counts the unit.
        other => acts.chain.value(tags, other, None)?,
    };
    let mut operands = vec![Path::tag(&name).into(), setpoint.into()];
    if let Some(reset) = &timer.reset {
        operands.push(given("R", pin(tags, acts, &name, "reset", reset)));
    }
    // A millisecond goes without saying.
    if timer.unit != Unit::Milliseconds {
        operands.push(given("B", duration(1, timer.unit)?));
    }
    acts.chain.push(op, operands)
}

/// So many of a unit: `T#5s`
pub(super) fn duration(number: i64, unit: Unit) -> Result<Expression, Refusal> {
    Ok(Expression::literal(format!("T#{number}{}", unit.suffix()))?)
}

/// An operand by its name: `R := reset`
pub(super) fn given(name: impl Into<String>, value: impl Into<Expression>) -> program::Operand {
    program::Operand::Given(name.into(), value.into())
}

fn counter(tags: &mut Tags<'_>, acts: &mut Acts, counter: &Counter) -> Result<(), Refusal> {
    let op = match counter.kind {
        CounterKind::Up => Op::Ctu,
        CounterKind::Down => Op::Ctd,
        CounterKind::UpDown => Op::Ctud,
    };
    let name = state(tags, &counter.tag)?;
    let setpoint = acts.chain.value(tags, &counter.setpoint, Some(Kind::Int2))?;
    let mut operands = vec![Path::tag(&name).into(), setpoint.into()];
    if let Some(down) = &counter.count_down {
        operands.push(given("CD", pin(tags, acts, &name, "down", down)));
    }
    if let Some(reset) = &counter.reset {
        operands.push(given("R", pin(tags, acts, &name, "reset", reset)));
    }
    acts.chain.push(op, operands)
}

/// The tag of a timer or counter.
fn state(tags: &Tags<'_>, tag: &Tag) -> Result<String, Refusal> {
    let state = tags
        .state(tag)
        .ok_or("a timer is in bank T, a counter in bank CT")?;
    Ok(state.name.clone())
}

fn copy(tags: &mut Tags<'_>, chain: &mut Chain, source: &Operand, target: &Operand) -> Result<(), Refusal> {
    let Some(to) = kind(target) else {
        return Err("a constant cannot be written".to_owned());
    };
    if let Operand::Tag(tag) = target {
        written(tag)?;
    }
    ranges::bring_pointed(tags, chain, source)?;
    ranges::bring_pointed(tags, chain, target)?;
    if let (Operand::Constant(Constant::Text(text)), Kind::Text, Operand::Tag(tag)) = (source, to, target) {
        return texts(tags, chain, text, tag);
    }
    let direct = match (source, kind(source)) {
        (Operand::Constant(constant), _) => fits(constant, to),
        (_, Some(from)) => passes(from, to),
        (_, None) => false,
    };
    let numbers = !matches!(to, Kind::Bit | Kind::Text)
        && !matches!(kind(source), Some(Kind::Bit | Kind::Text))
        && !matches!(source, Operand::Constant(Constant::Bit(_) | Constant::Text(_)));
    let op = match (direct, numbers) {
        (true, _) => Op::Mov,
        (false, true) => Op::Typ,
        (false, false) => return Err("bits, numbers and texts do not turn into one another".to_owned()),
    };
    let value = chain.value(tags, source, direct.then_some(to))?;
    let place = chain.value(tags, target, None)?;
    chain.push(op, [place, value])?;
    ranges::take_pointed(tags, chain, target)
}

/// A text goes into as many addresses as it has characters.
fn texts(tags: &Tags<'_>, chain: &mut Chain, text: &str, first: &Tag) -> Result<(), Refusal> {
    let characters: Vec<char> = text.chars().collect();
    if !text.is_ascii() || characters.is_empty() {
        return Err("a text has one to a thousand characters of ASCII".to_owned());
    }
    let character = |c: char| Expression::from(Literal::text(&c.to_string()));
    if let [only] = characters[..] {
        return chain.push(Op::Mov, [tags.place(first), character(only)]);
    }
    let start = tags
        .element(first)
        .ok_or("a text goes into several addresses, so the first must be given by its number")?;
    for (number, c) in (start.number..).zip(characters) {
        chain.push(Op::Mov, [element(Bank::Txt, number), character(c)])?;
    }
    Ok(())
}

fn pack(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    (source, target): (&Span, &Tag),
    allow_whitespace: bool,
) -> Result<(), Refusal> {
    ranges::bring(tags, chain, source)?;
    written(target)?;
    let place = tags.place(target);
    if source.bank.kind() != Kind::Text {
        return chain.push(Op::Pack, [place, range(source)]);
    }
    let text = tags.helper("packed_text", "STRING[255]", "characters put together");
    let (first, last) = source.bounds();
    if source.len() > 32 {
        return Err("a number of more than 32 characters is not read".to_owned());
    }
    let is_hex = target.bank.kind() == Kind::Hex;
    if is_hex && allow_whitespace {
        return Err("blanks around hexadecimal digits are not passed over here".to_owned());
    }
    let base = is_hex.then(|| Literal::text("16#").into());
    let characters = (first..=last).map(|number| element(Bank::Txt, number));
    let parts = std::iter::once(text.clone()).chain(base).chain(characters);
    let parts: Vec<Expression> = parts.collect();
    chain.push(if parts.len() == 2 { Op::Mov } else { Op::Concat }, parts)?;
    // An address without a character is no part of a number.
    let length = tags.helper("packed_length", "INT", "length of characters put together");
    let whole = source.len() as i64 + if is_hex { 3 } else { 0 };
    chain.push(Op::Len, [length.clone(), text.clone()])?;
    chain.push(Op::Eq, [length, whole.into()])?;
    let op = if allow_whitespace { Op::Typ } else { Op::Pack };
    chain.push(op, [place, text])
}

/// The clock shifts, and the rung's power is what enters; without a clock the rung itself shifts.
fn shift(tags: &mut Tags<'_>, acts: &mut Acts, shift: &Shift) -> Result<(), Refusal> {
    let bits = range(&shift.bits);
    if let Some(clock) = &shift.clock {
        let data = tags.helper("shift_data", "BOOL", format!("data of {bits}"));
        acts.chain.blocks.push(Block::coil(data.clone()));
        let blocks = if runs_down(&shift.bits) {
            shift_down(tags, &shift.bits, data)?
        } else {
            vec![Block::of(Op::Shift, [bits, data])?]
        };
        acts.after.push(Above {
            condition: clock.clone(),
            blocks,
        });
    } else {
        let why = "nothing says what enters it: the rung shifts, and the first bit stays";
        acts.chain.remark = Some(why.to_owned());
        let first = tags.place(&Tag::number(shift.bits.bank, shift.bits.first));
        acts.chain.push(Op::Shift, [bits, first])?;
    }
    if let Some(reset) = &shift.reset {
        let (first, last) = shift.bits.bounds();
        let bank = shift.bits.bank;
        let bits = range(&Span { bank, first, last });
        acts.after.push(Above {
            condition: reset.clone(),
            blocks: vec![Block::of(Op::ResetCoil, [bits])?],
        });
    }
    Ok(())
}

/// Whether a register shifts to lower numbers.
const fn runs_down(bits: &Span) -> bool {
    bits.first > bits.last
}

/// `[SHIFT]` moves bits up only: downwards they are copied, and what enters is written after them.
fn shift_down(tags: &Tags<'_>, bits: &Span, data: Expression) -> Result<Vec<Block>, Refusal> {
    let of = |first, last| Span {
        bank: bits.bank,
        first,
        last,
    };
    let (low, high) = (bits.last, bits.first);
    let first = tags.place(&Tag::number(bits.bank, high));
    let mut chain = Chain::default();
    chain.blocks.push(Block::one_shot());
    chain.push(Op::Bmov, [range(&of(low, high - 1)), range(&of(low + 1, high))])?;
    chain.push(Op::Mov, [first, data])?;
    Ok(chain.blocks)
}

fn search(tags: &mut Tags<'_>, chain: &mut Chain, search: &Search) -> Result<(), Refusal> {
    ranges::bring(tags, chain, &search.among)?;
    written(&search.result)?;
    written(&search.flag)?;
    if search.among.first > search.among.last {
        return Err("a search goes upwards".to_owned());
    }
    let kind = search.among.bank.kind();
    if kind == Kind::Text
        && !matches!(&search.value, Operand::Constant(Constant::Text(text)) if text.chars().count() == 1)
    {
        return Err("[SEARCH] looks for one character, not for a text".to_owned());
    }
    let value = chain.value(tags, &search.value, Some(kind))?;
    let mut operands: Vec<program::Operand> = vec![
        tags.place(&search.result).into(),
        Path::tag(search.relation.mnemonic()).into(),
        value.into(),
        range(&search.among).into(),
    ];
    if search.continuous {
        operands.push(given("NEXT", Path::system("ON")));
    }
    let found = tags.place(&search.flag);
    operands.push(program::Operand::Taken("FOUND".to_owned(), found));
    chain.push(Op::Search, operands)
}
