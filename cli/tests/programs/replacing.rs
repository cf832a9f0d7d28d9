//! Output files that are there already.

use crate::harness::{Folder, MOTOR};

const PROGRAM: &str = "this is a program, and it stays as it is; name another file, or end with --force";
const NEXT_TO: &str =
    "this belongs to a program, and it stays as it is; name another file, or end with --force";
const OTHERS: &str =
    "this file is there, and no command of ladder made it; name another file, or end with --force";

const COMMANDS: &[&[&str]] = &[
    &["sim", "motor.clad", "--scans", "1", "--format", "csv", "-o"],
    &["sim", "motor.clad", "--scans", "1", "--format", "json", "-o"],
    &["sim", "motor.clad", "--scans", "1", "--format", "vcd", "-o"],
    &["sim", "motor.clad", "--scans", "1", "--format", "svg", "-o"],
    &["sim", "motor.clad", "--scans", "1", "--format", "diagram", "-o"],
    &["render", "motor.clad", "--format", "svg", "-o"],
    &["render", "motor.clad", "--format", "png", "-o"],
    #[cfg(feature = "pdf")]
    &["render", "motor.clad", "--format", "pdf", "-o"],
    &["test", "motor.ladder-test", "--coverage-output"],
];

const SCENARIOS: &str = "program motor.clad\nstep 10ms\n\nscenario \"one\"\nstart -\nrun => -\n";

fn folder() -> Folder {
    Folder::with(&[
        ("motor.clad", MOTOR),
        ("motor.ladder-test", SCENARIOS),
        ("ladder.toml", ""),
        ("notes.txt", "start,stop\n1,0\n"),
    ])
}

#[test]
fn a_program_or_a_file_of_others_stays() {
    let folder = folder();
    for &command in COMMANDS {
        for (name, sentence) in [
            ("motor.clad", PROGRAM),
            ("motor.ladder-test", NEXT_TO),
            ("ladder.toml", NEXT_TO),
            ("notes.txt", OTHERS),
        ] {
            let before = folder.read(name);
            let run = folder.ladder(&[command, &[name]].concat());
            run.refused_with(&format!("{name}: {sentence}"));
            assert_eq!(folder.read(name), before);
        }
    }
    assert_eq!(
        folder.names(),
        ["ladder.toml", "motor.clad", "motor.ladder-test", "notes.txt"]
    );
}

#[test]
fn what_a_command_made_it_makes_again() {
    let folder = folder();
    for &command in COMMANDS {
        for _ in 0..2 {
            let run = folder.ladder(&[command, &["out"]].concat());
            assert_eq!(run.status, Some(0), "{command:?}: {run}");
        }
        // Another command's file is not a file of others.
        let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "-o", "out"]);
        assert_eq!(run.status, Some(0), "{command:?}: {run}");
        std::fs::remove_file(folder.path("out")).unwrap();
    }
}

#[test]
fn manual_pages() {
    let folder = folder();
    for _ in 0..2 {
        assert_eq!(folder.ladder(&["man", "-o", "man1"]).status, Some(0));
    }
    folder.write("man1/ladder-sim.1", b"mine\n");
    let run = folder.ladder(&["man", "-o", "man1"]);
    run.refused_with(&format!("man1/ladder-sim.1: {OTHERS}"));
    assert_eq!(folder.ladder(&["man", "-o", "man1", "--force"]).status, Some(0));
}

#[test]
fn an_empty_file_holds_nothing_to_lose() {
    let folder = folder();
    folder.write("out", b"");
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "-o", "out"]);
    assert_eq!(run.status, Some(0), "{run}");
}

#[test]
fn force_replaces_it() {
    for &command in COMMANDS {
        let folder = folder();
        let run = folder.ladder(&[command, &["notes.txt", "--force"]].concat());
        assert_eq!(run.status, Some(0), "{command:?}: {run}");
        assert!(
            !std::fs::read(folder.path("notes.txt"))
                .unwrap()
                .starts_with(b"start,stop")
        );
    }
    let folder = folder();
    let run = folder.ladder(&[
        "sim",
        "motor.clad",
        "--scans",
        "1",
        "--force",
        "stop=1",
        "--watch",
        "stop",
        "-o",
        "notes.txt",
        "--force",
    ]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(folder.read("notes.txt"), "scan,time_ms,stop\n0,0,1\n");
    // In front of a name it takes the name for what is to be held.
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "--force", "stop"]);
    run.refused_with("--force stop: write it TAG=VALUE, for example start=1");
}

#[test]
fn a_picture_of_others_stays() {
    let folder = folder();
    for (name, bytes) in [
        ("photo.png", &b"\x89PNG\r\n\x1a\n"[..]),
        (
            "logo.svg",
            b"<svg xmlns=\"http://www.w3.org/2000/svg\"><title>logo</title></svg>\n",
        ),
    ] {
        folder.write(name, bytes);
        folder
            .ladder(&["render", "motor.clad", "-o", name])
            .refused_with(&format!("{name}: {OTHERS}"));
        assert_eq!(std::fs::read(folder.path(name)).unwrap(), bytes);
    }
}

#[cfg(unix)]
#[test]
fn a_program_by_another_name() {
    let folder = folder();
    std::os::unix::fs::symlink("motor.clad", folder.path("out.csv")).unwrap();
    let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", "-o", "out.csv"]);
    run.refused_with(&format!("out.csv: {PROGRAM}"));
    assert_eq!(folder.read("motor.clad"), MOTOR);
}

#[test]
fn a_recording_replaces_recordings_only() {
    let folder = folder();
    let mirror = |name: &str| {
        let run = folder.run(env!("CARGO_BIN_EXE_ladder"), &["lsp", "--mirror", name], b"", &[]);
        (run.status, run.stderr)
    };
    let (status, said) = mirror("motor.clad");
    assert_eq!(status, Some(2));
    assert!(
        said.contains("it holds something else, and stays as it is"),
        "{said}"
    );
    assert_eq!(folder.read("motor.clad"), MOTOR);
    for _ in 0..2 {
        assert_eq!(mirror("session.rec").0, Some(1));
        assert!(folder.read("session.rec").starts_with("ladder lsp recording 1\n"));
    }
}
