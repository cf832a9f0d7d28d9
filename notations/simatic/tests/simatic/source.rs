//! Sources in SCL.

use super::{read_with, remarks};
use expect_test::expect;
use ladder_notation_simatic::SimaticScl;

#[test]
fn several_blocks_of_which_the_organization_block_runs() {
    let text = "TYPE \"Drive\"\nVERSION : 0.1\n   STRUCT\n      run : Bool;   // runs\n   END_STRUCT;\nEND_TYPE\n
FUNCTION_BLOCK \"Belt\"\nTITLE = A belt\n{ S7_Optimized_Access := 'TRUE' }\nAUTHOR : me\nVERSION : 0.1\n//about it
   VAR_INPUT\n      start : Bool;\n      \"stop it\" : Bool;\n   END_VAR\n   VAR_OUTPUT\n      drive : \"Drive\";\n   END_VAR
   VAR\n      delay {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME;\n   END_VAR\n   VAR CONSTANT\n      TIME_ON : Time := T#2s;\n   END_VAR
BEGIN\n	REGION Run\n	    /* latch */\n	    IF #start AND NOT #\"stop it\" THEN\n	        #drive.run := TRUE;\n	    END_IF;\n	END_REGION\n	#delay(IN := #drive.run, PT := #TIME_ON);\nEND_FUNCTION_BLOCK\n
DATA_BLOCK \"Belt_DB\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nNON_RETAIN\n\"Belt\"\nBEGIN\nEND_DATA_BLOCK\n
ORGANIZATION_BLOCK \"Main\"\nTITLE = \"Main Program Sweep (Cycle)\"\nVERSION : 0.1\nBEGIN\n	\"Belt_DB\"(start := \"PB_Start\");\n	\"Light\" := \"Belt_DB\".drive.run;\nEND_ORGANIZATION_BLOCK\n";
    let converted = read_with(&SimaticScl, "plant", text, Vec::new());
    expect![[r#"
        # Main Program Sweep (Cycle) #

        TYPE
            Drive : STRUCT
                run : BOOL;  # runs #
            END_STRUCT;
        END_TYPE

        # A belt #
        FUNCTION_BLOCK [$Belt]
        VAR_INPUT
            start   : BOOL;
            stop_it : BOOL;  # stop it in the project #
        END_VAR
        VAR_OUTPUT
            drive : Drive;
        END_VAR
        VAR
            delay : TON;
        END_VAR
        VAR CONSTANT
            TIME_ON : TIME := T#2s;
        END_VAR

        +--[/]( EN )------------------------------------------------------------<RET>--+

        # Run #
        # latch #
        +--[ ]( start )--[/]( stop_it )------------------------------(S)( drive.run )--+
        +--[ ]( drive.run )-----------------------------------[TON]( delay, TIME_ON )--+
        END_FUNCTION_BLOCK

        VAR_GLOBAL
            Belt_DB  : $Belt;
            Light    : BOOL;
            PB_Start : BOOL;
        END_VAR

        +---------------------------------------[$Belt]( Belt_DB, start := PB_Start )--+
        +--[ ]( Belt_DB.drive.run )--------------------------------------( )( Light )--+

        1:1: approximated: tag Light: another file of the project declares it: its type is the one that its place asks for
        1:1: approximated: tag PB_Start: another file of the project declares it: its type is the one that its place asks for
        45:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
    "#]].assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}
