//! Semantic tokens of texts.

use super::*;
use expect_test::{Expect, expect};
use std::sync::Arc;

fn shown(text: &str, within: Option<TextRange>) -> String {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
    let tokens = semantic_tokens(&analysis.context, within);
    let mut shown = String::new();
    let mut end = TextSize::new(0);
    for token in tokens {
        assert!(token.range.start() >= end, "in order, none in another: {token:?}");
        end = token.range.end();
        let legend = TokenKind::LEGEND
            .iter()
            .find(|(kind, ..)| *kind == token.kind)
            .unwrap();
        let mut modifiers = String::new();
        for (modifier, name, _) in Modifiers::LEGEND {
            if token.modifiers.0 & modifier.0 != 0 {
                modifiers.push(' ');
                modifiers.push_str(name);
            }
        }
        shown.push_str(&format!("{:?} {}{modifiers}\n", &text[token.range], legend.1));
    }
    shown
}

fn check(text: &str, expected: Expect) {
    expected.assert_eq(&shown(text, None));
}

#[test]
fn legends_are_in_the_order_of_their_numbers() {
    for (index, (kind, ..)) in TokenKind::LEGEND.iter().enumerate() {
        assert_eq!(*kind as usize, index);
    }
    for (index, (modifier, ..)) in Modifiers::LEGEND.iter().enumerate() {
        assert_eq!(modifier.0, 1 << index);
    }
}

#[test]
fn rungs() {
    check(
        "# a pump #\n+--\\--[ ]( start )--\\--[/]( stop )--# why #--( )( run )--+\n|  /--[ ]( run )----/                                     |\n",
        expect![[r##"
            "# a pump #" comment
            "start" variable input
            "/" function defaultLibrary contact
            "stop" variable input
            "# why #" comment
            "run" variable modification
            "run" variable
        "##]],
    );
    check(
        "+--[TON]( t, T#5s, R := SYS.FIRST_SCAN )--[GT]( t.ET, 3 )--[ ]( word.3 )--(S)( %QX0.1 )--+\n",
        expect![[r#"
            "TON" function defaultLibrary
            "t" variable modification
            "T#5s" number
            "R" parameter
            ":=" operator
            "SYS" variable readonly defaultLibrary
            "FIRST_SCAN" property
            "GT" function defaultLibrary
            "t" variable
            "ET" property
            "3" number
            "word" variable input
            "3" property
            "S" function defaultLibrary coil
            "%QX0.1" variable static modification output
        "#]],
    );
    check(
        "+--[CALC]( y, SQRT(a[i]) + -2 * x MOD 3 )--[MOV]( row[k], 'text' )--[SEARCH]( n, EQ, 1, row[1..4], FOUND => hit )--+\n",
        expect![[r#"
            "CALC" function defaultLibrary
            "y" variable modification
            "SQRT" function defaultLibrary
            "a" variable input
            "i" variable input
            "+" operator
            "-" operator
            "2" number
            "*" operator
            "x" variable input
            "MOD" operator
            "3" number
            "MOV" function defaultLibrary
            "row" variable modification
            "k" variable input
            "'text'" string
            "SEARCH" function defaultLibrary
            "n" variable modification
            "EQ" enumMember defaultLibrary
            "1" number
            "row" variable
            "1" number
            "4" number
            "FOUND" parameter
            "=>" operator
            "hit" variable modification
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( done )--<CALL>( dose )--+\n+--<LBL>( done )--+\n+--<FUN>( dose )--<RET>--+\n",
        expect![[r#"
            "a" variable input
            "JMP" keyword
            "done" label
            "CALL" keyword
            "dose" function
            "LBL" keyword
            "done" label declaration
            "FUN" keyword
            "dose" function declaration
            "RET" keyword
        "#]],
    );
}

#[test]
fn declarations() {
    check(
        "VAR CONSTANT\n    limit, other AT %MW1 : INT := 80;\n    on : BOOL := TRUE;\n    a : ARRAY[1..8] OF DINT;\n    t : TON;\nEND_VAR\n\
             VAR_GLOBAL total : DINT; END_VAR\n+--[GT]( total, limit )--( )( on )--+\n",
        expect![[r#"
                "VAR" keyword
                "CONSTANT" keyword
                "limit" variable declaration readonly
                "other" variable declaration readonly
                "AT" keyword
                "%MW1" variable static
                "INT" type defaultLibrary
                ":=" operator
                "80" number
                "on" variable declaration readonly
                "BOOL" type defaultLibrary
                ":=" operator
                "TRUE" enumMember readonly defaultLibrary
                "a" variable declaration readonly
                "ARRAY" keyword
                "1" number
                "8" number
                "OF" keyword
                "DINT" type defaultLibrary
                "t" variable declaration readonly
                "TON" type defaultLibrary
                "END_VAR" keyword
                "VAR_GLOBAL" keyword
                "total" variable declaration static
                "DINT" type defaultLibrary
                "END_VAR" keyword
                "GT" function defaultLibrary
                "total" variable static
                "limit" variable readonly
                "on" variable readonly modification
            "#]],
    );
    check(
        "FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; END_VAR\nVAR_OUTPUT clean : BOOL; END_VAR\nVAR own : BOOL; END_VAR\n\
             +--[ ]( raw )--( )( clean )--( )( own )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n+--[$Hold]( raw := a, clean => b )--[$Hold]( a, b )--+\n",
        expect![[r#"
            "FUNCTION_BLOCK" keyword
            "$Hold" class declaration
            "VAR_INPUT" keyword
            "raw" parameter declaration input
            "BOOL" type defaultLibrary
            "END_VAR" keyword
            "VAR_OUTPUT" keyword
            "clean" parameter declaration output
            "BOOL" type defaultLibrary
            "END_VAR" keyword
            "VAR" keyword
            "own" variable declaration
            "BOOL" type defaultLibrary
            "END_VAR" keyword
            "raw" parameter input
            "clean" parameter modification output
            "own" variable modification
            "ENO" variable modification
            "END_FUNCTION_BLOCK" keyword
            "$Hold" class
            "raw" parameter
            ":=" operator
            "a" variable input
            "clean" parameter
            "=>" operator
            "b" variable modification
            "$Hold" class
            "a" variable input
            "b" variable modification
        "#]],
    );
}

#[test]
fn half_written_text() {
    check(
        "+--[TO\n+--[TON]( t, \nVAR\n  a :\n+--(",
        expect![[r#"
            "TO" function defaultLibrary
            "TON" function defaultLibrary
            "t" variable modification
            "VAR" keyword
            "a" variable declaration
        "#]],
    );
    check(
        "# never closed\n+--[ ]( a )--+",
        expect![[r##"
            "# never closed\n+--[ ]( a )--+" comment
        "##]],
    );
    check("", expect![[r""]]);
}

/// The tokens of a range are those of all of the text that are on its lines.
#[test]
fn a_range_is_a_part_of_the_whole() {
    let text = "VAR a : BOOL; END_VAR\n+--[ ]( a )--( )( y )--+\nFUNCTION_BLOCK [$B]\nVAR_INPUT raw : BOOL; END_VAR\n\
                    +--\\--[ ]( raw )--\\--( )( ENO )--+\n|  /--[ ]( raw )--/  |\nEND_FUNCTION_BLOCK\n+--[$B]( a )--+\n";
    for line in 0..text.lines().count() {
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let range = TextRange::at(TextSize::new(start as u32), TextSize::new(1));
        let mut whole = String::new();
        let alone = shown(text, Some(range));
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "test.clad");
        let logical = analysis.context.parse.line_at(range.start()).unwrap();
        let last = analysis.context.parse.line_at(range.end()).unwrap();
        let logical = analysis
            .context
            .parse
            .line_range(logical)
            .cover(analysis.context.parse.line_range(last));
        for (token, line) in semantic_tokens(&analysis.context, None)
            .iter()
            .zip(shown(text, None).lines())
        {
            if logical.contains_range(token.range) {
                whole.push_str(&format!("{line}\n"));
            }
        }
        assert_eq!(alone, whole, "line {line}");
    }
}
