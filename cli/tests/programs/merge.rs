//! `ladder merge`

use crate::harness::Folder;
use expect_test::expect;

const BASE: &str = "\
+--[ ]( a )--( )( x )--+

+--[ ]( b )--( )( y )--+
";

fn sides(ours: &str, theirs: &str) -> Folder {
    Folder::with(&[("base.clad", BASE), ("ours.clad", ours), ("theirs.clad", theirs)])
}

const MERGE: [&str; 4] = ["merge", "base.clad", "ours.clad", "theirs.clad"];

#[test]
fn ours_becomes_the_result() {
    let folder = sides(
        &BASE.replace("[ ]( a )", "[/]( a )"),
        &BASE.replace("[ ]( b )", "[P]( b )"),
    );
    let run = folder.ladder(&MERGE);
    assert_eq!(run.to_string(), "exit status 0\n");
    expect![[r#"
        +--[/]( a )----------------------------------------------------------( )( x )--+

        +--[P]( b )----------------------------------------------------------( )( y )--+
    "#]]
    .assert_eq(&folder.read("ours.clad"));
}

#[test]
fn a_conflict_is_drawn_as_both() {
    let ours = BASE.replace("[ ]( a )", "[/]( a )");
    let folder = sides(&ours, &BASE.replace("[ ]( a )", "[P]( a )"));
    let run = folder.ladder(&[&MERGE[..], &["-o", "-"]].concat());
    expect![[r#"
        exit status 1
        -- stdout
        # <<<<<<< ours #
        +--[/]( a )--( )( x )--+
        # ======= #
        +--[P]( a )--( )( x )--+
        # >>>>>>> theirs #

        +--[ ]( b )----------------------------------------------------------( )( y )--+
        -- stderr
        warning: ours.clad: both sides edited the network that writes x
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.read("ours.clad"), ours);
    let run = folder.ladder(&[&MERGE[..], &["-o", "both.clad", "--path=plant/motor.clad"]].concat());
    expect![[r#"
        exit status 1
        -- stderr
        warning: plant/motor.clad: both sides edited the network that writes x
    "#]]
    .assert_eq(&run.to_string());
    let check = folder.ladder(&["check", "--format", "concise", "both.clad"]);
    let errors: Vec<&str> = check
        .stdout
        .lines()
        .filter(|line| line.contains("error["))
        .collect();
    assert_eq!(errors.len(), 1, "{check}");
    assert!(errors[0].contains("merge-conflict"), "{check}");
    assert_eq!(folder.ladder(&["fmt", "--check", "both.clad"]).status, Some(0));
}

#[test]
fn an_error_that_neither_side_has_is_reported() {
    let declared = |section: &str| format!("{section} z : BOOL; END_VAR\n{BASE}");
    let folder = sides(&declared("VAR_INPUT"), &declared("VAR"));
    let run = folder.ladder(&MERGE);
    expect![[r#"
        exit status 1
        -- stderr
        ours.clad:5:5: error[duplicate-declaration] `z` is declared twice
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn what_cannot_be_merged_stays_as_it_is() {
    let ours = format!("{BASE}FUNCTION_BLOCK [$B]\n");
    let folder = sides(&ours, &BASE.replace("[ ]( b )", "[P]( b )"));
    expect![[r#"
        exit status 2
        -- stderr
        error: ours.clad: the block in line 4 of ours is not closed, so it is not known what belongs to it; close it first
    "#]].assert_eq(&folder.ladder(&MERGE).to_string());
    assert_eq!(folder.read("ours.clad"), ours);
    folder.write("theirs.clad", b"\xff");
    assert_eq!(folder.ladder(&MERGE).status, Some(2));
    assert_eq!(folder.read("ours.clad"), ours);
}
