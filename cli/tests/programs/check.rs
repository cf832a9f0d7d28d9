//! `ladder check`

use crate::harness::{Folder, MOTOR};
use expect_test::{Expect, expect};

/// A program with an error.
const ERROR: &str = "+--[ ]( start )--<JMP>( finish )--+\n\n+--<LBL>( finsh )--( )( run )--+\n";

/// Checks one program.
fn check(text: &str, expected: Expect) {
    let folder = Folder::with(&[("a.clad", text)]);
    expected.assert_eq(&folder.ladder(&["check", "a.clad"]).to_string());
}

#[test]
fn a_program_without_mistakes() {
    check(
        MOTOR,
        expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no mistakes found.
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
        1 + +--[ ]( start )--<JMP>( finsh )--+
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
          {"file":"c.clad","rule":"unknown-label","severity":"error","message":"there is no label `finish` to jump to","line":1,"column":25,"end_line":1,"end_column":31,"help":"did you mean `finsh`?","fix":{"title":"Jump to `finsh`","edits":[{"line":1,"column":25,"end_line":1,"end_column":31,"text":"finsh"}]}}
        ]
    "#]].assert_eq(&folder.ladder(&["check", "--format", "json", "."]).to_string());
}

#[test]
fn json_of_a_program_without_mistakes_is_an_empty_array() {
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
