//! The rules about tags, on members and elements: each is a tag of its own (LANGUAGE §4).

use crate::check::found;
use expect_test::{Expect, expect};

/// What `T` and `U` stand for in the rungs of a program: two places of one kind.
const KINDS: [(&str, &str, &str); 5] = [
    ("tag", "x", "y"),
    ("member", "s.x", "s.y"),
    ("element", "a[1]", "a[two]"),
    ("computed", "a[i]", "a[i]"),
    ("instance", "m.x", "m.y"),
];

const TYPES: &str = "TYPE\n    S : STRUCT\n        x, y : BOOL;\n    END_STRUCT;\n    C : STRUCT\n        c, d : CTU;\n    END_STRUCT;\nEND_TYPE\n\
    FUNCTION_BLOCK [$M]\nVAR_INPUT\n    x, y : BOOL;\nEND_VAR\n+--[ ]( x )--[ ]( y )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
    VAR\n    x, y : BOOL;\n    s, r : S;\n    a : ARRAY[1..4] OF BOOL;\n    m : $M;\n    i : INT;\nEND_VAR\n\
    VAR CONSTANT\n    two : INT := 2;\nEND_VAR\n";

/// What a rule finds in these rungs, with the places of each kind for `T` and `U`.
#[track_caller]
fn table(rule: &str, rungs: &str, expected: Expect) {
    let mut shown = String::new();
    for (kind, t, u) in KINDS {
        let text = format!("{TYPES}{}", rungs.replace('T', t).replace('U', u));
        let mut messages = found(&text, rule);
        messages.retain(|message| !message.contains("declared and never used"));
        let line = format!("{kind}: {}", messages.join("; "));
        shown.push_str(&format!("{}\n", line.trim_end()));
    }
    expected.assert_eq(&shown);
}

#[test]
fn set_without_reset() {
    table(
        "set-without-reset",
        "+--[ ]( I1 )--(S)( T )--+\n+--[ ]( I2 )--(R)( U )--+\n",
        expect![[r#"
            tag: `x` is set, and nothing resets it: once on, it stays on <+--[ ]( I1 )--(S)( x )--+>
            member: `s.x` is set, and nothing resets it: once on, it stays on <+--[ ]( I1 )--(S)( s.x )--+>
            element: `a[1]` is set, and nothing resets it: once on, it stays on <+--[ ]( I1 )--(S)( a[1] )--+>
            computed:
            instance: `m.x` is set, and nothing resets it: once on, it stays on <+--[ ]( I1 )--(S)( m.x )--+>
        "#]],
    );
    table(
        "set-without-reset",
        "+--[ ]( I1 )--(S)( T )--+\n+--[ ]( I2 )--[MOV]( s, r )--(R)( a[1..4] )--(R)( x )--+\n",
        expect![[r#"
            tag:
            member:
            element:
            computed:
            instance: `m.x` is set, and nothing resets it: once on, it stays on <+--[ ]( I1 )--(S)( m.x )--+>
        "#]],
    );
}

#[test]
fn reset_without_set() {
    table(
        "reset-without-set",
        "+--[ ]( I1 )--(S)( T )--+\n+--[ ]( I2 )--(R)( U )--+\n",
        expect![[r#"
            tag: `y` is reset, and nothing sets it: it is never on <+--[ ]( I2 )--(R)( y )--+>
            member: `s.y` is reset, and nothing sets it: it is never on <+--[ ]( I2 )--(R)( s.y )--+>
            element: `a[two]` is reset, and nothing sets it: it is never on <+--[ ]( I2 )--(R)( a[two] )--+>
            computed:
            instance: `m.y` is reset, and nothing sets it: it is never on <+--[ ]( I2 )--(R)( m.y )--+>
        "#]],
    );
}

#[test]
fn set_and_reset() {
    table(
        "set-and-reset",
        "+--[ ]( I1 )--(S)( T )--+\n+--[ ]( I1 )--(R)( T )--+\n",
        expect![[r#"
            tag: whenever this sets `x`, another coil resets it in the same scan: this has no effect <+--[ ]( I1 )--(S)( x )--+>
            member: whenever this sets `s.x`, another coil resets it in the same scan: this has no effect <+--[ ]( I1 )--(S)( s.x )--+>
            element: whenever this sets `a[1]`, another coil resets it in the same scan: this has no effect <+--[ ]( I1 )--(S)( a[1] )--+>
            computed:
            instance: whenever this sets `m.x`, another coil resets it in the same scan: this has no effect <+--[ ]( I1 )--(S)( m.x )--+>
        "#]],
    );
    table(
        "set-and-reset",
        "+--[ ]( I1 )--(S)( T )--+\n+--[ ]( I1 )--(R)( U )--+\n",
        expect![[r#"
            tag:
            member:
            element:
            computed:
            instance:
        "#]],
    );
    // What is asked for is a place of its own as well.
    table(
        "set-and-reset",
        "+--[ ]( U )--(S)( T )--+\n+--[ ]( U )--(R)( T )--+\n",
        expect![[r#"
            tag: whenever this sets `x`, another coil resets it in the same scan: this has no effect <+--[ ]( y )--(S)( x )--+>
            member: whenever this sets `s.x`, another coil resets it in the same scan: this has no effect <+--[ ]( s.y )--(S)( s.x )--+>
            element: whenever this sets `a[1]`, another coil resets it in the same scan: this has no effect <+--[ ]( a[two] )--(S)( a[1] )--+>
            computed:
            instance: whenever this sets `m.x`, another coil resets it in the same scan: this has no effect <+--[ ]( m.y )--(S)( m.x )--+>
        "#]],
    );
}

#[test]
fn double_coil() {
    table(
        "double-coil",
        "+--[ ]( I1 )--( )( T )--+\n+--[ ]( I2 )--( )( T )--+\n",
        expect![[r#"
            tag: `x` is written by 2 coils: the last one alone decides <+--[ ]( I2 )--( )( x )--+>
            member: `s.x` is written by 2 coils: the last one alone decides <+--[ ]( I2 )--( )( s.x )--+>
            element: `a[1]` is written by 2 coils: the last one alone decides <+--[ ]( I2 )--( )( a[1] )--+>
            computed:
            instance: `m.x` is written by 2 coils: the last one alone decides <+--[ ]( I2 )--( )( m.x )--+>
        "#]],
    );
    table(
        "double-coil",
        "+--[ ]( I1 )--( )( T )--+\n+--[ ]( I2 )--( )( U )--+\n",
        expect![[r#"
            tag:
            member:
            element:
            computed:
            instance:
        "#]],
    );
    table(
        "double-coil",
        "+--[ ]( I1 )--( )( U )--+\n+--[ ]( I2 )--( )( a[2] )--+\n",
        expect![[r#"
            tag:
            member:
            element: `a[2]` is written by 2 coils: the last one alone decides <+--[ ]( I2 )--( )( a[2] )--+>
            computed:
            instance:
        "#]],
    );
}

#[test]
fn never_written() {
    table(
        "never-written",
        "+--[ ]( T )--( )( Q1 )--+\n+--[ ]( I2 )--( )( U )--+\n",
        expect![[r#"
            tag: `x` is read, and nothing writes it: it stays off <+--[ ]( x )--( )( Q1 )--+>
            member: the member `x` of S is read, and nothing writes it <x, y : BOOL;>
            element: `a[1]` is read, and nothing writes this element: it stays off <+--[ ]( a[1] )--( )( Q1 )--+>
            computed: `i` is read, and nothing writes it: it stays 0 <+--[ ]( a[i] )--( )( Q1 )--+>
            instance:
        "#]],
    );
    table(
        "never-written",
        "+--[ ]( T )--( )( Q1 )--+\n+--[ ]( I2 )--( )( U )--( )( a[i] )--[MOV]( s, r )--+\n",
        expect![[r#"
            tag: `x` is read, and nothing writes it: it stays off <+--[ ]( x )--( )( Q1 )--+>; `i` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( y )--( )( a[i] )--[MOV]( s, r )--+>; `r` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( y )--( )( a[i] )--[MOV]( s, r )--+>
            member: `i` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( s.y )--( )( a[i] )--[MOV]( s, r )--+>; `r` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( s.y )--( )( a[i] )--[MOV]( s, r )--+>
            element: `i` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( a[two] )--( )( a[i] )--[MOV]( s, r )--+>; `r` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( a[two] )--( )( a[i] )--[MOV]( s, r )--+>
            computed: `i` is read, and nothing writes it: it stays 0 <+--[ ]( a[i] )--( )( Q1 )--+>; `r` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( a[i] )--( )( a[i] )--[MOV]( s, r )--+>
            instance: `i` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( m.y )--( )( a[i] )--[MOV]( s, r )--+>; `r` is read, and nothing writes it: it stays 0 <+--[ ]( I2 )--( )( m.y )--( )( a[i] )--[MOV]( s, r )--+>
        "#]],
    );
}

#[test]
fn never_read() {
    table(
        "never-read",
        "+--[ ]( I1 )--( )( T )--+\n+--[ ]( U )--( )( Q1 )--+\n",
        expect![[r#"
            tag: `x` is written, and nothing reads it <x, y : BOOL;>
            member: the member `x` of S is written, and nothing reads it <x, y : BOOL;>
            element: `a[1]` is written, and nothing reads this element <+--[ ]( I1 )--( )( a[1] )--+>
            computed:
            instance:
        "#]],
    );
    table(
        "never-read",
        "+--[ ]( I1 )--( )( T )--+\n+--[ ]( U )--( )( Q1 )--[ ]( a[1..4] )--[MOV]( r, s )--( )( Q2 )--+\n",
        expect![[r#"
            tag: `x` is written, and nothing reads it <x, y : BOOL;>; `r` is written, and nothing reads it <s, r : S;>
            member: `r` is written, and nothing reads it <s, r : S;>
            element: `r` is written, and nothing reads it <s, r : S;>
            computed: `r` is written, and nothing reads it <s, r : S;>
            instance: `r` is written, and nothing reads it <s, r : S;>
        "#]],
    );
}

#[test]
fn read_before_write() {
    table(
        "read-before-write",
        "+--[ ]( T )--( )( Q1 )--+\n+--[ ]( I1 )--( )( T )--+\n",
        expect![[r#"
            tag: `x` is written further down: this rung sees its value of the scan before <+--[ ]( x )--( )( Q1 )--+>
            member: `s.x` is written further down: this rung sees its value of the scan before <+--[ ]( s.x )--( )( Q1 )--+>
            element: `a[1]` is written further down: this rung sees its value of the scan before <+--[ ]( a[1] )--( )( Q1 )--+>
            computed:
            instance: `m.x` is written further down: this rung sees its value of the scan before <+--[ ]( m.x )--( )( Q1 )--+>
        "#]],
    );
    table(
        "read-before-write",
        "+--[ ]( T )--( )( Q1 )--+\n+--[ ]( I1 )--( )( U )--+\n",
        expect![[r#"
            tag:
            member:
            element:
            computed:
            instance:
        "#]],
    );
    table(
        "read-before-write",
        "+--[ ]( T )--[MOV]( r, s )--( )( Q1 )--+\n+--[ ]( I1 )--( )( U )--+\n",
        expect![[r#"
            tag:
            member: `s.y` is written further down: this rung sees its value of the scan before <+--[ ]( s.x )--[MOV]( r, s )--( )( Q1 )--+>
            element:
            computed:
            instance:
        "#]],
    );
}

#[test]
fn order_sensitive() {
    table(
        "order-sensitive",
        "+--[ ]( I1 )--( )( T )--[ ]( T )--( )( Q1 )--[/]( T )--( )( Q2 )--+\n",
        expect![[r#"
            tag: the order of this network matters: with I1 = 1, x = 0: `Q1` becomes 1, but 0 if all contacts were read first <+--[ ]( I1 )--( )( x )--[ ]( x )--( )( Q1 )--[/]( x )--( )( Q2 )--+>
            member: the order of this network matters: with I1 = 1, s.x = 0: `Q1` becomes 1, but 0 if all contacts were read first <+--[ ]( I1 )--( )( s.x )--[ ]( s.x )--( )( Q1 )--[/]( s.x )--( )( Q2 )--+>
            element: the order of this network matters: with I1 = 1, a[1] = 0: `Q1` becomes 1, but 0 if all contacts were read first <+--[ ]( I1 )--( )( a[1] )--[ ]( a[1] )--( )( Q1 )--[/]( a[1] )--( )( Q2 )--+>
            computed:
            instance: the order of this network matters: with I1 = 1, m.x = 0: `Q1` becomes 1, but 0 if all contacts were read first <+--[ ]( I1 )--( )( m.x )--[ ]( m.x )--( )( Q1 )--[/]( m.x )--( )( Q2 )--+>
        "#]],
    );
    table(
        "constant-power",
        "+--[ ]( T )--[/]( U )--( )( Q1 )--+\n+--[ ]( T )--[/]( T )--( )( Q2 )--+\n",
        expect![[r#"
            tag: no power ever comes through here: when this conducts, what is before it does not <+--[ ]( x )--[/]( x )--( )( Q2 )--+>
            member: no power ever comes through here: when this conducts, what is before it does not <+--[ ]( s.x )--[/]( s.x )--( )( Q2 )--+>
            element: no power ever comes through here: when this conducts, what is before it does not <+--[ ]( a[1] )--[/]( a[1] )--( )( Q2 )--+>
            computed:
            instance: no power ever comes through here: when this conducts, what is before it does not <+--[ ]( m.x )--[/]( m.x )--( )( Q2 )--+>
        "#]],
    );
}

#[test]
fn input_written() {
    let text = |section: &str, place: &str| {
        format!(
            "{TYPES}{section}\n    p : S;\n    q : ARRAY[1..2] OF BOOL;\nEND_VAR\n+--[ ]( I1 )--( )( {place} )--+\n"
        )
    };
    let mut shown = String::new();
    for (section, rule) in [("VAR_INPUT", "input-written"), ("VAR CONSTANT", "constant-write")] {
        for place in ["p.x", "q[1]", "q[i]"] {
            shown.push_str(&format!(
                "{rule} {place}: {}\n",
                found(&text(section, place), rule).join("; ")
            ));
        }
    }
    expect![[r#"
        input-written p.x: `p` is an input, and is written here: the next reading of the inputs overwrites it <+--[ ]( I1 )--( )( p.x )--+>
        input-written q[1]: `q` is an input, and is written here: the next reading of the inputs overwrites it <+--[ ]( I1 )--( )( q[1] )--+>
        input-written q[i]: `q` is an input, and is written here: the next reading of the inputs overwrites it <+--[ ]( I1 )--( )( q[i] )--+>
        constant-write p.x: `p` is a constant: no block may write it <+--[ ]( I1 )--( )( p.x )--+>
        constant-write q[1]: `q` is a constant: no block may write it <+--[ ]( I1 )--( )( q[1] )--+>
        constant-write q[i]: `q` is a constant: no block may write it <+--[ ]( I1 )--( )( q[i] )--+>
    "#]].assert_eq(&shown);
}

#[test]
fn timers_and_counters() {
    let mut shown = String::new();
    let mut show = |rule: &str, rungs: &str| {
        let text = format!(
            "{TYPES}VAR\n    k, l : CTU;\n    t : ARRAY[1..3] OF C;\n    e : C;\n    v : ARRAY[1..3] OF TON;\n    w, w2 : $M;\n    z : ARRAY[1..2] OF $M;\nEND_VAR\n{rungs}"
        );
        shown.push_str(&format!("{rule}: {rungs}{}\n", found(&text, rule).join("; ")));
    };
    for (one, other) in [
        ("k", "l"),
        ("e.c", "e.d"),
        ("t[1].c", "t[two].c"),
        ("t[2].c", "t[two].c"),
        ("t[i].c", "t[i].c"),
        ("t[i].c", "t[1].c"),
    ] {
        show(
            "duplicate-counter",
            &format!("+--[CTU]( {one}, 5 )--[CTU]( {other}, 5 )--( )( Q1 )--+\n"),
        );
        show(
            "never-reset",
            &format!("+--[CTU]( {one}, 5 )--( )( Q1 )--+\n+--[ ]( I1 )--(RES)( {other} )--+\n"),
        );
    }
    for (one, other) in [("v[1]", "v[2]"), ("v[two]", "v[2]"), ("v[i]", "v[i]")] {
        show(
            "duplicate-timer",
            &format!("+--[TON]( {one}, 5s )--[TON]( {other}, 5s )--( )( Q1 )--+\n"),
        );
    }
    for (one, other) in [("w", "w2"), ("w", "w"), ("z[two]", "z[2]"), ("z[1]", "z[2]")] {
        show(
            "duplicate-instance",
            &format!("+--[$M]( {one}, I1, I2 )--[$M]( {other}, I1, I2 )--( )( Q1 )--+\n"),
        );
    }
    expect![[r#"
        duplicate-counter: +--[CTU]( k, 5 )--[CTU]( l, 5 )--( )( Q1 )--+

        never-reset: +--[CTU]( k, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( l )--+
        nothing resets or loads the CTU `k`: it counts to its end once <+--[CTU]( k, 5 )--( )( Q1 )--+>
        duplicate-counter: +--[CTU]( e.c, 5 )--[CTU]( e.d, 5 )--( )( Q1 )--+

        never-reset: +--[CTU]( e.c, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( e.d )--+
        nothing resets or loads the CTU `e.c`: it counts to its end once <+--[CTU]( e.c, 5 )--( )( Q1 )--+>
        duplicate-counter: +--[CTU]( t[1].c, 5 )--[CTU]( t[two].c, 5 )--( )( Q1 )--+

        never-reset: +--[CTU]( t[1].c, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( t[two].c )--+
        nothing resets or loads the CTU `t[1].c`: it counts to its end once <+--[CTU]( t[1].c, 5 )--( )( Q1 )--+>
        duplicate-counter: +--[CTU]( t[2].c, 5 )--[CTU]( t[two].c, 5 )--( )( Q1 )--+
        the counter `t[two].c` has a second block: both would work on one CTU <+--[CTU]( t[2].c, 5 )--[CTU]( t[two].c, 5 )--( )( Q1 )--+>
        never-reset: +--[CTU]( t[2].c, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( t[two].c )--+

        duplicate-counter: +--[CTU]( t[i].c, 5 )--[CTU]( t[i].c, 5 )--( )( Q1 )--+
        the counter `t[i].c` has a second block: both would work on one CTU <+--[CTU]( t[i].c, 5 )--[CTU]( t[i].c, 5 )--( )( Q1 )--+>
        never-reset: +--[CTU]( t[i].c, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( t[i].c )--+

        duplicate-counter: +--[CTU]( t[i].c, 5 )--[CTU]( t[1].c, 5 )--( )( Q1 )--+

        never-reset: +--[CTU]( t[i].c, 5 )--( )( Q1 )--+
        +--[ ]( I1 )--(RES)( t[1].c )--+

        duplicate-timer: +--[TON]( v[1], 5s )--[TON]( v[2], 5s )--( )( Q1 )--+

        duplicate-timer: +--[TON]( v[two], 5s )--[TON]( v[2], 5s )--( )( Q1 )--+
        the timer `v[2]` has a second block: both would work on one TON <+--[TON]( v[two], 5s )--[TON]( v[2], 5s )--( )( Q1 )--+>
        duplicate-timer: +--[TON]( v[i], 5s )--[TON]( v[i], 5s )--( )( Q1 )--+
        the timer `v[i]` has a second block: both would work on one TON <+--[TON]( v[i], 5s )--[TON]( v[i], 5s )--( )( Q1 )--+>
        duplicate-instance: +--[$M]( w, I1, I2 )--[$M]( w2, I1, I2 )--( )( Q1 )--+

        duplicate-instance: +--[$M]( w, I1, I2 )--[$M]( w, I1, I2 )--( )( Q1 )--+
        a second [$M] works on `w`: what one does the other sees <+--[$M]( w, I1, I2 )--[$M]( w, I1, I2 )--( )( Q1 )--+>
        duplicate-instance: +--[$M]( z[two], I1, I2 )--[$M]( z[2], I1, I2 )--( )( Q1 )--+
        a second [$M] works on `z[2]`: what one does the other sees <+--[$M]( z[two], I1, I2 )--[$M]( z[2], I1, I2 )--( )( Q1 )--+>
        duplicate-instance: +--[$M]( z[1], I1, I2 )--[$M]( z[2], I1, I2 )--( )( Q1 )--+

    "#]].assert_eq(&shown);
}

/// A member counts for all tags of its type; a whole copy touches all members.
#[test]
fn members_that_nothing_uses() {
    let text = |rungs: &str| {
        format!(
            "TYPE\n    P : STRUCT\n        a, b : BOOL;\n        c : INT := 5;\n    END_STRUCT;\n    L : STRUCT\n        p : P;\n        d : BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR\n    s, r : L;\n    k : ARRAY[1..2] OF P;\nEND_VAR\n{rungs}"
        )
    };
    let mut shown = String::new();
    for rungs in [
        "+--[ ]( s.p.a )--[ ]( k[1].b )--( )( Q1 )--+\n",
        "+--[ ]( s.p.a )--[ ]( I1 )--( )( k[2].a )--( )( r.d )--+\n",
        "+--[ ]( I1 )--[MOV]( s, r )--[ ]( s.d )--( )( Q1 )--+\n",
        "+--[ ]( I1 )--[MOV]( k[1], r.p )--( )( Q1 )--+\n",
    ] {
        let text = text(rungs);
        let mut found = found(&text, "never-read");
        found.extend(crate::check::found(&text, "never-written"));
        shown.push_str(&format!("{rungs}    {}\n", found.join("\n    ")));
    }
    expect![[r#"
        +--[ ]( s.p.a )--[ ]( k[1].b )--( )( Q1 )--+
            the member `c` of P is declared and never used <c : INT := 5;>
            the member `d` of L is declared and never used <d : BOOL;>
            `r` is declared and never used <s, r : L;>
            the member `a` of P is read, and nothing writes it <a, b : BOOL;>
            the member `b` of P is read, and nothing writes it <a, b : BOOL;>
            `s` is read, and nothing writes it: it stays 0 <+--[ ]( s.p.a )--[ ]( k[1].b )--( )( Q1 )--+>
            `k` is read, and nothing writes it: it stays 0 <+--[ ]( s.p.a )--[ ]( k[1].b )--( )( Q1 )--+>
        +--[ ]( s.p.a )--[ ]( I1 )--( )( k[2].a )--( )( r.d )--+
            the member `b` of P is declared and never used <a, b : BOOL;>
            the member `c` of P is declared and never used <c : INT := 5;>
            `s` is read, and nothing writes it: it stays 0 <+--[ ]( s.p.a )--[ ]( I1 )--( )( k[2].a )--( )( r.d )--+>
        +--[ ]( I1 )--[MOV]( s, r )--[ ]( s.d )--( )( Q1 )--+
            `k` is declared and never used <k : ARRAY[1..2] OF P;>
            `r` is read, and nothing writes it: it stays 0 <+--[ ]( I1 )--[MOV]( s, r )--[ ]( s.d )--( )( Q1 )--+>
        +--[ ]( I1 )--[MOV]( k[1], r.p )--( )( Q1 )--+
            the member `d` of L is declared and never used <d : BOOL;>
            `s` is declared and never used <s, r : L;>
            `k` is written, and nothing reads it <k : ARRAY[1..2] OF P;>
            `r` is read, and nothing writes it: it stays 0 <+--[ ]( I1 )--[MOV]( k[1], r.p )--( )( Q1 )--+>
    "#]].assert_eq(&shown);
}
