//! The rules, one file each: what they find, their sentences and their fixes.
//!
//! Rules about names and types are found while the program is resolved; their files hold the constructors that
//! the resolver calls. All others have a `check` over the [`Context`].

pub(crate) mod bad_arity;
pub(crate) mod bad_declaration;
pub(crate) mod bad_operand;
pub(crate) mod constant_write;
pub(crate) mod did_you_mean;
pub(crate) mod duplicate_declaration;
pub(crate) mod type_mismatch;
pub(crate) mod undeclared_tag;
pub(crate) mod unknown_function;
pub(crate) mod unknown_label;
pub(crate) mod unknown_member;

use crate::context::Context;
use crate::diagnostic::Diagnostic;

type Check = fn(&Context, &mut Vec<Diagnostic>);

/// Every rule that looks at the whole context.
const CHECKS: &[Check] = &[];

/// Runs them.
pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for check in CHECKS {
        check(context, out);
    }
}
