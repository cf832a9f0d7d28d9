//! What is found about the flow of the program as a whole, kept while no edit concerns it.

use super::at_tags::Exchanged;
use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::findings::Anchored;
use crate::others::Others;
use crate::rules;
use crate::rules::survey::Survey;
use std::sync::Arc;

/// What is found about the program as a whole.
#[derive(Debug, Default)]
pub(super) struct OfProgram {
    found: Vec<Arc<Anchored>>,
    /// None if it is to be looked for again.
    found_with: Option<FoundWith>,
}

/// What decides about it besides the networks that have something of program flow.
#[derive(Debug)]
struct FoundWith {
    whole: bool,
    others: Others,
}

impl OfProgram {
    /// Networks have changed that have this of program flow, or had it.
    pub(super) fn follow(&mut self, touched: ControlFlow) {
        if touched.has(ControlFlow::OF_PROGRAM) {
            self.look_again();
        }
    }

    /// What is kept may not be true any longer.
    pub(super) fn look_again(&mut self) {
        self.found_with = None;
    }

    /// Looks at the program, if what is kept may not be true.
    pub(super) fn look(&mut self, context: &Context, survey: &Survey<'_>) -> Exchanged {
        let is_kept =
            |with: &FoundWith| with.whole == survey.whole && with.others.are_all_the_same(&context.others);
        if self.found_with.as_ref().is_some_and(is_kept) {
            return Exchanged::default();
        }
        self.found_with = Some(FoundWith {
            whole: survey.whole,
            others: context.others.clone(),
        });
        let mut found = Vec::new();
        rules::of_program(context, survey, &mut found);
        let anchored = |found| Arc::new(Anchored::in_networks(found, context));
        let new: Vec<Arc<Anchored>> = found.into_iter().map(anchored).collect();
        debug_assert!(
            !new.iter().any(|found| found.is_volatile()),
            "all places are in networks"
        );
        Exchanged {
            gone: std::mem::replace(&mut self.found, new.clone()),
            new,
        }
    }
}
