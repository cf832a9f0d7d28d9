//! VAR_GLOBAL tags in the files of a workspace (LANGUAGE §4).

use crate::check::{check_files, check_workspace};
use expect_test::expect;

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
                                                 ^ error[type-mismatch]: the number 2 is given, STRING is expected
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
                help: declare it, so that a typing error cannot make a new tag
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                                  ^^ error[duplicate-timer]: the timer `t1` has another block in b.clad: both would work on one TON
                help: give one of the blocks a timer of its own; to use the timer elsewhere read `t1.Q`
                at b.clad:1:21 `t1`: this is the other block
            > +--[ ]( x )--[TON]( t1, T#1s )--( )( y )--+
                                                   ^ warning[undeclared-tag]: `y` is not declared
                help: declare it, so that a typing error cannot make a new tag
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
