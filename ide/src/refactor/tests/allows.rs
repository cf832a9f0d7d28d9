//! Comments that switch a rule off, written where a finding is meant so.

use crate::refactor::quick_fixes;
use expect_test::{Expect, expect};
use ladder_analysis::{Analysis, Rule, analyze, rules};
use ladder_format::{Options, apply};
use ladder_syntax::parse;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

fn analysis(text: &str) -> Analysis {
    analyze(&Arc::new(parse(text)), "test.clad")
}

/// The texts after each of the comments that are offered for the findings of a rule, with their titles.
fn allowed(rule: Rule, text: &str) -> Vec<(String, String)> {
    let analysis = analysis(text);
    let of_rule = analysis.findings().iter().filter(|found| found.rule == rule);
    let offered = of_rule.flat_map(|found| quick_fixes(&analysis, found.range));
    let title = format!("Allow `{}`", rule.name());
    let allowing = offered.filter(|action| action.title.starts_with(&title));
    let after = allowing.map(|action| {
        let edits = action.aligned(&analysis, text, &Options::default());
        (action.title.clone(), apply(text, &edits))
    });
    after.collect()
}

#[track_caller]
fn check(rule: &str, text: &str, expected: Expect) {
    let rule = rules::rule_named(rule).expect("a rule of this name");
    let mut shown = String::new();
    for (title, after) in allowed(rule, text) {
        let is_crlf = text.contains("\r\n");
        assert!(!is_crlf || !after.replace("\r\n", "").contains('\n'), "{after:?}");
        let _ = writeln!(shown, "> {title}\n{}", after.replace("\r\n", "\n"));
    }
    expected.assert_eq(&shown);
}

#[test]
fn where_the_comment_is() {
    check(
        "double-coil",
        "# mixer #\n+--[ ]( a )--( )( y )--+\n\n# by hand #\n+--\\--[ ]( b )--\\--( )( y )--+\n|  /--[ ]( c )--/            |\n",
        expect![[r#"
            > Allow `double-coil` here, with a reason
            # mixer #
            +--[ ]( a )--( )( y )--+

            # by hand #
            # ladder: allow(double-coil): reason #
            +--\--[ ]( b )--\--( )( y )--+
            |  /--[ ]( c )--/            |

            > Allow `double-coil` in this file, with a reason
            # ladder: allow-file(double-coil): reason #
            # mixer #
            +--[ ]( a )--( )( y )--+

            # by hand #
            +--\--[ ]( b )--\--( )( y )--+
            |  /--[ ]( c )--/            |

        "#]],
    );
    check(
        "never-read",
        "\u{feff}VAR\r\n    a, b, c, y : BOOL;\r\nEND_VAR\r\n\r\n+--[ ]( a )--( )( b )--+\r\n\r\n+--[ ]( a )--( )( y )--+\r\n",
        expect![[r#"
            > Allow `never-read` here, with a reason
            ﻿# ladder: allow(never-read): reason #
            VAR
                a, b, c, y : BOOL;
            END_VAR

            +--[ ]( a )--( )( b )--+

            +--[ ]( a )--( )( y )--+

            > Allow `never-read` in this file, with a reason
            ﻿# ladder: allow-file(never-read): reason #
            VAR
                a, b, c, y : BOOL;
            END_VAR

            +--[ ]( a )--( )( b )--+

            +--[ ]( a )--( )( y )--+

        "#]],
    );
    // The program does not run with a hidden error either.
    check(
        "type-mismatch",
        "VAR n : INT; END_VAR\n+--[ ]( n )--( )( y )--+\n",
        expect![""],
    );
}

/// On the wrong programs of the book each comment hides what it is for, and is itself in order.
#[test]
fn a_comment_hides_its_finding() {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/src/rules");
    let mut tried = 0;
    for &rule in rules::ALL.iter().filter(|rule| rule.may_be_allowed()) {
        let page = std::fs::read_to_string(pages.join(format!("{rule}.md"))).expect("each rule has its page");
        let wrong = page.split("```clad wrong\n").skip(1);
        for program in wrong.filter_map(|rest| rest.split("```").next()) {
            let count = |text: &str, rule: &str| {
                let analysis = analysis(text);
                let found = analysis.findings().iter();
                found.filter(|found| found.rule.name() == rule).count()
            };
            for (title, after) in allowed(rule, program) {
                tried += 1;
                let left = (count(program, rule.name()), count(&after, rule.name()));
                assert!(left.1 < left.0, "{title}\n{after}");
                for about in ["suppression-unused", "bad-directive"] {
                    assert!(count(&after, about) <= count(program, about), "{title}\n{after}");
                }
            }
        }
    }
    assert!(tried > 40, "{tried}");
}
