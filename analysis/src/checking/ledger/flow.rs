//! What networks have of program flow, and what is found of it in bodies and in the program as a whole.

use super::Ledger;
use crate::checking::at_tags::Flow;
use crate::checking::shelf::Source;
use crate::context::{Change, Context};
use crate::control_flow::ControlFlow;
use crate::networks::NetworkAt;
use crate::rules::survey::Survey;
use std::collections::BTreeSet;

impl Ledger {
    /// Notes what the networks have of program flow, of which these are new or looked at again.
    pub(super) fn follow_flow(
        &mut self,
        context: &Context,
        change: Option<&Change>,
        networks: &[usize],
    ) -> Flow {
        let new = networks.iter().map(|&index| context.networks.id(index));
        let gone = change
            .into_iter()
            .flat_map(|change| change.removed.iter().copied());
        let touched: Vec<(u32, ControlFlow)> = gone
            .chain(new.clone())
            .map(|id| (id, self.control_flow[id as usize]))
            .collect();
        for (id, _) in &touched {
            self.control_flow[*id as usize] = ControlFlow::default();
        }
        for (id, &index) in new.zip(networks) {
            self.control_flow[id as usize] = context.networks.at(index).control_flow;
        }
        let together = |all: ControlFlow, flow: ControlFlow| all.with(flow);
        let now = |id: u32| self.control_flow[id as usize];
        let changed = touched.iter().map(|&(id, before)| before.differing(now(id)));
        let changed = changed.fold(ControlFlow::default(), together);
        let touched = touched.iter().map(|&(id, before)| before.with(now(id)));
        let touched = touched.fold(ControlFlow::default(), together);
        self.any = self
            .control_flow
            .iter()
            .copied()
            .fold(ControlFlow::default(), together);
        Flow {
            any: self.any,
            changed,
            touched,
        }
    }

    /// Looks at the flow of the bodies that a change concerns, and of the program if that concerns it.
    pub(super) fn of_flow(&mut self, context: &Context, whole: bool) {
        let (mut bodies, mut program) = (
            std::mem::take(&mut self.bodies),
            std::mem::take(&mut self.program),
        );
        let survey = self.survey(context, whole);
        let looked_at = bodies.look(context, &survey);
        let exchanged = program.look(context, &survey);
        self.work.networks += looked_at;
        for exchanged in [bodies.take_exchanged(), exchanged] {
            self.shelf.exchange(exchanged, |_| Source::Program);
        }
        (self.bodies, self.program) = (bodies, program);
    }

    /// What a network has of program flow.
    pub(super) fn flow_at(&self, context: &Context, index: usize) -> ControlFlow {
        self.control_flow[context.networks.id(index) as usize]
    }

    /// What is known of the file as a whole.
    pub(super) fn survey<'l>(&'l self, context: &'l Context, whole: bool) -> Survey<'l> {
        Survey {
            whole,
            any: self.any,
            networks: &context.networks,
            control_flow: &self.control_flow,
            unsound: &self.unsound,
        }
    }

    /// The networks whose blocks may leave something in doubt: with one that is not known, with a label, or with the
    /// beginning of a function.
    pub(in crate::checking) fn marked<'c>(
        &self,
        context: &'c Context,
    ) -> impl Iterator<Item = NetworkAt<'c>> {
        let count = if self.any.has(ControlFlow::MARK) {
            self.control_flow.len()
        } else {
            0
        };
        let marks = self.control_flow[..count].iter().enumerate();
        let marks = marks.filter(|(_, flow)| flow.has(ControlFlow::MARK));
        let marks = marks.map(|(id, _)| id as u32);
        let ids: BTreeSet<u32> = marks.chain(self.unclear.iter().copied()).collect();
        ids.into_iter()
            .map(|id| context.networks.at(context.networks.index_of(id)))
    }
}
