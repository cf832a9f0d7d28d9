//! `ladder check -`

use crate::harness::{CROOKED, Folder, MOTOR, Run};
use expect_test::expect;

/// A program with an error that has one fix.
const ERROR: &str = "+--[ ]( start )--<JMP>( finish )--+\n\n+--<LBL>( finsh )--( )( run )--+\n";

fn check(folder: &Folder, arguments: &[&str], text: &str) -> Run {
    let arguments = [&["check"], arguments].concat();
    folder.run(env!("CARGO_BIN_EXE_ladder"), &arguments, text.as_bytes(), &[])
}

#[test]
fn a_text_without_a_name() {
    let folder = Folder::with(&[]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&check(&folder, &["-"], MOTOR).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        <stdin>:1:25: error[unknown-label] there is no label `finish` to jump to
        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&check(&folder, &["--format", "concise", "-"], ERROR).to_string());
    assert!(folder.names().is_empty());
}

#[test]
fn the_name_decides_the_workspace_and_is_in_messages() {
    let folder = Folder::with(&[
        ("plant/ladder.toml", "[lint]\nundeclared-tag = \"error\"\n"),
        (
            "plant/globals.clad",
            "VAR_GLOBAL\n    go : BOOL;\nEND_VAR\n\n+--[ ]( go )--( )( go )--+\n",
        ),
        // What is saved is not what is checked.
        ("plant/line/motor.clad", "+--[ ( broken\n"),
    ]);
    let text = "VAR_EXTERNAL\n    go : BOOL;\nEND_VAR\n\n+--[ ]( go )--( )( lamp )--+\n";
    for name in ["plant/line/motor.clad", "plant/line/new.clad"] {
        let run = check(
            &folder,
            &["--format", "concise", "--stdin-filename", name, "-"],
            text,
        );
        assert_eq!(run.status, Some(1), "{run}");
        assert!(
            run.stdout
                .starts_with(&format!("{name}:5:20: error[undeclared-tag]")),
            "{run}"
        );
    }
    assert!(!folder.path("plant/line/new.clad").exists());
}

/// The text may be one of the files around it, which must not meet itself there.
#[test]
fn a_text_without_a_name_is_alone_under_the_settings_of_the_folder() {
    let text = "VAR_GLOBAL\n    t : TON;\nEND_VAR\n\n+--[ ]( go )--[TON]( t, T#5s )--( )( late )--+\n";
    let settings = "[lint]\nundeclared-tag = \"off\"\n";
    let folder = Folder::with(&[("0.clad", text), ("ladder.toml", settings)]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&check(&folder, &["-"], text).to_string());
}

#[test]
fn formats_for_machines_have_the_name() {
    let folder = Folder::with(&[]);
    let arguments = ["--stdin-filename", "line/a.clad", "-"];
    let json = check(&folder, &[&["--format", "json"][..], &arguments].concat(), ERROR);
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(value[0]["file"], "line/a.clad", "{json}");
    let sarif = check(&folder, &[&["--format", "sarif"][..], &arguments].concat(), ERROR);
    assert!(sarif.stdout.contains("\"uri\": \"line/a.clad\""), "{sarif}");
    let github = check(
        &folder,
        &[&["--format", "github"][..], &arguments].concat(),
        ERROR,
    );
    assert!(
        github.stdout.starts_with("::error file=line/a.clad,line=1,"),
        "{github}"
    );
}

#[test]
fn the_fixed_text_goes_to_stdout_and_the_report_to_stderr() {
    let folder = Folder::with(&[]);
    let text = "+--[ ]( start )( )( run )--+\n";
    expect![[r#"
        exit status 0
        -- stdout
        +--[ ]( start )----------------------------------------------------( )( run )--+
        -- stderr
        fixed <stdin>:1:15 missing-wire: Insert wire
        Checked 1 file: no errors found. Fixed 1 finding.
    "#]]
    .assert_eq(&check(&folder, &["--fix", "-"], text).to_string());
    // What cannot be fixed, and what need not be, comes back as it is.
    let run = check(
        &folder,
        &["--fix", "--format", "concise", "-"],
        "+--<JMP>( done )--+\r\n",
    );
    assert_eq!(
        (run.status, run.stdout.as_str()),
        (Some(1), "+--<JMP>( done )--+\r\n"),
        "{run}"
    );
    let run = check(&folder, &["--fix", "-"], CROOKED);
    assert_eq!(run.stdout, CROOKED, "{run}");
}

#[test]
fn scenarios() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let text = "program motor.clad\nstep 10ms\n\nscenario \"it runs\"\nstrat  _-\nrun => _-\n";
    let run = check(
        &folder,
        &[
            "--format",
            "concise",
            "--stdin-filename",
            "motor.ladder-test",
            "-",
        ],
        text,
    );
    assert_eq!(run.status, Some(1), "{run}");
    assert!(
        run.stdout
            .starts_with("motor.ladder-test:5:1: error[bad-scenario]"),
        "{run}"
    );
}

#[test]
fn what_is_excluded_is_passed_over_where_that_is_wanted() {
    let folder = Folder::with(&[
        ("ladder.toml", "[workspace]\nexclude = [\"old/\"]\n"),
        ("old/b.clad", ERROR),
    ]);
    let named = ["--stdin-filename", "old/a.clad", "-"];
    assert_eq!(check(&folder, &named, ERROR).status, Some(1));
    let run = check(&folder, &[&["--force-exclude"], &named[..]].concat(), ERROR);
    assert_eq!(run.to_string(), "exit status 0\n");
    let run = check(
        &folder,
        &[&["--force-exclude", "--fix"], &named[..]].concat(),
        ERROR,
    );
    assert_eq!(run.stdout, ERROR);
    // A file that a hook names is a file like that.
    assert_eq!(folder.ladder(&["check", "old/b.clad"]).status, Some(1));
    let run = folder.ladder(&["check", "--force-exclude", "old/b.clad"]);
    assert_eq!(run.to_string(), "exit status 0\n");
}

#[test]
fn what_cannot_be() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    check(&folder, &["-", "a.clad"], "")
        .refused_with("`-` (stdin) cannot be given together with other paths");
    check(&folder, &["--stdin-filename", "a.clad", "a.clad"], "")
        .refused_with("--stdin-filename needs `-` as the path, which reads stdin");
    check(&folder, &["--watch", "-"], "")
        .refused_with("`-` (stdin) cannot be watched; name a file or folder");
    let run = folder.run(env!("CARGO_BIN_EXE_ladder"), &["check", "-"], b"\xFF", &[]);
    run.refused_with(
        "<stdin>: the file is not UTF-8: byte 16#FF at line 1, column 1; save it as UTF-8 in your editor",
    );
}
