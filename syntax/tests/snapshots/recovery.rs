//! Broken rungs: one error is reported once, and the rest of the rung keeps its meaning.

use crate::show::check_errors;
use expect_test::expect;
use ladder_syntax::{Many, SyntaxErrorKind};

#[test]
fn first_part_not_closed() {
    check_errors(
        &[
            "+--[TON( t, 5s )--( )( y )--+",
            "+--[ ( a )--( )( y )--+",
            "+--[TON --( )( y )--+",
            "+--[TO",
            "+--[",
            "+--[ \n+--+",
            "+--[TON --+",
            "+--(S( y )--+",
            "+--( --+",
            "+--<JMP( l )--+",
            "+--<JMP --[ ]( a )--+",
            "+--[ # c #--+",
            "+--[/\\--+",
        ],
        expect![[r#"
            RUNG + -- ‹‹[TON›‹( ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "[TON" 3..7 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[› ‹( ‹NAME_EXPR:a› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "[" 3..4 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[TON ›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "[TON " 3..8 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[TO››
                "[TO" 3..6 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[››
                "[" 3..4 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[›› · \n
                "[" 3..4 UnclosedBlock {closing: R_BRACKET}
            RUNG + -- +

            RUNG + -- ‹‹[TON ›› -- +
                "[TON " 3..8 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹(S›‹( ‹NAME_EXPR:y› )›› -- +
                "(S" 3..5 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹( ›› -- +
                "( " 3..5 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹<JMP›‹( ‹NAME_EXPR:l› )›› -- +
                "<JMP" 3..7 UnclosedBlock {closing: R_ANGLE}

            RUNG + -- ‹‹<JMP ›› -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- +
                "<JMP " 3..8 UnclosedBlock {closing: R_ANGLE}

            RUNG + -- ‹‹[ # c #›› -- +
                "[ # c #" 3..10 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[/›› \ -- +
                "[/" 3..5 UnclosedBlock {closing: R_BRACKET}

        "#]],
    );
}

#[test]
fn first_part_with_junk() {
    check_errors(
        &[
            "+--[TON)( t, 5s )--+",
            "+--(S]( y )--+",
            "+--<RET]--+",
            "+--[T ON]( t )--+",
            "+--[>=]( a, b )--+",
            "+--[T-ON]( t )--+",
            "+--[TON, x]( t )--+",
            "+--[=]( a )--+",
            "+--( t, T#5s )--+",
            "+--( a + b )--+",
            "+--[$my__block]( a )--+",
            "+--[$]( a )--+",
            "+--[$1a]( a )--+",
            "+--[€]( a )--+",
        ],
        expect![[r#"
            RUNG + -- ‹‹[TON!")"›‹( ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s› )›› -- +
                ")" 7..8 WrongBracket {closing: R_BRACKET}

            RUNG + -- ‹‹(S!"]"›‹( ‹NAME_EXPR:y› )›› -- +
                "]" 5..6 WrongBracket {closing: R_PAREN}

            RUNG + -- ‹‹<RET!"]"›› -- +
                "]" 7..8 WrongBracket {closing: R_ANGLE}

            RUNG + -- ‹‹[T !"ON"]›‹( ‹NAME_EXPR:t› )›› -- +
                "ON" 6..8 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[!">="]›‹( ‹NAME_EXPR:a›, ‹NAME_EXPR:b› )›› -- +
                ">=" 4..6 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[T!"-ON"]›‹( ‹NAME_EXPR:t› )›› -- +
                "-ON" 5..8 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[TON!", x"]›‹( ‹NAME_EXPR:t› )›› -- +
                ", x" 7..10 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[!"="]›‹( ‹NAME_EXPR:a› )›› -- +
                "=" 4..5 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹( t!"," !"T#5s" )›› -- +
                ", T#5s" 6..12 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹( a !"+ b" )›› -- +
                "+ b" 7..10 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[$my__block]›‹( ‹NAME_EXPR:a› )›› -- +
                "$my__block" 4..14 BadBlockName

            RUNG + -- ‹‹[!"$"]›‹( ‹NAME_EXPR:a› )›› -- +
                "$" 4..5 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[!"$1a"]›‹( ‹NAME_EXPR:a› )›› -- +
                "$1a" 4..7 UnexpectedCharacter {place: Head, after_comment: false}

            RUNG + -- ‹‹[!"€"]›‹( ‹NAME_EXPR:a› )›› -- +
                "€" 4..7 UnexpectedCharacter {place: Head, after_comment: false}

        "#]],
    );
}

#[test]
fn operand_list_not_closed() {
    check_errors(
        &[
            "+--[ ]( a --( )( y )--+",
            "+--[ ]( a--( )( y )--+",
            "+--[ ]( a-[ ]( b )--+",
            "+--[ ]( a -\\--[ ]( b )--+",
            "+--[ ]( a --+",
            "+--[ ]( a -+",
            "+--[ ]( a +",
            "+--[ ]( a  |",
            "+--[ ]( a",
            "+--[ ](",
            "+--[ ]( \n+--+",
            "+--[ ]( a [ ]( b )--( )( y )--+",
            "+--[ ]( a[ ]( b )--( )( y )--+",
            "+--[ ]( a ( )( y )--+",
            "+--[ ]( a --[TON]( t, 5s --( )( y )--+",
            "+--[ ]( a # c #--( )( y )--+",
            "+--[ ]( a --# c #--( )( y )--+",
            "+--[TON]( t, --( )( y )--+",
            "+--[TON]( t, 5s, R := --( )( y )--+",
            "+--[CALC]( y, (a + b )--( )( z )--+",
            "+--[CALC]( y, ((a + b) * 2 )--( )( z )--+",
            "+--[CALC]( y, a[3 )--( )( z )--+",
            "+--[CALC]( y, a + --( )( z )--+",
            "+--[CALC]( y, SQRT(a --( )( z )--+",
            "+--[FMT]( 'abc )--( )( z )--+",
            "|  /--[ ]( a --/  |",
        ],
        expect![[r#"
            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a››› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a" 6..9 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a››› - ‹‹[ ]›‹( ‹NAME_EXPR:b› )›› -- +
                "( a" 6..9 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› - \ -- ‹‹[ ]›‹( ‹NAME_EXPR:b› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› - +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a››› · |
                "( a" 6..9 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a›››
                "( a" 6..9 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹(››
                "(" 6..7 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹(›› · \n
                "(" 6..7 UnclosedBlock {closing: R_PAREN}
            RUNG + -- +

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› ‹‹[ ]›‹( ‹NAME_EXPR:b› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a››› ‹‹[ ]›‹( ‹NAME_EXPR:b› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a" 6..9 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› -- ‹‹[TON]›‹( ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s› ›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}
                "( t, 5s " 17..25 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› # c #›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a # c #" 6..15 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› -- # c # -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( a " 6..10 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[TON]›‹( ‹NAME_EXPR:t›, ›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( t, " 8..13 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[TON]›‹( ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s›, ‹NAMED_OPERAND:‹NAME_EXPR:R› :=› ›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- +
                "( t, 5s, R := " 8..22 UnclosedBlock {closing: R_PAREN}
                "" 21..21 MissingOperand {place: Named}

            RUNG + -- ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹PAREN_EXPR:(‹BINARY_EXPR:‹NAME_EXPR:a› + ‹NAME_EXPR:b›› )››› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "( y, (a + b )" 9..22 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹PAREN_EXPR:(‹BINARY_EXPR:‹PAREN_EXPR:(‹BINARY_EXPR:‹NAME_EXPR:a› + ‹NAME_EXPR:b››)› * ‹LITERAL_EXPR:2›› )››› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "( y, ((a + b) * 2 )" 9..28 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹INDEX_EXPR:‹NAME_EXPR:a›[‹LITERAL_EXPR:3›› )›› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "[3" 15..17 UnclosedBlock {closing: R_BRACKET}

            RUNG + -- ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› +› ›› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "( y, a + " 9..18 UnclosedBlock {closing: R_PAREN}
                "" 17..17 MissingOperand {place: Operator}

            RUNG + -- ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹CALL_EXPR:‹NAME_EXPR:SQRT›(‹NAME_EXPR:a›› ›› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "( y, SQRT(a " 9..21 UnclosedBlock {closing: R_PAREN}
                "(a" 18..20 UnclosedBlock {closing: R_PAREN}

            RUNG + -- ‹‹[FMT]›‹( ‹LITERAL_EXPR:'abc› )›› -- ‹‹( )›‹( ‹NAME_EXPR:z› )›› -- +
                "'abc" 10..14 UnclosedString

            RUNG | · / -- ‹‹[ ]›‹( ‹NAME_EXPR:a› ›› -- / · |
                "( a " 9..13 UnclosedBlock {closing: R_PAREN}

        "#]],
    );
}

/// What looks like drawing stays an expression where the parentheses pair.
#[test]
fn closed_lists_are_never_cut() {
    check_errors(
        &[
            "[CALC]( y, a --b )",
            "[CALC]( y, a --(b) )",
            "[CALC]( y, a --# c # b )",
            "[CALC]( y, a - -b[ 1 ] )",
            "[CALC]( y, a -(b)(c) )",
            "[MOV]( y, a [3] )",
            "[FMT]( ')', '--(' )--( )( y )",
            "[FMT]( a, # ) # b )--( )( y )",
            "[MOV]( y, T#5s )# ) #--( )( y )",
        ],
        expect![[r#"
            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› -‹UNARY_EXPR:-‹NAME_EXPR:b››› )››

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› -‹UNARY_EXPR:-‹PAREN_EXPR:(‹NAME_EXPR:b›)››› )››

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› -‹UNARY_EXPR:-# c # ‹NAME_EXPR:b››› )››

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› - ‹UNARY_EXPR:-‹INDEX_EXPR:‹NAME_EXPR:b›[ ‹LITERAL_EXPR:1› ]››› )››

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› -‹CALL_EXPR:‹PAREN_EXPR:(‹NAME_EXPR:b›)›(‹NAME_EXPR:c›)›› )››

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹INDEX_EXPR:‹NAME_EXPR:a› [‹LITERAL_EXPR:3›]› )››

            RUNG ‹‹[FMT]›‹( ‹LITERAL_EXPR:')'›, ‹LITERAL_EXPR:'--('› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )››

            RUNG ‹‹[FMT]›‹( ‹NAME_EXPR:a›, # ) # ‹NAME_EXPR:b› )›› -- ‹‹( )›‹( ‹NAME_EXPR:y› )››

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹LITERAL_EXPR:T#5s› )›› # ) # -- ‹‹( )›‹( ‹NAME_EXPR:y› )››

        "#]],
    );
}

#[test]
fn operands_missing_or_misplaced() {
    check_errors(
        &[
            "[TON]( , 5s )",
            "[TON]( t, )",
            "[TON]( t,, 5s )",
            "[TON]( t 5s )",
            "[TON]( t; 5s )",
            "[TON]( t, R := )",
            "[TON]( t, := r )",
            "[TON]( t, R := a := b )",
            "[CALC]( y, a + )",
            "[CALC]( y, * b )",
            "[CALC]( y, a + * b )",
            "[CALC]( y, a NOT b )",
            "[CALC]( y, () )",
            "[CALC]( y, (a b) )",
            "[CALC]( y, SQRT() )",
            "[CALC]( y, SQRT(,) )",
            "[CALC]( y, SQRT(a,) )",
            "[CALC]( y, +5 + +b )",
            "[MOV]( a[], b[..], c[1..], d[..2], e[1, 2] )",
            "[MOV]( a., .b, a..b )",
            "[MOV]( y, [1, 2] )",
            "[MOV]( y | a )",
            "[MOV]( y, € )",
            "[MOV]( y, a € b )",
            "[MOV]( y, a) )",
            "[MOV]( y, a ]] )",
            "[MOV]( y, 'a', '\n)",
        ],
        expect![[r#"
            RUNG ‹‹[TON]›‹( , ‹LITERAL_EXPR:5s› )››
                "," 7..8 MissingOperand {place: List}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›, )››
                ")" 10..11 MissingOperand {place: List}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›,, ‹LITERAL_EXPR:5s› )››
                "," 9..10 MissingOperand {place: List}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t› ‹LITERAL_EXPR:5s› )››
                "5s" 9..11 MissingComma

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›!";" ‹LITERAL_EXPR:5s› )››
                ";" 8..9 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›, ‹NAMED_OPERAND:‹NAME_EXPR:R› :=› )››
                ")" 15..16 MissingOperand {place: Named}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›, ‹NAMED_OPERAND::= ‹NAME_EXPR:r›› )››
                ":=" 10..12 MissingOperand {place: Named}

            RUNG ‹‹[TON]›‹( ‹NAME_EXPR:t›, ‹NAMED_OPERAND:‹NAME_EXPR:R› := ‹NAME_EXPR:a›› ‹NAMED_OPERAND::= ‹NAME_EXPR:b›› )››
                ":=" 17..19 MissingOperand {place: Named}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› +› )››
                ")" 15..16 MissingOperand {place: Operator}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:* ‹NAME_EXPR:b›› )››
                "*" 11..12 MissingOperand {place: Operator}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:‹NAME_EXPR:a› + ‹BINARY_EXPR:* ‹NAME_EXPR:b››› )››
                "*" 15..16 MissingOperand {place: Operator}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹NAME_EXPR:a› ‹UNARY_EXPR:NOT ‹NAME_EXPR:b›› )››
                "NOT" 13..16 MissingComma

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹PAREN_EXPR:()› )››
                ")" 12..13 MissingOperand {place: Parentheses}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹PAREN_EXPR:(‹NAME_EXPR:a› ‹NAME_EXPR:b›)› )››
                "b" 14..15 MissingComma

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹CALL_EXPR:‹NAME_EXPR:SQRT›()› )››

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹CALL_EXPR:‹NAME_EXPR:SQRT›(,)› )››
                "," 16..17 MissingOperand {place: List}
                ")" 17..18 MissingOperand {place: List}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹CALL_EXPR:‹NAME_EXPR:SQRT›(‹NAME_EXPR:a›,)› )››
                ")" 18..19 MissingOperand {place: List}

            RUNG ‹‹[CALC]›‹( ‹NAME_EXPR:y›, ‹BINARY_EXPR:!"+"‹LITERAL_EXPR:5› + !"+"‹NAME_EXPR:b›› )››
                "+" 11..12 UnexpectedCharacter {place: Operands, after_comment: false}
                "+" 16..17 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹INDEX_EXPR:‹NAME_EXPR:a›[]›, ‹INDEX_EXPR:‹NAME_EXPR:b›[‹RANGE_EXPR:..›]›, ‹INDEX_EXPR:‹NAME_EXPR:c›[‹RANGE_EXPR:‹LITERAL_EXPR:1›..›]›, ‹INDEX_EXPR:‹NAME_EXPR:d›[‹RANGE_EXPR:..‹LITERAL_EXPR:2››]›, ‹INDEX_EXPR:‹NAME_EXPR:e›[‹LITERAL_EXPR:1›, ‹LITERAL_EXPR:2›]› )››
                "]" 9..10 MissingOperand {place: Index}
                ".." 14..16 MissingOperand {place: Range}
                "]" 16..17 MissingOperand {place: Range}
                "]" 24..25 MissingOperand {place: Range}
                ".." 29..31 MissingOperand {place: Range}

            RUNG ‹‹[MOV]›‹( ‹MEMBER_EXPR:‹NAME_EXPR:a›.›, !"."‹NAME_EXPR:b›, ‹NAME_EXPR:a›!".."‹NAME_EXPR:b› )››
                "," 9..10 MissingOperand {place: Member}
                "." 11..12 UnexpectedCharacter {place: Operands, after_comment: false}
                ".." 16..18 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, !"["‹LITERAL_EXPR:1›, ‹LITERAL_EXPR:2›!"]" )››
                "[" 10..11 UnexpectedCharacter {place: Operands, after_comment: false}
                "]" 15..16 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y› !"|" ‹NAME_EXPR:a› )››
                "|" 9..10 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, !"€" )››
                "€" 10..13 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹NAME_EXPR:a› !"€" ‹NAME_EXPR:b› )››
                "€" 12..15 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹NAME_EXPR:a›)›› · !")"
                ")" 13..14 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹NAME_EXPR:a› !"]"!"]" )››
                "]]" 12..14 UnexpectedCharacter {place: Operands, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, ‹LITERAL_EXPR:'a'›, ‹LITERAL_EXPR:'››› \n
                "( y, 'a', '" 5..16 UnclosedBlock {closing: R_PAREN}
                "'" 15..16 UnclosedString
            STRAY_LINE !")"
                ")" 17..18 UnexpectedCharacter {place: Rung, after_comment: false}

        "#]],
    );
}

#[test]
fn stray_characters_on_a_rung() {
    check_errors(
        &[
            "+--hello--+",
            "+--[ ]( a ))--+",
            "hello world, this is text",
            "+--[ ]( a )--] --+",
            "+-- a > b --+",
            "x +--( )( y )--+ z",
            "+--\u{a0}--+",
            "*",
        ],
        expect![[r#"
            RUNG + -- !"hello" -- +
                "hello" 3..8 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› !")" -- +
                ")" 11..12 UnexpectedCharacter {place: Rung, after_comment: false}

            STRAY_LINE !"hello" · !"world," · !"this" · !"is" · !"text"
                "hello world, this is text" 0..25 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- !"]" · -- +
                "]" 13..14 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG + -- · !"a" · !">" · !"b" · -- +
                "a > b" 4..9 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG !"x" · + -- ‹‹( )›‹( ‹NAME_EXPR:y› )›› -- + · !"z"
                "x" 0..1 UnexpectedCharacter {place: Rung, after_comment: false}
                "z" 17..18 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG + -- !"\u{a0}" -- +
                "\u{a0}" 3..5 UnexpectedCharacter {place: Rung, after_comment: false}

            STRAY_LINE !"*"
                "*" 0..1 UnexpectedCharacter {place: Rung, after_comment: false}

        "#]],
    );
}

#[test]
fn too_many() {
    let errors = |text: &str| {
        let parse = ladder_syntax::parse(text);
        assert_eq!(parse.syntax().to_string(), text);
        let errors = parse.errors().into_iter();
        errors
            .map(|error| (error.kind, text[error.range].to_owned()))
            .collect::<Vec<_>>()
    };
    let parts = Many::Parts.most() as usize;
    let line = "- ".repeat(parts) + "\n";
    assert_eq!(errors(&line), []);
    // The next line is read again, also where a comment begins in what was not read.
    let line = "- ".repeat(parts) + "(S)( y )--+ # open\r\n+--( )( y )--+";
    let rest = (
        SyntaxErrorKind::TooMany(Many::Parts),
        "(S)( y )--+ # open".to_owned(),
    );
    assert_eq!(errors(&line), [rest]);
    let operands = Many::Operands.most() as usize;
    let block =
        |count: usize, after: &str| format!("+--[ADD]( y{}{after} )--( )( z )--+\n", ", a".repeat(count - 1));
    assert_eq!(errors(&block(operands, "")), []);
    let rest = (
        SyntaxErrorKind::TooMany(Many::Operands),
        "b, (c + d), R := e".to_owned(),
    );
    assert_eq!(errors(&block(operands, ", b, (c + d), R := e")), [rest]);
    let blocks = ladder_syntax::parse(&block(operands, ", b")).syntax();
    let blocks = blocks.descendants().filter(|node| node.kind().is_block()).count();
    assert_eq!(blocks, 2, "the coil after it is still a block");
}

#[test]
fn too_complex() {
    let deep = format!(
        "[CALC]( y, {}a{}, b )--( )( z )",
        "(".repeat(150),
        ")".repeat(150)
    );
    let long = format!("[CALC]( y, a{}, b )--( )( z )", " + a".repeat(600));
    for text in [deep, long] {
        let parse = ladder_syntax::parse(&text);
        let errors: Vec<_> = parse.errors().into_iter().map(|e| e.kind).collect();
        assert_eq!(errors, [ladder_syntax::SyntaxErrorKind::TooComplex], "{text}");
        let end = parse
            .syntax()
            .descendants()
            .filter(|n| n.kind().is_block())
            .count();
        assert_eq!(end, 2, "the coil after it is still a block");
    }
}
