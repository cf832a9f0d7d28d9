//! Coils on tags for what goes on from a network to others.

use super::{Pencil, RAIL};
use crate::graph::End;
use crate::sketch::blocks::{Class, power_output};
use crate::standard::StandardBlock;
use ladder_format::program::{Block, Path};

impl Pencil<'_, '_> {
    /// What decides whether a text runs: without power a jump goes past it. Comes back with the power that goes on.
    pub(super) fn text(&mut self, node: usize, point: usize) -> usize {
        let Some(past) = self.body.past(node).map(str::to_owned) else {
            return point;
        };
        let output = power_output(self.body, node).unwrap_or(0);
        let end = End { node, output };
        let is_used = self.body.facts.uses.contains_key(&end);
        let feeds_back = self.body.graph.feedback.iter().any(|(_, other)| *other == end);
        if point == RAIL && !feeds_back {
            self.held.push((end, Path::system("ON")));
            return point;
        }
        let mut point = point;
        if is_used {
            let tag = self.body.holder(end);
            point = self.series(point, [Block::coil(&tag)], node);
            self.held.push((end, tag));
        }
        if point != RAIL {
            self.series(point, [Block::inverter(), Block::jump(&past)], node);
            self.body.state.jumped.insert(node);
        }
        point
    }

    /// A coil on a tag for the power after a block, where nothing has it already.
    pub(super) fn hold(&mut self, end: End) {
        let has_tag = match self.body.class(end.node) {
            Some(Class::Standard(StandardBlock::Stateful(..))) => true,
            _ => self.body.tags.results.contains_key(&end),
        };
        if has_tag || self.body.is_refused(end.node) || self.held.iter().any(|(held, _)| *held == end) {
            return;
        }
        let tag = self.body.holder(end);
        self.series(self.after[&end.node], [Block::coil(&tag)], end.node);
        self.held.push((end, tag));
    }

    /// Coils on tags for power that leaves blocks of this network and goes on in others.
    pub(super) fn hold_what_goes_on(&mut self) {
        for node in self.executed.clone() {
            if let Some(output) = power_output(self.body, node) {
                let end = End { node, output };
                let mut guards = self.body.tags.guards.iter();
                let is_guard = guards.any(|(user, guard)| *guard == end && !self.done.contains(user));
                let mut put = self.put.iter();
                let goes_to_other_pin = put.any(|(user, pin)| self.body.feeds_another(node, *user, *pin));
                if is_guard || goes_to_other_pin || self.body.goes_on_from(end, &self.done) {
                    self.hold(end);
                }
            }
        }
    }

    /// The same of what conditions decided that are asked for again.
    pub(super) fn hold_what_was_decided(&mut self) {
        let mut conditions: Vec<usize> = self.shown.iter().copied().collect();
        conditions.retain(|node| self.body.class(*node).is_some_and(|class| !class.acts()));
        conditions.sort_unstable();
        for node in conditions {
            let output = power_output(self.body, node).unwrap_or(0);
            let end = End { node, output };
            let Some(point) = self.ends.get(&(end, RAIL)).copied() else {
                continue;
            };
            let has_tag = self.held.iter().any(|(held, _)| *held == end);
            if !has_tag && self.body.is_asked_again(end, &self.done) {
                let tag = self.body.helper("decided", "BOOL", "what a condition decided");
                self.series(point, [Block::coil(&tag)], node);
                self.held.push((end, tag));
            }
        }
    }
}
