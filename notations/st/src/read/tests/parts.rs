//! Parts of words.

use super::check;
use crate::read::dialect::Dialect;
use expect_test::expect;

#[test]
fn parts_are_read_and_written() {
    check(
        "w.%B0 := w.%B1; i.%B1 := 16#80; a := w.%X3 AND w.%B1 = 16#12; u := DWORD_TO_DINT(v.%W1);",
        Dialect::Iec,
        &expect![[r#"
            VAR
                st1 : WORD;
                st2 : BYTE;
                st3 : WORD;
                st4 : WORD;
                st5 : WORD;
                st6 : DWORD;
                st7 : DWORD;
            END_VAR

            +---[SHR]( st1, w, 8 )--[WRAP]( st2, st1 )--[WRAP]( st3, st2 )--[CALC]( w, w AND 16#FF00 OR st3 )--+
            +---------------------[WRAP]( st3, 16#80 )--[SHL]( st1, st3, 8 )--[WRAP]( st4, i )--[CALC]( st5, st4 AND 16#FF OR st1 )--[WRAP]( i, st5 )--+

            # a := w.%X3 AND w.%B1 = 16|12 #
            +----[SHR]( st5, w, 8 )--[WRAP]( st2, st5 )--[CALC]( a, w.3 AND st2 = 16#12 )--+

            # u := DWORD_TO_DINT(v.%W1) #
            +-------------------[WRAP]( st6, v )--[SHR]( st7, st6, 16 )--[WRAP]( st5, st7 )--[WRAP]( u, st5 )--+
        "#]],
    );
    check(
        "#w.%B1 := #w.%B0;",
        Dialect::Scl,
        &expect![[r#"
        VAR
            st1 : BYTE;
            st2 : WORD;
            st3 : WORD;
        END_VAR

        +-----[WRAP]( st1, w )--[WRAP]( st2, st1 )--[SHL]( st3, st2, 8 )--[CALC]( w, w AND 16#FF OR st3 )--+
    "#]],
    );
}

#[test]
fn parts_that_are_not_there() {
    check(
        "w.%B2 := 1; i := r.%B0; w.%W0.%B1 := 1; w.%L0 := w;",
        Dialect::Iec,
        &expect![[r#"
        # line 1 of Main: `w` does not have so many parts; it is not run here. #
        FUNCTION_BLOCK [$line_1_of_Main]
        # ladder: unread, writes w #
        # w.%B2 := 1 #
        END_FUNCTION_BLOCK

        # line 1 of Main: `r` has no parts of bits; it is not run here. #
        FUNCTION_BLOCK [$line_1_of_Main2]
        # ladder: unread, writes i #
        # i := r.%B0 #
        END_FUNCTION_BLOCK

        # line 1 of Main: a part of a word of this kind works on memory by address, which ladder text does not have; it is not run here. #
        FUNCTION_BLOCK [$line_1_of_Main3]
        # ladder: unread #
        # w.%W0.%B1 := 1 #
        END_FUNCTION_BLOCK

        # line 1 of Main: a part of a word of this kind works on memory by address, which ladder text does not have; it is not run here. #
        FUNCTION_BLOCK [$line_1_of_Main4]
        # ladder: unread #
        # w.%L0 := w #
        END_FUNCTION_BLOCK

        +-----------------------------------------------------------[$line_1_of_Main]--+
        +----------------------------------------------------------[$line_1_of_Main2]--+
        +----------------------------------------------------------[$line_1_of_Main3]--+
        +----------------------------------------------------------[$line_1_of_Main4]--+
    "#]],
    );
}
