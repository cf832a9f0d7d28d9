//! `ladder online`: a program of ours that runs is the controller that is watched.
#![cfg(all(feature = "run", unix))]

use crate::harness::Folder;
use crate::real_time::Running;
use expect_test::expect;

const PRESS: &str = "VAR_INPUT\n    start AT %IX0.0 : BOOL;\n    stop AT %IX0.1 : BOOL;\n    level AT %IW3 : INT;\nEND_VAR\nVAR_OUTPUT\n    run AT %QX0.0 : BOOL;\n    high AT %QX0.1 : BOOL;\n    spare : BOOL;\nEND_VAR\n\n\
    +--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n\
    +--[GT]( level, 50 )--[ ]( spare )--( )( high )-+\n";

/// A press that runs and serves its tags, and what its address is.
fn press(files: &[(&str, &str)]) -> (Folder, Running, String) {
    let served = [
        ("press.clad", PRESS),
        ("ladder.toml", "[serve.modbus]\nlisten = \"127.0.0.1:0\"\n"),
    ];
    let folder = Folder::with(&[&served, files].concat());
    let mut press = Running::new(
        &folder,
        &["run", "press.clad", "--set", "start=1", "--set", "level=70"],
    );
    let source = format!("modbus:{}", press.address());
    (folder, press, source)
}

/// What differs from run to run is taken out.
fn shown(text: &str, source: &str) -> String {
    let mut shown = text.replace(source, "SOURCE");
    while let Some(at) = shown
        .find("values ")
        .filter(|at| !shown[*at..].starts_with("values OLD"))
    {
        let end = shown[at..]
            .find(" old")
            .map_or(shown.len(), |end| at + end + " old".len());
        shown.replace_range(at..end, "values OLD");
    }
    shown
}

#[test]
fn one_reading_shows_the_power_and_says_why() {
    let (folder, _press, source) = press(&[]);
    let once = folder.ladder(&["online", "press.clad", "--from", &source, "--once"]);
    assert_eq!(once.status, Some(0), "{once}");
    expect![[""]].assert_eq(&shown(&once.stdout, &source));
    let why = folder.ladder(&[
        "online",
        "press.clad",
        "--from",
        &source,
        "--once",
        "--why",
        "run",
        "--tags-out",
        "values.csv",
    ]);
    assert_eq!(why.status, Some(0), "{why}");
    expect![[""]].assert_eq(&shown(&why.stdout, &source));
    expect![[""]].assert_eq(&folder.read("values.csv"));
    let later = folder.ladder(&["why", "press.clad", "high", "--tags", "values.csv"]);
    expect![[""]].assert_eq(later.stdout.lines().next().unwrap_or_default());
}

#[test]
fn a_controller_with_another_program_is_told() {
    let other = PRESS.replace("[/]( stop )", "[ ]( stop )");
    let (folder, _press, source) = press(&[("other.clad", &other)]);
    let once = folder.ladder(&[
        "online",
        "other.clad",
        "--from",
        &source,
        "--once",
        "--why",
        "run",
    ]);
    assert_eq!(once.status, Some(1), "{once}");
    expect![[""]].assert_eq(&shown(&once.stdout, &source));
}

#[test]
fn what_was_recorded_is_played() {
    let (folder, _press, source) = press(&[]);
    let recorded = folder.ladder(&[
        "online",
        "press.clad",
        "--from",
        &source,
        "--record",
        "night.csv",
        "--for",
        "500ms",
    ]);
    assert_eq!(recorded.status, Some(0), "{recorded}");
    let text = folder.read("night.csv");
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(
        rows[..2],
        ["run,high,start,stop,level", "TRUE,FALSE,TRUE,FALSE,70"],
        "{text}"
    );
    assert!(
        rows.len() > 2 && rows[2..].iter().all(|row| *row == ",,,,"),
        "{text}"
    );
    let played = folder.ladder(&[
        "sim",
        "press.clad",
        "--inputs",
        "night.csv",
        "--scans",
        "1",
        "--watch",
        "run,level",
    ]);
    expect![[r#"
        scan,time_ms,run,level
        0,0,1,70
    "#]]
    .assert_eq(&played.stdout);
}

#[test]
fn what_cannot_be_watched_is_refused() {
    let folder = Folder::with(&[
        ("press.clad", PRESS),
        ("plain.clad", "+--[ ]( a )--( )( b )--+\n"),
        ("own/press.clad", PRESS),
        (
            "own/ladder.toml",
            "[online]\nmodbus = \"127.0.0.1:1\"\nlogix = \"h\"\nwords = \"odd\"\n",
        ),
        ("map/press.clad", PRESS),
        (
            "map/ladder.toml",
            "[online]\nmodbus = \"127.0.0.1:1\"\n[online.map]\n\"holding 3\" = \"nothing\"\n",
        ),
    ]);
    let refused = |arguments: &[&str]| {
        let run = folder.ladder(&[&["online"], arguments].concat());
        assert_eq!(run.status, Some(2), "{run}");
        run.stderr
    };
    let all = [
        refused(&["press.clad", "--once"]),
        refused(&["press.clad", "--once", "--from", "10.0.0.5"]),
        refused(&["press.clad", "--from", "modbus:127.0.0.1:1"]),
        refused(&["press.clad", "--once", "--from", "modbus:127.0.0.1:1"]),
        refused(&["plain.clad", "--once", "--from", "modbus:127.0.0.1:1"]),
        refused(&["press.clad", "--once", "--from", "logix:1.2.3.4/x"]),
        refused(&["own/press.clad", "--once"]),
        refused(&["map/press.clad", "--once"]),
    ];
    expect![[""]].assert_eq(&all.concat());
}
