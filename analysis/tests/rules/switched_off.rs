//! Severities that are set, and comments that switch rules off.

use expect_test::{Expect, expect};
use ladder_analysis::{Analysis, AnalyzeOptions, Level, Others, Rule, RuleSettings, Severity, analyze};
use ladder_syntax::parse;
use std::fmt::Write;
use std::sync::Arc;

const TWICE: &str = "+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+\n";

fn analysed(text: &str, levels: &[(Rule, Level)]) -> Analysis {
    let mut settings = RuleSettings::default();
    for &(rule, level) in levels {
        settings.set(rule, level);
    }
    analyze(
        &Arc::new(parse(text)),
        AnalyzeOptions::new("a")
            .among(&Others::default())
            .with_rules(&settings),
    )
}

fn check(text: &str, levels: &[(Rule, Level)], expected: Expect) {
    let analysis = analysed(text, levels);
    let mut out = String::new();
    for found in analysis.diagnostics() {
        let place = &text[usize::from(found.range.start())..usize::from(found.range.end())];
        let line = text[..usize::from(found.range.start())].matches('\n').count() + 1;
        let severity = found.severity.name();
        writeln!(
            out,
            "{line} {severity} {}: {} <{place}>",
            found.rule, found.message
        )
        .unwrap();
    }
    if analysis.program().is_none() {
        writeln!(out, "does not run").unwrap();
    }
    expected.assert_eq(&out);
}

#[test]
fn severities_are_those_that_are_set() {
    let twice = |level, expected| {
        check(
            TWICE,
            &[(
                ladder_analysis::rules::rule_named("double-coil").expect("a rule"),
                level,
            )],
            expected,
        );
    };
    twice(
        Level::Shown(Severity::Info),
        expect![[r#"
        2 info double-coil: `y` is written by 2 coils: the last one alone decides <y>
    "#]],
    );
    // A program with errors is not simulated, whatever made the finding an error.
    twice(
        Level::Shown(Severity::Error),
        expect![[r#"
        2 error double-coil: `y` is written by 2 coils: the last one alone decides <y>
        does not run
    "#]],
    );
    twice(Level::Off, expect![[r#""#]]);
}

#[test]
fn an_error_that_is_hidden_still_keeps_the_program_from_running() {
    let text = "+--[TOM]( t )--( )( y )--+\n";
    check(
        text,
        &[(
            ladder_analysis::rules::rule_named("unknown-instruction").expect("a rule"),
            Level::Off,
        )],
        expect![[r#"
        does not run
    "#]],
    );
    let analysis = analysed(
        text,
        &[(
            ladder_analysis::rules::rule_named("unknown-instruction").expect("a rule"),
            Level::Off,
        )],
    );
    let errors: Vec<_> = analysis.errors().map(|error| error.rule).collect();
    assert_eq!(
        errors,
        [ladder_analysis::rules::rule_named("unknown-instruction").expect("a rule")]
    );
}

#[test]
fn a_comment_speaks_of_what_is_next() {
    // The finding is at the second coil.
    check(
        "+--[ ]( a )--( )( y )--+\n\n# ladder: allow(double-coil): two modes #\n\n+--[ ]( b )--( )( y )--+\n",
        &[],
        expect![[r#""#]],
    );
    check(
        "# ladder: allow(double-coil): two modes #\n+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+\n",
        &[],
        expect![[r#"
            1 info suppression-unused: `double-coil` finds nothing here that could be switched off <# ladder: allow(double-coil): two modes #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+  # ladder: allow(double-coil): two modes #\n",
        &[],
        expect![[r#""#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n+--[ ]( b )--( )( y )--+\n# ladder: allow-file(double-coil): two modes #\n",
        &[],
        expect![[r#""#]],
    );
}

#[test]
fn comments_that_the_tools_do_not_understand() {
    for (comment, expected) in [
        (
            "allow(duble-coil): why",
            expect![[r#"
            1 warning bad-directive: there is no rule `duble-coil` <# ladder: allow(duble-coil): why #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "allow(double-coil)",
            expect![[r#"
            1 warning bad-directive: this comment does not say why a rule is switched off <# ladder: allow(double-coil) #>
            1 info suppression-unused: `double-coil` finds nothing here that could be switched off <# ladder: allow(double-coil) #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "allow double-coil",
            expect![[r#"
            1 warning bad-directive: the rules to switch off belong in parentheses <# ladder: allow double-coil #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "alow(double-coil): why",
            expect![[r#"
            1 warning bad-directive: `alow` is nothing that a comment can ask for <# ladder: alow(double-coil): why #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "fmt of",
            expect![[r#"
            1 warning bad-directive: `fmt` is followed by `on` or `off` <# ladder: fmt of #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "profile click",
            expect![[r#"
                3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
            "#]],
        ),
        (
            "profile s7",
            expect![[r#"
            1 warning bad-directive: there is no profile `s7` <# ladder: profile s7 #>
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
        (
            "profile iec #\n# ladder: cycle 5ms #  # ladder: profile click #\n\n# ladder: cycle 5ms",
            expect![[r#"
                2 warning bad-directive: `profile` is on line 1 already, and the first one counts: this changes nothing <# ladder: profile click #>
                4 warning bad-directive: `cycle` is on line 2 already, and the first one counts: this changes nothing <# ladder: cycle 5ms #>
                6 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
            "#]],
        ),
        (
            "profile iec",
            expect![[r#"
            3 warning double-coil: `y` is written by 2 coils: the last one alone decides <y>
        "#]],
        ),
    ] {
        check(&format!("# ladder: {comment} #\n{TWICE}"), &[], expected);
    }
}

/// What speaks of the whole file counts above its first network, and once.
#[test]
fn comments_that_come_too_late() {
    let text = "VAR a : BOOL; END_VAR\n# ladder: profile iec #\n# before # +--[ ]( a )--( )( b )--+ # ladder: profile click #\n\n\
                # ladder: cycle 5ms #\n+--[ ]( a )--( )( y )--+\n|  # ladder: profile iec #\n\n\
                FUNCTION_BLOCK [$B]\n# ladder: profile iot #\n+--[ ]( EN )--+\nEND_FUNCTION_BLOCK\n";
    check(
        text,
        &[],
        expect![[r#"
            3 warning undeclared-tag: `b` is not declared <b>
            3 warning bad-directive: `profile` counts above the first network only: here it changes nothing <# ladder: profile click #>
            5 warning bad-directive: `cycle` counts above the first network only: here it changes nothing <# ladder: cycle 5ms #>
            6 warning undeclared-tag: `y` is not declared <y>
            7 warning bad-directive: `profile` counts above the first network only: here it changes nothing <# ladder: profile iec #>
            10 warning bad-directive: `profile` counts above the first network only: here it changes nothing <# ladder: profile iot #>
            11 warning no-output: this network does nothing: no block in it acts <+--[ ]( EN )--+>
        "#]],
    );
}

#[test]
fn a_comment_that_hides_nothing_is_reported_and_can_be_removed() {
    let text = "# ladder: allow(double-coil, never-read): why #\n+--[ ]( a )--( )( y )--+\n";
    check(
        text,
        &[],
        expect![[r#"
        1 info suppression-unused: `double-coil`, `never-read` find nothing here that could be switched off <# ladder: allow(double-coil, never-read): why #>
    "#]],
    );
    let analysis = analysed(text, &[]);
    let fix = &analysis.diagnostics()[0].fixes[0];
    assert_eq!(
        ladder_format::apply(text, &fix.edits),
        "+--[ ]( a )--( )( y )--+\n"
    );
}

#[test]
fn a_comment_that_hides_what_is_not_looked_for_is_no_finding() {
    let text = |last: &str| {
        format!(
            "# ladder: allow-file(unused-label): later #\n\
             VAR_OUTPUT out, other : BOOL; END_VAR\n\
             VAR debug : BOOL; END_VAR\n\
             # ladder: allow(never-written, double-coil): for the panel #\n\
             +--[ ]( debug )--( )( other )--+\n\
             {last}\n"
        )
    };
    let found = |last: &str| {
        let analysis = analysed(&text(last), &[]);
        let rules = analysis.diagnostics().iter().map(|found| found.rule.name());
        rules.collect::<Vec<_>>()
    };
    assert_eq!(
        found("+--[ ]( I2 )--( )( out )--+"),
        ["suppression-unused", "suppression-unused"]
    );
    // Which of the two it is about: `double-coil` does not wait for the error to go.
    assert_eq!(
        found("+--[ ]( I2 )--( )("),
        ["suppression-unused", "unclosed-block"]
    );
}

/// Two blocks on one timer have a meaning, so a comment that allows them lets the program run, and a setting does not.
#[test]
fn blocks_that_share_a_state_on_purpose() {
    let text = |first: &str, second: &str| {
        format!(
            "{first}+--[ ]( a )--[TON]( t, 5s )--[CTU]( c, 3 )--( )( y )--+\n{second}+--[ ]( b )--[TON]( t, 2s )--[CTU]( c, 2, R := a )--( )( z )--+\n"
        )
    };
    check(
        &text(
            "",
            "# ladder: allow(duplicate-timer, duplicate-counter): one instance #\n",
        ),
        &[],
        expect![[r#""#]],
    );
    check(
        &text("# ladder: allow-file(duplicate-timer): one instance #\n", ""),
        &[],
        expect![[r#"
            3 error duplicate-counter: the counter `c` has a second block: both would work on one CTU <c>
            does not run
        "#]],
    );
    let rule = |name| ladder_analysis::rules::rule_named(name).expect("a rule");
    check(
        &text("", "# ladder: allow(duplicate-counter): one instance #\n"),
        &[(rule("duplicate-timer"), Level::Shown(Severity::Warning))],
        expect![[r#"
            3 warning duplicate-timer: the timer `t` has a second block: both would work on one TON <t>
            does not run
        "#]],
    );
}
