//! Programs as units of TwinCAT: what is written, what there is to say about it, and what is read of it again.

use expect_test::{Expect, expect, expect_file};
use ladder_format::Options;
use ladder_notation::{Notation, Outcome, Source, Writing, convert};
use ladder_notation_twincat::TwinCat;

fn written(text: &str) -> Writing {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
    assert!(errors.is_empty(), "{errors:?}");
    TwinCat.write(&analysis).expect("it has no errors")
}

/// The names of the files next to the program, the remarks, and the program that is read of all of them.
#[track_caller]
fn check(text: &str, expected: Expect) {
    let writing = written(text);
    let mut out = String::new();
    for file in &writing.companions {
        out.push_str(&format!("{}\n", file.name));
    }
    for entry in writing.report.remarks() {
        if let Outcome::Approximated(why) | Outcome::Refused(why) = &entry.outcome {
            out.push_str(&format!("{}: {}: {why}\n", entry.place, entry.element));
        }
    }
    let source = Source {
        companions: writing.companions,
        ..Source::alone("plant", &writing.bytes)
    };
    let again = convert(&TwinCat, &source, &Options::default()).expect("it is read again");
    for entry in again.report.remarks() {
        if let Outcome::Approximated(why) | Outcome::Refused(why) = &entry.outcome {
            out.push_str(&format!("read again: {}: {why}\n", entry.element));
        }
    }
    let text = again.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&text).into(), "plant.clad");
    out.push_str(&text);
    out.extend(
        analysis
            .errors()
            .map(|error| format!("error: {}\n", error.message)),
    );
    expected.assert_eq(&out);
}

fn file(writing: &Writing, name: &str) -> String {
    let file = writing.companions.iter().find(|file| file.name == name);
    String::from_utf8(file.expect("there is such a file").bytes.to_vec()).expect("it is UTF-8")
}

#[test]
fn the_file_of_a_rung() {
    let writing = written(
        "VAR  start, halt, run : BOOL;  END_VAR\n+--\\--[ ]( start )--\\--[/]( halt )--( )( run )--+\n|  /--[ ]( run )----/                           |\n",
    );
    let text = String::from_utf8(writing.bytes).expect("it is UTF-8");
    expect_file!["written/rung.TcPOU"].assert_eq(&text);
}

#[test]
fn declarations_of_types_globals_and_blocks() {
    let writing = written(
        r"
TYPE
    Phase : (IDLE, FILLING := 10);
    Pump  : STRUCT
        speed : REAL := 50.0;  # rpm #
        on    : BOOL;
    END_STRUCT;
END_TYPE
VAR_GLOBAL  limit : INT := 80;  END_VAR
VAR  pumps : ARRAY[1..2] OF Pump;  step : Phase := FILLING;  m : $Motor;  q AT %QX0.1 : BOOL;  END_VAR
# Runs a motor #
FUNCTION_BLOCK [$Motor]
VAR_INPUT  start : BOOL;  END_VAR
VAR_OUTPUT  run : BOOL;  END_VAR
+--[ ]( start )--( )( run )--+
END_FUNCTION_BLOCK
+--[EQ]( step, FILLING )--[$Motor]( m, start := pumps[1].on )--[LT]( limit, 90 )--( )( q )--+
",
    );
    let mut out = String::new();
    for name in ["Phase.TcDUT", "Pump.TcDUT", "GVL_plant.TcGVL", "Motor.TcPOU"] {
        let text = file(&writing, name);
        let end = text.find("]]>").unwrap_or(text.len());
        let start = text.find("<Declaration>").unwrap_or_default();
        out.push_str(&text[start..end]);
        out.push('\n');
    }
    expect![[r#"
        <Declaration><![CDATA[TYPE Phase : (IDLE, FILLING := 10);
        END_TYPE

        <Declaration><![CDATA[TYPE Pump :
        STRUCT
        	speed : REAL := 50.0; // rpm
        	on_1 : BOOL;
        END_STRUCT
        END_TYPE

        <Declaration><![CDATA[VAR_GLOBAL
        	limit_1 : INT := 80;
        END_VAR

        <Declaration><![CDATA[// Runs a motor
        FUNCTION_BLOCK Motor
        VAR_INPUT
        	power_in : BOOL; // EN of the block in ladder text
        END_VAR
        VAR_OUTPUT
        	power_out : BOOL; // ENO of the block in ladder text
        END_VAR
        VAR_INPUT
        	start : BOOL;
        END_VAR
        VAR_OUTPUT
        	run : BOOL;
        END_VAR

    "#]]
    .assert_eq(&out);
}

#[test]
fn contacts_coils_and_branches() {
    check(
        r"
VAR  a, b, c, x, y, z : BOOL;  w : WORD;  END_VAR

# Seal-in #
+--\--[ ]( a )--\--[/]( b )--( )( x )--+
|  /--[ ]( x )--/                      |

+--[P]( a )--\--(S)( y )------------\--+
|            /--[ ]( c )--(/)( z )--/  |
+--[ ]( b )--(R)( y )--(P)( x )--+
+--[ ]( a )--\--[ ]( b )-----\--( )( y )--+
|            /--[/]( x )--\--/            |
+--[ ]( c )---------------/--[ ]( z )--( )( x )--+
+--[ ]( w.3 )--[/]( w.4 )--[NOT]--( )( x )--+
",
        expect![[r#"
            VAR
                a : BOOL;
                b : BOOL;
                c : BOOL;
                x : BOOL;
                y : BOOL;
                z : BOOL;
                w : WORD;
            END_VAR

            # Seal-in #
            +--\--[ ]( a )--\--[/]( b )------------------------------------------( )( x )--+
            |  /--[ ]( x )--/                                                              |

            +--[P]( a )--\----------------------------------------------------(S)( y )--\--+
            |            /--[ ]( c )------------------------------------------(/)( z )--/  |

            +--[ ]( b )--\----------------------------------------------------(R)( y )--\--+
            |            /--[OSR]---------------------------------------------( )( x )--/  |

            +--\--[ ]( a )--\--[ ]( b )--\-----\---------------------------------( )( y )--+
            |  /--\         /--[/]( x )--/  \--/                                           |
            |     /--[ ]( c )---------------/                                              |

            +--\--[ ]( a )--[/]( x )--\--[ ]( z )--------------------------------( )( x )--+
            |  /--[ ]( c )------------/                                                    |

            +--[ ]( w.3 )--[/]( w.4 )--[NOT]-------------------------------------( )( x )--+
        "#]],
    );
}

#[test]
fn timers_counters_and_values() {
    check(
        r"
VAR  a, b, y : BOOL;  n, m : DINT;  i : INT;  s : STRING;  t : TON;  c : CTU;  d : CTD;  u : CTUD;  r : RTO;  f : SR;  p : TIME;  END_VAR

+--[ ]( a )--[TON]( t, T#5s )--\--( )( y )----------------\--+
|                              /--[ ]( b )--[MOV]( n, 3 )--/  |
+--[ ]( a )--[CTU]( c, 3, R := b )--[CTD]( d, n )--[CTUD]( u, 5, CD := b )--(S)( y )--+
+--[ ]( a )--[RTO]( r, T#1s, R := b )--[SR]( f, R := a )--( )( y )--+
+--[ ]( a )--[ADD]( n, n, 1 )--[CALC]( m, n * 2 + i )--[LEN]( n, s )--+
+--[GE]( n, 3 )--[TYP]( i, n )--[MOV]( p, T#3s )--[ADD]( p, p, T#1s )--+
+--[ ]( SYS.CLOCK_1S )--( )( y )--+
",
        expect![[r#"
            LADDER_CLOCK.TcPOU
            LADDER_RTO.TcPOU
            CTU_DINT.TcPOU
            CTD_DINT.TcPOU
            CTUD_DINT.TcPOU
            LADDER_SYS.TcPOU
            GVL_plant.TcGVL
            9:1: [TYP]( i, n ): what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it
            VAR
                a : BOOL;
                b : BOOL;
                y : BOOL;
                n : DINT;
                m : DINT;
                i : INT;
                s : STRING;
                t : TON;
                c : CTU;
                d : CTD;
                u : CTUD;
                r : RTO;
                f : SR;
                p : TIME;
            END_VAR

            +--[ ]( a )--[TON]( t, T#5s )--\----------------------------------( )( y )--\--+
            |                              /--[ ]( b )-------------------[MOV]( n, 3 )--/  |

            +--[ ]( a )---------------[CTU]( c, 3, R := b )--[CTD]( d, n )--[CTUD]( u, 5, CD := b )--(S)( y )--+

            +--[ ]( a )-------------[RTO]( r, T#1s, R := b )--[SR]( f, R := a )--( )( y )--+

            +--[ ]( a )-----------[ADD]( n, n, 1 )--[CALC]( m, n * 2 + i )--[LEN]( n, s )--+

            +--[GE]( n, 3 )----------[TYP]( i, n )--[MOV]( p, T#3s )--[ADD]( p, p, T#1s )--+

            +--[ ]( SYS.CLOCK_1S )-----------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn jumps_returns_and_loops() {
    check(
        r"
VAR  a, b, y : BOOL;  n : DINT;  END_VAR

+--[ ]( a )--<JMP>( over )--+
+--[ ]( b )--( )( y )--+
+--<LBL>( over )--[ ]( b )--<RET>--+
+--<FOR>( 3, I => n )--+
+--[ ]( a )--( )( y )--+
+--<NEXT>--+
",
        expect![[r#"
            VAR
                a : BOOL;
                b : BOOL;
                y : BOOL;
                n : DINT;
            END_VAR

            +--[ ]( a )-----------------------------------------------------<JMP>( over )--+

            +--[ ]( b )----------------------------------------------------------( )( y )--+

            +--<LBL>( over )---------------------------------------------------------------+

            +--[ ]( b )-------------------------------------------------------------<RET>--+

            +----------------------------------------------------------<FOR>( 3, I => n )--+

            +--[ ]( a )----------------------------------------------------------( )( y )--+

            +----------------------------------------------------------------------<NEXT>--+
        "#]],
    );
}

#[test]
fn blocks_functions_and_structures() {
    check(
        r"
TYPE
    Phase : (IDLE, FILLING);
    Pump  : STRUCT
        on    : BOOL;
        delay : TON;
        step  : Phase := FILLING;
    END_STRUCT;
END_TYPE
VAR  pumps : ARRAY[1..2] OF Pump := [2((step := FILLING))];  k : INT := 1;  step : Phase;  y : BOOL;  d : DINT;  m : $Motor;  END_VAR

# Guarded #
FUNCTION_BLOCK [$Motor]
VAR_IN_OUT  pump : Pump;  END_VAR
VAR_INPUT  start : BOOL;  END_VAR
VAR_OUTPUT  count : INT;  END_VAR
+--[/]( EN )--<RET>--+
+--[ ]( start )--[TON]( pump.delay, T#1s )--( )( pump.on )--[ADD]( count, count, 1 )--+
END_FUNCTION_BLOCK

+--[EQ]( step, FILLING )--[$Motor]( m, pump := pumps[k], start := y, count => d )--( )( y )--+
+--[ ]( y )--<CALL>( Stop )--+
+--<FUN>( Stop )--+
+--[MOV]( step, IDLE )--[TON]( pumps[2].delay, T#2s )--(R)( pumps[1].on )--+
",
        expect![[r#"
            Motor.TcPOU
            Stop.TcPOU
            Phase.TcDUT
            Pump.TcDUT
            TYPE
                Phase : (IDLE, FILLING);
                Pump  : STRUCT
                    on_1   : BOOL;
                    delay  : TON;
                    step_1 : Phase := FILLING;
                END_STRUCT;
            END_TYPE

            # Guarded #
            FUNCTION_BLOCK [$Motor]
            VAR_IN_OUT
                pump_2 : Pump;
            END_VAR
            VAR_INPUT
                start : BOOL := FALSE;
            END_VAR
            VAR_OUTPUT
                count : INT;
            END_VAR

            +--[/]( EN )------------------------------------------------------------<RET>--+

            +--[ ]( start )---[TON]( pump_2.delay, T#1s )--\--------( )( pump_2.on_1 )--\--+
            |                                              /--[ADD]( count, count, 1 )--/  |
            END_FUNCTION_BLOCK

            VAR
                pumps  : ARRAY[1..2] OF Pump := [2((step_1 := FILLING))];
                k      : INT                 := 1;
                step_1 : Phase;
                y      : BOOL;
                d      : DINT;
                m      : $Motor;
                power  : BOOL;  # the power after a block #
            END_VAR

            +--[EQ]( step_1, Phase.FILLING )------[$Motor]( m, pump_2 := pumps[k], start := y )--( )( power )--+

            +---------------------------------------------------------[TYP]( d, m.count )--+

            +--[ ]( power )------------------------------------------------------( )( y )--+

            +--[ ]( y )----------------------------------------------------<CALL>( Stop )--+

            +--<FUN>( Stop )---------------------------------------------------------------+

            +----------------[MOV]( step_1, Phase.IDLE )--[TON]( pumps[2].delay, T#2s )--(R)( pumps[1].on_1 )--+
        "#]],
    );
}

#[test]
fn long_rungs() {
    let written_of = |elements: &str, times: usize| {
        let text = format!(
            "VAR  a, y : BOOL;  n : DINT;  END_VAR\n+--{}( )( y )--+\n",
            elements.repeat(times)
        );
        let remarks = written(&text).report;
        remarks
            .remarks()
            .map(|entry| format!("{:?}", entry.outcome))
            .collect::<Vec<_>>()
    };
    assert_eq!(written_of("[ ]( a )--", 900), [""; 0]);
    assert_eq!(written_of("[MOV]( n, 3 )--", 300), [""; 0]);
    let why = "Refused(\"more than 90 boxes are one in the other\")";
    assert_eq!(written_of("[NOT]--", 900), [why]);
}

#[test]
fn what_is_not_written_stays_as_a_comment() {
    check(
        r"
VAR  a, y : BOOL;  t : TON;  c : CTU;  END_VAR

+--[ ]( a )--<JMP>( on )--+
+--<LBL>( on )--(RES)( t )--+
# The last #
+--[ ]( a )--[TON]( t, 5s )--[CTU]( c, 3 )--( )( y )--+
",
        expect![[r#"
            CTU_DINT.TcPOU
            5:1: network: the standard has no (RES)
            VAR
                a : BOOL;
                y : BOOL;
                t : TON;
                c : CTU;
            END_VAR

            +--[ ]( a )-----------------------------------------------------<JMP>( on_1 )--+

            # Not written, because the standard has no (RES): #
            # +--<LBL>( on )--(RES)( t )--+ #
            +--<LBL>( on_1 )---------------------------------------------------------------+

            # The last #
            +--[ ]( a )-------------------------[TON]( t, T#5s )--[CTU]( c, 3 )--( )( y )--+
        "#]],
    );
}
