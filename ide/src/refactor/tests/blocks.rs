//! Blocks become a user-defined block and come back.

use super::{check, titles};
use expect_test::expect;

#[test]
fn extract() {
    check(
        "Extract the selected",
        r"
VAR_INPUT raw : BOOL; wait : TIME; END_VAR
+--[ ]( on )--$0\--[ ]( raw )--[TON]( t, wait )--\--( )( clean )--$1( )( light )--+
|             /--[ ]( test )-------------------/                              |
",
        expect![[r#"
    Extract the selected blocks into the block `[$Block1]`


    VAR_INPUT raw : BOOL; wait : TIME; END_VAR
    +--[ ]( on )-------------[$Block1]( raw, wait, test, t, clean )--( )( light )--+

    FUNCTION_BLOCK [$Block1]
    VAR_INPUT
        raw  : BOOL;
        wait : TIME;
        test : BOOL;
    END_VAR
    VAR_IN_OUT
        t : TON;
    END_VAR
    VAR_OUTPUT
        clean : BOOL;
    END_VAR
    +--[ ]( EN )--\--[ ]( raw )-----[TON]( t, wait )--\--( )( clean )--( )( ENO )--+
    |             /--[ ]( test )----------------------/                            |
    END_FUNCTION_BLOCK
"#]],
    );
    check(
        "Extract the selected",
        "+--$0[ ]( a )--(M)( b )$1--+\n",
        expect![[r#"
        disabled: (M) makes a tag of the program retentive
    "#]],
    );
    check(
        "Extract the selected",
        "+--[ ]( a )--$0[ADD]( n, n, 1 )--[GT]( n, 5 )$1--( )( y )--+\n",
        expect![[r#"
            Extract the selected blocks into the block `[$Block1]`

            +--[ ]( a )------------------------------------------[$Block1]( n )--( )( y )--+

            FUNCTION_BLOCK [$Block1]
            VAR_IN_OUT
                n : DINT;
            END_VAR
            +--[ ]( EN )--[ADD]( n, n, 1 )--[GT]( n, 5 )-----------------------( )( ENO )--+
            END_FUNCTION_BLOCK
        "#]],
    );
}

const DEBOUNCE: &str = r"
FUNCTION_BLOCK [$Debounce]
VAR_INPUT   raw : BOOL;  wait : TIME;  END_VAR
VAR_OUTPUT  clean : BOOL;  END_VAR
VAR         t : TON;  END_VAR
+--[ ]( EN )--\--[ ]( raw )--[TON]( t, wait )--\--( )( clean )--( )( ENO )--+
|             /--[ ]( test.3 )-----------------/                            |
END_FUNCTION_BLOCK
VAR_GLOBAL test : WORD; END_VAR
";

#[test]
fn inline() {
    check(
        "Inline",
        &format!(
            "{DEBOUNCE}+--\\--[$Deb$0ounce]( button, T#20ms, pressed )--( )( light )--+\n|  /--[ ]( other )--( )( lamp )--+\n"
        ),
        expect![[r#"
            Inline the block `[$Debounce]` here


            FUNCTION_BLOCK [$Debounce]
            VAR_INPUT   raw : BOOL;  wait : TIME;  END_VAR
            VAR_OUTPUT  clean : BOOL;  END_VAR
            VAR         t : TON;  END_VAR
            +--[ ]( EN )--\--[ ]( raw )--[TON]( t, wait )--\--( )( clean )--( )( ENO )--+
            |             /--[ ]( test.3 )-----------------/                            |
            END_FUNCTION_BLOCK
            VAR_GLOBAL test : WORD; END_VAR
            VAR
                t : TON;
            END_VAR
            +--\-----\--[ ]( button )---------------------[TON]( t, T#20ms )--\--( )( pressed )--( )( light )--+
            |  /--\  /--[ ]( test.3 )-----------------------------------------/                                |
            |     /--[ ]( other )-----------------------------------------------------------------( )( lamp )--+
        "#]],
    );
    check(
        "Inline",
        &format!("{DEBOUNCE}+--[$Deb$0ounce]( button, T#20ms, button )--( )( light )--+\n"),
        expect![[r#"
            disabled: `button` is given for two operands, or used in the body too
        "#]],
    );
    titles(
        "FUNCTION_BLOCK [$B]\n+--[ ]( EN )--( )( ENO )--+\n+--( )( SYS.ON )--+\nEND_FUNCTION_BLOCK\n+--[$0$B]--( )( light )--+\n",
        expect![[r#"
            Draw a parallel contact `new_contact_1` around `[$B]` (no change while it is low)
            Wrap `[$B]` in a branch, with a copy in parallel (changes nothing yet) -- [$B] has an effect or a memory, and a copy would have them once more
            Extract the network into the function `function_1`
            Inline the block `[$B]` here -- fix the errors of the file first
            Give the state of `[$B]` the tag `b1` -- fix the errors of the file first
        "#]],
    );
}
