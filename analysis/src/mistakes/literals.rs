//! A value that does not fit its place: `bad-literal`, `literal-out-of-range`, `type-mismatch`, and `bad-declaration` for an
//! initial value.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::values::constant::{ConstantFault, ConstantProblem};

/// The finding about a value.
pub(crate) fn diagnostic(problem: &ConstantProblem) -> Diagnostic {
    let rule = match problem.fault {
        ConstantFault::Malformed => Rule::BadLiteral,
        ConstantFault::OutOfRange => Rule::LiteralOutOfRange,
        ConstantFault::OtherType => Rule::TypeMismatch,
        ConstantFault::NotInitial => Rule::BadDeclaration,
    };
    Diagnostic::new(rule, problem.range, &problem.message)
}
