//! The tags that are read above the rung that writes them, and which of these a rule has something to say about.
//!
//! For that the networks of the whole file count: a circle of them may open or close far away. It is decided once the file as a whole is
//! known, and again where the circles have changed.

use super::at_tags::TagKey;
use super::dependencies::Dependencies;
use crate::context::{Body, Context};
use crate::control_flow::ControlFlow;
use crate::rules::double_coil::Leaving;
use crate::rules::read_before_write::Late;
use rustc_hash::{FxHashMap, FxHashSet};

/// The tags that are read above the rung that writes them, and could be below it.
#[derive(Debug, Default)]
pub(super) struct ReadAbove {
    tags: FxHashMap<TagKey, Decided>,
    undecided: FxHashSet<TagKey>,
    /// Those that were looked at since it was last asked for circles.
    touched: FxHashSet<TagKey>,
    /// Which networks depend on each other, once that is asked.
    dependencies: Option<Dependencies>,
    /// The bodies in which the straight way down is not the only one, once that is asked. Where a way out of a network comes or
    /// goes, nothing of this is kept: see [`Leaving`].
    jumping: Option<FxHashSet<Body>>,
}

/// What was decided last.
#[derive(Debug)]
struct Decided {
    late: Late,
    is_found: bool,
}

/// What a decision has changed.
#[derive(Debug, Default)]
pub(super) struct Decision {
    /// The tags of which something is found that was not, or nothing any longer.
    pub(super) other: Vec<(TagKey, bool)>,
    /// How many were decided.
    pub(super) count: usize,
}

impl ReadAbove {
    /// A tag is looked at again: nothing is known of it, and nothing found.
    pub(super) fn forget(&mut self, key: &TagKey) {
        self.tags.remove(key);
        self.undecided.remove(key);
        if self.dependencies.is_some() {
            self.touched.insert(key.clone());
        }
    }

    /// A tag is one of them.
    pub(super) fn note(&mut self, key: &TagKey, late: Late) {
        let decided = Decided {
            late,
            is_found: false,
        };
        self.tags.insert(key.clone(), decided);
        self.undecided.insert(key.clone());
    }

    /// Decides in a file that is known as a whole. `any` is what its networks have together of program flow.
    pub(super) fn decide(&mut self, context: &Context, any: ControlFlow) -> Decision {
        if self.tags.is_empty() {
            return Decision::default();
        }
        let jumping = self.jumping.get_or_insert_with(|| bodies_that_jump(context, any));
        let dependencies = match &mut self.dependencies {
            Some(dependencies) => {
                if dependencies.follow(context, self.touched.drain()) {
                    self.undecided.extend(self.tags.keys().cloned());
                }
                dependencies
            }
            none => none.insert(Dependencies::new(context)),
        };
        let mut decision = Decision {
            other: Vec::new(),
            count: self.undecided.len(),
        };
        for key in self.undecided.drain() {
            let Some(decided) = self.tags.get_mut(&key) else {
                continue;
            };
            let Late { read, write } = decided.late;
            let body = context.bodies[context.networks.index_of(write)];
            // Somebody has to read the old value where each rung depends on the other.
            let is_found = !jumping.contains(&body) && !dependencies.are_in_a_circle(read, write);
            if std::mem::replace(&mut decided.is_found, is_found) != is_found {
                decision.other.push((key, is_found));
            }
        }
        decision
    }
}

/// The bodies in which the straight way down is not the only one.
fn bodies_that_jump(context: &Context, any: ControlFlow) -> FxHashSet<Body> {
    if !any.has(Leaving::WAYS) {
        return FxHashSet::default();
    }
    let jumping = context
        .networks
        .iter()
        .filter(|network| network.control_flow.has(Leaving::WAYS));
    jumping.map(|network| context.bodies[network.index]).collect()
}
