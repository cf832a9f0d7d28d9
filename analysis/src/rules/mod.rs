//! The rules, one file each: what they find, their sentences and their fixes.
//!
//! Each has a `check`: over the [`Form`] of a network, what its file makes of a block, or the [`Context`]. What is found while names are declared and operands resolved is in
//! `mistakes`.

mod alternative_mnemonic;
mod ambiguous_sign;
pub(crate) mod bad_arity;
pub(crate) mod bad_literal;
pub(crate) mod bad_operand;
mod bypassed;
mod circles;
pub(crate) mod commented_out_rung;
mod complex_network;
mod constant_power;
mod contact_after_coil;
pub(crate) mod cplc_draft;
mod dead_end;
pub mod declaration_fix;
mod dependencies;
mod division_by_zero;
pub(crate) mod double_coil;
mod duplicate_block;
mod duplicate_branch;
pub(crate) mod duplicate_function;
mod duplicate_label;
mod duplicate_timer;
mod endless_jump;
pub(crate) mod flow;
pub(crate) mod follow_ups;
pub(crate) mod foreign_comment;
mod form;
mod frame_keyword;
mod input_written;
mod latched_power;
mod misleading_alignment;
mod misplaced_rail;
pub(crate) mod missing_wire;
pub(crate) mod near_names;
mod never_read;
mod never_written;
mod no_output;
pub(crate) mod one_address;
mod open_wire;
mod order_sensitive;
pub(crate) mod overlapping_address;
pub(crate) mod power_rules;
pub(crate) mod read_before_write;
mod real_equality;
mod recursive_block;
mod recursive_call;
mod redundant_element;
mod result_arrow;
mod return_outside_function;
mod rung_not_powered;
pub(crate) mod set_and_reset;
mod set_without_reset;
mod short_preset;
mod shorted_branch;
pub(crate) mod survey;
pub(crate) mod syntax_errors;
pub(crate) mod tag_summary;
mod type_conflict;
mod unbalanced_loop;
mod unclosed_block;
pub(crate) mod unclosed_comment;
mod unconditional_end;
pub(crate) mod undeclared_tag;
mod unexpected_character;
mod unknown_block;
mod unknown_instruction;
pub(crate) mod unknown_label;
mod unpaired_connector;
mod unreachable;
mod unused_function;
mod unused_label;
pub(crate) mod wiring_walk;
mod wrong_place;
mod wrong_shape;

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Severity;
use crate::findings::rule_settings::RuleSettings;
use crate::names::scope::TagFacts;
use crate::networks::NetworkAt;
use crate::networks::control_flow::ControlFlow;
use form::Form;
use survey::Survey;

type FormCheck = fn(&Form<'_>, &mut Vec<Diagnostic>);

/// The rules that look at a network by itself: its drawing and the form of its blocks.
const OF_FORM: &[FormCheck] = &[
    missing_wire::check,
    misplaced_rail::check,
    unpaired_connector::check,
    misleading_alignment::check,
    unknown_instruction::check,
    unknown_block::check,
    bad_arity::check,
    bad_operand::check,
    wrong_place::check,
    open_wire::check,
    no_output::check,
];

type FileCheck = fn(&Context, &mut Vec<Diagnostic>);

/// Rules that look at the names and definitions of a file.
const OF_FILE: &[FileCheck] = &[
    duplicate_label::check,
    duplicate_function::check,
    unknown_label::check,
    duplicate_block::check,
    recursive_block::check,
    commented_out_rung::check,
    one_address::check,
];

type ProgramCheck = fn(&Context, &Survey<'_>, &mut Vec<Diagnostic>);

/// Rules that need to know what is in the file at all.
const OF_PROGRAM: &[ProgramCheck] = &[
    recursive_call::check,
    return_outside_function::check,
    unbalanced_loop::check,
    unused_function::check,
    unused_label::check,
    flow::check,
];

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
    let enough = format!("{MOST_FINDINGS} findings are enough: what is behind this place is not checked");
    last.help = Some(enough.into());
    // What was not looked at may be wrong: such a program does not run.
    last.severity = Severity::Error;
}

/// Looks at a network by itself: its drawing, and its blocks.
pub(crate) fn of_network(
    context: &Context,
    network: NetworkAt<'_>,
    settings: &RuleSettings,
    out: &mut Vec<Diagnostic>,
) {
    let form = Form::of(context, network);
    for check in OF_FORM {
        check(&form, out);
    }
    survey::of_network(context, network, settings, out);
}

/// Looks at what power does in a network without errors.
pub(crate) fn of_power(survey: &Survey<'_>, network: NetworkAt<'_>, out: &mut Vec<Diagnostic>) {
    wiring_walk::check(survey.context, network, out);
    power_rules::check(survey, network, out);
}

/// Puts into sentences what is wrong with names.
pub(crate) fn of_names(context: &Context, out: &mut Vec<Diagnostic>) {
    for problem in &context.problems {
        out.push(crate::mistakes::of_names::diagnostic(context, problem));
    }
}

/// Looks at the names and definitions of a file.
pub(crate) fn of_file(context: &Context, out: &mut Vec<Diagnostic>) {
    for check in OF_FILE {
        check(context, out);
    }
}

/// What the rules about tags need to know of the rest of the file.
pub(crate) struct AroundTags<'c> {
    context: &'c Context,
    /// What the networks of the file have together of program flow.
    any: ControlFlow,
    leaving: double_coil::Leaving,
    undeclaring: undeclared_tag::Undeclaring<'c>,
    summaries: tag_summary::Summaries,
}

impl<'c> AroundTags<'c> {
    /// `any` is what the networks of the file have together of program flow.
    pub(crate) fn of(context: &'c Context, any: ControlFlow) -> AroundTags<'c> {
        AroundTags {
            context,
            any,
            leaving: double_coil::Leaving::of(context, any),
            undeclaring: undeclared_tag::Undeclaring::of(context),
            summaries: tag_summary::Summaries::of(context),
        }
    }
}

/// Looks at the places of one tag.
pub(crate) fn of_tag((scope, tag): (usize, &TagFacts), around: &AroundTags<'_>, out: &mut Vec<Diagnostic>) {
    let context = around.context;
    undeclared_tag::check(scope, tag, &around.undeclaring, out);
    type_conflict::check(context, tag, out);
    duplicate_timer::check(context, tag, out);
    double_coil::check(context, tag, &around.leaving, out);
    tag_summary::check(context, (scope, tag), &around.summaries, out);
    set_and_reset::check(context, around.any, tag, out);
}

/// Looks at the program as a whole.
pub(crate) fn of_program(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    for check in OF_PROGRAM {
        check(survey.context, survey, out);
    }
    read_before_write::check(survey, out);
    overlapping_address::check(survey.context, out);
}
