//! Programs as projects: what there is to say about it, and what is read of the project again.

mod blocks;
mod file;

use crate::harness;
use expect_test::{Expect, expect};
use ladder_notation::{Notation, Outcome};
use ladder_notation_plcopen::Plcopen;

pub(super) fn xml(text: &str) -> (String, String) {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let writing = match Plcopen.write(&analysis) {
        Ok(writing) => writing,
        Err(error) => return (String::new(), format!("{error}\n")),
    };
    let mut told = String::new();
    for entry in writing.report.remarks() {
        match &entry.outcome {
            Outcome::Translated => {}
            Outcome::Approximated(why) => told.push_str(&format!(
                "{}: approximated {}: {why}\n",
                entry.place, entry.element
            )),
            Outcome::Refused(why) => {
                told.push_str(&format!("{}: refused {}: {why}\n", entry.place, entry.element));
            }
        }
    }
    (String::from_utf8(writing.bytes).expect("it is UTF-8"), told)
}

#[track_caller]
pub(super) fn check(text: &str, expected: Expect) {
    let (xml, told) = xml(text);
    let again = if xml.is_empty() {
        String::new()
    } else {
        harness::text(&xml)
    };
    expected.assert_eq(&(told + &again));
}

#[test]
fn contacts_coils_and_branches() {
    check(
        r"
VAR  a, b, c, x, y, z : BOOL;  END_VAR

# Seal-in #
+--\--[ ]( a )--\--[/]( b )--( )( x )--+
|  /--[ ]( x )--/                      |

+--[P]( a )--\--(S)( y )------------\--+
|            /--[ ]( c )--(/)( z )--/  |
+--[ ]( b )--(R)( y )--(P)( x )--+
+--[ ]( a )--\--[ ]( b )-----\--( )( y )--+
|            /--[/]( x )--\--/            |
+--[ ]( c )---------------/--[ ]( z )--( )( x )--+
",
        expect![[r#"
            # plant #
            # ladder: cycle 10ms #

            VAR
                a : BOOL;
                b : BOOL;
                c : BOOL;
                x : BOOL;
                y : BOOL;
                z : BOOL;
            END_VAR

            # Seal-in #
            +--\--[ ]( a )--\--[/]( b )------------------------------------------( )( x )--+
            |  /--[ ]( x )--/                                                              |

            +--[P]( a )--\----------------------------------------------------(S)( y )--\--+
            |            /--[ ]( c )------------------------------------------(/)( z )--/  |

            +--[ ]( b )------------------------------------------------(R)( y )--(P)( x )--+

            +--\--[ ]( a )--\--[ ]( b )--\-----\---------------------------------( )( y )--+
            |  /--\         /--[/]( x )--/  \--/                                           |
            |     /--[ ]( c )---------------/                                              |

            +--\--[ ]( a )--[/]( x )--\--[ ]( z )--------------------------------( )( x )--+
            |  /--[ ]( c )------------/                                                    |
        "#]],
    );
}

#[test]
fn what_changes_before_it_is_read_again() {
    check(
        r"
VAR  a, b, x, y : BOOL;  n : DINT;  END_VAR

+--[ ]( a )--[/]( x )--( )( x )--( )( y )--+
+--\--[ ]( a )--\--\--[ ]( b )--(R)( a )--\--+
|  /--[ ]( b )--/  /--( )( y )------------/  |
+--[EQ]( n, 3 )--[ADD]( n, n, 1 )--[ ]( a )--\--(S)( x )--\--+
|                                            /--(R)( y )--/  |
+--[ ]( a )--(S)( x )--( )( y )--+
",
        expect![[r#"
            # plant #
            # ladder: cycle 10ms #

            VAR
                a       : BOOL;
                b       : BOOL;
                x       : BOOL;
                y       : BOOL;
                n       : DINT;
                power   : BOOL;  # power at a point of the drawing #
                power_2 : BOOL;  # power at a point of the drawing #
            END_VAR

            +--[ ]( a )--[/]( x )--------------------------------------------( )( power )--+

            +--[ ]( power )--------------------------------------------( )( x )--( )( y )--+

            +--[ ]( a )----------------------------------------------------( )( power_2 )--+

            +--\--[ ]( power_2 )--\--\--[ ]( b )------------------------------(R)( a )--\--+
            |  /--[ ]( b )--------/  /----------------------------------------( )( y )--/  |

            +--[EQ]( n, 3 )--[ADD]( n, n, 1 )--[ ]( a )--\--------------------(S)( x )--\--+
            |                                            /--------------------(R)( y )--/  |

            +--[ ]( a )----------------------------------------------------------(S)( x )--+

            +--[ ]( x )----------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn falls_are_not_those_of_the_standard() {
    check(
        r"
VAR  a, b, x : BOOL;  END_VAR
+--[ ]( b )--[N]( a )--( )( x )--+
+--[ ]( a )--[OSF]--(N)( x )--+
",
        expect![[r#"
            # plant #
            # ladder: cycle 10ms #

            VAR
                a      : BOOL;
                b      : BOOL;
                x      : BOOL;
                was    : BOOL;  # what it was at the last evaluation #
                fell   : BOOL;  # it fell #
                was_2  : BOOL;  # what it was at the last evaluation #
                fell_2 : BOOL;  # it fell #
                was_3  : BOOL;  # what it was at the last evaluation #
                fell_3 : BOOL;  # it fell #
            END_VAR

            +--[ ]( was )--[/]( a )-------------------------------------------( )( fell )--+

            +--[ ]( a )--------------------------------------------------------( )( was )--+

            +--[ ]( b )--[ ]( fell )---------------------------------------------( )( x )--+

            +--\--[ ]( was_2 )--[/]( a )---------------------------------( )( fell_2 )--\--+
            |  /--[ ]( a )------------------------------------------------( )( was_2 )--/  |

            +--\--[ ]( was_3 )--[/]( fell_2 )----------------------------( )( fell_3 )--\--+
            |  /--[ ]( fell_2 )-------------------------------------------( )( was_3 )--/  |

            +--[ ]( fell_3 )-----------------------------------------------------( )( x )--+
        "#]],
    );
}

#[test]
fn timers_and_counters() {
    check(
        r"
VAR  a, r : BOOL;  t : TON;  c : CTU;  d : CTUD;  k : RTO;  END_VAR
+--[ ]( a )--[TON]( t, 500, R := r )--+
+--[ ]( a )--[CTU]( c, 5, R := t.DN )--+
+--[ ]( a )--[CTUD]( d, 5, CD := r, LD := c.Q )--[GE]( d.AC, 3 )--( )( r )--+
+--[ ]( a )--[RTO]( k, 5s )--+
+--[ ]( k.Q )--(RES)( c )--+
+--[ ]( t.TT )--( )( a )--+
",
        expect![[r#"
            7:1: refused network: the standard has no (RES)
            8:1: refused network: timers and counters there have no `TT`
            # plant #
            # ladder: cycle 10ms #

            VAR
                a : BOOL;
                r : BOOL;
                t : TON;
                c : CTU;
                d : CTUD;
                k : RTO;
            END_VAR

            +--[ ]( a )--[/]( r )-------------------------------------[TON]( t, T#500ms )--+

            +--[ ]( a )-------------------------------------------[CTU]( c, 5, R := t.Q )--+

            +--[ ]( a )--[CTUD]( d, 5, CD := r, LD := c.Q )--[GE]( d.CV, 3 )-----( )( r )--+

            +--[ ]( a )--------------------------------------------------[RTO]( k, T#5s )--+

            # Not written, because the standard has no (RES): #
            # +--[ ]( k.Q )--(RES)( c )--+ #
            # Not written, because timers and counters there have no `TT`: #
            # +--[ ]( t.TT )--( )( a )--+ #
        "#]],
    );
}

#[test]
fn data() {
    check(
        r"
VAR  a : BOOL;  i : INT;  n, m : DINT;  r : REAL;  t : TIME;  s : STRING;  w : WORD;  bits : ARRAY[1..4] OF BOOL;  END_VAR
+--[ ]( a )--[ADD]( n, i, m, 16#FF )--[SUB]( n, n, m, 1 )--[DIV]( r, r, 2 )--+
+--[CALC]( r, (r + 1) * i - r / 3 )--[LIMIT]( n, 0, m, 99 )--[SEL]( n, a, 1, m )--+
+--[MUL]( t, t, 2 )--[ADD]( t, t, 5s )--[TYP]( i, r )--[NEG]( n, m )--[NOT]( w, w )--+
+--[CONCAT]( s, s, 'a$'b' )--[LEN]( n, s )--[CALC]( a, n > 3 AND NOT a )--+
+--[UNPACK]( bits[1..4], w )--+
+--[TYP]( n, t )--+
",
        expect![[r#"
            3:1: approximated [DIV]( r, r, 2 ): what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it
            4:1: approximated [CALC]( r, (r + 1) * i - r / 3 ): what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it
            5:1: approximated [TYP]( i, r ): what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it
            8:1: approximated [TYP]( n, t ): what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it
            # plant #
            # ladder: cycle 10ms #

            VAR
                a    : BOOL;
                i    : INT;
                n    : DINT;
                m    : DINT;
                r    : REAL;
                t    : TIME;
                s    : STRING;
                w    : WORD;
                bits : ARRAY[1..4] OF BOOL;
            END_VAR

            +--[ ]( a )---------------------[ADD]( n, i, m, 255 )--[CALC]( n, n - m - 1 )--[DIV]( r, r, 2.0 )--+

            +---------------[CALC]( r, (r + 1.0) * i - r / 3.0 )--[LIMIT]( n, 0, m, 99 )--[SEL]( n, a, 1, m )--+

            +-----[MUL]( t, t, 2 )--[ADD]( t, t, T#5s )--[TYP]( i, r )--[CALC]( n, -m )--[XOR]( w, w, 65535 )--+

            +-------[CONCAT]( s, s, 'a$'b' )--[LEN]( n, s )--[CALC]( a, n > 3 AND NOT a )--+

            +------[MOV]( bits[1], w.0 )--[MOV]( bits[2], w.1 )--[MOV]( bits[3], w.2 )--[MOV]( bits[4], w.3 )--+

            +---------------------------------------------------------------[TYP]( n, t )--+
        "#]],
    );
}
