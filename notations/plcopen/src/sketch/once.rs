//! Whether a text can be networks of its own in a drawing of which each network is read once: what is read before it and again after
//! it must be the same.

use crate::expression::{Meaning, operand, reads};
use crate::graph::{Graph, Kind};
use std::collections::{HashMap, HashSet};

/// All boxes of a drawing together pass through no more elements.
const MOST_WORK: usize = 1_000_000;

/// A drawing, as far as it matters for its boxes.
pub(super) struct Once<'g> {
    graph: &'g Graph,
    meaning: Meaning<'g>,
    /// What takes what leaves an element.
    users: HashMap<usize, Vec<usize>>,
    work: usize,
}

impl<'g> Once<'g> {
    pub(super) fn of(graph: &'g Graph, meaning: Meaning<'g>) -> Once<'g> {
        let mut users: HashMap<usize, Vec<usize>> = HashMap::new();
        for (number, node) in graph.nodes.iter().enumerate() {
            for end in node.inputs.iter().flat_map(|pin| &pin.from) {
                users.entry(end.node).or_default().push(number);
            }
        }
        Once {
            graph,
            meaning,
            users,
            work: 0,
        }
    }

    /// Whether the order of all that is read and written stays, where a text that writes these tags is apart from its network. `written`
    /// is what another text writes.
    ///
    /// # Errors
    ///
    /// Why not.
    pub(super) fn keeps<'w>(
        &mut self,
        text: usize,
        writes: &HashSet<String>,
        written: impl Fn(usize) -> Option<&'w HashSet<String>>,
    ) -> Result<(), String> {
        let after = self.reached([text], Once::users, None)?;
        let before = self.reached([text], Once::sources, None)?;
        let both = |once: &Self, node| once.users(node).into_iter().chain(once.sources(node)).collect();
        let network = self.reached([text], both, None)?;
        let is_aside = |node: &&usize| !after.contains(*node) && **node != text;
        let others: Vec<usize> = network.iter().copied().filter(|node| self.acts(*node)).collect();
        let elsewhere = others.iter().copied();
        let elsewhere: Vec<usize> = elsewhere
            .filter(|node| *node != text && !before.contains(node))
            .collect();
        let fed = self.reached(elsewhere, Once::sources, Some(text))?;
        let mut again = fed.iter().filter(is_aside);
        if again.any(|node| self.reads(*node).iter().any(|tag| writes.contains(tag))) {
            return Err("what it writes is read in its network by what is not after it".to_owned());
        }
        let is_coil = |node: usize| !matches!(self.graph.nodes[node].kind, Kind::Block { .. });
        let mut all = HashSet::new();
        for node in others.iter().filter(is_aside) {
            if !before.contains(node) || is_coil(*node) {
                match written(*node) {
                    Some(writes) => all.extend(writes.iter().cloned()),
                    None => all.extend(self.writes(*node)),
                }
            }
        }
        let mut conditions = before.iter();
        if conditions.any(|node| self.reads(*node).iter().any(|tag| all.contains(tag))) {
            return Err("what its network writes is read on the way to it".to_owned());
        }
        Ok(())
    }

    /// All elements that a way leads to from some, with them; none leads through a rail, or this one.
    fn reached(
        &mut self,
        from: impl IntoIterator<Item = usize>,
        way: impl Fn(&Self, usize) -> Vec<usize>,
        but: Option<usize>,
    ) -> Result<HashSet<usize>, String> {
        let mut met = HashSet::new();
        let mut waiting: Vec<usize> = from.into_iter().collect();
        while let Some(node) = waiting.pop() {
            let is_rail = matches!(self.graph.nodes[node].kind, Kind::LeftRail | Kind::RightRail);
            if is_rail || Some(node) == but || !met.insert(node) {
                continue;
            }
            let next = way(self, node);
            self.work += 1 + next.len();
            if self.work > MOST_WORK {
                return Err("the drawing is larger than what can be read".to_owned());
            }
            waiting.extend(next);
        }
        Ok(met)
    }

    fn users(&self, node: usize) -> Vec<usize> {
        self.users.get(&node).cloned().unwrap_or_default()
    }

    fn sources(&self, node: usize) -> Vec<usize> {
        let pins = self.graph.nodes[node].inputs.iter();
        pins.flat_map(|pin| &pin.from).map(|end| end.node).collect()
    }

    /// Whether an element may do something.
    fn acts(&self, node: usize) -> bool {
        matches!(
            self.graph.nodes[node].kind,
            Kind::Coil(..) | Kind::Variable(..) | Kind::Jump(..) | Kind::Return(_) | Kind::Block { .. }
        )
    }

    fn reads(&self, node: usize) -> Vec<String> {
        match &self.graph.nodes[node].kind {
            Kind::Contact(text, _) | Kind::Value(text, _) => self.tags(text),
            _ => Vec::new(),
        }
    }

    fn writes(&self, node: usize) -> Vec<String> {
        match &self.graph.nodes[node].kind {
            Kind::Coil(text, ..) | Kind::Variable(text, _) => self.tags(text),
            Kind::Block {
                instance: Some(name), ..
            } => self.tags(name),
            _ => Vec::new(),
        }
    }

    fn tags(&self, text: &str) -> Vec<String> {
        let operand = operand(text, self.meaning);
        operand.map_or_else(|_| Vec::new(), |operand| reads(&operand.value))
    }
}
