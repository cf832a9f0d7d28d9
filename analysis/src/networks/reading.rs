//! What is at hand while networks are read, one after the other.

use crate::networks::named::Named;
use crate::networks::order_table::OrderTable;
use ladder_syntax::rowan::GreenNode;
use ladder_syntax::wiring::{Wiring, wiring_of};
use ladder_syntax::{LineKind, Network, Parse, Trees};
use std::ops::Range;

/// So many networks, or lines of declarations, are taken through one step after the other together: what they need fits into
/// the processor's nearest cache, where the code of all steps does not.
pub(crate) const TOGETHER: usize = 16;

/// Makes the trees of rungs as they are read, and keeps those of a few networks.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    pub(crate) orders: OrderTable,
    /// Room for the tags that a network names.
    pub(crate) named: Vec<Named>,
    trees: Trees,
    /// The trees of some rungs, from top to bottom.
    made: Vec<GreenNode>,
    /// On which lines they are.
    lines: Vec<usize>,
    /// Those of the network whose wiring was read last.
    read: Range<usize>,
}

impl Reading {
    /// Networks that are to be read next, from top to bottom.
    pub(crate) fn look_ahead(&mut self, parse: &Parse, networks: &[Network]) {
        self.made.clear();
        self.lines.clear();
        self.read = 0..0;
        for network in networks {
            let lines = parse.lines().range(network.lines.clone());
            let numbered = network.lines.clone().zip(lines);
            for (number, line) in numbered.filter(|(_, line)| line.kind == LineKind::Rung) {
                self.lines.push(number);
                self.made.push(self.trees.of(line));
            }
        }
    }

    /// The wiring of a network, whose rungs are at hand from now on.
    pub(crate) fn wiring(&mut self, parse: &Parse, network: &Network) -> Wiring {
        let next = self.read.end;
        if self.lines.get(next) != Some(&network.lines.start) {
            self.look_ahead(parse, std::slice::from_ref(network));
        }
        let next = self.read.end;
        let of_network = self.lines[next..].iter();
        let count = of_network.take_while(|line| network.lines.contains(line)).count();
        self.read = next..next + count;
        wiring_of(parse, network, self.rungs())
    }

    /// The rungs of the network whose wiring was read last.
    pub(crate) fn rungs(&self) -> &[GreenNode] {
        &self.made[self.read.clone()]
    }
}
