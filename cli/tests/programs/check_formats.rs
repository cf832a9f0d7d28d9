//! `ladder check` for machines, `--fix` and `--statistics`.

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

/// An error with related places and a fix, and a warning with a fix.
const WRONG: &str = "+--[ ]( a )( )( y )--+\n\n+--[TNO]( t, T#5s )--( )( z )--+\n";

fn wrong() -> Folder {
    Folder::with(&[("wrong.clad", WRONG)])
}

#[test]
fn concise() {
    expect![[r#"
        exit status 1
        -- stdout
        wrong.clad:1:11: warning[missing-wire] two blocks touch without a wire between them
        wrong.clad:3:4: error[unknown-instruction] there is no instruction [TNO]
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
        ::error file=wrong.clad,line=3,col=4,endColumn=9,title=unknown-instruction::there is no instruction [TNO]%0Adid you mean [TON] (on-delay timer)?
    "#]].assert_eq(
        &wrong()
            .ladder(&["check", "--format", "github", "wrong.clad"])
            .to_string(),
    );
}

/// tests/conformance holds the whole document against the schema of the standard.
#[test]
fn sarif_names_rule_file_and_line() {
    let folder = Folder::with(&[("lines/wrong one.clad", WRONG), ("motor.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--format", "sarif", "lines", "motor.clad"]);
    assert_eq!(run.status, Some(1), "{run}");
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let results = document["runs"][0]["results"].as_array().unwrap();
    let found: Vec<_> = results
        .iter()
        .map(|result| {
            let place = &result["locations"][0]["physicalLocation"];
            let file = place["artifactLocation"]["uri"].as_str().unwrap();
            let line = place["region"]["startLine"].as_u64().unwrap();
            (result["ruleId"].as_str().unwrap(), file, line)
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
        wrong.clad:3:4: error[unknown-instruction] there is no instruction [TNO]
             1 * missing-wire
             1   unknown-instruction
        Checked 1 file: 1 error, 1 warning.
    "#]]
    .assert_eq(
        &wrong()
            .ladder(&["check", "--format", "concise", "--statistics", "wrong.clad"])
            .to_string(),
    );
}

#[test]
fn fix_fixes_and_aligns() {
    let folder = wrong();
    expect![[r#"
        exit status 0
        -- stdout
        fixed wrong.clad:1:11 missing-wire: Insert wire
        fixed wrong.clad:3:4 unknown-instruction: Replace with [TON]
        Checked 1 file: no errors found. Fixed 2 findings.
    "#]]
    .assert_eq(
        &folder
            .ladder(&["check", "--fix", "--unsafe-fixes", "wrong.clad"])
            .to_string(),
    );
    expect![[r#"
        +--[ ]( a )----------------------------------------------------------( )( y )--+

        +--------------------------------------------------[TON]( t, T#5s )--( )( z )--+
    "#]]
    .assert_eq(&folder.read("wrong.clad"));
}

/// A misspelt instruction is a guess: it waits for a person.
#[test]
fn only_safe_fixes_are_made_unasked() {
    let folder = wrong();
    let run = folder.ladder(&["check", "--fix", "--format", "concise", "wrong.clad"]);
    expect![[r#"
        exit status 1
        -- stdout
        fixed wrong.clad:1:11 missing-wire: Insert wire
        wrong.clad:3:4: error[unknown-instruction] there is no instruction [TNO]
        Checked 1 file: 1 error. Fixed 1 finding.
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        +--[ ]( a )----------------------------------------------------------( )( y )--+

        +--[TNO]( t, T#5s )--( )( z )--+
    "#]]
    .assert_eq(&folder.read("wrong.clad"));
}

/// A connector without its partner is never taken away unasked: the branch with the seal-in would go.
#[test]
fn a_branch_that_is_not_closed_stays() {
    const OPEN: &str = "\
VAR_INPUT start, stop : BOOL; END_VAR
VAR_OUTPUT run : BOOL; END_VAR

+-\\-[ ]( start )-\\-[/]( stop )-( )( run )-+
|  -[ ]( run )-/
";
    let folder = Folder::with(&[("motor.clad", OPEN)]);
    let run = folder.ladder(&["check", "--fix", "--format", "concise", "motor.clad"]);
    assert_eq!(folder.read("motor.clad"), OPEN);
    assert_eq!(run.status, Some(1), "{run}");
    let run = folder.ladder(&["check", "--fix", "--unsafe-fixes", "motor.clad"]);
    expect![[r#"
        exit status 0
        -- stdout
        fixed motor.clad:4:18 unpaired-connector: Close the branch with `/`
        Checked 1 file: no errors found. Fixed 1 finding.
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        VAR_INPUT start, stop : BOOL; END_VAR
        VAR_OUTPUT run : BOOL; END_VAR

        +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
        |  /--[ ]( run )----/                                                          |
    "#]]
    .assert_eq(&folder.read("motor.clad"));
}

/// A blank line of a diff begins with a blank, which an expected text cannot hold.
fn without_blanks(run: &impl std::fmt::Display) -> String {
    run.to_string().replace("\n \n", "\n\n")
}

#[test]
fn diff_shows_what_would_be_fixed() {
    let folder = wrong();
    let before = folder.read("wrong.clad");
    let run = folder.ladder(&["check", "--fix", "--diff", "wrong.clad"]);
    expect![[r#"
        exit status 1
        -- stdout
        would fix wrong.clad:1:11 missing-wire: Insert wire
        --- wrong.clad
        +++ wrong.clad
        @@ -1,3 +1,3 @@
        -+--[ ]( a )( )( y )--+
        ++--[ ]( a )----------------------------------------------------------( )( y )--+

         +--[TNO]( t, T#5s )--( )( z )--+
        Checked 1 file: 1 error. 1 finding would be fixed.
    "#]]
    .assert_eq(&without_blanks(&run));
    let run = folder.ladder(&["check", "--fix", "--unsafe-fixes", "--diff", "wrong.clad"]);
    expect![[r#"
        exit status 1
        -- stdout
        would fix wrong.clad:1:11 missing-wire: Insert wire
        would fix wrong.clad:3:4 unknown-instruction: Replace with [TON]
        --- wrong.clad
        +++ wrong.clad
        @@ -1,3 +1,3 @@
        -+--[ ]( a )( )( y )--+
        ++--[ ]( a )----------------------------------------------------------( )( y )--+

        -+--[TNO]( t, T#5s )--( )( z )--+
        ++--------------------------------------------------[TON]( t, T#5s )--( )( z )--+
        Checked 1 file: no errors found. 2 findings would be fixed.
    "#]]
    .assert_eq(&without_blanks(&run));
    assert_eq!(folder.read("wrong.clad"), before);
    // Nothing to fix, nothing to show.
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["check", "--fix", "--diff", "motor.clad"]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&without_blanks(&run));
}

#[test]
fn diff_and_unsafe_fixes_belong_to_fix() {
    let folder = wrong();
    for arguments in [
        &["check", "--diff", "wrong.clad"][..],
        &["check", "--unsafe-fixes", "wrong.clad"],
        &["check", "--fix", "--diff", "--format", "json", "wrong.clad"],
    ] {
        let run = folder.ladder(arguments);
        assert_eq!(run.status, Some(2), "{run}");
    }
}

/// What machines read stays whole: the list of fixes goes to standard error.
#[test]
fn fixes_are_listed_next_to_what_machines_read() {
    let run = wrong().ladder(&["check", "--fix", "--format", "json", "wrong.clad"]);
    assert!(
        run.stderr
            .contains("fixed wrong.clad:1:11 missing-wire: Insert wire"),
        "{run}"
    );
    assert!(run.stdout.starts_with('['), "{run}");
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

/// Many files are checked at once; what is found is in their order all the same.
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
