//! Projects of several programs in PLCopen XML, opened as they are and written as a workspace.

use crate::harness::Folder;
use expect_test::expect;

const PLANT: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201"><types><dataTypes/><pous>
<pou name="Main" pouType="program"><interface>
<inputVars><variable name="a"><type><BOOL/></type></variable></inputVars>
<outputVars><variable name="y"><type><BOOL/></type></variable></outputVars></interface><body><LD>
<leftPowerRail localId="1"/>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>a</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>y</variable></coil>
</LD></body></pou>
<pou name="Count" pouType="program"><interface/><body><FBD>
<inVariable localId="1"><expression>level</expression></inVariable>
<inVariable localId="2"><expression>1</expression></inVariable>
<block localId="3" typeName="ADD"><inputVariables>
<variable formalParameter="IN1"><connectionPointIn><connection refLocalId="1"/></connectionPointIn></variable>
<variable formalParameter="IN2"><connectionPointIn><connection refLocalId="2"/></connectionPointIn></variable>
</inputVariables><inOutVariables/><outputVariables><variable formalParameter="OUT"><connectionPointOut/></variable></outputVariables></block>
<outVariable localId="4"><connectionPointIn><connection refLocalId="3" formalParameter="OUT"/></connectionPointIn><expression>level</expression></outVariable>
</FBD></body></pou></pous></types>
<instances><configurations><configuration name="c">
<globalVars><variable name="level"><type><INT/></type></variable></globalVars>
<resource name="r"><task name="t" interval="T#50ms" priority="0">
<pouInstance name="i" typeName="Main"/><pouInstance name="j" typeName="Count"/></task></resource>
</configuration></configurations></instances></project>
"#;

#[test]
fn a_project_runs_as_it_is() {
    let folder = Folder::with(&[("plant.xml", PLANT)]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "plant.xml"]).to_string());
    let run = folder.ladder(&["sim", "plant.xml", "--scans", "2", "--set", "a=1"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,a,level,y
        0,0,1,1,1
        1,50,1,2,1
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn a_project_becomes_a_workspace() {
    let folder = Folder::with(&[("plant.xml", PLANT)]);
    let run = folder.ladder(&["convert", "plant.xml", "-o", "plant/", "--report", "report.txt"]);
    expect![[r#"
        exit status 0
        -- stderr
        plant.xml: 15 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        plant
        plant.xml
        report.txt"#]]
    .assert_eq(&folder.names().join("\n"));
    expect![[r#"
        plant.xml:3:1: translated: program Main
        plant.xml:4:12: translated: variable a
        plant.xml:5:13: translated: variable y
        plant.xml:6:1: translated: left rail
        plant.xml:7:1: translated: contact a
        plant.xml:8:1: translated: coil y
        plant.xml:10:1: translated: program Count
        plant.xml:11:1: translated: input level
        plant.xml:12:1: translated: input 1
        plant.xml:13:1: translated: block ADD
        plant.xml:17:1: translated: output level
        plant.xml:20:13: translated: variable level
        plant.xml:21:20: translated: task t
        plant.xml:22:1: translated: instance of Main
        plant.xml:22:40: translated: instance of Count
    "#]]
    .assert_eq(&folder.read("report.txt"));
    expect![[r#"
        +----------------------------------------------------[ADD]( level, level, 1 )--+
    "#]]
    .assert_eq(&folder.read("plant/Count.clad"));
    expect![[r#"
        exit status 0
        -- stdout
        Checked 3 files: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "plant"]).to_string());
    let run = folder.ladder(&["sim", "plant/Count.clad", "--scans", "2"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,level
        0,0,1
        1,50,2
    "#]]
    .assert_eq(&run.to_string());
    // A file that a person wrote stays.
    folder.write("plant/Main.clad", b"mine");
    let run = folder.ladder(&["convert", "plant.xml", "-o", "plant/"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: plant/Main.clad: this is a program, and it stays as it is; name another file, or end with --force
    "#]].assert_eq(&run.to_string());
    assert_eq!(folder.read("plant/Main.clad"), "mine");
}

#[test]
fn what_a_second_run_would_write_again_stays() {
    let folder = Folder::with(&[("plant.xml", PLANT)]);
    for _ in 0..2 {
        let run = folder.ladder(&["convert", "plant.xml", "-o", "plant.xml.d/plant.xml/"]);
        expect![[r#"
            exit status 0
            -- stderr
            plant.xml: 15 translated, 0 approximated, 0 refused
        "#]]
        .assert_eq(&run.to_string());
    }
    let names = [
        "Count.clad",
        "Main.clad",
        "globals.clad",
        "ladder.toml",
        "plant.xml",
    ];
    assert_eq!(folder.names_in("plant.xml.d/plant.xml"), names);
}

#[test]
fn names_that_no_file_may_have() {
    let long = "x".repeat(300);
    let plant = PLANT
        .replace("\"Main\"", "\"CON\"")
        .replace("\"Count\"", &format!("\"{long}\""));
    let folder = Folder::with(&[("plant.xml", &plant)]);
    folder.ladder(&["convert", "plant.xml", "-o", "plant/"]);
    let long = format!("{}.clad", &long[..100]);
    assert_eq!(
        folder.names_in("plant"),
        ["CON_.clad", "globals.clad", "ladder.toml", "plant.xml", &long]
    );
}

#[test]
fn a_project_in_another_encoding_is_read() {
    let folder = Folder::with(&[]);
    let utf16 = |text: &str| {
        text.encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect::<Vec<u8>>()
    };
    folder.write("plant.xml", &[&[0xFF, 0xFE][..], &utf16(PLANT)].concat());
    let run = folder.ladder(&["check", "plant.xml"]);
    assert_eq!(
        run.to_string(),
        "exit status 0\n-- stdout\nChecked 1 file: no errors found.\n"
    );
}

#[test]
fn a_report_in_markdown_is_a_table_that_nothing_in_the_program_breaks() {
    let plant = PLANT.replace("<variable>y</variable>", "<variable>y | `*</variable>");
    let folder = Folder::with(&[("plant_1.xml", &plant)]);
    folder.ladder(&["convert", "plant_1.xml", "-o", "plant/", "--report", "report.MD"]);
    expect![[r#"
        # plant\_1.xml

        14 translated, 1 approximated, 0 refused

        | place | element | outcome | reason |
        | --- | --- | --- | --- |
        | 3:1 | program Main | translated |  |
        | 4:12 | variable a | translated |  |
        | 5:13 | variable y | translated |  |
        | 6:1 | left rail | translated |  |
        | 7:1 | contact a | translated |  |
        | 8:1 | coil y \| \`\* | approximated | \`\|\` has no place in an expression here\: it is not run |
        | 10:1 | program Count | translated |  |
        | 11:1 | input level | translated |  |
        | 12:1 | input 1 | translated |  |
        | 13:1 | block ADD | translated |  |
        | 17:1 | output level | translated |  |
        | 20:13 | variable level | translated |  |
        | 21:20 | task t | translated |  |
        | 22:1 | instance of Main | translated |  |
        | 22:40 | instance of Count | translated |  |
    "#]]
    .assert_eq(&folder.read("report.MD"));
}

#[test]
fn of_a_file_that_was_cut_off_nothing_is_written() {
    let folder = Folder::with(&[("plant.xml", &PLANT[..1000])]);
    let run = folder.ladder(&["convert", "plant.xml", "-o", "plant/", "--report", "report.md"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: plant.xml:15:26: the file ends too early, as one that was not saved or copied whole: export it again
    "#]]
    .assert_eq(&run.to_string());
    assert_eq!(folder.names(), ["plant.xml"]);
}
