//! Types, blocks of one's own, and what a program does after another.

use super::check;
use expect_test::expect;
use ladder_analysis::{AnalyzeOptions, Exported, analyze, exports, link_files};
use ladder_notation::Notation;
use ladder_notation_plcopen::Plcopen;
use std::sync::Arc;

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
VAR  pump_1 : Pump := (speed := 2.0);  k : INT(1..3);  m1 : $Motor;  go, on : BOOL;  END_VAR

# It runs #
FUNCTION_BLOCK [$Motor]
VAR_INPUT   start : BOOL;  wait : TIME := T#1s;  END_VAR
VAR_OUTPUT  run : BOOL;  END_VAR
VAR_IN_OUT  speed : REAL;  END_VAR
VAR  t : TON;  END_VAR
+--[ ]( EN )--[ ]( start )--[TON]( t, wait )--( )( run )--( )( ENO )--+
+--[ ]( alarm )--[MOV]( speed, 0.0 )--+
END_FUNCTION_BLOCK

+--[EQ]( phase, Phase.RUN )--[$Motor]( m1, start := go, speed := pump_1.speed )--(M)( on )--+
+--[ ]( m1.run )--[$Motor]( go, 2s, on, pump_1.speed )--[MOV]( phase, DONE )--+
+--[GT]( pump_1.speed, 3.0 )--[ADD]( k, k, 1 )--[$Toggle]( )--( )( alarm )--+
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
                pump_1   : Pump := (speed := 2.0);
                k        : INT  := 1;
                m1       : $Motor;
                go       : BOOL;
                Motor_2  : $Motor;  # the state of a block #
                Toggle_2 : $Toggle;  # the state of a block #
                power    : BOOL;  # the power after a block #
            END_VAR

            +--[EQ]( phase_2, RUN )-----------[$Motor]( m1, start := go, speed := pump_1.speed )--( )( on_1 )--+

            +--[ ]( m1.run )------------------[$Motor]( Motor_2, start := go, wait := T#2s, speed := pump_1.speed )--( )( power )--+

            +--[ ]( Motor_2.run )---------------------------------------------( )( on_1 )--+

            +--[ ]( power )----------------------------------------[MOV]( phase_2, DONE )--+

            +--[GT]( pump_1.speed, 3.0 )----------------[ADD]( k, k, 1 )--[$Toggle]( Toggle_2 )--( )( alarm )--+
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
            5:1: refused network: the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around
            6:1: refused network: the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around
            7:1: refused network: the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around
            8:1: approximated <LBL>( out ): the generators of Beremiz and OpenPLC Editor up to 3 pass over jumps, labels and returns, and say nothing
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

            # Not written, because the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around: #
            # +--[ ]( a )--<FOR>( 3, I => k )--+ #
            # Not written, because the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around: #
            # +--[ ]( b )--( )( a )--+ #
            # Not written, because the standard has no loops of networks, and jumps cannot stand for this one: something jumps into it, or an <MCR> is around: #
            # +--<NEXT>--+ #
            +--<LBL>( out )----------------------------------------------------------------+

            +--[ ]( SYS.FIRST_SCAN )---------------------------------------------( )( b )--+

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
fn what_compilers_have_no_types_for() {
    check(
        r"
TYPE
    Row : ARRAY[0..2] OF INT;
    Box : STRUCT
        t : TON;
    END_STRUCT;
    Pump : STRUCT
        speed : REAL;
    END_STRUCT;
END_TYPE
VAR_GLOBAL  sums : ARRAY[0..1] OF INT;  END_VAR
VAR  rows : ARRAY[0..1] OF Row;  box_1 : Box;  t : ARRAY[1..2] OF TON;  list : ARRAY[0..1] OF INT;  grid : ARRAY[0..1, 0..1] OF INT;
     percent : INT(5..100);  s : STRING := 'öl';  w : WORD;  k : INT;  q : BOOL;  go, stop : ARRAY[0..2] OF INT;  END_VAR

FUNCTION_BLOCK [$Handed]
VAR_INPUT  pump : Pump;  END_VAR
END_FUNCTION_BLOCK

FUNCTION_BLOCK [$Sum]
VAR_IN_OUT  list : ARRAY[0..1] OF INT;  END_VAR
+--[ADD]( list[0], list[0], list[1] )--+
END_FUNCTION_BLOCK

+--[MOV]( rows[1, k], 3 )--[TON]( box_1.t, 1s )--+
+--[TON]( t[1], 1s )--( )( q )--+
+--[$Sum]( list )--[$Sum]( sums )--+
+--[MOV]( grid[1][0], grid[k, 1] )--[ADD]( percent, percent, 1 )--[CONCAT]( s, s, 'ä' )--+
+--[ ]( w.3 )--[/]( w.4 )--[MOV]( go, stop )--+
+--[ ]( w.3 )--[/]( w.4 )--( )( q )--+
+--( )( w.3 )--+
+--[AND]( k, k, 3 )--+
+--[EXP]( k, k, 3 )--+
",
        expect![[r#"
            4:5: refused type Box: compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part a tag of its own
            12:1: refused tag rows: compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part a tag of its own
            12:1: refused tag box_1: compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part a tag of its own
            12:1: refused tag t: compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part a tag of its own
            16:1: refused tag pump: compilers there hand no timer, counter, block or structure to a block: hand what is in it
            24:1: refused network: the type of `rows` has no counterpart
            25:1: refused network: the type of `t` has no counterpart
            28:1: refused network: whole arrays and structures are not written there: copy what is in them
            30:1: refused network: a bit of a number cannot be written there: use a BOOL
            31:1: refused network: what works on bits takes bit strings there: use BYTE, WORD, DWORD or LWORD
            32:1: refused network: powers are of real numbers there: use REAL or LREAL, or multiply
            # plant #
            # ladder: cycle 10ms #

            TYPE
                Row  : ARRAY[0..2] OF INT;
                Pump : STRUCT
                    speed : REAL;
                END_STRUCT;
            END_TYPE

            VAR_GLOBAL
                sums : ARRAY[0..1] OF INT;
            END_VAR

            FUNCTION_BLOCK [$Handed]

            +--[ ]( EN )-------------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK

            FUNCTION_BLOCK [$Sum]
            VAR_IN_OUT
                list : ARRAY[0..1] OF INT;
            END_VAR

            +--[ ]( EN )-------------------------------------------------------( )( ENO )--+

            +------------------------------------------[ADD]( list[0], list[0], list[1] )--+
            END_FUNCTION_BLOCK

            VAR
                list    : ARRAY[0..1] OF INT;
                grid    : ARRAY[0..1, 0..1] OF INT;
                percent : INT    := 5;
                s       : STRING := '$C3$B6l';
                w       : WORD;
                k       : INT;
                q       : BOOL;
                go      : ARRAY[0..2] OF INT;
                stop    : ARRAY[0..2] OF INT;
                Sum_2   : $Sum;  # the state of a block #
                Sum_3   : $Sum;  # the state of a block #
            END_VAR

            # Not written, because the type of `rows` has no counterpart: #
            # +--[MOV]( rows[1, k], 3 )--[TON]( box_1.t, 1s )--+ #
            # Not written, because the type of `t` has no counterpart: #
            # +--[TON]( t[1], 1s )--( )( q )--+ #
            +----------------[$Sum]( Sum_2, list := list )--[$Sum]( Sum_3, list := sums )--+

            +-------[MOV]( grid[1, 0], grid[k, 1] )--[ADD]( percent, percent, 1 )--[CONCAT]( s, s, '$C3$A4' )--+

            # Not written, because whole arrays and structures are not written there: copy what is in them: #
            # +--[ ]( w.3 )--[/]( w.4 )--[MOV]( go, stop )--+ #
            +--[ ]( w.3 )--[/]( w.4 )--------------------------------------------( )( q )--+

            # Not written, because a bit of a number cannot be written there: use a BOOL: #
            # +--( )( w.3 )--+ #
            # Not written, because what works on bits takes bit strings there: use BYTE, WORD, DWORD or LWORD: #
            # +--[AND]( k, k, 3 )--+ #
            # Not written, because powers are of real numbers there: use REAL or LREAL, or multiply: #
            # +--[EXP]( k, k, 3 )--+ #
        "#]],
    );
}

#[test]
fn globals_of_another_file_begin_as_they_do_there() {
    let program = "+--[GT]( level, 3 )--( )( lamps[1] )--+\n";
    let globals = "# All that the files of the plant share. #\nVAR_GLOBAL\n    level : DINT := 1234;\n    lamps : ARRAY[0..1] OF BOOL := [TRUE, FALSE];\nEND_VAR\n";
    let of = |text| Arc::new(ladder_syntax::parse(text));
    let shown = Exported::new(vec![
        Arc::new(exports(&of(program), "plant.clad")),
        Arc::new(exports(&of(globals), "globals.clad")),
    ]);
    let others = Arc::new(shown).others_of("plant.clad");
    let own = Arc::new(analyze(
        &of(program),
        AnalyzeOptions::new("plant.clad").among(&others),
    ));
    let linked = link_files(&own, &|_| Some(Arc::new(analyze(&of(globals), "globals.clad"))));
    let own = own.with_others(linked.expect("the program is whole"));
    let writing = Plcopen.write(&own).expect("it can be written");
    let xml = String::from_utf8(writing.bytes).expect("it is UTF-8");
    let values = xml.lines().filter(|line| line.contains("<simpleValue"));
    let values: Vec<&str> = values.map(str::trim).collect();
    expect![[r#"
        <simpleValue value="1234"/>
        <simpleValue value="TRUE"/>
        <simpleValue value="FALSE"/>"#]]
    .assert_eq(&values.join("\n"));
}
