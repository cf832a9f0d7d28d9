//! Arbitrary strings, and strings of pieces that look like ladder.

use crate::invariants::check;
use proptest::prelude::*;

/// Pieces from which texts are made that look like ladder, with every character that means something.
pub(crate) fn pieces() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        4 => prop::sample::select(vec![
            "+--", "--+", "\\", "/", "--\\--", "--/--", "[ ]( a )", "[/]( b )", "( )( y )", "(S)( y )",
            "[TON]( t, T#5s )", "[TON]( t, 5s, R := r )", "<JMP>( l )", "<RET>", "[$B]( a, b )", "|", "|  ", "\n", "\r\n",
            "\r", " ", "\t", "--", "-", "# c #", "#", "# a\n+--", "VAR\n", "VAR_INPUT ", "END_VAR\n", "a : INT;",
            "TYPE\n", "END_TYPE\n", "M : STRUCT\n", "END_STRUCT;\n", "P : (IDLE, RUN := 5);", "x : M := (a := [1, 2((b := 3))]);",
            "cell[2].zone[k + 1, 3].open", "g[1, 2..3]", "r : INT(0..9);", "m : ARRAY[1..2, 0..n] OF $B;",
            "b, c : ARRAY[1..3] OF INT := [1, 2(0)];", "s : STRING[5] := 'a$'b';", "FUNCTION_BLOCK [$B]\n",
            "END_FUNCTION_BLOCK\n", "[CALC]( y, a + b * -c ^ 2 )", "[CALC]( y, (a + SQRT(b)) / 2 )", "a[3..9]", "t1.Q",
            "[ ]( word.3 )", "16#FF", "T#1h30m", "D#2026-11-21", "'", "(", ")", "[", "]", "<", ">", ",", ":=", "=>", ";",
            ":", "..", ".", "%IX0.3", "NOT", "MOD", "$", "\u{feff}", "\0", "\u{2028}", "é", "温", "🙂", "((((", "----(",
            "<<<<<<< a\n", "<<<<<<<\r\n", "||||||| b\n", "=======\n", ">>>>>>> c\n", "# <<<<<<< ours #\n", "# ======= #\n",
            "# >>>>>>> theirs #\n",
        ]).prop_map(str::to_owned),
        1 => any::<String>(),
    ];
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_string(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn ladder_like(text in pieces()) {
        check(&text);
    }
}
