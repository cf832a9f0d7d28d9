//! What `ladder sim` does not run.

use crate::harness::{Folder, MOTOR};
use crate::sim::TYPES;
use expect_test::expect;

#[test]
fn a_program_with_errors_is_not_run() {
    let folder = Folder::with(&[("a.clad", "+--[TNO]( t, T#5s )--( )( run )--+\n")]);
    let run = folder.ladder(&["sim", "a.clad", "--scans", "1", "-o", "out.csv"]);
    expect![[r#"
        exit status 1
        -- stderr
        error[unknown-instruction]: there is no instruction [TNO]
         --> a.clad:1:4
          |
        1 | +--[TNO]( t, T#5s )--( )( run )--+
          |    ^^^^^
          |
          = help: did you mean [TON] (on-delay timer)?
        help: Replace with [TON]
          |
        1 - +--[TNO]( t, T#5s )--( )( run )--+
        1 + +------------------------------------------------[TON]( t, T#5s )--( )( run )--+
          |

        error: a.clad: a program with errors is not run
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.names(), ["a.clad"]);
}

/// One message, exit status 2, and no file.
fn refused(arguments: &[&str], message: &str) {
    let folder = Folder::with(&[("types.clad", TYPES)]);
    let run = folder.ladder(&[&["sim", "types.clad", "-o", "out.csv"], arguments].concat());
    run.refused_with(message);
    assert_eq!(folder.names(), ["types.clad"]);
}

#[test]
fn without_scans_it_says_what_is_missing() {
    refused(
        &[],
        "say how many scans to run, for example --scans 100; `ladder sim --help` shows more",
    );
}

#[test]
fn unknown_tags_are_refused_with_what_was_meant() {
    let scans = ["--scans", "1"];
    let with = |option: &'static str, text: &'static str| [scans[0], scans[1], option, text];
    refused(
        &with("--watch", "go,sped"),
        "--watch sped: there is no tag `sped`; did you mean speed?",
    );
    refused(
        &with("--set", "og=1"),
        "--set og=1: there is no tag `og`; did you mean go?",
    );
    refused(
        &with("--force", "pump=1"),
        "--force pump=1: there is no tag `pump` in this program",
    );
    refused(
        &with("--set", "t1=1"),
        "--set t1=1: t1 is a TON: name one of its members, as in t1.Q",
    );
    refused(
        &with("--set", "list=1"),
        "--set list=1: list is an array: name one of its elements, as in list[1]",
    );
}

#[test]
fn values_that_do_not_fit_are_refused() {
    let scans = ["--scans", "1"];
    let with = |option: &'static str, text: &'static str| [scans[0], scans[1], option, text];
    refused(
        &with("--set", "go"),
        "--set go: write it TAG=VALUE, for example start=1",
    );
    refused(
        &with("--set", "go=2"),
        "--set go=2: `2` is not a value for a BOOL: write 0, 1, TRUE or FALSE",
    );
    refused(
        &with("--force", "speed=40000"),
        "--force speed=40000: 40000 does not fit: INT holds -32768 to 32767",
    );
    refused(
        &with("--set", "limit=1"),
        "--set limit=1: limit is read-only: it cannot be given a value",
    );
    refused(
        &with("--set", "SYS.SCAN=1"),
        "--set SYS.SCAN=1: SYS.SCAN is read-only: it cannot be given a value",
    );
}

#[test]
fn a_broken_csv_is_refused_with_row_and_column() {
    for (csv, message) in [
        ("", "in.csv: the file is empty; its first line names the tags"),
        (
            "go,sped\n1,2\n",
            "in.csv: header, column 2 (`sped`): there is no tag `sped`; did you mean speed?",
        ),
        ("go,GO\n1,2\n", "in.csv: the header has `GO` in columns 1 and 2"),
        (
            "go;speed\n1;2,5\n",
            "in.csv: row 0 (line 2), column `speed`: `2,5` is not a value for an INT: write a whole number as in 42 or 16#FF",
        ),
        (
            "go,limit\n1,2\n",
            "in.csv: header, column 2 (`limit`): this tag can only be read",
        ),
        (
            "go,speed\n1,5\n0,fast\n",
            "in.csv: row 1 (line 3), column `speed`: `fast` is not a value for an INT: write a whole number as in 42 or 16#FF",
        ),
        (
            "go,speed\n1,5\n\n0\n",
            "in.csv: row 2 (line 4): the cell for column `speed` is missing; the row has 1 of 2 cells",
        ),
        (
            "go,speed\n1,5,6\n",
            "in.csv: row 0 (line 2): column 3 has no name in the header; the row has 3 of 2 cells",
        ),
    ] {
        let folder = Folder::with(&[("types.clad", TYPES), ("in.csv", csv)]);
        let run = folder.ladder(&[
            "sim",
            "types.clad",
            "--scans",
            "9",
            "--inputs",
            "in.csv",
            "-o",
            "out.csv",
        ]);
        run.refused_with(message);
        assert_eq!(folder.names(), ["in.csv", "types.clad"]);
    }
    let folder = Folder::with(&[("types.clad", TYPES)]);
    folder.write("latin.csv", b"go\n\xE4\n");
    let sim = |inputs: &str| folder.ladder(&["sim", "types.clad", "--scans", "1", "--inputs", inputs]);
    sim("latin.csv").refused_with(
        "latin.csv: the file is not UTF-8: byte 16#E4 at line 2, column 1; save it as UTF-8 in your editor",
    );
    sim("missing.csv").refused_with("missing.csv: no such file or folder");
}

#[test]
fn an_interval_must_be_a_time_that_passes() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    for dt in ["0ms", "-5ms", "soon", ""] {
        let run = folder.ladder(&["sim", "motor.clad", "--scans", "1", &format!("--dt={dt}")]);
        assert_eq!(run.status, Some(2), "{run}");
        assert_eq!(run.stdout, "", "{run}");
        assert!(run.stderr.starts_with("error: "), "{run}");
    }
}
