//! `alternative-mnemonic`: an instruction is written in one of the spellings that are also accepted.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Blocks, "alternative-mnemonic", Severity::Info)
        .off()
        .fixed(Applicability::Safe),
);

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    let (Some(row), bound) = (place.row, place.bound) else {
        return;
    };
    let text = bound.facts.head.text();
    if row.aliases.iter().any(|alias| alias.eq_ignore_ascii_case(text)) {
        let block = row.block();
        out.push(
            Diagnostic::new(
                RULE,
                bound.head_range(),
                format!("{} is another spelling of {block}", bound.head_text()),
            )
            .help("one spelling for one instruction makes a program easy to search")
            .fix(
                Applicability::Safe,
                format!("Write {block}"),
                bound.head_range(),
                block,
            ),
        );
    }
}
