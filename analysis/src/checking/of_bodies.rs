//! What is found about the ways that a scan takes through each body, kept while no edit concerns one of its networks.

use super::at_tags::Exchanged;
use crate::context::{Body, Change, Context};
use crate::findings::Anchored;
use crate::rules::flow;
use crate::rules::survey::Survey;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// What is found in bodies.
#[derive(Debug, Default)]
pub(super) struct OfBodies {
    found: FxHashMap<Body, Vec<Arc<Anchored>>>,
    /// The body of each network, by its number.
    body_of: Vec<Body>,
    /// Those to look at once the file is known as a whole. Of none of them anything is kept.
    dirty: FxHashSet<Body>,
    exchanged: Exchanged,
}

impl OfBodies {
    /// Drops what is found in the bodies of networks that are gone, new or looked at again.
    pub(super) fn follow(&mut self, context: &Context, change: Option<&Change>, networks: &[usize]) {
        let removed = change.iter().flat_map(|change| &change.removed);
        let before: Vec<Body> = removed.map(|&id| self.body_of[id as usize]).collect();
        self.body_of.resize(context.networks.numbers(), Body::Main);
        for body in before {
            self.drop_what_is_found_in(body);
        }
        for &index in networks {
            let body = context.bodies[index];
            self.body_of[context.networks.id(index) as usize] = body;
            self.drop_what_is_found_in(body);
        }
    }

    fn drop_what_is_found_in(&mut self, body: Body) {
        if self.dirty.insert(body) {
            let gone = self.found.remove(&body);
            self.exchanged.gone.extend(gone.into_iter().flatten());
        }
    }

    /// Looks at the bodies of which nothing is kept, if the file is known as a whole. Gives how many networks they have, as far as
    /// these were looked at.
    pub(super) fn look(&mut self, context: &Context, survey: &Survey<'_>) -> usize {
        if !survey.whole || self.dirty.is_empty() {
            return 0;
        }
        let dirty = std::mem::take(&mut self.dirty);
        flow::check(context, survey, &dirty, |body, found| {
            let anchored = |found| Arc::new(Anchored::in_networks(found, context));
            let found: Vec<Arc<Anchored>> = found.into_iter().map(anchored).collect();
            self.exchanged.new.extend(found.iter().cloned());
            self.found.insert(body, found);
        })
    }

    /// What has come and gone since this was last asked.
    pub(super) fn take_exchanged(&mut self) -> Exchanged {
        std::mem::take(&mut self.exchanged)
    }
}
