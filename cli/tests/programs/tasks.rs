//! Projects whose tasks run their programs at rates of their own.

use crate::harness::Folder;
use expect_test::expect;

const SETTINGS: &str = r#"[[task]]
name = "slow"
interval = "50ms"
priority = 2
programs = ["count.clad"]

[[task]]
name = "fast"
interval = "20ms"
priority = 1
programs = ["main.clad", "lines/out.clad"]
"#;
const MAIN: &str = "\
VAR_INPUT
    start : BOOL;
END_VAR
VAR_GLOBAL
    run : BOOL;
    n   : INT;
END_VAR
VAR
    t : TON;
END_VAR

+--[ ]( start )--[TON]( t, 30ms )--( )( run )--+
";
const COUNT: &str = "\
VAR_GLOBAL
    run : BOOL;
    n   : INT;
END_VAR
VAR
    gap : TIME;
    k   : DINT;
END_VAR

+--[MOV]( gap, SYS.SCAN_TIME )--[MOV]( k, SYS.SCAN )--+
+--[/]( run )--<RET>--+
+--[ADD]( n, n, 1 )--+
";
const OUT: &str = "\
VAR_GLOBAL
    n : INT;
END_VAR
VAR_OUTPUT
    lamp : BOOL;
END_VAR

+--[GT]( n, 1 )--( )( lamp )--+
";

/// Without how long it took.
fn untimed(told: &str) -> String {
    told.rsplit_once(", in ")
        .map_or(told, |(told, _)| told)
        .to_owned()
}

fn project() -> Folder {
    Folder::with(&[
        ("ladder.toml", SETTINGS),
        ("main.clad", MAIN),
        ("count.clad", COUNT),
        ("lines/out.clad", OUT),
    ])
}

#[test]
fn each_program_runs_at_the_rate_of_its_task() {
    let folder = project();
    let run = folder.ladder(&["sim", "ladder.toml", "--scans", "18", "--set", "main.start=1"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,count.gap,count.k,fast_in,main.start,main.t.ET,main.t.Q,n,out.lamp,run,slow_in
        0,0,0,0,1,1,0,0,0,0,0,1
        1,10,0,0,0,1,0,0,0,0,0,2
        2,20,0,0,1,1,20,0,0,0,0,3
        3,30,0,0,0,1,20,0,0,0,0,4
        4,40,0,0,1,1,30,1,0,0,1,0
        5,50,50,1,0,1,30,1,1,0,1,1
        6,60,50,1,1,1,30,1,1,0,1,2
        7,70,50,1,0,1,30,1,1,0,1,3
        8,80,50,1,1,1,30,1,1,0,1,4
        9,90,50,1,0,1,30,1,1,0,1,0
        10,100,50,2,1,1,30,1,2,0,1,1
        11,110,50,2,0,1,30,1,2,0,1,2
        12,120,50,2,1,1,30,1,2,1,1,3
        13,130,50,2,0,1,30,1,2,1,1,4
        14,140,50,2,1,1,30,1,2,1,1,0
        15,150,50,3,0,1,30,1,3,1,1,1
        16,160,50,3,1,1,30,1,3,1,1,2
        17,170,50,3,0,1,30,1,3,1,1,3
    "#]]
    .assert_eq(&run.to_string());
    // A folder is its project; a program that is named alone runs at the rate of its task.
    let run = folder.ladder(&["sim", ".", "--scans", "2", "--watch", "n"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,n
        0,0,0
        1,10,0
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&["sim", "count.clad", "--scans", "2", "--watch", "k,gap"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,k,gap
        0,0,0,0
        1,50,1,50
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn what_runs_in_a_scan_is_drawn() {
    let folder = project();
    let run = folder.ladder(&["sim", ".", "--scans", "1", "--format", "diagram"]);
    let (plan, _) = run.stdout.split_once("# main.clad #").unwrap();
    expect![[r#"
        # ladder: cycle 10ms #

        VAR
            fast_in : DINT;  # how many scans it has waited #
            slow_in : DINT;  # how many scans it has waited #
        END_VAR

        # task fast: every 20ms #
        +==[EQ]( fast_in, 0 )===========================<CALL>( main )==<CALL>( out )==+

        +======================================[CALC]( fast_in, (fast_in + 1) MOD 2 )==+

        # task slow: every 50ms #
        +==[EQ]( slow_in, 0 )=========================================<CALL>( count )==+

        +======================================[CALC]( slow_in, (slow_in + 1) MOD 5 )==+

        # the main program of main.clad #
        +--<FUN>( main )---------------------------------------------------------------+

        # the main program of out.clad #
        +--<FUN>( out )----------------------------------------------------------------+

        # the main program of count.clad #
        +--<FUN>( count )--------------------------------------------------------------+

    "#]]
    .assert_eq(plan);
}

#[test]
fn scenarios_and_properties_of_a_project() {
    let folder = project();
    folder.write(
        "plant.ladder-test",
        b"program ladder.toml
step 50ms

scenario \"counts at its rate\"
main.start  -----
n        => 0 1 2 3 4
out.lamp => __---

property \"never many\" always n < 4
property \"the lamp may light\" possible out.lamp within 300ms
property \"no lamp at once\" never out.lamp and not main.start and n < 1
",
    );
    expect![[r#"
        exit status 1
        -- stdout
        plant.ladder-test
          FAIL  counts at its rate
                main.start  ---------
                n           0 1 2 3 4
                                    ^
                the property "never many" is violated in scan 20 (step 4, at 200ms); 5 scans violate it
                at plant.ladder-test:4:10
                3 properties watched; ladder prove plant.ladder-test decides them for all runs

        1 scenario in 1 file: 0 passed, 1 failed"#]]
    .assert_eq(&untimed(
        &folder.ladder(&["test", "plant.ladder-test"]).to_string(),
    ));
    let run = folder.ladder(&["prove", "plant.ladder-test"]);
    expect![[r#"
        plant.ladder-test
          violated    never many          in scan 20, at 200ms
                      main.start    - - - - - - - - - - - - - - - - - - - - -
                      n          => 0 0 0 0 0 1 1 1 1 1 2 2 2 2 2 3 3 3 3 3 4
          possible    the lamp may light  in scan 12, at 120ms
                      main.start    -------------
                      out.lamp   => ____________-
          unknown     no lamp at once     no such run in 200 scans
                      not decided: no induction excludes a longer run: an assumption may help

        3 properties in 1 file: 1 possible, 1 violated, 1 unknown"#]]
    .assert_eq(&untimed(&run.stdout));
    folder.write(
        "plant.ladder-test",
        b"program ladder.toml\ninterval 5ms\nstep 50ms\n\nscenario \"x\"\nn => 0\n",
    );
    expect![[r#"
        exit status 1
        -- stdout
        error[bad-scenario]: the tasks of a project say how often each program runs
         --> plant.ladder-test:2:10
          |
        2 | interval 5ms
          |          ^^^
          |
          = help: leave the line out

        0 scenarios in 1 file: 0 passed, 1 file not run for errors"#]]
    .assert_eq(&untimed(
        &folder.ladder(&["test", "plant.ladder-test"]).to_string(),
    ));
}

#[test]
fn what_cannot_run_says_why() {
    let folder = project();
    let told = |settings: &str| {
        folder.write("ladder.toml", settings.as_bytes());
        folder.ladder(&["sim", "ladder.toml", "--scans", "1"]).to_string()
    };
    expect![[r#"
        exit status 2
        -- stderr
        error: ladder.toml: there are no tasks to run: write [[task]] with `name`, `interval` and `programs`, or name a program
    "#]].assert_eq(&told("[simulate]\ninterval = \"5ms\"\n"));
    expect![[r#"
        exit status 2
        -- stderr
        error: ladder.toml:1:8: write [[task]] on a line of its own
    "#]]
    .assert_eq(&told("task = 5\n"));
    expect![[r#"
        exit status 2
        -- stderr
        error: ladder.toml:4:26: `gone.clad` cannot be used: no such file or folder
    "#]]
    .assert_eq(&told(
        "[[task]]\nname = \"a\"\ninterval = \"10ms\"\nprograms = [\"main.clad\", \"gone.clad\"]\n",
    ));
    expect![[r#"
        exit status 2
        -- stderr
        error: ladder.toml:4:13: `x.txt` is not a program: a task runs files that end in .clad or .st
        ladder.toml:4:22: `../main.clad` cannot be used: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
        ladder.toml:6:1: a task has `interval`, for example interval = "10ms"
        ladder.toml:13:13: the intervals of the tasks have no common scan of at least a microsecond, a millionth of the longest: round them
        ladder.toml:13:40: a task runs `main.clad` already: a program has one
        ladder.toml:15:1: there are two tasks `C`
    "#]].assert_eq(&told(
        "[[task]]\nname = \"a\"\ninterval = \"10ms\"\nprograms = [\"x.txt\", \"../main.clad\"]\n
[[task]]\nname = \"b\"\nprograms = [\"main.clad\"]\n
[[task]]\nname = \"c\"\ninterval = \"7ns\"\nprograms = [\"main.clad\", \"count.clad\", \"lines/../main.clad\"]\n
[[task]]\nname = \"C\"\ninterval = \"1s\"\nprograms = [\"lines/out.clad\"]\n"
    ));
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,a_in,b_in,count.gap,count.k,main.start,main.t.ET,main.t.Q,n,run
        0,0,1,1,0,0,0,0,0,0,0
    "#]].assert_eq(&told(
        "[[task]]\nname = \"a\"\ninterval = \"1s\"\nprograms = [\"main.clad\"]\n[[task]]\nname = \"b\"\ninterval = \"7us\"\nprograms = [\"count.clad\"]\n"
    ));
    folder.write("ladder.toml", SETTINGS.as_bytes());
    expect![[r#"
        exit status 2
        -- stderr
        error: --dt is not for a project: its tasks say how often each program runs
    "#]]
    .assert_eq(
        &folder
            .ladder(&["sim", ".", "--scans", "1", "--dt", "1ms"])
            .to_string(),
    );
    folder.write("main.clad", b"+--[ ]( a )--( y )--+\n");
    expect![[r#"
        exit status 1
        -- stderr
        error[unknown-instruction]: there is no instruction (y)
         --> main.clad:1:14
          |
        1 | +--[ ]( a )--( y )--+
          |              ^^^^^
          |
          = help: a coil of the tag `y` is written ( )( y )
        help: Write ( )( y )
          |
        1 | +--[ ]( a )----------------------------------------------------------( )( y )--+
          |              +++++++++++++++++++++++++++++++++++++++++++++++++++++++++++

        error: ./ladder.toml: this program uses main.clad; a program with errors is not run
    "#]]
    .assert_eq(&folder.ladder(&["sim", ".", "--scans", "1"]).to_string());
}
