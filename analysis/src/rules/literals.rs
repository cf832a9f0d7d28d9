//! A value that does not fit its place: `bad-literal`, `literal-out-of-range`, `type-mismatch`, and `bad-declaration` for an
//! initial value.

use crate::findings::diagnostic::Diagnostic;
use crate::written::constant::{ConstantFault, ConstantProblem};

/// The finding about a value.
pub(crate) fn diagnostic(problem: &ConstantProblem) -> Diagnostic {
    let rule = match problem.fault {
        ConstantFault::Malformed => super::bad_literal::RULE,
        ConstantFault::OutOfRange => super::literal_out_of_range::RULE,
        ConstantFault::OtherType => super::type_mismatch::RULE,
        ConstantFault::NotInitial => super::bad_declaration::RULE,
    };
    Diagnostic::new(rule, problem.range, &problem.message)
}
