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
