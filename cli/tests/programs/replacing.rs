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

/// Whether it leads somewhere or nowhere: the link stays, or a file takes its place; what it leads to is never touched.
#[cfg(unix)]
#[test]
fn nothing_is_written_through_a_link() {
    use std::os::unix::fs::symlink;
    for command in [
        &["convert", "motor.clad", "--to", "st", "-o", "out/link"][..],
        &[
            "convert",
            "motor.clad",
            "--to",
            "st",
            "--report",
            "out/link",
            "-o",
            "out/motor.st",
        ],
        &["render", "motor.clad", "--format", "svg", "-o", "out/link"],
        &["sim", "motor.clad", "--scans", "1", "-o", "out/link"],
        &["diff", "motor.clad", "other.clad", "-o", "out/link"],
    ] {
        for behind in [None, Some("1,2\n")] {
            let folder = folder();
            folder.write("other.clad", MOTOR.replace("run", "ran").as_bytes());
            std::fs::create_dir(folder.path("out")).unwrap();
            if let Some(behind) = behind {
                folder.write("behind", behind.as_bytes());
            }
            symlink("../behind", folder.path("out/link")).unwrap();
            let run = folder.ladder(command);
            assert_eq!(run.status, Some(2), "{command:?}: {run}");
            assert!(run.stderr.contains("out/link: this is a link"), "{run}");
            assert!(folder.path("out/link").is_symlink());
            let run = folder.ladder(&[command, &["--force"]].concat());
            assert_ne!(run.status, Some(2), "{command:?}: {run}");
            assert!(!folder.path("out/link").is_symlink(), "{command:?}");
            assert_eq!(folder.path("behind").exists(), behind.is_some(), "{command:?}");
            assert!(
                behind.is_none_or(|behind| folder.read("behind") == behind),
                "{command:?}"
            );
        }
    }
}

/// The files of a project, and what belongs next to a program.
#[cfg(unix)]
#[test]
fn a_project_stays_in_its_folder() {
    use std::os::unix::fs::symlink;
    let folder = folder();
    std::fs::create_dir(folder.path("elsewhere")).unwrap();
    std::fs::create_dir(folder.path("out")).unwrap();
    symlink("../elsewhere/motor.h", folder.path("out/motor.h")).unwrap();
    let run = folder.ladder(&["convert", "motor.clad", "--to", "c", "-o", "out/"]);
    run.refused_with(
        "out/motor.h: this is a link, and nothing is written through it; name another file, or end with --force, which replaces the link",
    );
    assert!(!folder.path("out/motor.c").exists() && !folder.path("elsewhere/motor.h").exists());
    let run = folder.ladder(&["convert", "motor.clad", "--to", "c", "-o", "out/", "--force"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(!folder.path("out/motor.h").is_symlink() && !folder.path("elsewhere/motor.h").exists());
    assert!(folder.read("out/motor.c").contains("#include \"motor.h\""));
    let run = folder.ladder(&["convert", "motor.clad", "--to", "c", "-o", "out/other.c"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(
        folder.read("out/other.c").contains("#include \"other.h\"") && folder.path("out/other.h").exists()
    );
}

#[test]
fn a_recording_replaces_recordings_only() {
    let folder = folder();
    let mirror = |name: &str| {
        let run = folder.run(env!("CARGO_BIN_EXE_ladder"), &["lsp", "--mirror", name], b"", &[]);
        (run.status, run.stderr)
    };
    let (status, told) = mirror("motor.clad");
    assert_eq!(status, Some(2));
    assert!(
        told.contains("it holds something else, and stays as it is"),
        "{told}"
    );
    assert_eq!(folder.read("motor.clad"), MOTOR);
    for _ in 0..2 {
        assert_eq!(mirror("session.rec").0, Some(1));
        assert!(folder.read("session.rec").starts_with("ladder lsp recording 1\n"));
    }
    #[cfg(unix)]
    for target in ["nowhere.rec", "session.rec"] {
        let before = folder.path("session.rec").metadata().unwrap().modified().unwrap();
        std::os::unix::fs::symlink(target, folder.path(&format!("to-{target}"))).unwrap();
        let (status, told) = mirror(&format!("to-{target}"));
        assert_eq!(status, Some(2), "{told}");
        assert!(
            told.contains("it is a link, and nothing is written through it"),
            "{told}"
        );
        assert!(!folder.path("nowhere.rec").exists());
        assert_eq!(
            folder.path("session.rec").metadata().unwrap().modified().unwrap(),
            before
        );
    }
}
