//! `ladder tags`

use crate::harness::Folder;
use expect_test::expect;

const PLANT: &str = "\
VAR_INPUT
    start, stop : BOOL;  # \"the desk\", left #
    level AT %IW3 : INT;
END_VAR
VAR_OUTPUT
    lamp : BOOL;
END_VAR
VAR
    unused : DINT;
END_VAR

+--[ ]( start )----------------(S)( lamp )--+
+--[ ]( stop )-----------------(R)( lamp )--+
+--[GT]( level, 5 )--[ ]( lamp )--[TON]( t, 5s )--( )( warm )--+
";

fn tags(arguments: &[&str]) -> String {
    let folder = Folder::with(&[("plant.clad", PLANT)]);
    let arguments: Vec<&str> = ["tags", "plant.clad"]
        .into_iter()
        .chain(arguments.iter().copied())
        .collect();
    folder.ladder(&arguments).to_string()
}

#[test]
fn where_each_tag_is_read_and_written() {
    expect![[r#"
        exit status 0
        -- stdout
        lamp : BOOL, output, declared in line 6
            set             line 12 (network 1)
            reset           line 13 (network 2)
            read            line 14 (network 3)
        level : INT, input, at %IW3, declared in line 3
            read            line 14 (network 3)
        start : BOOL, input, declared in line 2  # "the desk", left #
            read            line 12 (network 1)
        stop : BOOL, input, declared in line 2  # "the desk", left #
            read            line 13 (network 2)
        t : TON, internal
            read and write  line 14 (network 3)
        unused : DINT, internal, declared in line 9
            used nowhere
        warm : BOOL, output
            write           line 14 (network 3)
    "#]]
    .assert_eq(&tags(&[]));
}

#[test]
fn for_a_spreadsheet() {
    expect![[r#"
        exit status 0
        -- stdout
        tag,block,type,kind,address,declared,write,set,reset,read and write,read,comment
        lamp,,BOOL,output,,6,,12:1,13:2,,14:3,
        level,,INT,input,%IW3,3,,,,,14:3,
        start,,BOOL,input,,2,,,,,12:1,"""the desk"", left"
        stop,,BOOL,input,,2,,,,,13:2,"""the desk"", left"
        t,,TON,internal,,,,,,14:3,,
        unused,,DINT,internal,,9,,,,,,
        warm,,BOOL,output,,,14:3,,,,,
    "#]]
    .assert_eq(&tags(&["--format", "csv"]));
}

#[test]
fn for_other_programs() {
    let told = tags(&["--format", "json"]);
    let json = &told[told.find('[').unwrap()..];
    let tags: serde_json::Value = serde_json::from_str(json).unwrap();
    expect![[r#"{"comment":"","declared":6,"kind":"output","places":[{"does":"set","line":12,"network":1},{"does":"reset","line":13,"network":2},{"does":"read","line":14,"network":3}],"tag":"lamp","type":"BOOL"}"#]].assert_eq(&tags[0].to_string());
}

#[test]
fn no_cell_is_a_formula() {
    let folder = Folder::with(&[(
        "h.clad",
        "VAR_INPUT\n    a : BOOL;  # =cmd|' /C calc'!A0 #\n    b : BOOL;  # a = b #\nEND_VAR\n+--[ ]( a )--[ ]( b )--( )( y )--+\n",
    )]);
    let run = folder.ladder(&["tags", "h.clad", "--format", "csv"]);
    assert!(run.stdout.contains(",'=cmd|' /C calc'!A0\n"), "{run}");
    assert!(run.stdout.contains(",a = b\n"), "{run}");
}
