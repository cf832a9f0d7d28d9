//! Brackets, comments, characters, wires.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn first_part_that_is_not_closed() {
    check("+--[TON( t, T#5s )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--<JMP( there )--+\n\n+--<LBL>( there )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--( ( y )--+\n", expect![[r#""#]]);
    check("+--[TON)( t, T#5s )--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn operand_list_that_is_not_closed() {
    check("+--[ ]( start --( )( y )--+\n", expect![[r#""#]]);
    check("+--[TON]( warmup, T#5s--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a[3 )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--( )( y", expect![[r#""#]]);
}

#[test]
fn unclosed_block_brings_nothing_else() {
    check(
        "+--\\--[ ]( a --\\--( )( y )--+\n|  /--[ ]( b )--/            |\n",
        expect![[r#""#]],
    );
}

#[test]
fn comment_that_is_not_closed() {
    check("+--[ ]( a )--( )( y )--+  # the motor\n", expect![[r#""#]]);
    check(
        "# start\n+--[ ]( a )--( )( y )--+\n# stop #\n+--[ ]( b )--<JMP>( nowhere )--+\n",
        expect![[r#""#]],
    );
    // What stands before is still found; what a name means may be behind.
    check(
        "+--[TOM]( t, 5s )--<JMP>( there )--+\n# mark\n+--<LBL>( there )--( )( y )--+\n",
        expect![[r#""#]],
    );
    check("+--[ ]( a # b )--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn stray_characters() {
    check("+--[ ]( a )--?--( )( y )--+\n", expect![[r#""#]]);
    check("+--start--( )( y )--+\n", expect![[r#""#]]);
    check("hello world\n\n+--[ ]( a )--( )( y )--+\n", expect![[r#""#]]);
    check("+──[ ]( a )──( )( y )--+\n", expect![[r#""#]]);
    check("+--[T!ON]( t, 5s )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a & b )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[$my_block]( a )--( )( y )--+\n", expect![[r#""#]]);
    // The comment of a commented-out timer ends at the # of its literal.
    check("# +--[TON]( t, T#5s )--( )( y )--+ #\n+--[ ]( a )--( )( y )--+\n", expect![[r#""#]]);
}

#[test]
fn blocks_that_touch() {
    check("+--[ ]( a )[ ]( b )--( )( y )--+\n", expect![[r#""#]]);
    check(
        "+--\\[ ]( a )\\--( )( y )+\n|  /[ ]( b )/           |\n",
        expect![[r#""#]],
    );
    check("+--[ ]( a )--[OSR]( )( y )--+\n", expect![[r#""#]]);
    check("+--[ ]( a )--[NOT] (S)( y )--+\n", expect![[r#""#]]);
    // A comment is wire.
    clean("+--[ ]( a )# here #[ ]( b )--( )( y )--+\n");
}

#[test]
fn declarations_that_cannot_be_read() {
    check("VAR\n    a BOOL;\n    b : ;\n    : INT;\n    c : INT\nEND_VAR\n", expect![[r#""#]]);
    check("VAR\n    a : ARRAY[1 .. OF INT;\n    b AT : BOOL;\n    c : INT := ;\nEND_VAR\n", expect![[r#""#]]);
    check("VAR\n    a : BOOL;\n\n+--[ ]( a )--( )( a )--+\n", expect![[r#""#]]);
    check("END_VAR\nFUNCTION_BLOCK\nEND_FUNCTION_BLOCK\nEND_FUNCTION_BLOCK\n", expect![[r#""#]]);
    check("FUNCTION_BLOCK [$A]\nFUNCTION_BLOCK [$B]\n", expect![[r#""#]]);
    check("VAR a : BOL; END : INT; b : STRING[0]; END_VAR\n", expect![[r#""#]]);
}

#[test]
fn literals() {
    check("+--[EQ]( s, 'open )--( )( y )--+\n", expect![[r#""#]]);
    check("+--[GT]( n, 12x )--[TON]( t, T#5x )--( )( y )--+\n", expect![[r#""#]]);
}
