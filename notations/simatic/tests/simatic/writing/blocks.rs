//! Blocks of one's own, of the library, and structures.

use super::check;
use crate::write;
use expect_test::expect;

#[test]
fn blocks_and_structures_are_documents_of_their_own() {
    check(
        "TYPE\n    Limits : STRUCT\n        low, high : INT := 5;\n    END_STRUCT;\nEND_TYPE\n\nFUNCTION_BLOCK [$Watch]\nVAR_INPUT\n    value : INT;\n    range : Limits;\nEND_VAR\nVAR_OUTPUT\n    bad : BOOL;\nEND_VAR\n\
         +--[/]( EN )--<RET>--+\n+--[LE]( range.low, value, range.high )--[NOT]--( )( bad )--+\nEND_FUNCTION_BLOCK\n\n\
         VAR\n    limits : Limits;\n    n : INT;\n    on, alarm : BOOL;\nEND_VAR\n+--[ ]( on )--[$Watch]( n, limits, alarm )--+\n",
        expect![[r#"
            {
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR
                    "limits" : "Limits";
                    "n" : Int;
                    "on" : Bool;
                    "alarm" : Bool;
                    "Watch_1" : "Watch";
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"on" )
                        #"Watch_1"( "value" := #"n", "range" := #"limits", "bad" => #"alarm" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == Limits.s7dcl
            ﻿{
                S7_Version := "0.1"
            }
            TYPE "Limits"
                STRUCT
                    "low" : Int := 5;
                    "high" : Int := 5;
                END_STRUCT;
            END_TYPE
            == Watch.s7dcl
            ﻿{
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "Watch"
                VAR_INPUT
                    "value" : Int;
                    "range" : "Limits";
                END_VAR
                VAR_OUTPUT
                    "bad" : Bool;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        { S7_Templates := "SrcType := Int" }
                        InRange( min := #"range"."low", in := #"value", max := #"range"."high" )
                        Not( )
                        Coil( #"bad" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn a_block_that_runs_without_power_is_called_without_a_condition() {
    check(
        "FUNCTION_BLOCK [$Count]\nVAR_OUTPUT\n    n : INT;\nEND_VAR\n+--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\nVAR\n    a : BOOL;\n    x : INT;\nEND_VAR\n\
         +--[$Count]( x )--+\n\n+--[ ]( a )--[$Count]( x )--+\n",
        expect![[r#"
            {
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR
                    "a" : Bool;
                    "x" : Int;
                    "Count_1" : "Count";
                    "power_1" : Bool;
                    "Count_2" : "Count";
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        #"Count_1"( "n" => #"x" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"a" )
                        Coil( #"power_1" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        #"Count_2"( "n" => #"x" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == Count.s7dcl
            ﻿{
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "Count"
                VAR_OUTPUT
                    "n" : Int;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        { S7_Templates := "SrcType := Int" }
                        Add( in1 := #"n", in2 := 1, out => #"n" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
        "#]],
    );
}

#[test]
fn a_block_that_knows_its_power_is_given_it() {
    check(
        "FUNCTION_BLOCK [$Hold]\nVAR_OUTPUT\n    q : BOOL;\nEND_VAR\n+--[ ]( EN )--(S)( q )--+\n+--[ ]( q )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\nVAR\n    a, b, y, z : BOOL;\nEND_VAR\n\
         # Held #\n+--[ ]( a )--[$Hold]( )--[/]( b )--( )( y )--+\n\n+--[$Hold]( y )--+\n\n+--\\--[ ]( a )--[$Hold]( )--\\--( )( y )--+\n|  /--[ ]( b )--------------/\n\n\
         +--[ ]( a )--\\--[$Hold]( )--( )( y )--+\n|            /--( )( z )--+\n\n\
         +--[ ]( b )--( )( z )--+\n+--[ ]( a )--[$Hold]( )--+\n+--[ ]( z )--( )( y )--+\n",
        expect![[r#"
            {
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR
                    "a" : Bool;
                    "b" : Bool;
                    "y" : Bool;
                    "z" : Bool;
                    "power_1" : Bool;
                    "power_2" : Bool;
                    "Hold_1" : "Hold";
                    "Hold_2" : "Hold";
                    "power_3" : Bool;
                    "Hold_3" : "Hold";
                END_VAR

                {
                    S7_Language := "LAD";
                    S7_NetworkTitle := "MLC_1"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"a" )
                        Coil( #"power_1" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        #"Hold_1"( "power_in" := #"power_1", "power_out" => #"power_2" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"power_2" )
                        I_Contact( #"b" )
                        Coil( #"y" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        #"Hold_2"( "power_in" := TRUE, "q" => #"y" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--\--[ ]( a )--[$Hold]( )--\--( )( y )--+
                    // |  /--[ ]( b )--------------/
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[ ]( a )--\--[$Hold]( )--( )( y )--+
                    // |            /--( )( z )--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"b" )
                        Coil( #"z" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"a" )
                        Coil( #"power_3" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        #"Hold_3"( "power_in" := #"power_3" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"z" )
                        Coil( #"y" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == Hold.s7dcl
            ﻿{
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "Hold"
                VAR_INPUT
                    "power_in" : Bool;
                END_VAR
                VAR_OUTPUT
                    "q" : Bool;
                    "power_out" : Bool;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"power_in" )
                        Coil( #"power_out" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"power_in" )
                        S_Coil( #"q" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"q" )
                        Coil( #"power_out" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == test.s7res
            ﻿MultiLingualTexts:
              - id: MLC_1
                en-US: "Held"
            17:1 network: Refused("power passes by the block, which is called from the rail there: draw it on a network of its own")
            20:1 network: Refused("power passes by the block, which is called from the rail there: draw it on a network of its own")
        "#]],
    );
}

/// Which blocks of the library can be written, and why the others cannot.
#[test]
fn blocks_of_the_library_are_function_blocks() {
    let mut out = String::new();
    for source in ladder_analysis::library::SOURCES {
        let writing = write(source.example).unwrap_or_else(|error| panic!("{error}"));
        let name = format!("{}.s7dcl", &source.name[1..]);
        let is_written = writing.companions.iter().any(|file| file.name == name);
        out.push_str(&format!("{}: {is_written}\n", source.name));
        for entry in writing.report.remarks() {
            out.push_str(&format!(
                "    {} {}: {:?}\n",
                entry.place, entry.element, entry.outcome
            ));
        }
    }
    expect![[r#"
        $Alarm: true
        $Alternate: true
        $Average: true
        $Blink: true
        $Debounce: true
        $Drum: true
        $FirstOut: true
        $Hysteresis: true
        $Interval: true
        $PID: true
        $Ramp: true
        $RunTime: true
        $Scale: true
        $Step: true
        $Toggle: true
        $Total: true
        $Amount: true
            8:24 [$Amount]: Approximated("the block counts scans and time only while it runs")
        $Belt: true
            11:22 [$Amount]: Approximated("the block counts scans and time only while it runs")
        $Cylinder: true
            11:27 [$Cylinder]: Approximated("the block counts scans and time only while it runs")
        $Heater: true
            10:25 [$Heater]: Approximated("the block counts scans and time only while it runs")
        $Motor: true
            11:24 [$Motor]: Approximated("the block counts scans and time only while it runs")
        $Noise: true
        $Tank: true
            10:36 [$Amount]: Approximated("the block counts scans and time only while it runs")
        $Valve: true
            10:21 [$Valve]: Approximated("the block counts scans and time only while it runs")
    "#]]
    .assert_eq(&out);
}
