//! What kinds of values go together: in contacts, comparisons, set points, copies and formulas.

use super::super::bank::{Bank, Kind};
use super::super::calc;
use super::super::dsl::spell;
use super::super::formula;
use super::super::model::{
    Action, Bits, Coil, Comparison, Condition, Constant, Instruction, Math, MathKind, Operand, Relation,
    Search,
};
use super::super::operand::{fits, kind};
use super::Found;
use crate::notation::Place;

pub(super) fn condition(condition: &Condition, out: &mut Found) {
    match condition {
        Condition::All(parts) | Condition::Any(parts) => {
            for part in parts {
                self::condition(part, out);
            }
        }
        Condition::Contact(contact) => {
            if contact.bits.bank().kind() != Kind::Bit {
                let shown = spell::bits(&contact.bits);
                let message = format!(
                    "a contact is a bit, and {shown} is {}: compare it",
                    words(contact.bits.bank().kind())
                );
                out.error(contact.place, "click-contact", message);
            }
        }
        Condition::Compare(comparison) => compare(comparison, out),
    }
}

const fn words(kind: Kind) -> &'static str {
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
enum Family {
    Decimal,
    Hex,
    Text,
    Bit,
}

const fn family(kind: Kind) -> Family {
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
        let shown = spell::condition(&Condition::Compare(comparison.clone()));
        let message = format!(
            "`{shown}` compares what cannot be compared: numbers go with numbers, words with words, texts with texts"
        );
        out.error(place, "click-compare", message);
        return;
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
            spell::operand(pointer)
        );
        out.warning(place, "click-pointer", message);
    }
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
                    format!("a timer is an address of t, and {} is none", timer.tag.dsl()),
                );
            }
            setpoint(place, "set point", &timer.setpoint, Kind::Int, &[Bank::Ds], out);
            timer.reset.iter().for_each(|pin| condition(pin, out));
        }
        Instruction::Counter(counter) => {
            if counter.tag.bank != Bank::Ct {
                let message = format!("a counter is an address of ct, and {} is none", counter.tag.dsl());
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
            counter.reset.iter().for_each(|pin| condition(pin, out));
            counter.count_down.iter().for_each(|pin| condition(pin, out));
        }
        Instruction::Copy { source, target, .. } => match kind(target) {
            Some(to) => copied(place, source, to, out),
            None => out.error(
                place,
                "click-copy",
                "a constant cannot be written: the destination is an address",
            ),
        },
        Instruction::Fill { source, target, .. } => copied(place, source, target.bank.kind(), out),
        Instruction::BlockCopy { source, target, .. } => {
            let (from, to) = (source.bank.kind(), target.bank.kind());
            if from != to {
                let message = format!(
                    "a block copies addresses of one kind, and this goes from {} to {}",
                    source.bank.row().dsl,
                    target.bank.row().dsl
                );
                out.error(place, "click-copy", message);
            }
        }
        Instruction::Pack { source, target, .. } => {
            packed(place, source.bank, source.len(), target.bank, out);
        }
        Instruction::Unpack { source, target, .. } => {
            unpacked(place, source.bank, target.bank, target.len(), out);
        }
        Instruction::Shift(shift) => {
            if shift.bits.bank != Bank::C {
                let message = format!(
                    "a shift register is a range of c, and {} is none",
                    shift.bits.dsl()
                );
                out.error(place, "click-shift", message);
            }
            shift.clock.iter().for_each(|pin| condition(pin, out));
            shift.reset.iter().for_each(|pin| condition(pin, out));
        }
        Instruction::Search(search) => self::search(place, search, out),
        Instruction::Math(math) => self::math(place, math, out),
        Instruction::For(count) => setpoint(place, "number of loops", count, Kind::Int, &[Bank::Ds], out),
        Instruction::Call(_)
        | Instruction::Next
        | Instruction::End
        | Instruction::Return
        | Instruction::Nop
        | Instruction::Kept { .. } => {}
    }
}

fn coil(place: Place, coil: &Coil, out: &mut Found) {
    let bank = coil.bits.bank();
    if !matches!(bank, Bank::Y | Bank::C | Bank::Sc) {
        let message = format!(
            "a coil is an address of y, c or sc, and {} is none",
            spell::bits(&coil.bits)
        );
        out.error(place, "click-coil", message);
    }
    if let Bits::Many(span) = &coil.bits
        && span.first > span.last
    {
        out.error(place, "click-coil", "a range of coils goes upwards");
    }
}

fn setpoint(place: Place, what: &str, value: &Operand, most: Kind, banks: &[Bank], out: &mut Found) {
    let goes = match value {
        Operand::Constant(constant) => {
            matches!(constant, Constant::Int(number) if *number >= 0) && fits(constant, most)
        }
        Operand::Tag(tag) => banks.contains(&tag.bank),
        Operand::Pointer(_) => true,
    };
    if !goes {
        let banks: Vec<&str> = banks.iter().map(|bank| bank.row().dsl).collect();
        let largest = if most == Kind::Int { "32767" } else { "2147483647" };
        let message = format!(
            "{} is no {what}: write a whole number from 0 to {largest}, or an address of {}",
            spell::operand(value),
            banks.join(" or ")
        );
        out.error(place, "click-setpoint", message);
    }
}

/// The page's table of what turns into what in a copy.
fn copied(place: Place, source: &Operand, to: Kind, out: &mut Found) {
    let number = |kind: Kind| !matches!(kind, Kind::Bit | Kind::Text);
    if let Operand::Constant(constant) = source {
        let sort = match constant {
            Constant::Bit(_) => to == Kind::Bit,
            Constant::Text(_) => to == Kind::Text,
            Constant::Int(_) => number(to) || fits(constant, to),
            Constant::Hex(_) | Constant::Float(_) => number(to),
        };
        let shown = spell::operand(source);
        if !sort {
            let message = format!("{shown} does not turn into {}", words(to));
            out.error(place, "click-copy", message);
        } else if matches!(constant, Constant::Int(_) | Constant::Hex(_)) && !fits(constant, to) {
            let message =
                format!("{shown} does not fit its destination, which takes the nearest value that does");
            out.warning(place, "click-constant", message);
        }
        return;
    }
    let Some(from) = kind(source) else { return };
    if from != to && !(number(from) && number(to)) {
        let message = format!(
            "{} does not turn into {}: {}",
            words(from),
            words(to),
            spell::operand(source)
        );
        out.error(place, "click-copy", message);
    }
}

/// What may be packed into what, and how much of it.
fn packed(place: Place, from: Bank, count: usize, to: Bank, out: &mut Found) {
    use Bank::{C, Ct, Ctd, Dd, Df, Dh, Ds, Sc, T, Td, Txt, X, Y};
    let most = match (from, to) {
        (X | Y | T | Ct | Sc, Dh) | (C, Ds | Dh) => 16,
        (C, Dd | Df) => 32,
        (Ds | Dh, Dd | Df) => 2,
        (Txt, Ds | Dd | Dh | Df | Td | Ctd) => 1_000,
        _ => 0,
    };
    complain(
        place,
        most,
        count,
        &format!("{} is not packed into {}", from.row().dsl, to.row().dsl),
        out,
    );
}

fn unpacked(place: Place, from: Bank, to: Bank, count: usize, out: &mut Found) {
    use Bank::{C, Dd, Df, Dh, Ds, Y};
    let most = match (from, to) {
        (Ds | Dh, C | Y) => 16,
        (Dd | Df, C | Y) => 32,
        (Dd | Df, Ds | Dh) => 2,
        _ => 0,
    };
    complain(
        place,
        most,
        count,
        &format!("{} is not unpacked into {}", from.row().dsl, to.row().dsl),
        out,
    );
}

fn complain(place: Place, most: usize, count: usize, never: &str, out: &mut Found) {
    match most {
        0 => out.error(place, "click-pack", never),
        most if count > most => {
            out.error(
                place,
                "click-pack",
                format!("no more than {most} addresses go into it, and these are {count}"),
            );
        }
        _ => {}
    }
}

fn search(place: Place, search: &Search, out: &mut Found) {
    if search.flag.bank != Bank::C {
        let message = format!(
            "the flag of a search is an address of c, and {} is none",
            search.flag.dsl()
        );
        out.error(place, "click-search", message);
    }
    if !search.result.bank.kind().is_decimal() || search.result.bank == Bank::Df {
        let message = format!(
            "the result of a search is a number of an address, and {} holds none",
            search.result.dsl()
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
            spell::operand(&search.value),
            search.among.dsl()
        );
        out.error(place, "click-search", message);
    }
    if among == Kind::Text && !matches!(search.relation, Relation::Eq | Relation::Ne) {
        out.error(place, "click-search", "texts are searched with eq and ne only");
    }
}

fn math(place: Place, math: &Math, out: &mut Found) {
    let Some(target) = kind(&math.target) else {
        return out.error(
            place,
            "click-math",
            "a constant cannot be written: the result goes into an address",
        );
    };
    let mut kinds = calc::parts(&math.formula);
    kinds.push(target);
    let wanted = match math.kind {
        MathKind::Decimal => Family::Decimal,
        MathKind::Hex => Family::Hex,
    };
    if let Some(odd) = kinds.into_iter().find(|kind| family(*kind) != wanted) {
        let (word, instead) = match math.kind {
            MathKind::Decimal => ("calc", "decimal numbers"),
            MathKind::Hex => ("math_hex", "hexadecimal words"),
        };
        let message = format!("{word}() computes with {instead}, and this is {}", words(odd));
        out.error(place, "click-math", message);
    }
    let text = spell::formula(&math.formula);
    if formula::nesting(&text) > 8 {
        out.error(
            place,
            "click-math",
            "Click has no more than eight parentheses in one another",
        );
    }
    let operators = formula::foreign(&math.formula, math.kind);
    if let Some(word) = operators {
        let where_it_is = match math.kind {
            MathKind::Decimal => "math_hex",
            MathKind::Hex => "calc",
        };
        out.error(
            place,
            "click-math",
            format!("{word} is for {where_it_is}() alone"),
        );
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
