//! What only follows from a slip is left out alike, whether findings are kept by network or all gone through: a comment
//! that speaks to the tools makes the difference.

use crate::incremental::{asked, edited, settings};
use ladder_analysis::{Others, RuleSettings, analyze_with};
use ladder_syntax::parse;
use ladder_tests::generator::{Dice, Mode, program};
use std::sync::Arc;

/// What is found in a text with a comment behind it, and how much of it is an error that settings hide.
fn said(text: &str, comment: &str, settings: &RuleSettings) -> (String, usize, usize) {
    let parsed = Arc::new(parse(&format!("{text}\n{comment}\n")));
    let analysis = analyze_with(&parsed, "main", &Others::default(), settings);
    let found = format!("{:#?}", analysis.diagnostics());
    (found, analysis.count(), analysis.hidden_errors().len())
}

/// Has all findings of a text gone through in one of two analyses, and compares them.
fn compare(text: &str, settings: &RuleSettings) {
    // The comment behind it would close one.
    if parse(text).unclosed_comment().is_some() {
        return;
    }
    let kept = said(text, "# says nothing here! #", settings);
    let gone_through = said(text, "# ladder: fmt on     #", settings);
    assert_eq!(kept, gone_through, "{text}");
}

#[test]
fn of_generated_programs_with_slips() {
    for mode in [Mode::Sensible, Mode::Wild] {
        for seed in 0..asked(40) {
            let mut dice = Dice::new(seed);
            let original = program(seed, mode);
            let settings = settings(&mut dice);
            for _ in 0..10 {
                compare(&edited(&original, &mut dice), &settings);
            }
        }
    }
}

/// A slip of each kind, in a program with findings that follow from it and others that do not.
#[test]
fn of_each_kind_of_slip() {
    let program = |declared: &str, drawn: &str, defined: &str| {
        format!(
            "VAR\n    a, b, c : BOOL;\n    n : INT;\n{declared}END_VAR\n\n\
             +--[ ]( a )--[/]( a )--( )( b )--+\n\n{drawn}\n\n+--[ ]( b )--( )( c )--[ ]( a )--( )( lamp )--+\n\n\
             +--[ ]( c )--[$PUMP]( a )--( )( c )--+\n\n+--[ ]( c )--<JMP>( there )--+\n\n+--[ ]( c )--<CALL>( here )--+\n\n\
             +--[ ]( list.Q )--[TON]( n, T#5s )--[MOV]( list, n )--( )( c )--+\n{defined}"
        )
    };
    let texts = [
        program("", "", ""),
        program("    lamp\n", "", ""),
        program("    lamp = BOOL;\n", "", ""),
        program("    list : TONN;\n    lamp : BOOL;\n", "", ""),
        program("", "+--[ ]( a )--[/]( a )--( )( b --+", ""),
        program("", "+--<LBL>( there --( )( a )--+", ""),
        program("", "+--<LBL>( )--( )( a )--+", ""),
        program("", "+--<FUN>( 5 )--( )( a )--+", ""),
        program("", "FUNCTION_BLOK [$PUMP]", ""),
        program("", "VAR_OUTPT\n    lamp : BOOL;\nEND_VAR", ""),
        program("", "+--[PUMP]( list, a )--( )( a )--+", ""),
        program(
            "",
            "",
            "\nFUNCTION_BLOCK [$PUMP\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        ),
        program("", "", "\nFUNCTION_BLOCK [$PUMP]\n+--[ ]( EN )--( )( ENO )--+\n"),
        program("", "", "\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n"),
        program("", "// +--[ ]( d )--( )( d )--+", ""),
        program("", "# +--[ ]( d )--( )( d )--+", ""),
    ];
    for text in texts {
        for settings in [RuleSettings::default(), RuleSettings::everything()] {
            compare(&text, &settings);
        }
    }
}
