//! What the tags of a ladder program are in Click.

use super::super::address::{Address, Tag, Which};
use super::super::bank::{Bank, Kind};
use super::super::model::{Action, Constant, Instruction, Nickname, Operand, Program};
use super::super::operand::shortest;
use super::super::python_name::python_name;
use super::super::ranges::is_of_blocks;
use ladder_analysis::program::{self as ladder, Role, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_notation::{LineColumn, Report};
use std::collections::{HashMap, HashSet};

/// What a tag is.
#[derive(Debug, Clone)]
pub(super) enum Meaning {
    /// The array of a bank.
    Bank(Bank),
    /// An address. That of a timer or counter is its bit.
    Address(Tag),
    /// The importer's own, and what it says of it: `reset of Warm`.
    Helper(String),
    /// Click has nothing like it; why.
    Nothing(&'static str),
}

/// All of them, by the number of the tag, and what the address picker says.
pub(super) fn meanings(
    program: &ladder::Program,
    comments: &HashMap<TagId, String>,
    places: impl Fn(&ladder::Tag) -> LineColumn,
    report: &mut Report,
) -> (Vec<Meaning>, Vec<Nickname>) {
    let mut nicknames = Vec::new();
    let mut taken = HashSet::new();
    let mut out = Vec::with_capacity(program.tags.len());
    for (number, tag) in program.tags.iter().enumerate() {
        let comment = comments.get(&TagId(number as u32)).map_or("", String::as_str);
        let meaning = match tag.block {
            None => meaning(tag, comment, &mut nicknames),
            Some(_) => {
                Meaning::Nothing("it belongs to the body of a block, and Click has no blocks of one's own")
            }
        };
        let meaning = match meaning {
            Meaning::Address(tag_there) => {
                let original = tag_there.dsl();
                let tag_there = pythonic(tag_there);
                if tag_there.dsl() != original {
                    let why = format!("it is spelled `{}` in Python", tag_there.dsl());
                    report.approximated(places(tag), &tag.name, why);
                }
                if taken.insert(tag_there.clone()) {
                    Meaning::Address(tag_there)
                } else {
                    Meaning::Nothing("another tag is the same address")
                }
            }
            other => other,
        };
        out.push(meaning);
    }
    (out, nicknames)
}

fn meaning(tag: &ladder::Tag, comment: &str, nicknames: &mut Vec<Nickname>) -> Meaning {
    if let Some(what) = comment.strip_prefix("helper: ") {
        return Meaning::Helper(what.to_owned());
    }
    if let Type::Array { element, .. } = tag.ty {
        return match Bank::of_array(&tag.name)
            .filter(|bank| kind_bank(element, tag.role).is_some_and(|like| like.kind() == bank.kind()))
        {
            Some(bank) => Meaning::Bank(bank),
            None => Meaning::Nothing("Click has no arrays but its banks: name it as one, such as DS"),
        };
    }
    if let Some(found) = told(comment, tag, nicknames) {
        return Meaning::Address(found);
    }
    let bank = match tag.ty {
        Type::Scalar(scalar) => kind_bank(scalar, tag.role),
        Type::State(state) if state.is_timer() => Some(Bank::T),
        Type::State(state) if state.is_counter() => Some(Bank::Ct),
        _ => None,
    };
    let Some(bank) = bank else {
        return Meaning::Nothing(
            "Click has no type like this: it has BOOL, INT, DINT, WORD, REAL, timers and counters",
        );
    };
    // `T7` is the timer with that number, as `DS[7]` is an address.
    match Address::parse(&tag.name).filter(|address| address.bank == bank && bank.has(address.number)) {
        Some(address) if matches!(bank, Bank::T | Bank::Ct) => Meaning::Address(address.into()),
        _ => Meaning::Address(Tag::nickname(bank, &tag.name)),
    }
}

/// The bank whose addresses hold such values.
fn kind_bank(scalar: Scalar, role: Role) -> Option<Bank> {
    Some(match (scalar, role) {
        (Scalar::Bool, Role::Input) => Bank::X,
        (Scalar::Bool, Role::Output) => Bank::Y,
        (Scalar::Bool, Role::Internal) => Bank::C,
        (Scalar::Int, _) => Bank::Ds,
        (Scalar::Dint, _) => Bank::Dd,
        (Scalar::Word, _) => Bank::Dh,
        (Scalar::Real, _) => Bank::Df,
        (Scalar::String(1), _) => Bank::Txt,
        _ => return None,
    })
}

/// What a declaration's comment says: `X001`, `X001 Start: at the door`, `sc.Ready`.
fn told(comment: &str, tag: &ladder::Tag, nicknames: &mut Vec<Nickname>) -> Option<Tag> {
    let (head, text) = comment.split_once(':').unwrap_or((comment, ""));
    let (first, rest) = head.trim().split_once(' ').unwrap_or((head.trim(), ""));
    if let Some((bank, nickname)) = first.split_once('.') {
        return Some(Tag::nickname(Bank::of_dsl(bank)?, nickname));
    }
    let address = Address::parse(first).filter(|address| address.bank.has(address.number))?;
    if address.is_upper() && rest.is_empty() && text.is_empty() && Address::parse(&tag.name) == Some(address)
    {
        return Some(address.into());
    }
    let name = if rest.is_empty() { &tag.name } else { rest.trim() };
    nicknames.push(Nickname {
        address,
        name: name.to_owned(),
        comment: text.trim().to_owned(),
        initial: tag
            .initial
            .first()
            .and_then(|value| initial(value, address.bank.kind())),
        retentive: Some(tag.retain),
    });
    Some(Tag::nickname(address.bank, name))
}

/// An initial value, unless it is what an address holds anyway.
fn initial(value: &Value, kind: Kind) -> Option<Constant> {
    match (value, kind) {
        (Value::Bool(true), Kind::Bit) => Some(Constant::Bit(true)),
        (Value::Int(number), Kind::Hex) => Some(Constant::Hex(
            u32::try_from(*number).ok().filter(|bits| *bits != 0)?,
        )),
        (Value::Int(number), _) if *number != 0 => Some(Constant::Int(*number)),
        (Value::Real(number), _) if *number != 0.0 => Some(Constant::Float(shortest(*number))),
        (Value::Text(text), _) if !text.is_empty() => {
            Some(Constant::Text(String::from_utf8(text.to_vec()).ok()?))
        }
        _ => None,
    }
}

/// A nickname as Python can hold it.
fn pythonic(tag: Tag) -> Tag {
    match &tag.which {
        Which::Nickname(name) => Tag::nickname(tag.bank, python_name(name)),
        Which::Number(_) => tag,
    }
}

/// Takes out the copies between timers and counters and the arrays that hold what they do: in Click they are one.
pub(super) fn without_own_copies(program: &mut Program) {
    let nicknames = std::mem::take(&mut program.nicknames);
    let blocks = |bank| match bank {
        Bank::Td => Bank::T,
        Bank::Ctd => Bank::Ct,
        bank => bank,
    };
    let number = |tag: &Tag| match &tag.which {
        Which::Number(number) => Some(*number),
        Which::Nickname(name) => {
            let own = nicknames.iter().find(|nickname| {
                blocks(nickname.address.bank) == blocks(tag.bank) && python_name(&nickname.name) == *name
            })?;
            Some(own.address.number)
        }
    };
    let is_own = |action: &Action| match &action.what {
        Instruction::Copy {
            source: Operand::Tag(from),
            target: Operand::Tag(to),
            ..
        } => {
            from.bank == to.bank
                && is_of_blocks(to.bank)
                && number(from).is_some_and(|from| number(to) == Some(from))
        }
        _ => false,
    };
    let routines = std::iter::once(&mut program.main).chain(&mut program.subroutines);
    for rung in routines.flat_map(|routine| &mut routine.rungs) {
        let all = std::mem::take(&mut rung.actions);
        for action in all {
            if !is_own(&action) {
                rung.actions.push(action);
            } else if let (Some(last), Some(comment)) = (rung.actions.last_mut(), action.comment) {
                // It is after the last block of what the copy belongs to.
                last.comment = Some(comment);
            }
        }
    }
    program.nicknames = nicknames;
}
