//! The power of every step of a network, for every combination of values.

use super::gate::{Ask, CoilKind, Gate, Gates, Variable};
use super::space::{Set, Space};
use super::variables::gates;
use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::program::Step;

/// How many steps a network may have: nobody draws more by hand.
const MOST_STEPS: usize = 400;

/// A network, ready to be asked.
pub(crate) struct NetworkPower<'c> {
    network: NetworkAt<'c>,
    pub(crate) gates: Gates,
    pub(crate) space: Space,
    /// When the left rail has power.
    rail: Set,
}

/// What the network is asked with.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Question {
    /// Contacts see what their tags were before the network.
    pub(crate) read_first: bool,
    /// This block is a bare wire, or a gap.
    pub(crate) replaced: Option<(usize, Replacement)>,
    /// `SYS.ON` is on and `SYS.OFF` is off. Otherwise they are contacts like others, which were put there on purpose
    /// on purpose.
    pub(crate) fixed: bool,
}

/// What is in a block's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Replacement {
    Wire,
    Gap,
}

/// The answer: sets of combinations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Powers {
    /// For each step when it has power.
    pub(crate) of_step: Vec<Set>,
    /// For each block what it does: for a coil whose tag is read, when its tag is on after it; for others when
    /// power enters them.
    pub(crate) effects: Vec<Option<Set>>,
}

impl<'c> NetworkPower<'c> {
    /// None if there are too many combinations. `rail_varies`: an `<MCR>` may take the left rail's power away.
    pub(crate) fn new(
        context: &Context,
        network: NetworkAt<'c>,
        rail_varies: bool,
    ) -> Option<NetworkPower<'c>> {
        if network.order.steps.len() > MOST_STEPS {
            return None;
        }
        let mut gates = gates(context, network)?;
        if rail_varies {
            gates.variables.push(Variable::Unknown);
        }
        let space = Space::new(gates.variables.iter().map(Variable::size).collect())?;
        let rail = if rail_varies {
            space.values(gates.variables.len() - 1, 0b10)
        } else {
            space.all()
        };
        Some(NetworkPower {
            network,
            gates,
            space,
            rail,
        })
    }

    /// When each step has power, and what each block does.
    pub(crate) fn powers(&self, question: Question) -> Powers {
        // What a tag holds once a coil of the network has written it.
        let mut held: Vec<Option<Set>> = vec![None; self.gates.variables.len()];
        let mut powers = Powers {
            of_step: Vec::with_capacity(self.network.order.steps.len()),
            effects: vec![None; self.network.blocks.len()],
        };
        for step in &self.network.order.steps {
            let power = match *step {
                Step::Start { rail: true } => self.rail.clone(),
                Step::Start { rail: false } => self.space.none(),
                Step::Join { upper, lower } => &powers.of_step[upper] | &powers.of_step[lower],
                Step::Block { block, en } => {
                    let en = &powers.of_step[en];
                    let (eno, effect) = self.block(block, en, &mut held, question);
                    powers.effects[block] = Some(effect.unwrap_or_else(|| en.clone()));
                    match question.replaced {
                        Some((replaced, Replacement::Wire)) if replaced == block => en.clone(),
                        Some((replaced, Replacement::Gap)) if replaced == block => self.space.none(),
                        _ => eno,
                    }
                }
            };
            powers.of_step.push(power);
        }
        powers
    }

    fn block(
        &self,
        block: usize,
        en: &Set,
        held: &mut [Option<Set>],
        question: Question,
    ) -> (Set, Option<Set>) {
        let ask = |ask: &Ask, held: &[Option<Set>]| self.ask(*ask, held, question);
        match &self.gates.of_block[block] {
            Gate::Pass => (en.clone(), None),
            Gate::If(asks) => {
                let mut power = en.clone();
                for one in asks {
                    power = &power & &ask(one, held);
                }
                (power, None)
            }
            Gate::Inverter => (!en, None),
            Gate::IfNot(one) => (&!en & &ask(one, held), None),
            Gate::Gives(one) => (ask(one, held), None),
            Gate::Coil(_, None) => (en.clone(), None),
            Gate::Coil(kind, Some(variable)) => {
                let before = held[*variable]
                    .take()
                    .unwrap_or_else(|| self.space.values(*variable, 0b10));
                let after = match kind {
                    CoilKind::Power => en.clone(),
                    CoilKind::Negated => !en,
                    CoilKind::Set => &before | en,
                    CoilKind::Reset => &before & &!en,
                };
                held[*variable] = Some(after.clone());
                let eno = if *kind == CoilKind::Set {
                    after.clone()
                } else {
                    en.clone()
                };
                (eno, Some(after))
            }
        }
    }

    fn ask(&self, ask: Ask, held: &[Option<Set>], question: Question) -> Set {
        match (&held[ask.variable], &self.gates.variables[ask.variable]) {
            (_, Variable::Fixed(value)) if question.fixed => {
                if ask.mask >> u8::from(*value) & 1 == 1 {
                    self.space.all()
                } else {
                    self.space.none()
                }
            }
            (Some(on), _) if !question.read_first => match ask.mask {
                0b10 => on.clone(),
                0b01 => !on,
                _ => self.space.values(ask.variable, ask.mask),
            },
            _ => self.space.values(ask.variable, ask.mask),
        }
    }

    /// Whether a block's condition can be answered from one value of its variable alone: never, or always.
    pub(crate) fn constant_condition(&self, block: usize) -> Option<bool> {
        let Gate::If(asks) = &self.gates.of_block[block] else {
            return None;
        };
        let whole = |ask: &Ask| {
            let size = self.space.size(ask.variable);
            if size == 64 { u64::MAX } else { (1 << size) - 1 }
        };
        if asks.iter().any(|ask| ask.mask & whole(ask) == 0) {
            return Some(false);
        }
        (!asks.is_empty() && asks.iter().all(|ask| ask.mask & whole(ask) == whole(ask))).then_some(true)
    }

    /// The values of a combination that matter: those without which `interesting` would not hold. Variables that
    /// have no name are left out.
    pub(crate) fn says(&self, point: usize, interesting: &Set) -> String {
        let values = self.space.at(point);
        let variables = self.gates.variables.iter().enumerate();
        let matter = variables.filter(|&(index, _)| {
            (0..self.space.size(index)).any(|value| !interesting.holds(self.space.with(point, index, value)))
        });
        let told: Vec<String> = matter
            .filter_map(|(index, variable)| variable.says(values[index]))
            .collect();
        told.join(", ")
    }
}
