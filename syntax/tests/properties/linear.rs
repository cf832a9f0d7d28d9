//! Texts that would take minutes if any look ahead or back went over the same characters again and again.

use crate::invariants::check;

const LENGTH: usize = 20_000;

/// A beginning, and what is repeated after it.
const PATTERNS: [(&str, &[&str]); 5] = [
    (
        "",
        &[
            "(",
            "[",
            "<",
            ")",
            "]",
            "/",
            "\\",
            "|",
            "+",
            "-",
            "#",
            "# ",
            "#a",
            "'",
            "$",
            "5",
            "x",
            "x ",
            "é",
            " ",
            "\n",
            "\r",
            "[ ](",
            "[ ]( a",
            "[ ]( a --",
            "[ ]( a [ ",
            "[ ]( a [b",
            "[TON ",
            "(S ",
            "(T#",
            "(a#b ",
            "[= ",
            "[ # c #",
            "<J ",
            "\\\n/",
            "# a\n+",
            "END_VAR ",
            "VAR ",
            "VAR\n",
            "FUNCTION_BLOCK [$B]\n",
            "END_FUNCTION_BLOCK\n",
        ],
    ),
    (
        "[CALC]( ",
        &[
            "(",
            "[",
            "-",
            "- ",
            "a --",
            "a -",
            "a - ",
            "'",
            "'(,$",
            "+ ",
            "+|",
            "NOT ",
            ".",
            ".a",
            "[a]",
            "(a)",
            "a[",
            "a [",
            "a(",
            ",",
            "a ",
            "a + ",
            "a ^ ",
            "a + b * ",
            "a # c # ",
            "# c #",
            "a:=",
            ":=",
            "]",
            "€ ",
            "1e-",
            "1#",
            "1.",
            "-(",
            "-(a",
            "-(  ",
            "a -(b)(",
            "a -[",
            "\\",
            "(a b,",
            "(a, ",
            "a[ ",
            "a.b.c[1].d + ",
        ],
    ),
    ("[CALC]( y, a", &[" ", " |", "\t", "  -", " # c #"]),
    (
        "VAR\n",
        &[
            "a\n",
            "a :\n",
            "a,\n",
            "a : INT\n",
            "a : INT;",
            "a;",
            "a # c #\n",
            "# c #\n",
            ";",
            "'\n",
            ":=\n",
        ],
    ),
    (
        "VAR\na : INT := ",
        &["[", "(", "1,", "a.", "-", "'", "\n", "# c #"],
    ),
];

#[test]
fn long_texts_take_their_time_once() {
    for (begin, patterns) in PATTERNS {
        for pattern in patterns {
            for end in ["", " )--( )( y )--+\n"] {
                check(&format!("{begin}{}{end}", pattern.repeat(LENGTH / pattern.len())));
            }
        }
    }
}
