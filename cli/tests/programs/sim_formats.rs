//! `ladder sim --format`: the same run in every form, as golden files.

use crate::harness::{Folder, Run};
use expect_test::{Expect, expect, expect_file};

/// Every kind of value, names with members, elements and bits, and texts that need care.
const KINDS: &str = "\
VAR_INPUT go : BOOL; END_VAR
VAR count : INT; total : LREAL; level : REAL := 0.1; word1 : WORD; big : ULINT := 18446744073709551615; END_VAR
VAR name : STRING := 'a'; day : DATE := D#2026-11-21; list : ARRAY[1..3] OF INT; t1 : TON; END_VAR
+--[ADD]( total, total, 0.5 )--[SUB]( count, count, 3 )--[MOV]( list[2], count )--+
+--[ ]( go )--[TON]( t1, T#25ms )--[MOV]( word1, 255 )--[MOV]( name, '<a & \"b\"> $N \\' )--+
";

const WATCHED: &str = "go,t1.Q,t1.ET,count,list[2],word1,word1.3,big,total,level,name,day,SYS.SCAN";

fn kinds(arguments: &[&str]) -> Run {
    let folder = Folder::with(&[("kinds.clad", KINDS)]);
    folder.ladder(
        &[
            &["sim", "kinds.clad", "--set", "go=1", "--watch", WATCHED],
            arguments,
        ]
        .concat(),
    )
}

fn check(format: &str, expected: expect_test::ExpectFile) {
    let run = kinds(&["--scans", "5", "--format", format]);
    assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""), "{format}");
    expected.assert_eq(&run.stdout);
}

#[test]
fn csv() {
    check("csv", expect_file!["traces/kinds.csv"]);
}

#[test]
fn json() {
    check("json", expect_file!["traces/kinds.json"]);
}

#[test]
fn vcd() {
    check("vcd", expect_file!["traces/kinds.vcd"]);
}

#[test]
fn svg() {
    check("svg", expect_file!["traces/kinds.svg"]);
}

/// Reports that machines read name what did nothing, too.
#[test]
fn unread_parts_are_named() {
    let folder = Folder::with(&[
        (
            "u.clad",
            "FUNCTION_BLOCK [$PART]\n# ladder: unread, writes b #\nEND_FUNCTION_BLOCK\n\n+--[$PART]--[ ]( b )--( )( y )--+\n",
        ),
        (
            "u.ladder-test",
            "program u.clad\n\nscenario \"one\"\ny => _\n\nproperty \"two\"\nnever y\n",
        ),
    ]);
    let run = folder.ladder(&["sim", "u.clad", "--scans", "1", "--format", "json"]);
    assert!(
        run.stdout.contains("\n  \"unread_parts\": [\"PART\"],\n"),
        "{}",
        run.stdout
    );
    for command in ["test", "prove"] {
        let junit = folder
            .ladder(&[command, "u.ladder-test", "--format", "junit"])
            .stdout;
        assert!(
            junit.contains("<property name=\"unread part\" value=\"PART\"/>"),
            "{junit}"
        );
    }
}

/// Another reader than the one that wrote it agrees about the JSON, and both say the same as the CSV.
#[test]
fn json_says_what_csv_says() {
    let json: serde_json::Value =
        serde_json::from_str(&kinds(&["--scans", "5", "--format", "json"]).stdout).expect("JSON");
    let csv = kinds(&["--scans", "5"]).stdout;
    let mut rows = csv::Reader::from_reader(csv.as_bytes());
    for (row, scan) in rows.records().zip(json["scans"].as_array().expect("scans")) {
        let row = row.expect("a row");
        assert_eq!(row[0], scan["scan"].to_string());
        assert_eq!(row[1], scan["time_ms"].to_string());
        for (cell, value) in row.iter().skip(2).zip(scan["values"].as_array().expect("values")) {
            match value {
                serde_json::Value::Bool(high) => assert_eq!(cell, if *high { "1" } else { "0" }),
                serde_json::Value::String(text) => assert_eq!(cell, text),
                number => assert_eq!(cell, number.to_string()),
            }
        }
    }
    assert_eq!(json["scans"].as_array().map(Vec::len), Some(5));
}

#[test]
fn no_scan_at_all() {
    let shown = |format, expected: Expect| {
        let folder = Folder::with(&[("a.clad", "+--[ ]( go )--( )( lamp )--+\n")]);
        let run = folder.ladder(&["sim", "a.clad", "--scans", "0", "--format", format]);
        expected.assert_eq(&run.stdout);
    };
    shown(
        "csv",
        expect![[r#"
        scan,time_ms,go,lamp
    "#]],
    );
    shown(
        "json",
        expect![[r#"
        {
          "program": "a.clad",
          "interval_ms": 10,
          "tags": [
            { "name": "go", "type": "BOOL" },
            { "name": "lamp", "type": "BOOL" }
          ],
          "scans": []
        }
    "#]],
    );
    shown(
        "vcd",
        expect![[r#"
        $comment TIME is in milliseconds $end
        $version ladder 0.1.0 $end
        $timescale 10 ms $end
        $scope module a $end
        $var wire 1 ! go $end
        $var wire 1 " lamp $end
        $upscope $end
        $enddefinitions $end
        #0
    "#]],
    );
}
