//! Sections, declarations and the first and last line of a block definition.

use crate::show::{check_errors, check_tree};
use expect_test::expect;

#[test]
fn a_section() {
    check_tree(
        "VAR_INPUT RETAIN # c #\n  start, stop : BOOL;\n  level AT %IW3 : INT := -5; # tank #\nEND_VAR\n",
        expect![[r##"
            SOURCE_FILE@0..91
              SECTION_HEADER@0..23
                KEYWORD@0..9 "VAR_INPUT"
                WHITESPACE@9..10 " "
                KEYWORD@10..16 "RETAIN"
                WHITESPACE@16..17 " "
                COMMENT@17..22 "# c #"
                NEWLINE@22..23 "\n"
              DECLARATION@23..45
                WHITESPACE@23..25 "  "
                NAME_LIST@25..36
                  IDENT@25..30 "start"
                  COMMA@30..31 ","
                  WHITESPACE@31..32 " "
                  IDENT@32..36 "stop"
                WHITESPACE@36..37 " "
                COLON@37..38 ":"
                WHITESPACE@38..39 " "
                TYPE_REF@39..43
                  KEYWORD@39..43 "BOOL"
                SEMICOLON@43..44 ";"
                NEWLINE@44..45 "\n"
              DECLARATION@45..83
                WHITESPACE@45..47 "  "
                NAME_LIST@47..52
                  IDENT@47..52 "level"
                WHITESPACE@52..53 " "
                AT_CLAUSE@53..60
                  KEYWORD@53..55 "AT"
                  WHITESPACE@55..56 " "
                  ADDRESS@56..60 "%IW3"
                WHITESPACE@60..61 " "
                COLON@61..62 ":"
                WHITESPACE@62..63 " "
                TYPE_REF@63..66
                  KEYWORD@63..66 "INT"
                WHITESPACE@66..67 " "
                INITIAL_VALUE@67..72
                  ASSIGN@67..69 ":="
                  WHITESPACE@69..70 " "
                  UNARY_EXPR@70..72
                    MINUS@70..71 "-"
                    LITERAL_EXPR@71..72
                      LITERAL@71..72 "5"
                SEMICOLON@72..73 ";"
                WHITESPACE@73..74 " "
                COMMENT@74..82 "# tank #"
                NEWLINE@82..83 "\n"
              SECTION_END@83..91
                KEYWORD@83..90 "END_VAR"
                NEWLINE@90..91 "\n"
        "##]],
    );
}

#[test]
fn types_and_values() {
    check_tree(
        "VAR a : ARRAY[-1..100] OF STRING[80] := [1, 2(0)]; t : TON; x : LREAL := 2.0 * PI; END_VAR",
        expect![[r#"
            SOURCE_FILE@0..90
              SECTION_HEADER@0..4
                KEYWORD@0..3 "VAR"
                WHITESPACE@3..4 " "
              DECLARATION@4..51
                NAME_LIST@4..5
                  IDENT@4..5 "a"
                WHITESPACE@5..6 " "
                COLON@6..7 ":"
                WHITESPACE@7..8 " "
                TYPE_REF@8..36
                  KEYWORD@8..13 "ARRAY"
                  L_BRACKET@13..14 "["
                  MINUS@14..15 "-"
                  LITERAL@15..16 "1"
                  DOT_DOT@16..18 ".."
                  LITERAL@18..21 "100"
                  R_BRACKET@21..22 "]"
                  WHITESPACE@22..23 " "
                  KEYWORD@23..25 "OF"
                  WHITESPACE@25..26 " "
                  KEYWORD@26..32 "STRING"
                  L_BRACKET@32..33 "["
                  LITERAL@33..35 "80"
                  R_BRACKET@35..36 "]"
                WHITESPACE@36..37 " "
                INITIAL_VALUE@37..49
                  ASSIGN@37..39 ":="
                  WHITESPACE@39..40 " "
                  ARRAY_EXPR@40..49
                    L_BRACKET@40..41 "["
                    LITERAL_EXPR@41..42
                      LITERAL@41..42 "1"
                    COMMA@42..43 ","
                    WHITESPACE@43..44 " "
                    CALL_EXPR@44..48
                      LITERAL_EXPR@44..45
                        LITERAL@44..45 "2"
                      L_PAREN@45..46 "("
                      LITERAL_EXPR@46..47
                        LITERAL@46..47 "0"
                      R_PAREN@47..48 ")"
                    R_BRACKET@48..49 "]"
                SEMICOLON@49..50 ";"
                WHITESPACE@50..51 " "
              DECLARATION@51..60
                NAME_LIST@51..52
                  IDENT@51..52 "t"
                WHITESPACE@52..53 " "
                COLON@53..54 ":"
                WHITESPACE@54..55 " "
                TYPE_REF@55..58
                  KEYWORD@55..58 "TON"
                SEMICOLON@58..59 ";"
                WHITESPACE@59..60 " "
              DECLARATION@60..83
                NAME_LIST@60..61
                  IDENT@60..61 "x"
                WHITESPACE@61..62 " "
                COLON@62..63 ":"
                WHITESPACE@63..64 " "
                TYPE_REF@64..69
                  KEYWORD@64..69 "LREAL"
                WHITESPACE@69..70 " "
                INITIAL_VALUE@70..81
                  ASSIGN@70..72 ":="
                  WHITESPACE@72..73 " "
                  BINARY_EXPR@73..81
                    LITERAL_EXPR@73..76
                      LITERAL@73..76 "2.0"
                    WHITESPACE@76..77 " "
                    STAR@77..78 "*"
                    WHITESPACE@78..79 " "
                    NAME_EXPR@79..81
                      IDENT@79..81 "PI"
                SEMICOLON@81..82 ";"
                WHITESPACE@82..83 " "
              SECTION_END@83..90
                KEYWORD@83..90 "END_VAR"
        "#]],
    );
}

#[test]
fn free_form() {
    check_errors(
        &[
            "VAR\n a\n ,\n b # c #\n :\n\n INT\n ;\nEND_VAR\n",
            "VAR CONSTANT limit : INT := 80; END_VAR\n",
            "var_output run : bool; end_var\n",
            "VAR\n\n# c #\n  # d # a : INT;\nEND_VAR",
        ],
        expect![[r#"
            SECTION_HEADER VAR \n
            DECLARATION · ‹NAME_LIST:a
             ,
             b› · # c # \n · : \n \n · ‹TYPE_REF:INT› \n · ; \n
            SECTION_END END_VAR \n

            SECTION_HEADER VAR · CONSTANT ·
            DECLARATION ‹NAME_LIST:limit› · : · ‹TYPE_REF:INT› · ‹INITIAL_VALUE::= ‹LITERAL_EXPR:80›› ; ·
            SECTION_END END_VAR \n

            SECTION_HEADER var_output ·
            DECLARATION ‹NAME_LIST:run› · : · ‹TYPE_REF:bool› ; ·
            SECTION_END end_var \n

            SECTION_HEADER VAR \n
            BLANK_LINE \n
            COMMENT_LINE # c # \n
            DECLARATION · # d # · ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

        "#]],
    );
}

#[test]
fn declarations_with_errors() {
    check_errors(
        &[
            "VAR\na\nb : INT;\nEND_VAR",
            "VAR\na : INT\nb : INT;\nEND_VAR",
            "VAR\na :\nEND_VAR",
            "VAR\na : INT :=\n;\nEND_VAR",
            "VAR\na : INT 5;\nb : INT;\nEND_VAR",
            "VAR\na b : INT; c : INT;\nEND_VAR",
            "VAR\na, : INT;\nEND_VAR",
            "VAR\na AT : INT;\nEND_VAR",
            "VAR\na : ARRAY[1] OF INT;\nb : ARRAY[1..2] INT;\nc : STRING[];\nd : ARRAY[1..2, 3..4] OF INT;\nEND_VAR",
            "VAR\na : INT := [1, , 2, (3;\nEND_VAR",
            "VAR\n;\n)\n: INT;\nAND : INT;\nEND_VAR",
            "VAR a : INT END_VAR\n",
            "VAR a : INT := END_VAR\n",
            "VAR a : INT := 'x\n;END_VAR\n",
            "VAR RETAIN CONSTANT\nEND_VAR",
        ],
        expect![[r#"
            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› \n
                "" 5..5 BadDeclaration(TypeExpected)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› \n
                "" 11..11 BadDeclaration(SemicolonMissing)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : ‹TYPE_REF:› \n
                "" 7..7 BadDeclaration(TypeExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · ‹INITIAL_VALUE::=› \n ; \n
                "" 14..14 BadDeclaration(ValueExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · ‹ERROR_NODE:5;› \n
                "" 11..11 BadDeclaration(SemicolonMissing)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · ‹ERROR_NODE:b : INT;› ·
                "b" 6..7 BadDeclaration(TypeExpected)
            DECLARATION ‹NAME_LIST:c› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a,› · ‹ERROR_NODE:: INT;› \n
                ":" 7..8 BadDeclaration(NameExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · ‹AT_CLAUSE:AT› · ‹ERROR_NODE:: INT;› \n
                ":" 9..10 BadDeclaration(AddressExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:ARRAY[1› ‹ERROR_NODE:] OF INT;› \n
                "]" 15..16 BadDeclaration(BoundsExpected)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:ARRAY[1..2]› · ‹ERROR_NODE:INT;› \n
                "INT" 41..44 BadDeclaration(OfExpected)
            DECLARATION ‹NAME_LIST:c› · : · ‹TYPE_REF:STRING[› ‹ERROR_NODE:];› \n
                "]" 57..58 BadDeclaration(BoundsExpected)
            DECLARATION ‹NAME_LIST:d› · : · ‹TYPE_REF:ARRAY[1..2, 3..4] OF INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · ‹INITIAL_VALUE::= ‹ARRAY_EXPR:[‹LITERAL_EXPR:1›, , ‹LITERAL_EXPR:2›, ‹PAREN_EXPR:(‹LITERAL_EXPR:3›››› ; \n
                "[1, , 2, (3" 15..26 UnclosedBlock {closing: R_BRACKET}
                "," 19..20 MissingOperand {place: List}
                "(3" 24..26 UnclosedBlock {closing: R_PAREN}
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:› ; \n
                ";" 4..5 BadDeclaration(NameExpected)
            DECLARATION ‹NAME_LIST:› ‹ERROR_NODE:)› \n
                ")" 6..7 BadDeclaration(NameExpected)
            DECLARATION ‹NAME_LIST:› ‹ERROR_NODE:: INT;› \n
                ":" 8..9 BadDeclaration(NameExpected)
            DECLARATION ‹NAME_LIST:› ‹ERROR_NODE:AND : INT;› \n
                "AND" 15..18 BadDeclaration(NameExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR ·
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ·
                "" 11..11 BadDeclaration(SemicolonMissing)
            SECTION_END END_VAR \n

            SECTION_HEADER VAR ·
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · ‹INITIAL_VALUE::=› ·
                "" 14..14 BadDeclaration(ValueExpected)
            SECTION_END END_VAR \n

            SECTION_HEADER VAR ·
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · ‹INITIAL_VALUE::= ‹LITERAL_EXPR:'x›› \n ;
                "'x" 15..17 UnclosedString
            SECTION_END END_VAR \n

            SECTION_HEADER VAR · RETAIN · CONSTANT \n
                "CONSTANT" 11..19 BadDeclaration(Unexpected)
            SECTION_END END_VAR

        "#]],
    );
}

/// An unfinished section ends at a line of a drawing or of a block definition, with one error.
#[test]
fn unfinished_sections() {
    check_errors(
        &[
            "VAR\na : INT;\n\n+--[ ]( a )--+\n",
            "VAR\na : INT\n  |\n",
            "VAR\na :\n# c # +--+\n",
            "VAR\na : INT; +--+\nEND_VAR",
            "VAR\n( a )\nEND_VAR",
            "VAR\nFUNCTION_BLOCK [$B]\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [$B]\nVAR\nEND_FUNCTION_BLOCK",
            "VAR\na : INT;\nVAR_INPUT\nb : INT;\nEND_VAR",
            "VAR\na : INT;\n",
            "VAR",
        ],
        expect![[r#"
            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; \n
            BLANK_LINE \n
            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- + \n
                "+" 14..15 BadDeclaration(SectionNotClosed)

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› \n
                "" 11..11 BadDeclaration(SemicolonMissing)
            RAIL_LINE · | \n
                "|" 14..15 BadDeclaration(SectionNotClosed)

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : ‹TYPE_REF:› \n
                "" 7..7 BadDeclaration(TypeExpected)
            RUNG # c # · + -- + \n
                "+" 14..15 BadDeclaration(SectionNotClosed)

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; ·
            DECLARATION ‹NAME_LIST:› ‹ERROR_NODE:+--+› \n
                "+" 13..14 BadDeclaration(NameExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:› ‹ERROR_NODE:( a )› \n
                "(" 4..5 BadDeclaration(NameExpected)
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› \n
                "FUNCTION_BLOCK" 4..18 BadDeclaration(SectionNotClosed)
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› \n
            SECTION_HEADER VAR \n
            BLOCK_END END_FUNCTION_BLOCK
                "END_FUNCTION_BLOCK" 24..42 BadDeclaration(SectionNotClosed)

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; \n
            SECTION_HEADER VAR_INPUT \n
                "VAR_INPUT" 13..22 BadDeclaration(SectionNotClosed)
            DECLARATION ‹NAME_LIST:b› · : · ‹TYPE_REF:INT› ; \n
            SECTION_END END_VAR

            SECTION_HEADER VAR \n
                "VAR" 0..3 BadDeclaration(SectionNotClosed)
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; \n

            SECTION_HEADER VAR
                "VAR" 0..3 BadDeclaration(SectionNotClosed)

        "#]],
    );
}

#[test]
fn section_ends() {
    check_errors(
        &[
            "END_VAR",
            "END_VAR END_VAR",
            "VAR END_VAR;",
            "VAR END_VAR VAR END_VAR",
            "VAR END_VAR +--+",
            "VAR END_VAR ---",
            "VAR END_VAR hello there",
            "VAR END_VAR # c #",
        ],
        expect![[r#"
            SECTION_END END_VAR
                "END_VAR" 0..7 BadDeclaration(EndWithoutSection)

            SECTION_END END_VAR ·
                "END_VAR" 0..7 BadDeclaration(EndWithoutSection)
            SECTION_END END_VAR
                "END_VAR" 8..15 BadDeclaration(EndWithoutSection)

            SECTION_HEADER VAR ·
            SECTION_END END_VAR ‹ERROR_NODE:;›
                ";" 11..12 BadDeclaration(LineNotEnded)

            SECTION_HEADER VAR ·
            SECTION_END END_VAR ·
            SECTION_HEADER VAR ·
                "VAR" 12..15 BadDeclaration(LineNotEnded)
            SECTION_END END_VAR

            SECTION_HEADER VAR ·
            SECTION_END END_VAR ·
            RUNG + -- +
                "+" 12..13 BadDeclaration(LineNotEnded)

            SECTION_HEADER VAR ·
            SECTION_END END_VAR ·
            RUNG ---
                "---" 12..15 BadDeclaration(LineNotEnded)

            SECTION_HEADER VAR ·
            SECTION_END END_VAR · ‹ERROR_NODE:hello there›
                "hello there" 12..23 BadDeclaration(LineNotEnded)

            SECTION_HEADER VAR ·
            SECTION_END END_VAR · # c #

        "#]],
    );
}

#[test]
fn block_definitions() {
    check_tree(
        "FUNCTION_BLOCK [$B] # c #\n+--+\nEND_FUNCTION_BLOCK\n",
        expect![[r##"
            SOURCE_FILE@0..50
              BLOCK_HEADER@0..26
                KEYWORD@0..14 "FUNCTION_BLOCK"
                WHITESPACE@14..15 " "
                BLOCK_HEAD@15..19
                  L_BRACKET@15..16 "["
                  BLOCK_NAME@16..18 "$B"
                  R_BRACKET@18..19 "]"
                WHITESPACE@19..20 " "
                COMMENT@20..25 "# c #"
                NEWLINE@25..26 "\n"
              RUNG@26..31
                RAIL_CONNECTOR@26..27 "+"
                WIRE@27..29 "--"
                RAIL_CONNECTOR@29..30 "+"
                NEWLINE@30..31 "\n"
              BLOCK_END@31..50
                KEYWORD@31..49 "END_FUNCTION_BLOCK"
                NEWLINE@49..50 "\n"
        "##]],
    );
    check_errors(
        &[
            "FUNCTION_BLOCK ($B)\nEND_FUNCTION_BLOCK",
            "function_block <$B>\nend_function_block",
            "FUNCTION_BLOCK\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK $B\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [B]\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [$B\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [$B]( a, b )\nEND_FUNCTION_BLOCK x",
            "FUNCTION_BLOCK [$B] VAR_INPUT a : INT; END_VAR\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [$B]\nFUNCTION_BLOCK [$C]\nEND_FUNCTION_BLOCK\nEND_FUNCTION_BLOCK",
            "FUNCTION_BLOCK [$B]\n",
        ],
        expect![[r#"
            BLOCK_HEADER FUNCTION_BLOCK · ‹($B)› \n
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER function_block · ‹<$B>› \n
            BLOCK_END end_function_block

            BLOCK_HEADER FUNCTION_BLOCK \n
                "" 14..14 BadDeclaration(BlockHeadExpected)
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹ERROR_NODE:!"$"B› \n
                "$B" 15..17 BadDeclaration(BlockHeadExpected)
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹[B]› \n
                "[B]" 15..18 BadDeclaration(BlockHeadExpected)
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B› \n
                "[$B" 15..18 UnclosedBlock {closing: R_BRACKET}
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› ‹ERROR_NODE:( a, b )› \n
                "( a, b )" 19..27 BadDeclaration(Unexpected)
            BLOCK_END END_FUNCTION_BLOCK · ‹ERROR_NODE:x›
                "x" 47..48 BadDeclaration(LineNotEnded)

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› ·
            SECTION_HEADER VAR_INPUT ·
                "VAR_INPUT" 20..29 BadDeclaration(LineNotEnded)
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› ; ·
            SECTION_END END_VAR \n
            BLOCK_END END_FUNCTION_BLOCK

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› \n
            BLOCK_HEADER FUNCTION_BLOCK · ‹[$C]› \n
                "FUNCTION_BLOCK [$C]" 20..39 BadDeclaration(NestedBlock)
            BLOCK_END END_FUNCTION_BLOCK \n
            BLOCK_END END_FUNCTION_BLOCK
                "END_FUNCTION_BLOCK" 59..77 BadDeclaration(EndWithoutBlock)

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› \n
                "FUNCTION_BLOCK [$B]" 0..19 BadDeclaration(BlockNotClosed)

        "#]],
    );
}
