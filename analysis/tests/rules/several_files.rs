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
                help: declare it, so that a typing error cannot make a new tag
            > +--[ ]( x )--( )( y )--+
                                ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
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
                help: declare it, so that a typing error cannot make a new tag
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

/// It hides what it is about in its own file only.
#[test]
fn an_open_comment_hides_no_place_in_another_file() {
    check_files(
        "\
%% a.clad
+--[ ]( a_long_name )--[ ]( another_long_name )--( )( z )--+
+--<FUN>( f )--( )( z )--+
%% b.clad
+--[ ]( a_long_name )--[ ]( another_long_name )--( )( z )--+
+--<FUN>( f )--( )( z )--+
%% c.clad
+--<CALL>( f )--+
# open
",
        expect![[r#"
            == c.clad
            > +--<CALL>( f )--+
                         ^ error[duplicate-function]: several files define the function `f`: which one is called here is open
                help: rename all but one of them, or define the function in this file
                at a.clad:2:11 `f`: it is defined here
                at b.clad:2:11 `f`: it is defined here
            > # open
              ^ error[unclosed-comment]: this comment is never closed: all that follows is read as comment
                help: close it with a second `#`
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
