//! `duplicate-function`: a function is defined twice in a file. Calls of one that several other files define are found
//! while operands are resolved.

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use rustc_hash::FxHashMap;

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut first = FxHashMap::default();
    for function in &context.functions {
        match first.get(&function.key) {
            None => {
                first.insert(&function.key, function);
            }
            Some(before) => out.push(
                Diagnostic::new(
                    Rule::DuplicateFunction,
                    function.at,
                    format!("the function `{}` is defined twice", function.name),
                )
                .help("remove one of the functions, or give one of them another name")
                .related(before.at, format!("`{}` is first defined here", before.name)),
            ),
        }
    }
}
