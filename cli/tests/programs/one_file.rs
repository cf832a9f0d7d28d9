//! A project that becomes a folder, and the folder that becomes one file again.

use crate::harness::Folder;
use expect_test::expect;

/// An export with a module, two programs, and a task.
fn cell() -> String {
    let program = |name: &str, rung: &str| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\"><Tags/><Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent>\n<Rung Number=\"0\" \
             Type=\"N\"><Text><![CDATA[{rung}]]></Text></Rung>\n</RLLContent></Routine></Routines></Program>\n"
        )
    };
    let tag = |name: &str| {
        format!("<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"BOOL\" Class=\"Standard\"/>\n")
    };
    format!(
        "<RSLogix5000Content SchemaRevision=\"1.0\"><Controller Name=\"Cell\">\n<Modules><Module Name=\"Local\" Slot=\"3\"/></Modules>\n<Tags>\n{}{}\
         </Tags>\n<Programs>\n{}{}</Programs>\n<Tasks><Task Name=\"Fast\" Type=\"PERIODIC\" Rate=\"5\"><ScheduledPrograms><ScheduledProgram \
         Name=\"Pump\"/><ScheduledProgram Name=\"Valve\"/></ScheduledPrograms></Task></Tasks>\n</Controller></RSLogix5000Content>\n",
        tag("go"),
        tag("run"),
        program("Pump", "XIC(go)OTE(run);"),
        program("Valve", "XIO(run)NOP();")
    )
}

fn edit(folder: &Folder) {
    let pump = folder.read("cell/Pump.clad").replace("[ ]( go )", "[/]( go )");
    folder.write("cell/Pump.clad", pump.as_bytes());
}

#[test]
fn a_folder_knows_the_file_that_it_comes_from() {
    let cell = cell();
    let folder = Folder::with(&[("Cell.L5X", &cell)]);
    folder.ladder(&["convert", "Cell.L5X", "-o", "cell/"]);
    expect![[r#"
        [
            "Cell.L5X",
            "Cell.clad",
            "Pump.clad",
            "Valve.clad",
            "ladder.toml",
        ]
    "#]]
    .assert_debug_eq(&folder.names_in("cell"));
    expect![[r#"
        exit status 0
        -- stderr
        note: cell: nothing was changed since it was read from cell/Cell.L5X
    "#]]
    .assert_eq(&folder.ladder(&["convert", "cell", "-o", "same.L5X"]).to_string());
    assert_eq!(folder.read("same.L5X"), cell);
    edit(&folder);
    expect![[r#"
        exit status 0
        -- stderr
        cell/Pump.clad: 1 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&folder.ladder(&["convert", "cell", "-o", "new.L5X"]).to_string());
    assert_eq!(folder.read("new.L5X"), cell.replace("XIC(go)", "XIO(go)"));
    // What is called as the original replaces no file of a person.
    expect![[r#"
        exit status 2
        -- stderr
        error: cell/Cell.L5X: this file is there, and no command of ladder made it; name another file, or end with --force
    "#]].assert_eq(
        &folder
            .ladder(&["convert", "cell", "-o", "cell/Cell.L5X"])
            .to_string(),
    );
    assert_eq!(folder.read("cell/Cell.L5X"), cell);
}

#[test]
fn the_file_that_a_folder_comes_from_is_named() {
    let folder = Folder::with(&[
        ("Cell.L5X", &cell()),
        ("old.L5X", &cell().replace("Slot=\"3\"", "Slot=\"4\"")),
    ]);
    folder.ladder(&["convert", "Cell.L5X", "-o", "cell/"]);
    edit(&folder);
    let run = folder.ladder(&["convert", "cell", "-o", "new.L5X", "--keep", "old.L5X"]);
    expect![[r#"
        exit status 0
        -- stderr
        cell/Pump.clad: 1 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
    assert!(folder.read("new.L5X").contains("Slot=\"4\""));
    folder.write("cell/old.L5X", cell().as_bytes());
    expect![[r#"
        exit status 2
        -- stderr
        error: cell: its programs may come from cell/Cell.L5X or from cell/old.L5X: name the one that they come from with --keep
    "#]].assert_eq(&folder.ladder(&["convert", "cell", "-o", "other.L5X"]).to_string());
    let run = folder.ladder(&["convert", "cell", "-o", "other.L5X", "--keep", "cell/Pump.clad"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: cell/Pump.clad: this is no Logix L5X export, so what is written cannot be kept as it is there; name the file that the programs come from
    "#]].assert_eq(&run.to_string());
    let run = folder.ladder(&["convert", "cell", "-o", "other.L5X", "--keep", "missing.L5X"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: missing.L5X: no such file or folder
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&[
        "convert",
        "cell/Pump.clad",
        "-o",
        "other.L5X",
        "--keep",
        "old.L5X",
    ]);
    expect![[r#"
        exit status 2
        -- stderr
        error: --keep old.L5X: this is the file that the programs of one folder come from, which become one file again: name the folder, and with -o a file of a notation that holds whole projects, as `-o project.L5X`
    "#]].assert_eq(&run.to_string());
    assert!(!folder.names().contains(&"other.L5X".to_owned()));
}

#[test]
fn a_folder_that_comes_from_no_file_becomes_one() {
    let pump = "# ladder: profile logix #\nVAR_GLOBAL go, run : BOOL; END_VAR\n+--[ ]( go )--( )( run )--+\n";
    let valve = "# ladder: profile logix #\nVAR shut : BOOL; END_VAR\n+--[/]( run )--( )( shut )--+\n";
    let folder = Folder::with(&[("plant/Pump.clad", pump), ("plant/Valve.clad", valve)]);
    expect![[r#"
        exit status 0
        -- stderr
        plant/Pump.clad: 1 translated, 0 approximated, 0 refused
        plant/Valve.clad: 2 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(
        &folder
            .ladder(&["convert", "plant", "-o", "plant.L5X"])
            .to_string(),
    );
    folder.ladder(&["convert", "plant.L5X", "-o", "again/"]);
    expect![[r#"
        [
            "Pump.clad",
            "Valve.clad",
            "ladder.toml",
            "plant.L5X",
            "plant.clad",
        ]
    "#]]
    .assert_debug_eq(&folder.names_in("again"));
    folder.write("plant/Valve.clad", b"+--[/]( run )--( )( shut\n");
    expect![[r#"
        exit status 2
        -- stderr
        error: plant: this cannot be written as one Logix L5X export: Valve.clad:1:19: `( shut` is not closed: `)` is missing
    "#]].assert_eq(
        &folder
            .ladder(&["convert", "plant", "-o", "other.L5X"])
            .to_string(),
    );
    assert!(!folder.names().contains(&"other.L5X".to_owned()));
}
