//! The order in which a generator runs a drawing: what writes, jumps or has a state has its turn by its place, and a function runs
//! with the first of these that takes what it computes.

use crate::graph::{Graph, Kind};

impl Graph {
    /// Whether an element has a turn of its own, by its place or its number.
    fn has_turn(&self, node: usize) -> bool {
        match &self.nodes[node].kind {
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) => true,
            Kind::Block { instance, code, .. } => {
                instance.is_some() || code.is_some() || self.nodes[node].order.is_some()
            }
            _ => false,
        }
    }

    fn is_function(&self, node: usize) -> bool {
        matches!(self.nodes[node].kind, Kind::Block { .. }) && !self.has_turn(node)
    }

    /// Whether each element has a turn by its place: functions that nothing asks for have one, too.
    pub(crate) fn turns(&self) -> Vec<bool> {
        let mut is_asked = vec![false; self.nodes.len()];
        let nodes = 0..self.nodes.len();
        let mut waiting: Vec<usize> = nodes.clone().filter(|node| self.has_turn(*node)).collect();
        while let Some(node) = waiting.pop() {
            if !std::mem::replace(&mut is_asked[node], true) {
                let ends = self.nodes[node].inputs.iter().flat_map(|pin| &pin.from);
                waiting.extend(ends.map(|end| end.node));
            }
        }
        nodes
            .map(|node| self.has_turn(node) || (self.is_function(node) && !is_asked[node]))
            .collect()
    }

    /// All elements in the order of execution.
    pub(crate) fn in_order(&self) -> Vec<usize> {
        let has_turn = self.turns();
        let mut order = Vec::with_capacity(self.nodes.len());
        let mut is_met = vec![false; self.nodes.len()];
        for node in self.by_place() {
            if has_turn[node] {
                self.functions_before(node, &mut is_met, &mut order);
            }
            if !self.is_function(node) {
                order.push(node);
            }
        }
        order
    }

    /// The functions that feed an element and did not run yet, each after those that feed it; and itself, if it is one.
    fn functions_before(&self, root: usize, is_met: &mut [bool], order: &mut Vec<usize>) {
        let mut waiting = vec![(root, false)];
        while let Some((node, is_left)) = waiting.pop() {
            if is_left {
                order.push(node);
                continue;
            }
            if std::mem::replace(&mut is_met[node], true) {
                continue;
            }
            if self.is_function(node) {
                waiting.push((node, true));
            }
            let ends = self.nodes[node].inputs.iter().flat_map(|pin| &pin.from);
            let ends = ends.filter(|end| !self.feedback.contains(&(node, **end)));
            let before: Vec<usize> = ends.map(|end| end.node).collect();
            waiting.extend(before.into_iter().rev().map(|node| (node, false)));
        }
    }
}
