//! Contacts and comparisons, as cells have them.

use super::super::address::{Address, Tag};
use super::super::bank::Kind;
use super::super::model::{Bits, Comparison, Condition, Contact, ContactKind, Relation};
use super::addresses::Addresses;
use super::operand::{operand, operand_text};
use ladder_notation::LineColumn;

/// What a cell means, and what of it is only nearly expressed.
pub(super) struct Read {
    pub(super) condition: Condition,
    pub(super) remark: Option<&'static str>,
}

/// A contact or a comparison.
///
/// # Errors
///
/// Why it is none.
pub(super) fn read(text: &str, place: LineColumn) -> Result<Read, String> {
    if let Some(comparison) = comparison(text, place)? {
        let condition = Condition::Compare(comparison);
        return Ok(Read {
            condition,
            remark: None,
        });
    }
    let call = |name: &str| text.strip_prefix(name)?.strip_prefix('(')?.strip_suffix(')');
    let (kind, bit) = if let Some(bit) = call("rise") {
        (ContactKind::Rising, bit)
    } else if let Some(bit) = call("fall") {
        (ContactKind::Falling, bit)
    } else if let Some(bit) = text.strip_prefix('~') {
        (ContactKind::Closed, bit)
    } else {
        (ContactKind::Open, text)
    };
    let immediate = bit
        .strip_prefix("immediate(")
        .and_then(|bit| bit.strip_suffix(')'))
        .or_else(|| bit.strip_suffix(".immediate"));
    let remark = immediate.map(|_| "it reads the input itself; here all inputs are read before the scan");
    let bit = immediate.unwrap_or(bit).trim();
    let address = Address::parse(bit).ok_or_else(|| unknown(text))?;
    if address.bank.kind() != Kind::Bit {
        return Err(format!("{address} is not a bit: compare it with a value"));
    }
    let contact = Contact {
        place,
        kind,
        bits: Bits::One(exists(address)?),
    };
    let condition = Condition::Contact(contact);
    Ok(Read { condition, remark })
}

fn unknown(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    format!(
        "`{shown}` is not a cell of the grid: `X001`, `~X001`, `rise(X001)`, `fall(X001)`, `DS1==5`, `-`, `T`, `|` and `T:X001` are"
    )
}

/// An address that there is.
pub(super) fn exists(address: Address) -> Result<Tag, String> {
    let Address { bank, number } = address;
    if !bank.has(number) {
        return Err(format!(
            "there is no {address}: {} has {}",
            bank.row().name,
            bank.extent()
        ));
    }
    Ok(address.into())
}

fn comparison(text: &str, place: LineColumn) -> Result<Option<Comparison>, String> {
    let Some((left, relation, right)) = split(text) else {
        return Ok(None);
    };
    let side = |text: &str| operand(text).map_err(|_| unknown(text));
    let (left, right) = (side(left)?, side(right)?);
    Ok(Some(Comparison {
        place,
        left,
        relation,
        right,
    }))
}

/// What is on both sides of the relation, if there is one outside of quotes.
pub(super) fn split(text: &str) -> Option<(&str, Relation, &str)> {
    let mut quoted = false;
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        if quoted || !matches!(c, '=' | '!' | '<' | '>') {
            continue;
        }
        let sign = text[at..]
            .find(|c| !matches!(c, '=' | '!' | '<' | '>'))
            .map_or(&text[at..], |end| &text[at..at + end]);
        let relation = Relation::named(sign)?;
        return Some((text[..at].trim(), relation, text[at + sign.len()..].trim()));
    }
    None
}

/// As a cell has it. None: no cell has it, or an address in it has none.
pub(super) fn write(condition: &Condition, addresses: &Addresses) -> Option<String> {
    match condition {
        Condition::Contact(Contact { kind, bits, .. }) => {
            let Bits::One(tag) = bits else { return None };
            let bit = addresses.text(tag)?;
            Some(match kind {
                ContactKind::Open => bit,
                ContactKind::Closed => format!("~{bit}"),
                ContactKind::Rising => format!("rise({bit})"),
                ContactKind::Falling => format!("fall({bit})"),
            })
        }
        Condition::Compare(Comparison {
            left,
            relation,
            right,
            ..
        }) => Some(format!(
            "{}{}{}",
            operand_text(left, addresses)?,
            relation.sign(),
            operand_text(right, addresses)?
        )),
        Condition::All(_) | Condition::Any(_) => None,
    }
}
