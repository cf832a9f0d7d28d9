//! Whether two programs do the same, as wholes.

use crate::harness::outline;
use expect_test::{Expect, expect};
use ladder_analysis::Cancel;
use ladder_review::whole::{Whole, told};
use ladder_review::{Limits, compare};
use std::time::Duration;

/// What is reported about two programs.
fn answer(old: &str, new: &str) -> String {
    let (old, new) = (outline(old), outline(new));
    let mut comparison = compare(&old, &new);
    comparison.decide(Duration::from_secs(20), &Cancel::default());
    comparison.decide_whole(Limits::default(), usize::MAX);
    match comparison.whole {
        Some(Whole::Same) => "the same\n".to_owned(),
        Some(Whole::Differs(run)) => {
            let (told, rows) = told(&run);
            format!("{told}\n{}\n", rows.join("\n"))
        }
        Some(Whole::Outputs(names) | Whole::NotDecided(names)) => names.join("\n") + "\n",
        Some(Whole::Refuted) | None => "nothing is known\n".to_owned(),
    }
}

fn check(old: &str, new: &str, expected: Expect) {
    expected.assert_eq(&answer(old, new));
}

/// Two networks, in either order.
fn swapped(declarations: &str, first: &str, second: &str) -> [String; 2] {
    [(first, second), (second, first)].map(|(one, other)| format!("{declarations}\n{one}\n\n{other}\n"))
}

const TAGS: &str = "\
VAR_INPUT
    a, b : BOOL;
    i    : DINT;
END_VAR
VAR_OUTPUT
    x, y : BOOL;
    n    : DINT;
END_VAR
VAR
    list  : ARRAY[0..3] OF DINT;
    texts : STRING[8];
    t     : TON;
END_VAR
";

#[test]
fn networks_that_touch_one_tag_do_not_change_places_unseen() {
    for (first, second) in [
        ("+--[ ]( a )--( )( y )--+", "+--[ ]( b )--( )( y )--+"),
        ("+--[ ]( a )--(S)( y )--+", "+--[ ]( b )--(R)( y )--+"),
        ("+--[ ]( a )--( )( x )--+", "+--[ ]( x )--( )( y )--+"),
        ("+--[MOV]( list[i], 1 )--+", "+--[MOV]( n, list[2] )--+"),
        ("+--[MOV]( n.3, a )--+", "+--[ ]( b )--[MOV]( n, 0 )--+"),
        ("+--[LEN]( n, texts )--+", "+--[ ]( a )--[MOV]( texts, 'on' )--+"),
        (
            "+--[MOV]( texts, 'on' )--+",
            "+--[ ]( a )--[MOV]( texts, '' )--+\n\n+--[LEN]( n, texts )--+",
        ),
        ("+--[ ]( a )--[TON]( t, 20ms )--+", "+--[ ]( t.Q )--( )( y )--+"),
        ("+--[ ]( a )--<RET>--+", "+--[ ]( b )--( )( y )--+"),
        ("+--[ ]( a )--<MCR>--+", "+--[ ]( b )--( )( y )--+"),
        ("+--<FOR>( 3 )--+", "+--[ADD]( n, n, 1 )--+\n\n+--<NEXT>--+"),
    ] {
        let [old, new] = swapped(TAGS, first, second);
        let told = answer(&old, &new);
        assert_ne!(told, "the same\n", "{old}");
    }
}

#[test]
fn a_run_shows_what_another_order_does() {
    let [old, new] = swapped(TAGS, "+--[ ]( a )--( )( y )--+", "+--[ ]( b )--( )( y )--+");
    check(
        &old,
        &new,
        expect![[r#"
        the programs differ in scan 0, at 0s
        a    -
        y => _  (old)
        y => -  (new)
    "#]],
    );
}

#[test]
fn networks_that_have_nothing_in_common_may_change_places() {
    let [old, new] = swapped(
        TAGS,
        "+--[LEN]( n, texts )--+",
        "+--[ ]( a )--[TON]( t, i )--( )( y )--+",
    );
    check(&old, &new, expect![["the same\n"]]);
}

#[test]
fn the_order_of_parameters_counts() {
    let program = |parameters: &str| {
        format!(
            "FUNCTION_BLOCK [$Both]\nVAR_INPUT\n{parameters}END_VAR\n+--[ ]( EN )--[ ]( one )--[/]( two )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n\
            {TAGS}\n+--[$Both]( a, b )--( )( y )--+\n"
        )
    };
    let (old, new) = (
        program("    one : BOOL;\n    two : BOOL;\n"),
        program("    two : BOOL;\n    one : BOOL;\n"),
    );
    check(
        &old,
        &new,
        expect![[r#"
        the programs differ in scan 0, at 0s
        a    -
        y => -  (old)
        y => _  (new)
    "#]],
    );
}

#[test]
fn a_setting_that_comes_too_late_is_none() {
    let setting = "# ladder: profile ldmicro #\n";
    let rung = "+--[ ]( Xa )--[TON]( Td, T#50ms )--( )( Yb )--+\n";
    let old = format!("{setting}\n{rung}");
    let new = format!("{rung}\n{setting}");
    assert_ne!(answer(&old, &new), "the same\n");
}

#[test]
fn a_tag_that_nothing_uses_is_no_difference() {
    let old = format!("{TAGS}\n+--[ ]( a )--( )( y )--+\n\n+--[LEN]( n, texts )--+\n");
    let spare = old.replace("    t     : TON;", "    t     : TON;\n    spare : REAL;");
    check(&old, &spare, expect![["the same\n"]]);
    check(&spare, &old, expect![["the same\n"]]);
    let output = old.replace("    n    : DINT;", "    n    : DINT;\n    lamp : BOOL;");
    check(
        &old,
        &output,
        expect![[r#"
        only the new program has the output lamp
    "#]],
    );
}

#[test]
fn another_time_between_scans_is_not_the_same() {
    let program = "+--[ ]( a )--[TON]( t, 30ms )--( )( y )--+\n";
    let with = |cycle: &str| format!("# ladder: cycle {cycle} #\n{program}");
    check(
        program,
        &with("20ms"),
        expect![[r#"
        new: setting, line 1
        other settings hold
        they are made for other times between scans
    "#]],
    );
    check(
        &with("5ms"),
        &with("20ms"),
        expect![[r#"
        edited: setting, line 1
        other settings hold
        they are made for other times between scans
    "#]],
    );
    check(
        program,
        &with("10ms"),
        expect![[r#"
        the same
    "#]],
    );
}

#[test]
fn a_tag_that_other_programs_see_is_another_without_them() {
    let network = "+--[ ]( a )--( )( y )--+\n";
    let with = |section: &str| format!("{section}\n    y : BOOL;\nEND_VAR\n{network}");
    check(
        &with("VAR_GLOBAL"),
        &with("VAR"),
        expect![[r#"
        only the old program shares y with other programs
    "#]],
    );
    check(
        network,
        &with("VAR_GLOBAL"),
        expect![[r#"
        only the new program shares y with other programs
    "#]],
    );
    check(
        network,
        &with("VAR"),
        expect![[r#"
        the same
    "#]],
    );
}
