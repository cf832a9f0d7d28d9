//! Sections of types, structures, enumerations, and the values and paths that go with them.

use crate::show::{check_errors, check_tree};
use expect_test::expect;

#[test]
fn a_structure() {
    check_tree(
        "TYPE\n  Motor : STRUCT\n    speed : REAL := 50.0; # rpm #\n  END_STRUCT;\nEND_TYPE\n",
        expect![[r##"
            SOURCE_FILE@0..79
              SECTION_HEADER@0..5
                KEYWORD@0..4 "TYPE"
                NEWLINE@4..5 "\n"
              STRUCT_HEADER@5..22
                WHITESPACE@5..7 "  "
                NAME_LIST@7..12
                  IDENT@7..12 "Motor"
                WHITESPACE@12..13 " "
                COLON@13..14 ":"
                WHITESPACE@14..15 " "
                KEYWORD@15..21 "STRUCT"
                NEWLINE@21..22 "\n"
              DECLARATION@22..56
                WHITESPACE@22..26 "    "
                NAME_LIST@26..31
                  IDENT@26..31 "speed"
                WHITESPACE@31..32 " "
                COLON@32..33 ":"
                WHITESPACE@33..34 " "
                TYPE_REF@34..38
                  KEYWORD@34..38 "REAL"
                WHITESPACE@38..39 " "
                INITIAL_VALUE@39..46
                  ASSIGN@39..41 ":="
                  WHITESPACE@41..42 " "
                  LITERAL_EXPR@42..46
                    LITERAL@42..46 "50.0"
                SEMICOLON@46..47 ";"
                WHITESPACE@47..48 " "
                COMMENT@48..55 "# rpm #"
                NEWLINE@55..56 "\n"
              STRUCT_END@56..70
                WHITESPACE@56..58 "  "
                KEYWORD@58..68 "END_STRUCT"
                SEMICOLON@68..69 ";"
                NEWLINE@69..70 "\n"
              SECTION_END@70..79
                KEYWORD@70..78 "END_TYPE"
                NEWLINE@78..79 "\n"
        "##]],
    );
}

#[test]
fn an_enumeration_and_a_subrange() {
    check_tree(
        "TYPE P : (IDLE, MIXING := -10) := IDLE; L : INT(0..100); END_TYPE",
        expect![[r#"
        SOURCE_FILE@0..65
          SECTION_HEADER@0..5
            KEYWORD@0..4 "TYPE"
            WHITESPACE@4..5 " "
          DECLARATION@5..40
            NAME_LIST@5..6
              IDENT@5..6 "P"
            WHITESPACE@6..7 " "
            COLON@7..8 ":"
            WHITESPACE@8..9 " "
            TYPE_REF@9..30
              L_PAREN@9..10 "("
              ENUM_VALUE@10..14
                IDENT@10..14 "IDLE"
              COMMA@14..15 ","
              WHITESPACE@15..16 " "
              ENUM_VALUE@16..29
                IDENT@16..22 "MIXING"
                WHITESPACE@22..23 " "
                ASSIGN@23..25 ":="
                WHITESPACE@25..26 " "
                MINUS@26..27 "-"
                LITERAL@27..29 "10"
              R_PAREN@29..30 ")"
            WHITESPACE@30..31 " "
            INITIAL_VALUE@31..38
              ASSIGN@31..33 ":="
              WHITESPACE@33..34 " "
              NAME_EXPR@34..38
                IDENT@34..38 "IDLE"
            SEMICOLON@38..39 ";"
            WHITESPACE@39..40 " "
          DECLARATION@40..57
            NAME_LIST@40..41
              IDENT@40..41 "L"
            WHITESPACE@41..42 " "
            COLON@42..43 ":"
            WHITESPACE@43..44 " "
            TYPE_REF@44..55
              KEYWORD@44..47 "INT"
              L_PAREN@47..48 "("
              LITERAL@48..49 "0"
              DOT_DOT@49..51 ".."
              LITERAL@51..54 "100"
              R_PAREN@54..55 ")"
            SEMICOLON@55..56 ";"
            WHITESPACE@56..57 " "
          SECTION_END@57..65
            KEYWORD@57..65 "END_TYPE"
    "#]],
    );
}

#[test]
fn arrays_of_anything() {
    check_tree(
        "VAR a : ARRAY[1..3, -1..n] OF ARRAY[1..2] OF $Motor; END_VAR",
        expect![[r#"
        SOURCE_FILE@0..60
          SECTION_HEADER@0..4
            KEYWORD@0..3 "VAR"
            WHITESPACE@3..4 " "
          DECLARATION@4..53
            NAME_LIST@4..5
              IDENT@4..5 "a"
            WHITESPACE@5..6 " "
            COLON@6..7 ":"
            WHITESPACE@7..8 " "
            TYPE_REF@8..51
              KEYWORD@8..13 "ARRAY"
              L_BRACKET@13..14 "["
              LITERAL@14..15 "1"
              DOT_DOT@15..17 ".."
              LITERAL@17..18 "3"
              COMMA@18..19 ","
              WHITESPACE@19..20 " "
              MINUS@20..21 "-"
              LITERAL@21..22 "1"
              DOT_DOT@22..24 ".."
              IDENT@24..25 "n"
              R_BRACKET@25..26 "]"
              WHITESPACE@26..27 " "
              KEYWORD@27..29 "OF"
              WHITESPACE@29..30 " "
              TYPE_REF@30..51
                KEYWORD@30..35 "ARRAY"
                L_BRACKET@35..36 "["
                LITERAL@36..37 "1"
                DOT_DOT@37..39 ".."
                LITERAL@39..40 "2"
                R_BRACKET@40..41 "]"
                WHITESPACE@41..42 " "
                KEYWORD@42..44 "OF"
                WHITESPACE@44..45 " "
                BLOCK_NAME@45..51 "$Motor"
            SEMICOLON@51..52 ";"
            WHITESPACE@52..53 " "
          SECTION_END@53..60
            KEYWORD@53..60 "END_VAR"
    "#]],
    );
}

#[test]
fn values() {
    check_tree(
        "VAR a : M := (x := [1, 2((y := 3)), [4]], z := (w := 5)); END_VAR",
        expect![[r#"
        SOURCE_FILE@0..65
          SECTION_HEADER@0..4
            KEYWORD@0..3 "VAR"
            WHITESPACE@3..4 " "
          DECLARATION@4..58
            NAME_LIST@4..5
              IDENT@4..5 "a"
            WHITESPACE@5..6 " "
            COLON@6..7 ":"
            WHITESPACE@7..8 " "
            TYPE_REF@8..9
              IDENT@8..9 "M"
            WHITESPACE@9..10 " "
            INITIAL_VALUE@10..56
              ASSIGN@10..12 ":="
              WHITESPACE@12..13 " "
              STRUCT_EXPR@13..56
                L_PAREN@13..14 "("
                NAMED_OPERAND@14..40
                  NAME_EXPR@14..15
                    IDENT@14..15 "x"
                  WHITESPACE@15..16 " "
                  ASSIGN@16..18 ":="
                  WHITESPACE@18..19 " "
                  ARRAY_EXPR@19..40
                    L_BRACKET@19..20 "["
                    LITERAL_EXPR@20..21
                      LITERAL@20..21 "1"
                    COMMA@21..22 ","
                    WHITESPACE@22..23 " "
                    CALL_EXPR@23..34
                      LITERAL_EXPR@23..24
                        LITERAL@23..24 "2"
                      L_PAREN@24..25 "("
                      STRUCT_EXPR@25..33
                        L_PAREN@25..26 "("
                        NAMED_OPERAND@26..32
                          NAME_EXPR@26..27
                            IDENT@26..27 "y"
                          WHITESPACE@27..28 " "
                          ASSIGN@28..30 ":="
                          WHITESPACE@30..31 " "
                          LITERAL_EXPR@31..32
                            LITERAL@31..32 "3"
                        R_PAREN@32..33 ")"
                      R_PAREN@33..34 ")"
                    COMMA@34..35 ","
                    WHITESPACE@35..36 " "
                    ARRAY_EXPR@36..39
                      L_BRACKET@36..37 "["
                      LITERAL_EXPR@37..38
                        LITERAL@37..38 "4"
                      R_BRACKET@38..39 "]"
                    R_BRACKET@39..40 "]"
                COMMA@40..41 ","
                WHITESPACE@41..42 " "
                NAMED_OPERAND@42..55
                  NAME_EXPR@42..43
                    IDENT@42..43 "z"
                  WHITESPACE@43..44 " "
                  ASSIGN@44..46 ":="
                  WHITESPACE@46..47 " "
                  STRUCT_EXPR@47..55
                    L_PAREN@47..48 "("
                    NAMED_OPERAND@48..54
                      NAME_EXPR@48..49
                        IDENT@48..49 "w"
                      WHITESPACE@49..50 " "
                      ASSIGN@50..52 ":="
                      WHITESPACE@52..53 " "
                      LITERAL_EXPR@53..54
                        LITERAL@53..54 "5"
                    R_PAREN@54..55 ")"
                R_PAREN@55..56 ")"
            SEMICOLON@56..57 ";"
            WHITESPACE@57..58 " "
          SECTION_END@58..65
            KEYWORD@58..65 "END_VAR"
    "#]],
    );
}

#[test]
fn paths() {
    check_tree(
        "+--[MOV]( cell[2].zone[k + 1, 3].open, g[1, 2..3] )--+",
        expect![[r#"
        SOURCE_FILE@0..54
          RUNG@0..54
            RAIL_CONNECTOR@0..1 "+"
            WIRE@1..3 "--"
            LOGICAL_BLOCK@3..51
              BLOCK_HEAD@3..8
                L_BRACKET@3..4 "["
                MNEMONIC@4..7 "MOV"
                R_BRACKET@7..8 "]"
              OPERAND_LIST@8..51
                L_PAREN@8..9 "("
                WHITESPACE@9..10 " "
                MEMBER_EXPR@10..37
                  INDEX_EXPR@10..32
                    MEMBER_EXPR@10..22
                      INDEX_EXPR@10..17
                        NAME_EXPR@10..14
                          IDENT@10..14 "cell"
                        L_BRACKET@14..15 "["
                        LITERAL_EXPR@15..16
                          LITERAL@15..16 "2"
                        R_BRACKET@16..17 "]"
                      DOT@17..18 "."
                      IDENT@18..22 "zone"
                    L_BRACKET@22..23 "["
                    BINARY_EXPR@23..28
                      NAME_EXPR@23..24
                        IDENT@23..24 "k"
                      WHITESPACE@24..25 " "
                      PLUS@25..26 "+"
                      WHITESPACE@26..27 " "
                      LITERAL_EXPR@27..28
                        LITERAL@27..28 "1"
                    COMMA@28..29 ","
                    WHITESPACE@29..30 " "
                    LITERAL_EXPR@30..31
                      LITERAL@30..31 "3"
                    R_BRACKET@31..32 "]"
                  DOT@32..33 "."
                  IDENT@33..37 "open"
                COMMA@37..38 ","
                WHITESPACE@38..39 " "
                INDEX_EXPR@39..49
                  NAME_EXPR@39..40
                    IDENT@39..40 "g"
                  L_BRACKET@40..41 "["
                  LITERAL_EXPR@41..42
                    LITERAL@41..42 "1"
                  COMMA@42..43 ","
                  WHITESPACE@43..44 " "
                  RANGE_EXPR@44..48
                    LITERAL_EXPR@44..45
                      LITERAL@44..45 "2"
                    DOT_DOT@45..47 ".."
                    LITERAL_EXPR@47..48
                      LITERAL@47..48 "3"
                  R_BRACKET@48..49 "]"
                WHITESPACE@49..50 " "
                R_PAREN@50..51 ")"
            WIRE@51..53 "--"
            RAIL_CONNECTOR@53..54 "+"
    "#]],
    );
}

#[test]
fn what_is_wrong_is_said_once() {
    check_errors(
        &[
            "VAR\n a : STRUCT\n  b : INT;\n END_STRUCT;\n c : INT;\nEND_VAR\n",
            "TYPE\n A : STRUCT\n  b : STRUCT\n c : INT;\n END_STRUCT;\n END_STRUCT;\nEND_TYPE\n",
            "TYPE\n A : STRUCT\n  b : INT;\nEND_TYPE\n+--[ ]( a )--( )( b )--+\n",
            "TYPE\n A : STRUCT\n  b : INT;\n+--[ ]( a )--( )( b )--+\n",
            "TYPE\n A : INT;\nEND_VAR\n",
            "VAR\n A : INT;\nEND_TYPE\n",
            "TYPE\n A : INT;\n",
            "END_STRUCT;\n",
            "TYPE RETAIN\n A : (IDLE, );\n B : ();\n C : (1);\nEND_TYPE\n",
            "VAR a : (IDLE, RUN); END_VAR\n",
            "VAR a : M := (x := , y 5); b : M := (x := 1; END_VAR\n",
            "TYPE A : STRUCT END_STRUCT END_TYPE\n",
        ],
        expect![[r#"
            SECTION_HEADER VAR \n
            STRUCT_HEADER · ‹NAME_LIST:a› · : · STRUCT \n
                "STRUCT" 9..15 BadDeclaration(StructOutsideTypes)
            DECLARATION · ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            STRUCT_END · END_STRUCT ; \n
            DECLARATION · ‹NAME_LIST:c› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR \n

            SECTION_HEADER TYPE \n
            STRUCT_HEADER · ‹NAME_LIST:A› · : · STRUCT \n
            STRUCT_HEADER · ‹NAME_LIST:b› · : · STRUCT \n
                "STRUCT" 23..29 BadDeclaration(NestedStruct)
            DECLARATION · ‹NAME_LIST:c› · : · ‹TYPE_REF:INT› ; \n
            STRUCT_END · END_STRUCT ; \n
            STRUCT_END · END_STRUCT ; \n
            SECTION_END END_TYPE \n

            SECTION_HEADER TYPE \n
            STRUCT_HEADER · ‹NAME_LIST:A› · : · STRUCT \n
            DECLARATION · ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_TYPE \n
                "END_TYPE" 28..36 BadDeclaration(StructNotClosed)
            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- ‹‹( )›‹( ‹NAME_EXPR:b› )›› -- + \n

            SECTION_HEADER TYPE \n
            STRUCT_HEADER · ‹NAME_LIST:A› · : · STRUCT \n
            DECLARATION · ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- ‹‹( )›‹( ‹NAME_EXPR:b› )›› -- + \n
                "+" 28..29 BadDeclaration(StructNotClosed)

            SECTION_HEADER TYPE \n
            DECLARATION · ‹NAME_LIST:A› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR \n
                "END_VAR" 15..22 BadDeclaration(OtherEnd)

            SECTION_HEADER VAR \n
            DECLARATION · ‹NAME_LIST:A› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_TYPE \n
                "END_TYPE" 14..22 BadDeclaration(OtherEnd)

            SECTION_HEADER TYPE \n
                "TYPE" 0..4 BadDeclaration(TypesNotClosed)
            DECLARATION · ‹NAME_LIST:A› · : · ‹TYPE_REF:INT› ; \n

            STRUCT_END END_STRUCT ; \n
                "END_STRUCT" 0..10 BadDeclaration(EndWithoutSection)

            SECTION_HEADER TYPE · RETAIN \n
                "RETAIN" 5..11 BadDeclaration(Unexpected)
            DECLARATION · ‹NAME_LIST:A› · : · ‹TYPE_REF:(‹ENUM_VALUE:IDLE›,› · ‹ERROR_NODE:);› \n
                ")" 24..25 BadDeclaration(EnumerationValueExpected)
            DECLARATION · ‹NAME_LIST:B› · : · ‹TYPE_REF:(› ‹ERROR_NODE:);› \n
                ")" 33..34 BadDeclaration(EnumerationValueExpected)
            DECLARATION · ‹NAME_LIST:C› · : · ‹TYPE_REF:(› ‹ERROR_NODE:1);› \n
                "1" 42..43 BadDeclaration(EnumerationValueExpected)
            SECTION_END END_TYPE \n

            SECTION_HEADER VAR ·
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:(‹ENUM_VALUE:IDLE›, ‹ENUM_VALUE:RUN›)› ; ·
                "(" 8..9 BadDeclaration(EnumerationOutsideTypes)
            SECTION_END END_VAR \n

            SECTION_HEADER VAR ·
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:M› · ‹INITIAL_VALUE::= ‹STRUCT_EXPR:(‹NAMED_OPERAND:‹NAME_EXPR:x› :=› , ‹NAMED_OPERAND:‹NAME_EXPR:y›››› · ‹ERROR_NODE:5);› ·
                "(x := , y" 13..22 UnclosedBlock {closing: R_PAREN}
                "," 19..20 MissingOperand {place: Named}
                "" 22..22 BadDeclaration(SemicolonMissing)
                "5" 23..24 BadDeclaration(MemberExpected)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:M› · ‹INITIAL_VALUE::= ‹STRUCT_EXPR:(‹NAMED_OPERAND:‹NAME_EXPR:x› := ‹LITERAL_EXPR:1›››› ; ·
                "(x := 1" 36..43 UnclosedBlock {closing: R_PAREN}
            SECTION_END END_VAR \n

            SECTION_HEADER TYPE ·
            STRUCT_HEADER ‹NAME_LIST:A› · : · STRUCT ·
            STRUCT_END END_STRUCT ·
                "" 26..26 BadDeclaration(SemicolonMissing)
            SECTION_END END_TYPE \n

        "#]],
    );
}
