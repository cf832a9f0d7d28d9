//! Files and folders that cannot be used: one message that names them, exit status 2, nothing written.

use crate::harness::{CROOKED, Folder, MOTOR};
use std::fs::File;

/// Every way to hand a file to a program.
const COMMANDS: [&[&str]; 5] = [
    &["check"],
    &["fmt"],
    &["fmt", "--check"],
    &["sim", "--scans", "1"],
    &["tree"],
];

fn each_command_refuses(folder: &Folder, path: &str, message: &str) {
    for command in COMMANDS {
        folder.ladder(&[command, &[path]].concat()).refused_with(message);
    }
    folder.ldfmt(&[path]).refused_with(message);
}

#[test]
fn a_missing_file() {
    let folder = Folder::with(&[]);
    each_command_refuses(&folder, "motor.clad", "motor.clad: no such file or folder");
    assert!(folder.names().is_empty());
}

#[test]
fn standard_input_where_it_is_not_read() {
    let folder = Folder::with(&[]);
    for command in [&["sim", "--scans", "1"][..], &["test"], &["render"], &["tree"]] {
        folder.ladder(&[command, &["-"]].concat()).refused_with(
            "-: no such file or folder; of standard input only `ladder check -` and `ladder fmt -` read a program",
        );
    }
}

#[test]
fn scenarios_where_a_program_is_needed() {
    let folder = Folder::with(&[("a.ladder-test", "program a.clad\n")]);
    folder
        .ladder(&["sim", "a.ladder-test", "--scans", "1"])
        .refused_with(
            "a.ladder-test: this file has scenarios, no program; `ladder test a.ladder-test` runs them",
        );
}

#[test]
fn values_that_are_no_values() {
    let folder = Folder::with(&[("a.clad", MOTOR), ("a.ladder-test", "program a.clad\n")]);
    for scans in ["many", "1.5", "-1", "1e9"] {
        let run = folder.ladder(&["sim", "a.clad", "--scans", scans]);
        assert_eq!(run.status, Some(2), "{run}");
        assert!(run.stderr.contains("write a whole number, such as 100"), "{run}");
    }
    folder
        .ladder(&["sim", "a.clad", "--scans", "1", "--watch", "run,,stop"])
        .refused_with("--watch: a name is missing; write the tags as in --watch run,warmup.ET");
    folder
        .ladder(&["test", "a.ladder-test", "--coverage-output", "-"])
        .refused_with("--coverage-output needs a file: stdout has the results");
    assert_eq!(folder.names(), ["a.clad", "a.ladder-test"]);
}

#[test]
fn a_file_that_is_not_utf_8() {
    let folder = Folder::with(&[]);
    let text = b"+--( )( a )--+\n# \xDCberlauf #\n";
    folder.write("old.clad", text);
    each_command_refuses(
        &folder,
        "old.clad",
        "old.clad: the file is not UTF-8: byte 16#DC at line 2, column 3; save it as UTF-8 in your editor",
    );
    assert_eq!(std::fs::read(folder.path("old.clad")).unwrap(), text);
}

#[test]
fn a_file_past_the_size_limit() {
    let folder = Folder::with(&[]);
    // Sparse: it takes no room on the disk.
    let file = File::create(folder.path("big.clad")).unwrap();
    file.set_len((64 << 20) + 1).unwrap();
    each_command_refuses(
        &folder,
        "big.clad",
        "big.clad: the file is larger than 64 MiB, the most that is read",
    );
}

#[test]
fn a_folder_without_programs() {
    let folder = Folder::with(&[("plant/notes.txt", "")]);
    let message = "plant: no program (a file ending in .clad or .st) is in this folder";
    folder.ladder(&["check", "plant"]).refused_with(message);
    let message = "plant: no program (a file ending in .clad) is in this folder";
    folder.ladder(&["fmt", "plant"]).refused_with(message);
    folder.ldfmt(&["--check", "plant"]).refused_with(message);
    for command in ["sim", "tree"] {
        folder
            .ladder(&[command, "plant"])
            .refused_with("plant: this is a folder; name a file in it");
    }
}

#[test]
fn a_bad_file_among_good_ones_is_named_and_the_others_are_done() {
    let folder = Folder::with(&[("crooked.clad", CROOKED), ("motor.clad", MOTOR)]);
    folder.write("old.clad", b"\xFF");
    let run = folder.ldfmt(&[".", "missing.clad"]);
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("error: missing.clad: no such file"), "{run}");
    assert!(
        run.stderr.contains("error: old.clad: the file is not UTF-8"),
        "{run}"
    );
    assert_eq!(folder.read("crooked.clad"), MOTOR);

    let run = folder.ladder(&["check", "."]);
    assert_eq!(run.status, Some(2));
    assert_eq!(run.stdout, "Checked 2 files: no errors found.\n");
}

#[cfg(unix)]
#[test]
fn stdout_that_takes_nothing_is_an_error() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let full = File::options().write(true).open("/dev/full").unwrap();
    let output = folder
        .command(env!("CARGO_BIN_EXE_ladder"), &["tree", "motor.clad"])
        .stdout(full)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.starts_with("error: the output cannot be written: "),
        "{message}"
    );
}
