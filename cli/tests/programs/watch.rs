//! `ladder check --watch` and `ladder test --watch`, as a process whose output is read while it runs.

use crate::harness::{Folder, MOTOR};
use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStderr, ChildStdout, Stdio};

const ERROR: &str = "+--[ ]( start )--<JMP>( finish )--+\n";

/// A watch, ended with the value.
struct Watch {
    child: Child,
    stdout: BufReader<ChildStdout>,
    stderr: BufReader<ChildStderr>,
}

impl Watch {
    fn start(folder: &Folder, arguments: &[&str]) -> Watch {
        let arguments = [arguments, &["--watch"]].concat();
        let mut child = folder
            .command(env!("CARGO_BIN_EXE_ladder"), &arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        Watch {
            stdout: BufReader::new(child.stdout.take().unwrap()),
            stderr: BufReader::new(child.stderr.take().unwrap()),
            child,
        }
    }

    /// The next line of stdout, as soon as it is there.
    fn line(&mut self) -> String {
        let mut line = String::new();
        self.stdout.read_line(&mut line).unwrap();
        line.trim_end().to_owned()
    }

    /// Reads until the command says that it waits.
    fn waits(&mut self) -> String {
        let mut line = String::new();
        self.stderr.read_line(&mut line).unwrap();
        line.trim_end().to_owned()
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn every_change_is_checked() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    let mut watch = Watch::start(&folder, &["check", "--format", "concise", "."]);
    assert_eq!(watch.line(), "Checked 1 file: no errors found.");
    assert_eq!(watch.waits(), "note: watching 1 program; Ctrl-C ends this");

    folder.write("a.clad", ERROR.as_bytes());
    assert_eq!(
        watch.line(),
        "a.clad:1:25: error[unknown-label] there is no label `finish` to jump to"
    );
    assert_eq!(watch.line(), "Checked 1 file: 1 error.");
    watch.waits();

    folder.write("line/b.clad", MOTOR.as_bytes());
    watch.line();
    assert_eq!(watch.line(), "Checked 2 files: 1 error.");
    assert_eq!(watch.waits(), "note: watching 2 programs; Ctrl-C ends this");

    // An error in the settings is reported, and the watch goes on.
    folder.write("ladder.toml", b"[lint]\nunknown-label = 3\n");
    assert!(watch.waits().starts_with("error"), "the settings are refused");
    while !watch.waits().starts_with("note: watching") {}
    folder.write("ladder.toml", b"[lint]\nunknown-label = \"off\"\n");
    assert_eq!(watch.line(), "Checked 2 files: no errors found.");
}

#[test]
fn each_round_is_a_document_for_machines() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    let mut watch = Watch::start(&folder, &["check", "--format", "json", "a.clad"]);
    assert_eq!(watch.line(), "[]");
    watch.waits();
    folder.write("a.clad", ERROR.as_bytes());
    assert_eq!(watch.line(), "[");
    assert!(watch.line().contains("\"rule\":\"unknown-label\""));
    assert_eq!(watch.line(), "]");
}

#[test]
fn a_reader_that_goes_away_ends_it() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    let mut watch = Watch::start(&folder, &["check", "a.clad"]);
    watch.line();
    watch.waits();
    let Watch { child, stdout, .. } = &mut watch;
    // Nobody reads this end any more.
    let closed = std::mem::replace(stdout, BufReader::new(spare_pipe(&folder)));
    drop(closed);
    folder.write("a.clad", ERROR.as_bytes());
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

/// The output of a program that has ended.
fn spare_pipe(folder: &Folder) -> ChildStdout {
    let mut child = folder
        .command(env!("CARGO_BIN_EXE_ladder"), &["--version"])
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.wait().unwrap();
    child.stdout.take().unwrap()
}

#[test]
fn what_is_not_there_cannot_be_watched() {
    let folder = Folder::with(&[]);
    folder
        .ladder(&["check", "--watch", "motor.clad"])
        .refused_with("motor.clad: no such file or folder");
    let run = folder.ladder(&["check", "--watch", "--fix", "motor.clad"]);
    assert_eq!(run.status, Some(2));
    assert!(
        run.stderr.contains("'--watch' cannot be used with '--fix'"),
        "{run}"
    );
}

const PRESSED: &str = "program motor.clad\nscenario \"pressed\"\nstart _-_\nrun => _--\n";

#[test]
fn every_change_is_tested() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("motor.ladder-test", PRESSED)]);
    let mut watch = Watch::start(&folder, &["test", "motor.ladder-test"]);
    let is_waiting = "note: watching 1 file of scenarios; Ctrl-C ends this";
    assert_eq!(watch.line(), "motor.ladder-test");
    assert_eq!(watch.line(), "  ok    pressed");
    assert_eq!(watch.line(), "");
    assert!(watch.line().starts_with("1 scenario in 1 file: 1 passed, in "));
    assert_eq!(watch.waits(), is_waiting);

    // The program.
    folder.write("motor.clad", b"+--[ ]( start )--( )( run )--+\n");
    assert_eq!(watch.line(), "motor.ladder-test");
    assert_eq!(watch.line(), "  FAIL  pressed");
    while !watch
        .line()
        .starts_with("1 scenario in 1 file: 0 passed, 1 failed")
    {}
    assert_eq!(watch.waits(), is_waiting);

    // The scenario; now it names a program that is not there, which then comes.
    folder.write(
        "motor.ladder-test",
        PRESSED.replace("motor.clad", "other.clad").as_bytes(),
    );
    while !watch.line().contains("1 file not run for errors") {}
    assert_eq!(watch.waits(), is_waiting);
    folder.write("other.clad", MOTOR.as_bytes());
    assert_eq!(watch.line(), "motor.ladder-test");
    assert_eq!(watch.line(), "  ok    pressed");
    while !watch.line().starts_with("1 scenario in 1 file: 1 passed") {}
    assert_eq!(watch.waits(), is_waiting);
}

#[test]
fn scenarios_that_are_not_there_cannot_be_watched() {
    let folder = Folder::with(&[]);
    folder
        .ladder(&["test", "--watch", "motor.ladder-test"])
        .refused_with("motor.ladder-test: no such file or folder");
}
