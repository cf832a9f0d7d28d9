//! `ladder check` for machines, `--fix` and `--statistics`.

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

/// An error with related places and a fix, and a warning with a fix.
const WRONG: &str = "+--[ ]( a )( )( y )--+\n\n+--[TOM]( t, T#5s )--( )( z )--+\n";

fn wrong() -> Folder {
    Folder::with(&[("wrong.clad", WRONG)])
}

#[test]
fn concise() {
    expect![[r#"
        exit status 1
        -- stdout
        wrong.clad:1:11: warning[missing-wire] two blocks touch without a wire between them
        wrong.clad:3:4: error[unknown-instruction] there is no instruction [TOM]
        Checked 1 file: 1 error, 1 warning.
    "#]]
    .assert_eq(
        &wrong()
            .ladder(&["check", "--format", "concise", "wrong.clad"])
            .to_string(),
    );
}

#[test]
fn github() {
    expect![[r#"
        exit status 1
        -- stdout
        ::warning file=wrong.clad,line=1,col=11,endColumn=13,title=missing-wire::two blocks touch without a wire between them%0Adraw a `-` between them
        ::error file=wrong.clad,line=3,col=4,endColumn=9,title=unknown-instruction::there is no instruction [TOM]%0Adid you mean [TON] (on-delay timer)?
    "#]].assert_eq(
        &wrong()
            .ladder(&["check", "--format", "github", "wrong.clad"])
            .to_string(),
    );
}

/// Read back with types that others made from the standard's schema.
#[test]
fn sarif_is_what_the_standard_says() {
    let folder = Folder::with(&[("lines/wrong one.clad", WRONG), ("motor.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--format", "sarif", "lines", "motor.clad"]);
    assert_eq!(run.status, Some(1), "{run}");
    let document: serde_sarif::sarif::Sarif = serde_json::from_str(&run.stdout).unwrap();
    let results = document.runs[0].results.as_ref().unwrap();
    let found: Vec<_> = results
        .iter()
        .map(|result| {
            let place = &result.locations.as_ref().unwrap()[0];
            let place = place.physical_location.as_ref().unwrap();
            let file = place.artifact_location.as_ref().unwrap().uri.clone();
            let line = place.region.as_ref().unwrap().start_line;
            (result.rule_id.clone().unwrap(), file.unwrap(), line.unwrap())
        })
        .collect();
    expect![[r#"
        [
            (
                "missing-wire",
                "lines/wrong%20one.clad",
                1,
            ),
            (
                "unknown-instruction",
                "lines/wrong%20one.clad",
                3,
            ),
        ]
    "#]]
    .assert_debug_eq(&found);
    // What comes out is what went in: no member has a name that the standard does not know.
    let again = serde_json::to_value(&document).unwrap();
    let written: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(again, written);
}

#[test]
fn sarif_without_findings_has_no_results() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--format", "sarif", "motor.clad"]);
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(document["runs"][0]["results"], serde_json::json!([]));
}

#[test]
fn statistics() {
    expect![[r#"
        exit status 1
        -- stdout
        wrong.clad:1:11: warning[missing-wire] two blocks touch without a wire between them
        wrong.clad:3:4: error[unknown-instruction] there is no instruction [TOM]
             1 * missing-wire
             1 * unknown-instruction
        Checked 1 file: 1 error, 1 warning.
    "#]]
    .assert_eq(
        &wrong()
            .ladder(&["check", "--format", "concise", "--statistics", "wrong.clad"])
            .to_string(),
    );
}

#[test]
fn fix_mends_and_aligns() {
    let folder = wrong();
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no mistakes found. Mended 2 findings.
    "#]]
    .assert_eq(&folder.ladder(&["check", "--fix", "wrong.clad"]).to_string());
    expect![[r#"
        +--[ ]( a )------------------( )( y )--+

        +----------[TON]( t, T#5s )--( )( z )--+
    "#]]
    .assert_eq(&folder.read("wrong.clad"));
}

#[test]
fn fix_leaves_alone_what_is_right() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let path = folder.path("motor.clad");
    let before = std::fs::metadata(&path).unwrap().modified().unwrap();
    let run = folder.ladder(&["check", "--fix", "motor.clad"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(std::fs::metadata(&path).unwrap().modified().unwrap(), before);
}

/// Many files are checked at once; what is found stands in their order all the same.
#[test]
fn the_order_of_many_files_is_theirs() {
    let names: Vec<String> = (0..200).map(|n| format!("{n:03}.clad")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), WRONG)).collect();
    let folder = Folder::with(&files);
    let run = folder.ladder(&["check", "--format", "concise", "."]);
    let order: Vec<&str> = run
        .stdout
        .lines()
        .filter_map(|line| line.split(':').next())
        .collect();
    let mut sorted = order.clone();
    sorted.pop();
    sorted.sort_unstable();
    assert_eq!(order[..order.len() - 1], sorted);
    assert_eq!(sorted.len(), 400);
}
