//! What comes out: statements as a person writes them.

use expect_test::{Expect, expect};
use ladder_analysis::{AnalyzeOptions, Exported, analyze, exports, link_files};
use ladder_notation::Notation;
use ladder_notation_st::St;
use std::sync::Arc;

/// The whole text, or why there is none.
fn written(text: &str) -> Result<String, String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    match St.write(&analysis) {
        Ok(writing) => Ok(String::from_utf8(writing.bytes).expect("text is UTF-8")),
        Err(error) => Err(error.message),
    }
}

/// The body of the program, or why there is none.
#[track_caller]
fn check(text: &str, expected: Expect) {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let body = match St.write(&analysis) {
        Ok(writing) => {
            let text = String::from_utf8(writing.bytes).expect("text is UTF-8");
            let program = text.split_once("PROGRAM plant\n").expect("a program").1;
            program.split_once("END_PROGRAM").expect("its end").0.to_owned()
        }
        Err(error) => error.message,
    };
    expected.assert_eq(&body);
}

#[test]
fn the_order_of_evaluation_stays() {
    check(
        r"
# A bridge; q takes what a was before #
+--[ ]( a )--\--[ ]( b )-----\--( )( y )--+
|            /--[/]( x )--\--/            |
+--[ ]( c )---------------/--[ ]( d )--( )( z )--+
+--[ ]( a )--(R)( a )--( )( q )--+
+--\--[ ]( a )--\--[ ]( b )--( )( p )--(/)( r )--+
|  /--[ ]( c )--/                                |
",
        expect![[r#"
            VAR_INPUT
                b : BOOL;
                x : BOOL;
                c : BOOL;
                d : BOOL;
            END_VAR
            VAR_OUTPUT
                y : BOOL;
                z : BOOL;
                q : BOOL;
                p : BOOL;
                r : BOOL;
            END_VAR
            VAR
                a : BOOL;
            END_VAR
            VAR
                power1 : BOOL;
            END_VAR
                (* A bridge; q takes what a was before *)
                y := a AND b OR a AND NOT x OR c;
                z := (a AND NOT x OR c) AND d;
                power1 := a;
                IF a THEN
                    a := FALSE;
                END_IF;
                q := power1;
                p := (a OR c) AND b;
                r := NOT p;
        "#]],
    );
}

#[test]
fn what_may_be_a_fault_is_checked() {
    check(
        "VAR\n    a : ARRAY[1..3] OF INT;\n    k, n : INT;\nEND_VAR\n+--[DIV]( n, a[k], n )--( )( done )--+\n+--[ADD]( n, n, 1 )--[SHL]( n, n, 2 )--+\n",
        expect![[r#"
            VAR_OUTPUT
                done : BOOL;
            END_VAR
            VAR
                a : ARRAY[1..3] OF INT;
                k : INT;
                n : INT;
            END_VAR
            VAR
                power1 : BOOL;
            END_VAR
                power1 := FALSE;
                IF k >= 1 AND k <= 3 AND n <> 0 THEN
                    n := LINT_TO_INT(LADDER_DIV(INT_TO_LINT(a[k]), INT_TO_LINT(n)));
                    power1 := TRUE;
                END_IF;
                done := power1;
                n := n + 1;
                n := WORD_TO_INT(SHL(INT_TO_WORD(n), 2));
        "#]],
    );
}

#[test]
fn jumps_and_loops() {
    check(
        "VAR\n    i, sum : INT;\n    step : BOOL;\nEND_VAR\n+--[ ]( skip )--<JMP>( done )--+\n+--<FOR>( 3, I => i )--+\n+--[ADD]( sum, sum, i )--<NEXT>--+\n\
         +--<LBL>( done )--[P]( step )--( )( y )--+\n",
        expect![[r#"
            VAR_INPUT
                skip : BOOL;
            END_VAR
            VAR_OUTPUT
                y : BOOL;
            END_VAR
            VAR
                i : INT;
                sum : INT;
                step_tag : BOOL;  (* called step *)
            END_VAR
            VAR
                turns1 : DINT;
                to_done : BOOL;
                turn1 : DINT;
                step_rises : R_TRIG;
            END_VAR
                to_done := skip;
                turns1 := 0;
                IF NOT to_done THEN
                    turns1 := 3;
                END_IF;
                turn1 := 0;
                WHILE turn1 < turns1 DO
                    turn1 := turn1 + 1;
                    i := DINT_TO_INT(turn1);
                    IF NOT to_done THEN
                        sum := sum + i;
                    END_IF;
                END_WHILE;
                step_rises(CLK := step_tag);
                y := step_rises.Q;
        "#]],
    );
}

#[test]
fn what_cannot_be_said_is_refused_with_its_place() {
    check(
        "+--<LBL>( top )--[ ]( a )--<JMP>( top )--+\n",
        expect![
            "1:28: Structured Text cannot say this: a jump back, which Structured Text has no word for: use a loop"
        ],
    );
    check(
        "+--[ADC]( y, 1 )--( )( q )--+\n",
        expect![
            "1:4: Structured Text cannot say this: a port, which each system has in its own way: use tags at addresses"
        ],
    );
}

/// The first of several files, with the program that it makes with the others and the library.
#[track_caller]
fn check_files(files: &[(&str, &str)], expected: Expect) {
    let parsed = files
        .iter()
        .map(|(name, text)| (*name, Arc::new(ladder_syntax::parse(text))));
    let parsed: Vec<_> = parsed.collect();
    let summaries = parsed.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
    let exported = Arc::new(Exported::new(summaries.collect()));
    let analysis = |wanted: &str| {
        let (name, parse) = parsed.iter().find(|(name, _)| *name == wanted)?;
        Some(Arc::new(analyze(
            parse,
            AnalyzeOptions::new(name).among(&exported.others_of(name)),
        )))
    };
    let own = analysis(files[0].0).expect("the first file is one of them");
    let linked = link_files(&own, &analysis).expect("it is whole");
    let writing = St.write(&own.with_others(linked)).expect("it is written");
    let text = String::from_utf8(writing.bytes).expect("text is UTF-8");
    let heads = text.lines().filter(|line| line.starts_with("FUNCTION_BLOCK "));
    let own = text.split_once("PROGRAM plant\n").expect("a program").1;
    let heads: Vec<&str> = heads.collect();
    expected.assert_eq(&format!("{}\n{own}", heads.join("\n")));
}

#[test]
fn blocks_of_the_library_are_written_along() {
    check_files(
        &[("plant.clad", "+--[ ]( on )--[$Blink]( T#1s )--( )( lamp )--+\n")],
        expect![[r#"
            FUNCTION_BLOCK Interval_block
            FUNCTION_BLOCK Blink
            VAR_INPUT
                on_tag : BOOL;  (* called on *)
            END_VAR
            VAR_OUTPUT
                lamp : BOOL;
            END_VAR
            VAR
                blink1 : Blink;
            END_VAR
                blink1(power_in := on_tag, high := T#1s, low := T#500ms);
                lamp := blink1.power_out;
            END_PROGRAM
        "#]],
    );
}

#[test]
fn blocks_and_functions_of_other_files_are_written_along() {
    check_files(
        &[
            ("plant.clad", "+--[ ]( on )--[$Half]( x, y )--<CALL>( wash )--+\n"),
            (
                "other.clad",
                "FUNCTION_BLOCK [$Half]\nVAR_INPUT\n    x : DINT;\nEND_VAR\nVAR_OUTPUT\n    y : DINT;\nEND_VAR\n+--[DIV]( y, x, 2 )--+\nEND_FUNCTION_BLOCK\n\n\
                 VAR\n    count : DINT;\nEND_VAR\n+--<FUN>( wash )--[ADD]( count, count, 1 )--+\n",
            ),
        ],
        expect![[r#"
            FUNCTION_BLOCK Half
            FUNCTION_BLOCK wash
            VAR_INPUT
                on_tag : BOOL;  (* called on *)
                x : DINT;
            END_VAR
            VAR
                y : DINT;
            END_VAR
            VAR
                half1 : Half;
                do_wash : wash;
            END_VAR
                half1(power_in := on_tag, x := x);
                y := half1.y;
                IF half1.power_out THEN
                    do_wash();
                END_IF;
            END_PROGRAM

            CONFIGURATION config
            VAR_GLOBAL
                other_count : DINT;  (* called other.count *)
            END_VAR
            RESOURCE plc ON PLC
                TASK scan_task(INTERVAL := T#10ms, PRIORITY := 0);
                PROGRAM main_program WITH scan_task : plant;
            END_RESOURCE
            END_CONFIGURATION
        "#]],
    );
}

#[test]
fn an_array_in_an_array_has_a_type_with_a_name_and_indices_of_its_own() {
    let text = written(
        r"
TYPE
    Row : ARRAY[0..2] OF INT := [1, 2, 3];
    First : Item;
    Item : STRUCT
        n : INT;
        sheet : ARRAY[1..2] OF ARRAY[1..2, 1..2] OF BOOL;
    END_STRUCT;
END_TYPE
VAR
    rows : ARRAY[0..1, 5..5] OF Row;
    f : First;
    one : Row;
    k : INT;
    on : BOOL;
END_VAR
+--[ ]( f.sheet[2, 1, k] )--[MOV]( rows[1, 5, 2], f.n )--+
+--[ ]( on )--[MOV]( one[0], rows[1][5][k] )--+
+--[ ]( on )--[$Bump]( rows[0, 5] )--+

FUNCTION_BLOCK [$Bump]
VAR_IN_OUT
    line : Row;
END_VAR
+--[ADD]( line[1], line[1], 1 )--+
END_FUNCTION_BLOCK
",
    );
    let text = text.unwrap_or_else(|why| why);
    expect![[r#"
        (* The ladder program plant. *)

        TYPE
            Row : ARRAY[0..2] OF INT;
        END_TYPE

        TYPE
            Row_type : ARRAY[1..2, 1..2] OF BOOL;
        END_TYPE

        TYPE
            Item : STRUCT
                n : INT;
                sheet : ARRAY[1..2] OF Row_type;
            END_STRUCT;
        END_TYPE

        TYPE
            Row_0_TO_1 : ARRAY[0..1, 5..5] OF Row;
        END_TYPE

        FUNCTION_BLOCK Bump
        VAR_INPUT
            power_in : BOOL;
        END_VAR
        VAR_OUTPUT
            power_out : BOOL;
        END_VAR
        VAR_IN_OUT
            line : Row;
        END_VAR
            power_out := power_in;
            line[1] := line[1] + 1;
        END_FUNCTION_BLOCK

        PROGRAM plant
        VAR
            rows : Row_0_TO_1;
            f : Item;
            one : Row := [1, 2, 3];
            k : INT;
            on_tag : BOOL;  (* called on *)
        END_VAR
        VAR
            has_begun : BOOL;
            bump1 : Bump;
        END_VAR
        VAR
            power1 : BOOL;
        END_VAR
            IF NOT has_begun THEN
                has_begun := TRUE;
                rows[0, 5][0] := 1;
                rows[0, 5][1] := 2;
                rows[0, 5][2] := 3;
                rows[1, 5][0] := 1;
                rows[1, 5][1] := 2;
                rows[1, 5][2] := 3;
            END_IF;

            power1 := FALSE;
            IF k >= 1 AND k <= 2 THEN
                power1 := f.sheet[2][1, k];
            END_IF;
            IF power1 THEN
                rows[1, 5][2] := f.n;
            END_IF;
            IF on_tag AND k >= 0 AND k <= 2 THEN
                one[0] := rows[1, 5][k];
            END_IF;
            bump1(power_in := on_tag, line := rows[0, 5]);
        END_PROGRAM
    "#]]
    .assert_eq(&text);
}

/// Timers in arrays and structures, with a function that uses them too.
const ZONES: &str = "\
TYPE
    Zone : STRUCT
        hot   : BOOL;
        watch : TON;
    END_STRUCT;
END_TYPE
VAR CONSTANT  last : INT := 3;  END_VAR
VAR
    timers   : ARRAY[1..3] OF TON;  # delays #
    zone     : ARRAY[1..2] OF Zone;
    timers_2 : BOOL;
    a, y     : BOOL;
END_VAR
+--[ ]( a )--[TON]( timers[2], T#5s )--( )( timers_2 )--+
+--[ ]( a )--[TON]( timers[last], T#5s )--<CALL>( heat )--+
+--<FUN>( heat )--[ ]( timers[3].Q )--[TON]( zone[last - 1].watch, T#1s )--( )( zone[1].hot )--+
";

#[test]
fn timers_in_arrays_are_variables_where_their_index_is_known() {
    let text = written(ZONES).expect("it is written");
    expect![[r#"
        (* The ladder program plant. *)

        TYPE
            Zone_type : STRUCT
                hot : BOOL;
            END_STRUCT;
        END_TYPE

        TYPE
            Zone_type_1_TO_2 : ARRAY[1..2] OF Zone_type;
        END_TYPE

        FUNCTION_BLOCK heat
        VAR_IN_OUT
            zone : Zone_type_1_TO_2;
        END_VAR
        VAR_EXTERNAL
            timers_3 : TON;
            zone_2_watch : TON;
        END_VAR
            zone_2_watch(IN := timers_3.Q, PT := T#1s);
            zone[1].hot := zone_2_watch.Q;
        END_FUNCTION_BLOCK

        PROGRAM plant
        VAR
            timers_2_tag : TON;  (* called timers[2]; delays *)
            zone : Zone_type_1_TO_2;
            timers_2 : BOOL;
            a : BOOL;
            y : BOOL;
        END_VAR
        VAR CONSTANT
            last : INT := 3;
        END_VAR
        VAR
            do_heat : heat;
        END_VAR
        VAR_EXTERNAL
            timers_3 : TON;
        END_VAR
            timers_2_tag(IN := a, PT := T#5s);
            timers_2 := timers_2_tag.Q;
            timers_3(IN := a, PT := T#5s);
            IF timers_3.Q THEN
                do_heat(zone := zone);
            END_IF;
        END_PROGRAM

        CONFIGURATION config
        VAR_GLOBAL
            timers_3 : TON;  (* called timers[3]; delays *)
            zone_2_watch : TON;  (* called zone[2].watch *)
        END_VAR
        RESOURCE plc ON PLC
            TASK scan_task(INTERVAL := T#10ms, PRIORITY := 0);
            PROGRAM main_program WITH scan_task : plant;
        END_RESOURCE
        END_CONFIGURATION
    "#]]
    .assert_eq(&text);
    check(
        "VAR  t : ARRAY[1..3] OF TON;  k : INT;  END_VAR\n+--[ ]( a )--[TON]( t[k], T#5s )--( )( y )--+\n",
        expect![
            "2:14: Structured Text cannot say this: a timer, counter or block that a computed index chooses, as compilers that are built on matiec have no arrays of them: give each element a network with its index"
        ],
    );
    check(
        "VAR  t : ARRAY[1..3] OF TON;  k : INT;  END_VAR\n+--[ ]( a )--[TON]( t[1], T#5s )--( )( y )--+\n+--[ ]( t[k].Q )--( )( z )--+\n",
        expect![
            "3:4: Structured Text cannot say this: a timer, counter or block that a computed index chooses, as compilers that are built on matiec have no arrays of them: give each element a network with its index"
        ],
    );
    check(
        "\
TYPE
    Zone : STRUCT
        watch : TON;
    END_STRUCT;
END_TYPE
FUNCTION_BLOCK [$Heat]
VAR_IN_OUT  zone : Zone;  END_VAR
+--[ ]( EN )--[TON]( zone.watch, T#1s )--( )( ENO )--+
END_FUNCTION_BLOCK
VAR  zone : Zone;  END_VAR
+--[ ]( a )--[$Heat]( zone )--( )( y )--+
",
        expect![
            "7:13: Structured Text cannot say this: a parameter with timers, counters or blocks in it, which compilers that are built on matiec do not take: declare them in the block"
        ],
    );
}
