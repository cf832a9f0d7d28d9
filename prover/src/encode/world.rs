//! What the functions of a scan are over: its graph, what goes in, what is remembered, and what was left open.

use super::cells::InputTag;
use super::memory::Kept;
use crate::graph::{Graph, Lit};
use crate::limits::End;
use crate::number::Number;
use ladder_analysis::program::Location;
use ladder_analysis::values::types::Scalar;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::VecDeque;

/// What goes into the program.
#[derive(Debug, Clone)]
pub(crate) struct Input {
    pub(crate) tag: InputTag,
    /// Its bits, from the lowest on; of a real those of the 64-bit number that a word holds.
    pub(crate) bits: Vec<Lit>,
}

/// A bit that is remembered from scan to scan.
#[derive(Debug, Clone, Copy)]
pub(crate) struct State {
    pub(crate) leaf: Lit,
    pub(crate) initial: bool,
    pub(crate) next: Lit,
}

/// What was left open, in words, and the block that it is about.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Gap {
    pub(crate) what: String,
    pub(crate) location: Option<Location>,
}

/// A function that is not followed, with what it is of.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Applied {
    pub(crate) function: String,
    pub(crate) of: Vec<Lit>,
}

impl Applied {
    pub(crate) fn new(function: String, of: &[&Number]) -> Applied {
        let of = of.iter().flat_map(|number| number.low(64)).collect();
        Applied { function, of }
    }
}

/// See the module.
#[derive(Debug, Default)]
pub(crate) struct World {
    pub(crate) graph: Graph,
    pub(crate) inputs: Vec<Input>,
    pub(crate) states: Vec<State>,
    /// Leaves that stand for what was left open: by their nodes the gap.
    pub(crate) open: FxHashMap<usize, usize>,
    pub(crate) gaps: Vec<Gap>,
    /// What was left open and depends on some bits alone, by these.
    pub(crate) applied: FxHashMap<Applied, Vec<Lit>>,
    /// Those of them that stand for what unread parts write: the simulator does not have these values.
    pub(crate) unread: FxHashSet<usize>,
    /// Another program is followed after this one: what unread parts get and write is kept.
    pub(crate) compares: bool,
    /// Each unread part that was met, by its text and how often it was met before.
    pub(crate) ran: FxHashMap<(String, u32), Ran>,
    /// Pairs of states of which the first is always high, and the second as long as something has always been so.
    pub(crate) always: Vec<(usize, usize)>,
    /// Leaves that are in the place of times.
    pub(crate) times: Vec<Lit>,
    /// The words that are remembered, by their bits among the states.
    pub(crate) numbers: Vec<Vec<usize>>,
    /// The counters: the first word of each, a bit of what it counts, and what it counts to where that is known.
    pub(crate) counts: Vec<(u32, Lit, Option<i64>)>,
    /// The numbers that say how long a property waits, by their bits among the states.
    pub(crate) waits: Vec<Vec<usize>>,
    /// The ages of timers likewise.
    pub(crate) ages: Vec<Vec<usize>>,
    /// Whose ages these are: the first bits of the timers.
    pub(crate) timers: Vec<u32>,
    /// What inputs cannot be is excluded: all are high in each scan.
    pub(crate) valid: Vec<Lit>,
    /// Why nothing can be expressed of the program at all.
    pub(crate) blocked: Option<Gap>,
    /// Of each timer the largest preset in scans that it was given, by its first bit; none where that is not known.
    pub(crate) presets: FxHashMap<u32, Option<u64>>,
    /// How many scans ago the run began.
    pub(crate) clock: Option<Number>,
    /// What goes in by its name: of two programs or networks that are compared the same for both.
    pub(crate) shared: FxHashMap<(String, Scalar), Number>,
    /// What words that are remembered can hold before any scan, by their first: the least and the greatest value.
    pub(crate) ranges: FxHashMap<u32, (i128, i128)>,
    /// Numbers that the program holds at the start: those that values are compared with are among them.
    pub(crate) constants: Vec<i64>,
    /// What the program that is followed may share with another one.
    pub(crate) twins: Twins,
    /// When nothing more may be followed.
    pub(crate) end: End,
}

/// What an unread part got and wrote in a scan.
#[derive(Debug)]
pub(crate) struct Ran {
    /// It was reached.
    pub(crate) act: Lit,
    /// All that it may read, by name; none if something of it is not tracked.
    pub(crate) reads: Option<Vec<(String, Read)>>,
    /// The bits of each cell that it may write, by the name of the tag and which cell of it.
    pub(crate) written: FxHashMap<(String, u32), Vec<Lit>>,
}

/// A value that an unread part may read.
#[derive(Debug)]
pub(crate) enum Read {
    Number(Number),
    Text(Vec<u8>),
}

/// Of a program that is followed after another one: what of it is remembered in the same variables as there.
#[derive(Debug, Default)]
pub(crate) struct Twins {
    /// The leaves of what is remembered first, in this order; none for one of its own.
    pub(crate) first: VecDeque<Option<Lit>>,
    /// The names there of what goes in, by its names here.
    pub(crate) names: FxHashMap<String, String>,
    /// Of the bits of a cell the leaf, and what that begins with; none for a bit of its own.
    pub(crate) cells: FxHashMap<Kept, Vec<Option<(Lit, bool)>>>,
}

impl World {
    /// An empty one, for what is followed until then.
    pub(crate) fn until(end: &End) -> World {
        World {
            end: end.clone(),
            ..World::default()
        }
    }

    /// Bits that may be anything, since what they would be is not followed.
    pub(crate) fn open_bits(&mut self, gap: Gap, count: usize) -> Vec<Lit> {
        let number = self.gap(gap);
        let bits: Vec<Lit> = (0..count).map(|_| self.graph.leaf()).collect();
        self.open.extend(bits.iter().map(|bit| (bit.node(), number)));
        bits
    }

    fn gap(&mut self, gap: Gap) -> usize {
        let known = self.gaps.iter().rposition(|known| *known == gap);
        known.unwrap_or_else(|| {
            self.gaps.push(gap);
            self.gaps.len() - 1
        })
    }

    /// The same, of what depends on these bits and nothing else: asked for again, it is the same as before.
    pub(crate) fn open_bits_of(&mut self, gap: Gap, applied: Applied, count: usize) -> Vec<Lit> {
        if let Some(bits) = self.applied.get(&applied) {
            return bits.clone();
        }
        let bits = self.open_bits(gap, count);
        self.applied.insert(applied, bits.clone());
        bits
    }

    /// Any value of a type, likewise.
    pub(crate) fn open_any(&mut self, gap: Gap, ty: Scalar) -> Number {
        let (value, bits) = self.any(ty);
        let gap = self.gap(gap);
        let open = bits.iter().filter(|bit| bit.known().is_none());
        self.open.extend(open.map(|bit| (bit.node(), gap)));
        value
    }

    /// High where something holds now and did in all scans before.
    pub(crate) fn and_always_before(&mut self, now: Lit) -> Lit {
        let [high, before] = [(); 2].map(|()| {
            let leaf = self.graph.leaf();
            self.remember_as(leaf, true).0
        });
        let always = self.graph.and(before, now);
        let number = self.states.len() - 1;
        self.states[number].next = always;
        self.valid.push(high);
        self.always.push((number - 1, number));
        always
    }

    /// Nothing can be expressed of the program.
    pub(crate) fn block(&mut self, what: impl Into<String>, location: Option<Location>) {
        self.blocked.get_or_insert(Gap {
            what: what.into(),
            location,
        });
    }

    /// A bit that is remembered; what it is next is set later. Returns its leaf and its number.
    pub(crate) fn remember(&mut self, initial: bool) -> (Lit, usize) {
        let twin = self.twins.first.pop_front().flatten();
        let leaf = twin.unwrap_or_else(|| self.graph.leaf());
        self.remember_as(leaf, initial)
    }

    fn remember_as(&mut self, leaf: Lit, initial: bool) -> (Lit, usize) {
        self.states.push(State {
            leaf,
            initial,
            next: leaf,
        });
        (leaf, self.states.len() - 1)
    }

    /// The bits of a cell that is remembered: their leaves and numbers.
    pub(crate) fn remember_cell(&mut self, cell: Kept, count: usize, initial: i64) -> (Vec<Lit>, Vec<usize>) {
        let twins = self.twins.cells.remove(&cell).unwrap_or_default();
        (0..count)
            .map(|bit| {
                let initial = initial >> bit & 1 != 0;
                let twin = twins.get(bit).copied().flatten();
                let leaf = match twin.filter(|(_, begins)| *begins == initial) {
                    Some((leaf, _)) => leaf,
                    None => self.graph.leaf(),
                };
                self.remember_as(leaf, initial)
            })
            .unzip()
    }

    /// States have other numbers, or none any more: ages and words of which one is gone are no longer known as such.
    pub(crate) fn renumber(&mut self, numbers: &[Option<usize>]) {
        let left = |bits: &Vec<usize>| {
            bits.iter()
                .map(|number| numbers[*number])
                .collect::<Option<Vec<usize>>>()
        };
        let ages = self.ages.iter().zip(&self.timers);
        (self.ages, self.timers) = ages
            .filter_map(|(bits, timer)| Some((left(bits)?, *timer)))
            .unzip();
        self.numbers = self.numbers.iter().filter_map(left).collect();
    }

    /// A value that goes in by its name.
    pub(crate) fn shared(&mut self, tag: &InputTag) -> Number {
        let name = tag.name.to_ascii_lowercase();
        let key = (self.twins.names.get(&name).cloned().unwrap_or(name), tag.ty);
        if let Some(known) = self.shared.get(&key) {
            return known.clone();
        }
        let value = self.input(tag);
        self.shared.insert(key, value.clone());
        value
    }

    fn input(&mut self, tag: &InputTag) -> Number {
        let (number, bits) = self.any(tag.ty);
        self.inputs.push(Input {
            tag: tag.clone(),
            bits,
        });
        number
    }

    /// Any value of a type, and its bits.
    fn any(&mut self, ty: Scalar) -> (Number, Vec<Lit>) {
        match ty {
            Scalar::Bool => {
                let bit = self.graph.leaf();
                (Number::of_bit(bit), vec![bit])
            }
            Scalar::Real | Scalar::Lreal => self.any_real(ty == Scalar::Real),
            Scalar::Enum(id) => {
                let bits: Vec<Lit> = (0..32).map(|_| self.graph.leaf()).collect();
                let number = Number::of_bits(bits.clone());
                let values = &id.get().values;
                let is_one: Vec<Lit> = (values.iter())
                    .map(|(_, value)| {
                        let value = Number::constant(i64::from(*value));
                        self.graph.equal(&number, &value)
                    })
                    .collect();
                let is_valid = self.graph.any(is_one);
                self.valid.push(is_valid);
                (number, bits)
            }
            ty => {
                let width = ladder_simulator::compiled::Width::of(ty);
                let bits: Vec<Lit> = (0..width.bits()).map(|_| self.graph.leaf()).collect();
                (Number::of_bits(bits.clone()).wrapped(width), bits)
            }
        }
    }

    /// A finite real: of 32 bits 0 and what is not too small or too large, which are the same bits in a word.
    fn any_real(&mut self, single: bool) -> (Number, Vec<Lit>) {
        let mut bits: Vec<Lit> = (0..64).map(|_| self.graph.leaf()).collect();
        let exponent = Number::unsigned(bits[52..63].to_vec());
        let (least, most) = if single { (897, 1150) } else { (1, 2046) };
        let too_small = self.graph.less(&exponent, &Number::constant(least));
        let too_large = self.graph.less(&Number::constant(most), &exponent);
        if single {
            bits[..29].fill(Lit::FALSE);
        }
        let something = self.graph.any(bits[..63].to_vec());
        let small_is_zero = self.graph.and(too_small, something);
        self.valid.extend([!small_is_zero, !too_large]);
        (Number::of_bits(bits.clone()), bits)
    }
}
