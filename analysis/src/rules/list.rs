//! Every rule, in the order of the reference, and what it is a function of. A new rule is a file, its line here, and its page.

use super::flow::Flow;
use super::form::Form;
use super::power_rules::Table;
use super::survey::{Survey, SurveyedBlock};
use super::tag_view::TagView;
use super::wiring_walk::Walk;
// The list names every rule of this room; that is what it is for.
#[allow(clippy::wildcard_imports)]
use super::*;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleGroup};
use crate::findings::rule_settings::{Level, RuleSettings};
use crate::names::context::Context;

/// What a rule is a function of. What it finds goes to the list.
#[derive(Clone, Copy)]
enum Check {
    /// Found while the text is read, names are joined, operands resolved or comments read; or together with another rule.
    ByOthers,
    /// The drawing of a network, and the form of its blocks.
    Form(fn(&Form<'_>, &mut Vec<Diagnostic>)),
    /// A block of a network.
    Block(fn(&SurveyedBlock<'_>, &mut Vec<Diagnostic>)),
    /// What is after what on the wires of a network without errors.
    Wiring(fn(&Walk<'_>, &mut Vec<Diagnostic>)),
    /// When power comes through a network without errors.
    Power(fn(&Table<'_>, &mut Vec<Diagnostic>)),
    /// A tag with its uses.
    Tag(fn(&TagView<'_>, &mut Vec<Diagnostic>)),
    /// The ways of a scan through a body that holds jumps, returns or ends.
    Flow(fn(&Flow<'_>, &mut Vec<Diagnostic>)),
    /// The names and definitions of a file.
    File(fn(&Context, &mut Vec<Diagnostic>)),
    /// The program as a whole.
    Program(fn(&Survey<'_>, &mut Vec<Diagnostic>)),
}

const LIST: &[(Rule, Check)] = &[
    (unclosed_block::RULE, Check::ByOthers),
    (unclosed_comment::RULE, Check::ByOthers),
    (unexpected_character::RULE, Check::ByOthers),
    (merge_conflict::RULE, Check::ByOthers),
    (missing_wire::RULE, Check::Form(missing_wire::check)),
    (misplaced_rail::RULE, Check::Form(misplaced_rail::check)),
    (bad_literal::RULE, Check::ByOthers),
    (bad_declaration::RULE, Check::ByOthers),
    (bad_directive::RULE, Check::ByOthers),
    (suppression_unused::RULE, Check::ByOthers),
    (unpaired_connector::RULE, Check::Form(unpaired_connector::check)),
    (
        misleading_alignment::RULE,
        Check::Form(misleading_alignment::check),
    ),
    (unknown_instruction::RULE, Check::Form(unknown_instruction::check)),
    (wrong_shape::RULE, Check::ByOthers),
    (bad_arity::RULE, Check::Form(bad_arity::check)),
    (bad_operand::RULE, Check::Form(bad_operand::check)),
    (type_mismatch::RULE, Check::Tag(type_conflict::check)),
    (
        literal_out_of_range::RULE,
        Check::File(literal_out_of_range::check),
    ),
    (constant_write::RULE, Check::ByOthers),
    (
        alternative_mnemonic::RULE,
        Check::Block(alternative_mnemonic::check),
    ),
    (result_arrow::RULE, Check::Block(result_arrow::check)),
    (real_equality::RULE, Check::Block(real_equality::check)),
    (division_by_zero::RULE, Check::Block(division_by_zero::check)),
    (short_preset::RULE, Check::Block(short_preset::check)),
    (ambiguous_sign::RULE, Check::Block(ambiguous_sign::check)),
    (undeclared_tag::RULE, Check::Tag(undeclared_tag::check)),
    (duplicate_declaration::RULE, Check::File(one_address::check)),
    (unknown_member::RULE, Check::ByOthers),
    (duplicate_timer::RULE, Check::Tag(duplicate_timer::check)),
    (duplicate_counter::RULE, Check::ByOthers),
    (unknown_label::RULE, Check::File(unknown_label::check)),
    (duplicate_label::RULE, Check::File(duplicate_label::check)),
    (unknown_function::RULE, Check::ByOthers),
    (duplicate_function::RULE, Check::File(duplicate_function::check)),
    (unknown_block::RULE, Check::Form(unknown_block::check)),
    (duplicate_block::RULE, Check::File(duplicate_block::check)),
    (library_name::RULE, Check::File(library_name::check)),
    (unknown_type::RULE, Check::ByOthers),
    (duplicate_type::RULE, Check::ByOthers),
    (recursive_type::RULE, Check::ByOthers),
    (duplicate_instance::RULE, Check::Tag(duplicate_instance::check)),
    (wrong_place::RULE, Check::Form(wrong_place::check)),
    (recursive_block::RULE, Check::File(recursive_block::check)),
    (recursive_call::RULE, Check::Program(recursive_call::check)),
    (
        overlapping_address::RULE,
        Check::Program(overlapping_address::check),
    ),
    (input_written::RULE, Check::Tag(input_written::check)),
    (open_wire::RULE, Check::Form(open_wire::check)),
    (rung_not_powered::RULE, Check::ByOthers),
    (dead_end::RULE, Check::Wiring(dead_end::check)),
    (no_output::RULE, Check::Form(no_output::check)),
    (shorted_branch::RULE, Check::Wiring(shorted_branch::check)),
    (duplicate_branch::RULE, Check::Power(duplicate_branch::check)),
    (constant_power::RULE, Check::Power(constant_power::check)),
    (redundant_element::RULE, Check::Power(redundant_element::check)),
    (contact_after_coil::RULE, Check::Wiring(contact_after_coil::check)),
    (latched_power::RULE, Check::Wiring(latched_power::check)),
    (unread_part::RULE, Check::File(unread_part::check)),
    (complex_network::RULE, Check::Form(complex_network::check)),
    (double_coil::RULE, Check::Tag(double_coil::check)),
    (set_and_reset::RULE, Check::Tag(set_and_reset::check)),
    (set_without_reset::RULE, Check::Tag(set_without_reset::check)),
    (reset_without_set::RULE, Check::ByOthers),
    (never_written::RULE, Check::Tag(never_written::check)),
    (never_read::RULE, Check::Tag(never_read::check)),
    (never_reset::RULE, Check::Tag(never_reset::check)),
    (read_before_write::RULE, Check::Program(read_before_write::check)),
    (order_sensitive::RULE, Check::Power(order_sensitive::check)),
    (unreachable::RULE, Check::Flow(unreachable::check)),
    (endless_jump::RULE, Check::Flow(endless_jump::check)),
    (unconditional_end::RULE, Check::Flow(unconditional_end::check)),
    (
        return_outside_function::RULE,
        Check::Program(return_outside_function::check),
    ),
    (unbalanced_loop::RULE, Check::Program(unbalanced_loop::check)),
    (unused_function::RULE, Check::Program(unused_function::check)),
    (unused_label::RULE, Check::Program(unused_label::check)),
    (unused_type::RULE, Check::Program(unused_type::check)),
    (
        edge_of_varying_index::RULE,
        Check::Block(edge_of_varying_index::check),
    ),
    (unhandled_value::RULE, Check::File(unhandled_value::check)),
    (commented_out_rung::RULE, Check::File(commented_out_rung::check)),
];

/// Every rule, in the order of the reference.
pub const ALL: &[Rule] = &{
    let mut all = [LIST[0].0; LIST.len()];
    let mut next = 0;
    while next < all.len() {
        all[next] = LIST[next].0;
        next += 1;
    }
    all
};

/// Which rule it is in the order of the reference: findings at one place come in it.
pub(crate) fn position(rule: Rule) -> usize {
    ALL.iter().position(|other| *other == rule).unwrap_or(ALL.len())
}

/// The rule of a name, compared to the letter.
pub fn rule_named(name: &str) -> Option<Rule> {
    ALL.iter().copied().find(|rule| rule.name() == name)
}

/// Whether what a rule finds follows from the text of the file alone, whatever other files show.
pub fn is_of_own_text(rule: Rule) -> bool {
    let is_of_text = matches!(rule.group(), RuleGroup::Text | RuleGroup::Connectors);
    // A constant of another file may be a bound, and a comment may switch off what follows from one.
    is_of_text && ![bad_declaration::RULE, suppression_unused::RULE].contains(&rule)
}

/// The checks that are asked, by what they are a function of.
#[derive(Default)]
pub(crate) struct Checks {
    pub(super) form: Vec<fn(&Form<'_>, &mut Vec<Diagnostic>)>,
    pub(super) block: Vec<fn(&SurveyedBlock<'_>, &mut Vec<Diagnostic>)>,
    pub(super) wiring: Vec<fn(&Walk<'_>, &mut Vec<Diagnostic>)>,
    pub(super) power: Vec<fn(&Table<'_>, &mut Vec<Diagnostic>)>,
    pub(super) tag: Vec<fn(&TagView<'_>, &mut Vec<Diagnostic>)>,
    pub(super) flow: Vec<fn(&Flow<'_>, &mut Vec<Diagnostic>)>,
    pub(super) file: Vec<fn(&Context, &mut Vec<Diagnostic>)>,
    pub(super) program: Vec<fn(&Survey<'_>, &mut Vec<Diagnostic>)>,
}

impl Checks {
    /// All but those of rules that are a matter of taste and not switched on.
    pub(crate) fn new(settings: &RuleSettings) -> Checks {
        let mut all = Checks::default();
        for (rule, check) in LIST {
            if !rule.on_by_default() && !settings.is_on(*rule) {
                continue;
            }
            match *check {
                Check::ByOthers => {}
                Check::Form(check) => all.form.push(check),
                Check::Block(check) => all.block.push(check),
                Check::Wiring(check) => all.wiring.push(check),
                Check::Power(check) => all.power.push(check),
                Check::Tag(check) => all.tag.push(check),
                Check::Flow(check) => all.flow.push(check),
                Check::File(check) => all.file.push(check),
                Check::Program(check) => all.program.push(check),
            }
        }
        all
    }
}

impl RuleSettings {
    /// Every rule looks, also those that are off unless set.
    pub fn everything() -> RuleSettings {
        let mut settings = RuleSettings::default();
        for rule in ALL.iter().copied().filter(|rule| !rule.on_by_default()) {
            settings.set(rule, Level::Shown(rule.default_severity()));
        }
        settings
    }
}
