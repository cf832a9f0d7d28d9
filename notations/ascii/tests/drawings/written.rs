//! Ladder text drawn with characters, and read again.

use super::truth::{assert_runs, read};
use expect_test::{Expect, expect};
use ladder_analysis::analyze;
use ladder_notation::Notation;
use ladder_notation_ascii::Ascii;
use ladder_syntax::parse;

fn drawn(ladder: &str) -> String {
    let analysis = analyze(&parse(ladder).into(), "test");
    let writing = Ascii.write(&analysis).expect("it can be written");
    String::from_utf8(writing.bytes).expect("it is text")
}

#[track_caller]
fn check(ladder: &str, expected: Expect) {
    let drawn = drawn(ladder);
    expected.assert_eq(&format!("{drawn}\n{}", read(&drawn)));
}

#[test]
fn branches() {
    let ladder = r"
# Seal-in #
+--\--[ ]( start )--\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |

+--\--[ ]( a )--------\--(S)( y )--+
|  /--\--[ ]( b )--\--/            |
|     /--[P]( c )--/               |
";
    check(
        ladder,
        expect![[r#"
        Seal-in

        |     start     stop                                                    run   |
        +--+--|   |--+--| / |--------------------------------------------------(   )--+
        |  |   run   |                                                                |
        |  +--|   |--+                                                                |

        |       a                                                                y    |
        +--+--|   |--+---------------------------------------------------------( S )--+
        |  |    b    |                                                                |
        |  +--|   |--+                                                                |
        |  |    c    |                                                                |
        |  +--| P |--+                                                                |

        # Seal-in #

        +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
        |  /--[ ]( run )----/                                                          |

        +--\--[ ]( a )--------\----------------------------------------------(S)( y )--+
        |  /--\--[ ]( b )--\--/                                                        |
        |     /--[P]( c )--/                                                           |
    "#]],
    );
    for text in [ladder, &read(&drawn(ladder))] {
        assert_runs(text, "run", &["start", "run", "stop"], |v| {
            (v[0] || v[1]) && !v[2]
        });
    }
}

#[test]
fn boxes() {
    check(
        "+--[ ]( a )--[TON]( t, T#5s )--( )( y )--+\n+--[ ]( b )--[CTU]( c, 5, R := a )--(S)( z )--+\n+--[GE]( n, 3 )--[ADD]( n, n, 1 )--+\n+--[ ]( a )--[MOV]( n, 5 )--(RES)( c )--+\n",
        expect![[r#"
            |                                                               t             |
            |    a                                                      +- TON -+    y    |
            +--|   |----------------------------------------------------+IN    Q+--(   )--+
            |                                                           |PT T#5s|         |
            |                                                           +-------+         |

            |                                                                c            |
            |    b                                                        + CTU +    z    |
            +--|   |------------------------------------------------------+CU  Q+--( S )--+
            |                                                             |PV 5 |         |
            |                                                             |R  a |         |
            |                                                             +-----+         |

            |    n                                                             +- ADD -+  |
            +--| >=|-----------------------------------------------------------+EN  ENO+--+
            |    3                                                             |y = n  |  |
            |                                                                  |a   n  |  |
            |                                                                  |b   1  |  |
            |                                                                  +-------+  |

            |    a                                                    +- MOV -+     c     |
            +--|   |--------------------------------------------------+EN  ENO+--( RES )--+
            |                                                         |y = n  |           |
            |                                                         |a   5  |           |
            |                                                         +-------+           |

            +--[ ]( a )----------------------------------------[TON]( t, T#5s )--( )( y )--+

            +--[ ]( b )-----------------------------------[CTU]( c, 5, R := a )--(S)( z )--+

            +--[GE]( n, 3 )----------------------------------------------[ADD]( n, n, 1 )--+

            +--[ ]( a )-----------------------------------------[MOV]( n, 5 )--(RES)( c )--+
        "#]],
    );
}

#[test]
fn the_program_flow() {
    check(
        "+--<LBL>( again )--[ ]( a )--( )( y )--+\n\n+--[/]( a )--<JMP>( again )--+\n\n+--[ ]( b )--<CALL>( mix )--+\n\n+--<FUN>( mix )--( )( z )--+\n\n+--[ ]( b )--<RET>--+\n",
        expect![[r#"
            |               a                                                        y    |
            +--[again: ]--|   |----------------------------------------------------(   )--+

            |    a                                                                        |
            +--| / |------------------------------------------------------------>> again--+

            |    b                                                                        |
            +--|   |--------------------------------------------------------< CALL mix >--+

            |                                                                        z    |
            +--< FUN mix >---------------------------------------------------------(   )--+

            |    b                                                                        |
            +--|   |----------------------------------------------------------< RETURN >--+

            +--<LBL>( again )--[ ]( a )------------------------------------------( )( y )--+

            +--[/]( a )----------------------------------------------------<JMP>( again )--+

            +--[ ]( b )-----------------------------------------------------<CALL>( mix )--+

            +--<FUN>( mix )------------------------------------------------------( )( z )--+

            +--[ ]( b )-------------------------------------------------------------<RET>--+
        "#]],
    );
}

/// Numbers with their signs, in every place of an operand: what is drawn is read as the same program.
#[test]
fn operands_come_back() {
    let numbers = ["-7", "7", "-1_000", "INT#-5", "-32768", "16#FF"];
    let reals = ["-1.5", "2.25e-3", "-1.5e-3", "-0.001", "REAL#-2.5"];
    let times = ["T#-5s", "T#1h30m", "T#-1m30s", "T#250ms"];
    let blocks = |value: &str, of: &str| {
        [
            format!("[LE]( {of}1, {value} )"),
            format!("[GT]( {value}, {of}1 )"),
            format!("[EQ]( {of}1, {of}2, {value} )"),
            format!("[MOV]( {of}1, {value} )"),
            format!("[LIMIT]( {of}1, {value}, {of}1, {value} )"),
            format!("[SEL]( {of}1, go, {value}, {of}1 )"),
        ]
    };
    let sums = |value: &str, of: &str| {
        [
            format!("[ADD]( {of}1, {of}2, {value} )"),
            format!("[SUB]( {of}1, {value}, {of}2, {value} )"),
            format!("[CALC]( {of}1, -{of}2 + {value} * -({of}1 - {value}) )"),
        ]
    };
    let of = |values: &[&str], name: &str, adds: bool| -> Vec<String> {
        let all = values.iter().flat_map(|value| {
            let sums = adds.then(|| sums(value, name)).into_iter().flatten();
            blocks(value, name).into_iter().chain(sums).collect::<Vec<_>>()
        });
        all.collect()
    };
    let all = [
        of(&numbers, "n", true),
        of(&reals, "x", true),
        of(&times, "d", false),
    ]
    .concat();
    let all = all
        .into_iter()
        .chain(["[TON]( t, T#5s )".into(), "[LUT]( n1, n2, -1, 2, -3 )".into()]);
    for block in all {
        let program = format!("+--[ ]( go )--{block}--( )( out )--+\n");
        let laid_out = ladder_format::format_text(&program, &ladder_format::Options::default());
        let drawn = drawn(&program);
        assert_eq!(read(&drawn), laid_out, "{drawn}");
    }
}
