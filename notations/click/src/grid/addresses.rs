//! The addresses of nicknames: the grid knows nothing else.

use super::super::address::{Address, Tag, Which};
use super::super::bank::Bank;
use super::super::model::{Nickname, Program};
use super::super::uses::{What, uses};
use crate::python_name::python_name;
use ladder_notation::Report;
use std::collections::{HashMap, HashSet};

/// Where each tag of a program lies.
#[derive(Debug, Default)]
pub(super) struct Addresses {
    by_nickname: HashMap<(Bank, String), u16>,
    /// What had no address and got one here.
    given: Vec<Nickname>,
}

/// The bit and the value of a timer or counter have one number.
const fn pair(bank: Bank) -> Bank {
    match bank {
        Bank::Td => Bank::T,
        Bank::Ctd => Bank::Ct,
        bank => bank,
    }
}

impl Addresses {
    /// Those of a program. A nickname without an address gets the first one of its bank that nothing uses.
    pub(super) fn of(program: &Program, report: &mut Report) -> Addresses {
        let mut addresses = Addresses::default();
        let mut taken: HashSet<(Bank, u16)> = HashSet::new();
        for nickname in &program.nicknames {
            let Address { bank, number } = nickname.address;
            taken.insert((pair(bank), number));
            if !nickname.name.is_empty() {
                addresses
                    .by_nickname
                    .insert((pair(bank), nickname.name.clone()), number);
                // Tags are called as Python can call them.
                addresses
                    .by_nickname
                    .entry((pair(bank), python_name(&nickname.name)))
                    .or_insert(number);
            }
        }
        let uses = uses(program);
        for one in &uses {
            let (bank, first, count) = match one.what {
                What::One(tag) => (tag.bank, tag.address(), 1),
                What::From(tag, count) => (tag.bank, tag.address(), count),
                What::Many(span) => (
                    span.bank,
                    Some(Address {
                        bank: span.bank,
                        number: span.bounds().0,
                    }),
                    span.len(),
                ),
                What::Somewhere(_) => continue,
            };
            let Some(first) = first else { continue };
            let numbers = first.number
                ..=first
                    .number
                    .saturating_add(u16::try_from(count - 1).unwrap_or(u16::MAX));
            taken.extend(numbers.map(|number| (pair(bank), number)));
        }
        for one in &uses {
            if let What::One(tag) | What::From(tag, _) = one.what {
                addresses.give(tag, &mut taken, |address, name| {
                    let why = format!("Click's grid has addresses only; it has none, and becomes {address}");
                    report.approximated(one.place, name, why);
                });
            }
        }
        addresses
    }

    fn give(&mut self, tag: &Tag, taken: &mut HashSet<(Bank, u16)>, say: impl FnOnce(Address, &str)) {
        let Which::Nickname(name) = &tag.which else { return };
        let key = (pair(tag.bank), name.clone());
        if self.by_nickname.contains_key(&key) {
            return;
        }
        let bank = key.0;
        let numbers = bank.row().numbers.iter().flat_map(|(first, last)| *first..=*last);
        let Some(number) = numbers
            .into_iter()
            .find(|number| !taken.contains(&(bank, *number)))
        else {
            return;
        };
        taken.insert((bank, number));
        self.by_nickname.insert(key, number);
        let address = Address { bank, number };
        say(address, name);
        self.given.push(Nickname {
            address,
            name: name.clone(),
            comment: String::new(),
            initial: None,
            retentive: None,
        });
    }

    /// The address of a tag. None: its bank is full.
    pub(super) fn of_tag(&self, tag: &Tag) -> Option<Address> {
        match &tag.which {
            Which::Number(_) => tag.address(),
            Which::Nickname(name) => Some(Address {
                bank: tag.bank,
                number: *self.by_nickname.get(&(pair(tag.bank), name.clone()))?,
            }),
        }
    }

    /// As the grid writes a tag.
    pub(super) fn text(&self, tag: &Tag) -> Option<String> {
        self.of_tag(tag).map(|address| address.to_string())
    }

    /// What had no address before.
    pub(super) fn into_given(self) -> Vec<Nickname> {
        self.given
    }
}
