//! What other tools write around Structured Text, and what their compilers take.

use super::check_file;
use expect_test::expect;

#[test]
fn text_in_c_is_unread_alone() {
    check_file(
        "FUNCTION_BLOCK Log VAR_INPUT on : BOOL; END_VAR VAR n : INT; END_VAR\n  n := 1;\n  {{ puts(\"}\"); }}\n  {n++;}\nEND_FUNCTION_BLOCK\n\
         PROGRAM Main VAR a, b : BOOL; END_VAR\n  a := b;\n  IF a THEN {stop();} END_IF;\n  b := TRUE;\nEND_PROGRAM\n",
        &expect![[""]],
    );
}

#[test]
fn a_choice_of_what_is_compiled_makes_the_body_unread() {
    check_file(
        "PROGRAM Main VAR a : BOOL; END_VAR\n  {IF defined(X)}\n  a := TRUE;\n  {ELSE}\n  a := FALSE;\n  {END_IF}\nEND_PROGRAM\n",
        &expect![[""]],
    );
}

#[test]
fn what_tools_write_around_programs_is_passed_over() {
    check_file(
        "(*@PROPERTIES_EX@\nTYPE: POU\n*)\n(*@KEY@:DESCRIPTION*)\nadds two;\n(*@KEY@:END_DESCRIPTION*)\nFUNCTION Plus2 : INT\nVAR_INPUT v : INT; END_VAR\n\
         (*@KEY@: WORKSHEET\nNAME: Plus2\n*)\nPlus2 := v + 2;\n(*@KEY@: END_WORKSHEET *)\nEND_FUNCTION\n\
         PROGRAM Main VAR a : BOOL; END_VAR a := TRUE; END_PROGRAM\n(*DBG:#define cast(p) ((T *) p);*)\n(*DBG:int x = 3*(*y);*)\n",
        &expect![[""]],
    );
}

#[test]
fn namespaces_are_read_as_what_is_in_them() {
    check_file(
        "USING Lib.Parts, Lib.More;\nNAMESPACE Plant.Line\nTYPE Mode : (Idle, Busy); END_TYPE\nFUNCTION_BLOCK Box VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT b : BOOL; END_VAR\n  b := a;\nEND_FUNCTION_BLOCK\nEND_NAMESPACE\n\
         NAMESPACE Plant PROGRAM Main VAR x : Box; m : Mode; END_VAR x(a := m = Mode#Busy); END_PROGRAM END_NAMESPACE\n",
        &expect![[""]],
    );
}

#[test]
fn an_input_that_a_call_leaves_out_has_the_value_of_its_type() {
    check_file(
        "FUNCTION Mix : INT VAR_INPUT a : INT; b : INT; c : INT := 7; on : BOOL; END_VAR IF on THEN Mix := a; ELSE Mix := a + b + c; END_IF; END_FUNCTION\n\
         PROGRAM Main VAR x : INT; END_VAR x := Mix(b := 1); x := Mix(on := TRUE, a := x, b := 2, c := 3); END_PROGRAM\n",
        &expect![[""]],
    );
}

#[test]
fn of_bits_both_sides_are_computed() {
    check_file(
        "PROGRAM Main VAR d : DWORD; w : WORD; n : INT; a, b : BOOL; END_VAR\n  d := SHL(d, n) OR SHR(d, 32 - n);\n  w := w AND ROL(w, n);\n  a := b OR n / n > 1;\nEND_PROGRAM\n",
        &expect![[""]],
    );
}
