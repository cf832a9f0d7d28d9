//! Blocks of another file of the workspace, and what their bodies see (LANGUAGE §5.7).

use crate::check::check_files;
use expect_test::expect;

#[test]
fn operands_of_a_block_in_another_file_are_checked() {
    check_files(
        "\
%% lib.clad
FUNCTION_BLOCK [$Scale]
VAR_INPUT raw : INT; factor : INT := 2; END_VAR
VAR_OUTPUT scaled : INT; END_VAR
+--[MUL]( scaled, raw, factor )--+
END_FUNCTION_BLOCK
%% main.clad
VAR a, b : INT; t : TIME; END_VAR
+--[$Scale]( a )--+
+--[$Scale]( a, 3, b )--+
+--[$Scale]( a, scaled => b )--+
+--[$Scale]( t, 3, b, 4 )--+
+--[$Scale]( 1, 3, t )--+
+--[$Scale]( factr := 1, raw := 2 )--+
+--[$Scale]( scaled => b )--+
",
        expect![[r#"
            == main.clad
            > +--[$Scale]( t, 3, b, 4 )--+
                           ^ error[type-mismatch]: `t` is TIME, and `raw` of [$Scale] takes INT
                help: convert it with [TYP]( result, value ) into an INT first
            > +--[$Scale]( t, 3, b, 4 )--+
                                    ^ error[bad-arity]: [$Scale] takes 3 operands, 4 are given
                help: it is written [$Scale]( raw, factor, scaled )
                at lib.clad:1:16 `[$Scale]`: the block is defined here
            > +--[$Scale]( 1, 3, t )--+
                                 ^ error[type-mismatch]: `t` is TIME, and the output `scaled` is INT
                help: give a tag of type INT, and convert it with [TYP]( result, value ) afterwards
            > +--[$Scale]( factr := 1, raw := 2 )--+
                           ^^^^^ error[bad-operand]: [$Scale] has no operand of the name `factr`
                help: did you mean `factor`?
            > +--[$Scale]( scaled => b )--+
                 ^^^^^^^^^^^^^^^^^^^^^^^ error[bad-arity]: the operand `raw` of [$Scale] is missing
                help: it is written [$Scale]( raw, factor, scaled )
                at lib.clad:1:16 `[$Scale]`: the block is defined here
        "#]],
    );
}

#[test]
fn a_body_sees_globals_of_other_files_and_no_other_tags() {
    check_files(
        "\
%% lib.clad
VAR_GLOBAL seen : BOOL; END_VAR
VAR hidden : BOOL; END_VAR
%% main.clad
VAR seen : INT; END_VAR
+--[$B]--( )( y )--+
+--[MOV]( seen, 3 )--+
FUNCTION_BLOCK [$B]
+--[ ]( seen )--[ ]( hidden )--( )( ENO )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            == main.clad
            > +--[$B]--( )( y )--+
                            ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
            > +--[ ]( seen )--[ ]( hidden )--( )( ENO )--+
                                   ^^^^^^ error[undeclared-tag]: `hidden` is not declared in the block `$B`
                help: a block sees its own tags and VAR_GLOBAL tags only: declare it in the block
        "#]],
    );
}

#[test]
fn a_block_never_uses_itself_not_even_through_other_files() {
    check_files(
        "\
%% a.clad
FUNCTION_BLOCK [$A]
+--[$B]--( )( ENO )--+
END_FUNCTION_BLOCK
%% b.clad
FUNCTION_BLOCK [$B]
+--[$C]--( )( ENO )--+
END_FUNCTION_BLOCK
FUNCTION_BLOCK [$C]
+--[$A]--( )( ENO )--+
END_FUNCTION_BLOCK
%% c.clad
+--[$A]--( )( y )--+
",
        expect![[r#"
            == a.clad
            > FUNCTION_BLOCK [$A]
                             ^^^^ error[recursive-block]: the block `$A` uses itself: it uses `$B`, which uses `$C`, which uses `$A`
                help: every place of a block has a state of its own, so a block cannot contain itself: break the circle
                at 2:4 `[$B]`: `$B` is used here
                at b.clad:2:4 `[$C]`: `$C` is used here
                at b.clad:5:4 `[$A]`: `$A` is used here
            == b.clad
            > FUNCTION_BLOCK [$B]
                             ^^^^ error[recursive-block]: the block `$B` uses itself: it uses `$C`, which uses `$A`, which uses `$B`
                help: every place of a block has a state of its own, so a block cannot contain itself: break the circle
                at 2:4 `[$C]`: `$C` is used here
                at 5:4 `[$A]`: `$A` is used here
                at a.clad:2:4 `[$B]`: `$B` is used here
        "#]],
    );
}

#[test]
fn labels_of_a_block_in_another_file_are_looked_up_where_it_stands() {
    check_files(
        "\
%% lib.clad
FUNCTION_BLOCK <$Leave>
+--<JMP>( out )--+
END_FUNCTION_BLOCK
FUNCTION_BLOCK <$Outer>
+--<$Leave>--<JMP>( own )--+
+--<LBL>( own )--+
END_FUNCTION_BLOCK
%% good.clad
+--[ ]( a )--<$Leave>--<$Outer>--+
+--<LBL>( out )--( )( y )--+
%% bad.clad
+--[ ]( a )--<$Leave>--<$Outer>--+
",
        expect![[r#"
            == bad.clad
            > +--[ ]( a )--<$Leave>--<$Outer>--+
                           ^^^^^^^^ error[unknown-label]: the block `$Leave` jumps to the label `out`, which is not here
                help: mark a network with <LBL>( out )
                at lib.clad:2:11 `out`: this is the jump
            > +--[ ]( a )--<$Leave>--<$Outer>--+
                                     ^^^^^^^^ error[unknown-label]: the block `$Outer` jumps to the label `out`, which is not here
                help: mark a network with <LBL>( out )
                at lib.clad:2:11 `out`: this is the jump
        "#]],
    );
}

/// Whether the states of a block keep what its body writes into an input follows from all files that use it.
#[test]
fn an_input_is_kept_if_no_file_gives_it() {
    let block = "%% lib.clad\nFUNCTION_BLOCK [$Once]\nVAR_INPUT\n    go : BOOL;\n    more : BOOL;\nEND_VAR\n+--[ ]( go )--[ ]( more )--(R)( go )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let uses = "%% use.clad\nVAR\n    once : $Once;\nEND_VAR\n+--[ ]( I1 )--(S)( once.go )--+\n";
    check_files(
        &format!("{block}{uses}+--[$Once]( once, more := I2 )--( )( Q1 )--+\n"),
        expect![[r#""#]],
    );
    check_files(
        &format!("{block}{uses}+--[$Once]( once, I3, I2 )--( )( Q1 )--+\n"),
        expect![[r#"
            == lib.clad
            > +--[ ]( go )--[ ]( more )--(R)( go )--( )( ENO )--+
                                              ^^ warning[input-written]: `go` is an input of the block, and is written here: its caller gives it again each time the block runs
                help: write a tag of its own, and read that instead of the input where it is needed
                at 3:5 `go`: `go` is declared as an input here
            == use.clad
            > +--[ ]( I1 )--(S)( once.go )--+
                                 ^^^^ warning[input-written]: `once.go` is an input of $Once, and is written here: the block is given it again each time it runs
                help: leave `go` out where the block is, or give it the value there
                at 5:13 `once`: the block is given `go` here
        "#]],
    );
}
