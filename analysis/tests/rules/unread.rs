//! Unread parts: reported once, and nothing else of them.

use crate::check::{check, check_program};
use expect_test::expect;

#[test]
fn each_part_once_and_nothing_else_of_it() {
    check_program(
        "VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR done, seen : BOOL; END_VAR
# MSG: it is not run here. #
FUNCTION_BLOCK [$MSG]
VAR_INPUT operands : STRING[254] := ''; END_VAR
VAR_OUTPUT never : BOOL; END_VAR
# ladder: unread, writes done #
# +--[ ]( a )--( )( b )--+ #
+--(R)( ENO )--+
END_FUNCTION_BLOCK

+--[ ]( go )--( )( seen )--[$MSG]( 'control' )--+

+--[ ]( done )--[$MSG]( 'other' )--( )( lamp )--+
",
        expect![[r#""#]],
    );
}

#[test]
fn a_part_that_does_not_say_what_it_writes() {
    check_program(
        "VAR_GLOBAL shared : INT; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR done : BOOL; c : CTU; END_VAR
FUNCTION_BLOCK [$Calc]
# ladder: unread, at any time #
END_FUNCTION_BLOCK
+--[ ]( done )--[GT]( shared, 3 )--( )( lamp )--+
+--[ ]( done )--[CTU]( c, 5 )--+
+--[$Calc]--+
",
        expect![[r#""#]],
    );
}

#[test]
fn directives_that_are_not_understood() {
    check(
        "FUNCTION_BLOCK [$A]
# ladder: unread writes a #
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$B]
VAR_OUTPUT y : BOOL; END_VAR
# ladder: unread, writes y, z, q.r #
# ladder: unread #
END_FUNCTION_BLOCK
# ladder: unread #
+--[$B]( q )--( )( q )--+
",
        expect![[r#""#]],
    );
}
