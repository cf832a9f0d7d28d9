//! The spacing and the letters of operands.

use ladder_format::{Options, format_text};

/// Formats one block that is alone on a rung.
#[track_caller]
fn becomes(block: &str, expected: &str) {
    for (text, expected) in [(block, expected), (expected, expected)] {
        let new = format_text(&format!("+--{text}--+"), &Options::default());
        let new = new.trim_start_matches(['+', '-']).trim_end_matches(['+', '-']);
        assert_eq!(new, expected);
    }
}

#[test]
fn lists() {
    becomes("[TON](t,T#5s)", "[TON]( t, T#5s )");
    becomes("[TON]\t(  t  ,  T#5s  )", "[TON]( t, T#5s )");
    becomes("[TON](t,5s,R:=r,R=>r)", "[TON]( t, 5s, R := r, R => r )");
    becomes("[OSR](   )", "[OSR]( )");
    becomes("[]()", "[ ]( )");
    becomes("()(a)", "( )( a )");
    becomes("[\t/ ]( a )", "[/]( a )");
    becomes("< JMP >( l )", "<JMP>( l )");
    becomes("( $Coil )( a )", "($Coil)( a )");
}

#[test]
fn expressions() {
    becomes("[CALC](y,a+b*c/d^2)", "[CALC]( y, a + b * c / d ^ 2 )");
    becomes("[CALC](y,a  -  b--c)", "[CALC]( y, a - b - -c )");
    becomes("[CALC](y,- - a)", "[CALC]( y, --a )");
    becomes("[CALC](y,-  5)", "[CALC]( y, -5 )");
    becomes(
        "[CALC](y,not a and(not(b)or c))",
        "[CALC]( y, NOT a AND (NOT (b) OR c) )",
    );
    becomes("[CALC](y,( ( a )+b ))", "[CALC]( y, ((a) + b) )");
    becomes("[CALC](y,a<=b)", "[CALC]( y, a <= b )");
    becomes("[CALC](y,a<>b = c)", "[CALC]( y, a <> b = c )");
    becomes("[CALC](y,max( a,min (b ,c) ))", "[CALC]( y, MAX(a, MIN(b, c)) )");
    becomes(
        "[CALC](y,SUM( a[ 1 .. n + 1 ] ))",
        "[CALC]( y, SUM(a[1..n + 1]) )",
    );
    becomes("[ ]( a [ i ] . q )", "[ ]( a[i].q )");
    becomes("[ ]( word . 3 )", "[ ]( word.3 )");
    becomes("[MOV]( s, 'a  b' )", "[MOV]( s, 'a  b' )");
}

#[test]
fn letters() {
    becomes("[ton]( T1, t#5s, r := R )", "[TON]( T1, t#5s, R := R )");
    becomes("[mov]( a, true )", "[MOV]( a, TRUE )");
    becomes("[mov]( a, Sys.first_scan )", "[MOV]( a, SYS.first_scan )");
    becomes("[calc]( y, sqrt(pi) shl 2 )", "[CALC]( y, SQRT(PI) SHL 2 )");
    becomes("[search]( y, ge, ge, t[1..9] )", "[SEARCH]( y, GE, ge, t[1..9] )");
    becomes("<call>( sqrt )", "<CALL>( sqrt )");
    // The parameters of a user-defined block are names, not words of the language.
    becomes("[$debounce]( raw := a )", "[$debounce]( raw := a )");
    // An unknown word may be a tag that lost its coil.
    becomes("(run)", "(run)");
    becomes("[foo]( a )", "[foo]( a )");
    // EN and ENO are such words only in the body of a block.
    becomes("[ ]( en )", "[ ]( en )");
}

#[test]
fn comments() {
    becomes("[ ]( a# after a tag #)", "[ ]( a # after a tag # )");
    becomes("[ ](a # c #)", "[ ]( a # c # )");
    becomes("[ ](# c #a)", "[ ]( # c # a )");
    becomes("[ADD](y # c # , a,# d #b)", "[ADD]( y # c #, a, # d # b )");
    becomes("[# c #TON]( t, 5s )", "[# c # TON]( t, 5s )");
    becomes("[CALC]( y, - - # c # a )", "[CALC]( y, -- # c # a )");
    becomes("[CALC]( y, a[ # c # 3 ] )", "[CALC]( y, a[# c # 3] )");
}

/// Where blanks away would make other tokens, they stay.
#[test]
fn what_would_read_differently() {
    becomes("[CALC]( y, - (a)(b) )", "[CALC]( y, - (a)(b) )");
    becomes("[CALC]( y, a.1 . 2 )", "[CALC]( y, a.1 . 2 )");
    becomes("[ ]( %IX0 . 3 )", "[ ]( %IX0 . 3 )");
    becomes("[ ]( w[1 .. 4] )", "[ ]( w[1..4] )");
}

#[test]
fn a_block_with_an_error_stays_as_written() {
    becomes("[TON](t,)", "[TON](t,)");
    becomes("[ADD](a  b,c)", "[ADD](a  b,c)");
    becomes("[CALC](y,a+)", "[CALC](y,a+)");
}
