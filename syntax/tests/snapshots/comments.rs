//! Comments: which of them an error is about.

use crate::show::check_errors;
use expect_test::expect;

#[test]
fn over_several_lines() {
    check_errors(
        &[
            "+--[ ]( a )--# three\nand more #--( )( w )--+\n",
            "# one\r\n| two\r\n#\r\n+--+",
            "[TON]( # first\noperand # t, 5s )",
            "[ # in\nthe head # TON ]( t, 5s )",
        ],
        expect![[r#"
            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- # three\nand more # -- ‹‹( )›‹( ‹NAME_EXPR:w› )›› -- + \n

            COMMENT_LINE # one\r\n| two\r\n# \r\n
            RUNG + -- +

            RUNG ‹‹[TON]›‹( # first
            operand # ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s› )››

            RUNG ‹‹[ # in
            the head # TON ]›‹( ‹NAME_EXPR:t›, ‹LITERAL_EXPR:5s› )››

        "#]],
    );
}

#[test]
fn never_closed() {
    check_errors(
        &[
            "#",
            "+--+ # tail",
            "+--[ ]( a # c )--+\n",
            "+--[ ]( a, # c )--+\n",
            "+--[TON # c ]( t )--+\n",
            "# a\n+--[ ]( a )--+\n# b #\n+--+\n",
            "# one\n  two #\n+--+ # three\n",
            "VAR\na : INT # END_VAR\n",
            "FUNCTION_BLOCK [$B] # END\n",
            "x # a\n  | y #\n$ # z",
        ],
        expect![[r##"
            COMMENT_LINE #
                "#" 0..1 UnclosedComment

            RUNG + -- + · # tail
                "#" 5..6 UnclosedComment

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a››› · # c )--+\n
                "#" 10..11 UnclosedComment

            RUNG + -- ‹‹[ ]›‹( ‹NAME_EXPR:a›,›› · # c )--+\n
                "#" 11..12 UnclosedComment

            RUNG + -- ‹‹[TON # c ]( t )--+
            ››
                "#" 8..9 UnclosedComment

            STRAY_LINE # a\n+--[ ]( a )--+\n# · !"b" · #\n+--+\n
                "#" 0..1 UnclosedComment

            COMMENT_LINE # one\n  two # \n
            RUNG + -- + · # three\n
                "#" 19..20 UnclosedComment

            SECTION_HEADER VAR \n
            DECLARATION ‹NAME_LIST:a› · : · ‹TYPE_REF:INT› · # END_VAR\n
                "#" 12..13 UnclosedComment

            BLOCK_HEADER FUNCTION_BLOCK · ‹[$B]› · # END\n
                "#" 20..21 UnclosedComment

            STRAY_LINE !"x" · # a\n  | y # \n
                "x" 0..1 UnexpectedCharacter {place: Rung, after_comment: false}
                "#" 2..3 UnclosedComment
            STRAY_LINE !"$" · # z

        "##]],
    );
}

/// A comment that takes in a literal's `#` ends there; the rest of the literal says so.
#[test]
fn cut_by_a_literal() {
    check_errors(
        &[
            "# +--[TON]( t, T#5s )--+ #",
            "# was 16#FF #",
            "# plain #word",
            "# plain # word",
            "[MOV]( y, # T#5s # )",
            "# c # +--[ ]( a )--+",
        ],
        expect![[r##"
            RUNG # +--[TON]( t, T# !"5s" · !")" -- + · #
                "5s )" 17..21 UnexpectedCharacter {place: Rung, after_comment: true}
                "#" 25..26 UnclosedComment

            STRAY_LINE # was 16# !"FF" · #
                "FF" 9..11 UnexpectedCharacter {place: Rung, after_comment: true}
                "#" 12..13 UnclosedComment

            STRAY_LINE # plain # !"word"
                "word" 9..13 UnexpectedCharacter {place: Rung, after_comment: false}

            STRAY_LINE # plain # · !"word"
                "word" 10..14 UnexpectedCharacter {place: Rung, after_comment: false}

            RUNG ‹‹[MOV]›‹( ‹NAME_EXPR:y›, # T#‹LITERAL_EXPR:5s››› · # )
                "#" 17..18 UnclosedComment

            RUNG # c # · + -- ‹‹[ ]›‹( ‹NAME_EXPR:a› )›› -- +

        "##]],
    );
}
