//! Programs of several files.

use crate::harness::Folder;
use expect_test::expect;

const MAIN: &str = "\
VAR_INPUT go : BOOL; END_VAR
VAR count : INT := 7; END_VAR
+--[ ]( go )--<CALL>( next )--[$Hold]( go, hold => count )--( )( alarm )--+
";

const LIBRARY: &str = "\
VAR_GLOBAL alarm, running : BOOL; END_VAR
VAR count : INT; unused : INT; zero : INT; END_VAR
+--[MOV]( unused, 1 )--+
+--<FUN>( next )--[ADD]( count, count, 1 )--[DIV]( count, count, zero )--+
+--[ ]( SYS.ON )--( )( running )--+
FUNCTION_BLOCK [$Hold]
VAR_INPUT a : BOOL; END_VAR
VAR_OUTPUT hold : INT; END_VAR
+--[ ]( a )--[P]( a )--[ADD]( hold, hold, 10 )--+
END_FUNCTION_BLOCK
";

#[test]
fn a_function_runs_with_the_tags_of_its_file_and_faults_lie_there() {
    let folder = Folder::with(&[("main.clad", MAIN), ("library.clad", LIBRARY)]);
    let sim = ["sim", "main.clad", "--scans", "3", "--set", "go=1"];
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,alarm,count,go,library.count,library.zero,running
        0,0,1,10,1,1,0,1
        1,10,1,10,1,2,0,1
        2,20,1,10,1,3,0,1
        -- stderr
        library.clad:4:45: fault in scan 0: division by zero: nothing was written; check the divisor before this block
        library.clad:4:45: fault in scan 1: division by zero: nothing was written; check the divisor before this block
        library.clad:4:45: fault in scan 2: division by zero: nothing was written; check the divisor before this block
    "#]].assert_eq(&folder.ladder(&sim).to_string());
}

#[test]
fn the_diagram_shows_each_file_under_its_name() {
    let folder = Folder::with(&[("main.clad", MAIN), ("library.clad", LIBRARY)]);
    let sim = [
        "sim",
        "main.clad",
        "--scans",
        "1",
        "--set",
        "go=1",
        "--format",
        "diagram",
    ];
    expect![[r#"
        VAR_INPUT go : BOOL; END_VAR
        VAR count : INT := 7; END_VAR
        +==[ ]( go )==<CALL>( next )==[$Hold]( go, hold => count )==( )( alarm )==+

        # library.clad #

        VAR_GLOBAL alarm, running : BOOL; END_VAR
        VAR count : INT; unused : INT; zero : INT; END_VAR
        +--[MOV]( unused, 1 )--+
        +==<FUN>( next )==[ADD]( count, count, 1 )==[DIV]( count, count, zero )--+
        +==[ ]( SYS.ON )==( )( running )==+
        FUNCTION_BLOCK [$Hold]
        VAR_INPUT a : BOOL; END_VAR
        VAR_OUTPUT hold : INT; END_VAR
        +==[ ]( a )==[P]( a )==[ADD]( hold, hold, 10 )==+
        END_FUNCTION_BLOCK
    "#]]
    .assert_eq(&folder.ladder(&sim).stdout);
}

#[test]
fn a_check_of_one_file_knows_the_others() {
    let folder = Folder::with(&[("main.clad", MAIN), ("library.clad", LIBRARY)]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "main.clad"]).to_string());
}

#[test]
fn related_places_in_other_files_are_shown() {
    let folder = Folder::with(&[
        ("ladder.toml", ""),
        ("a.clad", "+--<FUN>( f )--( )( z )--+\n"),
        ("lib/b.clad", "\n+--<FUN>( F )--( )( z )--+\n"),
        ("c.clad", "+--<CALL>( f )--+\n"),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        error[duplicate-function]: several files define the function `f`: which one is called here is open
         --> c.clad:1:12
          |
        1 | +--<CALL>( f )--+
          |            ^
          |
         ::: a.clad:1:11
          |
        1 | +--<FUN>( f )--( )( z )--+
          |           - it is defined here
          |
         ::: lib/b.clad:2:11
          |
        2 | +--<FUN>( F )--( )( z )--+
          |           - it is defined here
          |
          = help: rename all but one of them, or define the function in this file

        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&folder.ladder(&["check", "c.clad"]).to_string());
    expect![[r#"
        [
          {"file":"c.clad","rule":"duplicate-function","severity":"error","message":"several files define the function `f`: which one is called here is open","line":1,"column":12,"end_line":1,"end_column":13,"help":"rename all but one of them, or define the function in this file","related":[{"file":"a.clad","message":"it is defined here","line":1,"column":11,"end_line":1,"end_column":12},{"file":"lib/b.clad","message":"it is defined here","line":2,"column":11,"end_line":2,"end_column":12}]}
        ]
    "#]].assert_eq(&folder.ladder(&["check", "--format", "json", "c.clad"]).stdout);
}

#[test]
fn errors_in_a_file_that_is_used_keep_the_program_from_running() {
    let folder = Folder::with(&[
        ("main.clad", "+--<CALL>( f )--+\n"),
        ("lib.clad", "+--[TNO]( t, 3s )--+\n+--<FUN>( f )--( )( z )--+\n"),
        ("other.clad", "+--[TNO]( t, 3s )--+\n"),
    ]);
    expect![[r#"
        exit status 1
        -- stderr
        error[unknown-instruction]: there is no instruction [TNO]
         --> lib.clad:1:4
          |
        1 | +--[TNO]( t, 3s )--+
          |    ^^^^^
          |
          = help: did you mean [TON] (on-delay timer)?
        help: Replace with [TON]
          |
        1 - +--[TNO]( t, 3s )--+
        1 + +--------------------------------------------------------------[TON]( t, 3s )--+
          |

        error: main.clad: this program uses lib.clad; a program with errors is not run
    "#]]
    .assert_eq(&folder.ladder(&["sim", "main.clad", "--scans", "1"]).to_string());
}

#[test]
fn sub_folders_belong_to_it_only_with_settings_and_what_is_excluded_does_not() {
    let call = "+--<CALL>( f )--+\n";
    let function = "+--<FUN>( f )--( )( z )--+\n";
    let alone = Folder::with(&[("a.clad", call), ("sub/f.clad", function)]);
    let run = alone.ladder(&["check", "a.clad"]);
    assert!(run.stdout.contains("unknown-function"), "{run}");
    let with = Folder::with(&[("ladder.toml", ""), ("a.clad", call), ("sub/f.clad", function)]);
    let run = with.ladder(&["check", "a.clad"]);
    assert_eq!(run.status, Some(0), "{run}");
    let excluded = Folder::with(&[
        ("ladder.toml", "[workspace]\nexclude = [\"sub\"]\n"),
        ("a.clad", call),
        ("sub/f.clad", function),
    ]);
    let run = excluded.ladder(&["check", "a.clad"]);
    assert!(run.stdout.contains("unknown-function"), "{run}");
}

#[test]
fn c_has_what_the_program_uses_of_other_files_and_of_the_library() {
    let main = format!("{MAIN}+--[$Blink]( 1s, 1s, lamp )--+\n");
    let folder = Folder::with(&[("main.clad", &main), ("library.clad", LIBRARY)]);
    let run = folder.ladder(&["convert", "main.clad", "--to", "c", "-o", "plant.c"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(
        folder.read("plant.c").contains("FAULT_DIVISION"),
        "a function of the other file is in it"
    );
}

#[test]
fn a_file_is_used_of_which_other_parts_use_a_third() {
    let block = |name: &str| {
        format!(
            "FUNCTION_BLOCK [${name}]\nVAR_INPUT x : BOOL; END_VAR\n+--[ ]( x )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n"
        )
    };
    let second = block("Second") + "VAR t : $Third; END_VAR\n+--[$Third]( t, q )--( )( z )--+\n";
    let folder = Folder::with(&[
        ("third.clad", &block("Third")),
        ("second.clad", &second),
        (
            "main.clad",
            "VAR s : $Second; END_VAR\n+--[$Second]( s, r )--( )( y )--+\n",
        ),
    ]);
    let run = folder.ladder(&["sim", "main.clad", "--scans", "1", "--watch", "y"]);
    assert_eq!(
        run.to_string(),
        "exit status 0\n-- stdout\nscan,time_ms,y\n0,0,0\n"
    );
}
