//! The drawings by which the language is explained.

use expect_test::{Expect, expect};
use ladder_format::{Options, format_text};

/// As LANGUAGE §8 shows them.
fn options() -> Options {
    Options {
        width: 60,
        ..Options::default()
    }
}

#[track_caller]
fn stays(text: &str) {
    assert_eq!(format_text(text, &options()), text);
}

#[test]
fn canonical() {
    stays(
        r"+--[ ]( a )--\--[ ]( b )-----\-------------------( )( y )--+
|            /--[/]( x )--\--/                             |
+--[ ]( c )---------------/--[ ]( d )------------( )( z )--+

+--[ ]( a )--\--------------------------------( )( y )--\--+
|            /-----------------------( )( valve_open )--/  |

+--\--[ ]( a )--# was: b #--\--[/]( stop )-------( )( y )--+  # main pump #
|  /--[ ]( y )--------------/                              |  # seal-in #
",
    );
}

#[test]
fn start_stop() {
    stays(
        r"# Start/stop with a seal-in contact #
+--\--[ ]( start )--\--[/]( stop )-------------( )( run )--+
|  |                |                                      |
|  /--[ ]( run )----/                                      |

+--[ ]( run )---------[TON]( warmup, T#5s )--( )( ready )--+
",
    );
}

#[track_caller]
fn becomes(text: &str, expected: Expect) {
    let new = format_text(text, &options());
    expected.assert_eq(&new);
    stays(&new);
}

#[test]
fn side_by_side() {
    becomes(
        r"+--\--[ ]( a )--\-----\--[ ]( c )--\--( )( y )--+
|  /--[ ]( b )--/     /--[ ]( d )--/            |
",
        expect![[r#"
            +--\--[ ]( a )--\--\--[ ]( c )--\----------------( )( y )--+
            |  /--[ ]( b )--/  /--[ ]( d )--/                          |
        "#]],
    );
}

#[test]
fn three_branches() {
    becomes(
        r"+--\--[ ]( a )--------\--( )( y )--+
|  /--\--[ ]( b )--\--/            |
|     /--[ ]( c )--/               |
",
        expect![[r#"
            +--\--[ ]( a )--------\--------------------------( )( y )--+
            |  /--\--[ ]( b )--\--/                                    |
            |     /--[ ]( c )--/                                       |
        "#]],
    );
}

#[test]
fn a_branch_that_passes_a_line() {
    becomes(
        r"+--\-----\--[ ]( a )--\-----\--( )( y )--+
|  /--\  /--[ ]( b )--/  \--/            |
|     /--[ ]( c )--------/               |
",
        expect![[r#"
            +--\-----\--[ ]( a )--\-----\--------------------( )( y )--+
            |  /--\  /--[ ]( b )--/  \--/                              |
            |     /--[ ]( c )--------/                                 |
        "#]],
    );
}

#[test]
fn a_user_defined_block() {
    becomes(
        r"FUNCTION_BLOCK [$Debounce]
VAR_INPUT   raw : BOOL;  wait : TIME;  END_VAR
VAR_OUTPUT  clean : BOOL;  END_VAR
VAR         t : TON;  END_VAR
+--[ ]( EN )--[ ]( raw )--[TON]( t, wait )--( )( clean )--( )( ENO )--+
END_FUNCTION_BLOCK

+--[$Debounce]( button, T#20ms, pressed )--( )( light )--+
",
        expect![[r#"
            FUNCTION_BLOCK [$Debounce]
            VAR_INPUT
                raw  : BOOL;
                wait : TIME;
            END_VAR
            VAR_OUTPUT
                clean : BOOL;
            END_VAR
            VAR
                t : TON;
            END_VAR
            +--[ ]( EN )--[ ]( raw )-----------[TON]( t, wait )--( )( clean )--( )( ENO )--+
            END_FUNCTION_BLOCK

            +----[$Debounce]( button, T#20ms, pressed )--( )( light )--+
        "#]],
    );
}

#[test]
fn sections() {
    becomes(
        r"VAR_INPUT
    start, stop : BOOL;
    level  AT %IW3 : INT;
END_VAR
VAR_OUTPUT  run : BOOL;  END_VAR
VAR RETAIN  total : DINT := 0;  END_VAR
VAR CONSTANT  limit : INT := 80;  END_VAR
",
        expect![[r#"
            VAR_INPUT
                start, stop         : BOOL;
                level       AT %IW3 : INT;
            END_VAR
            VAR_OUTPUT
                run : BOOL;
            END_VAR
            VAR RETAIN
                total : DINT := 0;
            END_VAR
            VAR CONSTANT
                limit : INT := 80;
            END_VAR
        "#]],
    );
}
