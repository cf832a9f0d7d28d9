//! `ladder online`: a program of ours that runs is the controller that is watched.
#![cfg(all(feature = "run", unix))]

use crate::harness::Folder;
use crate::real_time::Running;
use expect_test::expect;
use std::time::{Duration, Instant};

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
    expect![[r#"
        SOURCE: READ ONLY; values OLD

        │     start     stop                                                    run   │
        ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
        │  ┃   run   ┃                                                                │
        │  ┗━━┥━━━┝━━┛                                                                │

        │     70                                                                      │
        │    level    spare                                                    high   │
        ┝━━━━┥━>━┝━━━━┥   ├────────────────────────────────────────────────────(   )──┤
        │     50                                                                      │

        not known, because a value that they need was not read: the rungs in line 14
    "#]]
    .assert_eq(&shown(&once.stdout, &source));
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
    expect![[r#"
        SOURCE: READ ONLY; values OLD

        run is 1: line 12, ( )( run ) writes 1; power came through [ ]( start ) (line 12, column 7): start is 1, [/]( stop ) (line 12, column 24): stop is 0
          start is 1: it is an input
          stop is 0: it is an input

        │     start     stop                                                    run   │
        ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
        │  ┃   run   ┃                                                                │
        │  ┗━━┥━━━┝━━┛                                                                │

        not known, because a value that they need was not read: the rungs in line 14
    "#]].assert_eq(&shown(&why.stdout, &source));
    expect![[r#"
        name,value
        start,TRUE
        stop,FALSE
        level,70
        run,TRUE
        high,FALSE
    "#]]
    .assert_eq(&folder.read("values.csv"));
    let later = folder.ladder(&["why", "press.clad", "high", "--tags", "values.csv"]);
    expect!["high is 0, as far as the table goes: line 14, ( )( high ) writes 0; blocked by [ ]( spare ) (line 14, column 23): spare is 0"].assert_eq(later.stdout.lines().next().unwrap_or_default());
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
    expect![[r#"
        SOURCE: READ ONLY; values OLD; 1 value is against the program

        run is 1, against the program: line 12, ( )( run ) writes 0; blocked by [ ]( stop ) (line 12, column 24): stop is 0
          stop is 0: it is an input

        │     start     stop                                                    run   │
        ┝━━┳━━┥━━━┝━━┳━━┥   ├──────────────────────────────────────────────────(   )──┤
        │  ┃   run   ┃                                                                │
        │  ┗━━┥━━━┝━━┛                                                                │

        not known, because a value that they need was not read: the rungs in line 14

        line 12: run is not what this rung makes it: something else writes it, or the controller runs another program
    "#]].assert_eq(&shown(&once.stdout, &source));
}

#[test]
fn one_reading_ends_though_values_change_all_the_time() {
    let program = "VAR_INPUT\n    i AT %IX0.0 : BOOL;\nEND_VAR\nVAR_OUTPUT\n    o AT %QX0.0 : BOOL;\nEND_VAR\n+--[ ]( i )--( )( o )--+\n";
    let plant = "VAR_OUTPUT\n    i : BOOL;\nEND_VAR\n+--[/]( i )--( )( i )--+\n";
    let settings = "[simulate]\ninterval = \"1ms\"\n[serve.modbus]\nlisten = \"127.0.0.1:0\"\n";
    let folder = Folder::with(&[
        ("blink.clad", program),
        ("hand.clad", plant),
        ("ladder.toml", settings),
    ]);
    let mut blink = Running::new(&folder, &["run", "blink.clad", "--plant", "hand.clad"]);
    let source = format!("modbus:{}", blink.address());
    let begun = Instant::now();
    for _ in 0..5 {
        let once = folder.ladder(&["online", "blink.clad", "--from", &source, "--once"]);
        assert!(once.status == Some(0) || once.status == Some(1), "{once}");
    }
    assert!(begun.elapsed() < Duration::from_secs(60), "{:?}", begun.elapsed());
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
        ["start,stop,level,run,high", "TRUE,FALSE,70,TRUE,FALSE"],
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
    expect![[r#"
        error: which controller? Write --from logix:192.168.1.10/0 or --from modbus:192.168.1.20:502, or put [online] into ladder.toml
        error: --from: 10.0.0.5 is not a controller: write logix:ADDRESS/SLOT as in logix:192.168.1.10/0, or modbus:HOST:PORT as in modbus:192.168.1.10:502
        error: say what is to be done: --once writes the diagram with its power, --record FILE.csv records; on a terminal it is shown live
        error: the controller cannot be reached at 127.0.0.1:1: Connection refused (os error 111)
        error: nothing is known to be at any place of the controller: no tag has a direct address such as %QX0.0, and [online.map] in ladder.toml names none
        error: "1.2.3.4/x" is not the address of a Logix controller (what follows the host is neither a slot nor a route): write HOST/SLOT, as 10.0.0.5/0 for the processor in slot 0, or a route as 10.0.0.5/bp/1/enet/10.1.1.1/bp/0
        error: own/ladder.toml:1:1: a program is watched on one controller: write `logix` or `modbus`
        own/ladder.toml:4:9: `odd` is not one of them: known here are big, little
        error: map/ladder.toml:4:1: there is no tag `nothing` in this program
    "#]].assert_eq(&all.concat());
}
