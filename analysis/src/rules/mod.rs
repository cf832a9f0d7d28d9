//! The rules, one file each: what a rule is called and how much it matters, what it finds, its sentences and its fixes. What they
//! are functions of is in `list`; `checking` asks them.

pub(crate) mod alternative_mnemonic;
pub(crate) mod ambiguous_sign;
pub(crate) mod bad_arity;
pub(crate) mod bad_declaration;
pub(crate) mod bad_directive;
pub(crate) mod bad_literal;
pub(crate) mod bad_operand;
pub(crate) mod bypassed;
pub(crate) mod circles;
pub(crate) mod commented_out_rung;
pub(crate) mod complex_network;
pub(crate) mod constant_power;
pub(crate) mod constant_write;
pub(crate) mod contact_after_coil;
pub(crate) mod cplc_draft;
pub(crate) mod dead_end;
pub mod declaration_fix;
pub(crate) mod dependencies;
pub(crate) mod division_by_zero;
pub(crate) mod double_coil;
pub(crate) mod drawn;
pub(crate) mod duplicate_block;
pub(crate) mod duplicate_branch;
pub(crate) mod duplicate_counter;
pub(crate) mod duplicate_declaration;
pub(crate) mod duplicate_function;
pub(crate) mod duplicate_instance;
pub(crate) mod duplicate_label;
pub(crate) mod duplicate_timer;
pub(crate) mod duplicate_type;
pub(crate) mod edge_of_varying_index;
pub(crate) mod endless_jump;
pub(crate) mod flow;
pub(crate) mod follow_ups;
pub(crate) mod foreign_comment;
pub(crate) mod form;
pub(crate) mod frame_keyword;
pub(crate) mod input_written;
pub(crate) mod latched_power;
pub(crate) mod library_name;
pub(crate) mod list;
pub(crate) mod literal_out_of_range;
pub(crate) mod literals;
pub(crate) mod merge_conflict;
pub(crate) mod misleading_alignment;
pub(crate) mod misplaced_rail;
pub(crate) mod missing_wire;
pub(crate) mod near_names;
pub(crate) mod neutral_text;
pub(crate) mod never_read;
pub(crate) mod never_reset;
pub(crate) mod never_written;
pub(crate) mod no_output;
pub(crate) mod of_names;
pub(crate) mod one_address;
pub(crate) mod open_wire;
mod operand_fit;
pub(crate) mod order_sensitive;
pub(crate) mod overlapping_address;
pub(crate) mod parts;
pub(crate) mod power_rules;
pub(crate) mod read_before_write;
pub(crate) mod real_equality;
pub(crate) mod recursive_block;
pub(crate) mod recursive_call;
pub(crate) mod recursive_type;
pub(crate) mod redundant_element;
pub(crate) mod reset_without_set;
pub(crate) mod result_arrow;
pub(crate) mod return_outside_function;
pub(crate) mod rung_not_powered;
pub(crate) mod set_and_reset;
pub(crate) mod set_without_reset;
pub(crate) mod short_preset;
pub(crate) mod shorted_branch;
pub(crate) mod suppression_unused;
pub(crate) mod survey;
pub(crate) mod syntax_errors;
pub(crate) mod tag_view;
mod tags_shown;
pub(crate) mod type_conflict;
pub(crate) mod type_members;
pub(crate) mod type_mismatch;
pub(crate) mod unbalanced_loop;
pub(crate) mod unclosed_block;
pub(crate) mod unclosed_comment;
mod unclosed_section;
pub(crate) mod unconditional_end;
pub(crate) mod undeclared_tag;
pub(crate) mod unexpected_character;
pub(crate) mod unhandled_value;
pub(crate) mod unknown_block;
pub(crate) mod unknown_function;
pub(crate) mod unknown_instruction;
pub(crate) mod unknown_label;
pub(crate) mod unknown_member;
pub(crate) mod unknown_type;
pub(crate) mod unpaired_connector;
pub(crate) mod unreachable;
pub(crate) mod unread_part;
pub(crate) mod unused_function;
pub(crate) mod unused_label;
pub(crate) mod unused_type;
pub(crate) mod wiring_walk;
pub(crate) mod wrong_place;
pub(crate) mod wrong_shape;

pub use list::{ALL, is_of_own_text, rule_named};
pub(crate) use list::{Checks, position};

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Severity;
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::networks::network::Meaning;
use form::Form;
use survey::{Survey, SurveyedBlock};
use tag_view::TagView;
use tags_shown::TagsShown;
use wiring_walk::Walk;

/// Once so much was found in a file, no more is looked for in single networks and lines: nobody reads it, and each
/// finding takes a hundred times the memory of the character that it is about.
pub(crate) const MOST_FINDINGS: usize = 200_000;

/// Whether enough was found since there were `before` findings; then the last of them says so.
fn is_enough(before: usize, out: &mut [Diagnostic]) -> bool {
    if out.len() - before < MOST_FINDINGS {
        return false;
    }
    if let Some(last) = out.last_mut() {
        say_enough(last);
    }
    true
}

/// Has the last finding say that no more is looked for.
pub(crate) fn say_enough(last: &mut Diagnostic) {
    let enough = format!("{MOST_FINDINGS} findings are enough: what is after this place is not checked");
    last.help = Some(enough.into());
    // What was not checked may be wrong: such a program does not run.
    last.severity = Severity::Error;
}

impl Checks {
    /// Asks those about a network by itself: its drawing, and its blocks.
    pub(crate) fn form(
        &self,
        context: &Context,
        network: NetworkAt<'_>,
        settings: &RuleSettings,
        out: &mut Vec<Diagnostic>,
    ) {
        let form = Form::of(context, network);
        for check in &self.form {
            check(&form, out);
        }
        for bound in network.blocks() {
            let row = match bound.meaning {
                Meaning::Instruction(row) if !bound.faulty => Some(row),
                _ => None,
            };
            let block = SurveyedBlock {
                tags: TagsShown::of(context, network),
                bound,
                row,
                scan: settings.scan_interval.or(context.cycle),
            };
            for check in &self.block {
                check(&block, out);
            }
        }
    }

    /// Asks those about what power does in a network without errors.
    pub(crate) fn power(&self, survey: &Survey<'_>, network: NetworkAt<'_>, out: &mut Vec<Diagnostic>) {
        if let Some(walk) = Walk::new(survey.context, network) {
            for check in &self.wiring {
                check(&walk, out);
            }
        }
        if let Some(table) = power_rules::table(survey, network) {
            for check in &self.power {
                check(&table, out);
            }
        }
    }

    /// Asks those about a tag with its uses.
    pub(crate) fn tag(&self, tag: &TagView<'_>, out: &mut Vec<Diagnostic>) {
        for check in &self.tag {
            check(tag, out);
        }
    }

    /// Asks those about the names and definitions of a file.
    pub(crate) fn file(&self, context: &Context, out: &mut Vec<Diagnostic>) {
        for check in &self.file {
            check(context, out);
        }
    }

    /// Asks those about the program as a whole.
    pub(crate) fn program(&self, survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
        for check in &self.program {
            check(survey, out);
        }
        flow::check(survey, &self.flow, out);
    }
}

/// Puts into sentences what is wrong with names.
pub(crate) fn of_names(context: &Context, out: &mut Vec<Diagnostic>) {
    let problems = context.problems.iter();
    out.extend(problems.map(|problem| of_names::diagnostic(context, problem)));
}
