//! Rungs that most programs begin with, for an empty line.

use super::item::{CompletionKind, Snippet, Topic};
use super::proposals::Proposals;

/// The word that it is found by, what it is, and its text: what is in braces is a place to write at; one that comes again is the
/// same there.
const DRAWINGS: [(&str, &str, &str); 7] = [
    (
        "rung",
        "a contact and a coil",
        "+--[ ]( {start} )----------------------------------------------------( )( {run} )--+",
    ),
    (
        "branch",
        "either of two contacts",
        "\
+--\\--[ ]( {here} )---\\----------------------------------------------( )( {run} )--+
|  /--[ ]( {there} )--/                                                          |",
    ),
    (
        "seal-in",
        "start, held until stop",
        "\
+--\\--[ ]( {start} )--\\--[/]( {stop} )---------------------------------( )( {run} )--+
|  /--[ ]( {run} )----/                                                          |",
    ),
    (
        "timer",
        "a coil that follows its contact after a time",
        "+--[ ]( {start} )------------------------------[TON]( {delay}, {T#5s} )--( )( {run} )--+",
    ),
    (
        "counter",
        "counts up at every press, until it is reset",
        "+--[ ]( {press} )-------------------[CTU]( {count}, {10}, R := {reset} )--( )( {full} )--+",
    ),
    (
        "function",
        "networks that are run where they are called",
        "\
+--[ ]( {start} )------------------------------------------------<CALL>( {Task} )--+

+--<FUN>( {Task} )--[ ]( {sensor} )-----------------------------------( )( {lamp} )--+
+-----------------------------------------------------------------------<RET>--+",
    ),
    (
        "block",
        "a block of your own, and a rung that uses it",
        "\
FUNCTION_BLOCK [${Debounce}]
VAR_INPUT
    {raw}  : BOOL;
    {wait} : TIME;
END_VAR
VAR_OUTPUT
    {clean} : BOOL;
END_VAR
VAR
    t : TON;
END_VAR
+--[ ]( EN )--[ ]( {raw} )-----------[TON]( t, {wait} )--( )( {clean} )--( )( ENO )--+
END_FUNCTION_BLOCK

+------------------------[${Debounce}]( {button}, {T#20ms}, {pressed} )--( )( {light} )--+",
    ),
];

pub(super) fn propose(out: &mut Proposals<'_>, in_block: bool) {
    for (word, detail, text) in DRAWINGS {
        if in_block && text.starts_with("FUNCTION_BLOCK") {
            continue;
        }
        let kind = CompletionKind::Drawing;
        out.snippet((2, 0), kind, word, detail, snippet(text), Topic::Nothing);
    }
}

fn snippet(text: &str) -> Snippet {
    let mut parts = text.split(['{', '}']);
    let mut snippet = Snippet::default().text(parts.next().unwrap_or_default());
    while let (Some(stop), Some(text)) = (parts.next(), parts.next()) {
        snippet = snippet.stop_again(stop).text(text);
    }
    snippet.end()
}

#[cfg(test)]
mod tests {
    use super::{DRAWINGS, snippet};
    use expect_test::expect;
    use ladder_analysis::{Severity, analyze};
    use ladder_format::{Options, format_text};
    use std::sync::Arc;

    #[test]
    fn as_they_come_they_are_programs_without_warnings_in_the_canonical_layout() {
        for (word, _, text) in DRAWINGS {
            let program = snippet(text).plain() + "\n";
            assert_eq!(format_text(&program, &Options::default()), program, "{word}");
            let parse = Arc::new(ladder_syntax::parse(&program));
            for finding in analyze(&parse, "program").diagnostics() {
                assert!(finding.severity == Severity::Info, "{word}: {}", finding.message);
            }
        }
    }

    #[test]
    fn a_place_that_comes_again_is_the_same_place() {
        let seal_in = snippet(DRAWINGS[2].2).snippet();
        expect![[r#"
            +--\\--[ ]( ${1:start} )--\\--[/]( ${2:stop} )---------------------------------( )( ${3:run} )--+
            |  /--[ ]( ${3:run} )----/                                                          |$0"#]]
        .assert_eq(&seal_in);
    }
}
