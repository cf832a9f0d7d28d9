//! Comments at every gap between two tokens, in every construct: the formatter may move them, but keeps every one of
//! them, and what the text says.

use super::check;
use ladder_syntax::{NodeOrToken, parse};
use proptest::sample::Index;

/// Every construct of the language.
const CONSTRUCTS: &[&str] = &[
    "+--[ ]( a )--[/]( b[ i + 1 ] )--( )( y )--+\n",
    "+--\\--[P]( a )--\\--(S)( y[1..3] )--+\n|  /--[N]( b.3 )--/                |\n",
    "+--[ ]( a )\\( )( y )/( )( z )\\+\n|/[ ]( b )/\\( )( w )/|\n|/( )( v )|\n",
    "+--\\--[ ]( a )--\\--\\--[ ]( c )--\\--( )( y )--+\n|  /--[ ]( b )--/  /--[ ]( d )--/            |\n",
    "  --[OSR]--[NOT]( )--  -[GT]( level, -5, 16#FF )-\n",
    "+--[TON]( t, T#5s, R := reset )--[CTUD]( c, 3, CD := d, LD := l )--+\n",
    "+--[CALC]( y, -( a + b ) * SQRT( c ) ^ 2 - NOT d OR e MOD 3 <> 1.5 )--+\n",
    "+--[SEARCH]( k, EQ, 5, t[1..9], NEXT := m, FOUND => h )--[MOV]( s, 'it$'s' )--+\n",
    "<LBL>( loop )--[ ]( %IX0.3 )--<JMP>( loop )\n+--<FUN>( f )--+\n+--<FOR>( 3 )--+\n+--<NEXT>--+\n+--<RET>--+\n",
    "+--[$Wait]( in, out := x, q => y )--($Coil)( a )--<$Home>--+\n",
    "VAR_INPUT\n    start, stop : BOOL;\n    level AT %IW3 : INT := -5;\nEND_VAR\n",
    "VAR RETAIN s : STRING[80] := 'a'; list : ARRAY[1..3] OF INT := [1, 2( 0 )]; END_VAR\n",
    "VAR\n    a : BOOL;\n\n    bcd : REAL := 1.5;\nEND_VAR\n\n+--[ ]( a )--+\n",
    "VAR CONSTANT x : TIME := T#5s; y : DINT := 2 * -( 3 + x ); END_VAR\n",
    "FUNCTION_BLOCK [$W]\nVAR_OUTPUT q : BOOL; END_VAR\n+--[ ]( EN )--( )( q )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK <$Home>\n\n|\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK ( $Coil )\nEND_FUNCTION_BLOCK\n",
    "+--[ ]( a )--( )( y )--\n\n|      |\n|\n+--[ ]( b )--\\--( )( y )--+\n|      |\n\n   /--( )( z )--+\n",
    // Errors: what stays must stay whole.
    "+--[ ]( a b )--[UNKNOWN]( c, )--|--( )( y )--+--+\n",
    "+--[ ( broken )--+\nstray\nEND_VAR\nVAR a : ; b : INT\n+--[ ]( b )--+\n",
    "VAR_INPUT a : INT; END_VAR +--[ ]( a )--+ \nEND_FUNCTION_BLOCK x\nFUNCTION_BLOCK x\nFUNCTION_BLOCK\n",
];

/// Comments and what may be around them.
pub(crate) const COMMENTS: &[&str] = &[
    "# c #",
    " # c # ",
    "##",
    "# c ## d #",
    "# c #  # d #",
    "# a\nb #",
    "# c #\n",
    "\n# c #",
    "# ladder: fmt off #",
];

#[test]
fn at_every_gap() {
    for construct in CONSTRUCTS {
        for gap in gaps(construct) {
            for comment in COMMENTS {
                let (before, after) = construct.split_at(gap);
                check(&format!("{before}{comment}{after}"));
            }
        }
    }
}

/// Where a token begins or ends.
fn gaps(text: &str) -> Vec<usize> {
    let tokens = parse(text)
        .syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .map(|token| usize::from(token.text_range().start()))
        .collect::<Vec<_>>();
    tokens.into_iter().chain([text.len()]).collect()
}

/// A text with comments at some of its gaps.
pub(crate) fn insert(mut text: String, places: &[(Index, usize)]) -> String {
    for (at, comment) in places {
        let gaps = gaps(&text);
        text.insert_str(gaps[at.index(gaps.len())], COMMENTS[*comment]);
    }
    text
}

#[test]
fn at_two_gaps() {
    for construct in CONSTRUCTS {
        let gaps = gaps(construct);
        for (n, &first) in gaps.iter().enumerate() {
            for &second in &gaps[n..] {
                check(&format!(
                    "{}# c #{}# d #{}",
                    &construct[..first],
                    &construct[first..second],
                    &construct[second..]
                ));
            }
        }
    }
}
