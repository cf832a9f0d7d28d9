//! Instructions as blocks of ladder text.

use super::address::{Span, Tag};
use super::bank::{Bank, Kind};
use super::calc;
use super::convert;
use super::drum;
use super::model::{
    Bits, Coil, Condition, Constant, Counter, CounterKind, Instruction, Operand, Search, Timer, TimerKind,
    Unit,
};
use super::operand::{Chain, fits, kind, literal, passes};
use super::ranges::{self, array, range};
use super::tags::Tags;

/// What an instruction becomes.
pub(super) struct Acts {
    /// What is after its condition.
    pub(super) chain: Chain,
    /// Rungs of their own, right above: what pins and set points need.
    pub(super) above: Vec<Above>,
}

/// A rung of the importer's own.
pub(super) struct Above {
    pub(super) condition: Condition,
    pub(super) blocks: Vec<String>,
}

/// Why an instruction has no counterpart.
pub(super) type Refusal = String;

/// The blocks of an instruction. `oneshot`: an output is on for one scan.
pub(super) fn acts(tags: &mut Tags<'_>, what: &Instruction, oneshot: bool) -> Result<Acts, Refusal> {
    let mut acts = Acts {
        chain: Chain::default(),
        above: Vec::new(),
    };
    let chain = &mut acts.chain;
    match what {
        Instruction::Out(target) if oneshot && matches!(target.bits, Bits::One(_)) => {
            coil(tags, chain, "(P)", target)?;
        }
        Instruction::Out(target) => coil(tags, chain, "( )", target)?,
        Instruction::Set(target) => coil(tags, chain, "(S)", target)?,
        Instruction::Reset(target) => coil(tags, chain, "(R)", target)?,
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
            let source = chain.value(tags, &Operand::Tag(source.clone()), None);
            chain.push(format!("[UNPACK]( {}, {source} )", range(target)));
        }
        Instruction::Shift(shift) => {
            array(&shift.bits)?;
            if runs_down(&shift.bits) && shift.clock.is_none() {
                return Err("nothing says what enters it, and [SHIFT] moves bits up".to_owned());
            }
            self::shift(tags, &mut acts, shift);
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
        Instruction::Call(name) => chain.push(format!("<CALL>( {name} )")),
        Instruction::For(count) => {
            let count = chain.value(tags, count, Some(Kind::Int));
            chain.push(format!("<FOR>( {count} )"));
        }
        Instruction::Next => chain.push("<NEXT>".to_owned()),
        Instruction::End | Instruction::Return => chain.push("<RET>".to_owned()),
        Instruction::Nop => {}
        Instruction::Kept { why, .. } => return Err(why.clone()),
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

fn coil(tags: &Tags<'_>, chain: &mut Chain, head: &str, coil: &Coil) -> Result<(), Refusal> {
    match &coil.bits {
        Bits::One(tag) => {
            written(tag)?;
            chain.push(format!("{head}( {} )", tags.text(tag)));
        }
        Bits::Many(span) => {
            array(span)?;
            chain.push(format!("{head}( {} )", range(span)));
        }
    }
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
) -> String {
    use super::model::ContactKind;
    if let Some(seen) = tags.seen(condition) {
        return seen;
    }
    match condition {
        Condition::Contact(contact) if contact.kind == ContactKind::Open => {
            if let Bits::One(tag) = &contact.bits {
                return tags.text(tag);
            }
        }
        condition if condition.is_always() => return "SYS.ON".to_owned(),
        _ => {}
    }
    let helper = tags.helper(&format!("{of}_{word}"), "BOOL", format!("{word} of {of}"));
    acts.above.push(Above {
        condition: condition.clone(),
        blocks: vec![format!("( )( {helper} )")],
    });
    helper
}

fn timer(tags: &mut Tags<'_>, acts: &mut Acts, timer: &Timer) -> Result<(), Refusal> {
    let head = match timer.kind {
        TimerKind::On => "[TON]",
        TimerKind::Off => "[TOF]",
        TimerKind::RetentiveOn => "[RTO]",
        TimerKind::RetentiveOff => "[RTOF]",
    };
    let name = state(tags, &timer.tag)?;
    let setpoint = match &timer.setpoint {
        Operand::Constant(Constant::Int(number)) => format!("T#{number}{}", timer.unit.suffix()),
        Operand::Constant(_) => return Err("a set point is a whole number or a DS address".to_owned()),
        // A plain integer counts the unit.
        other => acts.chain.value(tags, other, None),
    };
    let mut operands = format!("{name}, {setpoint}");
    if let Some(reset) = &timer.reset {
        operands.push_str(&format!(", R := {}", pin(tags, acts, &name, "reset", reset)));
    }
    // A millisecond goes without saying.
    if timer.unit != Unit::Milliseconds {
        operands.push_str(&format!(", B := T#1{}", timer.unit.suffix()));
    }
    acts.chain.push(format!("{head}( {operands} )"));
    Ok(())
}

fn counter(tags: &mut Tags<'_>, acts: &mut Acts, counter: &Counter) -> Result<(), Refusal> {
    let head = match counter.kind {
        CounterKind::Up => "[CTU]",
        CounterKind::Down => "[CTD]",
        CounterKind::UpDown => "[CTUD]",
    };
    let name = state(tags, &counter.tag)?;
    let setpoint = acts.chain.value(tags, &counter.setpoint, Some(Kind::Int2));
    let mut operands = format!("{name}, {setpoint}");
    if let Some(down) = &counter.count_down {
        operands.push_str(&format!(", CD := {}", pin(tags, acts, &name, "down", down)));
    }
    if let Some(reset) = &counter.reset {
        operands.push_str(&format!(", R := {}", pin(tags, acts, &name, "reset", reset)));
    }
    acts.chain.push(format!("{head}( {operands} )"));
    Ok(())
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
    let head = match (direct, numbers) {
        (true, _) => "[MOV]",
        (false, true) => "[TYP]",
        (false, false) => return Err("bits, numbers and texts do not turn into one another".to_owned()),
    };
    let value = match source {
        Operand::Constant(constant) if !direct => literal(constant, None),
        other => chain.value(tags, other, Some(to)),
    };
    let place = chain.place(tags, target);
    chain.push(format!("{head}( {place}, {value} )"));
    ranges::take_pointed(tags, chain, target)
}

/// A text goes into as many addresses as it has characters.
fn texts(tags: &Tags<'_>, chain: &mut Chain, text: &str, first: &Tag) -> Result<(), Refusal> {
    let characters: Vec<char> = text.chars().collect();
    if !text.is_ascii() || characters.is_empty() {
        return Err("a text has one to a thousand characters of ASCII".to_owned());
    }
    if characters.len() == 1 {
        chain.push(format!(
            "[MOV]( {}, {} )",
            tags.text(first),
            super::operand::string(text)
        ));
        return Ok(());
    }
    let start = tags
        .element(first)
        .ok_or("a text goes into several addresses, so the first must be given by its number")?;
    for (number, c) in (start.number..).zip(characters) {
        let character = super::operand::string(&c.to_string());
        chain.push(format!("[MOV]( TXT[{number}], {character} )"));
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
    let place = tags.text(target);
    if source.bank.kind() != Kind::Text {
        chain.push(format!("[PACK]( {place}, {} )", range(source)));
        return Ok(());
    }
    let text = tags.helper("packed_text", "STRING[255]", "characters put together");
    let (first, last) = source.bounds();
    if source.len() > 32 {
        return Err("a number of more than 32 characters is not read".to_owned());
    }
    let characters: Vec<String> = (first..=last).map(|number| format!("TXT[{number}]")).collect();
    let is_hex = target.bank.kind() == Kind::Hex;
    if is_hex && allow_whitespace {
        return Err("blanks around hexadecimal digits are not passed over here".to_owned());
    }
    let base = is_hex.then(|| "'16#'".to_owned());
    let parts: Vec<String> = base.into_iter().chain(characters).collect();
    chain.push(match &parts[..] {
        [one] => format!("[MOV]( {text}, {one} )"),
        all => format!("[CONCAT]( {text}, {} )", all.join(", ")),
    });
    // An address without a character is no part of a number.
    let length = tags.helper("packed_length", "INT", "length of characters put together");
    let whole = source.len() + if is_hex { 3 } else { 0 };
    chain.push(format!("[LEN]( {length}, {text} )"));
    chain.push(format!("[EQ]( {length}, {whole} )"));
    let head = if allow_whitespace { "[TYP]" } else { "[PACK]" };
    chain.push(format!("{head}( {place}, {text} )"));
    Ok(())
}

/// The clock shifts, and the rung's power is what enters; without a clock the rung itself shifts.
fn shift(tags: &mut Tags<'_>, acts: &mut Acts, shift: &super::model::Shift) {
    let bits = range(&shift.bits);
    let first = tags.text(&Tag::number(shift.bits.bank, shift.bits.first));
    match &shift.clock {
        None => {
            acts.chain.push(format!("[SHIFT]( {bits}, {first} )"));
            let why = "nothing says what enters it: the rung shifts, and the first bit stays";
            acts.chain.remark = Some(why.to_owned());
        }
        Some(_) => {
            let data = tags.helper("shift_data", "BOOL", format!("data of {bits}"));
            acts.chain.push(format!("( )( {data} )"));
        }
    }
}

/// Whether a register shifts to lower numbers.
const fn runs_down(bits: &Span) -> bool {
    bits.first > bits.last
}

/// `[SHIFT]` moves bits up only: downwards they are copied, and what enters is written after them.
fn shift_down(tags: &Tags<'_>, bits: &Span, data: &str) -> Vec<String> {
    let (bank, name) = (bits.bank, bits.bank.row().name);
    let (low, high) = (bits.last, bits.first);
    let first = tags.text(&Tag::number(bank, high));
    vec![
        "[OSR]".to_owned(),
        format!(
            "[BMOV]( {name}[{low}..{}], {name}[{}..{high}] )",
            high - 1,
            low + 1
        ),
        format!("[MOV]( {first}, {data} )"),
    ]
}

/// The rungs after a shift register's own: its clock and its reset.
pub(super) fn after(tags: &mut Tags<'_>, what: &Instruction) -> Vec<Above> {
    let Instruction::Shift(shift) = what else {
        return Vec::new();
    };
    let bits = range(&shift.bits);
    let mut out = Vec::new();
    if let Some(clock) = &shift.clock {
        let data = tags.helper("shift_data", "BOOL", format!("data of {bits}"));
        out.push(Above {
            condition: clock.clone(),
            blocks: if runs_down(&shift.bits) {
                shift_down(tags, &shift.bits, &data)
            } else {
                vec![format!("[SHIFT]( {bits}, {data} )")]
            },
        });
    }
    if let Some(reset) = &shift.reset {
        let (first, last) = shift.bits.bounds();
        let bits = range(&Span {
            bank: shift.bits.bank,
            first,
            last,
        });
        out.push(Above {
            condition: reset.clone(),
            blocks: vec![format!("(R)( {bits} )")],
        });
    }
    out
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
    let value = chain.value(tags, &search.value, Some(kind));
    let mut operands = vec![
        tags.text(&search.result),
        search.relation.mnemonic().to_owned(),
        value,
        range(&search.among),
    ];
    if search.continuous {
        operands.push("NEXT := SYS.ON".to_owned());
    }
    operands.push(format!("FOUND => {}", tags.text(&search.flag)));
    chain.push(format!("[SEARCH]( {} )", operands.join(", ")));
    Ok(())
}
