//! Networks in SCL.

use super::{read, remarks};
use expect_test::{Expect, expect};
use ladder_notation::Companion;

/// What an organization block with these statements becomes, next to these files.
fn check(statements: &str, files: &[(&str, &str)], expected: &Expect) {
    let text = format!(
        "ORGANIZATION_BLOCK \"Main\"\n    VAR_TEMP\n        i : Int;\n        run : Bool;\n    END_VAR\n    {{ S7_Language := \"SCL\" }}\n    NETWORK\n{statements}\n    END_NETWORK\nEND_ORGANIZATION_BLOCK\n"
    );
    let companions = files.iter().map(|(name, text)| Companion {
        name: format!("{name}.s7dcl"),
        bytes: (*text).to_owned().into(),
    });
    let converted = read(&text, companions.collect());
    let text = format!("\n{}", converted.written.text);
    let (_, networks) = text.split_once("\nVAR\n").expect("variables");
    expected.assert_eq(&format!("{networks}\n{}", remarks(&converted)));
}

/// `#run` and `"run"` are two tags.
#[test]
fn names_of_the_project_and_of_the_block() {
    check(
        "(* a pipe of 5\" *) #run := \"run\" AND NOT #run; \"Level\" := 5; \"Data\".lamp := \"Level\" > \"Data\".limit; IF \"AlwaysTRUE\" THEN \"Speed\" := 1.5; END_IF;",
        &[],
        &expect![[r#"
                i   : INT;
                run : BOOL;
            END_VAR
            VAR_GLOBAL
                Data_lamp  : BOOL;  # Data.lamp in the project #
                Data_limit : INT;  # Data.limit in the project #
                Level      : INT;
                run_2      : BOOL;  # run in the project #
                Speed      : REAL;
            END_VAR

            # a pipe of 5" #
            # run := "run" AND NOT run #
            +--[ ]( run_2 )--[/]( run )----------------------------------------( )( run )--+
            +-----------------------------------------------------------[MOV]( Level, 5 )--+
            +--[GT]( Level, Data_limit )---------------------------------( )( Data_lamp )--+

            # IF "AlwaysTRUE" THEN "Speed" := 1.5; END_IF #
            +--[ ]( SYS.ON )------------------------------------------[MOV]( Speed, 1.5 )--+

            1:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
            1:1: approximated: tag Data.lamp: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Data.limit: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Level: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag run: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Speed: another file of the project declares it: its type is the one that its place asks for
            3:9: approximated: variable i: it keeps its value from one scan to the next here
            4:9: approximated: variable run: it keeps its value from one scan to the next here
        "#]],
    );
}

#[test]
fn labels_are_of_the_whole_block() {
    let network = "IF #run THEN #i := 1; ELSE #i := 2; END_IF;";
    let second =
        format!("{network}\n    END_NETWORK\n    {{ S7_Language := \"SCL\" }}\n    NETWORK\n{network}");
    check(
        &second,
        &[],
        &expect![[r#"
            i   : INT;
            run : BOOL;
        END_VAR

        # IF run THEN #
        +--[ ]( run )----------------------------------[MOV]( i, 1 )--<JMP>( endif1 )--+

        # ELSE #
        +---------------------------------------------------------------[MOV]( i, 2 )--+
        +--<LBL>( endif1 )-------------------------------------------------------------+

        # IF run THEN #
        +--[ ]( run )----------------------------------[MOV]( i, 1 )--<JMP>( endif2 )--+

        # ELSE #
        +---------------------------------------------------------------[MOV]( i, 2 )--+
        +--<LBL>( endif2 )-------------------------------------------------------------+

        1:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
        3:9: approximated: variable i: it keeps its value from one scan to the next here
        4:9: approximated: variable run: it keeps its value from one scan to the next here
    "#]],
    );
}

#[test]
fn blocks_functions_and_timers_of_the_project() {
    let block = "FUNCTION_BLOCK \"Fan\"\n    VAR_INPUT\n        go : Bool;\n    END_VAR\n    VAR_OUTPUT\n        on : Bool;\n    END_VAR\n    { S7_Language := \"SCL\" }\n    NETWORK\n        IF NOT #go THEN RETURN; END_IF;\n        #on := #go;\n    END_NETWORK\nEND_FUNCTION_BLOCK\n";
    let function = "FUNCTION \"Half\" : Real\n    VAR_INPUT\n        of : Real;\n    END_VAR\n    { S7_Language := \"SCL\" }\n    NETWORK\n        #Half := #of / 2.0;\n    END_NETWORK\nEND_FUNCTION\n";
    let data = "DATA_BLOCK \"Fan_DB\"\n    \"Fan\"\nEND_DATA_BLOCK\n";
    check(
        "\"Fan_DB\"(go := \"Go\", on => #run); \"Y\" := \"Half\"(of := 3.0) + 1.0; \"Delay\".TON(IN := \"Fan_DB\".on, PT := T#1s); \"Lamp\" := \"Delay\".Q;",
        &[("Fan", block), ("Half", function), ("Fan_DB", data)],
        &expect![[r#"
                i   : INT;
                run : BOOL;
                st1 : REAL;
            END_VAR
            VAR_GLOBAL
                Delay  : TON;
                Fan_DB : $Fan;
                Go     : BOOL;
                Lamp   : BOOL;
                Y      : REAL;
            END_VAR

            +---------------------------------------[$Fan]( Fan_DB, go := Go, on => run )--+

            # "Y" := "Half"(of := 3.0) + 1.0 #
            +------------------[$Half]( _of := 3.0, Half => st1 )--[CALC]( Y, st1 + 1.0 )--+
            +--[ ]( Fan_DB.on )--------------------------------------[TON]( Delay, T#1s )--+
            +--[ ]( Delay.Q )-------------------------------------------------( )( Lamp )--+

            1:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
            1:1: approximated: tag Delay: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Go: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Lamp: another file of the project declares it: its type is the one that its place asks for
            1:1: approximated: tag Y: another file of the project declares it: its type is the one that its place asks for
            3:9: approximated: variable i: it keeps its value from one scan to the next here
            4:9: approximated: variable run: it keeps its value from one scan to the next here
        "#]],
    );
}

#[test]
fn functions_of_the_controller() {
    check(
        "\"A\" := NORM_X(MIN := 0, VALUE := #i, MAX := 27648); #i := SCALE_X(MIN := 0, VALUE := \"A\", MAX := 100); #i := CEIL(\"A\"); #i := FLOOR(\"A\");",
        &[],
        &expect![[r#"
                i   : INT;
                run : BOOL;
                st1 : REAL;
                st2 : LINT;
                st3 : DINT;
                st5 : BOOL;
                st6 : DINT;
                st7 : DINT;
            END_VAR
            VAR_GLOBAL
                A : REAL;
            END_VAR

            # "A" := NORM_X(MIN := 0, VALUE := i, MAX := 27648) #
            +-----------------------[TYP]( st1, i )--[CALC]( A, (st1 - 0) / (27648 - 0) )--+

            # i := SCALE_X(MIN := 0, VALUE := "A", MAX := 100) #
            +-------[CALC]( st1, A * (100 - 0) + 0 )--[TYP]( st2, st1 )--[WRAP]( st3, st2 )--[WRAP]( i, st3 )--+

            # i := CEIL("A") #
            +-----[TRUNC]( st2, A )--[WRAP]( st3, st2 )--[TYP]( st1, st3 )--[CALC]( st5, st1 < A )--[CALC]( st6, st3 + 1 )--[SEL]( st7, st5, st3, st6 )--[WRAP]( i, st7 )--+

            # i := FLOOR("A") #
            +-----[TRUNC]( st2, A )--[WRAP]( st7, st2 )--[TYP]( st1, st7 )--[CALC]( st5, st1 > A )--[CALC]( st6, st7 - 1 )--[SEL]( st3, st5, st7, st6 )--[WRAP]( i, st3 )--+

            1:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
            1:1: approximated: tag A: another file of the project declares it: its type is the one that its place asks for
            3:9: approximated: variable i: it keeps its value from one scan to the next here
            4:9: approximated: variable run: it keeps its value from one scan to the next here
        "#]],
    );
}
