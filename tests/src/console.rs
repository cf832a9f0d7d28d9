//! Sessions at a terminal, as the book shows them: what a person types after `$ `, and what they see.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// Runs what is typed in a session, in a folder, and returns the session as it really goes: standard output and
/// standard error as they come, commands as they were written. `programs` is the folder where `ladder` and `ldfmt`
/// are found.
pub fn replay(session: &str, folder: &Path, programs: &Path) -> String {
    let mut out = String::new();
    let mut status = 0;
    for command in session.lines().filter_map(|line| line.strip_prefix("$ ")) {
        let ran = run(command, status, folder, programs);
        status = ran.status;
        // Writing to a String does not fail.
        let _ = write!(out, "$ {command}\n{}", without_times(&ran.shown));
        if !out.ends_with('\n') {
            out.push('\n');
        }
    }
    out
}

/// How long something took differs from run to run: `2 passed, in 0.07 s.`
fn without_times(shown: &str) -> String {
    let lines = shown.split_inclusive('\n').map(|line| {
        let time = line
            .trim_end()
            .strip_suffix(" s.")
            .and_then(|line| line.rsplit_once(", in "));
        match time {
            Some((before, seconds)) if seconds.parse::<f64>().is_ok() => format!("{before}, in 0.01 s.\n"),
            _ => line.to_owned(),
        }
    });
    lines.collect()
}

struct Ran {
    shown: String,
    status: i32,
}

/// `status` is that of the command before: `echo $?` shows it.
fn run(command: &str, status: i32, folder: &Path, programs: &Path) -> Ran {
    let path = std::env::var("PATH").unwrap_or_default();
    let output = Command::new("sh")
        .arg("-c")
        .arg(format!("exec 2>&1; (exit {status}); {command}"))
        .current_dir(folder)
        .env("PATH", format!("{}:{path}", programs.display()))
        .env("NO_COLOR", "1")
        // The width that help and messages are wrapped to is that of a common terminal.
        .env("COLUMNS", "100")
        .output()
        .unwrap_or_else(|error| panic!("sh: {error}"));
    Ran {
        shown: String::from_utf8_lossy(&output.stdout).into_owned(),
        status: output.status.code().unwrap_or(-1),
    }
}
