//! The rules, one file each: what they find, their sentences and their fixes.
//!
//! Rules about names and types are found while the program is resolved; their files hold the constructors that
//! the resolver calls. All others have a `check` over the [`Context`].

mod alternative_mnemonic;
mod ambiguous_sign;
pub(crate) mod bad_arity;
pub(crate) mod bad_declaration;
pub(crate) mod bad_literal;
pub(crate) mod bad_operand;
mod bypassed;
mod circles;
mod commented_out_rung;
mod complex_network;
mod constant_power;
pub(crate) mod constant_write;
mod contact_after_coil;
pub(crate) mod cplc_draft;
mod dead_end;
pub(crate) mod did_you_mean;
mod division_by_zero;
mod double_coil;
mod duplicate_block;
mod duplicate_branch;
pub(crate) mod duplicate_declaration;
pub(crate) mod duplicate_function;
mod duplicate_label;
mod duplicate_timer;
mod endless_jump;
mod flow;
mod follow_ups;
mod foreign_comment;
mod frame_keyword;
mod input_written;
mod latched_power;
mod misleading_alignment;
mod misplaced_rail;
pub(crate) mod missing_wire;
mod near_names;
mod never_read;
mod never_written;
mod no_output;
mod open_wire;
mod order_sensitive;
mod overlapping_address;
mod power_rules;
mod read_before_write;
mod real_equality;
mod recursive_block;
mod recursive_call;
mod redundant_element;
mod result_arrow;
mod return_outside_function;
mod rung_not_powered;
mod set_and_reset;
mod set_without_reset;
pub(crate) mod shared_globals;
mod short_preset;
mod shorted_branch;
mod survey;
pub(crate) mod syntax_errors;
mod tag_summary;
pub(crate) mod type_mismatch;
mod unbalanced_loop;
mod unclosed_block;
pub(crate) mod unclosed_comment;
mod unconditional_end;
pub(crate) mod undeclared_tag;
mod unexpected_character;
mod unknown_block;
pub(crate) mod unknown_function;
mod unknown_instruction;
pub(crate) mod unknown_label;
pub(crate) mod unknown_member;
mod unpaired_connector;
mod unreachable;
mod unused_function;
mod unused_label;
mod wiring_walk;
mod wrong_place;
mod wrong_shape;

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::networks::NetworkAt;
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::verdict::{self, Pass};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use survey::Survey;

type NetworkCheck = fn(&Context, NetworkAt<'_>, &mut Vec<Diagnostic>);

/// The rules that look at a network by itself: its drawing and the form of its blocks.
const OF_NETWORKS: &[NetworkCheck] = &[
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

type Check = fn(&Context, &mut Vec<Diagnostic>);

/// Every rule that looks at the whole context.
const CHECKS: &[Check] = &[
    undeclared_tag::check,
    duplicate_timer::check,
    duplicate_label::check,
    duplicate_function::check,
    unknown_label::check,
    duplicate_block::check,
    recursive_block::check,
    double_coil::check,
    overlapping_address::check,
    commented_out_rung::check,
];

type SurveyedCheck = fn(&Context, &Survey, &mut Vec<Diagnostic>);

/// Those that need to know what is in the file at all.
const SURVEYED: &[SurveyedCheck] = &[
    flow::check,
    set_and_reset::check,
    read_before_write::check,
    return_outside_function::check,
    unbalanced_loop::check,
    unused_function::check,
    unused_label::check,
];

/// Once so much was found in a file, no more is looked for in single networks and lines: nobody reads it, and each
/// finding takes a hundred times the memory of the character that it is about.
const MOST_FINDINGS: usize = 50_000;

/// Whether enough was found since there were `before` findings; then the last of them says so.
fn is_enough(before: usize, out: &mut [Diagnostic]) -> bool {
    if out.len() - before < MOST_FINDINGS {
        return false;
    }
    if let Some(last) = out.last_mut() {
        last.help = Some(format!(
            "{MOST_FINDINGS} findings are enough: what stands behind this place is not checked"
        ));
        // What was not looked at may be wrong: such a program does not run.
        last.severity = Severity::Error;
    }
    true
}

/// Looks at each network by itself.
fn of_networks(context: &Context, out: &mut Vec<Diagnostic>) {
    let before = out.len();
    for network in &context.networks {
        if is_enough(before, out) {
            return;
        }
        let look = |out: &mut Vec<Diagnostic>| {
            for check in OF_NETWORKS {
                check(context, network, out);
            }
        };
        // Elsewhere what surrounds the network, or another file, has a say.
        if network.names_tags_only && !network.broken {
            let mut hasher = FxHasher::default();
            (context.profile, context.signatures, network.scope).hash(&mut hasher);
            verdict::once(Pass::Form, hasher.finish(), network, out, look);
        } else {
            look(out);
        }
    }
}

/// Runs them.
/// `stamps` are those of the networks' tags.
pub(crate) fn check(context: &Context, stamps: &[u64], settings: &RuleSettings, out: &mut Vec<Diagnostic>) {
    of_networks(context, out);
    for check in CHECKS {
        check(context, out);
    }
    let survey = survey::survey(context, stamps, settings, out);
    tag_summary::check(context, &survey, out);
    recursive_call::check(context, &survey, out);
    wiring_walk::check(context, &survey, stamps, out);
    power_rules::check(context, &survey, stamps, out);
    for check in SURVEYED {
        check(context, &survey, out);
    }
    if settings.is_on(Rule::ComplexNetwork) {
        complex_network::check(context, out);
    }
    follow_ups::remove(context, out);
    foreign_comment::check(context, out);
    syntax_errors::check(context, out);
}
