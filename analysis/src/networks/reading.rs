//! What is at hand while networks are read, one after the other.

use crate::order_table::OrderTable;
use ladder_syntax::rowan::GreenNode;
use ladder_syntax::wiring::{Wiring, wiring_of};
use ladder_syntax::{Network, Parse, Trees};

/// Makes the trees of rungs as they are read, and keeps those of one network.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    pub(crate) orders: OrderTable,
    trees: Trees,
    rungs: Vec<GreenNode>,
}

impl Reading {
    /// The wiring of a network, whose rungs are at hand from now on.
    pub(crate) fn wiring(&mut self, parse: &Parse, network: &Network) -> Wiring {
        self.rungs.clear();
        for line in network.rungs(parse.lines()) {
            self.rungs.push(self.trees.of(&parse.lines()[line]));
        }
        wiring_of(parse, network, &self.rungs)
    }

    /// The rungs of the network whose wiring was read last.
    pub(crate) fn rungs(&self) -> &[GreenNode] {
        &self.rungs
    }
}
