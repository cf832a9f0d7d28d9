//! The rules, one file each: what they find, their sentences and their fixes.
//!
//! Rules about names and types are found while the program is resolved; their files hold the constructors that
//! the resolver calls. All others have a `check` over the [`Context`].

pub(crate) mod bad_arity;
pub(crate) mod bad_declaration;
pub(crate) mod bad_literal;
pub(crate) mod bad_operand;
pub(crate) mod constant_write;
pub(crate) mod did_you_mean;
mod double_coil;
mod duplicate_block;
pub(crate) mod duplicate_declaration;
pub(crate) mod duplicate_function;
mod duplicate_label;
mod duplicate_timer;
mod follow_ups;
mod frame_keyword;
mod misleading_alignment;
mod misplaced_rail;
pub(crate) mod missing_wire;
mod near_names;
mod no_output;
mod open_wire;
mod recursive_block;
pub(crate) mod shared_globals;
pub(crate) mod syntax_errors;
pub(crate) mod type_mismatch;
mod unclosed_block;
pub(crate) mod unclosed_comment;
mod undeclared_tag;
mod unexpected_character;
mod unknown_block;
pub(crate) mod unknown_function;
mod unknown_instruction;
pub(crate) mod unknown_label;
pub(crate) mod unknown_member;
mod unpaired_connector;
mod wrong_place;
mod wrong_shape;

use crate::context::Context;
use crate::diagnostic::Diagnostic;

type Check = fn(&Context, &mut Vec<Diagnostic>);

/// Every rule that looks at the whole context.
const CHECKS: &[Check] = &[
    missing_wire::check,
    misplaced_rail::check,
    unpaired_connector::check,
    misleading_alignment::check,
    unknown_instruction::check,
    bad_arity::check,
    bad_operand::check,
    undeclared_tag::check,
    duplicate_timer::check,
    duplicate_label::check,
    duplicate_function::check,
    unknown_label::check,
    unknown_block::check,
    duplicate_block::check,
    recursive_block::check,
    wrong_place::check,
    open_wire::check,
    no_output::check,
    double_coil::check,
];

/// Runs them.
pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for check in CHECKS {
        check(context, out);
    }
    follow_ups::remove(context, out);
    syntax_errors::check(context, out);
}
