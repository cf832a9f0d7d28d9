//! What the commands take from `ladder.toml`.

use crate::harness::{CROOKED, Folder, MOTOR};
use expect_test::expect;

const SPACED: &str = "\
+----\\----[ ]( start )----\\----[/]( stop )-----------------------( )( run )----+
|    /----[ ]( run )------/                                                    |
";

#[test]
fn the_formatter_takes_width_and_spacing() {
    let folder = Folder::with(&[
        ("ladder.toml", "[format]\nspacing = 4\n"),
        ("sub/a.clad", CROOKED),
    ]);
    expect![[r#"
        exit status 0
    "#]]
    .assert_eq(&folder.ldfmt(&["sub/a.clad"]).to_string());
    assert_eq!(folder.read("sub/a.clad"), SPACED);
    let named = ["-", "--stdin-filename", "sub/new.clad"];
    assert_eq!(folder.ldfmt_stdin(&named, CROOKED.as_bytes()).stdout, SPACED);
    // Without a name stdin is a file of the current folder.
    assert_eq!(folder.ldfmt_stdin(&["-"], CROOKED.as_bytes()).stdout, SPACED);
}

/// One blank where two would be by default: in the fix that is shown, and in the one that is made.
#[test]
fn fixes_are_laid_out_as_the_workspace_asks() {
    let folder = Folder::with(&[
        ("ladder.toml", "[format]\nspacing = 1\n"),
        (
            "sub/a.clad",
            "+-[ ]( a )-[TNO]( t, 5s )--------------( )( y )-+\n",
        ),
    ]);
    let laid_out = "+-[ ]( a )---------------------------------------------[TON]( t, 5s )-( )( y )-+\n";
    let shown = folder.ladder(&["check", "sub/a.clad"]).stdout;
    assert!(shown.contains(laid_out), "{shown}");
    folder.ladder(&["check", "--fix", "--unsafe-fixes", "sub/a.clad"]);
    assert_eq!(folder.read("sub/a.clad"), laid_out);
}

#[test]
fn the_simulator_takes_the_interval_and_the_watchdog() {
    let folder = Folder::with(&[
        ("ladder.toml", "[simulate]\ninterval = \"50ms\"\nwatchdog = 1\n"),
        ("slow.clad", "+--( )( run )--+\n"),
        ("sub/ladder.toml", "[simulate]\nwatchdog = 1\n"),
        ("sub/busy.clad", "+--( )( run )--+\n+--( )( on )--+\n"),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,run
        0,0,1
        1,50,1
    "#]]
    .assert_eq(&folder.ladder(&["sim", "slow.clad", "--scans", "2"]).to_string());
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,run
        0,0,1
        1,20,1
    "#]]
    .assert_eq(
        &folder
            .ladder(&["sim", "slow.clad", "--scans", "2", "--dt", "20ms"])
            .to_string(),
    );
    expect![[r#"
        exit status 1
        -- stdout
        scan,time_ms,on,run
        -- stderr
        sub/busy.clad:2:4: fault in scan 0: this scan has evaluated more than 1 blocks, so the watchdog stopped the simulation here; look for a jump or loop that does not end
    "#]]
    .assert_eq(
        &folder
            .ladder(&["sim", "sub/busy.clad", "--scans", "2"])
            .to_string(),
    );
}

#[test]
fn a_broken_settings_file_is_reported_once() {
    let broken = [
        ("ladder.toml", "[format]\nwith = 3\n"),
        ("a.clad", MOTOR),
        ("b.clad", CROOKED),
    ];
    let folder = Folder::with(&broken);
    let message = "ladder.toml:2:1: `with` is not a setting in [format]: did you mean `width`?";
    folder.ldfmt(&["."]).refused_with(message);
    folder
        .ldfmt_stdin(&["-"], CROOKED.as_bytes())
        .refused_with(message);
    folder
        .ladder(&["sim", "a.clad", "--scans", "1"])
        .refused_with(message);
    assert_eq!(folder.read("b.clad"), CROOKED);
}

#[test]
fn check_shows_what_is_wrong_in_them_with_its_lines() {
    let folder = Folder::with(&[
        ("ladder.toml", "[format]\nwith = 120\nspacing = 0\n"),
        ("a.clad", "+--[ ]( a )--( )( y )--+\n"),
    ]);
    let run = folder.ladder(&["check", "a.clad"]);
    assert_eq!(run.status, Some(2), "{run}");
    assert_eq!(
        run.stderr,
        "\
error[bad-setting]: `with` is not a setting in [format]: did you mean `width`?
 --> ladder.toml:2:1
  |
2 | with = 120
  | ^^^^

error[bad-setting]: a whole number from 1 to 40 is expected here
 --> ladder.toml:3:11
  |
3 | spacing = 0
  |           ^
"
    );
}

#[test]
fn settings_that_cannot_be_used_are_refused_by_every_command() {
    let scenarios = "program a.clad\nstep 10ms\n\nproperty \"p\"\nnever stop and run\n";
    let folder = Folder::with(&[
        ("ladder.toml", "[simulate]\ninterval = 7\n"),
        ("a.clad", MOTOR),
        ("a.ladder-test", scenarios),
        ("values.csv", "start,1\n"),
    ]);
    let check = |command: &str, message: &str| {
        let arguments: Vec<&str> = command.split(' ').collect();
        let run = folder.ladder(&arguments);
        assert_eq!(run.status, Some(2), "{command}\n{run}");
        assert!(run.to_string().contains(message), "{command}\n{run}");
    };
    for command in [
        "check a.clad",
        "fmt a.clad",
        "test a.ladder-test",
        "prove a.ladder-test",
        "sim a.clad --scans 1",
        "diff a.clad a.clad",
        "render a.clad",
        "convert a.clad --to st -o a.st",
        "why a.clad run --tags values.csv",
        "tags a.clad",
    ] {
        check(command, "ladder.toml:2:12");
    }
    folder.write("ladder.toml", "#".repeat((1 << 20) + 1).as_bytes());
    check(
        "tags a.clad",
        "a ladder.toml has at most 1 MiB, and this one is larger",
    );
}
