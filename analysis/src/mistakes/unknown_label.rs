//! `unknown-label`: a `<JMP>` goes to a label that its program or function does not have. `rules/unknown_label.rs` looks at
//! jumps out of blocks.

use crate::context::Context;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Rule;
use crate::names::did_you_mean;
use ladder_syntax::{Name, TextRange};

pub(crate) fn unknown(context: &Context, network: usize, name: &str, range: TextRange) -> Diagnostic {
    let body = context.bodies[network];
    let found = Diagnostic::new(
        Rule::UnknownLabel,
        range,
        format!("there is no label `{name}` to jump to"),
    );
    let seen = context
        .labels
        .iter()
        .filter(|label| context.bodies[label.network] == body);
    if let Some(near) = did_you_mean::closest(name, seen.map(|label| label.name.as_str())) {
        return found.help(format!("did you mean `{near}`?")).fix(
            Applicability::Unsafe,
            format!("Jump to `{near}`"),
            range,
            near,
        );
    }
    let key = Name::new(name);
    match context.labels.iter().find(|label| label.key == key) {
        Some(elsewhere) => found
            .help("a jump stays in its own program or function: put a label there, or use <CALL>")
            .related(
                elsewhere.at,
                "the label of this name belongs to another function or block",
            ),
        None => found.help(format!("mark the network with <LBL>( {name} )")),
    }
}
