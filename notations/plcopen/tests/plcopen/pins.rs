//! Pins that nothing is wired to, the order of boxes in a chain, and boxes in a ring.

use crate::harness::{check, program, project};
use expect_test::{Expect, expect};
use std::path::Path;

/// A drawing as people have it.
#[track_caller]
fn check_field(name: &str, expected: Expect) {
    let field = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/field");
    let xml = std::fs::read_to_string(field.join(name)).expect("the file can be read");
    check(&xml, expected);
}

#[track_caller]
fn check_body(variables: &str, body: &str, expected: Expect) {
    check(&project("", &program(variables, body), ""), expected);
}

#[test]
fn a_variable_without_a_name_is_nothing() {
    check_field(
        "output_pin_left_blank/blank.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            go   : BOOL;
            done : BOOL;
            t1   : TON;
        END_VAR

        +--[ ]( go )---------------------------------[TON]( t1, T#50ms )--( )( done )--+
    "#]],
    );
    check_body(
        "n : INT",
        "inVariable 1 n\ninVariable 2\ninVariable 3 2\nblock 4 ADD IN1=1 IN2=2 IN3=3 / OUT\noutVariable 5 from=4.OUT n",
        expect![[r#"
            VAR
                n : INT;
            END_VAR

            +------------------------------------------------------------[ADD]( n, n, 2 )--+
        "#]],
    );
}

#[test]
fn a_block_whose_enable_is_not_wired_runs() {
    check_field(
        "plcopen_en_not_wired_is_off/timer.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            go : BOOL;
            q  : BOOL;
            t1 : TON;
        END_VAR

        +--[ ]( go )------------------------------------[TON]( t1, T#20ms )--( )( q )--+
    "#]],
    );
    check_field(
        "plcopen_en_not_wired_is_off/add.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            a : INT := 3;
            y : INT;
        END_VAR

        +------------------------------------------------------------[ADD]( y, a, 2 )--+
    "#]],
    );
    check_field(
        "plcopen_en_not_wired_is_off/eno.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            go : BOOL;
            q  : BOOL;
            t1 : TON;
        END_VAR

        +--[ ]( go )----------------------------------------------[TON]( t1, T#20ms )--+

        +--------------------------------------------------------------------( )( q )--+
    "#]],
    );
}

#[test]
fn enable_out_of_a_block_with_a_state_is_what_came_to_its_enable() {
    check_body(
        "a : BOOL\nb : BOOL\nq : BOOL\nr : BOOL\nt : TON",
        "leftPowerRail 1\ncontact 2 from=1 a\ncontact 3 from=1 b\ninVariable 4 T#1s\n\
         block 5 TON t EN=2 IN=3 PT=4 / ENO Q ET\ncoil 6 from=5.ENO q\ncoil 7 from=5.Q r",
        expect![[r#"
            VAR
                a       : BOOL;
                b       : BOOL;
                q       : BOOL;
                r       : BOOL;
                t       : TON;
                enabled : BOOL;  # what comes to EN #
            END_VAR

            +--[ ]( a )----------------------------------------------------( )( enabled )--+

            +--[ ]( enabled )--[ ]( b )----------------------------------[TON]( t, T#1s )--+

            +--[ ]( enabled )----------------------------------------------------( )( q )--+

            +--[ ]( t.Q )--------------------------------------------------------( )( r )--+
            approximated TON t: without EN it stands still there; here EN and its first input are in series
        "#]],
    );
    check_body(
        "q : BOOL\nr : BOOL\nn : INT",
        "inVariable 3 n\ninVariable 4 2\n\
         block 5 GT EN= IN1=3 IN2=4 / ENO OUT\ncoil 6 from=5.ENO q\ncoil 7 from=5.OUT r",
        expect![[r#"
            VAR
                q  : BOOL;
                r  : BOOL;
                n  : INT;
                gt : BOOL;  # the result of GT #
            END_VAR

            +-----------------------------------------------[CALC]( gt, n > 2 )--( )( q )--+

            +--[ ]( gt )---------------------------------------------------------( )( r )--+
        "#]],
    );
}

#[test]
fn a_negated_pin_that_nothing_is_wired_to_is_off() {
    check_body(
        "q : BOOL\nt : TON",
        "inVariable 1 T#1s\nblock 2 TON t IN!negated= PT=1 / Q ET\noutVariable 3 from=2.Q q",
        expect![[r#"
            VAR
                q : BOOL;
                t : TON;
            END_VAR

            +--[ ]( SYS.OFF )----------------------------------[TON]( t, T#1s )--( )( q )--+
            approximated TON t: nothing is wired to it: no power comes there
        "#]],
    );
}

#[test]
fn of_boxes_in_a_chain_each_writes_before_the_next_reads() {
    check_field(
        "plcopen_chain_writes_too_late/prog.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            secs : DINT := 90061;
            day  : DINT;
        END_VAR

        +----------------------------[MOD]( day, secs, 86400 )--[DIV]( day, day, 60 )--+
    "#]],
    );
}

#[test]
fn boxes_in_a_ring_run_one_after_the_other() {
    check_field(
        "plcopen_two_timers_in_a_ring/loop.xml",
        expect![[r#"
        # p, from Beremiz #
        # ladder: cycle 10ms #

        VAR
            lamp : BOOL;
            on1  : TON;
            off1 : TON;
        END_VAR

        +--[ ]( on1.Q )--[TON]( off1, T#20ms )--[NOT]------------[TON]( on1, T#20ms )--+

        +--[ ]( on1.Q )---------------------------------------------------( )( lamp )--+
    "#]],
    );
    check_body(
        "lamp : BOOL\nt : TON",
        "inVariable 1 T#1s\nblock 2 NOT IN=3.Q / OUT\nblock 3 TON t IN=2.OUT PT=1 / Q ET\noutVariable 4 from=3.Q lamp",
        expect![[r#"
            VAR
                lamp : BOOL;
                t    : TON;
            END_VAR

            +--[ ]( t.Q )--[NOT]-----------------------------------------[TON]( t, T#1s )--+

            +--[ ]( t.Q )-----------------------------------------------------( )( lamp )--+
        "#]],
    );
    check_body(
        "a : BOOL\nn : INT",
        "leftPowerRail 1\ncontact 2 from=1 a\ninVariable 3 1\nblock 4 ADD EN=2 IN1=5.OUT IN2=3 / ENO OUT\n\
         block 5 SUB IN1=4.OUT IN2=3 / OUT\noutVariable 6 from=5.OUT n",
        expect![[r#"
            VAR
                a   : BOOL;
                n   : INT;
                sub : INT;  # the result of SUB #
                add : INT;  # the result of ADD #
            END_VAR

            +-------------------------------------------------------------[MOV]( add, 0 )--+

            +--[ ]( a )----------------------------------------------[ADD]( add, sub, 1 )--+

            +--------------------------------------------------------[SUB]( sub, add, 1 )--+

            +-------------------------------------------------------------[MOV]( n, sub )--+
        "#]],
    );
    check_body(
        "a : BOOL\nq : BOOL\nt : TOF",
        "leftPowerRail 1\ncontact 2 from=1,5.Q a\ninVariable 3 T#1s\nblock 5 TOF t IN=2 PT=3 / Q ET\ncoil 6 from=2 q",
        expect![[r#"
            VAR
                a : BOOL;
                q : BOOL;
                t : TOF;
            END_VAR

            +--\--[ ]( t.Q )--\--[ ]( a )--------------------------------[TOF]( t, T#1s )--+
            |  /--------------/                                                            |

            +--\--[ ]( t.Q )--\--[ ]( a )----------------------------------------( )( q )--+
            |  /--------------/                                                            |
        "#]],
    );
}
