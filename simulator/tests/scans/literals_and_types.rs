//! The sentences of LANGUAGE §3 and §4 that a run can show.

use crate::support::{check, get, set, simulation};
use expect_test::expect;
use ladder_analysis::analyze;
use std::sync::Arc;

/// What a tag of a type holds at the start that a literal gives it; or the rule that refuses it.
fn starts(ty: &str, literal: &str) -> String {
    let text = format!("VAR y : {ty} := {literal}; END_VAR\n+--[PERSIST]( y )--+\n");
    let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
    match analysis.diagnostics().first() {
        Some(found) => found.rule.to_string(),
        None => get(&simulation(&text), "y"),
    }
}

fn table(rows: &[(&str, &str)]) -> String {
    let row = |(ty, literal): &(&str, &str)| format!("{ty} {literal}: {}\n", starts(ty, literal));
    rows.iter().map(row).collect()
}

#[test]
fn every_form_of_a_literal() {
    expect![[r#"
        BOOL TRUE: 1
        BOOL false: 0
        INT 42: 42
        INT -7: -7
        DINT 1_000: 1000
        BYTE 16#FF: 255
        INT 8#17: 15
        WORD 2#1010_0101: 165
        LREAL 3.14: 3.14
        REAL -1.0e-3: -0.001
        TIME T#5s: 5000
        TIME T#1h30m: 5400000
        TIME TIME#-250ms: -250
        TIME T#1.5s: 1500
        TIME T#2d_4h: 187200000
        TIME t#1us500ns: 0.0015
        TIME T#90m: 5400000
        TIME 5s: 5000
        TIME 1h30m: 5400000
        DATE D#2026-11-21: 2026-11-21
        DATE DATE#2024-02-29: 2024-02-29
        TOD TOD#13:45:00.5: 13:45:00.5
        TOD TIME_OF_DAY#00:00:01: 00:00:01
        DT DT#2026-11-21-13:45:00: 2026-11-21-13:45:00
        DT DATE_AND_TIME#1970-01-01-00:00:00: 1970-01-01-00:00:00
        STRING 'text': text
        INT INT#5: 5
        INT INT#-5: -5
        WORD WORD#16#00FF: 255
        REAL REAL#1: 1.0
        BOOL BOOL#1: 1
        BOOL BOOL#0: 0
    "#]]
    .assert_eq(&table(&[
        ("BOOL", "TRUE"),
        ("BOOL", "false"),
        ("INT", "42"),
        ("INT", "-7"),
        ("DINT", "1_000"),
        ("BYTE", "16#FF"),
        ("INT", "8#17"),
        ("WORD", "2#1010_0101"),
        ("LREAL", "3.14"),
        ("REAL", "-1.0e-3"),
        ("TIME", "T#5s"),
        ("TIME", "T#1h30m"),
        ("TIME", "TIME#-250ms"),
        ("TIME", "T#1.5s"),
        ("TIME", "T#2d_4h"),
        ("TIME", "t#1us500ns"),
        ("TIME", "T#90m"),
        ("TIME", "5s"),
        ("TIME", "1h30m"),
        ("DATE", "D#2026-11-21"),
        ("DATE", "DATE#2024-02-29"),
        ("TOD", "TOD#13:45:00.5"),
        ("TOD", "TIME_OF_DAY#00:00:01"),
        ("DT", "DT#2026-11-21-13:45:00"),
        ("DT", "DATE_AND_TIME#1970-01-01-00:00:00"),
        ("STRING", "'text'"),
        ("INT", "INT#5"),
        ("INT", "INT#-5"),
        ("WORD", "WORD#16#00FF"),
        ("REAL", "REAL#1"),
        ("BOOL", "BOOL#1"),
        ("BOOL", "BOOL#0"),
    ]));
}

#[test]
fn what_a_dollar_is_before() {
    assert_eq!(starts("STRING", "'$'$$$L$N$R$T$P$41'"), "'$\n\n\r\t\u{c}A");
}

#[test]
fn what_is_no_literal_or_does_not_fit() {
    expect![[r#"
        TIME T#5m1h: bad-literal
        TIME T#5s5s: bad-literal
        TIME T#1.5m3s: bad-literal
        TIME T#: bad-literal
        DATE D#2026-02-30: bad-literal
        TOD TOD#24:00:00: bad-literal
        STRING '$x': bad-literal
        INT 8#9: bad-literal
        INT 1__0: bad-literal
        INT 40000: literal-out-of-range
        BYTE 256: literal-out-of-range
        USINT -1: literal-out-of-range
        SINT -129: literal-out-of-range
        INT SINT#200: literal-out-of-range
        ULINT 18446744073709551616: literal-out-of-range
        INT 1.5: type-mismatch
        BOOL 2: type-mismatch
        TIME 5: type-mismatch
        STRING[3] 'four': literal-out-of-range
        INT DINT#5: type-mismatch
        DATE T#5s: type-mismatch
    "#]]
    .assert_eq(&table(&[
        ("TIME", "T#5m1h"),
        ("TIME", "T#5s5s"),
        ("TIME", "T#1.5m3s"),
        ("TIME", "T#"),
        ("DATE", "D#2026-02-30"),
        ("TOD", "TOD#24:00:00"),
        ("STRING", "'$x'"),
        ("INT", "8#9"),
        ("INT", "1__0"),
        ("INT", "40000"),
        ("BYTE", "256"),
        ("USINT", "-1"),
        ("SINT", "-129"),
        ("INT", "SINT#200"),
        ("ULINT", "18446744073709551616"),
        ("INT", "1.5"),
        ("BOOL", "2"),
        ("TIME", "5"),
        ("STRING[3]", "'four'"),
        ("INT", "DINT#5"),
        ("DATE", "T#5s"),
    ]));
}

#[test]
fn elementary_types_hold_their_borders() {
    expect![[r#"
        BYTE 255: 255
        WORD 65535: 65535
        DWORD 4294967295: 4294967295
        LWORD 18446744073709551615: 18446744073709551615
        SINT -128: -128
        INT -32768: -32768
        DINT -2147483648: -2147483648
        LINT -9223372036854775808: -9223372036854775808
        USINT 255: 255
        UINT 65535: 65535
        UDINT 4294967295: 4294967295
        ULINT 18446744073709551615: 18446744073709551615
        REAL 0.1: 0.1
        LREAL 0.1: 0.1
        TIME T#106751d: 9223286400000
        TIME T#1ns: 0.000001
        STRING[5] '12345': 12345
    "#]]
    .assert_eq(&table(&[
        ("BYTE", "255"),
        ("WORD", "65535"),
        ("DWORD", "4294967295"),
        ("LWORD", "18446744073709551615"),
        ("SINT", "-128"),
        ("INT", "-32768"),
        ("DINT", "-2147483648"),
        ("LINT", "-9223372036854775808"),
        ("USINT", "255"),
        ("UINT", "65535"),
        ("UDINT", "4294967295"),
        ("ULINT", "18446744073709551615"),
        ("REAL", "0.1"),
        ("LREAL", "0.1"),
        ("TIME", "T#106751d"),
        ("TIME", "T#1ns"),
        ("STRING[5]", "'12345'"),
    ]));
}

#[test]
fn what_a_tag_starts_with_and_constants() {
    check(
        "VAR b : BOOL; n : INT; r : REAL; t : TIME; s : STRING; d : DATE; END_VAR\n\
         VAR i, j : INT := 7; a : ARRAY[-1..2] OF INT := [1, 2(5), 9]; END_VAR\n\
         VAR CONSTANT limit : INT := 80; END_VAR\n\
         +--[ADD]( n, limit, 0 )--+\n",
        "1",
        "b r t s d i j a[-1] a[0] a[1] a[2] n",
        expect![[r#"
            b      _
            r      0.0
            t      0
            s      
            d      1970-01-01
            i      7
            j      7
            a[-1]  1
            a[0]   5
            a[1]   5
            a[2]   9
            n      80
        "#]],
    );
}

#[test]
fn retentive_tags_keep_their_value_over_a_warm_restart() {
    let mut simulation = simulation(
        "VAR RETAIN kept : INT := 3; END_VAR\nVAR lost : INT := 3; m, sm, rm : BOOL; p : INT; END_VAR\n\
         VAR_GLOBAL RETAIN shared : INT; END_VAR\n\
         +--[ ]( SYS.FIRST_SCAN )--[ADD]( kept, kept, 1 )--[ADD]( lost, lost, 1 )--[ADD]( shared, shared, 1 )--[ADD]( p, p, 1 )--[PERSIST]( p )--+\n\
         +--[ ]( SYS.FIRST_SCAN )--(SM)( sm )--+\n",
    );
    simulation.scan();
    simulation.warm_restart();
    let held = ["kept", "lost", "shared", "p", "sm"].map(|tag| get(&simulation, tag));
    assert_eq!(held, ["4", "3", "1", "1", "1"]);
    simulation.scan();
    let held = ["kept", "lost", "shared", "p"].map(|tag| get(&simulation, tag));
    assert_eq!(held, ["5", "4", "2", "2"], "a warm restart has a first scan too");
}

#[test]
fn direct_addresses_have_a_type_by_their_size_and_do_not_overlap() {
    check(
        "+--[ ]( %IX0.3 )--( )( %QX1.7 )--[MOV]( %MB2, 16#FF )--[MOV]( %MW2, 16#FFFF )--+\n\
         +--[MOV]( %MD2, 16#FFFF_FFFF )--[MOV]( %ML2, 16#FFFF_FFFF_FFFF_FFFF )--[MOV]( %QW1, 16#1234 )--+\n",
        "%IX0.3 _-",
        "%QX1.7 %MB2 %MW2 %MD2 %ML2 %QW1",
        expect![[r#"
            %QX1.7  _-
            %MB2    0 255
            %MW2    0 65535
            %MD2    4294967295 4294967295
            %ML2    18446744073709551615 18446744073709551615
            %QW1    4660 4660
        "#]],
    );
}

#[test]
fn names_give_types_and_roles() {
    let simulation = simulation(
        "+--[ ]( I1 )--( )( Q1 )--+\n+--[ ]( M1 )--[ADD]( MI1, MI1, 1 )--[ADD]( MF1, MF1, 0.5 )--+\n\
         +--[ ]( button )--( )( lamp )--[MOV]( wait, T#1s )--[MOV]( text, 'a' )--[SQRT]( root, 2 )--[MOV]( n, 5 )--+\n",
    );
    let shown: Vec<String> = simulation
        .points()
        .iter()
        .map(|point| format!("{} : {} {:?}", point.name, point.ty, point.role))
        .collect();
    expect![[r#"
        I1 : BOOL Input
        Q1 : BOOL Output
        M1 : BOOL Internal
        MI1 : DINT Internal
        MF1 : LREAL Internal
        button : BOOL Input
        lamp : BOOL Output
        wait : TIME Internal
        text : STRING Internal
        root : LREAL Internal
        n : DINT Internal"#]]
    .assert_eq(&shown.join("\n"));
}

#[test]
fn members_of_timers_and_counters_under_both_names() {
    check(
        "VAR_INPUT a : BOOL; END_VAR\nVAR t : TON; c : CTU; u : CTUD; b : SR; q, dn, en, tt, cc : BOOL; et, acc, pre : TIME; n, m : DINT; END_VAR\n\
         +--[ ]( a )--[TON]( t, T#20ms )--+\n+--[ ]( a )--[CTU]( c, 2 )--+\n+--[ ]( a )--[CTUD]( u, 1 )--+\n+--[ ]( a )--[SR]( b )--+\n\
         +--[ ]( t.Q )--( )( q )--+\n+--[ ]( t.DN )--( )( dn )--+\n+--[ ]( t.EN )--[ ]( t.IN )--( )( en )--+\n+--[ ]( t.TT )--( )( tt )--+\n\
         +--[ ]( c.CC )--( )( cc )--+\n\
         +--[MOV]( et, t.ET )--[MOV]( acc, t.ACC )--[MOV]( pre, t.PRE )--[MOV]( n, c.CV )--[MOV]( m, c.AC )--+\n",
        "a _----",
        "q dn en tt et acc pre cc n m u.QU u.QD b.Q1",
        expect![[r#"
            q     ___--
            dn    ___--
            en    _----
            tt    _--__
            et    0 0 10 20 20
            acc   0 0 10 20 20
            pre   20 20 20 20 20
            cc    _-___
            n     0 1 1 1 1
            m     0 1 1 1 1
            u.QU  _----
            u.QD  -____
            b.Q1  _----
        "#]],
    );
}

#[test]
fn bits_elements_and_ranges() {
    check(
        "VAR_INPUT i : INT; END_VAR\nVAR w : WORD; n : INT; a : ARRAY[3..6] OF INT; f : ARRAY[0..3] OF BOOL; any, all : BOOL; END_VAR\n\
         +--[ ]( SYS.ON )--( )( w.3 )--( )( n.15 )--(S)( f[1..2] )--+\n\
         +--[MOV]( a[3], 10 )--[MOV]( a[i], 20 )--+\n\
         +--[ ]( f[1..2] )--( )( all )--+\n+--[/]( f[0..3] )--( )( any )--+\n",
        "i 4 6",
        "w n a[3] a[4] a[5] a[6] f[0] f[1] f[2] all any",
        expect![[r#"
            w     8 8
            n     -32768 -32768
            a[3]  10 10
            a[4]  20 20
            a[5]  0 0
            a[6]  0 20
            f[0]  __
            f[1]  --
            f[2]  --
            all   --
            any   __
        "#]],
    );
}

#[test]
fn system_tags() {
    let mut simulation = simulation(
        "VAR_INPUT z : INT := 1; END_VAR\nVAR first, fault, on, off : BOOL; n : DINT; t, step : TIME; y : INT; END_VAR\n\
         +--[ ]( SYS.FIRST_SCAN )--( )( first )--+\n+--[ ]( SYS.FAULT )--( )( fault )--+\n\
         +--[ ]( SYS.ON )--( )( on )--+\n+--[ ]( SYS.OFF )--( )( off )--+\n\
         +--[MOV]( n, SYS.SCAN )--[MOV]( t, SYS.TIME )--[MOV]( step, SYS.SCAN_TIME )--[DIV]( y, 1, z )--+\n",
    );
    let mut shown = String::new();
    for scan in 0..4 {
        set(&mut simulation, "z", if scan == 1 { "0" } else { "1" });
        simulation.scan();
        let row = ["first", "fault", "on", "off", "n", "t", "step"].map(|tag| get(&simulation, tag));
        shown.push_str(&format!("{}\n", row.join(" ")));
    }
    expect![[r#"
        1 0 1 0 0 0 0
        0 0 1 0 1 10 10
        0 1 1 0 2 20 10
        0 0 1 0 3 30 10
    "#]]
    .assert_eq(&shown);
}

#[test]
fn names_are_compared_without_regard_to_capitals() {
    check(
        "VAR Motor, GRÖSSE : INT; END_VAR\n+--[MOV]( MOTOR, 3 )--[mov]( größe, 4 )--<call>( Sub )--+\n+--<FUN>( sub )--[ADD]( motor, Motor, 1 )--+\n",
        "1",
        "motor",
        expect![[r#"
            motor  4
        "#]],
    );
}

#[test]
fn a_tag_at_an_address_and_the_address_are_one() {
    check(
        "VAR level AT %IW3 : INT; go AT %IX0.0 : BOOL; END_VAR\nVAR w : WORD; y, z : BOOL; END_VAR\n\
         FUNCTION_BLOCK [$B]\n+--[ ]( %IX0.0 )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\
         +--[ ]( %IX0.0 )--( )( y )--+\n+--[MOV]( w, %IW3 )--+\n+--[$B]--( )( z )--+\n",
        "go _-_\nlevel 5 -1 .\n%IX0.0 ..-",
        "go %IX0.0 level %iw3 w y z",
        expect![[r#"
            go      _--
            %IX0.0  _--
            level   5 -1 -1
            %iw3    5 -1 -1
            w       5 65535 65535
            y       _--
            z       _--
        "#]],
    );
}
