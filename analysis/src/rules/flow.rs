//! The ways that a scan can take from network to network, shared by the rules about what is never reached, never
//! left, or always ended.

use super::survey::Survey;
use crate::boolean::power::{NetworkPower, Question};
use crate::findings::diagnostic::Diagnostic;
use crate::names::context::{Body, Context};
use crate::networks::BlockAt;
use crate::networks::control_flow::ControlFlow;
use crate::program::{LoopEnds, Step, loops};
use ladder_instructions::Op;
use ladder_syntax::Name;
use smallvec::SmallVec;
use std::collections::BTreeMap;

/// A rule about the ways through a body.
pub(super) type FlowCheck = fn(&Flow<'_>, &mut Vec<Diagnostic>);

/// A block that leaves its network.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exit {
    /// The network, by its place in the body.
    pub(super) from: usize,
    pub(super) block: usize,
    /// Its step in the network.
    pub(super) step: usize,
    /// For a jump the network that it goes to, by its place in the body. The others end the body.
    pub(super) to: Option<usize>,
    /// Power always comes to it.
    pub(super) always: bool,
}

/// Some networks of a body. From most a scan goes on to one or two.
type Places = SmallVec<[usize; 2]>;

/// A body's networks and the ways between them.
pub(super) struct Flow<'c> {
    pub(super) context: &'c Context,
    pub(super) survey: &'c Survey<'c>,
    /// The body's networks from top to bottom.
    pub(super) networks: Vec<usize>,
    /// The blocks that leave, in the order of the networks and of evaluation; what is after one that always
    /// leaves is not among them.
    pub(super) exits: Vec<Exit>,
    /// For each network where a scan can go on; last of all the labels, for what may go to any of them.
    next: Vec<Places>,
    /// For each network whether the body can end there.
    ends: Vec<bool>,
}

/// Asks the rules about the bodies that hold jumps, returns or ends.
pub(super) fn check(survey: &Survey<'_>, checks: &[FlowCheck], out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    let leaves = ControlFlow::LEAVES;
    if !survey.whole || !survey.any.has(leaves) {
        return;
    }
    let mut networks_of: BTreeMap<Body, Vec<usize>> = BTreeMap::new();
    for (network, body) in context.bodies.iter().enumerate() {
        networks_of.entry(*body).or_default().push(network);
    }
    networks_of.retain(|_, networks| {
        let mut networks = networks.iter();
        networks.any(|&network| survey.control_flow(network).has(leaves))
    });
    let mut labels: BTreeMap<Body, Vec<usize>> = BTreeMap::new();
    for label in &context.labels {
        labels
            .entry(context.bodies[label.network])
            .or_default()
            .push(label.network);
    }
    for (body, networks) in networks_of {
        let labelled = labels.remove(&body).unwrap_or_default();
        let flow = Flow::new(context, survey, networks, &labelled);
        for check in checks {
            check(&flow, out);
        }
    }
}

impl<'c> Flow<'c> {
    /// Of a body with these networks, some of which have labels.
    fn new(
        context: &'c Context,
        survey: &'c Survey<'c>,
        networks: Vec<usize>,
        labelled: &[usize],
    ) -> Flow<'c> {
        let count = networks.len();
        let mut flow = Flow {
            context,
            survey,
            networks,
            exits: Vec::new(),
            next: vec![Places::new(); count + 1],
            ends: vec![false; count + 1],
        };
        let labelled = labelled.iter().filter_map(|&network| flow.place(network));
        let labelled: Places = labelled.collect();
        let rail_varies = flow.control_flow(0..count).has(ControlFlow::MCR);
        flow.next[count] = labelled;
        let loop_ends = flow.loop_ends();
        for (at, loop_end) in loop_ends.into_iter().enumerate() {
            flow.network(at, rail_varies, loop_end);
        }
        flow
    }

    /// Where in the body a network is.
    pub(super) fn place(&self, network: usize) -> Option<usize> {
        self.networks.binary_search(&network).ok()
    }

    /// The program flow of some of the networks.
    pub(super) fn control_flow(&self, networks: impl Iterator<Item = usize>) -> ControlFlow {
        networks.fold(ControlFlow::default(), |all, at| {
            all.with(self.survey.control_flow(self.networks[at]))
        })
    }

    pub(super) fn block(&self, exit: &Exit) -> BlockAt<'c> {
        self.context
            .networks
            .at(self.networks[exit.from])
            .block(exit.block)
    }

    /// For each network with a `<FOR>` the one with its `<NEXT>`.
    fn loop_ends(&self) -> Vec<Option<usize>> {
        let mut ends = vec![None; self.networks.len()];
        let of = |(at, &network): (usize, &usize)| LoopEnds {
            network: at,
            begins: self.survey.control_flow(network).has(ControlFlow::FOR),
            ends: self.survey.control_flow(network).has(ControlFlow::NEXT),
        };
        for (first, last) in loops(self.networks.iter().enumerate().map(of)) {
            ends[first] = Some(last);
        }
        ends
    }

    fn network(&mut self, at: usize, rail_varies: bool, loop_end: Option<usize>) {
        let control_flow = self.survey.control_flow(self.networks[at]);
        let mut goes_on = true;
        if control_flow.has(ControlFlow::JUMP.with(ControlFlow::RETURN).with(ControlFlow::END)) {
            goes_on = !self.exits_of(at, rail_varies && !control_flow.has(ControlFlow::MCR));
        }
        if control_flow.has(ControlFlow::FLOW_BLOCK) {
            // It may go to any label, or end the body.
            self.next[at].push(self.networks.len());
            self.ends[at] = true;
        }
        if !goes_on {
            return;
        }
        if control_flow.has(ControlFlow::FOR) {
            self.follow(at, loop_end.map_or(self.networks.len(), |next| next + 1));
        }
        self.follow(at, at + 1);
    }

    fn follow(&mut self, at: usize, next: usize) {
        if next < self.networks.len() {
            self.next[at].push(next);
        } else {
            self.ends[at] = true;
        }
    }

    /// Enters what leaves a network; whether one of these always does.
    fn exits_of(&mut self, at: usize, rail_varies: bool) -> bool {
        let index = self.networks[at];
        let network = self.context.networks.at(index);
        let power = NetworkPower::new(self.context, network, rail_varies);
        let powers = power.as_ref().map(|power| {
            power.powers(Question {
                fixed: true,
                ..Question::default()
            })
        });
        for (step, kind) in network.order.steps.iter().enumerate() {
            let Step::Block { block, en } = *kind else {
                continue;
            };
            let bound = network.block(block);
            let to = match bound.op() {
                Some(Op::Jmp) => match self.target(index, bound) {
                    Some(to) => Some(to),
                    None => continue,
                },
                Some(Op::Ret | Op::End) => None,
                _ => continue,
            };
            let always = match (&power, &powers) {
                (Some(power), Some(powers)) => powers.of_step[en] == power.space.all(),
                _ => false,
            };
            self.exits.push(Exit {
                from: at,
                block,
                step,
                to,
                always,
            });
            match to {
                Some(to) => self.next[at].push(to),
                None => self.ends[at] = true,
            }
            if always {
                return true;
            }
        }
        false
    }

    fn target(&self, network: usize, bound: BlockAt<'_>) -> Option<usize> {
        let (name, _) = bound.facts.first_name()?;
        self.place(self.context.jump_target(network, &Name::new(name))?)
    }

    /// For each network whether a scan can come there.
    pub(super) fn reached(&self) -> Vec<bool> {
        let mut reached = vec![false; self.next.len()];
        let mut open = vec![0];
        while let Some(at) = open.pop() {
            if !std::mem::replace(&mut reached[at], true) {
                open.extend(&self.next[at]);
            }
        }
        reached.truncate(self.networks.len());
        reached
    }

    /// For each network whether the body's end can be reached from it.
    pub(super) fn can_end(&self) -> Vec<bool> {
        let mut before: Vec<Places> = vec![Places::new(); self.next.len()];
        for (at, next) in self.next.iter().enumerate() {
            for &next in next {
                before[next].push(at);
            }
        }
        let mut can_end = vec![false; self.next.len()];
        let mut open: Vec<usize> = (0..self.next.len()).filter(|&at| self.ends[at]).collect();
        while let Some(at) = open.pop() {
            if !std::mem::replace(&mut can_end[at], true) {
                open.extend(&before[at]);
            }
        }
        can_end
    }
}
