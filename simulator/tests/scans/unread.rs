//! Unread parts: a scan runs past them.

use crate::support::check;
use expect_test::expect;

const BLOCKS: &str = "FUNCTION_BLOCK [$Calc]
VAR_INPUT a : INT := 3; END_VAR
VAR_IN_OUT c : INT; END_VAR
VAR_OUTPUT b : INT; END_VAR
# ladder: unread #
# b := a * 2; c := b; #
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$Asks]
# ladder: unread, writes y #
+--(R)( ENO )--+
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$Task]
# ladder: unread, at any time #
END_FUNCTION_BLOCK
";

#[test]
fn it_writes_nothing_and_passes_power() {
    check(
        &format!(
            "{BLOCKS}VAR_INPUT go : BOOL; END_VAR
VAR r : INT := 8; s : INT := 9; y, z : BOOL; END_VAR
+--[ ]( go )--[$Calc]( 5, s, r )--( )( y )--+
+--[ ]( go )--[$Asks]--( )( z )--+
+--[$Task]--+
"
        ),
        "go _-_",
        "r s y z",
        expect![[r#"
            r  8 8 8
            s  9 9 9
            y  _-_
            z  ___
        "#]],
    );
}

#[test]
fn inputs_go_into_a_state() {
    check(
        &format!(
            "{BLOCKS}VAR_INPUT n : INT; END_VAR
VAR m : $Calc; r, s, seen : INT; END_VAR
+--[$Calc]( m, n, s, r )--[MOV]( seen, m.a )--+
"
        ),
        "n 1 2 3",
        "seen r s m.b",
        expect![[r#"
            seen  1 2 3
            r     0 0 0
            s     0 0 0
            m.b   0 0 0
        "#]],
    );
}
