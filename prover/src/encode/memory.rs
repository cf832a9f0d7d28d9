//! The memory of a scan that is followed: what each cell holds, as far as it was touched.

use super::cells::{Cells, InputTag};
use super::slots::Reach;
use super::world::World;
use crate::graph::Lit;
use crate::number::{Number, room};
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Memory as Banks, TextSlot, Width, Word, timer};
use rustc_hash::FxHashMap;

/// A cell that is remembered, and the numbers of its bits among those that are.
#[derive(Debug)]
enum Remembered {
    Bit(u32, usize),
    Word(u32, Vec<usize>),
    Phase(u32, Vec<usize>),
    /// Of a timer the scans since it began, and how many there can be.
    Age(u32, Vec<usize>, u64),
}

/// A cell that is remembered from scan to scan, or what is in the place of cells of a timer: by the cell, or its first bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Kept {
    Bit(u32),
    Word(u32),
    Phase(u32),
    Age(u32),
}

/// See the module.
#[derive(Debug)]
pub(crate) struct Memory<'c> {
    initial: &'c Banks,
    /// None: nothing but what was put in changes, as in the small program of an expression.
    cells: Option<&'c Cells>,
    bits: FxHashMap<u32, Lit>,
    words: FxHashMap<u32, Number>,
    phases: FxHashMap<u32, Vec<Lit>>,
    ages: FxHashMap<u32, Number>,
    /// Ages that became open before they were asked for: where that is so, and their bits.
    open_ages: FxHashMap<u32, Vec<(Lit, Vec<Lit>)>>,
    remembered: Vec<Remembered>,
}

impl<'c> Memory<'c> {
    pub(crate) fn new(initial: &'c Banks, cells: Option<&'c Cells>) -> Memory<'c> {
        Memory {
            initial,
            cells,
            bits: FxHashMap::default(),
            words: FxHashMap::default(),
            phases: FxHashMap::default(),
            ages: FxHashMap::default(),
            open_ages: FxHashMap::default(),
            remembered: Vec::new(),
        }
    }

    /// Which cells computed slots may mean.
    pub(super) fn reach(&self) -> Option<&'c Reach> {
        Some(&self.cells?.reach)
    }

    /// Whether a word was put in or touched.
    pub(super) fn holds(&self, Word(at): Word) -> bool {
        self.words.contains_key(&at)
    }

    /// Whether a word may hold something else than at the start.
    pub(super) fn changes(&self, word: Word) -> bool {
        self.cells.is_some_and(|cells| cells.word_changes(word))
    }

    /// The type of a word that is a tag.
    pub(super) fn type_of(&self, word: Word) -> Option<Scalar> {
        self.cells?.type_of(word)
    }

    /// How many scans ago a timer began, where that is told.
    pub(super) fn known_age(&self, timer: Bit) -> Option<Number> {
        self.ages.get(&timer.0).cloned()
    }

    pub(crate) fn set_bit(&mut self, Bit(at): Bit, value: Lit) {
        self.bits.insert(at, value);
    }

    pub(crate) fn set_word(&mut self, Word(at): Word, value: Number) {
        self.words.insert(at, value);
    }

    pub(crate) fn bit(&mut self, world: &mut World, bit: Bit) -> Lit {
        let at = bit.0;
        if let Some(&value) = self.bits.get(&at) {
            return value;
        }
        let initial = self.initial.bits.get(at as usize) == Some(&1);
        let value = match self.cells {
            Some(cells) if cells.inputs_at_bits.contains_key(&at) => {
                world.shared(&cells.inputs_at_bits[&at]).bit(0)
            }
            Some(cells) if cells.bit_changes(bit) => {
                let (leaves, numbers) = world.remember_cell(Kept::Bit(at), 1, i64::from(initial));
                self.remembered.push(Remembered::Bit(at, numbers[0]));
                leaves[0]
            }
            _ => Lit::constant(initial),
        };
        self.bits.insert(at, value);
        value
    }

    pub(crate) fn word(&mut self, world: &mut World, word: Word) -> Number {
        let at = word.0;
        if let Some(value) = self.words.get(&at) {
            return value.clone();
        }
        let initial = self.initial.words.get(at as usize).copied().unwrap_or(0);
        let value = match self.cells {
            Some(cells) if cells.inputs_at_words.contains_key(&at) => {
                world.shared(&cells.inputs_at_words[&at])
            }
            Some(cells) if cells.word_changes(word) => {
                let width = cells.type_of(word).map_or(Width::I64, Width::of);
                self.remember_word(world, at, width, initial)
            }
            _ => Number::constant(initial),
        };
        self.words.insert(at, value.clone());
        value
    }

    fn remember_word(&mut self, world: &mut World, at: u32, width: Width, initial: i64) -> Number {
        let ends = world.ranges.get(&at).copied();
        let bits = ends.map_or(width.bits() as usize, room);
        let (leaves, numbers) = world.remember_cell(Kept::Word(at), bits, initial);
        world.numbers.push(numbers.clone());
        self.remembered.push(Remembered::Word(at, numbers));
        Number::of_bits(leaves).wrapped(width).within(ends)
    }

    /// What words that are remembered can hold before the next scan, whatever they held before this one: what they begin with, and
    /// what it leaves.
    pub(crate) fn ranges(&self) -> FxHashMap<u32, (i128, i128)> {
        let of = |remembered: &Remembered| {
            let Remembered::Word(at, _) = remembered else {
                return None;
            };
            let initial = i128::from(self.initial.words.get(*at as usize).copied().unwrap_or(0));
            let (least, most) = self.words[at].ends()?;
            Some((*at, (least.min(initial), most.max(initial))))
        };
        self.remembered.iter().filter_map(of).collect()
    }

    /// The word of a timer's ET whose presets are at most this: no longer than it takes.
    pub(crate) fn elapsed(&mut self, world: &mut World, word: Word, most: i64) -> Number {
        if self.cells.is_some_and(|cells| cells.alone.is_some()) {
            let is_first = !self.words.contains_key(&word.0);
            let value = self.word(world, word);
            world.valid.extend(is_first.then(|| !value.sign()));
            return value;
        }
        let is_own = self.cells.is_some_and(|cells| cells.elapsed.contains(&word.0));
        if !is_own {
            return self.word(world, word);
        }
        self.up_to(world, word, most)
    }

    /// A word that only one block uses and that holds 0 to this.
    pub(crate) fn up_to(&mut self, world: &mut World, word: Word, most: i64) -> Number {
        if self.words.contains_key(&word.0) || self.cells.is_none_or(|cells| cells.alone.is_some()) {
            return self.word(world, word);
        }
        let count = (64 - most.max(0).leading_zeros()) as usize;
        let (leaves, numbers) = world.remember_cell(Kept::Word(word.0), count, 0);
        self.remembered.push(Remembered::Word(word.0, numbers));
        let value = Number::unsigned(leaves);
        self.words.insert(word.0, value.clone());
        value
    }

    /// What a timer is doing: three bits, by its first bit.
    pub(crate) fn phase(&mut self, world: &mut World, timer: Bit) -> Vec<Lit> {
        if let Some(phase) = self.phases.get(&timer.0) {
            return phase.clone();
        }
        if let Some(tag) = self.of_timer(timer, "phase", Scalar::Usint) {
            let phase = world.shared(&tag).low(3);
            self.phases.insert(timer.0, phase.clone());
            return phase;
        }
        let initial = self.initial.bits.get((timer.0 + timer::PHASE) as usize);
        let initial = i64::from(initial.copied().unwrap_or(0));
        let (leaves, numbers) = world.remember_cell(Kept::Phase(timer.0), 3, initial);
        self.remembered.push(Remembered::Phase(timer.0, numbers));
        self.phases.insert(timer.0, leaves.clone());
        leaves
    }

    pub(crate) fn set_phase(&mut self, timer: Bit, phase: Vec<Lit>) {
        self.phases.insert(timer.0, phase);
    }

    /// How many scans ago a timer began, held at the number given.
    pub(crate) fn age(&mut self, world: &mut World, timer: Bit, most: u64) -> Number {
        if let Some(age) = self.ages.get(&timer.0) {
            return age.clone();
        }
        if let Some(tag) = self.of_timer(timer, "age", Scalar::Time) {
            let age = world.shared(&tag);
            world.valid.push(!age.sign());
            return self.begin_age(world, timer, age);
        }
        let count = (64 - most.max(1).leading_zeros()) as usize;
        // It counts only once the timer has begun: what it is before does not matter, and 1 is what it mostly is.
        let (leaves, numbers) = world.remember_cell(Kept::Age(timer.0), count, 1);
        world.ages.push(numbers.clone());
        world.timers.push(timer.0);
        self.remembered
            .push(Remembered::Age(timer.0, numbers, most.max(1)));
        self.begin_age(world, timer, Number::unsigned(leaves))
    }

    fn begin_age(&mut self, world: &mut World, timer: Bit, mut age: Number) -> Number {
        let len = age.len() - 1;
        for (act, bits) in self.open_ages.remove(&timer.0).unwrap_or_default() {
            let open = Number::unsigned(bits[..len.min(bits.len())].to_vec());
            age = world.graph.choose_number(act, &open, &age);
        }
        self.ages.insert(timer.0, age.clone());
        age
    }

    /// Where this holds, an age is what the lowest of these bits say.
    pub(crate) fn open_age(&mut self, world: &mut World, timer: Bit, open: (Lit, Vec<Lit>)) {
        self.open_ages.entry(timer.0).or_default().push(open);
        if let Some(age) = self.known_age(timer) {
            self.begin_age(world, timer, age);
        }
    }

    /// The bytes that a text holds at the start.
    pub(super) fn first_text(&self, at: u32) -> &[u8] {
        self.initial.text(TextSlot(at))
    }

    /// What stands for something that a timer remembers where its network is followed alone.
    fn of_timer(&self, timer: Bit, what: &str, ty: Scalar) -> Option<InputTag> {
        let name = self.cells?.alone.as_ref()?.get(&timer.0)?;
        Some(InputTag {
            name: format!("{name} {what}"),
            ty,
        })
    }

    /// Of a network that was followed alone what it leaves: each value that has a name.
    pub(crate) fn left(&self) -> Vec<(InputTag, Number)> {
        let Some(cells) = self.cells else {
            return Vec::new();
        };
        let mut left = Vec::new();
        for (at, value) in &self.bits {
            let tag = cells.inputs_at_bits.get(at);
            left.extend(tag.map(|tag| (tag.clone(), Number::of_bit(*value))));
        }
        for (at, value) in &self.words {
            let tag = cells.inputs_at_words.get(at);
            left.extend(tag.map(|tag| (tag.clone(), value.clone())));
        }
        for (at, value) in &self.phases {
            let tag = self.of_timer(Bit(*at), "phase", Scalar::Usint);
            left.extend(tag.map(|tag| (tag, Number::unsigned(value.clone()))));
        }
        for (at, value) in &self.ages {
            let tag = self.of_timer(Bit(*at), "age", Scalar::Time);
            left.extend(tag.map(|tag| (tag, value.clone())));
        }
        left
    }

    pub(crate) fn set_age(&mut self, timer: Bit, age: Number) {
        self.ages.insert(timer.0, age);
    }

    /// Whether a bit is written by one block alone, which reads it later.
    pub(crate) fn is_temporary_bit(&self, bit: Bit) -> bool {
        self.cells
            .is_some_and(|cells| cells.temporary_bits.contains(&bit.0))
    }

    /// The same of a word.
    pub(crate) fn is_temporary_word(&self, word: Word) -> bool {
        self.cells
            .is_some_and(|cells| cells.temporary_words.contains(&word.0))
    }

    /// What is remembered so far, with the numbers of its bits among the states.
    pub(crate) fn kept(&self) -> impl Iterator<Item = (Kept, Vec<usize>)> + '_ {
        self.remembered.iter().map(|remembered| match remembered {
            Remembered::Bit(at, number) => (Kept::Bit(*at), vec![*number]),
            Remembered::Word(at, numbers) => (Kept::Word(*at), numbers.clone()),
            Remembered::Phase(timer, numbers) => (Kept::Phase(*timer), numbers.clone()),
            Remembered::Age(timer, numbers, _) => (Kept::Age(*timer), numbers.clone()),
        })
    }

    /// The scan is over: what is remembered is what cells hold now.
    pub(crate) fn finish(&mut self, world: &mut World) {
        for remembered in std::mem::take(&mut self.remembered) {
            match remembered {
                Remembered::Bit(at, number) => world.states[number].next = self.bits[&at],
                Remembered::Word(at, numbers) => next(world, &numbers, &self.words[&at]),
                Remembered::Phase(timer, numbers) => {
                    for (number, bit) in numbers.iter().zip(&self.phases[&timer]) {
                        world.states[*number].next = *bit;
                    }
                }
                Remembered::Age(timer, numbers, most) => {
                    let age = &self.ages[&timer];
                    let more = world.graph.add(age, &Number::constant(1));
                    let is_less = world.graph.less(age, &Number::constant(most as i64));
                    let age = world.graph.choose_number(is_less, &more, age);
                    next(world, &numbers, &age);
                }
            }
        }
    }
}

fn next(world: &mut World, numbers: &[usize], value: &Number) {
    for (n, number) in numbers.iter().enumerate() {
        world.states[*number].next = value.bit(n);
    }
}
