//! `ladder convert`

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

const RUNG: &str = "start (open contact I0.1 V open contact Q0) & closed contact I1.0 & active coil Q0 end\n";

const DRAFT: &str = "\
// a lamp
IN = {DI go}
OUT = {DO lamp}

+---[ ]<go>---[PID]<x>---()<lamp>---+
";

#[test]
fn a_program_becomes_ladder_text() {
    let folder = Folder::with(&[("motor.txt", RUNG)]);
    expect![[r#"
        exit status 0
        -- stdout
        VAR_INPUT
            I0 : BOOL := TRUE;
            I1 : BOOL;
        END_VAR
        VAR_OUTPUT
            Q0 : BOOL;
        END_VAR

        +--\--[ ]( I0 )--\--[/]( I1 )---------------------------------------( )( Q0 )--+
        |  /--[ ]( Q0 )--/                                                             |
        -- stderr
        motor.txt: 4 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&folder.ladder(&["convert", "motor.txt"]).to_string());
}

#[test]
fn what_has_no_counterpart_stays_as_a_comment() {
    let folder = Folder::with(&[("lamp.cplc", DRAFT)]);
    let run = folder.ladder(&["convert", "lamp.cplc", "-o", "lamp.clad"]);
    expect![[r#"
        exit status 1
        -- stderr
        lamp.cplc:5:15: refused: [PID]<x>: the draft has no such block
        lamp.cplc: 4 translated, 0 approximated, 1 refused
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        # a lamp #

        VAR_INPUT
            go : BOOL;
        END_VAR
        VAR_OUTPUT
            lamp : BOOL;
        END_VAR

        +--[ ]( go )--# [PID]<x> #----------------------------------------( )( lamp )--+
    "#]]
    .assert_eq(&folder.read("lamp.clad"));
    let run = folder.ladder(&["convert", "lamp.cplc", "-o", "x.clad", "--report", "json"]);
    expect![[r#"
        exit status 1
        -- stderr
        [
          {
            "file": "lamp.cplc",
            "line": 2,
            "column": 1,
            "outcome": "translated",
            "element": "DI go"
          },
          {
            "file": "lamp.cplc",
            "line": 3,
            "column": 1,
            "outcome": "translated",
            "element": "DO lamp"
          },
          {
            "file": "lamp.cplc",
            "line": 5,
            "column": 5,
            "outcome": "translated",
            "element": "[ ]<go>"
          },
          {
            "file": "lamp.cplc",
            "line": 5,
            "column": 15,
            "outcome": "refused",
            "element": "[PID]<x>",
            "reason": "the draft has no such block"
          },
          {
            "file": "lamp.cplc",
            "line": 5,
            "column": 26,
            "outcome": "translated",
            "element": "()<lamp>"
          }
        ]
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn ladder_text_becomes_something_else() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["convert", "motor.clad", "--to", "textbook"]);
    expect![[r#"
        exit status 0
        -- stdout
        start (open contact I0.0 V open contact M0) & closed contact I1.0 & active coil M0 end
        -- stderr
        motor.clad:1:1: approximated: tag `start`: the grammar knows names such as I0, M0 and Q0 only; it is `I0` there
        motor.clad:1:1: approximated: tag `stop`: the grammar knows names such as I0, M0 and Q0 only; it is `I1` there
        motor.clad:1:1: approximated: tag `run`: the grammar knows names such as I0, M0 and Q0 only; it is `M0` there
        motor.clad: 1 translated, 3 approximated, 0 refused
    "#]].assert_eq(&run.to_string());
    let run = folder.ladder(&["convert", "motor.clad", "-o", "motor.cplc"]);
    expect![[r#"
        exit status 0
        -- stderr
        motor.clad: 1 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        IN = {DI start, DI stop}
        VAR = {BOOL run}

        +--\--[ ]<start>--\--[/]<stop>--( )<run>---------------------------------------+
        |  /--[ ]<run>----/                                                            |
    "#]]
    .assert_eq(&folder.read("motor.cplc"));
}

#[test]
fn one_foreign_notation_becomes_another() {
    let folder = Folder::with(&[("motor.rung", RUNG)]);
    let run = folder.ladder(&["convert", "motor.rung", "--to", "cplc-draft"]);
    expect![[r#"
        exit status 0
        -- stdout
        IN = {DI I0, DI I1}
        OUT = {DO Q0}

        +--\--[ ]<I0>--\--[/]<I1>--( )<Q0>---------------------------------------------+
        |  /--[ ]<Q0>--/                                                               |
        -- stderr
        motor.rung: approximated: tag `I0`: the draft has no initial values
        motor.rung: 5 translated, 1 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn folders_and_several_files() {
    let folder = Folder::with(&[
        ("in/a.rung", RUNG),
        ("in/deep/b.cplc", DRAFT),
        ("in/c.txt", "no program"),
    ]);
    let run = folder.ladder(&["convert", "in"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: several programs need a folder to be written into: name it with -o
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&["convert", "in", "-o", "out"]);
    expect![[r#"
        exit status 1
        -- stderr
        in/a.rung: 4 translated, 0 approximated, 0 refused
        in/deep/b.cplc:5:15: refused: [PID]<x>: the draft has no such block
        in/deep/b.cplc: 4 translated, 0 approximated, 1 refused
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.names(), ["in", "out"]);
    assert!(folder.read("out/a.clad").contains("[ ]( I0 )"));
    assert!(folder.read("out/deep/b.clad").contains("[PID]<x>"));
}

#[test]
fn what_is_found_in_folders_goes_to_the_same_folders() {
    let folder = Folder::with(&[
        ("in/a.rung", RUNG),
        ("in/hall/a.rung", RUNG),
        ("in/hall/wing/b.rung", RUNG),
    ]);
    let run = folder.ladder(&["convert", "in", "-o", "out"]);
    assert_eq!(run.status, Some(0), "{run}");
    for file in ["out/a.clad", "out/hall/a.clad", "out/hall/wing/b.clad"] {
        assert!(folder.read(file).contains("Q0"), "{file}");
    }
    let run = folder.ladder(&["convert", "in/hall", "in", "-o", "other"]);
    assert_eq!(run.status, Some(2), "{run}");
}

#[test]
fn a_name_keeps_its_dots() {
    let folder = Folder::with(&[("in/line.1_a.rung", RUNG), ("in/line.1_b.rung", RUNG)]);
    let run = folder.ladder(&["convert", "in", "-o", "out"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(folder.read("out/line.1_a.clad").contains("Q0"));
    assert!(folder.read("out/line.1_b.clad").contains("Q0"));
}

#[test]
fn what_cannot_be_read_is_not_written() {
    let folder = Folder::with(&[
        ("bad.rung", "start open contact I0.1 & end\n"),
        ("text.txt", "hello\n"),
        ("motor.clad", MOTOR),
        ("broken.clad", "+--[ ]( a\n"),
    ]);
    for (arguments, expected) in [
        (
            &["convert", "bad.rung", "-o", "out.clad"][..],
            expect![[r#"
                exit status 2
                -- stderr
                error: bad.rung:1:27: a contact, a coil or `(` is missing here
            "#]],
        ),
        (
            &["convert", "text.txt"],
            expect![[r#"
                exit status 2
                -- stderr
                error: text.txt: this is in no notation that is known; if it is, name it with --from
            "#]],
        ),
        (
            &["convert", "motor.clad"],
            expect![[r#"
                exit status 2
                -- stderr
                error: motor.clad: this is ladder text already; name the notation to write with --to
            "#]],
        ),
        (
            &["convert", "broken.clad", "--to", "textbook", "-o", "out.rung"],
            expect![[r#"
                exit status 2
                -- stderr
                error: broken.clad: this cannot be written as rung in the textbook grammar: the program has errors: 1:7: `( a` is not closed: `)` is missing
            "#]],
        ),
        (
            &["convert", "none.rung"],
            expect![[r#"
                exit status 2
                -- stderr
                error: none.rung: no such file or folder
            "#]],
        ),
        (
            &["convert", "motor.clad", "--to", "word"],
            expect![[r#"
                exit status 2
                -- stderr
                error: invalid value 'word' for '--to <NOTATION>'
                  [possible values: clad, textbook, cplc-draft, ldmicro, ldmicro-text, l5x, iot, click, click-csv, plcopen, simatic, simaticml, twincat, c, st, ascii]

                For more information, try '--help'.
            "#]],
        ),
    ] {
        expected.assert_eq(&folder.ladder(arguments).to_string());
    }
    assert_eq!(
        folder.names(),
        ["bad.rung", "broken.clad", "motor.clad", "text.txt"]
    );
}

#[test]
fn a_program_is_not_replaced_unasked() {
    let folder = Folder::with(&[("motor.rung", RUNG), ("motor.clad", MOTOR)]);
    let run = folder.ladder(&["convert", "motor.rung", "-o", "motor.clad"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: motor.clad: this is a program, and it stays as it is; name another file, or end with --force
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.read("motor.clad"), MOTOR);
    folder.ladder(&["convert", "motor.rung", "-o", "motor.clad", "--force"]);
    assert!(folder.read("motor.clad").contains("[ ]( I0 )"));
}

const GRID: &str = "marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF\n";

/// A row of Click's grid: its first cells, wire, and an output.
fn row(cells: &str, output: &str) -> String {
    let wires = ",-".repeat(32 - cells.split(',').count());
    format!("{cells}{wires},{output}\n")
}

#[test]
fn files_that_belong_to_a_program_are_read_and_written_with_it() {
    let call = row("R,X001", r#""call(""Rinse"")""#);
    let main = format!("{GRID}{call}{}", row("R", "end()"));
    let sub = format!("{GRID}{}{}", row("R,C1", "out(Y001)"), row("R", "return()"));
    let nicknames = "Address,Nickname\nY001,Pump\n";
    let folder = Folder::with(&[
        ("plant/main.csv", &main),
        ("plant/subroutines/Rinse.csv", &sub),
        ("plant/nicknames.csv", nicknames),
        ("plant/table.csv", "time,level\n0,1\n"),
    ]);
    let run = folder.ladder(&["convert", "plant", "-o", "made"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(!run.to_string().contains("table.csv"), "{run}");
    let text = folder.read("made/main.clad");
    assert!(
        text.contains("<FUN>( Rinse )") && text.contains("( )( Pump )"),
        "{text}"
    );
    let run = folder.ladder(&["convert", "made/main.clad", "-o", "made/main.csv"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(folder.read("made/main.csv"), main);
    assert_eq!(folder.read("made/subroutines/Rinse.csv"), sub);
    let run = folder.ladder(&["convert", "made/main.clad", "-o", "plant/new.csv"]);
    assert_eq!(run.status, Some(2), "{run}");
    assert!(!folder.path("plant/new.csv").exists(), "nothing is half written");
}

/// No other notation has the blocks of the library: which one it is is said, and where.
#[test]
fn what_a_program_uses_of_other_files() {
    let folder = Folder::with(&[
        ("pulse.clad", "+--[$Blink]( T#1s, T#1s )--( )( Q1 )--+\n"),
        ("call.clad", "+--[ ]( I1 )--<CALL>( count )--+\n"),
        (
            "count.clad",
            "VAR\n    n : INT;\nEND_VAR\n+--<FUN>( count )--[ADD]( n, n, 1 )--+\n",
        ),
    ]);
    let mut shown = String::new();
    for notation in ["textbook", "cplc-draft", "ldmicro", "iot", "click"] {
        for program in ["pulse.clad", "call.clad"] {
            let run = folder.ladder(&["convert", program, "--to", notation, "-o", "out"]);
            shown.push_str(&format!("{notation}: {run}"));
        }
    }
    expect![[r#"
        textbook: exit status 2
        -- stderr
        error: pulse.clad: this cannot be written as rung in the textbook grammar: 1:4: [$Blink] is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program
        textbook: exit status 2
        -- stderr
        error: call.clad: this cannot be written as rung in the textbook grammar: 1:15: the function `count` is in count.clad, and the notation has one file: put it into this one
        cplc-draft: exit status 2
        -- stderr
        error: pulse.clad: this cannot be written as program in the first draft of CPLC-LD: 1:4: [$Blink] is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program
        cplc-draft: exit status 2
        -- stderr
        error: call.clad: this cannot be written as program in the first draft of CPLC-LD: 1:15: the function `count` is in count.clad, and the notation has one file: put it into this one
        ldmicro: exit status 2
        -- stderr
        error: pulse.clad: this cannot be written as LDmicro program: 1:4: [$Blink] is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program
        ldmicro: exit status 2
        -- stderr
        error: call.clad: this cannot be written as LDmicro program: 1:15: the function `count` is in count.clad, and the notation has one file: put it into this one
        iot: exit status 2
        -- stderr
        error: pulse.clad: this cannot be written as program of the IoT ladder language: 1:4: [$Blink] is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program
        iot: exit status 2
        -- stderr
        error: call.clad: this cannot be written as program of the IoT ladder language: 1:15: the function `count` is in count.clad, and the notation has one file: put it into this one
        click: exit status 2
        -- stderr
        error: pulse.clad: this cannot be written as Click program in Python: 1:4: [$Blink] is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program
        click: exit status 2
        -- stderr
        error: call.clad: this cannot be written as Click program in Python: 1:15: the function `count` is in count.clad, and the notation has one file: put it into this one
    "#]].assert_eq(&shown);
}
