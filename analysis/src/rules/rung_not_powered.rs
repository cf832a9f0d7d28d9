//! `rung-not-powered`: a rung begins with `|--` where `+--` takes power from the left rail.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use ladder_syntax::TextRange;

/// `range` is the stretch without power, as open-wire would show it.
pub(super) fn found(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        Rule::RungNotPowered,
        range,
        "this rung gets no power: it begins with `|`, which is decoration; `+` takes power from the left rail",
    )
    .help("begin the line with `+`")
}
