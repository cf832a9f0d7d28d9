//! `unknown-type`: the type of a declaration is one that nobody declares.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "unknown-type", Severity::Error).fixed(Applicability::Unsafe));

pub(crate) fn unknown(name: &str, near: Option<&str>, range: TextRange) -> Diagnostic {
    let found = |message: String| Diagnostic::new(RULE, range, message);
    if name.starts_with('$') {
        return found(format!("there is no block {name} whose state this could be")).help(format!(
            "correct the name, or define it: FUNCTION_BLOCK [{name}], its declarations and rungs, END_FUNCTION_BLOCK"
        ));
    }
    match near {
        Some(near) => found(format!("there is no type `{name}`: did you mean {near}?")).fix(
            Applicability::Unsafe,
            format!("Replace with {near}"),
            range,
            near,
        ),
        None => found(format!("there is no type `{name}`")).help(format!(
            "the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others; declare one of your own in TYPE {name} : \
             .. END_TYPE"
        )),
    }
}
