//! `duplicate-function` where it matters: a call of a function that several other files define.

use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use ladder_syntax::{Name, TextRange};

/// A `<CALL>` of a function that the file does not have, and several others do.
pub(crate) fn of_several_files(context: &Context, name: &str, range: TextRange) -> Option<Diagnostic> {
    let key = Name::new(name);
    context.others.functions(&key).nth(1)?;
    let mut found = Diagnostic::new(
        Rule::DuplicateFunction,
        range,
        format!("several files define the function `{name}`: which one is called here is open"),
    )
    .help("rename all but one of them, or define the function in this file");
    for (file, function) in context.others.functions(&key) {
        found = found.related_in(&file.file, function.at, "it is defined here");
    }
    Some(found)
}
