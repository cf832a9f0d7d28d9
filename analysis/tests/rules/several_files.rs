//! What the files of a workspace see of each other (LANGUAGE §4, §5.7).

use crate::check::{check_files, check_workspace};
use expect_test::expect;

#[test]
fn globals_functions_and_blocks_are_seen() {
    check_files(
        "\
%% main.clad
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
+--[ ]( go )--<CALL>( count )--+
+--[$Hold]( go, lamp )--[GT]( total, 3 )--( )( alarm )--+
%% library.clad
VAR_GLOBAL total : DINT; alarm : BOOL; END_VAR
+--[ ]( x )--( )( y )--+
+--<FUN>( count )--[ADD]( total, total, 1 )--+
FUNCTION_BLOCK [$Hold]
VAR_INPUT a : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
+--[ ]( a )--(S)( q )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            == library.clad
            > +--[ ]( x )--( )( y )--+
                      ^ warning[undeclared-tag]: `x` is not declared
                help: declare it, so that a typing mistake cannot make a new tag
            > +--[ ]( x )--( )( y )--+
                                ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing mistake cannot make a new tag
        "#]],
    );
}

#[test]
fn other_tags_belong_to_their_file() {
    check_files(
        "\
%% main.clad
VAR_INPUT go : BOOL; END_VAR
+--[ ]( go )--( )( lamp )--+
%% other.clad
VAR_OUTPUT lamp : BOOL; END_VAR
+--[ ]( SYS.ON )--( )( lamp )--+
",
        expect![[r#"
            == main.clad
            > +--[ ]( go )--( )( lamp )--+
                                 ^^^^ warning[undeclared-tag]: `lamp` is not declared
                help: declare it, so that a typing mistake cannot make a new tag
        "#]],
    );
}

#[test]
fn a_name_is_looked_up_in_its_own_file_first() {
    check_files(
        "\
%% a.clad
+--<CALL>( f )--[$B]--( )( y )--+
+--<FUN>( f )--( )( z )--+
FUNCTION_BLOCK [$B]
+--( )( ENO )--+
END_FUNCTION_BLOCK
%% b.clad
+--<CALL>( f )--[$B]--( )( y )--+
+--<FUN>( f )--( )( z )--+
FUNCTION_BLOCK [$B]
+--( )( ENO )--+
END_FUNCTION_BLOCK
",
        expect![[r#""#]],
    );
}

#[test]
fn what_two_other_files_define_is_an_error_where_a_third_uses_it() {
    check_files(
        "\
%% a.clad
+--<FUN>( f )--( )( z )--+
FUNCTION_BLOCK [$B]
+--( )( ENO )--+
END_FUNCTION_BLOCK
%% b.clad
+--<FUN>( F )--( )( z )--+
FUNCTION_BLOCK [$b]
+--( )( ENO )--+
END_FUNCTION_BLOCK
%% c.clad
+--<CALL>( f )--[$B]--( )( y )--+
%% d.clad
+--( )( y )--+
",
        expect![[r#"
            == c.clad
            > +--<CALL>( f )--[$B]--( )( y )--+
                         ^ error[duplicate-function]: several files define the function `f`: which one is called here is open
                help: rename all but one of them, or define the function in this file
                at a.clad:1:11 `f`: it is defined here
                at b.clad:1:11 `F`: it is defined here
            > +--<CALL>( f )--[$B]--( )( y )--+
                              ^^^^ error[duplicate-block]: several files define the block `$B`: which one [$B] means is open
                help: rename all but one of them, or define the block in this file
                at a.clad:2:16 `[$B]`: it is defined here
                at b.clad:2:16 `[$b]`: it is defined here
        "#]],
    );
}

#[test]
fn what_nobody_defines_is_looked_for_in_all_files() {
    check_files(
        "\
%% a.clad
+--<FUN>( rotate )--( )( z )--+
FUNCTION_BLOCK [$Filter]
+--( )( ENO )--+
END_FUNCTION_BLOCK
%% b.clad
+--<CALL>( rotat )--[$Filtre]--($Filter)--+
",
        expect![[r#"
            == b.clad
            > +--<CALL>( rotat )--[$Filtre]--($Filter)--+
                         ^^^^^ error[unknown-function]: there is no function `rotat`
                help: did you mean `rotate`?
            > +--<CALL>( rotat )--[$Filtre]--($Filter)--+
                                  ^^^^^^^^^ error[unknown-block]: there is no block [$Filtre]
                help: did you mean [$Filter]?
            > +--<CALL>( rotat )--[$Filtre]--($Filter)--+
                                             ^^^^^^^^^ error[wrong-shape]: the block is drawn [$Filter], not ($Filter)
                help: a block keeps the brackets of its definition
                at a.clad:2:16 `[$Filter]`: it is defined here
        "#]],
    );
}

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
                           ^ error[type-mismatch]: this is TIME, INT is expected here
                help: convert it with [TYP]( result, value ) into an INT first
            > +--[$Scale]( t, 3, b, 4 )--+
                                    ^ error[bad-arity]: [$Scale] takes 3 operands, 4 are given
                help: it is written [$Scale]( raw, factor, scaled )
                at lib.clad:1:16 `[$Scale]`: the block is defined here
            > +--[$Scale]( 1, 3, t )--+
                                 ^ error[type-mismatch]: this is INT, TIME is expected here
                help: convert it with [TYP]( result, value ) into a TIME first
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
fn globals_of_one_name_agree() {
    check_files(
        "\
%% a.clad
VAR_GLOBAL speed : INT := 3; level : INT; END_VAR
%% b.clad
VAR_GLOBAL speed : INT := 4; level : DINT; END_VAR
%% c.clad
VAR_GLOBAL RETAIN speed : INT := 3; END_VAR
+--[MOV]( speed, 1 )--+
%% d.clad
+--[MOV]( level, 1 )--[MOV]( level, 2 )--+
",
        expect![[r#"
            == a.clad
            > VAR_GLOBAL speed : INT := 3; level : INT; END_VAR
                         ^^^^^ error[duplicate-declaration]: `speed` starts with another value in b.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at b.clad:1:12 `speed`: `speed` is declared here as well
            > VAR_GLOBAL speed : INT := 3; level : INT; END_VAR
                                           ^^^^^ error[duplicate-declaration]: `level` is DINT in b.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at b.clad:1:30 `level`: `level` is declared here as well
            == b.clad
            > VAR_GLOBAL speed : INT := 4; level : DINT; END_VAR
                         ^^^^^ error[duplicate-declaration]: `speed` starts with another value in a.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at a.clad:1:12 `speed`: `speed` is declared here as well
            > VAR_GLOBAL speed : INT := 4; level : DINT; END_VAR
                                           ^^^^^ error[duplicate-declaration]: `level` is INT in a.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at a.clad:1:30 `level`: `level` is declared here as well
            == c.clad
            > VAR_GLOBAL RETAIN speed : INT := 3; END_VAR
                                ^^^^^ error[duplicate-declaration]: `speed` starts with another value in b.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at b.clad:1:12 `speed`: `speed` is declared here as well
            == d.clad
            > +--[MOV]( level, 1 )--[MOV]( level, 2 )--+
                        ^^^^^ error[duplicate-declaration]: `level` is declared in a.clad and in b.clad, and not alike
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at a.clad:1:30 `level`: `level` is declared here
                at b.clad:1:30 `level`: and here
        "#]],
    );
}

#[test]
fn a_global_of_another_file_has_its_type_and_may_be_constant() {
    check_files(
        "\
%% a.clad
VAR_GLOBAL CONSTANT limit : INT := 3; END_VAR
VAR_GLOBAL text : STRING; t1 : TON; list : ARRAY[1..4] OF INT; END_VAR
%% b.clad
+--[MOV]( limit, 1 )--[MOV]( text, 2 )--[ADD]( list[9], list[1], 1 )--+
+--[ ]( t1.Q )--[ ]( t1.CV )--( )( y )--+
",
        expect![[r#"
            == b.clad
            > +--[MOV]( limit, 1 )--[MOV]( text, 2 )--[ADD]( list[9], list[1], 1 )--+
                        ^^^^^ error[constant-write]: `limit` is a constant: no block may write it
                help: declare it in a VAR section without CONSTANT, or write another tag
                at a.clad:1:21 `limit`: `limit` is declared CONSTANT here
            > +--[MOV]( limit, 1 )--[MOV]( text, 2 )--[ADD]( list[9], list[1], 1 )--+
                                                 ^ error[type-mismatch]: the number 2 is no STRING
            > +--[MOV]( limit, 1 )--[MOV]( text, 2 )--[ADD]( list[9], list[1], 1 )--+
                                                                  ^ error[bad-operand]: `list` has the elements 1 to 4, there is no 9
            > +--[ ]( t1.Q )--[ ]( t1.CV )--( )( y )--+
                                      ^^ error[unknown-member]: `t1` is a TON and has no member `CV`
                help: its members are IN PT Q ET R TT
        "#]],
    );
}

#[test]
fn external_names_a_global() {
    check_files(
        "\
%% a.clad
VAR_GLOBAL level : INT; END_VAR
%% b.clad
VAR_EXTERNAL level : INT; END_VAR
+--[MOV]( level, 1 )--+
%% c.clad
VAR_EXTERNAL level : DINT; levle : INT; END_VAR
+--[MOV]( level, 1 )--+
%% d.clad
VAR_GLOBAL own : BOOL; END_VAR
VAR_EXTERNAL other : BOOL; END_VAR
FUNCTION_BLOCK [$B]
VAR_EXTERNAL own : INT; level : INT; END_VAR
+--[MOV]( level, 1 )--+
END_FUNCTION_BLOCK
",
        expect![[r#"
            == c.clad
            > VAR_EXTERNAL level : DINT; levle : INT; END_VAR
                           ^^^^^ error[bad-declaration]: `level` is DINT here, the global of this name is INT
                help: write the type of the global
            > VAR_EXTERNAL level : DINT; levle : INT; END_VAR
                                         ^^^^^ error[bad-declaration]: no file of the workspace declares `levle` as VAR_GLOBAL
                help: VAR_EXTERNAL names a global that is declared elsewhere: declare it, or correct the name
            == d.clad
            > VAR_EXTERNAL other : BOOL; END_VAR
                           ^^^^^ error[bad-declaration]: no file of the workspace declares `other` as VAR_GLOBAL
                help: VAR_EXTERNAL names a global that is declared elsewhere: declare it, or correct the name
            > VAR_EXTERNAL own : INT; level : INT; END_VAR
                           ^^^ error[bad-declaration]: `own` is INT here, the global of this name is BOOL
                help: write the type of the global
                at 1:12 `own`: the global is declared here
        "#]],
    );
}

#[test]
fn a_section_in_a_body_introduces_the_tag_to_the_workspace() {
    check_files(
        "\
%% lib.clad
FUNCTION_BLOCK [$Count]
VAR_GLOBAL counted : DINT; END_VAR
+--[ADD]( counted, counted, 1 )--+
END_FUNCTION_BLOCK
%% main.clad
VAR_INPUT go : BOOL; END_VAR
+--[ ]( go )--[$Count]--[MOV]( counted, 0 )--+
",
        expect![[r#""#]],
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
                help: declare it, so that a typing mistake cannot make a new tag
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

#[test]
fn a_global_timer_belongs_to_one_block_of_the_workspace() {
    check_files(
        "\
%% a.clad
VAR_GLOBAL t1 : TON; END_VAR
+--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
%% b.clad
+--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
%% c.clad
+--[ ]( t1.Q )--( )( y )--+
%% d.clad
VAR t1 : TON; END_VAR
VAR x, y : BOOL; END_VAR
+--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
",
        expect![[r#"
            == a.clad
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                      ^ warning[undeclared-tag]: `x` is not declared
                help: declare it, so that a typing mistake cannot make a new tag
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                                  ^^ error[duplicate-timer]: the timer `t1` has another block in b.clad: both would work on one TON
                help: give one of the blocks a timer of its own; to use the timer elsewhere read `t1.Q`
                at b.clad:1:21 `t1`: this is the other block
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                                                   ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing mistake cannot make a new tag
            == b.clad
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                                  ^^ error[duplicate-timer]: the timer `t1` has another block in a.clad: both would work on one TON
                help: give one of the blocks a timer of its own; to use the timer elsewhere read `t1.Q`
                at a.clad:2:21 `t1`: this is the other block
        "#]],
    );
}

#[test]
fn globals_are_counted_over_all_files() {
    check_workspace(
        "\
%% globals.clad
VAR_GLOBAL
    used, only_read, only_written, never_used : BOOL;
    preset : INT := 5;
    shown : DINT;
END_VAR
%% main.clad
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR_GLOBAL of_main, kept : BOOL; END_VAR
+--[ ]( go )--[GT]( preset, 3 )--( )( used )--( )( only_written )--( )( of_main )--+
+--[ ]( only_read )--[ ]( kept )--[ADD]( shown, shown, 1 )--( )( lamp )--+
%% second.clad
VAR_EXTERNAL kept : BOOL; END_VAR
VAR_OUTPUT y : BOOL; END_VAR
+--[ ]( used )--( )( y )--( )( kept )--+
",
        expect![[r#"
            == globals.clad
            >     used, only_read, only_written, never_used : BOOL;
                        ^^^^^^^^^ info[never-written]: the global `only_read` is read, and no file of the workspace writes it: it stays off
                help: write it; or give it a value and declare it CONSTANT
            >     used, only_read, only_written, never_used : BOOL;
                                                 ^^^^^^^^^^ info[never-read]: the global `never_used` is declared, and no file of the workspace uses it
                help: use it, or remove its declaration
            == main.clad
            > VAR_GLOBAL of_main, kept : BOOL; END_VAR
                         ^^^^^^^ info[never-read]: the global `of_main` is written, and no file of the workspace reads it
                help: read it where it is meant to act, or remove it
        "#]],
    );
}

#[test]
fn what_cannot_be_read_may_use_anything() {
    check_workspace(
        "\
%% globals.clad
VAR_GLOBAL a, b, c, d : BOOL; END_VAR
%% main.clad
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
+--[ ]( go )--( )( lamp )--<CALL>( f )--+
+--<FUN>( f )--( )( lamp )--+
+--<FUN>( g )--( )( lamp )--+
%% broken.clad
+--[ ]( a )--? b --[TOM]( c )--<CALL>( g )--[$Other]( d )--+
",
        expect![[r#"
            == broken.clad
            > +--[ ]( a )--? b --[TOM]( c )--<CALL>( g )--[$Other]( d )--+
                           ^^^ error[unexpected-character]: `? b` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
}

#[test]
fn functions_are_counted_over_all_files() {
    check_workspace(
        "\
%% library.clad
VAR_OUTPUT y : BOOL; END_VAR
+--( )( y )--<CALL>( own )--+
+--<FUN>( own )--(S)( y )--+
+--<FUN>( called )--(R)( y )--+
+--<FUN>( idle )--(R)( y )--+
+--<FUN>( hidden )--(R)( y )--+
%% functions_only.clad
+--<FUN>( for_others )--<RET>--+
%% main.clad
VAR_OUTPUT z : BOOL; END_VAR
+--( )( z )--<CALL>( CALLED )--<CALL>( hidden )--+
+--<FUN>( hidden )--(S)( z )--+
",
        expect![[r#"
            == library.clad
            > +--<FUN>( idle )--(R)( y )--+
                        ^^^^ info[unused-function]: no file of the workspace calls the function `idle`
                help: call it with <CALL>( idle ), or remove it
            > +--<FUN>( hidden )--(R)( y )--+
                        ^^^^^^ info[unused-function]: no file of the workspace calls the function `hidden`
                help: call it with <CALL>( hidden ), or remove it
        "#]],
    );
}

#[test]
fn a_global_of_several_files_is_reported_once() {
    check_workspace(
        "\
%% a.clad
VAR_GLOBAL x : BOOL; END_VAR
VAR_OUTPUT y : BOOL; END_VAR
+--( )( y )--( )( x )--+
%% b.clad
VAR_GLOBAL x : BOOL; END_VAR
VAR_OUTPUT z : BOOL; END_VAR
+--( )( z )--+
",
        expect![[r#"
            == a.clad
            > VAR_GLOBAL x : BOOL; END_VAR
                         ^ info[never-read]: the global `x` is written, and no file of the workspace reads it
                help: read it where it is meant to act, or remove it
        "#]],
    );
}

#[test]
fn a_global_of_another_file_may_lie_at_an_address() {
    check_files(
        "\
%% main.clad
VAR own AT %MD3 : REAL; bit AT %MX8.0 : BOOL; END_VAR
+--[GT]( own, 1.0 )--[ ]( bit )--[MOV]( level, 5 )--[MOV]( high, 5 )--+
%% library.clad
VAR_GLOBAL level AT %MD3 : DINT; high AT %MW4 : INT; END_VAR
%% again.clad
VAR_GLOBAL high AT %MW5 : INT; END_VAR
",
        expect![[r#"
            == main.clad
            > +--[GT]( own, 1.0 )--[ ]( bit )--[MOV]( level, 5 )--[MOV]( high, 5 )--+
                                                      ^^^^^ error[duplicate-declaration]: `level` is DINT, and `own` at the same address %MD3 is REAL
                help: an address is one tag, whatever its names: they agree in type, initial value and CONSTANT
                at 1:5 `own`: `own` is declared here
            > +--[GT]( own, 1.0 )--[ ]( bit )--[MOV]( level, 5 )--[MOV]( high, 5 )--+
                                                                         ^^^^ error[duplicate-declaration]: `high` is declared in library.clad and in again.clad, and not alike
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at library.clad:1:34 `high`: `high` is declared here
                at again.clad:1:12 `high`: and here
            > +--[GT]( own, 1.0 )--[ ]( bit )--[MOV]( level, 5 )--[MOV]( high, 5 )--+
                                                                         ^^^^ warning[overlapping-address]: `high` at %MW4 and `bit` at %MX8.0 would share memory in a controller; here each is a tag of its own
                help: use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]
                at 1:25 `bit`: `bit` at %MX8.0 is here
            == library.clad
            > VAR_GLOBAL level AT %MD3 : DINT; high AT %MW4 : INT; END_VAR
                                               ^^^^ error[duplicate-declaration]: `high` lies at another address in again.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at again.clad:1:12 `high`: `high` is declared here as well
            == again.clad
            > VAR_GLOBAL high AT %MW5 : INT; END_VAR
                         ^^^^ error[duplicate-declaration]: `high` lies at another address in library.clad
                help: a global is one tag for the whole workspace: its declarations agree in type, initial value and address
                at library.clad:1:34 `high`: `high` is declared here as well
        "#]],
    );
}
