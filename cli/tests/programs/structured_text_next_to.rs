//! Files of Structured Text are programs of a workspace: what they declare is used in ladder text, and the reverse.

use crate::harness::Folder;
use expect_test::{Expect, expect};

const BLOCKS: &str = "\
TYPE
    Recipe : STRUCT amount : INT := 5; END_STRUCT;
END_TYPE
VAR_GLOBAL
    total : INT;
END_VAR

(* Runs a motor. *)
FUNCTION_BLOCK FB_Motor
VAR_INPUT
    go, stop : BOOL;
    speed : INT := 10;
END_VAR
VAR_OUTPUT
    run : BOOL;
    turns : INT;
END_VAR
    IF go AND NOT stop THEN
        run := TRUE;
    ELSIF stop THEN
        run := FALSE;
    END_IF;
    IF run THEN
        turns := turns + speed;
        total := total + 1;
    END_IF;
END_FUNCTION_BLOCK

FUNCTION Clamp : INT
VAR_INPUT v, lo, hi : INT; END_VAR
    Clamp := MIN(MAX(v, lo), hi);
END_FUNCTION
";

const PLANT: &str = "\
VAR_INPUT
    start, halt : BOOL;
END_VAR
VAR
    m : $FB_Motor;
    r : Recipe;
END_VAR
VAR_OUTPUT
    lamp : BOOL;
    n : INT;
END_VAR
+--[MOV]( r.amount, 5 )--[$FB_Motor]( m, go := start, stop := halt, speed := r.amount, run => lamp )--+
+--[$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n )--+
";

const LATCH: &str = "\
FUNCTION_BLOCK [$Latch]
VAR_INPUT set, clear : BOOL; END_VAR
VAR_OUTPUT out : BOOL; END_VAR
+--[ ]( set )--(S)( out )--+
+--[ ]( clear )--(R)( out )--+
END_FUNCTION_BLOCK
";

const MAIN: &str = "\
PROGRAM Main
VAR
    m : FB_Motor;
    held : Latch;
    r : Recipe;
    n : INT;
END_VAR
    r.amount := 4;
    m(go := TRUE, stop := FALSE, speed := r.amount);
    held(set := m.turns > 7, clear := FALSE);
    IF held.out THEN
        n := Clamp(v := m.turns, lo := 0, hi := 12) + total;
    END_IF;
END_PROGRAM
";

fn plant() -> Folder {
    Folder::with(&[
        ("blocks.st", BLOCKS),
        ("plant.clad", PLANT),
        ("latch.clad", LATCH),
        ("main.st", MAIN),
    ])
}

/// What the program says to some words, in the folder.
#[track_caller]
fn check(folder: &Folder, words: &str, expected: Expect) {
    let words: Vec<&str> = words.split_whitespace().collect();
    expected.assert_eq(&folder.ladder(&words).to_string());
}

/// The plant with another text in its blocks.
fn with_blocks(from: &str, to: &str) -> Folder {
    let folder = plant();
    folder.write("blocks.st", BLOCKS.replace(from, to).as_bytes());
    folder
}

#[test]
fn ladder_text_calls_them_and_they_call_ladder_text() {
    let folder = plant();
    check(
        &folder,
        "check . --format concise",
        expect![[r#"
        exit status 0
        -- stdout
        Checked 4 files: no errors found.
    "#]],
    );
    check(
        &folder,
        "sim plant.clad --scans 4 --set start=1 --watch n,lamp,total",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,n,lamp,total
        0,0,5,1,1
        1,10,10,1,2
        2,20,12,1,3
        3,30,12,1,4
    "#]],
    );
    check(
        &folder,
        "sim main.st --scans 4 --watch n,total",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,n,total
        0,0,0,1
        1,10,10,2
        2,20,15,3
        3,30,16,4
    "#]],
    );
}

#[test]
fn scenarios_and_properties_see_through_them() {
    let folder = plant();
    let scenarios = "\
program plant.clad
step 10ms
property \"n is never over 12\"
never n > 12
property \"n is never over 4\"
never n > 4
scenario \"runs\"
start    - - - -
n     => 5 10 12 12
";
    folder.write("plant.ladder-test", scenarios.as_bytes());
    for (words, told) in [
        (
            &["test", "plant.ladder-test"][..],
            "n is never over 4\" is violated in scan 0",
        ),
        (&["prove", "."], "proved      n is never over 12  for any times"),
        (&["prove", "."], "violated    n is never over 4   in scan 0"),
        (
            &["test", "--coverage", "."],
            "  blocks.st:18:5: this contact was never",
        ),
    ] {
        let answer = folder.ladder(words);
        assert!(answer.stdout.contains(told), "{answer}");
    }
}

#[test]
fn what_is_wrong_in_one_is_said_at_its_places_and_keeps_its_users_from_running() {
    let folder = with_blocks("IF run THEN", "IF run");
    check(
        &folder,
        "check . --format concise",
        expect![[r#"
        exit status 1
        -- stdout
        blocks.st:24:9: error[st-syntax] `THEN` is expected here, not `turns`
        blocks.st:26:11: error[st-syntax] `:=` is expected here, not `;`
        blocks.st:9:16: warning[unread-part] `FB_Motor` is an unread part: it is not run, and may write any tag that it sees
        Checked 4 files: 2 errors, 1 warning.
    "#]],
    );
    check(
        &folder,
        "sim plant.clad --scans 2",
        expect![[r#"
        exit status 1
        -- stderr
        error[st-syntax]: `THEN` is expected here, not `turns`
          --> blocks.st:24:9
           |
        24 |         turns := turns + speed;
           |         ^^^^^

        error[st-syntax]: `:=` is expected here, not `;`
          --> blocks.st:26:11
           |
        26 |     END_IF;
           |           ^

        error: plant.clad: this program uses blocks.st; a program with errors is not run
    "#]],
    );
}

#[test]
fn two_files_with_one_block_are_an_error_where_it_is_used() {
    let folder = plant();
    let clamp = &BLOCKS[BLOCKS.find("FUNCTION Clamp").unwrap()..];
    folder.write("more.st", clamp.as_bytes());
    check(
        &folder,
        "check plant.clad",
        expect![[r#"
        exit status 1
        -- stdout
        error[duplicate-block]: several files define the block `$Clamp`: which one [$Clamp] means is open
          --> plant.clad:13:4
           |
        13 | +--[$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n )--+
           |    ^^^^^^^^
           |
          ::: blocks.st:29:10
           |
        29 | FUNCTION Clamp : INT
           |          ----- it is defined here
           |
          ::: more.st:1:10
           |
         1 | FUNCTION Clamp : INT
           |          ----- it is defined here
           |
           = help: rename all but one of them, or define the block in this file

        Checked 1 file: 1 error.
    "#]],
    );
}

#[test]
fn reasons_and_faults_are_at_their_places() {
    let folder = with_blocks("turns + speed", "turns + speed / turns");
    check(
        &folder,
        "sim plant.clad --scans 4 --set start=1 --watch n",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,n
        0,0,0
        1,10,0
        2,20,0
        3,30,0
        -- stderr
        blocks.st:24:9: fault in scan 0: division by zero: nothing was written; check the divisor before this block
        blocks.st:24:9: fault in scan 1: division by zero: nothing was written; check the divisor before this block
        blocks.st:24:9: fault in scan 2: division by zero: nothing was written; check the divisor before this block
        blocks.st:24:9: fault in scan 3: division by zero: nothing was written; check the divisor before this block
    "#]],
    );
    folder.write("blocks.st", BLOCKS.as_bytes());
    folder.write("seen.csv", b"m.turns,10\nn,10\n");
    check(
        &folder,
        "why plant.clad n --tags seen.csv",
        expect![[r#"
        exit status 0
        -- stdout
        n is 10: line 13, [$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n ) writes 10; power came straight from the rail
          $Clamp#1.Clamp is 10, though not in the table, as far as the table goes: line 31 of blocks.st, [MIN]( Clamp, st1, hi ) writes 10; power came through [MAX]( st1, v, lo ) (line 31 of blocks.st, column 5): $Clamp#1.v is 10, $Clamp#1.lo is 0
            $Clamp#1.v is 10, though not in the table: line 13, [$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n ) writes 10; power came straight from the rail
              m.turns is 10: no network writes it
            $Clamp#1.lo is 0, though not in the table: line 13, [$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n ) writes 0; power came straight from the rail
            $Clamp#1.st1 is 10, though not in the table: line 31 of blocks.st, [MAX]( st1, v, lo ) writes 10; power came straight from the rail
            $Clamp#1.hi is 12, though not in the table: line 13, [$Clamp]( v := m.turns, lo := 0, hi := 12, Clamp => n ) writes 12; power came straight from the rail

        │                                                          ┌─── $Clamp ────┐  │
        ┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━┥EN          ENO┝━━┥
        │                                                          │v     m.turns  │  │
        │                                                          │      10       │  │
        │                                                          │lo    0        │  │
        │                                                          │hi    12       │  │
        │                                                          │Clamp n        │  │
        │                                                          │      10       │  │
        │                                                          └───────────────┘  │
    "#]],
    );
}

#[test]
fn they_are_compared_with_their_neighbours() {
    let edited = BLOCKS.replace("turns + speed", "turns + 2 * speed");
    let folder = Folder::with(&[
        ("old/blocks.st", BLOCKS),
        ("old/plant.clad", PLANT),
        ("new/blocks.st", edited.as_str()),
        ("new/plant.clad", PLANT),
    ]);
    check(
        &folder,
        "diff old new",
        expect![[r#"
        exit status 1
        -- stdout
        --- old/blocks.st
        +++ new/blocks.st
            1 edited, 18 the same

            ... 9 the same

        edited, does another thing: network, writes turns
            with turns 0 and speed 1, turns becomes 1 in the old and 2 in the new program
        - +--------------------------------------------[CALC]( turns, turns + speed )--+
                                                       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
        + +----------------------------------------[CALC]( turns, turns + 2 * speed )--+
                                                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^

            ... 9 the same

        the programs do the same in every run

        --- old/plant.clad
        +++ new/plant.clad
            7 the same, it uses blocks.st, which is different

            ... 7 the same

        the programs differ in scan 0, at 0s
            start    -
            n     => 5  (old)
            n     => 10  (new)
    "#]],
    );
}

#[test]
fn a_task_runs_one_and_the_formatter_leaves_it() {
    let folder = plant();
    folder.write(
        "ladder.toml",
        b"[[task]]\nname = \"Fast\"\ninterval = \"10ms\"\nprograms = [\"main.st\"]\n",
    );
    check(
        &folder,
        "sim . --scans 3 --watch total",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,total
        0,0,1
        1,10,2
        2,20,3
    "#]],
    );
    assert!(
        folder
            .ladder(&["fmt", "."])
            .to_string()
            .starts_with("exit status 0")
    );
    assert_eq!(folder.read("main.st"), MAIN);
    assert_eq!(folder.read("blocks.st"), BLOCKS);
}
