//! `result-arrow`: a result is taken with `:=` where `=>` shows that it comes out of the block.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::network::{Formal, Meaning};
use crate::program::ParameterKind;
use ladder_instructions::Direction;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "result-arrow", Severity::Info).fixed(Applicability::Safe));

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    let bound = place.bound;
    for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
        let (Some(name), false) = (operand.name(), operand.has_arrow()) else {
            continue;
        };
        let is_result = match (*formal, bound.meaning) {
            (Formal::Operand(row), _) => row.direction == Direction::Out,
            (Formal::Parameter(index), Meaning::User(block)) => {
                place.tags.parameters(block)[index].kind == ParameterKind::Output
            }
            _ => false,
        };
        let Some(arrow) = operand.arrow_range().filter(|_| is_result && !bound.faulty) else {
            continue;
        };
        out.push(
            Diagnostic::new(
                RULE,
                bound.absolute(arrow),
                format!(
                    "`{}` is a result of {}: it is taken with `=>`",
                    name.text,
                    bound.head_text()
                ),
            )
            .help("`:=` gives an operand, `=>` takes a result")
            .fix(
                Applicability::Safe,
                "Replace `:=` with `=>`",
                bound.absolute(arrow),
                "=>",
            ),
        );
    }
}
