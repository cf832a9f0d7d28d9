//! What is reported about two texts.

use crate::harness::outline;
use expect_test::{Expect, expect};
use ladder_review::compare;
use ladder_review::report::{Compared, text};

fn check(old: &str, new: &str, expected: Expect) {
    let (old, new) = (outline(old), outline(new));
    let compared = Compared {
        old: Some("old.clad"),
        new: Some("new.clad"),
        renamed: false,
        comparison: compare(&old, &new),
    };
    let lines = text::report(&compared);
    let lines: Vec<&str> = lines.iter().map(|line| line.text.as_str()).collect();
    expected.assert_eq(&(lines.join("\n") + "\n"));
}

const MOTOR: &str = "\
# A motor #

VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run   : BOOL;  # the contactor #
    ready : BOOL;
END_VAR
VAR
    warmup : TON;
END_VAR

# Start/stop with a seal-in contact #
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |

+--[ ]( run )--[TON]( warmup, 5s )-------------( )( ready )--+
";

#[test]
fn a_text_is_itself() {
    check(
        MOTOR,
        MOTOR,
        expect![[r#"
        --- old.clad
        +++ new.clad
            7 the same

            ... 7 the same
    "#]],
    );
    let blank = MOTOR.replace("\n\n", "\n\n\n").replace('\n', "\r\n");
    check(
        MOTOR,
        &blank,
        expect![[r#"
        --- old.clad
        +++ new.clad
            7 the same

            ... 7 the same
    "#]],
    );
}

#[test]
fn an_edit_is_marked_in_both_forms() {
    let new = MOTOR
        .replace("[/]( stop )", "[ ]( stop )")
        .replace("5s", "7s")
        .replace("ready : BOOL", "ready : BOOL := TRUE");
    check(
        MOTOR,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                3 edited, 4 the same

                ... 3 the same

            edited: declaration of ready, line 8
            - ready : BOOL;
            + ready : BOOL := TRUE;
                           ^^ ^^^^

                ... 1 the same

            edited: network, line 15, writes run
              # Start/stop with a seal-in contact #
            - +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
                                     ^^^^^^^^^^^
            - |  /--[ ]( run )----/                                                        |
            + +--\--[ ]( start )--\--[ ]( stop )-------------------------------( )( run )--+
                                     ^^^^^^^^^^^
            + |  /--[ ]( run )----/                                                        |

            edited: network, line 18, writes ready, warmup
            - +--[ ]( run )-----------------------------[TON]( warmup, 5s )--( )( ready )--+
                                                        ^^^^^^^^^^^^^^^^^^^
            + +--[ ]( run )-----------------------------[TON]( warmup, 7s )--( )( ready )--+
                                                        ^^^^^^^^^^^^^^^^^^^
        "#]],
    );
}

#[test]
fn what_is_drawn_or_spelled_differently_is_no_edit() {
    let new = MOTOR
        .replace("--[/]( stop )-------------( )( run )", "-[/](STOP)---( )(run)")
        .replace("5s", "T#5000ms")
        .replace("stop : BOOL", "stop   :   bool");
    check(
        MOTOR,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                3 drawn differently, 4 the same

                ... 1 the same

            drawn differently: declaration of start, stop, line 4

                ... 3 the same

            drawn differently: network, line 15, writes run

            drawn differently: network, line 18, writes ready, warmup
        "#]],
    );
}

#[test]
fn comments_alone() {
    let new = MOTOR
        .replace("with a seal-in contact", "and hold")
        .replace("the contactor", "K1");
    check(
        MOTOR,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                2 other comments, 5 the same

                ... 2 the same

            other comments: declaration of run, line 7
            - run   : BOOL;  # the contactor #
                               ^^^ ^^^^^^^^^
            + run   : BOOL;  # K1 #
                               ^^

                ... 2 the same

            other comments: network, line 15, writes run
            - # Start/stop with a seal-in contact #
                           ^^^^ ^ ^^^^^^^ ^^^^^^^
            - +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
            - |  /--[ ]( run )----/                                                        |
            + # Start/stop and hold #
                           ^^^ ^^^^
            + +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
            + |  /--[ ]( run )----/                                                        |

                ... 1 the same
        "#]],
    );
}

const LIGHTS: &str = "\
+--[ ]( a )--( )( red )--+

+--[ ]( b )--( )( green )--+

+--[ ]( c )--( )( blue )--+

+--[ ]( d )--[TON]( t, 3s )--( )( walk )--+
";

#[test]
fn one_preset_changed_one_network_moved_one_added() {
    let new = "\
+--[ ]( a )--( )( red )--+

+--[ ]( c )--( )( blue )--+

+--[ ]( d )--[TON]( t, 4s )--( )( walk )--+

+--[ ]( e )--( )( horn )--+

+--[ ]( b )--( )( green )--+
";
    check(
        LIGHTS,
        new,
        expect![[r#"
        --- old.clad
        +++ new.clad
            1 edited, 1 new, 1 moved, 2 the same

            ... 2 the same

        edited: network, line 5 (was line 7), writes t, walk
        - +--[ ]( d )-------------------------------------[TON]( t, 3s )--( )( walk )--+
                                                          ^^^^^^^^^^^^^^
        + +--[ ]( d )-------------------------------------[TON]( t, 4s )--( )( walk )--+
                                                          ^^^^^^^^^^^^^^

        new: network, line 7, writes horn
        + +--[ ]( e )-----------------------------------------------------( )( horn )--+

        moved: network, line 9 (was line 3), writes green
        > +--[ ]( b )----------------------------------------------------( )( green )--+
    "#]],
    );
}

#[test]
fn a_network_that_is_gone_is_where_it_was() {
    check(
        LIGHTS,
        &LIGHTS.replace("+--[ ]( b )--( )( green )--+\n\n", ""),
        expect![[r#"
            --- old.clad
            +++ new.clad
                1 gone, 3 the same

                ... 1 the same

            gone: network, was line 3, writes green
            - +--[ ]( b )----------------------------------------------------( )( green )--+

                ... 2 the same
        "#]],
    );
}

#[test]
fn functions_and_blocks_are_named() {
    let old = "\
+--<CALL>( mix )--+

+--<FUN>( mix )--+

+--[ ]( a )--( )( b )--+

FUNCTION_BLOCK [$Seal]
VAR_INPUT on : BOOL; END_VAR
+--[ ]( EN )--[ ]( on )--( )( ENO )--+
END_FUNCTION_BLOCK
";
    let new = old
        .replace("+--[ ]( a )", "+--[/]( a )")
        .replace("[ ]( on )", "[P]( on )")
        .replace("on : BOOL; ", "on : BOOL; off : BOOL; ");
    check(
        old,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                2 edited, 1 new, 3 the same

                ... 2 the same

            edited: network, line 5, in function mix, writes b
            - +--[ ]( a )--------------------------------------------------------( )( b )--+
                 ^^^^^^^^
            + +--[/]( a )--------------------------------------------------------( )( b )--+
                 ^^^^^^^^

                ... 1 the same

            new: declaration of off, line 8, in block $Seal
            + off : BOOL;

            edited: network, line 9, in block $Seal, writes ENO
            - +--[ ]( EN )--[ ]( on )------------------------------------------( )( ENO )--+
                            ^^^^^^^^^
            + +--[ ]( EN )--[P]( on )------------------------------------------( )( ENO )--+
                            ^^^^^^^^^
        "#]],
    );
}

#[test]
fn settings_and_types() {
    let old = "\
# ladder: profile iec #
# ladder: cycle 10ms #
TYPE
    Phase : (IDLE, RUN);
    Motor : STRUCT
        speed : REAL;
    END_STRUCT;
END_TYPE
+--[ ]( a )--( )( b )--+
";
    let new = old
        .replace("10ms", "20ms")
        .replace("RUN)", "RUN, STOP)")
        .replace("speed : REAL", "speed : LREAL");
    check(
        old,
        &new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                3 edited, 2 the same

                ... 1 the same

            edited: setting, line 2
            - # ladder: cycle 10ms #
                              ^^^^
            + # ladder: cycle 20ms #
                              ^^^^

            edited: declaration of Phase, line 4
            - Phase : (IDLE, RUN);
            + Phase : (IDLE, RUN, STOP);
                                ^ ^^^^

            edited: declaration of speed, line 6, in structure Motor
            - speed : REAL;
                      ^^^^
            + speed : LREAL;
                      ^^^^^

                ... 1 the same
        "#]],
    );
}

#[test]
fn a_broken_network_is_compared_by_its_words() {
    let old = "+--[ ]( a )--\\--( )( b )--+\n\n+--[ ]( a b )--( )( c )--+\n";
    let new = "+--[ ]( a )----\\--( )( b )--+\n\n+--[ ]( a d )--( )( c )--+\n";
    check(
        old,
        new,
        expect![[r#"
            --- old.clad
            +++ new.clad
                1 edited, 1 drawn differently

            drawn differently: network, line 1, writes b

            edited: network, line 3, writes d, c
            - +--[ ]( a b )------------------------------------------------------( )( c )--+
                 ^^^^^^^^^^
            + +--[ ]( a d )------------------------------------------------------( )( c )--+
                 ^^^^^^^^^^
        "#]],
    );
}
