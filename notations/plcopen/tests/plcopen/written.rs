//! Programs as projects: what there is to say about it, and what is read of the project again.

use crate::harness;
use expect_test::{Expect, expect};
use ladder_notation::{Notation, Outcome};
use ladder_notation_plcopen::Plcopen;

fn xml(text: &str) -> (String, String) {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let writing = match Plcopen.write(&analysis) {
        Ok(writing) => writing,
        Err(error) => return (String::new(), format!("{error}\n")),
    };
    let mut said = String::new();
    for entry in writing.report.remarks() {
        match &entry.outcome {
            Outcome::Translated => {}
            Outcome::Approximated(why) => said.push_str(&format!(
                "{}: approximated {}: {why}\n",
                entry.place, entry.element
            )),
            Outcome::Refused(why) => {
                said.push_str(&format!("{}: refused {}: {why}\n", entry.place, entry.element));
            }
        }
    }
    (String::from_utf8(writing.bytes).expect("it is UTF-8"), said)
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    let (xml, said) = xml(text);
    let again = if xml.is_empty() {
        String::new()
    } else {
        harness::text(&xml)
    };
    expected.assert_eq(&(said + &again));
}

#[test]
fn a_whole_file() {
    let (xml, _) = xml(r"# A lamp #
VAR_INPUT  on : BOOL;  END_VAR
VAR_OUTPUT lamp AT %QX0.0 : BOOL;  END_VAR
VAR  t : TON;  END_VAR

# It waits #
+--[ ]( on )--[TON]( t, 2s )--( )( lamp )--+
");
    expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml">
          <fileHeader companyName="" productName="Unnamed" productVersion="0.1.0" creationDateTime="2000-01-01T00:00:00"/>
          <contentHeader name="plant">
            <coordinateInfo>
              <fbd>
                <scaling x="10" y="10"/>
              </fbd>
              <ld>
                <scaling x="10" y="10"/>
              </ld>
              <sfc>
                <scaling x="10" y="10"/>
              </sfc>
            </coordinateInfo>
          </contentHeader>
          <types>
            <dataTypes/>
            <pous>
              <pou name="plant" pouType="program">
                <interface>
                  <inputVars>
                    <variable name="on_1">
                      <type>
                        <BOOL/>
                      </type>
                    </variable>
                  </inputVars>
                  <outputVars>
                    <variable name="lamp" address="%QX0.0">
                      <type>
                        <BOOL/>
                      </type>
                    </variable>
                  </outputVars>
                  <localVars>
                    <variable name="t">
                      <type>
                        <derived name="TON"/>
                      </type>
                    </variable>
                  </localVars>
                </interface>
                <body>
                  <LD>
                    <comment localId="1" height="40" width="120">
                      <position x="20" y="20"/>
                      <content>
                        <xhtml:p>It waits</xhtml:p>
                      </content>
                    </comment>
                    <leftPowerRail localId="2" height="40" width="10">
                      <position x="10" y="80"/>
                      <connectionPointOut formalParameter="">
                        <relPosition x="10" y="20"/>
                      </connectionPointOut>
                    </leftPowerRail>
                    <contact localId="3" height="20" width="30">
                      <position x="60" y="90"/>
                      <connectionPointIn>
                        <relPosition x="0" y="10"/>
                        <connection refLocalId="2">
                          <position x="60" y="100"/>
                          <position x="20" y="100"/>
                        </connection>
                      </connectionPointIn>
                      <connectionPointOut>
                        <relPosition x="30" y="10"/>
                      </connectionPointOut>
                      <variable>on_1</variable>
                    </contact>
                    <inVariable localId="4" height="30" width="60">
                      <position x="130" y="115"/>
                      <connectionPointOut>
                        <relPosition x="60" y="15"/>
                      </connectionPointOut>
                      <expression>T#2s</expression>
                    </inVariable>
                    <block localId="5" typeName="TON" instanceName="t" height="70" width="60">
                      <position x="210" y="70"/>
                      <inputVariables>
                        <variable formalParameter="IN">
                          <connectionPointIn>
                            <relPosition x="0" y="30"/>
                            <connection refLocalId="3">
                              <position x="210" y="100"/>
                              <position x="90" y="100"/>
                            </connection>
                          </connectionPointIn>
                        </variable>
                        <variable formalParameter="PT">
                          <connectionPointIn>
                            <relPosition x="0" y="60"/>
                            <connection refLocalId="4">
                              <position x="210" y="130"/>
                              <position x="190" y="130"/>
                            </connection>
                          </connectionPointIn>
                        </variable>
                      </inputVariables>
                      <inOutVariables/>
                      <outputVariables>
                        <variable formalParameter="Q">
                          <connectionPointOut>
                            <relPosition x="60" y="30"/>
                          </connectionPointOut>
                        </variable>
                        <variable formalParameter="ET">
                          <connectionPointOut>
                            <relPosition x="60" y="60"/>
                          </connectionPointOut>
                        </variable>
                      </outputVariables>
                    </block>
                    <coil localId="6" height="20" width="30">
                      <position x="310" y="90"/>
                      <connectionPointIn>
                        <relPosition x="0" y="10"/>
                        <connection refLocalId="5" formalParameter="Q">
                          <position x="310" y="100"/>
                          <position x="270" y="100"/>
                        </connection>
                      </connectionPointIn>
                      <connectionPointOut>
                        <relPosition x="30" y="10"/>
                      </connectionPointOut>
                      <variable>lamp</variable>
                    </coil>
                    <rightPowerRail localId="7" height="40" width="10">
                      <position x="380" y="80"/>
                      <connectionPointIn>
                        <relPosition x="0" y="20"/>
                        <connection refLocalId="6">
                          <position x="380" y="100"/>
                          <position x="340" y="100"/>
                        </connection>
                      </connectionPointIn>
                    </rightPowerRail>
                  </LD>
                </body>
                <documentation>
                  <xhtml:p>A lamp</xhtml:p>
                </documentation>
              </pou>
            </pous>
          </types>
          <instances>
            <configurations>
              <configuration name="config">
                <resource name="resource1">
                  <task name="scan" priority="0" interval="T#10ms">
                    <pouInstance name="instance0" typeName="plant"/>
                  </task>
                </resource>
              </configuration>
            </configurations>
          </instances>
        </project>
    "#]].assert_eq(&xml);
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
            2:1: refused tag k: the standard has no RTO
            6:1: refused network: the standard has no [RTO]
            7:1: refused network: the type of `k` has no counterpart
            8:1: refused network: timers and counters there have no `TT`
            # plant #
            # ladder: cycle 10ms #

            VAR
                a : BOOL;
                r : BOOL;
                t : TON;
                c : CTU;
                d : CTUD;
            END_VAR

            +--[ ]( a )--[/]( r )-------------------------------------[TON]( t, T#500ms )--+

            +--[ ]( a )-------------------------------------------[CTU]( c, 5, R := t.Q )--+

            +--[ ]( a )--[CTUD]( d, 5, CD := r, LD := c.Q )--[GE]( d.CV, 3 )-----( )( r )--+

            # Not written, because the standard has no [RTO]: #
            # +--[ ]( a )--[RTO]( k, 5s )--+ #
            # Not written, because the type of `k` has no counterpart: #
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
            7:1: refused network: the standard has no [UNPACK]
            8:1: refused network: times, dates and names are converted otherwise there
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

            +--[ ]( a )-------------------[ADD]( n, i, m, 16#FF )--[CALC]( n, n - m - 1 )--[DIV]( r, r, 2.0 )--+

            +---------------[CALC]( r, (r + 1.0) * i - r / 3.0 )--[LIMIT]( n, 0, m, 99 )--[SEL]( n, a, 1, m )--+

            +------------[MUL]( t, t, 2 )--[ADD]( t, t, T#5s )--[TYP]( i, r )--[CALC]( n, -m )--[NOT]( w, w )--+

            +-------[CONCAT]( s, s, 'a$'b' )--[LEN]( n, s )--[CALC]( a, n > 3 AND NOT a )--+

            # Not written, because the standard has no [UNPACK]: #
            # +--[UNPACK]( bits[1..4], w )--+ #
            # Not written, because times, dates and names are converted otherwise there: #
            # +--[TYP]( n, t )--+ #
        "#]],
    );
}

#[test]
fn types_and_blocks() {
    check(
        r"
TYPE
    Phase : (IDLE, RUN := 5, DONE);
    Pump  : STRUCT
        speed : REAL := 1.5;  # rpm #
        ran   : ARRAY[1..3] OF TIME;
    END_STRUCT;
END_TYPE
VAR_GLOBAL  alarm : BOOL;  END_VAR
VAR RETAIN  phase : Phase := RUN;  END_VAR
VAR  pumps : ARRAY[1..2] OF Pump := [2((speed := 2.0))];  k : INT;  m1 : $Motor;  go, on : BOOL;  END_VAR

# It runs #
FUNCTION_BLOCK [$Motor]
VAR_INPUT   start : BOOL;  wait : TIME := T#1s;  END_VAR
VAR_OUTPUT  run : BOOL;  END_VAR
VAR_IN_OUT  speed : REAL;  END_VAR
VAR  t : TON;  END_VAR
+--[ ]( EN )--[ ]( start )--[TON]( t, wait )--( )( run )--( )( ENO )--+
+--[ ]( alarm )--[MOV]( speed, 0.0 )--+
END_FUNCTION_BLOCK

+--[EQ]( phase, Phase.RUN )--[$Motor]( m1, start := go, speed := pumps[k].speed )--(M)( on )--+
+--[ ]( m1.run )--[$Motor]( go, 2s, on, pumps[1].speed )--[MOV]( phase, DONE )--+
+--[GT]( pumps[k + 1].speed, 3.0 )--[$Toggle]( )--( )( alarm )--+
",
        expect![[r#"
            # plant #
            # ladder: cycle 10ms #

            TYPE
                Phase : (IDLE, RUN := 5, DONE);
                Pump  : STRUCT
                    speed : REAL := 1.5;
                    ran   : ARRAY[1..3] OF TIME;
                END_STRUCT;
            END_TYPE

            VAR_GLOBAL
                alarm : BOOL;
            END_VAR

            # It runs #
            FUNCTION_BLOCK [$Motor]
            VAR_INPUT
                start : BOOL := FALSE;
                wait  : TIME := T#1s;
            END_VAR
            VAR_OUTPUT
                run : BOOL;
            END_VAR
            VAR_IN_OUT
                speed : REAL;
            END_VAR
            VAR
                t : TON;
            END_VAR

            +--[ ]( EN )-------------------------------------------------------( )( ENO )--+

            +--[ ]( EN )--[ ]( start )-----------[TON]( t, wait )--( )( run )--( )( ENO )--+

            +--[ ]( alarm )-------------------------------------------[MOV]( speed, 0.0 )--+
            END_FUNCTION_BLOCK

            # A switch made of a push button: each time EN goes high, `q` changes. It begins low; EN that is high in the very first run #
            # counts as pressed. While `reset` is high `q` is low. The power that leaves the block is `q`. #
            FUNCTION_BLOCK [$Toggle]
            VAR_INPUT
                reset : BOOL := FALSE;  # switches off #
            END_VAR
            VAR_OUTPUT
                q : BOOL;  # switched on #
            END_VAR
            VAR
                pressed : BOOL;  # EN went high #
            END_VAR

            +--[ ]( EN )-------------------------------------------------------( )( ENO )--+

            +--[P]( EN )---------------------------------------------------( )( pressed )--+

            +--\--[ ]( pressed )--[/]( q )--\------------------------------------( )( q )--+
            |  /--[/]( pressed )--[ ]( q )--/                                              |

            +--[ ]( reset )------------------------------------------------------(R)( q )--+

            +--[ ]( q )--------------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK

            VAR RETAIN
                phase_2 : Phase := RUN;
                on_1    : BOOL;
            END_VAR
            VAR
                pumps    : ARRAY[1..2] OF Pump := [2((speed := 2.0))];
                k        : INT;
                m1       : $Motor;
                go       : BOOL;
                Motor_2  : $Motor;  # the state of a block #
                Toggle_2 : $Toggle;  # the state of a block #
                power    : BOOL;  # the power after a block #
            END_VAR

            +--[EQ]( phase_2, Phase.RUN )---[$Motor]( m1, start := go, speed := pumps[k].speed )--( )( on_1 )--+

            +--[ ]( m1.run )----------------[$Motor]( Motor_2, start := go, wait := T#2s, speed := pumps[1].speed )--( )( power )--+

            +--[ ]( Motor_2.run )---------------------------------------------( )( on_1 )--+

            +--[ ]( power )----------------------------------------[MOV]( phase_2, DONE )--+

            +--[GT]( pumps[k + 1].speed, 3.0 )--------[$Toggle]( Toggle_2 )--( )( alarm )--+
        "#]],
    );
}

#[test]
fn flow() {
    check(
        r"
VAR  a, b : BOOL;  k : DINT;  Step, Größe : BOOL;  END_VAR
+--[ ]( a )--<JMP>( out )--+
+--[ ]( Step )--( )( Größe )--+
+--[ ]( a )--<FOR>( 3, I => k )--+
+--[ ]( b )--( )( a )--+
+--<NEXT>--+
+--<LBL>( out )--[ ]( SYS.FIRST_SCAN )--( )( b )--+
+--[ ]( SYS.ON )--<RET>--+
+--[ ]( a )--<MCR>--+
+--[ ]( b )--( )( a )--+
",
        expect![[r#"
            3:1: approximated <JMP>( out ): the generators of Beremiz and OpenPLC Editor up to 3 pass over jumps, labels and returns, and say nothing
            5:1: refused network: the standard has no loops of networks
            6:1: refused network: the standard has no loops of networks
            7:1: refused network: the standard has no loops of networks
            8:1: refused network: the standard has no SYS.FIRST_SCAN
            9:1: approximated <RET>: the generators of Beremiz and OpenPLC Editor up to 3 pass over jumps, labels and returns, and say nothing
            10:1: refused network: the standard has no <MCR>, which this is or stands after
            11:1: refused network: the standard has no <MCR>, which this is or stands after
            # plant #
            # ladder: cycle 10ms #

            VAR
                a      : BOOL;
                b      : BOOL;
                k      : DINT;
                Step_1 : BOOL;
                Gr_e   : BOOL;
            END_VAR

            +--[ ]( a )------------------------------------------------------<JMP>( out )--+

            +--[ ]( Step_1 )--------------------------------------------------( )( Gr_e )--+

            # Not written, because the standard has no loops of networks: #
            # +--[ ]( a )--<FOR>( 3, I => k )--+ #
            # Not written, because the standard has no loops of networks: #
            # +--[ ]( b )--( )( a )--+ #
            # Not written, because the standard has no loops of networks: #
            # +--<NEXT>--+ #
            +--<LBL>( out )----------------------------------------------------------------+

            # Not written, because the standard has no SYS.FIRST_SCAN: #
            # +--<LBL>( out )--[ ]( SYS.FIRST_SCAN )--( )( b )--+ #
            +--[ ]( SYS.ON )--------------------------------------------------------<RET>--+

            # Not written, because the standard has no <MCR>, which this is or stands after: #
            # +--[ ]( a )--<MCR>--+ #
            # Not written, because the standard has no <MCR>, which this is or stands after: #
            # +--[ ]( b )--( )( a )--+ #
        "#]],
    );
}

#[test]
fn what_no_power_can_reach() {
    check(
        "+--[ ]( a )--( )( x )--+\n|--[ ]( b )--( )( y )--|\n",
        expect![[r#"
            2:1: refused network: no power can reach a block of it
            # plant #
            # ladder: cycle 10ms #

            VAR
                a : BOOL;
                x : BOOL;
                b : BOOL;
                y : BOOL;
            END_VAR

            +--[ ]( a )----------------------------------------------------------( )( x )--+

            # Not written, because no power can reach a block of it: #
            # |--[ ]( b )--( )( y )--| #
        "#]],
    );
    check(
        "+--[ ]( a )--( )( x +\n",
        expect![[r#"
        the program has errors: 1:17: `( x` is not closed: `)` is missing
    "#]],
    );
}

#[test]
fn each_array_has_its_own_list_of_indices() {
    let (xml, said) = xml(
        "TYPE\n    Row : ARRAY[0..2] OF INT;\n    Box : STRUCT\n        deep : ARRAY[0..1, 0..1] OF Row;\n    END_STRUCT;\n    Chest : Box;\nEND_TYPE\n\
         VAR\n    rows : ARRAY[0..1] OF Row;\n    c : Chest;\n    grid : ARRAY[0..1, 0..1] OF INT;\n    k : INT;\nEND_VAR\n\
         +--[MOV]( rows[1, k], c.deep[0][1][2] )--[MOV]( grid[1][0], grid[rows[0, 1], 1] )--+\n",
    );
    let paths = xml.lines().filter_map(|line| {
        line.trim()
            .strip_prefix("<expression>")?
            .strip_suffix("</expression>")
    });
    let paths: Vec<&str> = paths.filter(|path| path.contains('[')).collect();
    expect![[r#"
        c.deep[0, 1][2]
        rows[1][k]
        grid[rows[0][1], 1]
        grid[1, 0]"#]]
    .assert_eq(&format!("{said}{}", paths.join("\n")));
}
