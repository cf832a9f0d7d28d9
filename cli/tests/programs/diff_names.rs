//! What `ladder diff` and `ladder merge` say of names, order, and the values of a controller.

use crate::harness::Folder;
use expect_test::expect;

const PUMP: &str = "\
VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    pump : BOOL;
END_VAR
VAR
    seal : BOOL;
END_VAR

+--\\--[ ]( start )--\\--[/]( stop )--( )( seal )--+
|  /--[ ]( seal )---/

+--[ ]( seal )--( )( pump )--+
";

#[test]
fn a_rename_is_said_in_every_form() {
    let folder = Folder::with(&[
        ("old.clad", PUMP),
        ("inside.clad", &PUMP.replace("seal", "runs")),
        ("outside.clad", &PUMP.replace("pump", "pump_1")),
    ]);
    let told = |arguments: &[&str]| folder.ladder(arguments).to_string();
    expect![[r#"
        exit status 0
        -- stdout
        the same
    "#]]
    .assert_eq(&told(&["diff", "--same", "old.clad", "inside.clad"]));
    expect![[r#"
        exit status 1
        -- stdout
        the same but for the names
          outside.clad: renamed: output pump -> pump_1 (2 places)
    "#]]
    .assert_eq(&told(&["diff", "--same", "old.clad", "outside.clad"]));
    expect![[r#"
        exit status 1
        -- stdout
        --- old.clad
        +++ inside.clad
            5 the same, 1 renamed

        renamed: tag seal -> runs (4 places)

            ... 5 the same

        the programs do the same in every run
    "#]]
    .assert_eq(&told(&["diff", "old.clad", "inside.clad"]));
    expect![[r#"
        exit status 1
        -- stdout
        [
          {
            "old": "old.clad",
            "new": "outside.clad",
            "same": 5,
            "renames": [
              {
                "kind": "tag",
                "old": "pump",
                "new": "pump_1",
                "places": 2,
                "shown_as": "output"
              }
            ],
            "changes": [],
            "whole": {
              "meaning": "same"
            }
          }
        ]
    "#]]
    .assert_eq(&told(&["diff", "old.clad", "outside.clad", "--format", "json"]));
    expect![[r#"
        exit status 1
        -- stdout
        ### `outside.clad` (was `old.clad`)

        5 the same, 1 renamed

        renamed: output pump \-\> pump\_1 (2 places)

        the programs do the same in every run, but for the names

    "#]]
    .assert_eq(&told(&[
        "diff",
        "old.clad",
        "outside.clad",
        "--format",
        "markdown",
    ]));
    let html = told(&["diff", "old.clad", "outside.clad", "--format", "html"]);
    assert!(
        html.contains("<p>renamed: output pump -&gt; pump_1 (2 places)</p>"),
        "{html}"
    );
}

#[test]
fn another_order_is_the_same_only_where_it_does_not_matter() {
    let (one, other) = ("+--[ ]( a )--( )( y )--+\n\n", "+--[ ]( b )--( )( y )--+\n\n");
    let apart = "+--[ ]( b )--( )( z )--+\n\n";
    let folder = Folder::with(&[
        ("old.clad", &format!("{one}{other}{apart}")),
        ("moved.clad", &format!("{apart}{one}{other}")),
        ("swapped.clad", &format!("{other}{one}{apart}")),
    ]);
    let told = |new: &str| folder.ladder(&["diff", "--same", "old.clad", new]).to_string();
    expect![[r#"
        exit status 0
        -- stdout
        the same
    "#]]
    .assert_eq(&told("moved.clad"));
    expect![[r#"
        exit status 1
        -- stdout
        not the same
          swapped.clad: the programs differ in scan 0, at 0s
            a    -
            y => _  (old)
            y => -  (new)
    "#]]
    .assert_eq(&told("swapped.clad"));
}

#[test]
fn values_of_a_controller_are_one_line() {
    let project = |count: u32, limit: u32| {
        let tag = |name: &str, value: u32| {
            format!(
                "<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"DINT\" Radix=\"Decimal\"><Data Format=\"L5K\">{value}</Data>\
                 <Data Format=\"Decorated\"><DataValue DataType=\"DINT\" Radix=\"Decimal\" Value=\"{value}\"/></Data></Tag>"
            )
        };
        format!(
            "<RSLogix5000Content><Controller Name=\"Cell\"><Tags>{}{}<Tag Name=\"run\" TagType=\"Base\" DataType=\"BOOL\"/></Tags><Programs>\
             <Program Name=\"Main\" MainRoutineName=\"Main\"><Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent>\
             <Rung Number=\"0\" Type=\"N\"><Text><![CDATA[ADD(count,1,count)GRT(count,limit)OTE(run);]]></Text></Rung>\
             </RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>\n",
            tag("count", count),
            tag("limit", limit)
        )
    };
    let folder = Folder::with(&[
        ("monday.L5X", &project(3, 80)),
        ("tuesday.L5X", &project(41, 80)),
        ("edited.L5X", &project(41, 90)),
    ]);
    let told = |arguments: &[&str]| folder.ladder(arguments).to_string();
    expect![[r#"
        exit status 1
        -- stdout
        --- monday.L5X
        +++ tuesday.L5X
            1 other value, 5 the same

        1 value differs; --values shows it

            ... 5 the same
    "#]]
    .assert_eq(&told(&["diff", "monday.L5X", "tuesday.L5X"]));
    expect![[r#"
        exit status 1
        -- stdout
        --- monday.L5X
        +++ tuesday.L5X
            1 edited, 5 the same

            ... 2 the same

        edited: declaration of count
        - count : DINT := 3;
                          ^
        + count : DINT := 41;
                          ^^

            ... 3 the same

        the programs differ in scan 0, at 0s
            count => 4  (old)
            count => 42  (new)
    "#]]
    .assert_eq(&told(&["diff", "--values", "monday.L5X", "tuesday.L5X"]));
    expect![[r#"
        exit status 1
        -- stdout
        --- monday.L5X
        +++ edited.L5X
            1 edited, 1 other value, 4 the same

        1 value differs; --values shows it

            ... 2 the same

        edited: declaration of limit
        - limit : DINT := 80;
                          ^^
        + limit : DINT := 90;
                          ^^

            ... 2 the same

        the programs differ in scan 0, at 0s
            limit => 80  (old)
            limit => 90  (new)
    "#]]
    .assert_eq(&told(&["diff", "monday.L5X", "edited.L5X"]));
}

#[test]
fn a_merge_names_no_tag_that_is_gone() {
    let base = "VAR\n    seal : BOOL;\n    lamp : BOOL;\nEND_VAR\n\n+--[ ]( lamp )--( )( seal )--+\n";
    let folder = Folder::with(&[
        ("base.clad", base),
        (
            "ours.clad",
            &base
                .replace("    seal : BOOL;\n", "")
                .replace("( )( seal )", "( )( lamp )"),
        ),
        (
            "theirs.clad",
            &format!("{base}\n+--[ ]( seal )--( )( horn )--+\n"),
        ),
    ]);
    let run = folder.ladder(&[
        "merge",
        "base.clad",
        "ours.clad",
        "theirs.clad",
        "-o",
        "both.clad",
    ]);
    expect![[r#"
        exit status 1
        -- stderr
        ours.clad:7:9: warning[undeclared-tag] `seal` is not declared
    "#]]
    .assert_eq(&run.to_string());
}
