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
use super::operand::{Chain, fits, kind, passes};
use super::tags::Tags;
use ladder_format::program::{Expression, Path};
use ladder_instructions::Op;

/// A block between kinds of more addresses is not copied: each takes a block of its own.
pub(super) const MOST_CONVERTED: usize = 200;

/// An element of the array that a bank is: `DS[3]`
pub(super) fn element(bank: Bank, number: u16) -> Expression {
    Path::tag(bank.array()).index([i64::from(number)]).into()
}

/// A part of that array: `DS[3..9]`
pub(super) fn range(span: &Span) -> Expression {
    let (first, last) = (i64::from(span.first), i64::from(span.last));
    Path::tag(span.bank.array()).range(first, last).into()
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
        chain.push(Op::Mov, [element, value])?;
    }
    Ok(())
}

/// Takes what an array holds to the blocks of a range.
fn take(tags: &mut Tags<'_>, chain: &mut Chain, span: &Span) -> Result<(), Refusal> {
    for (element, value) in tags.copies(span)? {
        chain.push(Op::Mov, [value, element])?;
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
    let moves = if passes(from, to) { Op::Mov } else { Op::Typ };
    let Some(first) = tags.address(target).map(|address| address.number) else {
        if source.len() == 1 {
            let source = Tag::number(source.bank, source.first);
            return chain.push(moves, [tags.place(target), tags.place(&source)]);
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
        chain.push(Op::Bmov, [element(span.bank, first), range(source)])?;
    } else {
        if source.len() > MOST_CONVERTED {
            return Err(format!(
                "more than {MOST_CONVERTED} addresses do not turn into another kind at once: make several blocks of it"
            ));
        }
        for (to, from) in (first..=last).zip(source.first..) {
            chain.push(moves, [element(span.bank, to), element(source.bank, from)])?;
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
        let value = chain.value(tags, source, Some(to))?;
        chain.push(Op::Fill, [range(target), value])?;
        return take(tags, chain, target);
    }
    let between = tags.helper("fill_value", to.iec(), "a value that fills a range");
    let value = chain.value(tags, source, None)?;
    let from_number = kind(source).map_or(
        !matches!(source, Operand::Constant(Constant::Bit(_) | Constant::Text(_))),
        is_number,
    );
    if !is_number(to) || !from_number {
        return Err("bits, numbers and texts do not turn into one another".to_owned());
    }
    chain.push(Op::Typ, [between.clone(), value])?;
    chain.push(Op::Fill, [range(target), between])?;
    take(tags, chain, target)
}
