//! The tree of each construct.

use crate::show::check_tree;
use expect_test::expect;

#[test]
fn a_rung() {
    check_tree(
        "+--[ ]( a )--(S)( y )--+\n",
        expect![[r#"
        SOURCE_FILE@0..25
          RUNG@0..25
            RAIL_CONNECTOR@0..1 "+"
            WIRE@1..3 "--"
            LOGICAL_BLOCK@3..11
              BLOCK_HEAD@3..6
                L_BRACKET@3..4 "["
                WHITESPACE@4..5 " "
                R_BRACKET@5..6 "]"
              OPERAND_LIST@6..11
                L_PAREN@6..7 "("
                WHITESPACE@7..8 " "
                NAME_EXPR@8..9
                  IDENT@8..9 "a"
                WHITESPACE@9..10 " "
                R_PAREN@10..11 ")"
            WIRE@11..13 "--"
            COIL_BLOCK@13..21
              BLOCK_HEAD@13..16
                L_PAREN@13..14 "("
                MNEMONIC@14..15 "S"
                R_PAREN@15..16 ")"
              OPERAND_LIST@16..21
                L_PAREN@16..17 "("
                WHITESPACE@17..18 " "
                NAME_EXPR@18..19
                  IDENT@18..19 "y"
                WHITESPACE@19..20 " "
                R_PAREN@20..21 ")"
            WIRE@21..23 "--"
            RAIL_CONNECTOR@23..24 "+"
            NEWLINE@24..25 "\n"
    "#]],
    );
}

#[test]
fn branches_rails_and_comments() {
    check_tree(
        "# seal-in #\n+--\\--/ |\n|  |\n\n \r\n",
        expect![[r##"
        SOURCE_FILE@0..31
          COMMENT_LINE@0..12
            COMMENT@0..11 "# seal-in #"
            NEWLINE@11..12 "\n"
          RUNG@12..22
            RAIL_CONNECTOR@12..13 "+"
            WIRE@13..15 "--"
            DOWN@15..16 "\\"
            WIRE@16..18 "--"
            UP@18..19 "/"
            WHITESPACE@19..20 " "
            RAIL@20..21 "|"
            NEWLINE@21..22 "\n"
          RAIL_LINE@22..27
            RAIL@22..23 "|"
            WHITESPACE@23..25 "  "
            RAIL@25..26 "|"
            NEWLINE@26..27 "\n"
          BLANK_LINE@27..28
            NEWLINE@27..28 "\n"
          BLANK_LINE@28..31
            WHITESPACE@28..29 " "
            NEWLINE@29..31 "\r\n"
    "##]],
    );
}

/// White space is free inside the brackets and between the two parts; a parenthesis after a first part is
/// always its operand list.
#[test]
fn free_white_space_in_blocks() {
    check_tree(
        "[ TON ] ( t , 5s )[]()<RET>",
        expect![[r#"
        SOURCE_FILE@0..27
          RUNG@0..27
            LOGICAL_BLOCK@0..18
              BLOCK_HEAD@0..7
                L_BRACKET@0..1 "["
                WHITESPACE@1..2 " "
                MNEMONIC@2..5 "TON"
                WHITESPACE@5..6 " "
                R_BRACKET@6..7 "]"
              WHITESPACE@7..8 " "
              OPERAND_LIST@8..18
                L_PAREN@8..9 "("
                WHITESPACE@9..10 " "
                NAME_EXPR@10..11
                  IDENT@10..11 "t"
                WHITESPACE@11..12 " "
                COMMA@12..13 ","
                WHITESPACE@13..14 " "
                LITERAL_EXPR@14..16
                  LITERAL@14..16 "5s"
                WHITESPACE@16..17 " "
                R_PAREN@17..18 ")"
            LOGICAL_BLOCK@18..22
              BLOCK_HEAD@18..20
                L_BRACKET@18..19 "["
                R_BRACKET@19..20 "]"
              OPERAND_LIST@20..22
                L_PAREN@20..21 "("
                R_PAREN@21..22 ")"
            FUNCTION_BLOCK@22..27
              BLOCK_HEAD@22..27
                L_ANGLE@22..23 "<"
                MNEMONIC@23..26 "RET"
                R_ANGLE@26..27 ">"
    "#]],
    );
    check_tree(
        "[OSR]( )( y )",
        expect![[r#"
        SOURCE_FILE@0..13
          RUNG@0..13
            LOGICAL_BLOCK@0..8
              BLOCK_HEAD@0..5
                L_BRACKET@0..1 "["
                MNEMONIC@1..4 "OSR"
                R_BRACKET@4..5 "]"
              OPERAND_LIST@5..8
                L_PAREN@5..6 "("
                WHITESPACE@6..7 " "
                R_PAREN@7..8 ")"
            COIL_BLOCK@8..13
              BLOCK_HEAD@8..13
                L_PAREN@8..9 "("
                WHITESPACE@9..10 " "
                MNEMONIC@10..11 "y"
                WHITESPACE@11..12 " "
                R_PAREN@12..13 ")"
    "#]],
    );
    check_tree(
        "[OSR]  --( y )",
        expect![[r#"
        SOURCE_FILE@0..14
          RUNG@0..14
            LOGICAL_BLOCK@0..5
              BLOCK_HEAD@0..5
                L_BRACKET@0..1 "["
                MNEMONIC@1..4 "OSR"
                R_BRACKET@4..5 "]"
            WHITESPACE@5..7 "  "
            WIRE@7..9 "--"
            COIL_BLOCK@9..14
              BLOCK_HEAD@9..14
                L_PAREN@9..10 "("
                WHITESPACE@10..11 " "
                MNEMONIC@11..12 "y"
                WHITESPACE@12..13 " "
                R_PAREN@13..14 ")"
    "#]],
    );
}

#[test]
fn named_operands() {
    check_tree(
        "[TON]( t, 5s, R := stop, Q=>run )",
        expect![[r#"
        SOURCE_FILE@0..33
          RUNG@0..33
            LOGICAL_BLOCK@0..33
              BLOCK_HEAD@0..5
                L_BRACKET@0..1 "["
                MNEMONIC@1..4 "TON"
                R_BRACKET@4..5 "]"
              OPERAND_LIST@5..33
                L_PAREN@5..6 "("
                WHITESPACE@6..7 " "
                NAME_EXPR@7..8
                  IDENT@7..8 "t"
                COMMA@8..9 ","
                WHITESPACE@9..10 " "
                LITERAL_EXPR@10..12
                  LITERAL@10..12 "5s"
                COMMA@12..13 ","
                WHITESPACE@13..14 " "
                NAMED_OPERAND@14..23
                  NAME_EXPR@14..15
                    IDENT@14..15 "R"
                  WHITESPACE@15..16 " "
                  ASSIGN@16..18 ":="
                  WHITESPACE@18..19 " "
                  NAME_EXPR@19..23
                    IDENT@19..23 "stop"
                COMMA@23..24 ","
                WHITESPACE@24..25 " "
                NAMED_OPERAND@25..31
                  NAME_EXPR@25..26
                    IDENT@25..26 "Q"
                  ARROW@26..28 "=>"
                  NAME_EXPR@28..31
                    IDENT@28..31 "run"
                WHITESPACE@31..32 " "
                R_PAREN@32..33 ")"
    "#]],
    );
}

#[test]
fn members_indices_and_ranges() {
    check_tree(
        "[BMOV]( a[3..9], b[i + 1].x, w.3 )",
        expect![[r#"
        SOURCE_FILE@0..34
          RUNG@0..34
            LOGICAL_BLOCK@0..34
              BLOCK_HEAD@0..6
                L_BRACKET@0..1 "["
                MNEMONIC@1..5 "BMOV"
                R_BRACKET@5..6 "]"
              OPERAND_LIST@6..34
                L_PAREN@6..7 "("
                WHITESPACE@7..8 " "
                INDEX_EXPR@8..15
                  NAME_EXPR@8..9
                    IDENT@8..9 "a"
                  L_BRACKET@9..10 "["
                  RANGE_EXPR@10..14
                    LITERAL_EXPR@10..11
                      LITERAL@10..11 "3"
                    DOT_DOT@11..13 ".."
                    LITERAL_EXPR@13..14
                      LITERAL@13..14 "9"
                  R_BRACKET@14..15 "]"
                COMMA@15..16 ","
                WHITESPACE@16..17 " "
                MEMBER_EXPR@17..27
                  INDEX_EXPR@17..25
                    NAME_EXPR@17..18
                      IDENT@17..18 "b"
                    L_BRACKET@18..19 "["
                    BINARY_EXPR@19..24
                      NAME_EXPR@19..20
                        IDENT@19..20 "i"
                      WHITESPACE@20..21 " "
                      PLUS@21..22 "+"
                      WHITESPACE@22..23 " "
                      LITERAL_EXPR@23..24
                        LITERAL@23..24 "1"
                    R_BRACKET@24..25 "]"
                  DOT@25..26 "."
                  IDENT@26..27 "x"
                COMMA@27..28 ","
                WHITESPACE@28..29 " "
                MEMBER_EXPR@29..32
                  NAME_EXPR@29..30
                    IDENT@29..30 "w"
                  DOT@30..31 "."
                  LITERAL@31..32 "3"
                WHITESPACE@32..33 " "
                R_PAREN@33..34 ")"
    "#]],
    );
}

/// Loosest first: OR, XOR, AND, equality, order, shifts, sums, products, powers (to the right), signs.
#[test]
fn precedence() {
    check_tree(
        "[CALC]( y, a OR b XOR c AND d = e < f SHL g + h * i ^ j ^ -k )",
        expect![[r#"
            SOURCE_FILE@0..62
              RUNG@0..62
                LOGICAL_BLOCK@0..62
                  BLOCK_HEAD@0..6
                    L_BRACKET@0..1 "["
                    MNEMONIC@1..5 "CALC"
                    R_BRACKET@5..6 "]"
                  OPERAND_LIST@6..62
                    L_PAREN@6..7 "("
                    WHITESPACE@7..8 " "
                    NAME_EXPR@8..9
                      IDENT@8..9 "y"
                    COMMA@9..10 ","
                    WHITESPACE@10..11 " "
                    BINARY_EXPR@11..60
                      NAME_EXPR@11..12
                        IDENT@11..12 "a"
                      WHITESPACE@12..13 " "
                      WORD_OPERATOR@13..15 "OR"
                      WHITESPACE@15..16 " "
                      BINARY_EXPR@16..60
                        NAME_EXPR@16..17
                          IDENT@16..17 "b"
                        WHITESPACE@17..18 " "
                        WORD_OPERATOR@18..21 "XOR"
                        WHITESPACE@21..22 " "
                        BINARY_EXPR@22..60
                          NAME_EXPR@22..23
                            IDENT@22..23 "c"
                          WHITESPACE@23..24 " "
                          WORD_OPERATOR@24..27 "AND"
                          WHITESPACE@27..28 " "
                          BINARY_EXPR@28..60
                            NAME_EXPR@28..29
                              IDENT@28..29 "d"
                            WHITESPACE@29..30 " "
                            EQUAL@30..31 "="
                            WHITESPACE@31..32 " "
                            BINARY_EXPR@32..60
                              NAME_EXPR@32..33
                                IDENT@32..33 "e"
                              WHITESPACE@33..34 " "
                              LESS@34..35 "<"
                              WHITESPACE@35..36 " "
                              BINARY_EXPR@36..60
                                NAME_EXPR@36..37
                                  IDENT@36..37 "f"
                                WHITESPACE@37..38 " "
                                WORD_OPERATOR@38..41 "SHL"
                                WHITESPACE@41..42 " "
                                BINARY_EXPR@42..60
                                  NAME_EXPR@42..43
                                    IDENT@42..43 "g"
                                  WHITESPACE@43..44 " "
                                  PLUS@44..45 "+"
                                  WHITESPACE@45..46 " "
                                  BINARY_EXPR@46..60
                                    NAME_EXPR@46..47
                                      IDENT@46..47 "h"
                                    WHITESPACE@47..48 " "
                                    STAR@48..49 "*"
                                    WHITESPACE@49..50 " "
                                    BINARY_EXPR@50..60
                                      NAME_EXPR@50..51
                                        IDENT@50..51 "i"
                                      WHITESPACE@51..52 " "
                                      CARET@52..53 "^"
                                      WHITESPACE@53..54 " "
                                      BINARY_EXPR@54..60
                                        NAME_EXPR@54..55
                                          IDENT@54..55 "j"
                                        WHITESPACE@55..56 " "
                                        CARET@56..57 "^"
                                        WHITESPACE@57..58 " "
                                        UNARY_EXPR@58..60
                                          MINUS@58..59 "-"
                                          NAME_EXPR@59..60
                                            IDENT@59..60 "k"
                    WHITESPACE@60..61 " "
                    R_PAREN@61..62 ")"
        "#]],
    );
    check_tree(
        "[CALC]( y, -2 ^ 2 - a - b )",
        expect![[r#"
        SOURCE_FILE@0..27
          RUNG@0..27
            LOGICAL_BLOCK@0..27
              BLOCK_HEAD@0..6
                L_BRACKET@0..1 "["
                MNEMONIC@1..5 "CALC"
                R_BRACKET@5..6 "]"
              OPERAND_LIST@6..27
                L_PAREN@6..7 "("
                WHITESPACE@7..8 " "
                NAME_EXPR@8..9
                  IDENT@8..9 "y"
                COMMA@9..10 ","
                WHITESPACE@10..11 " "
                BINARY_EXPR@11..25
                  BINARY_EXPR@11..21
                    BINARY_EXPR@11..17
                      UNARY_EXPR@11..13
                        MINUS@11..12 "-"
                        LITERAL_EXPR@12..13
                          LITERAL@12..13 "2"
                      WHITESPACE@13..14 " "
                      CARET@14..15 "^"
                      WHITESPACE@15..16 " "
                      LITERAL_EXPR@16..17
                        LITERAL@16..17 "2"
                    WHITESPACE@17..18 " "
                    MINUS@18..19 "-"
                    WHITESPACE@19..20 " "
                    NAME_EXPR@20..21
                      IDENT@20..21 "a"
                  WHITESPACE@21..22 " "
                  MINUS@22..23 "-"
                  WHITESPACE@23..24 " "
                  NAME_EXPR@24..25
                    IDENT@24..25 "b"
                WHITESPACE@25..26 " "
                R_PAREN@26..27 ")"
    "#]],
    );
    check_tree(
        "[CALC]( y, NOT (a OR b) AND SQRT( x , SUM(a[1..9]) ) # c # * PI )",
        expect![[r##"
            SOURCE_FILE@0..65
              RUNG@0..65
                LOGICAL_BLOCK@0..65
                  BLOCK_HEAD@0..6
                    L_BRACKET@0..1 "["
                    MNEMONIC@1..5 "CALC"
                    R_BRACKET@5..6 "]"
                  OPERAND_LIST@6..65
                    L_PAREN@6..7 "("
                    WHITESPACE@7..8 " "
                    NAME_EXPR@8..9
                      IDENT@8..9 "y"
                    COMMA@9..10 ","
                    WHITESPACE@10..11 " "
                    BINARY_EXPR@11..63
                      UNARY_EXPR@11..23
                        WORD_OPERATOR@11..14 "NOT"
                        WHITESPACE@14..15 " "
                        PAREN_EXPR@15..23
                          L_PAREN@15..16 "("
                          BINARY_EXPR@16..22
                            NAME_EXPR@16..17
                              IDENT@16..17 "a"
                            WHITESPACE@17..18 " "
                            WORD_OPERATOR@18..20 "OR"
                            WHITESPACE@20..21 " "
                            NAME_EXPR@21..22
                              IDENT@21..22 "b"
                          R_PAREN@22..23 ")"
                      WHITESPACE@23..24 " "
                      WORD_OPERATOR@24..27 "AND"
                      WHITESPACE@27..28 " "
                      BINARY_EXPR@28..63
                        CALL_EXPR@28..52
                          NAME_EXPR@28..32
                            IDENT@28..32 "SQRT"
                          L_PAREN@32..33 "("
                          WHITESPACE@33..34 " "
                          NAME_EXPR@34..35
                            IDENT@34..35 "x"
                          WHITESPACE@35..36 " "
                          COMMA@36..37 ","
                          WHITESPACE@37..38 " "
                          CALL_EXPR@38..50
                            NAME_EXPR@38..41
                              IDENT@38..41 "SUM"
                            L_PAREN@41..42 "("
                            INDEX_EXPR@42..49
                              NAME_EXPR@42..43
                                IDENT@42..43 "a"
                              L_BRACKET@43..44 "["
                              RANGE_EXPR@44..48
                                LITERAL_EXPR@44..45
                                  LITERAL@44..45 "1"
                                DOT_DOT@45..47 ".."
                                LITERAL_EXPR@47..48
                                  LITERAL@47..48 "9"
                              R_BRACKET@48..49 "]"
                            R_PAREN@49..50 ")"
                          WHITESPACE@50..51 " "
                          R_PAREN@51..52 ")"
                        WHITESPACE@52..53 " "
                        COMMENT@53..58 "# c #"
                        WHITESPACE@58..59 " "
                        STAR@59..60 "*"
                        WHITESPACE@60..61 " "
                        NAME_EXPR@61..63
                          IDENT@61..63 "PI"
                    WHITESPACE@63..64 " "
                    R_PAREN@64..65 ")"
        "##]],
    );
    check_tree(
        "[CALC]( y, SHL(a, 2) MOD 3 )",
        expect![[r#"
        SOURCE_FILE@0..28
          RUNG@0..28
            LOGICAL_BLOCK@0..28
              BLOCK_HEAD@0..6
                L_BRACKET@0..1 "["
                MNEMONIC@1..5 "CALC"
                R_BRACKET@5..6 "]"
              OPERAND_LIST@6..28
                L_PAREN@6..7 "("
                WHITESPACE@7..8 " "
                NAME_EXPR@8..9
                  IDENT@8..9 "y"
                COMMA@9..10 ","
                WHITESPACE@10..11 " "
                BINARY_EXPR@11..26
                  CALL_EXPR@11..20
                    NAME_EXPR@11..14
                      WORD_OPERATOR@11..14 "SHL"
                    L_PAREN@14..15 "("
                    NAME_EXPR@15..16
                      IDENT@15..16 "a"
                    COMMA@16..17 ","
                    WHITESPACE@17..18 " "
                    LITERAL_EXPR@18..19
                      LITERAL@18..19 "2"
                    R_PAREN@19..20 ")"
                  WHITESPACE@20..21 " "
                  WORD_OPERATOR@21..24 "MOD"
                  WHITESPACE@24..25 " "
                  LITERAL_EXPR@25..26
                    LITERAL@25..26 "3"
                WHITESPACE@26..27 " "
                R_PAREN@27..28 ")"
    "#]],
    );
}

#[test]
fn a_user_defined_block() {
    check_tree(
        "+--[$Debounce]( button, T#20ms, pressed )--+",
        expect![[r#"
        SOURCE_FILE@0..44
          RUNG@0..44
            RAIL_CONNECTOR@0..1 "+"
            WIRE@1..3 "--"
            LOGICAL_BLOCK@3..41
              BLOCK_HEAD@3..14
                L_BRACKET@3..4 "["
                BLOCK_NAME@4..13 "$Debounce"
                R_BRACKET@13..14 "]"
              OPERAND_LIST@14..41
                L_PAREN@14..15 "("
                WHITESPACE@15..16 " "
                NAME_EXPR@16..22
                  IDENT@16..22 "button"
                COMMA@22..23 ","
                WHITESPACE@23..24 " "
                LITERAL_EXPR@24..30
                  LITERAL@24..30 "T#20ms"
                COMMA@30..31 ","
                WHITESPACE@31..32 " "
                NAME_EXPR@32..39
                  IDENT@32..39 "pressed"
                WHITESPACE@39..40 " "
                R_PAREN@40..41 ")"
            WIRE@41..43 "--"
            RAIL_CONNECTOR@43..44 "+"
    "#]],
    );
}

#[test]
fn empty_texts() {
    check_tree(
        "",
        expect![[r#"
        SOURCE_FILE@0..0
    "#]],
    );
    check_tree(
        "\u{feff}",
        expect![[r#"
        SOURCE_FILE@0..3
          BLANK_LINE@0..3
            BOM@0..3 "\u{feff}"
    "#]],
    );
    check_tree(
        "\u{feff}+",
        expect![[r#"
        SOURCE_FILE@0..4
          RUNG@0..4
            BOM@0..3 "\u{feff}"
            RAIL_CONNECTOR@3..4 "+"
    "#]],
    );
}
