//! Sixty-four runs at once, with inputs that are held for a while: a bit of each number is one run.
//!
//! They find what is many scans away, where the solver would need each scan; and they show what never happened, of which some
//! never happens.

use crate::decide::{Run, reach};
use crate::graph::{Lit, Node};
use crate::model::Model;

/// The runs, while they go on.
pub(crate) struct Lanes<'m> {
    model: &'m Model,
    /// The nodes that are computed, in their order.
    nodes: Vec<usize>,
    values: Vec<u64>,
    states: Vec<u64>,
    /// Runs in which all that is assumed has held.
    pub(crate) alive: u64,
    /// What went in, in each scan.
    given: Vec<Vec<u64>>,
    dice: u64,
    /// Scans for which inputs are held, by and large, one after the other.
    holds: Vec<u64>,
    /// Of each input the runs in which it is mostly high, and those in which it is mostly low.
    biased: Vec<[u64; 2]>,
}

impl<'m> Lanes<'m> {
    /// Runs from the cold start, in which these matter.
    pub(crate) fn new(model: &'m Model, targets: &[Lit], seed: u64, hold: u64) -> Lanes<'m> {
        let reached = reach(model, targets.iter().chain(&model.assumed).copied());
        let mut nodes: Vec<usize> = reached.into_iter().collect();
        nodes.sort_unstable();
        let mut lanes = Lanes {
            model,
            nodes,
            values: vec![0; model.world.graph.len()],
            states: (model.world.states.iter())
                .map(|state| if state.initial { u64::MAX } else { 0 })
                .collect(),
            alive: u64::MAX,
            given: Vec::new(),
            dice: seed | 1,
            holds: Vec::new(),
            biased: Vec::new(),
        };
        for _ in &model.world.inputs {
            // Some change seldom and some often, or nothing takes long while something else goes on.
            let held = [hold, 16 * hold, 4 * hold, (hold / 4).max(1)][(lanes.any() >> 60) as usize % 4];
            lanes.holds.push(held);
            let [one, two] = [lanes.any(), lanes.any()];
            lanes.biased.push([one & two, one & !two]);
        }
        lanes
    }

    /// About how many steps a scan is.
    pub(crate) fn steps(&self) -> usize {
        let inputs = self.model.world.inputs.iter();
        let bits = inputs.map(|input| input.bits.len()).sum::<usize>();
        1 + self.nodes.len() + self.model.world.states.len() + 8 * bits
    }

    /// Some number: xorshift, the same on every machine.
    fn any(&mut self) -> u64 {
        self.dice ^= self.dice << 13;
        self.dice ^= self.dice >> 7;
        self.dice ^= self.dice << 17;
        self.dice.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// Bits of which each is high once in a while.
    fn seldom(&mut self, hold: u64) -> u64 {
        let mut bits = u64::MAX;
        let mut rest = hold;
        while rest > 1 {
            bits &= self.any();
            rest /= 2;
        }
        bits
    }

    /// One scan.
    pub(crate) fn scan(&mut self) {
        let count = self.model.world.inputs.iter().map(|input| input.bits.len()).sum();
        let mut given = Vec::with_capacity(count);
        let before = self.given.last().cloned();
        let numbers = self.model.world.constants.len();
        for (n, input) in self.model.world.inputs.iter().enumerate() {
            // All bits of an input change together.
            let changes = match before {
                None => u64::MAX,
                Some(_) => self.seldom(self.holds[n]),
            };
            let is_small = self.any();
            let first = given.len();
            for bit in 0..input.bits.len() {
                let mut value = self.any();
                if bit >= 4 {
                    value &= !is_small;
                }
                if let [_] = input.bits[..] {
                    let [high, low] = self.biased[n];
                    let seldom = self.any() & self.any();
                    value = value & (!low | seldom) | high & self.any();
                }
                let old = before.as_ref().map_or(0, |before| before[given.len()]);
                given.push(old & !changes | value & changes);
            }
            if input.bits.len() == 1 || numbers == 0 {
                continue;
            }
            // What a number is compared with is worth a try.
            let mut lanes = changes & self.any();
            while lanes != 0 {
                let lane = lanes.trailing_zeros();
                lanes &= lanes - 1;
                let dice = self.any();
                let number = self.model.world.constants[(dice % numbers as u64) as usize];
                let number = number.wrapping_add([0, 1, -1, 0][(dice >> 40 & 3) as usize]);
                for (bit, value) in given[first..].iter_mut().enumerate() {
                    let high = (number >> bit.min(63) & 1) as u64;
                    *value = *value & !(1 << lane) | high << lane;
                }
            }
        }
        let bits = self.model.world.inputs.iter().flat_map(|input| &input.bits);
        for (bit, value) in bits.zip(&given) {
            if bit.known().is_none() {
                self.values[bit.node()] = *value;
            }
        }
        self.given.push(given);
        for node in 0..self.model.world.times.len() {
            let value = self.any();
            self.values[self.model.world.times[node].node()] = value;
        }
        let open: Vec<usize> = self.model.world.open.keys().copied().collect();
        for node in open {
            self.values[node] = self.any();
        }
        for (state, value) in self.model.world.states.iter().zip(&self.states) {
            self.values[state.leaf.node()] = *value;
        }
        for &node in &self.nodes {
            if let Node::And(a, b) = self.model.world.graph.node(node) {
                self.values[node] = self.value(a) & self.value(b);
            }
        }
        for assumed in &self.model.assumed {
            self.alive &= self.value(*assumed);
        }
        let next = self.model.world.states.iter().map(|state| self.value(state.next));
        self.states = next.collect();
    }

    /// What a literal is in this scan, in each run.
    pub(crate) fn value(&self, lit: Lit) -> u64 {
        let value = self.values[lit.node()];
        if lit.is_negated() { !value } else { value }
    }

    /// Those inputs of one of the runs that matter.
    pub(crate) fn run(&self, lane: u32, matter: &[bool]) -> Run {
        let mut at = 0;
        let mut inputs = Vec::new();
        for (input, matters) in self.model.world.inputs.iter().zip(matter) {
            let bits = at..at + input.bits.len();
            at = bits.end;
            let scans = self.given.iter().filter(|_| *matters);
            let scans = scans.map(|given| {
                let bits = given[bits.clone()].iter().zip(&input.bits);
                bits.map(|(value, bit)| bit.known().unwrap_or(value >> lane & 1 != 0))
                    .collect()
            });
            inputs.push(scans.collect());
        }
        Run {
            scans: self.given.len(),
            inputs,
        }
    }
}
