//! Addresses: whether they exist, who may write them, what pointers may do.

use super::super::address::{Span, Tag};
use super::super::bank::{Bank, Writer};
use super::super::model::{Instruction, Program};
use super::super::uses::{Access, What, uses};
use super::{Found, actions};
use ladder_notation::LineColumn;
use std::collections::{HashMap, HashSet};

pub(super) fn check(program: &Program, out: &mut Found) {
    let mut owned: HashSet<&Tag> = HashSet::new();
    let all = uses(program);
    for one in all.iter().filter(|one| one.access == Access::Own) {
        if let What::One(tag) = one.what {
            owned.insert(tag);
        }
    }
    for one in &all {
        let place = one.place;
        match one.what {
            What::One(tag) => {
                if let Some(address) = tag.address()
                    && !tag.bank.has(address.number)
                {
                    missing(place, tag.bank, &out.words.tag(tag), out);
                    continue;
                }
                if one.access == Access::Write {
                    writes(place, tag, out);
                }
                if matches!(one.access, Access::Read | Access::Contact)
                    && matches!(tag.bank, Bank::T | Bank::Ct)
                    && !owned.contains(tag)
                {
                    let what = if tag.bank == Bank::T { "timer" } else { "counter" };
                    let message = format!("no {what} of the program has the bit {}", out.words.tag(tag));
                    out.warning(place, "click-c1002", message);
                }
            }
            What::Many(span) => {
                if !span.exists() {
                    missing(place, span.bank, &out.words.span(&span), out);
                    continue;
                }
                if one.access == Access::Write {
                    writes(place, &Tag::number(span.bank, span.first), out);
                }
            }
            What::From(tag, count) => {
                if let Some(address) = tag.address() {
                    let last = address.number.saturating_add(count as u16).saturating_sub(1);
                    let span = Span {
                        bank: tag.bank,
                        first: address.number,
                        last,
                    };
                    if !span.exists() {
                        missing(place, tag.bank, &out.words.span(&span), out);
                        continue;
                    }
                }
                writes(place, tag, out);
            }
            What::Somewhere(pointer) => {
                if pointer.by.bank != Bank::Ds {
                    let message = format!(
                        "a pointer is an address of {}, and {} is none",
                        out.words.bank(Bank::Ds),
                        out.words.tag(&pointer.by)
                    );
                    out.error(place, "click-pointer", message);
                }
                if matches!(
                    pointer.bank,
                    Bank::X | Bank::Y | Bank::T | Bank::Ct | Bank::Sc | Bank::Sd
                ) {
                    let message = format!(
                        "a pointer does not lead into the bank {}",
                        out.words.bank(pointer.bank)
                    );
                    out.error(place, "click-pointer", message);
                }
            }
        }
    }
    pointers(program, out);
    registers(program, out);
}

/// No bit is in two shift registers: each would move what the other holds.
fn registers(program: &Program, out: &mut Found) {
    let mut taken: HashMap<Bank, Vec<Option<LineColumn>>> = HashMap::new();
    for (_, _, action) in actions(program) {
        let Instruction::Shift(shift) = &action.what else {
            continue;
        };
        let bank = shift.bits.bank;
        let length = usize::from(bank.last()) + 1;
        let there = taken.entry(bank).or_insert_with(|| vec![None; length]);
        let (low, high) = shift.bits.bounds();
        // What does not exist is reported elsewhere.
        let bits = usize::from(low).min(length)..(usize::from(high) + 1).min(length);
        let mut shared = None;
        for (number, first) in there[bits.clone()].iter_mut().enumerate() {
            shared = shared.or_else(|| first.map(|first| (bits.start + number, first)));
            first.get_or_insert(action.place);
        }
        if let Some((number, first)) = shared {
            let tag = out.words.tag(&Tag::number(bank, number as u16));
            let message = format!("{tag} is in the shift register at {first} already");
            out.warning(action.place, "click-c0204", message);
        }
    }
}

fn missing(place: LineColumn, bank: Bank, what: &str, out: &mut Found) {
    let message = format!(
        "{what} does not exist: {} has {}",
        out.words.bank(bank),
        bank.extent()
    );
    out.error(place, "click-address", message);
}

/// What the program must not write.
fn writes(place: LineColumn, tag: &Tag, out: &mut Found) {
    let why = match (tag.bank.row().writer, tag.address()) {
        (Writer::Program, _) => return,
        (Writer::World, _) => "it is an input",
        (Writer::Blocks, _) => "its timer or counter alone writes it",
        (Writer::System(_), Some(address)) if tag.bank.is_writable(address.number) => return,
        // Which one a nickname means is not known here.
        (Writer::System(_), None) => return,
        (Writer::System(_), Some(_)) => "the controller alone writes it",
    };
    let message = format!("{} cannot be written: {why}", out.words.tag(tag));
    out.error(place, "click-read-only", message);
}

/// Pointers are for the single copy.
fn pointers(program: &Program, out: &mut Found) {
    use super::super::model::Operand;
    let is_pointer = |operand: &Operand| matches!(operand, Operand::Pointer(_));
    for (_, _, action) in actions(program) {
        let elsewhere = match &action.what {
            Instruction::Math(math) => {
                let mut operands = Vec::new();
                super::super::formula::operands(&math.formula, &mut operands);
                operands.into_iter().any(is_pointer) || is_pointer(&math.target)
            }
            Instruction::Fill { source, .. } => is_pointer(source),
            Instruction::Search(search) => is_pointer(&search.value),
            Instruction::For(count) => is_pointer(count),
            Instruction::Timer(timer) => is_pointer(&timer.setpoint),
            Instruction::Counter(counter) => is_pointer(&counter.setpoint),
            _ => false,
        };
        if elsewhere {
            let message = "Click itself has pointers in copy() alone: copy the value to an address first";
            out.warning(action.place, "click-pointer", message);
        }
    }
}
