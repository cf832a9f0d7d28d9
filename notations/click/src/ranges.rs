//! Ranges and pointers as ladder text has them.
//!
//! The bits and values of timers and counters belong to their blocks, and are no array here. Where the program takes them as
//! one, there is an array of that name which holds copies: they are brought there before an instruction reads, and taken
//! back after it wrote.

use super::act::{Refusal, written};
use super::address::{Span, Tag};
use super::bank::{Bank, Kind};
use super::formula;
use super::model::{Constant, Formula, Operand, Pointer};
use super::operand::{Chain, fits, kind, literal, passes};
use super::tags::Tags;

/// A block between kinds of more addresses is not copied: each takes a block of its own.
pub(super) const MOST_CONVERTED: usize = 200;

/// A range as ladder text writes it.
pub(super) fn range(span: &Span) -> String {
    let (first, last) = (span.first, span.last);
    format!("{}[{first}..{last}]", span.bank.array())
}

/// Whether the addresses of a bank belong to blocks.
pub(super) const fn is_of_blocks(bank: Bank) -> bool {
    matches!(bank, Bank::T | Bank::Ct | Bank::Td | Bank::Ctd)
}

/// A range that is an array of its own.
pub(super) fn array(span: &Span) -> Result<(), Refusal> {
    if is_of_blocks(span.bank) {
        return Err("only their own blocks write the bits of timers and counters".to_owned());
    }
    Ok(())
}

/// Brings what the blocks of a range hold into their array.
pub(super) fn bring(tags: &mut Tags<'_>, chain: &mut Chain, span: &Span) -> Result<(), Refusal> {
    for (element, value) in tags.copies(span)? {
        chain.push(format!("[MOV]( {element}, {value} )"));
    }
    Ok(())
}

/// Takes what an array holds to the blocks of a range.
fn take(tags: &mut Tags<'_>, chain: &mut Chain, span: &Span) -> Result<(), Refusal> {
    for (element, value) in tags.copies(span)? {
        chain.push(format!("[MOV]( {value}, {element} )"));
    }
    Ok(())
}

/// All addresses that a pointer may reach.
fn reached(pointer: &Pointer) -> Span {
    Span {
        bank: pointer.bank,
        first: pointer.bank.row().numbers[0].0,
        last: pointer.bank.last(),
    }
}

/// As [`bring`], for what a pointer may reach.
pub(super) fn bring_pointed(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    operand: &Operand,
) -> Result<(), Refusal> {
    match operand {
        Operand::Pointer(pointer) => bring(tags, chain, &reached(pointer)),
        _ => Ok(()),
    }
}

/// As [`take`], for what a pointer may reach.
pub(super) fn take_pointed(tags: &mut Tags<'_>, chain: &mut Chain, operand: &Operand) -> Result<(), Refusal> {
    match operand {
        Operand::Pointer(pointer) if matches!(pointer.bank, Bank::T | Bank::Ct) => array(&reached(pointer)),
        Operand::Pointer(pointer) => take(tags, chain, &reached(pointer)),
        _ => Ok(()),
    }
}

/// As [`bring`], for the sums and pointers of a formula.
pub(super) fn bring_formula(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    formula: &Formula,
) -> Result<(), Refusal> {
    let (mut operands, mut sums) = (Vec::new(), Vec::new());
    formula::operands(formula, &mut operands);
    formula::sums(formula, &mut sums);
    for span in sums {
        bring(tags, chain, span)?;
    }
    for operand in operands {
        bring_pointed(tags, chain, operand)?;
    }
    Ok(())
}

/// Whether a value is a number.
const fn is_number(kind: Kind) -> bool {
    !matches!(kind, Kind::Bit | Kind::Text)
}

pub(super) fn block_copy(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    source: &Span,
    target: &Tag,
) -> Result<(), Refusal> {
    written(target)?;
    let (from, to) = (source.bank.kind(), target.bank.kind());
    if from != to && !(is_number(from) && is_number(to)) {
        return Err("bits, numbers and texts do not turn into one another".to_owned());
    }
    let Some(first) = tags.address(target).map(|address| address.number) else {
        if source.len() == 1 {
            let head = if passes(from, to) { "[MOV]" } else { "[TYP]" };
            let source = Tag::number(source.bank, source.first);
            chain.push(format!("{head}( {}, {} )", tags.text(target), tags.text(&source)));
            return Ok(());
        }
        return Err("the first of several addresses must be given by its number".to_owned());
    };
    let last = first.saturating_add(u16::try_from(source.len() - 1).unwrap_or(u16::MAX));
    let span = Span {
        bank: target.bank,
        first,
        last,
    };
    bring(tags, chain, source)?;
    if from == to {
        chain.push(format!(
            "[BMOV]( {}[{first}], {} )",
            span.bank.array(),
            range(source)
        ));
    } else {
        if source.len() > MOST_CONVERTED {
            return Err(format!(
                "more than {MOST_CONVERTED} addresses do not turn into another kind at once: make several blocks of it"
            ));
        }
        let head = if passes(from, to) { "[MOV]" } else { "[TYP]" };
        let names = (span.bank.array(), source.bank.array());
        for (to, from) in (first..=last).zip(source.first..) {
            chain.push(format!("{head}( {}[{to}], {}[{from}] )", names.0, names.1));
        }
    }
    take(tags, chain, &span)
}

pub(super) fn fill(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    source: &Operand,
    target: &Span,
) -> Result<(), Refusal> {
    if matches!(target.bank, Bank::T | Bank::Ct) {
        array(target)?;
    }
    bring_pointed(tags, chain, source)?;
    let to = target.bank.kind();
    let direct = match (source, kind(source)) {
        (Operand::Constant(constant), _) => fits(constant, to),
        (_, Some(from)) => passes(from, to),
        (_, None) => false,
    };
    if direct {
        let value = chain.value(tags, source, Some(to));
        chain.push(format!("[FILL]( {}, {value} )", range(target)));
        return take(tags, chain, target);
    }
    let between = tags.helper("fill_value", to.iec(), "a value that fills a range");
    let value = match source {
        Operand::Constant(constant) => literal(constant, None),
        other => chain.value(tags, other, None),
    };
    let from_number = kind(source).map_or(
        !matches!(source, Operand::Constant(Constant::Bit(_) | Constant::Text(_))),
        is_number,
    );
    if !is_number(to) || !from_number {
        return Err("bits, numbers and texts do not turn into one another".to_owned());
    }
    chain.push(format!("[TYP]( {between}, {value} )"));
    chain.push(format!("[FILL]( {}, {between} )", range(target)));
    take(tags, chain, target)
}
