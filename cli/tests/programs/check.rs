//! `ladder check`

use crate::harness::{Folder, MOTOR, Run};
use expect_test::{Expect, expect};

/// A program with an error.
const ERROR: &str = "+--[ ]( start )--<JMP>( finish )--+\n\n+--<LBL>( finsh )--( )( run )--+\n";

/// A program with nothing worse than a warning.
const WARNING: &str = "+--[ ]( start )( )( run )--+\n";

/// Checks one program.
fn check(text: &str, expected: Expect) {
    let folder = Folder::with(&[("a.clad", text)]);
    expected.assert_eq(&folder.ladder(&["check", "a.clad"]).to_string());
}

#[test]
fn a_program_without_errors() {
    check(
        MOTOR,
        expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]],
    );
}

#[test]
fn an_error_with_what_to_do() {
    check(
        ERROR,
        expect![[r#"
            exit status 1
            -- stdout
            error[unknown-label]: there is no label `finish` to jump to
             --> a.clad:1:25
              |
            1 | +--[ ]( start )--<JMP>( finish )--+
              |                         ^^^^^^
              |
              = help: did you mean `finsh`?
            help: Jump to `finsh`
              |
            1 - +--[ ]( start )--<JMP>( finish )--+
            1 + +--[ ]( start )------------------------------------------------<JMP>( finsh )--+
              |

            Checked 1 file: 1 error.
        "#]],
    );
}

#[test]
fn a_warning_alone_does_not_fail() {
    check(
        WARNING,
        expect![[r#"
            exit status 0
            -- stdout
            warning[missing-wire]: two blocks touch without a wire between them
             --> a.clad:1:15
              |
            1 | +--[ ]( start )( )( run )--+
              |               ^^
              |
              = help: draw a `-` between them
            help: Insert wire
              |
            1 | +--[ ]( start )----------------------------------------------------( )( run )--+
              |                ++++++++++++++++++++++++++++++++++++++++++++++++++++

            Checked 1 file: 1 warning.
        "#]],
    );
}

#[test]
fn deny_warnings() {
    let folder = Folder::with(&[("a.clad", WARNING), ("b.clad", MOTOR)]);
    let status = |arguments: &[&str]| folder.ladder(&[&["check"], arguments].concat()).status;
    assert_eq!(status(&["."]), Some(0));
    assert_eq!(status(&["--deny", "warnings", "."]), Some(1));
    assert_eq!(status(&["--deny", "warnings", "b.clad"]), Some(0));
}

#[test]
fn a_fix_in_the_middle_of_a_network() {
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )                |\n",
        expect![[r#"
            exit status 1
            -- stdout
            error[unpaired-connector]: the 2nd `\` on line 1 has no partner: line 1 has 2 `\`, line 2 below it has 1 `/`
             --> a.clad:1:17
              |
            1 | +--\--[ ]( a )--\--( )( y )--+
              |                 ^
            2 | |  /--[ ]( b )                |
              | ------------------------------- its partner `/` belongs onto this rung
              |
              = help: every `\` needs a `/` on the rung below: together they join the two lines
            help: Close the branch with `/`
              |
            1 ~ +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            2 ~ |  /--[ ]( b )--/                                                              |
              |

            Checked 1 file: 1 error.
        "#]],
    );
}

#[test]
fn a_related_place() {
    check(
        "VAR a : BOOL; END_VAR\nVAR b, A : INT; END_VAR\n",
        expect![[r#"
        exit status 1
        -- stdout
        error[duplicate-declaration]: `A` is declared twice
         --> a.clad:2:8
          |
        1 | VAR a : BOOL; END_VAR
          |     - `a` is first declared here
        2 | VAR b, A : INT; END_VAR
          |        ^
          |
          = help: remove one of the declarations, or give one tag another name; capitals do not tell names apart

        Checked 1 file: 1 error.
    "#]],
    );
}

#[test]
fn json() {
    let folder = Folder::with(&[
        ("a.clad", "# é # +--<JMP>( done )--+\n"),
        ("b.clad", "VAR a : BOOL; END_VAR\nVAR b, A : INT; END_VAR\n"),
        ("c.clad", ERROR),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        [
          {"file":"a.clad","rule":"unknown-label","severity":"error","message":"there is no label `done` to jump to","line":1,"column":17,"end_line":1,"end_column":21,"help":"mark the network with <LBL>( done )"},
          {"file":"b.clad","rule":"duplicate-declaration","severity":"error","message":"`A` is declared twice","line":2,"column":8,"end_line":2,"end_column":9,"help":"remove one of the declarations, or give one tag another name; capitals do not tell names apart","related":[{"file":"b.clad","message":"`a` is first declared here","line":1,"column":5,"end_line":1,"end_column":6}]},
          {"file":"c.clad","rule":"unknown-label","severity":"error","message":"there is no label `finish` to jump to","line":1,"column":25,"end_line":1,"end_column":31,"help":"did you mean `finsh`?","fix":{"title":"Jump to `finsh`","applicability":"unsafe","edits":[{"line":1,"column":25,"end_line":1,"end_column":31,"text":"finsh"}]}}
        ]
    "#]].assert_eq(&folder.ladder(&["check", "--format", "json", "."]).to_string());
}

#[test]
fn json_of_a_program_without_errors_is_an_empty_array() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--format", "json", "a.clad"]);
    assert_eq!(run.to_string(), "exit status 0\n-- stdout\n[]\n");
}

#[test]
fn colours_only_where_they_are_wanted() {
    let folder = Folder::with(&[("a.clad", ERROR)]);
    let ladder = env!("CARGO_BIN_EXE_ladder");
    let coloured = |variables: &[(&str, &str)]| {
        let run = folder.run(ladder, &["check", "a.clad", "missing.clad"], b"", variables);
        (run.stdout.contains('\x1b'), run.stderr.contains('\x1b'))
    };
    // Here neither is a terminal.
    assert_eq!(coloured(&[]), (false, false));
    assert_eq!(coloured(&[("CLICOLOR_FORCE", "1")]), (true, true));
    assert_eq!(
        coloured(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]),
        (false, false)
    );
}

#[test]
fn without_a_path_it_is_this_folder() {
    let rung = "+--[ ]( a )--( )( y )--+\n";
    let folder = Folder::with(&[
        ("a.clad", rung),
        (
            "a.ladder-test",
            "program a.clad\n\nscenario \"on\"\na    -\ny => -\n",
        ),
    ]);
    let without_times = |run: Run| run.to_string().split(", in ").next().map(str::to_owned);
    for command in ["check", "test"] {
        let named = without_times(folder.ladder(&[command, "."]));
        assert_eq!(without_times(folder.ladder(&[command])), named);
    }
    folder.ladder(&["fmt"]);
    assert_ne!(folder.read("a.clad"), rung);
}
