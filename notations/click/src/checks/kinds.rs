//! What kinds of values go together: in contacts, comparisons, set points, copies and formulas.

use super::super::address::Tag;
use super::super::bank::{Bank, Kind};
use super::super::model::{
    Action, Bits, Coil, Comparison, Condition, Constant, Instruction, Operand, Relation, Search,
};
use super::super::operand::{fits, kind};
use super::words::Words;
use super::{Found, copies, mathematics};
use ladder_analysis::with_article;
use ladder_notation::LineColumn;

pub(super) fn condition(condition: &Condition, out: &mut Found) {
    match condition {
        Condition::All(parts) | Condition::Any(parts) => {
            for part in parts {
                self::condition(part, out);
            }
        }
        Condition::Contact(contact) => {
            if contact.bits.bank().kind() != Kind::Bit {
                let shown = out.words.bits(&contact.bits);
                let message = format!(
                    "a contact is a bit, and {shown} is {}: compare it",
                    sort(contact.bits.bank().kind())
                );
                out.error(contact.place, "click-contact", message);
            }
        }
        Condition::Compare(comparison) => compare(comparison, out),
    }
}

pub(super) const fn sort(kind: Kind) -> &'static str {
    match kind {
        Kind::Bit => "a bit",
        Kind::Int | Kind::Int2 => "an integer",
        Kind::Hex => "a hexadecimal word",
        Kind::Float => "a real number",
        Kind::Text => "a text",
    }
}

/// What a comparison can hold: decimal numbers, words or texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    Decimal,
    Hex,
    Text,
    Bit,
}

pub(super) const fn family(kind: Kind) -> Family {
    match kind {
        Kind::Int | Kind::Int2 | Kind::Float => Family::Decimal,
        Kind::Hex => Family::Hex,
        Kind::Text => Family::Text,
        Kind::Bit => Family::Bit,
    }
}

fn compare(comparison: &Comparison, out: &mut Found) {
    let place = comparison.place;
    let (left, right) = (&comparison.left, &comparison.right);
    let constant = |operand: &Operand| match operand {
        Operand::Constant(constant) => Some(constant.clone()),
        _ => None,
    };
    let goes = match (kind(left), kind(right)) {
        (Some(left), Some(right)) => family(left) == family(right) && family(left) != Family::Bit,
        (Some(kind), None) | (None, Some(kind)) => {
            let value = constant(left).or_else(|| constant(right));
            value.is_some_and(|value| compares(&value, kind))
        }
        (None, None) => true,
    };
    if !goes {
        let shown = out.words.comparison(comparison);
        let message = format!(
            "`{shown}` compares what cannot be compared: numbers go with numbers, words with words, texts with texts"
        );
        out.error(place, "click-compare", message);
        return;
    }
    if let (Words::Dsl, Some(one), Some(other)) = (out.words, type_of(left, right), type_of(right, left))
        && one != other
    {
        let shown = out.words.comparison(comparison);
        let message = format!(
            "`{shown}` compares {one} with {other}, and the DSL asks for one type; Click itself compares them as numbers"
        );
        out.warning(place, "click-compare", message);
    }
    let is_text = [left, right]
        .into_iter()
        .any(|side| kind(side) == Some(Kind::Text));
    if is_text && !matches!(comparison.relation, Relation::Eq | Relation::Ne) {
        out.error(place, "click-compare", "texts are compared with == and != only");
    }
    for pointer in [left, right]
        .into_iter()
        .filter(|side| matches!(side, Operand::Pointer(_)))
    {
        let message = format!(
            "`{}` is a pointer, and Click has them in copy() alone",
            out.words.operand(pointer)
        );
        out.warning(place, "click-pointer", message);
    }
}

/// The type of one side of a comparison, as the page on the DSL calls it. A whole number has that of the other side.
fn type_of(side: &Operand, other: &Operand) -> Option<&'static str> {
    let kind = match side {
        Operand::Constant(Constant::Float(_)) => Some(Kind::Float),
        Operand::Constant(_) => kind(other),
        side => kind(side),
    };
    Some(match kind? {
        Kind::Int => "int16",
        Kind::Int2 => "int32",
        Kind::Hex => "hex16",
        Kind::Float => "float32",
        Kind::Bit => "a bit",
        Kind::Text => "a text",
    })
}

fn compares(constant: &Constant, kind: Kind) -> bool {
    match constant {
        Constant::Int(_) => matches!(family(kind), Family::Decimal | Family::Hex),
        Constant::Float(_) => family(kind) == Family::Decimal,
        Constant::Hex(_) => family(kind) == Family::Hex || kind == Kind::Int,
        Constant::Text(_) => kind == Kind::Text,
        Constant::Bit(_) => false,
    }
}

pub(super) fn action(action: &Action, out: &mut Found) {
    condition(&action.condition, out);
    let place = action.place;
    match &action.what {
        Instruction::Out(coil) | Instruction::Set(coil) | Instruction::Reset(coil) => {
            self::coil(place, coil, out);
        }
        Instruction::Timer(timer) => {
            if timer.tag.bank != Bank::T {
                out.error(
                    place,
                    "click-timer",
                    format!(
                        "a timer is an address of {}, and {} is none",
                        out.words.bank(Bank::T),
                        out.words.tag(&timer.tag)
                    ),
                );
            }
            setpoint(place, "set point", &timer.setpoint, Kind::Int, &[Bank::Ds], out);
            timer.reset.iter().for_each(|pin| condition(pin, out));
        }
        Instruction::Counter(counter) => {
            if counter.tag.bank != Bank::Ct {
                let message = format!(
                    "a counter is an address of {}, and {} is none",
                    out.words.bank(Bank::Ct),
                    out.words.tag(&counter.tag)
                );
                out.error(place, "click-counter", message);
            }
            setpoint(
                place,
                "set point",
                &counter.setpoint,
                Kind::Int2,
                &[Bank::Ds, Bank::Dd],
                out,
            );
            wide_setpoint(place, &counter.setpoint, out);
            counter.reset.iter().for_each(|pin| condition(pin, out));
            counter.count_down.iter().for_each(|pin| condition(pin, out));
        }
        // What a conversion takes is refused where it is translated.
        Instruction::Copy { options, .. } | Instruction::BlockCopy { options, .. }
            if options.convert.is_some() => {}
        Instruction::Copy { source, target, .. } => match kind(target) {
            Some(to) => copies::copied(place, source, to, out),
            None => out.error(
                place,
                "click-copy",
                "a constant cannot be written: the destination is an address",
            ),
        },
        Instruction::Fill { source, target, .. } => copies::copied(place, source, target.bank.kind(), out),
        Instruction::BlockCopy { source, target, .. } => {
            let first = Operand::Tag(Tag::number(source.bank, source.first));
            copies::copied(place, &first, target.bank.kind(), out);
        }
        Instruction::Pack { source, target, .. } => {
            copies::packed(place, source.bank, source.len(), target.bank, out);
        }
        Instruction::Unpack { source, target, .. } => {
            copies::unpacked(place, source.bank, target.bank, target.len(), out);
        }
        Instruction::Shift(shift) => {
            if shift.bits.bank != Bank::C {
                let message = format!(
                    "a shift register is a range of {}, and {} is none",
                    out.words.bank(Bank::C),
                    out.words.span(&shift.bits)
                );
                out.error(place, "click-shift", message);
            }
            shift.clock.iter().for_each(|pin| condition(pin, out));
            shift.reset.iter().for_each(|pin| condition(pin, out));
        }
        Instruction::Search(search) => self::search(place, search, out),
        Instruction::Math(math) => mathematics::check(place, math, out),
        Instruction::Drum(drum) => drum.conditions().for_each(|pin| condition(pin, out)),
        Instruction::For(count) => setpoint(place, "number of loops", count, Kind::Int, &[Bank::Ds], out),
        Instruction::Call(_)
        | Instruction::Next
        | Instruction::End
        | Instruction::Return
        | Instruction::Nop
        | Instruction::Kept { .. } => {}
    }
}

fn coil(place: LineColumn, coil: &Coil, out: &mut Found) {
    let bank = coil.bits.bank();
    if !matches!(bank, Bank::Y | Bank::C | Bank::Sc) {
        let message = format!(
            "a coil is an address of {}, {} or {}, and {} is none",
            out.words.bank(Bank::Y),
            out.words.bank(Bank::C),
            out.words.bank(Bank::Sc),
            out.words.bits(&coil.bits)
        );
        out.error(place, "click-coil", message);
    }
    if let Bits::Many(span) = &coil.bits
        && span.first > span.last
    {
        out.error(place, "click-coil", "a range of coils goes upwards");
    }
}

fn setpoint(place: LineColumn, what: &str, value: &Operand, most: Kind, banks: &[Bank], out: &mut Found) {
    let goes = match value {
        Operand::Constant(constant) => {
            matches!(constant, Constant::Int(number) if *number >= 0) && fits(constant, most)
        }
        Operand::Tag(tag) => banks.contains(&tag.bank),
        Operand::Pointer(_) => true,
    };
    if !goes {
        let banks: Vec<&str> = banks.iter().map(|bank| out.words.bank(*bank)).collect();
        let largest = if most == Kind::Int { "32767" } else { "2147483647" };
        let message = format!(
            "{} is not {}: write a whole number from 0 to {largest}, or an address of {}",
            out.words.operand(value),
            with_article(what),
            banks.join(" or ")
        );
        out.error(place, "click-setpoint", message);
    }
}

/// What the page on the DSL does not have as the set point of a counter, and Click has.
fn wide_setpoint(place: LineColumn, value: &Operand, out: &mut Found) {
    let is_wide = match value {
        Operand::Constant(constant) => !fits(constant, Kind::Int) && fits(constant, Kind::Int2),
        Operand::Tag(tag) => tag.bank == Bank::Dd,
        Operand::Pointer(_) => false,
    };
    if is_wide && out.words == Words::Dsl {
        let message = format!(
            "{} is wider than a set point of the DSL, an int16 or an address of {}; Click's own counters take it",
            out.words.operand(value),
            out.words.bank(Bank::Ds)
        );
        out.warning(place, "click-setpoint", message);
    }
}

fn search(place: LineColumn, search: &Search, out: &mut Found) {
    if search.flag.bank != Bank::C {
        let message = format!(
            "the flag of a search is an address of {}, and {} is none",
            out.words.bank(Bank::C),
            out.words.tag(&search.flag)
        );
        out.error(place, "click-search", message);
    }
    if !search.result.bank.kind().is_decimal() || search.result.bank == Bank::Df {
        let message = format!(
            "the result of a search is a number of an address, and {} holds none",
            out.words.tag(&search.result)
        );
        out.error(place, "click-search", message);
    }
    let among = search.among.bank.kind();
    let goes = match &search.value {
        Operand::Constant(constant) => compares(constant, among),
        other => kind(other).is_some_and(|kind| family(kind) == family(among)),
    };
    if !goes || among == Kind::Bit {
        let message = format!(
            "{} is not found among {}",
            out.words.operand(&search.value),
            out.words.span(&search.among)
        );
        out.error(place, "click-search", message);
    }
    if among == Kind::Text && !matches!(search.relation, Relation::Eq | Relation::Ne) {
        let message = format!("texts are searched with {} only", out.words.equalities());
        out.error(place, "click-search", message);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hexadecimal_constants_go_with_words() {
        assert!(compares(&Constant::Hex(1), Kind::Hex));
        assert!(!compares(&Constant::Hex(1), Kind::Float));
        assert!(!compares(&Constant::Text("a".to_owned()), Kind::Int));
    }
}
