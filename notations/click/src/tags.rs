//! What the addresses of a Click program become: arrays for the banks, tags for nicknames, timers and counters.

mod sections;

use super::address::{Address, Span, Tag, Which};
use super::bank::Bank;
use super::drum::Shape;
use super::model::{Condition, Constant, CounterKind, Instruction, Nickname, Program, TimerKind};
use super::ranges::{element, is_of_blocks};
use super::uses::{Access, Use, What, uses};
use ladder_format::program::{Expression, Item, Literal, Path};
use ladder_instructions::Op;
use ladder_notation::names::Names;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// A timer or a counter: one tag of a block type.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub(super) name: String,
    op: Op,
}

/// A tag that the importer makes.
#[derive(Debug)]
struct Helper {
    name: String,
    ty: String,
    /// What it is for.
    what: String,
    initial: Option<Literal>,
}

/// The tags of a program.
#[derive(Debug, Default)]
pub(super) struct Tags<'p> {
    names: Names,
    nicknames: HashMap<(Bank, &'p str), &'p Nickname>,
    numbered: HashMap<Address, &'p Nickname>,
    /// The first and last number that is used of each bank's array.
    arrays: BTreeMap<Bank, (u16, u16)>,
    /// Nicknames with tags of their own, in the order in which they are met.
    own: Vec<(Tag, String)>,
    own_by_tag: HashMap<Tag, String>,
    /// By their bits: those in banks T and CT.
    states: HashMap<Tag, State>,
    state_order: Vec<Tag>,
    /// Tags that the importer makes.
    helpers: Vec<Helper>,
    helper_names: HashMap<(String, String), String>,
    /// Addresses that lie in ranges.
    ranged: HashMap<Bank, Vec<bool>>,
    pointed: HashSet<Bank>,
    /// The conditions of the rung that is being made which are checked before it acts, and the tags that hold them.
    pub(super) late: Vec<(Condition, Expression)>,
    /// Banks of timers and counters that are arrays too, and how many copies of elements that takes.
    copied: BTreeSet<Bank>,
    copies: usize,
    /// Banks of the controller that the program writes.
    written: HashSet<Bank>,
    /// How many drums there are so far, and the blocks that they call.
    pub(super) drums: usize,
    pub(super) drum_blocks: BTreeMap<Shape, Item>,
}

/// More copies of what timers and counters hold are not made.
const MOST_COPIES: usize = 20_000;

/// Bits of the controller that ladder text has of its own, by their names in `SYS`.
const SYSTEM: &[(u16, &str)] = &[
    (1, "ON"),
    (2, "FIRST_SCAN"),
    (4, "CLOCK_10MS"),
    (5, "CLOCK_100MS"),
    (6, "CLOCK_500MS"),
    (7, "CLOCK_1S"),
    (8, "CLOCK_1M"),
    (9, "CLOCK_1H"),
];

/// Whether the profile knows an address of the controller itself in the arrays SC and SD.
pub(super) const fn is_known(bank: Bank, number: u16) -> bool {
    match bank {
        Bank::Sc => matches!(number, 1..=11 | 40 | 43 | 44 | 46 | 50),
        Bank::Sd => matches!(number, 9..=12),
        _ => false,
    }
}

/// The system bit with a number, as ladder text has it.
pub(super) fn system(number: u16) -> Option<Path> {
    let row = SYSTEM.iter().find(|(own, _)| *own == number)?;
    Some(Path::system(row.1))
}

/// The number of the system bit that a tag of the system is.
pub(super) fn system_number(tag: &str) -> Option<u16> {
    let (_, name) = tag.split_once('.')?;
    let row = SYSTEM.iter().find(|(_, own)| own.eq_ignore_ascii_case(name))?;
    Some(row.0)
}

impl<'p> Tags<'p> {
    pub(super) fn of(program: &'p Program) -> Tags<'p> {
        let mut tags = Tags::default();
        for nickname in &program.nicknames {
            if !nickname.name.is_empty() {
                tags.nicknames
                    .entry((nickname.address.bank, &nickname.name))
                    .or_insert(nickname);
            }
            tags.numbered.entry(nickname.address).or_insert(nickname);
        }
        // The arrays keep their names, whatever nicknames there are.
        for row in super::bank::BANKS {
            tags.names.spell(row.bank.array());
        }
        let uses = uses(program);
        let mut spans = Vec::new();
        for one in &uses {
            match one.what {
                What::Many(span) => spans.push(span),
                What::From(tag, count) => {
                    if let Some(address) = tags.address(tag).filter(|_| count > 1) {
                        let last = address.number.saturating_add(count as u16 - 1);
                        spans.push(Span {
                            bank: address.bank,
                            first: address.number,
                            last,
                        });
                    }
                }
                What::Somewhere(pointer) => _ = tags.pointed.insert(pointer.bank),
                What::One(_) => {}
            }
        }
        let is_written = |one: &&Use<'_>| one.access == Access::Write;
        for one in uses.iter().filter(is_written) {
            let bank = match one.what {
                What::One(tag) | What::From(tag, _) => tag.bank,
                What::Many(span) => span.bank,
                What::Somewhere(pointer) => pointer.bank,
            };
            tags.written.insert(bank);
        }
        for span in &spans {
            let (first, last) = span.bounds();
            tags.widen(span.bank, first);
            tags.widen(span.bank, last);
        }
        tags.ranged = ranged(&spans);
        for bank in tags.pointed.clone() {
            tags.widen(bank, bank.row().numbers[0].0);
            tags.widen(bank, bank.last());
        }
        tags.blocks(program);
        for one in &uses {
            match one.what {
                What::One(tag) | What::From(tag, _) => tags.meet(tag),
                // A contact on a range is one on each of its bits.
                What::Many(span) if one.access == Access::Contact && is_of_blocks(span.bank) => {
                    let (first, last) = span.bounds();
                    for number in (first..=last).filter(|number| span.bank.has(*number)) {
                        tags.meet(&Tag::number(span.bank, number));
                    }
                }
                _ => {}
            }
        }
        tags
    }

    /// The address of a tag, if it is known.
    pub(super) fn address(&self, tag: &Tag) -> Option<Address> {
        match &tag.which {
            Which::Number(_) => tag.address(),
            Which::Nickname(name) => Some(self.nicknames.get(&(tag.bank, name.as_str()))?.address),
        }
    }

    /// One spelling for each address: its number, if that is known.
    fn canonical(&self, tag: &Tag) -> Tag {
        self.address(tag).map_or_else(|| tag.clone(), Tag::from)
    }

    /// The timer or counter whose bit or value a tag is.
    fn state_key(&self, tag: &Tag) -> Option<Tag> {
        let bank = match tag.bank {
            Bank::T | Bank::Td => Bank::T,
            Bank::Ct | Bank::Ctd => Bank::Ct,
            _ => return None,
        };
        let mut key = self.canonical(tag);
        key.bank = bank;
        Some(key)
    }

    fn widen(&mut self, bank: Bank, number: u16) {
        let lowest = bank.row().numbers[0].0;
        let there = self.arrays.entry(bank).or_insert((lowest.min(number), number));
        there.1 = there.1.max(number);
    }

    /// The timers and counters that have blocks.
    fn blocks(&mut self, program: &'p Program) {
        let rungs = program.routines().flat_map(|routine| &routine.rungs);
        for action in rungs.flat_map(|rung| &rung.actions) {
            let (tag, op) = match &action.what {
                Instruction::Timer(timer) => {
                    let op = match timer.kind {
                        TimerKind::On => Op::Ton,
                        TimerKind::Off => Op::Tof,
                        TimerKind::RetentiveOn => Op::Rto,
                        TimerKind::RetentiveOff => Op::Rtof,
                    };
                    (&timer.tag, op)
                }
                Instruction::Counter(counter) => {
                    let op = match counter.kind {
                        CounterKind::Up => Op::Ctu,
                        CounterKind::Down => Op::Ctd,
                        CounterKind::UpDown => Op::Ctud,
                    };
                    (&counter.tag, op)
                }
                _ => continue,
            };
            self.state_of(tag, op);
        }
    }

    fn state_of(&mut self, tag: &Tag, op: Op) {
        let Some(key) = self.state_key(tag).filter(|key| !self.states.contains_key(key)) else {
            return;
        };
        let like = match (&key.which, &tag.which) {
            (Which::Nickname(name), _) | (_, Which::Nickname(name)) => name.clone(),
            (Which::Number(number), _) => self.nickname_of(&key).map_or_else(
                || format!("{}{number}", key.bank.row().name),
                |nickname| nickname.name.clone(),
            ),
        };
        let name = self.names.fresh(&like);
        self.state_order.push(key.clone());
        self.states.insert(key, State { name, op });
    }

    fn nickname_of(&self, tag: &Tag) -> Option<&'p Nickname> {
        let nickname = self.numbered.get(&tag.address()?).copied()?;
        (!nickname.name.is_empty()).then_some(nickname)
    }

    /// Whether an address is reached as an element of its bank too, so that it cannot be a tag of its own.
    fn is_shared(&self, address: Address) -> bool {
        let in_range = self.ranged.get(&address.bank);
        is_known(address.bank, address.number)
            || self.pointed.contains(&address.bank)
            || in_range.is_some_and(|there| there.get(usize::from(address.number)) == Some(&true))
    }

    fn meet(&mut self, tag: &Tag) {
        match tag.bank {
            Bank::T | Bank::Td => return self.state_of(tag, Op::Ton),
            Bank::Ct | Bank::Ctd => return self.state_of(tag, Op::Ctu),
            _ => {}
        }
        let tag = self.canonical(tag);
        if self.own_by_tag.contains_key(&tag) {
            return;
        }
        let like = match &tag.which {
            Which::Nickname(name) => name.clone(),
            Which::Number(number) => {
                if tag.bank == Bank::Sc && system(*number).is_some() {
                    return;
                }
                let own = self
                    .nickname_of(&tag)
                    .filter(|nickname| !self.is_shared(nickname.address));
                match (own, tag.address()) {
                    (Some(nickname), _) => nickname.name.clone(),
                    // It is between two numbers, and no element.
                    (None, Some(address)) if address.is_upper() => address.to_string(),
                    (None, _) => return self.widen(tag.bank, *number),
                }
            }
        };
        let name = self.names.fresh(&like);
        self.own_by_tag.insert(tag.clone(), name.clone());
        self.own.push((tag, name));
    }

    /// The timer or counter that a tag belongs to.
    pub(super) fn state(&self, tag: &Tag) -> Option<&State> {
        self.states.get(&self.state_key(tag)?)
    }

    /// A tag where its bit or value is read or written: `DS[1]`, `Level`, `T1.DN`, `SYS.ON`.
    pub(super) fn place(&self, tag: &Tag) -> Expression {
        if let Some(state) = self.state(tag) {
            let value = matches!(tag.bank, Bank::Td | Bank::Ctd);
            return Path::tag(&state.name)
                .member(if value { "ACC" } else { "DN" })
                .into();
        }
        let tag = self.canonical(tag);
        if let Some(name) = self.own_by_tag.get(&tag) {
            return Path::tag(name).into();
        }
        match &tag.which {
            Which::Number(number) => match system(*number).filter(|_| tag.bank == Bank::Sc) {
                Some(system) => system.into(),
                None => element(tag.bank, *number),
            },
            Which::Nickname(name) => Path::tag(name).into(),
        }
    }

    /// The name of the tag, or of the array, that an address is part of. None: a timer or counter, or the system's.
    pub(super) fn declared(&self, tag: &Tag) -> Option<String> {
        match tag.bank {
            Bank::T | Bank::Ct | Bank::Td | Bank::Ctd => return None,
            _ => {}
        }
        let tag = self.canonical(tag);
        match (self.own_by_tag.get(&tag), &tag.which) {
            (Some(name), _) => Some(name.clone()),
            (None, Which::Number(number)) if tag.bank == Bank::Sc && system(*number).is_some() => None,
            (None, Which::Number(_)) => Some(tag.bank.row().name.to_owned()),
            (None, Which::Nickname(_)) => None,
        }
    }

    /// Whether a tag is an element of its bank's array, and which.
    pub(super) fn element(&self, tag: &Tag) -> Option<Address> {
        let tag = self.canonical(tag);
        tag.address().filter(|_| !self.own_by_tag.contains_key(&tag))
    }

    /// The tag that holds what a condition was before its rung acts.
    pub(super) fn seen(&self, condition: &Condition) -> Option<Expression> {
        let found = self.late.iter().find(|(late, _)| late == condition)?;
        Some(found.1.clone())
    }

    /// Where the blocks of a range keep what they hold, each with its element in the array of the bank.
    ///
    /// # Errors
    ///
    /// The program has so many of them that it would grow out of all proportion.
    pub(super) fn copies(&mut self, span: &Span) -> Result<Vec<(Expression, Expression)>, String> {
        if !is_of_blocks(span.bank) {
            return Ok(Vec::new());
        }
        self.copied.insert(span.bank);
        let (first, last) = span.bounds();
        self.widen(span.bank, first);
        self.widen(span.bank, last);
        let mut out = Vec::new();
        for key in &self.state_order {
            let mut tag = key.clone();
            tag.bank = span.bank;
            let is_there = tag.address().is_some_and(|address| span.holds(address));
            if is_there && self.state_key(&tag).as_ref() == Some(key) {
                let Which::Number(number) = key.which else {
                    continue;
                };
                out.push((element(span.bank, number), self.place(&tag)));
            }
        }
        out.sort_by_cached_key(|(element, _)| element.to_string().len());
        self.copies += out.len();
        if self.copies > MOST_COPIES {
            return Err("the program takes timers and counters as ranges too often".to_owned());
        }
        Ok(out)
    }

    /// Makes a tag of the importer's own. `what` says what it is for, and is how it is known again.
    pub(super) fn helper(&mut self, like: &str, ty: &str, what: impl Into<String>) -> Expression {
        self.constant(like, ty, what, None)
    }

    /// As [`Tags::helper`], with a value that stays.
    pub(super) fn constant(
        &mut self,
        like: &str,
        ty: &str,
        what: impl Into<String>,
        initial: Option<Literal>,
    ) -> Expression {
        let key = (ty.to_owned(), what.into());
        if let Some(name) = self.helper_names.get(&key) {
            return Path::tag(name).into();
        }
        let name = self.names.fresh(like);
        self.helper_names.insert(key.clone(), name.clone());
        let (ty, what) = key;
        self.helpers.push(Helper {
            name: name.clone(),
            ty,
            what,
            initial,
        });
        Path::tag(name).into()
    }

    /// The names that had to change: as the DSL has them, and as they are here.
    pub(super) fn renamed(&self) -> Vec<(String, &str)> {
        let own = self.own.iter().map(|(tag, name)| (tag, name.as_str()));
        let states = self
            .state_order
            .iter()
            .map(|tag| (tag, self.states[tag].name.as_str()));
        let mut out = Vec::new();
        for (tag, name) in own.chain(states) {
            let nickname = match &tag.which {
                Which::Nickname(nickname) => Some(nickname.as_str()),
                Which::Number(_) => self.nickname_of(tag).map(|nickname| nickname.name.as_str()),
            };
            if nickname.is_some_and(|nickname| nickname != name) {
                out.push((tag.dsl(), name));
            }
        }
        out
    }

    /// What the address picker says that declarations cannot: names and values of elements.
    pub(super) fn unsaid(&self) -> Vec<(&'p Nickname, &'static str)> {
        let mut out = Vec::new();
        let mut all: Vec<_> = self.numbered.values().copied().collect();
        all.sort_by_key(|nickname| nickname.address);
        for nickname in all {
            let tag = Tag::from(nickname.address);
            if self.element(&tag).is_none() || !self.arrays.contains_key(&nickname.address.bank) {
                continue;
            }
            if nickname.initial.as_ref().is_some_and(|initial| !is_zero(initial)) {
                out.push((
                    nickname,
                    "an element of an array has no initial value of its own here",
                ));
            }
            if !nickname.name.is_empty() && self.is_shared(nickname.address) {
                out.push((
                    nickname,
                    "it is reached as an element of its bank, so its nickname is left out",
                ));
            }
            let bank = nickname.address.bank.row().retentive;
            if nickname.retentive.is_some_and(|retentive| retentive != bank) {
                out.push((
                    nickname,
                    "all elements of a bank keep their values here, or none does",
                ));
            }
        }
        out
    }
}

/// Which addresses of each bank lie in ranges.
fn ranged(spans: &[Span]) -> HashMap<Bank, Vec<bool>> {
    // How many ranges begin and end at each number.
    let mut changes: HashMap<Bank, Vec<i32>> = HashMap::new();
    for span in spans {
        let (first, last) = span.bounds();
        let changes = changes.entry(span.bank).or_insert_with(|| vec![0; 0x1_0001]);
        changes[usize::from(first)] += 1;
        changes[usize::from(last) + 1] -= 1;
    }
    let covered = |changes: Vec<i32>| {
        let mut open = 0;
        let there = changes.into_iter().map(|change| {
            open += change;
            open > 0
        });
        there.collect()
    };
    changes
        .into_iter()
        .map(|(bank, changes)| (bank, covered(changes)))
        .collect()
}

/// Whether a value is the one that everything has at the start anyway.
fn is_zero(constant: &Constant) -> bool {
    match constant {
        Constant::Bit(on) => !on,
        Constant::Int(number) => *number == 0,
        Constant::Hex(number) => *number == 0,
        Constant::Float(number) => *number == 0.0,
        Constant::Text(text) => text.is_empty(),
    }
}
