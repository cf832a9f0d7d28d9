//! What is written.

mod blocks;
mod callers;
mod exports;

use super::write;
use expect_test::{Expect, expect};

#[track_caller]
pub(super) fn check(text: &str, expected: Expect) {
    let writing = write(text).unwrap_or_else(|error| panic!("{error}"));
    let mut out = String::from_utf8_lossy(&writing.bytes).replace('\r', "");
    // What calls the program is the same for all: see `callers`.
    let is_caller = |name: &str| ["test_DB.", "test_Main."].iter().any(|own| name.starts_with(own));
    for companion in writing.companions.iter().filter(|file| !is_caller(&file.name)) {
        out.push_str(&format!(
            "== {}\n{}",
            companion.name,
            String::from_utf8_lossy(&companion.bytes).replace('\r', "")
        ));
    }
    for entry in writing.report.remarks() {
        out.push_str(&format!(
            "{} {}: {:?}\n",
            entry.place, entry.element, entry.outcome
        ));
    }
    expected.assert_eq(out.trim_start_matches('\u{feff}'));
}

#[test]
fn a_program_is_a_function_block() {
    check(
        "# Warm up #\n# and wait #\n\nVAR_INPUT\n    start, stop : BOOL;  # keys #\nEND_VAR\nVAR RETAIN\n    total : DINT := 7;\nEND_VAR\nVAR\n    warm : TON;\nEND_VAR\n\n\
         # Seal-in #\n+--\\--[ ]( start )--\\--[/]( stop )--[TON]( warm, 5s )--( )( run )--+\n|  /--[ ]( run )----/\n\n\
         +--[P]( run )--[ADD]( total, total, 1 )--+\n\n+--[GT]( warm.ACC, T#1.5s )--(S)( late )--+\n",
        expect![[r#"
            {
                S7_BlockComment := "MLC_4";
                S7_BlockTitle := "MLC_5";
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR_INPUT
                    { S7_MLC := "MLC_1" } "start" : Bool;
                    { S7_MLC := "MLC_2" } "stop" : Bool;
                END_VAR
                VAR_OUTPUT
                    "late" : Bool;
                END_VAR
                VAR
                    "warm" : TON_TIME;
                    "run" : Bool;
                    "edge_1" : Bool;
                END_VAR
                VAR RETAIN
                    "total" : DInt := 7;
                END_VAR

                {
                    S7_Language := "LAD";
                    S7_NetworkTitle := "MLC_3"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"start" )
                        wire#w1
                        I_Contact( #"stop" )
                        { S7_Templates := "time_type := Time" }
                        #"warm".TON( pt := T#5s, et => )
                        Coil( #"run" )
                    END_RUNG
                    RUNG wire#powerrail
                        Contact( #"run" )
                    END_RUNG wire#w1
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        P_Contact( operand := #"run", bit := #"edge_1" )
                        { S7_Templates := "SrcType := DInt" }
                        Add( in1 := #"total", in2 := 1, out => #"total" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        { S7_Templates := "SrcType := Time" }
                        GT_Contact( in1 := #"warm".ET, in2 := T#1500ms )
                        S_Coil( #"late" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == test.s7res
            ﻿MultiLingualTexts:
              - id: MLC_1
                en-US: "keys"
              - id: MLC_2
                en-US: "keys"
              - id: MLC_3
                en-US: "Seal-in"
              - id: MLC_4
                en-US: "and wait"
              - id: MLC_5
                en-US: "Warm up"
        "#]],
    );
}

#[test]
fn what_has_no_form_is_refused_with_its_place() {
    check(
        "VAR\n    a, b, y : BOOL;\n    c : CTC;\n    k : SR;\n    s : STRING[9];\nEND_VAR\n\n+--[ ]( a )--(S)( y )--( )( b )--+\n\n+--[NOT]--( )( y )--+\n\n+--[ ]( a )--<END>--+\n\n+--[ ]( a )--[CTC]( c, 4 )--( )( y )--+\n\n\
         +--[ ]( a )--\\--( )( b )--+\n|            /--<JMP>( on )--+\n\n+--<LBL>( on )--[ ]( b )--( )( y )--+\n\n+--[ ]( a )--[LEN]( y2, s )--+\n\n+--[ ]( a )--<RET>--+\n",
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
                    "s" : String[9];
                    "y2" : DInt;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[ ]( a )--(S)( y )--( )( b )--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[NOT]--( )( y )--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[ ]( a )--<END>--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[ ]( a )--[CTC]( c, 4 )--( )( y )--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"a" )
                        wire#w1
                        Coil( #"b" )
                    END_RUNG
                    RUNG wire#w1
                        JumpCoil( "on" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    Label( "on" )
                    RUNG wire#powerrail
                        Contact( #"b" )
                        Coil( #"y" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    // +--[ ]( a )--[LEN]( y2, s )--+
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"a" )
                        Return( )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            3:1 tag `c`: Refused("`c` cannot be declared: `CTC` has no form there")
            4:1 tag `k`: Refused("`k` cannot be declared: `SR` has no form there")
            8:1 network: Refused("after a set coil power goes on as it came there, and here it is the tag")
            10:1 network: Refused("a Not stands after a contact there")
            12:1 network: Refused("`<END>`: `[END]` has no counterpart")
            14:1 network: Refused("`[CTC]( c, 4 )`: `[CTC]` has no counterpart")
            21:1 network: Refused("`[LEN]( y2, s )`: `[LEN]` has no counterpart")
        "#]],
    );
}

#[test]
fn other_arithmetic_is_refused() {
    let why = write("# ladder: profile click #\n+--[ ]( X1 )--( )( Y1 )--+\n").err();
    expect!["the program counts and times as another controller does (`# ladder: profile .. #`), and a SIMATIC block does not: take the profile out, and see whether it still does what it should"].assert_eq(&why.unwrap_or_default());
}

#[test]
fn an_array_of_arrays_is_one_of_several_dimensions() {
    check(
        "TYPE\n    Row : ARRAY[0..2] OF INT;\n    Begun : ARRAY[0..2] OF INT := [1, 2, 3];\n    Other : Item;\n    Item : STRUCT\n        n : INT;\n    END_STRUCT;\nEND_TYPE\n\
         VAR\n    rows : ARRAY[0..1] OF Row;\n    begun : ARRAY[0..1] OF Begun;\n    deep : ARRAY[0..1, 0..1, 0..1] OF Row;\n    one : Begun;\n    f : Other;\n    k : INT;\nEND_VAR\n\
         +--[MOV]( rows[1][k], f.n )--+\n+--[MOV]( f.n, rows[0, one[1]] )--+\n",
        expect![[r#"
            {
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR
                    "rows" : Array[0..1, 0..2] of Int;
                    "begun" : Array[0..1, 0..2] of Int := [1, 2, 3, 1, 2, 3];
                    "one" : Array[0..2] of Int := [1, 2, 3];
                    "f" : "Item";
                    "k" : Int;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Move( in := #"f"."n", out1 => #"rows"[1, #"k"] )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Move( in := #"rows"[0, #"one"[1]], out1 => #"f"."n" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            == Item.s7dcl
            ﻿{
                S7_Version := "0.1"
            }
            TYPE "Item"
                STRUCT
                    "n" : Int;
                END_STRUCT;
            END_TYPE
            12:1 tag `deep`: Refused("`deep` cannot be declared: an array of more than 3 dimensions, those of the arrays in it included, has no form here")
        "#]],
    );
}

#[test]
fn values_of_an_enumeration_are_constants() {
    check(
        "TYPE\n    Phase : (IDLE, RUN := 5);\nEND_TYPE\nVAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR\n    step : Phase;\nEND_VAR\n\n\
         +--[ ]( go )--[EQ]( step, IDLE )--[MOV]( step, RUN )--+\n\n+--[NE]( step, Phase.RUN )--( )( waits )--+\n",
        expect![[r#"
            {
                S7_Optimized := "TRUE";
                S7_PreferredLanguage := "LAD";
                S7_Version := "0.1"
            }
            FUNCTION_BLOCK "test"
                VAR_INPUT
                    "go" : Bool;
                END_VAR
                VAR_OUTPUT
                    "waits" : Bool;
                END_VAR
                VAR
                    "step" : DInt := 0;
                END_VAR
                VAR CONSTANT
                    "Phase_IDLE" : DInt := 0;
                    "Phase_RUN" : DInt := 5;
                END_VAR

                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        Contact( #"go" )
                        { S7_Templates := "SrcType := DInt" }
                        EQ_Contact( in1 := #"step", in2 := #"Phase_IDLE" )
                        Move( in := #"Phase_RUN", out1 => #"step" )
                    END_RUNG
                END_NETWORK
                {
                    S7_Language := "LAD"
                }
                NETWORK
                    RUNG wire#powerrail
                        { S7_Templates := "SrcType := DInt" }
                        NE_Contact( in1 := #"step", in2 := #"Phase_RUN" )
                        Coil( #"waits" )
                    END_RUNG
                END_NETWORK
            END_FUNCTION_BLOCK
            8:1 tag `step`: Approximated("an enumeration is a DInt there, and its values are constants")
        "#]],
    );
}
