//! The same for programs that hold, in small, what each rule looks at: whatever else decides about a finding comes and goes
//! elsewhere in the file.

use crate::incremental::{Document, asked, settings};
use ladder_tests::generator::Dice;

/// Declarations, definitions and comments.
const OTHERS: &[&str] = &[
    "VAR TOM : BOOL; END_VAR\n",
    "VAR n : INT; END_VAR\n",
    "VAR t : TON; END_VAR\n",
    "VAR_INPUT a, x : BOOL; END_VAR\n",
    "VAR_OUTPUT y : BOOL; END_VAR\n",
    "VAR CONSTANT k : INT := 0; END_VAR\n",
    "VAR arr : ARRAY[1..5] OF BOOL; END_VAR\n",
    "VAR w AT %IW0 : INT; END_VAR\n",
    "VAR RETAIN n : DINT; END_VAR\n",
    "VAR_GLOBAL g : BOOL; END_VAR\n",
    "VAR_EXTERNAL g : BOOL; END_VAR\n",
    "FUNCTION_BLOCK [$F]\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--( )( n )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK [$F]\nVAR_INPUT a : BOOL; b : INT := 1; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n\
     +--[ ]( a )--( )( q )--+\n+--<END>--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK <$G>\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--<JMP>( l )--+\nEND_FUNCTION_BLOCK\n",
    "FUNCTION_BLOCK ($F)\nVAR_INPUT a : BOOL; END_VAR\n+--[ ]( a )--($F)( a )--+\nEND_FUNCTION_BLOCK\n",
    "# ladder: allow(double-coil): x #\n",
    "# ladder: profile click #\n",
    "# ladder: profile iot #\n",
    "# ladder: cycle 5ms #\n",
    "# +--[ ]( a )--( )( b )--+ #\n",
    "// text\n",
    "# note #\n",
];

/// Networks, without the blank line behind them.
const NETWORKS: &[&str] = &[
    "+--[TOM]--( )( y )--+",
    "+--[ ]( TOM )--( )( b )--+",
    "+--[ ]( n )--( )( z )--+",
    "+--[GT]( n, 5 )--( )( z )--+",
    "+--[$F]( x )--( )( y )--+",
    "+--[$F]( x, q => y )--+",
    "+--[$F]( a := x, q := y )--+",
    "+--<$G>( x )--+",
    "+--[TON]( t, 5s )--( )( y )--+",
    "+--[TON]( t, 5ms )--( )( y )--+",
    "+--[ ]( t.Q )--( )( y )--+",
    "+--[ ]( t )--( )( z )--+",
    "+--[CTU]( t, 5 )--( )( y )--+",
    "+--[ ]( a )--(S)( y )--+",
    "+--[ ]( x )--(R)( y )--+",
    "+--[ ]( a )--[/]( a )--( )( y )--+",
    "+--<FUN>( f )--+",
    "+--[ ]( x )--<CALL>( f )--+",
    "+--<LBL>( l )--+",
    "+--[ ]( x )--<JMP>( l )--+",
    "+--<JMP>( l )--+",
    "+--<RET>--+",
    "+--<END>--+",
    "+--<FOR>( n, 1, 3 )--+",
    "+--<NEXT>--+",
    "+--<MCR>--+",
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( x )--/",
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /-----------/",
    "+--[ ]( a )--\\--( )( y )--+",
    "+--[ ]( x )--|--( )( z )--+",
    "|--[ ]( x )--( )( z )--+",
    "+--[DIV]( n, n, k )--+",
    "+--[MOV]( n, 70000 )--+",
    "+--[MOV]( w, n )--+",
    "+--[ ]( %IX0.1 )--( )( %QX0.1 )--+",
    "+--[ ]( arr[i] )--( )( z )--+",
    "+--[ ]( arr[3] )--( )( arr[9] )--+",
    "+--[ ]( undecl[2] )--( )( z )--+",
    "+--[ ]( tom )--( )( zz )--+",
    "+--[ ]( g )--( )( g )--+",
    "+--[EQ]( r, 0.1 )--( )( y )--+",
    "+--[CALC]( n, -n ^ 2 )--+",
    "+--[CALC]( r, 1.5 )--+",
    "+--[ADD]( n, n, 1 )--+",
    "+--[MOV]( d, T#5s )--+",
    "+--[MOV]( n, d )--+",
    "+--[ ]( n.3 )--( )( z )--+",
    "+--[ ]( q.Q )--( )( z )--+",
    "+--[TP]( q, 1s )--+",
    "+--[SET]( y, 1 )--+",
    "+--[ ]( y )--( )( x )--+",
    "+--[ ]( x )--( )( y )--[ ]( a )--( )( z )--+",
    "+--[ ]( a )--(M)( m )--+",
    "+--[PERSIST]( n )--+",
    "+--(RES)( t )--+",
    "+--[P]( a )--( )( y )--+",
    "+--[SR]( s )--+",
    "+--[ ]( start )--( )( stopp )--+",
    "+--[ ]( stop )--( )( start )--+",
    "+--[ ]( SYS.FIRST_SCAN )--( )( y )--+",
    "+--[ ]( x )--( )( SYS.ON )--+",
    "+--[MUX]( n, k, 1, 2 )--+",
    "+--[ ]( x )--",
    "+--[ ]( x )--( )( y )--( )( y )--+",
];

/// Names that take the place of others.
const NAMES: [&str; 14] = [
    "TOM", "n", "t", "a", "x", "y", "k", "arr", "g", "z", "f", "l", "start", "I1",
];

fn piece(dice: &mut Dice) -> String {
    if dice.one_in(4) {
        return dice.of(OTHERS).to_owned();
    }
    format!("{}\n\n", dice.of(NETWORKS))
}

/// Gives another name to one of the words in a piece.
fn rename(piece: &mut String, dice: &mut Dice) {
    let bytes = piece.as_bytes();
    let is_word = |at: usize| bytes[at].is_ascii_alphanumeric() || bytes[at] == b'_';
    let starts = (1..piece.len()).filter(|&at| bytes[at].is_ascii_lowercase() && !is_word(at - 1));
    let starts: Vec<usize> = starts.collect();
    if starts.is_empty() {
        return;
    }
    let start = starts[dice.below(starts.len())];
    let end = (start..piece.len())
        .find(|&at| !is_word(at))
        .unwrap_or(piece.len());
    piece.replace_range(start..end, NAMES[dice.below(NAMES.len())]);
}

#[test]
fn what_rules_look_at_comes_and_goes() {
    for seed in 0..asked(80) {
        let mut dice = Dice::new(seed);
        let mut pieces: Vec<String> = (0..8).map(|_| piece(&mut dice)).collect();
        let mut document = Document::with(pieces.concat(), settings(&mut dice));
        for _ in 0..40 {
            let at = dice.below(pieces.len());
            match dice.below(4) {
                0 if pieces.len() < 14 => pieces.insert(at, piece(&mut dice)),
                1 if pieces.len() > 4 => {
                    pieces.remove(at);
                }
                2 => rename(&mut pieces[at], &mut dice),
                _ => pieces[at] = piece(&mut dice),
            }
            document.becomes(pieces.concat());
        }
    }
}
