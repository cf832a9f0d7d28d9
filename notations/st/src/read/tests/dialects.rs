//! What other tools write around Structured Text, and what their compilers take.

use super::check_file;
use expect_test::expect;

#[test]
fn text_in_c_is_unread_alone() {
    check_file(
        "FUNCTION_BLOCK Log VAR_INPUT on : BOOL; END_VAR VAR n : INT; END_VAR\n  n := 1;\n  {{ puts(\"}\"); }}\n  {n++;}\nEND_FUNCTION_BLOCK\n\
         PROGRAM Main VAR a, b : BOOL; END_VAR\n  a := b;\n  IF a THEN {stop();} END_IF;\n  b := TRUE;\nEND_PROGRAM\n",
        &expect![[r##"
            # line 3 of Log: it is text in C, or for the compiler; it is not run here. #
            FUNCTION_BLOCK [$line_3_of_Log]
            # ladder: unread #
            # {{ puts("}"); }} #
            END_FUNCTION_BLOCK

            # line 4 of Log: it is text in C, or for the compiler; it is not run here. #
            FUNCTION_BLOCK [$line_4_of_Log]
            # ladder: unread #
            # {n++;} #
            END_FUNCTION_BLOCK

            # line 8 of Main: it is text in C, or for the compiler; it is not run here. #
            FUNCTION_BLOCK [$line_8_of_Main]
            # ladder: unread #
            # {stop();} #
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Log]
            VAR_INPUT
                on : BOOL;
            END_VAR
            VAR
                n : INT;
            END_VAR

            +---------------------------------------------------------------[MOV]( n, 1 )--+
            +------------------------------------------------------------[$line_3_of_Log]--+
            +------------------------------------------------------------[$line_4_of_Log]--+
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                b : BOOL;
            END_VAR

            +--[ ]( b )----------------------------------------------------------( )( a )--+

            # IF a THEN #
            +--[/]( a )---------------------------------------------------<JMP>( endif1 )--+
            +-----------------------------------------------------------[$line_8_of_Main]--+
            +--<LBL>( endif1 )-------------------------------------------[MOV]( b, TRUE )--+
            3:3: {{ puts("}"); }}: it is text in C, or for the compiler: it is not run
            4:3: {n++;}: it is text in C, or for the compiler: it is not run
            8:13: {stop();}: it is text in C, or for the compiler: it is not run
        "##]],
    );
}

#[test]
fn a_choice_of_what_is_compiled_makes_the_body_unread() {
    check_file(
        "PROGRAM Main VAR a : BOOL; END_VAR\n  {IF defined(X)}\n  a := TRUE;\n  {ELSE}\n  a := FALSE;\n  {END_IF}\nEND_PROGRAM\n",
        &expect![[r#"
            # Main: what is compiled is chosen here; it is not run here. #
            FUNCTION_BLOCK [$Main]
            # ladder: unread #
            # {IF defined(X)} #
            #   a := TRUE; #
            #   {ELSE} #
            #   a := FALSE; #
            #   {END_IF} #
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
            END_VAR

            +---------------------------------------------------------------------[$Main]--+
            1:1: Main: what is compiled is chosen here
        "#]],
    );
}

#[test]
fn what_tools_write_around_programs_is_passed_over() {
    check_file(
        "(*@PROPERTIES_EX@\nTYPE: POU\n*)\n(*@KEY@:DESCRIPTION*)\nadds two;\n(*@KEY@:END_DESCRIPTION*)\nFUNCTION Plus2 : INT\nVAR_INPUT v : INT; END_VAR\n\
         (*@KEY@: WORKSHEET\nNAME: Plus2\n*)\nPlus2 := v + 2;\n(*@KEY@: END_WORKSHEET *)\nEND_FUNCTION\n\
         PROGRAM Main VAR a : BOOL; END_VAR a := TRUE; END_PROGRAM\n(*DBG:#define cast(p) ((T *) p);*)\n(*DBG:int x = 3*(*y);*)\n",
        &expect![[r#"
            # adds two; #
            FUNCTION_BLOCK [$Plus2]
            VAR_INPUT
                v : INT;
            END_VAR
            VAR_OUTPUT
                Plus2 : INT;  # what the function returns #
            END_VAR

            # @KEY@: WORKSHEET #
            # NAME: Plus2 #
            +------------------------------------------------------[CALC]( Plus2, v + 2 )--+
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
            END_VAR

            +------------------------------------------------------------[MOV]( a, TRUE )--+
        "#]],
    );
}

#[test]
fn namespaces_are_read_as_what_is_in_them() {
    check_file(
        "USING Lib.Parts, Lib.More;\nNAMESPACE Plant.Line\nTYPE Mode : (Idle, Busy); END_TYPE\nFUNCTION_BLOCK Box VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT b : BOOL; END_VAR\n  b := a;\nEND_FUNCTION_BLOCK\nEND_NAMESPACE\n\
         NAMESPACE Plant PROGRAM Main VAR x : Box; m : Mode; END_VAR x(a := m = Mode#Busy); END_PROGRAM END_NAMESPACE\n",
        &expect![[r#"
            TYPE
                Mode : (Idle, Busy);
            END_TYPE

            FUNCTION_BLOCK [$Box]
            VAR_INPUT
                a : BOOL;
            END_VAR
            VAR_OUTPUT
                b : BOOL;
            END_VAR

            +--[ ]( a )----------------------------------------------------------( )( b )--+
            END_FUNCTION_BLOCK

            VAR
                x : $Box;
                m : Mode;
            END_VAR
            VAR
                st1 : BOOL;
            END_VAR

            +-------------------------[CALC]( st1, m = Mode.Busy )--[$Box]( x, a := st1 )--+
        "#]],
    );
}

#[test]
fn an_input_that_a_call_leaves_out_has_the_value_of_its_type() {
    check_file(
        "FUNCTION Mix : INT VAR_INPUT a : INT; b : INT; c : INT := 7; on : BOOL; END_VAR IF on THEN Mix := a; ELSE Mix := a + b + c; END_IF; END_FUNCTION\n\
         PROGRAM Main VAR x : INT; END_VAR x := Mix(b := 1); x := Mix(on := TRUE, a := x, b := 2, c := 3); END_PROGRAM\n",
        &expect![[r#"
            FUNCTION_BLOCK [$Mix]
            VAR_INPUT
                a  : INT;
                b  : INT;
                c  : INT := 7;
                on : BOOL;
            END_VAR
            VAR_OUTPUT
                Mix : INT;  # what the function returns #
            END_VAR

            +-------------------------------------------------------------[MOV]( Mix, 0 )--+

            # IF on THEN #
            +--[ ]( on )---------------------------------[MOV]( Mix, a )--<JMP>( endif1 )--+

            # ELSE #
            +----------------------------------------------------[CALC]( Mix, a + b + c )--+
            +--<LBL>( endif1 )-------------------------------------------------------------+
            END_FUNCTION_BLOCK

            VAR
                x : INT;
            END_VAR

            +-----------------------------[$Mix]( b := 1, a := 0, on := FALSE, Mix => x )--+
            +----------------------[$Mix]( on := TRUE, a := x, b := 2, c := 3, Mix => x )--+
        "#]],
    );
}

#[test]
fn of_bits_both_sides_are_computed() {
    check_file(
        "PROGRAM Main VAR d : DWORD; w : WORD; n : INT; a, b : BOOL; END_VAR\n  d := SHL(d, n) OR SHR(d, 32 - n);\n  w := w AND ROL(w, n);\n  a := b OR n / n > 1;\nEND_PROGRAM\n",
        &expect![[r#"
            VAR
                d : DWORD;
                w : WORD;
                n : INT;
                a : BOOL;
                b : BOOL;
            END_VAR
            VAR
                st1 : DWORD;
                st2 : DINT;
                st3 : DWORD;
                st4 : WORD;
                st5 : BOOL;
            END_VAR

            # d := SHL(d, n) OR SHR(d, 32 - n) #
            +--------[SHL]( st1, d, n )--[CALC]( st2, 32 - n )--[SHR]( st3, d, st2 )--[CALC]( d, st1 OR st3 )--+

            # w := w AND ROL(w, n) #
            +----------------------------------[ROL]( st4, w, n )--[CALC]( w, w AND st4 )--+
            +--[CALC]( st5, b )--[ ]( st5 )------------------------------<JMP>( enough1 )--+
            +--------------------------------[CALC]( st2, n / n )--[CALC]( st5, st2 > 1 )--+
            +--<LBL>( enough1 )-------------------------------------------[MOV]( a, st5 )--+
        "#]],
    );
}
