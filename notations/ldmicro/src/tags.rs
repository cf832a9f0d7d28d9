//! What the names of an LDmicro program become: bits, variables, timers, counters, places of shift registers.

use super::element::{self, Form};
use super::field::{self, Slot};
use super::fork::{self, Given, What};
use super::model::Dialect;
use super::model::{File, Leaf, leaves};
use ladder_format::program::Path;
use ladder_instructions::{Op, by_op};
use ladder_notation::names::Names;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The tags of a program. LDmicro keeps bits and variables apart, so one name can be two tags.
#[derive(Debug, Default)]
pub(super) struct Tags {
    names: Names,
    /// LDmicro's names in the order in which they were met, with the tag of each.
    pub(super) bits: Vec<(String, String)>,
    pub(super) variables: Vec<(String, String)>,
    bit: HashMap<String, String>,
    variable: HashMap<String, String>,
    /// The block types of timers and counters.
    states: HashMap<String, Op>,
    /// Shift registers: the tag and how many stages it has.
    pub(super) registers: BTreeMap<String, (String, u32)>,
    /// Where counters of the fork begin, if not at 0.
    initial: HashMap<String, i64>,
    /// Inputs that are high when a simulation begins.
    high: HashSet<String>,
    /// Outputs of pulses, with their numbers.
    pub(super) pulses: BTreeMap<String, u32>,
    /// What RES gives a counter of the fork, with the elements that say so, the first one first.
    resets: HashMap<String, (u8, String)>,
}

/// There are no more outputs of pulses here.
const MOST_PULSES: u32 = 64;

/// A shift register with more stages is not made.
pub(super) const MOST_STAGES: u32 = 10_000;

impl Tags {
    pub(super) fn of(file: &File) -> Tags {
        let all: Vec<&Leaf> = file.rungs.iter().flat_map(|rung| leaves(&rung.parts)).collect();
        let mut tags = Tags::default();
        let dialect = file.dialect();
        for leaf in &all {
            tags.kinds(leaf, dialect);
        }
        for (_, entry) in &file.io {
            let name = entry.split(' ').next().unwrap_or_default();
            match name.chars().next() {
                Some('X' | 'Y') => tags.meet_bit(name),
                Some('A') => tags.meet_variable(name),
                _ => {}
            }
        }
        for leaf in &all {
            tags.meet(leaf, dialect);
        }
        let registers: Vec<String> = tags.registers.keys().cloned().collect();
        for name in registers {
            let tag = if tags.bit.contains_key(&name) || tags.variable.contains_key(&name) {
                tags.names.fresh(&name)
            } else {
                tags.names.spell(&name).to_owned()
            };
            if let Some((there, _)) = tags.registers.get_mut(&name) {
                *there = tag;
            }
        }
        tags
    }

    /// Notes what an element says about the kind of its name.
    fn kinds(&mut self, leaf: &Leaf, dialect: Dialect) {
        if let Some(read) = fork::read(&leaf.text, dialect) {
            if let Ok(read) = read {
                self.counter(&leaf.text, &read);
                if read.what == What::Instruction(Op::Pwm) {
                    self.pulse(leaf.text.split(' ').nth(3).unwrap_or_default());
                }
            }
            return;
        }
        let Some(row) = element::row_of(&leaf.text) else {
            return;
        };
        let fields = field::fields(&leaf.text);
        match row.form {
            Form::Contact if fields.get(2).is_some_and(|high| *high != "0") => {
                self.high.insert(fields[0].to_owned());
            }
            Form::Timer(op) | Form::Counter(op) => {
                self.states.entry(fields[0].to_owned()).or_insert(op);
            }
            Form::Shift => {
                let stages = fields[1].parse().unwrap_or(0).min(MOST_STAGES);
                let there = self.registers.entry(fields[0].to_owned()).or_default();
                there.1 = there.1.max(stages);
            }
            _ => {}
        }
    }

    /// Notes where a counter of the fork begins.
    fn counter(&mut self, text: &str, read: &fork::Read<'_>) {
        let Some((name, init)) = read.counter() else {
            return;
        };
        if let Some(number) = read.initial {
            self.initial.insert(name.to_owned(), number);
        }
        // Of several counters with one name LDmicro takes the first of these.
        let rank = ["CTU", "CTD", "CTC", "CTR"].map(|word| text.starts_with(word));
        let rank = rank.iter().position(|is| *is).unwrap_or(4) as u8;
        let there = self
            .resets
            .entry(name.to_owned())
            .or_insert((u8::MAX, String::new()));
        if rank < there.0 {
            *there = (rank, init);
        }
    }

    /// The value that a variable of LDmicro's begins with, if it is not 0.
    pub(super) fn initial(&self, name: &str) -> Option<i64> {
        self.initial.get(name).copied().filter(|initial| *initial != 0)
    }

    /// Whether an input is high when a simulation begins.
    pub(super) fn begins_high(&self, name: &str) -> bool {
        self.high.contains(name)
    }

    /// The number of an output of pulses: its own, or the first that is free.
    fn pulse(&mut self, name: &str) {
        if self.pulses.contains_key(name) {
            return;
        }
        let own = name
            .strip_prefix('P')
            .and_then(|number| number.parse::<u32>().ok());
        let is_free = |number: &u32| self.pulses.values().all(|taken| taken != number);
        let own = own.filter(|number| *number < MOST_PULSES && is_free(number));
        if let Some(number) = own.or_else(|| (0..MOST_PULSES).find(is_free)) {
            self.pulses.insert(name.to_owned(), number);
        }
    }

    /// Whether it is an output of pulses.
    pub(super) fn is_pulses(&self, name: &str) -> bool {
        self.pulses.contains_key(name)
    }

    /// What RES gives a variable: a number, or another variable.
    pub(super) fn reset(&self, name: &str) -> &str {
        let counter = self.resets.get(name).filter(|_| name.starts_with('C'));
        counter.map_or("0", |(_, init)| init)
    }

    /// Notes the names of an element.
    fn meet(&mut self, leaf: &Leaf, dialect: Dialect) {
        if let Some(read) = fork::read(&leaf.text, dialect) {
            for given in read.map(|read| read.given).unwrap_or_default() {
                match given {
                    Given::Place(name) | Given::Value(name) | Given::Bit(name, _) => self.meet_variable(name),
                    Given::Relay(name) => self.meet_bit(name),
                    Given::Scans(_) | Given::Pulses(_) | Given::Fields(_) => {}
                }
            }
            return;
        }
        let Some(row) = element::row_of(&leaf.text) else {
            return;
        };
        let fields = field::fields(&leaf.text);
        match row.form {
            Form::Contact | Form::Coil => self.meet_bit(fields[0]),
            Form::Reset if self.is_pulses(fields[0]) => {}
            Form::Timer(_) | Form::Counter(_) | Form::Reset | Form::Adc => self.meet_variable(fields[0]),
            Form::Values(_, slots) => {
                for (field, slot) in fields.iter().zip(slots) {
                    if *slot != Slot::Number {
                        self.meet_variable(field);
                    }
                }
            }
            Form::Table | Form::Curve => {
                fields[..2].iter().for_each(|name| self.meet_variable(name));
            }
            Form::Text if fields[0] != "(none)" => self.meet_variable(fields[0]),
            _ => {}
        }
    }

    fn meet_bit(&mut self, name: &str) {
        if !self.bit.contains_key(name) {
            let tag = if self.variable.contains_key(name) {
                self.names.fresh(name)
            } else {
                self.names.spell(name).to_owned()
            };
            self.bit.insert(name.to_owned(), tag.clone());
            self.bits.push((name.to_owned(), tag));
        }
    }

    fn meet_variable(&mut self, name: &str) {
        if field::is_literal(name) || self.variable.contains_key(name) || self.stage(name).is_some() {
            return;
        }
        let tag = if self.bit.contains_key(name) {
            self.names.fresh(name)
        } else {
            self.names.spell(name).to_owned()
        };
        self.variable.insert(name.to_owned(), tag.clone());
        self.variables.push((name.to_owned(), tag));
    }

    /// The place in a shift register that a name such as `reg3` means.
    fn stage(&self, name: &str) -> Option<Path> {
        let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        // `r12` can be stage 12 of `r` or stage 2 of `r1`.
        (1..=digits.min(9)).find_map(|length| {
            let (base, index) = name.split_at(name.len() - length);
            if index.len() > 1 && index.starts_with('0') {
                return None;
            }
            let (tag, stages) = self.registers.get(base)?;
            let index: u32 = index.parse().ok()?;
            (index < *stages).then(|| Path::tag(tag).index([i64::from(index)]))
        })
    }

    /// The tag of a name in the I/O list.
    pub(super) fn listed(&self, name: &str) -> Option<&str> {
        let tag = match name.chars().next()? {
            'X' | 'Y' => self.bit.get(name),
            'A' => self.variable.get(name),
            _ => None,
        };
        tag.map(String::as_str)
    }

    pub(super) fn bit(&self, name: &str) -> Path {
        Path::tag(self.bit.get(name).map_or("_", String::as_str))
    }

    /// The type that a variable is declared with.
    pub(super) fn ty(&self, name: &str) -> String {
        match self.states.get(name) {
            Some(op) => by_op(*op).mnemonic.to_owned(),
            None => "INT".to_owned(),
        }
    }

    /// The tag of a timer or counter, if the name is one of this sort.
    pub(super) fn state(&self, name: &str, op: Op) -> Option<Path> {
        let own = self.states.get(name)?;
        self.any_state(name)
            .filter(|_| is_counter(*own) == is_counter(op))
    }

    /// The tag of any timer or counter.
    pub(super) fn any_state(&self, name: &str) -> Option<Path> {
        let _ = self.states.get(name)?;
        self.variable.get(name).map(Path::tag)
    }

    /// A variable where a number is read or written.
    pub(super) fn variable(&self, name: &str) -> Path {
        if let Some(stage) = self.stage(name) {
            return stage;
        }
        let tag = Path::tag(self.variable.get(name).map_or("_", String::as_str));
        match self.states.get(name) {
            None => tag,
            Some(op) if is_counter(*op) => tag.member("CV"),
            Some(_) => tag.member("ET"),
        }
    }

    /// The tags of a name, whatever they are.
    pub(super) fn named(&self, name: &str) -> impl Iterator<Item = String> {
        let stage = self.stage(name).map(|stage| stage.to_string());
        let own = [self.bit.get(name), self.variable.get(name)];
        stage.into_iter().chain(own.into_iter().flatten().cloned())
    }

    /// The names that had to change, as the tag and LDmicro's name.
    pub(super) fn renamed(&self) -> Vec<(&str, &str)> {
        let registers = self.registers.iter().map(|(name, (tag, _))| (name, tag));
        let all = self
            .bits
            .iter()
            .chain(&self.variables)
            .map(|(name, tag)| (name, tag));
        all.chain(registers)
            .filter(|(name, tag)| name != tag)
            .map(|(name, tag)| (tag.as_str(), name.as_str()))
            .collect()
    }
}

fn is_counter(op: Op) -> bool {
    matches!(op, Op::Ctu | Op::Ctd | Op::Ctc)
}
