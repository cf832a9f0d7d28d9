//! What a terminal obeys instead of showing it, in programs, scenarios and the names of files: it is written out, in
//! every command and every form.
#![cfg(unix)]

use crate::harness::{Folder, Run};
use expect_test::expect;

/// A program with all kinds of them: in comments, strings, and where they are errors.
const HOSTILE: &str = "\
# \u{1b}]0;title\u{7} \u{9b}2J \u{202e}txt \u{2028}x\u{7f} #
VAR s : STRING := 'a\u{1b}[31mb'; n : INT; END_VAR
+--[ ]( a\u{1b}[2J )--[TOM\u{9b}1m]( t\u{202e} )--( )( y )--+
";
/// The same, without errors.
const HARMLESS: &str = "\
# \u{1b}]0;title\u{7} \u{9b}2J \u{202e}txt \u{2028}x\u{7f} #
VAR s : STRING := 'a\u{1b}[31mb\u{9b}c'; n : INT; END_VAR
+--[ ]( a )--[DIV]( n, 1, n )--( )( y )--# \u{1b}[1m #--+
";
/// A name with a line end in it, which would begin a command of GitHub's.
const NAME: &str = "m\n::error::x\u{1b}[2J\u{202e}.clad";
const SCENARIOS: &str = "m\n::error::x.ladder-test";

fn scenarios() -> String {
    "program h.clad\nstep 10ms\n\nscenario \"\u{1b}[2J\u{9b}x\u{202e}\"\na   -\ny => -\n\nscenario \"fails\u{1b}c\"\na   _\ny => -\ns => 'b\u{1b}'\n\n".to_owned()
}

#[track_caller]
fn is_safe(what: &str, text: &str) {
    let obeyed = |c: char| ladder_workspace::shown::is_obeyed(c) && !matches!(c, '\n' | '\t');
    assert!(!text.contains(obeyed), "{what}: {text:?}");
    let command = text.lines().find(|line| line.starts_with("::error::"));
    assert_eq!(command, None, "{what}: {text}");
}

#[track_caller]
fn both_safe(what: &str, run: &Run) {
    is_safe(what, &run.stdout);
    is_safe(what, &run.stderr);
    assert!(run.status.is_some(), "{what}: {run}");
}

#[test]
fn in_every_form() {
    let folder = Folder::with(&[(NAME, HOSTILE), ("h.clad", HARMLESS), (SCENARIOS, &scenarios())]);
    for command in [
        &["check"][..],
        &["check", "--format", "concise"],
        &["check", "--format", "json"],
        &["check", "--format", "sarif"],
        &["check", "--format", "github"],
        &["check", "--statistics"],
        &["check", "--fix", "--unsafe-fixes", "--diff"],
        &["fmt", "--check"],
        &["fmt", "--diff"],
        &["sim", "--scans", "1"],
        &["render"],
        &["tree"],
    ] {
        let run = folder.ladder(&[command, &["--", NAME]].concat());
        both_safe(&format!("{command:?}"), &run);
        both_safe(
            &format!("{command:?} gone"),
            &folder.ladder(&[command, &["--", &format!("no{NAME}")]].concat()),
        );
    }
    for format in ["full", "junit", "json", "github"] {
        let run = folder.ladder(&["test", "--coverage", "--format", format, SCENARIOS]);
        both_safe(&format!("test {format}"), &run);
        assert_eq!(run.status, Some(1), "{run}");
    }
    let run = folder.ladder(&["check", SCENARIOS, "h.clad", "."]);
    both_safe("check of all", &run);
    for format in ["csv", "json", "vcd", "svg", "diagram"] {
        let run = folder.ladder(&[
            "sim", "h.clad", "--scans", "2", "--set", "a=1", "--format", format,
        ]);
        both_safe(&format!("sim {format}"), &run);
        assert!(run.stderr.contains("fault in scan 0"), "{run}");
    }
    both_safe("explain", &folder.ladder(&["explain", "a\u{1b}[2J\nb\u{9b}"]));
    both_safe("test of a program", &folder.ladder(&["test", NAME]));
}

#[test]
fn with_colours_nothing_but_colours() {
    let folder = Folder::with(&[(NAME, HOSTILE)]);
    for arguments in [&["check", NAME][..], &["fmt", "--diff", NAME]] {
        let colours = [("CLICOLOR_FORCE", "1"), ("TERM", "xterm-256color")];
        let run = folder.run(env!("CARGO_BIN_EXE_ladder"), arguments, b"", &colours);
        for rest in run.stdout.split('\u{1b}').skip(1) {
            let (colour, _) = rest.split_once('m').expect("a colour ends");
            let digits = colour.strip_prefix('[').expect("a colour begins");
            assert!(digits.chars().all(|c| c.is_ascii_digit() || c == ';'), "{rest:?}");
        }
        assert!(
            !run.stdout.contains("\u{1b}[2J") && !run.stdout.contains('\u{9b}'),
            "{run}"
        );
    }
}

#[test]
fn settings() {
    let folder = Folder::with(&[
        (
            "ladder.toml",
            "[lint]\n\"a\\u001b[2J\\n::error::\" = \"off\"\n[simulate]\nretain = \"/\\u009b\"\n",
        ),
        ("h.clad", HARMLESS),
    ]);
    for command in [
        &["check"][..],
        &["fmt", "--check"],
        &["sim", "--scans", "1"],
        &["test"],
    ] {
        both_safe(
            &format!("{command:?}"),
            &folder.ladder(&[command, &["."]].concat()),
        );
        both_safe(
            &format!("{command:?}"),
            &folder.ladder(&[command, &["h.clad"]].concat()),
        );
    }
}

#[test]
fn how_it_looks() {
    let folder = Folder::with(&[(NAME, "+--[ ]( a\u{1b}[2J )--( )( y )--+\n")]);
    expect![[r#"
        exit status 1
        -- stdout
        m\n::error::x\u{1b}[2J\u{202e}.clad:1:10: error[unexpected-character] `\u{1b}[` means nothing among operands
        Checked 1 file: 1 error.
    "#]].assert_eq(&folder.ladder(&["check", "--format", "concise", NAME]).to_string());
    let (name, text) = ("b\nc.clad", "+-[ ]( a )-( )( y )-+ #\u{1b}[2J#\r\n");
    folder.write(name, text.as_bytes());
    expect![[r#"
        exit status 1
        -- stdout
        --- b\nc.clad
        +++ b\nc.clad
        @@ -1 +1 @@
        -+-[ ]( a )-( )( y )-+ #\u{1b}[2J#
        ++--[ ]( a )----------------------------------------------------------( )( y )--+  #\u{1b}[2J#
    "#]]
    .assert_eq(
        &folder
            .ladder(&["fmt", "--diff", name])
            .to_string()
            .replace('\r', ""),
    );
}

#[test]
fn json_means_what_it_meant() {
    let folder = Folder::with(&[("h.clad", HOSTILE)]);
    let run = folder.ladder(&["check", "--format", "json", "h.clad"]);
    let findings: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    let told = findings.to_string();
    assert!(told.contains('\u{9b}') || told.contains('\u{202e}'), "{told}");
}

#[test]
fn a_program_that_is_sent_on_is_the_one_that_is_written() {
    let hostile = "# \u{9b}2J \u{2028} \u{1b}[1m #\nstart open contact I0.1 & active coil Q0 end\n";
    let folder = Folder::with(&[("h.rung", hostile)]);
    let sent = folder.ladder(&["convert", "h.rung", "--from", "textbook"]);
    folder.ladder(&["convert", "h.rung", "--from", "textbook", "-o", "h.clad"]);
    assert_eq!(sent.stdout, folder.read("h.clad"));
    assert!(sent.stdout.contains('\u{2028}'), "{sent}");
    let told = folder.ladder(&["convert", "h.rung", "--from", "textbook", "--report", "json"]);
    is_safe("report", &told.stderr);
}
