//! What a workspace names, and where it may lie.
#![cfg(unix)]

use crate::harness::{Folder, MOTOR};
use expect_test::expect;
use std::os::unix::fs::symlink;
use std::process::Command;

fn scenarios(program: &str) -> String {
    format!("program \"{program}\"\nstep 10ms\n\nscenario \"one\"\nstart -\nrun => -\n")
}

fn pipe(folder: &Folder, name: &str) {
    let made = Command::new("mkfifo").arg(folder.path(name)).status().unwrap();
    assert!(made.success());
}

#[test]
fn scenarios_stay_in_their_workspace() {
    let folder = Folder::with(&[
        ("plant/ladder.toml", ""),
        ("plant/motor.clad", MOTOR),
        ("plant/tests/motor.ladder-test", &scenarios("../motor.clad")),
        ("secret.clad", MOTOR),
        ("plant/tests/out.ladder-test", &scenarios("../../secret.clad")),
        ("plant/tests/link.ladder-test", &scenarios("link.clad")),
        ("plant/tests/pipe.ladder-test", &scenarios("pipe.clad")),
        ("plant/tests/zero.ladder-test", &scenarios("/dev/zero")),
    ]);
    symlink("../../secret.clad", folder.path("plant/tests/link.clad")).unwrap();
    pipe(&folder, "plant/tests/pipe.clad");
    let run = folder.ladder(&["test", "plant/tests/motor.ladder-test"]);
    assert_eq!(run.status, Some(0), "{run}");
    expect![[r#"
        exit status 2
        -- stdout
        error[bad-scenario]: plant/tests/../../secret.clad: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
         --> plant/tests/out.ladder-test:1:9
          |
        1 | program "../../secret.clad"
          |         ^^^^^^^^^^^^^^^^^^^
          |
          = help: a program is named as it is seen from the folder of the scenario file

        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&folder.ladder(&["check", "plant/tests/out.ladder-test"]).to_string());
    for (name, sentence) in [
        ("out", "this leads out of the workspace"),
        ("link", "this leads out of the workspace"),
        ("pipe", "this is a pipe, and only a regular file is used here"),
        ("zero", "a path in a workspace is relative"),
    ] {
        for command in ["test", "check"] {
            let run = folder.ladder(&[command, &format!("plant/tests/{name}.ladder-test")]);
            assert_eq!(run.status, Some(2), "{run}");
            assert!(run.to_string().contains(sentence), "{run}");
        }
    }
}

#[test]
fn a_search_does_not_read_or_write_what_its_links_lead_to() {
    let crooked = "+-[ ](a)-( )(y)-+\n";
    let folder = Folder::with(&[("plant/motor.clad", MOTOR), ("profile", crooked)]);
    symlink("../profile", folder.path("plant/link.clad")).unwrap();
    for command in [&["check"][..], &["fmt"], &["fmt", "--diff"]] {
        let run = folder.ladder(&[command, &["plant"]].concat());
        assert_eq!(run.status, Some(2), "{run}");
        assert!(
            run.stderr
                .starts_with("error: plant/link.clad: this leads out of the workspace"),
            "{run}"
        );
        assert!(!run.stdout.contains("( y )"), "{run}");
    }
    assert_eq!(folder.read("profile"), crooked);
    // A person may mean it.
    assert_eq!(folder.ladder(&["fmt", "plant/link.clad"]).status, Some(0));
    assert_ne!(folder.read("profile"), crooked);
}

#[test]
fn a_pipe_or_a_device_as_a_program() {
    let folder = Folder::with(&[]);
    pipe(&folder, "p.clad");
    for command in [
        &["check"][..],
        &["fmt"],
        &["sim", "--scans", "1"],
        &["tree"],
        &["render"],
    ] {
        let refused = |name: &str, what: &str| {
            let run = folder.ladder(&[command, &[name]].concat());
            run.refused_with(&format!(
                "{name}: this is a {what}, and only a regular file is used here"
            ));
        };
        refused("p.clad", "pipe");
        refused("/dev/zero", "device");
    }
}

#[test]
fn a_pipe_that_the_shell_hands_over_is_read() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let ladder = env!("CARGO_BIN_EXE_ladder");
    let line = format!("'{ladder}' sim <(cat motor.clad) --scans 1 --set start=1 --watch run");
    let output = folder.command("bash", &["-c", &line]).output().unwrap();
    assert_eq!(
        String::from_utf8_lossy(&output.stdout),
        "scan,time_ms,run\n0,0,1\n"
    );
}

#[test]
fn retain_of_the_command_line_replaces_no_file_of_others() {
    let program = "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n";
    let folder = Folder::with(&[("pump.clad", program), ("notes.txt", "mine\n")]);
    for name in ["notes.txt", "pump.clad"] {
        let before = folder.read(name);
        folder
            .ladder(&["sim", "pump.clad", "--scans", "1", "--retain", name])
            .refused_with(&format!(
                "{name}: this is not a file of retentive values, and it stays as it is; name another file, or remove this one"
            ));
        assert_eq!(folder.read(name), before);
    }
    assert_eq!(folder.names(), ["notes.txt", "pump.clad"]);
}

#[test]
fn two_runs_on_one_retentive_file() {
    let program = "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n";
    let folder = Folder::with(&[("pump.clad", program)]);
    pipe(&folder, "out");
    // It goes on for as long as nobody reads what it writes.
    let arguments = [
        "sim",
        "pump.clad",
        "--scans",
        "100000",
        "--retain",
        "pump.retain",
        "-o",
        "out",
    ];
    let mut first = folder
        .command(env!("CARGO_BIN_EXE_ladder"), &arguments)
        .spawn()
        .unwrap();
    let reader = std::fs::File::open(folder.path("out")).unwrap();
    folder
        .ladder(&["sim", "pump.clad", "--scans", "1", "--retain", "pump.retain"])
        .refused_with("pump.retain: another run uses this file; wait until that ends, or name another file");
    first.kill().unwrap();
    first.wait().unwrap();
    drop(reader);
    let run = folder.ladder(&["sim", "pump.clad", "--scans", "1", "--retain", "pump.retain"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(folder.names(), ["out", "pump.clad", "pump.retain"]);
}
