//! Copies between numbers and characters as blocks of ladder text.

use super::act::{Refusal, written};
use super::address::Tag;
use super::bank::{Bank, Kind};
use super::conversion::Convert;
use super::model::{Constant, Operand};
use super::operand::{Chain, kind};
use super::ranges::{bring_pointed, element, take_pointed};
use super::tags::Tags;
use ladder_format::program::{Expression, Literal};
use ladder_instructions::Op;

/// How many addresses of its target a copy may write.
pub(super) fn most(convert: Convert, source: &Operand) -> usize {
    match convert {
        Convert::Text { termination, .. } => {
            let is_wide = kind(source).is_none_or(|kind| kind == Kind::Int2);
            (if is_wide { 11 } else { 6 }) + usize::from(termination.is_some())
        }
        _ => 1,
    }
}

/// What the tags are for that a copy of a number into characters needs.
pub(super) const NUMBER: &str = "number as text";
const SIGN: &str = "sign of a number as text";
const LENGTH: &str = "length of a number as text";
/// What the tag is for that holds the code of a character which is read.
pub(super) const CODE: &str = "code of a character";
/// The same, of one that is written.
pub(super) const TO_CODE: &str = "character with a code";
/// All characters, each at its code and one.
pub(super) const CHARACTERS: &str = "the characters of ASCII by their codes";

/// Whether a tag of the importer's own, by what it is for, belongs to a number that becomes characters.
pub(super) fn is_of_number(what: &str) -> bool {
    what.contains(NUMBER)
}

/// A copy that converts.
///
/// # Errors
///
/// Ladder text has no counterpart for it, or Click has no such copy.
pub(super) fn copy(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    (source, target): (&Operand, &Operand),
    convert: Convert,
) -> Result<(), Refusal> {
    let from = kind(source).or(match source {
        Operand::Constant(Constant::Int(_)) => Some(Kind::Int2),
        Operand::Constant(Constant::Text(text)) if text.chars().count() == 1 => Some(Kind::Text),
        _ => None,
    });
    let (Some(from), Some(to)) = (from, kind(target)) else {
        return Err("this value does not turn into anything at that place".to_owned());
    };
    let is_number = |kind| !matches!(kind, Kind::Bit | Kind::Text);
    let goes = match convert {
        Convert::Value | Convert::Ascii => from == Kind::Text && is_number(to),
        Convert::Binary | Convert::Text { .. } => to == Kind::Text && is_number(from),
    };
    if !goes {
        return Err(format!("{} does not copy such values", convert.name()));
    }
    if let Operand::Tag(tag) = target {
        written(tag)?;
    }
    bring_pointed(tags, chain, source)?;
    bring_pointed(tags, chain, target)?;
    let value = chain.value(tags, source, Some(from))?;
    match convert {
        Convert::Value => {
            let place = chain.value(tags, target, None)?;
            chain.push(Op::Typ, [place, value])?;
        }
        Convert::Ascii => {
            let code = tags.helper("code", "INT", CODE);
            let all = characters(tags);
            let place = chain.value(tags, target, None)?;
            chain.push(Op::Find, [code.clone(), all, value])?;
            // No character has the code of the first one, 0.
            chain.push(Op::Sub, [code.clone(), code.clone(), 1.into()])?;
            chain.push(Op::Max, [code.clone(), code.clone(), 0.into()])?;
            chain.push(Op::Mov, [place, code])?;
        }
        Convert::Binary => {
            let ty = match from {
                Kind::Int | Kind::Hex => "INT",
                Kind::Int2 => "DINT",
                _ => return Err("a real is no code of a character".to_owned()),
            };
            let code = tags.helper("character", ty, TO_CODE);
            let all = characters(tags);
            let place = chain.value(tags, target, None)?;
            chain.push(Op::Mov, [code.clone(), value])?;
            chain.push(Op::And, [code.clone(), code.clone(), 255.into()])?;
            chain.push(Op::Le, [code.clone(), 127.into()])?;
            chain.push(Op::Add, [code.clone(), code.clone(), 1.into()])?;
            chain.push(Op::Mid, [place, all, 1.into(), code])?;
        }
        Convert::Text { .. } => {
            let Operand::Tag(first) = target else {
                return Err("a number goes into several addresses, so the first must be fixed".to_owned());
            };
            return number(tags, chain, (value, from), first, convert);
        }
    }
    take_pointed(tags, chain, target)
}

/// The tag with all characters.
fn characters(tags: &mut Tags<'_>) -> Expression {
    let all: String = (0..=0x7F_u8).map(char::from).collect();
    tags.constant("ascii", "STRING[128]", CHARACTERS, Some(Literal::text(&all)))
}

/// A number into as many characters as it has.
fn number(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    (value, from): (Expression, Kind),
    first: &Tag,
    convert: Convert,
) -> Result<(), Refusal> {
    let Convert::Text {
        suppress_zero,
        termination,
        ..
    } = convert
    else {
        return Ok(());
    };
    let (digits, most) = match from {
        Kind::Int => (5, 6),
        Kind::Int2 => (10, 11),
        _ => {
            return Err(
                "how Click writes reals and hexadecimal numbers is not known to the digit".to_owned(),
            );
        }
    };
    let start = tags
        .element(first)
        .ok_or("a number goes into several addresses, so the first must be given by its number")?;
    let text = tags.helper(
        "number_text",
        "STRING[16]",
        format!("{NUMBER}, {}", convert.grid()),
    );
    let length = tags.helper("number_length", "INT", LENGTH);
    let literal = |text: &str| Expression::from(Literal::text(text));
    chain.push(Op::Typ, [text.clone(), value])?;
    if !suppress_zero {
        let sign = tags.helper("number_sign", "STRING[1]", SIGN);
        let zeros = literal(&"0".repeat(digits));
        chain.push(Op::Find, [length.clone(), text.clone(), literal("-")])?;
        chain.push(Op::Left, [sign.clone(), text.clone(), length.clone()])?;
        chain.push(Op::Delete, [text.clone(), text.clone(), length.clone(), 1.into()])?;
        chain.push(Op::Concat, [text.clone(), zeros, text.clone()])?;
        chain.push(Op::Right, [text.clone(), text.clone(), (digits as i64).into()])?;
        chain.push(Op::Concat, [text.clone(), sign, text.clone()])?;
    }
    if let Some(code) = termination {
        let character = literal(&char::from(code).to_string());
        chain.push(Op::Concat, [text.clone(), text.clone(), character])?;
    }
    chain.push(Op::Len, [length.clone(), text.clone()])?;
    let most = most + u16::from(termination.is_some());
    let last = start.number.saturating_add(most - 1).min(Bank::Txt.last());
    for (at, place) in (1_i64..).zip(start.number..=last) {
        if at > 1 {
            chain.push(Op::Ge, [length.clone(), at.into()])?;
        }
        let place = element(Bank::Txt, place);
        chain.push(Op::Mid, [place, text.clone(), 1.into(), at.into()])?;
    }
    Ok(())
}

/// A block of characters into numbers, or the reverse: one after the other.
///
/// # Errors
///
/// As [`copy`], and if there are too many.
pub(super) fn block(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    (source, target): (&super::address::Span, &Tag),
    convert: Convert,
) -> Result<(), Refusal> {
    if !matches!(convert, Convert::Value | Convert::Ascii) {
        return Err("a block is copied with to_value or to_ascii alone".to_owned());
    }
    let first = tags.address(target).map(|address| address.number);
    let first = first.ok_or("the first of several addresses must be given by its number")?;
    if source.len() > super::ranges::MOST_CONVERTED || source.first > source.last {
        return Err("no more than 200 addresses turn into another kind at once".to_owned());
    }
    for (from, to) in (source.first..=source.last).zip(first..) {
        let from = Operand::Tag(Tag::number(source.bank, from));
        let to = Operand::Tag(Tag::number(target.bank, to));
        copy(tags, chain, (&from, &to), convert)?;
    }
    if source.len() > 1 {
        let why = "what is before a character that does not turn into a number is copied all the same";
        chain.remark = Some(why.to_owned());
    }
    Ok(())
}
