//! Models of the machine beside a program: in scenarios, in runs, and what is wrong with them.

use crate::harness::Folder;
use crate::scenarios::without_times;
use expect_test::{Expect, expect};
use std::path::{Path, PathBuf};

/// The machines with their controllers: always those of the project, and others where they are at hand.
fn machines() -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus");
    let more = std::env::var_os("LADDER_CORPUS").map(PathBuf::from);
    let corpora = std::iter::once(own).chain(more);
    let entries = corpora.flat_map(|corpus| std::fs::read_dir(corpus.join("plants")).into_iter().flatten());
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.sort();
    assert!(found.len() >= 4, "the corpus is not there");
    found
}

fn folder(machine: &Path) -> Folder {
    let folder = Folder::with(&[]);
    for entry in std::fs::read_dir(machine).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy();
        folder.write(&name, &std::fs::read(&path).unwrap());
    }
    folder
}

#[test]
fn the_machines_do_what_their_scenarios_say() {
    for machine in machines() {
        let folder = folder(&machine);
        for file in ["proposed.ladder-test", "loop.ladder-test"] {
            let run = folder.ladder(&["test", file]).to_string();
            assert!(run.starts_with("exit status 0"), "{}\n{run}", machine.display());
        }
    }
}

/// A program beside its plant does in each scan what both do in one file, written by hand.
#[test]
fn the_product_is_that_made_by_hand() {
    for (machine, inputs, watch) in [
        (
            "conveyor",
            &["place=1", "slip=0"][..],
            "box,front,near,far,belt,late,fell,travel.ET",
        ),
        (
            "cylinder",
            &["start=1", "out_dead=1"],
            "rod,is_in,is_out,extend,retract,fault,slow.ET",
        ),
        (
            "heater",
            &["on=1", "noise=300"],
            "temperature,measured,heat,ready,locked",
        ),
        (
            "tank",
            &["want=1", "usage=1500"],
            "volume,raw,fill,drain,alarm,overflow",
        ),
    ] {
        let folder = folder(
            &Path::new(env!("CARGO_MANIFEST_DIR"))
                .join("../tests/corpus/plants")
                .join(machine),
        );
        let run = |program: &[&str]| {
            let mut arguments = vec!["sim"];
            arguments.extend(program);
            arguments.extend(["--scans", "300", "--dt", "100ms", "--watch", watch]);
            for input in inputs {
                arguments.extend(["--set", input]);
            }
            folder.ladder(&arguments).stdout
        };
        let beside = run(&["controller.clad", "--plant", "plant.clad"]);
        let product = run(&["loop.clad"]);
        assert!(product.lines().count() > 300, "{machine}: {product}");
        let values = |trace: &str| -> Vec<String> { trace.lines().skip(1).map(str::to_owned).collect() };
        assert_eq!(values(&beside), values(&product), "{machine}");
    }
}

const PUMP: &str = "\
VAR_INPUT  low, high : BOOL;  END_VAR
VAR_OUTPUT pump      : BOOL;  END_VAR
VAR RETAIN starts    : DINT;  END_VAR

+--[ ]( low )-----------------------------------------------------(S)( pump )--+
+--[ ]( high )----------------------------------------------------(R)( pump )--+
+--[P]( pump )---------------------------------------[ADD]( starts, starts, 1 )--+
";

const TANK: &str = "\
VAR_INPUT
    pump : BOOL;
    leak : BOOL;
END_VAR
VAR_OUTPUT low, high : BOOL;  END_VAR
VAR        level     : INT;   END_VAR

+--[ ]( pump )------------------------------------------[ADD]( level, level, 2 )--+
+--[ ]( leak )------------------------------------------[SUB]( level, level, 1 )--+
+--[LT]( level, 2 )------------------------------------------------( )( low )--+
+--[GE]( level, 6 )-----------------------------------------------( )( high )--+
";

fn check(scenarios: &str, expected: &Expect) {
    let folder = Folder::with(&[
        ("pump.clad", PUMP),
        ("tank.clad", TANK),
        ("pump.ladder-test", scenarios),
    ]);
    let run = folder.ladder(&["test", "pump.ladder-test"]).to_string();
    expected.assert_eq(&without_times(&run));
}

#[test]
fn a_plant_goes_on_while_the_controller_has_no_power() {
    check(
        "program pump.clad\nplant tank.clad\n\n\
         scenario \"an outage\"\n\
         SYS.POWER        ---___---\n\
         leak             ----_____\n\
         pump          => -----_---\n\
         plant.level   => -1 0 1 0 0 0 0 2 4\n\
         starts        => 1 1 1 1 1 1 2 2 2\n\
         SYS.FIRST_SCAN => -__...-__\n\
         plant.SYS.SCAN => 0 1 2 3 4 5 6 7 8\n\n\
         scenario \"no power at first\"\n\
         SYS.POWER      __---\n\
         SYS.SCAN    => . . 0 1 2\n\
         plant.level => 0 0 0 2 4\n",
        &expect![[r#"
            exit status 0
            -- stdout
            pump.ladder-test
              ok    an outage
              ok    no power at first

            2 scenarios in 1 file: 2 passed, in T s.
        "#]],
    );
}

#[test]
fn a_row_of_a_connected_input_overrides_the_plant() {
    check(
        "program pump.clad\nplant tank.clad\n\n\
         scenario \"the low switch is stuck\"\n\
         low            ~~--~~\n\
         leak           ______\n\
         plant.low   => -_____\n\
         low         => -_--__\n",
        &expect![[r#"
            exit status 0
            -- stdout
            pump.ladder-test
              ok    the low switch is stuck

            1 scenario in 1 file: 1 passed, in T s.
        "#]],
    );
    check(
        "program pump.clad\nplant tank.clad\n\n\
         scenario \"nothing is driven by the plant there\"\n\
         leak           _~~___\n\
         pump        => ~-----\n",
        &expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: no plant drives plant.leak: `~` gives an input back to the plant
             --> pump.ladder-test:5:17
              |
            5 | leak           _~~___
              |                 ^
              |
              = help: write . where the tag stays as it is; `plant` and `connect` in the head of the file say what drives what

            error[bad-scenario]: `~` is for what is given: it gives an input back to the plant
             --> pump.ladder-test:6:16
              |
            6 | pump        => ~-----
              |                ^
              |
              = help: write . where nothing is checked

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
}

#[test]
fn what_is_wrong_with_plants_is_said_where_they_are_named() {
    for (head, expected) in [
        (
            "plant nope.clad",
            expect![[r#"
            exit status 2
            -- stdout
            error[bad-scenario]: nope.clad: no such file or folder
             --> pump.ladder-test:2:7
              |
            2 | plant nope.clad
              |       ^^^^^^^^^
              |
              = help: a program is named as it is seen from the folder of the scenario file

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad as pump",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: the program has a tag `pump`, which is the name of the plant, too
             --> pump.ladder-test:2:7
              |
            2 | plant tank.clad as pump
              |       ^^^^^^^^^^^^^^^^^
              |
              = help: give the plant another name, as in: plant tank.clad as tank

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad as SYS",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: a plant cannot be called `SYS`
             --> pump.ladder-test:2:7
              |
            2 | plant tank.clad as SYS
              |       ^^^^^^^^^^^^^^^^
              |
              = help: a name is letters, digits and _, as in: plant tank.clad as tank

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: the model of the machine is missing
             --> pump.ladder-test:2:1
              |
            2 | plant
              | ^^^^^
              |
              = help: name its file, as in: plant tank.clad

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad\nconnect plant.level = low",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: plant.level is an INT, and low is a BOOL
             --> pump.ladder-test:3:9
              |
            3 | connect plant.level = low
              |         ^^^^^^^^^^^^^^^^^
              |
              = help: only tags of one type are connected: convert it in the plant, as in: [TYP]( sensor, wide )

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad\nconnect plant.leak = plant.low",
            expect![[r#"
                exit status 1
                -- stdout
                error[bad-scenario]: one side is a tag of a plant, the other one of the program
                 --> pump.ladder-test:3:9
                  |
                3 | connect plant.leak = plant.low
                  |         ^^^^^^^^^^^^^^^^^^^^^^
                  |
                  = help: write it as in: connect plant.sensor_1 = near

                0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
            "#]],
        ),
        (
            "plant tank.clad\nconnect plant.leck = pump",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: there is no tag `plant.leck`
             --> pump.ladder-test:3:9
              |
            3 | connect plant.leck = pump
              |         ^^^^^^^^^^^^^^^^^
              |
              = help: connect a whole tag of a plant with one of the program, as in: connect plant.sensor_1 = near

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad\nconnect plant.high = low",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: low takes the value of both plant.high and plant.low
             --> pump.ladder-test:2:7
              |
            2 | plant tank.clad
              |       ^^^^^^^^^
              |
              = help: an input has one source: leave only one of them

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
        (
            "plant tank.clad\nconnect plant.level",
            expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: a connection is between two tags
             --> pump.ladder-test:3:9
              |
            3 | connect plant.level
              |         ^^^^^^^^^^^
              |
              = help: write it as in: connect plant.sensor_1 = near

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
        ),
    ] {
        check(
            &format!("program pump.clad\n{head}\n\nscenario \"it runs\"\npump => -\n"),
            &expected,
        );
    }
}

#[test]
fn two_plants_run_in_their_order() {
    check(
        "program pump.clad\nplant tank.clad\nplant tank.clad as other\nconnect other.leak = pump\n\n\
         scenario \"both\"\nother.level => 0 -1 -2\nplant.level => 0 2 4\nlevel => . . .\n",
        &expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: low takes the value of both plant.low and other.low
             --> pump.ladder-test:3:7
              |
            3 | plant tank.clad as other
              |       ^^^^^^^^^^^^^^^^^^
              |
              = help: an input has one source: leave only one of them

            error[bad-scenario]: high takes the value of both plant.high and other.high
             --> pump.ladder-test:3:7
              |
            3 | plant tank.clad as other
              |       ^^^^^^^^^^^^^^^^^^
              |
              = help: an input has one source: leave only one of them

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
    check(
        "program pump.clad\nplant tank.clad as near\nplant tank.clad as far\nconnect far.pump = low\n\n\
         scenario \"both\"\nnear.level => 0 2 4\n",
        &expect![[r#"
            exit status 1
            -- stdout
            error[bad-scenario]: low takes the value of both near.low and far.low
             --> pump.ladder-test:3:7
              |
            3 | plant tank.clad as far
              |       ^^^^^^^^^^^^^^^^
              |
              = help: an input has one source: leave only one of them

            error[bad-scenario]: high takes the value of both near.high and far.high
             --> pump.ladder-test:3:7
              |
            3 | plant tank.clad as far
              |       ^^^^^^^^^^^^^^^^
              |
              = help: an input has one source: leave only one of them

            0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
        "#]],
    );
}

const WIDE: &str = "\
VAR_INPUT  pump : BOOL;  END_VAR
VAR_OUTPUT low  : INT;   END_VAR
+--[ ]( pump )-----------------------------------------[ADD]( low, low, 1 )--+
";

#[test]
fn names_of_different_types_are_not_connected() {
    let scenarios = "program pump.clad\nplant wide.clad\n\nscenario \"it runs\"\npump => -\n";
    let folder = Folder::with(&[
        ("pump.clad", PUMP),
        ("wide.clad", WIDE),
        ("pump.ladder-test", scenarios),
    ]);
    let run = folder.ladder(&["test", "pump.ladder-test"]).to_string();
    expect![[r#"
        exit status 1
        -- stdout
        error[bad-scenario]: plant.low is an INT, and low is a BOOL
         --> pump.ladder-test:2:7
          |
        2 | plant wide.clad
          |       ^^^^^^^^^
          |
          = help: give both one type, or connect another tag, as in: connect plant.low = other_low

        0 scenarios in 1 file: 0 passed, 1 file not run for errors, in T s.
    "#]]
    .assert_eq(&without_times(&run));
}

#[test]
fn the_settings_name_the_plant_of_a_workspace() {
    let folder = Folder::with(&[
        ("pump.clad", PUMP),
        ("tank.clad", TANK),
        ("lamp.clad", "+--[ ]( switch )--( )( lamp )--+\n"),
        (
            "ladder.toml",
            "[simulate]\nplant = \"tank.clad\"\nconnect = [\"plant.leak = pump\"]\n",
        ),
        ("inputs.csv", "low,SYS.POWER\n,\n1,\n~,0\n,1\n"),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,high,low,plant.high,plant.leak,plant.level,plant.low,plant.pump,pump,starts
        0,0,0,1,0,0,0,1,0,1,1
        1,10,0,1,0,1,1,1,1,1,1
        2,20,0,1,0,0,1,1,0,0,1
        3,30,0,1,0,0,1,1,0,1,2
        4,40,0,0,0,1,2,0,1,1,2
    "#]]
    .assert_eq(
        &folder
            .ladder(&["sim", "pump.clad", "--scans", "5", "--inputs", "inputs.csv"])
            .to_string(),
    );
    expect![[r#"
        exit status 2
        -- stderr
        error: plant.leak = pump: there is no tag `pump`: connect a whole tag of a plant with one of the program, as in: connect plant.sensor_1 = near
    "#]].assert_eq(&folder.ladder(&["sim", "lamp.clad", "--scans", "1"]).to_string());
    expect![[r#"
        exit status 2
        -- stderr
        error: --connect plant.leak: a connection is between two tags, as in --connect plant.sensor_1=near
    "#]]
    .assert_eq(
        &folder
            .ladder(&[
                "sim",
                "pump.clad",
                "--plant",
                "tank.clad",
                "--scans",
                "2",
                "--connect",
                "plant.leak",
            ])
            .to_string(),
    );
}

/// What a table has is followed through the connection, where a plant is named.
#[test]
fn why_goes_through_the_connection() {
    let folder = Folder::with(&[
        (
            "lamp.clad",
            "VAR_INPUT high : BOOL; END_VAR\n+--[ ]( high )--( )( lamp )--+\n",
        ),
        (
            "tank.clad",
            "VAR_INPUT level : INT; END_VAR\nVAR_OUTPUT full : BOOL; END_VAR\n+--[GE]( level, 800 )--( )( full )--+\n",
        ),
        ("values.csv", "plant.level,810\nplant.full,1\nhigh,1\nlamp,1\n"),
        (
            "ladder.toml",
            "[simulate]\nplant = \"tank.clad\"\nconnect = [\"plant.full = high\"]\n",
        ),
    ]);
    let why = ["why", "lamp.clad", "lamp", "--tags", "values.csv"];
    expect![[r#"
        exit status 0
        -- stdout
        lamp is 1: line 2, ( )( lamp ) writes 1; power came through [ ]( high ) (line 2, column 4): high is 1
          high is 1: it is an input

        │  high                                                                lamp   │
        ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥

        in the table, and not in the program: plant.level (line 1), plant.full (line 2)
    "#]]
    .assert_eq(&folder.ladder(&why).to_string());
    let beside = ["--plant", "tank.clad", "--connect", "plant.full=high"];
    expect![[r#"
        exit status 0
        -- stdout
        lamp is 1: line 2, ( )( lamp ) writes 1; power came through [ ]( high ) (line 2, column 4): high is 1
          high is 1: line 2 of tank.clad, full writes 1; power came straight from the rail
            plant.full is 1: line 3 of tank.clad, ( )( full ) writes 1; power came through [GE]( level, 800 ) (line 3 of tank.clad, column 4): plant.level is 810
              plant.level is 810: it is an input

        │  high                                                                lamp   │
        ┝━━┥━━━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
    "#]].assert_eq(&folder.ladder(&[&why[..], &beside[..]].concat()).to_string());
}
