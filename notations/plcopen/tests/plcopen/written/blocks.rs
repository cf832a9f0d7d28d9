//! Types, blocks of one's own, and what a program does after another.

use super::{check, xml};
use expect_test::expect;
use ladder_analysis::{Exported, analyze, analyze_in, exports, link_files};
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
    let own = Arc::new(analyze_in(&of(program), "plant.clad", &others));
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
