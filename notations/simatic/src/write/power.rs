//! The power of blocks of one's own. There a block without power does not run, and no body has `EN` and `ENO` as variables:
//! a block that runs all the same is called from the rail, with the power as an input and an output.

use crate::model::Part;
use ladder_analysis::program::{Network, Program, Step, UserBlock};
use ladder_notation::guard::{is_guarded, uses};
use std::collections::HashMap;

/// The input that `EN` is.
pub(super) const POWER_IN: &str = "power_in";
/// The output that `ENO` is.
pub(super) const POWER_OUT: &str = "power_out";

/// How a block comes by its power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Power {
    /// Its first network, `+--[/]( EN )--<RET>--+`, keeps it from running without; it is not written.
    Guarded,
    /// It runs without.
    Given {
        /// Its body knows the power.
        reads: bool,
        /// Its body says which power leaves it.
        writes: bool,
    },
}

/// How a block comes by its power.
pub(super) fn power(program: &Program, block: &UserBlock) -> Power {
    if is_guarded(program, block) {
        return Power::Guarded;
    }
    let networks = &program.networks[block.networks.clone()];
    let writes = uses(networks, block.eno);
    Power::Given {
        reads: writes || uses(networks, block.en),
        writes,
    }
}

/// What stands for blocks of a network.
pub(super) type Stands = HashMap<usize, Part>;

/// A network in two, parted at a step that calls a block.
pub(super) struct Parted {
    /// What runs before; the call is where its power ends.
    pub(super) before: Network,
    /// What runs after; the call is where the power that leaves it begins.
    pub(super) after: Network,
}

/// Whether power comes straight from the rail.
pub(super) fn is_rail(network: &Network, step: usize) -> bool {
    matches!(network.steps[step], Step::Start { rail: true })
}

/// Whether something goes on with the power of a step.
pub(super) fn is_used(network: &Network, step: usize) -> bool {
    network.steps.iter().any(|other| match *other {
        Step::Start { .. } => false,
        Step::Block { en, .. } => en == step,
        Step::Join { upper, lower } => upper == step || lower == step,
    })
}

/// Parts a network at a call.
///
/// # Errors
///
/// Power from before the call is needed after it.
pub(super) fn parted(network: &Network, step: usize) -> Result<Parted, String> {
    let Step::Block { block, en } = network.steps[step] else {
        return Err("no block is called there".to_owned());
    };
    let with = |steps: Vec<Step>| Network {
        steps,
        ..network.clone()
    };
    let mut before = network.steps[..step].to_vec();
    if !is_rail(network, en) {
        before.push(network.steps[step]);
    }
    let result = if is_used(network, step) {
        Step::Block { block, en: 0 }
    } else {
        Step::Start { rail: false }
    };
    let mut after = vec![Step::Start { rail: true }, result];
    let moved = |from: usize| match from.checked_sub(step) {
        Some(later) => Ok(later + 1),
        None if is_rail(network, from) => Ok(0),
        None => Err(
            "power passes by the block, which is called from the rail there: draw it on a network of its own"
                .to_owned(),
        ),
    };
    for later in &network.steps[step + 1..] {
        after.push(match *later {
            Step::Start { .. } => *later,
            Step::Block { block, en } => Step::Block {
                block,
                en: moved(en)?,
            },
            Step::Join { upper, lower } => Step::Join {
                upper: moved(upper)?,
                lower: moved(lower)?,
            },
        });
    }
    Ok(Parted {
        before: with(before),
        after: with(after),
    })
}
