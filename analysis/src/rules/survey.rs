//! One walk over all blocks, shared by the rules that look at blocks one by one and by those that look at the
//! whole program.

use super::{
    alternative_mnemonic, ambiguous_sign, division_by_zero, real_equality, result_arrow, short_preset,
};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::network::{BoundBlock, Meaning, NetworkFacts};
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use ladder_instructions::{Op, Shape};
use ladder_syntax::TextSize;

/// What the walk found.
pub(super) struct Survey {
    /// Everything could be read, every block is known and nothing is an error: what the text does not hold is not
    /// there. Rules about the whole program are silent otherwise.
    pub(super) whole: bool,
    /// No tag is undeclared that should not be: a slip in a name is told once.
    pub(super) names_known: bool,
    /// For each network whether it is drawn and written without errors. Rules about its power are silent otherwise.
    pub(super) sound: Vec<bool>,
    /// For each network what in it steers the program.
    pub(super) steering: Vec<Steering>,
    /// All of them together.
    pub(super) any: Steering,
}

/// What in a network steers the program, as bits.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Steering(u16);

impl Steering {
    pub(super) const JUMP: Steering = Steering(1);
    pub(super) const RETURN: Steering = Steering(1 << 1);
    pub(super) const END: Steering = Steering(1 << 2);
    pub(super) const FOR: Steering = Steering(1 << 3);
    pub(super) const NEXT: Steering = Steering(1 << 4);
    pub(super) const MCR: Steering = Steering(1 << 5);
    pub(super) const CALL: Steering = Steering(1 << 6);
    /// A user-defined block in the shape `<$B>`, which may jump, return and end.
    pub(super) const FLOW_BLOCK: Steering = Steering(1 << 7);
    /// Any other user-defined block.
    pub(super) const USER_BLOCK: Steering = Steering(1 << 8);
    /// A coil, a set coil, a reset coil.
    pub(super) const SET: Steering = Steering(1 << 9);
    pub(super) const RESET: Steering = Steering(1 << 10);
    pub(super) const COIL: Steering = Steering(1 << 11);
    /// What can leave a network before its end.
    pub(super) const LEAVES: Steering =
        Steering(Steering::JUMP.0 | Steering::RETURN.0 | Steering::END.0 | Steering::FLOW_BLOCK.0);

    /// Whether one of these is there.
    pub(super) const fn has(self, other: Steering) -> bool {
        self.0 & other.0 != 0
    }

    /// Both together.
    pub(super) const fn with(self, other: Steering) -> Steering {
        Steering(self.0 | other.0)
    }

    fn of(bound: &BoundBlock) -> Steering {
        match bound.meaning {
            Meaning::Instruction(row) => match row.op {
                Op::Jmp => Steering::JUMP,
                Op::Ret => Steering::RETURN,
                Op::End => Steering::END,
                Op::For => Steering::FOR,
                Op::Next => Steering::NEXT,
                Op::Mcr => Steering::MCR,
                Op::Call => Steering::CALL,
                Op::SetCoil | Op::RetentiveSet => Steering::SET,
                Op::ResetCoil | Op::RetentiveReset => Steering::RESET,
                Op::Coil | Op::NegatedCoil | Op::RetentiveCoil => Steering::COIL,
                _ => Steering::default(),
            },
            Meaning::User(_) | Meaning::UnknownUser if bound.facts.shape == Shape::Function => {
                Steering::FLOW_BLOCK
            }
            Meaning::User(_) | Meaning::UnknownUser => Steering::USER_BLOCK,
            Meaning::Unknown => Steering::default(),
        }
    }
}

/// What a rule about single blocks is asked with.
pub(super) struct Place<'c> {
    pub(super) context: &'c Context,
    pub(super) network: &'c NetworkFacts,
    pub(super) bound: &'c BoundBlock,
    pub(super) settings: &'c RuleSettings,
}

/// Walks over all blocks and asks the rules about single blocks.
pub(super) fn survey(context: &Context, settings: &RuleSettings, out: &mut Vec<Diagnostic>) -> Survey {
    let is_error = |found: &&Diagnostic| found.severity == Severity::Error;
    let mut errors: Vec<TextSize> = out
        .iter()
        .filter(is_error)
        .map(|found| found.range.start())
        .collect();
    errors.sort_unstable();
    let mut survey = Survey {
        whole: errors.is_empty() && context.parse.lines().iter().all(|line| line.errors.is_empty()),
        names_known: out.iter().all(|found| found.rule != Rule::UndeclaredTag),
        sound: Vec::with_capacity(context.networks.len()),
        steering: Vec::with_capacity(context.networks.len()),
        any: Steering::default(),
    };
    let spelling = settings.is_on(Rule::AlternativeMnemonic);
    for network in &context.networks {
        survey.whole &= !network.broken;
        let mut steering = Steering::default();
        for bound in &network.blocks {
            steering = steering.with(Steering::of(bound));
            let Meaning::Instruction(row) = bound.meaning else {
                survey.whole &= matches!(bound.meaning, Meaning::User(_));
                result_arrow::check(context, bound, out);
                continue;
            };
            if bound.faulty {
                continue;
            }
            let place = Place {
                context,
                network,
                bound,
                settings,
            };
            match row.op {
                Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof => short_preset::check(&place, out),
                Op::Eq | Op::Ne => real_equality::check(&place, out),
                Op::Div | Op::Mod => division_by_zero::check(&place, out),
                Op::Calc => {
                    ambiguous_sign::check(&place, out);
                    real_equality::in_expression(&place, out);
                    division_by_zero::in_expression(&place, out);
                }
                _ => {}
            }
            if bound.facts.operands.len() > 1 {
                result_arrow::check(context, bound, out);
            }
            if spelling {
                alternative_mnemonic::check(row, bound, out);
            }
        }
        let next = errors.partition_point(|&at| at < network.range.start());
        let has_error = errors.get(next).is_some_and(|&at| at < network.range.end());
        survey.sound.push(!network.broken && !has_error);
        survey.any = survey.any.with(steering);
        survey.steering.push(steering);
    }
    survey
}
