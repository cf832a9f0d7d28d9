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
        error: cell/Pump.clad: its notation is not "Logix L5X export", so what is written cannot be kept as it is there; name the file that the programs come from
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

/// Two programs, what they share, and the tasks that run them.
fn plant(profile: &str) -> [(&'static str, String); 4] {
    let program = |rungs: &str| format!("{profile}{rungs}");
    [
        (
            "plant/globals.clad",
            program("VAR_GLOBAL\n    go  : BOOL;\n    run : BOOL;\nEND_VAR\n"),
        ),
        (
            "plant/Pump.clad",
            program("VAR_EXTERNAL\n    go  : BOOL;\n    run : BOOL;\nEND_VAR\n+--[ ]( go )--( )( run )--+\n"),
        ),
        (
            "plant/Valve.clad",
            program(
                "VAR_EXTERNAL\n    run : BOOL;\nEND_VAR\nVAR\n    shut : BOOL;\nEND_VAR\n+--[/]( run )--( )( shut )--+\n",
            ),
        ),
        (
            "plant/ladder.toml",
            "[[task]]\nname = \"Slow\"\ninterval = \"1s\"\npriority = 7\nprograms = [\"Valve.clad\"]\n\n[[task]]\nname = \
             \"Fast\"\ninterval = \"5ms\"\npriority = 3\nprograms = [\"Pump.clad\"]\n"
                .to_owned(),
        ),
    ]
}

/// The tasks of a folder.
fn tasks(folder: &Folder, name: &str) -> String {
    let settings = folder.read(&format!("{name}/ladder.toml"));
    settings
        .find("[[task]]")
        .map_or("", |at| &settings[at..])
        .to_owned()
}

#[test]
fn tasks_become_tasks_and_come_back() {
    let mut told = String::new();
    for (profile, file) in [("# ladder: profile logix #\n", "plant.L5X"), ("", "plant.xml")] {
        let plant = plant(profile);
        let folder = Folder::with(&plant.each_ref().map(|(name, text)| (*name, text.as_str())));
        let run = folder.ladder(&["convert", "plant", "-o", file]);
        told.push_str(&format!("{file}: {run}"));
        folder.ladder(&["convert", file, "-o", "again/"]);
        expect![[r#"
            [[task]]
            name = "Fast"
            interval = "5ms"
            priority = 3
            programs = ["Pump.clad"]

            [[task]]
            name = "Slow"
            interval = "1s"
            priority = 7
            programs = ["Valve.clad"]
        "#]]
        .assert_eq(&tasks(&folder, "again"));
        // What is not changed stays as it is there; without that file it is written, and read, as it was.
        folder.ladder(&["convert", "again", "-o", &format!("same-{file}")]);
        let original = folder.read(file);
        assert_eq!(folder.read(&format!("same-{file}")), original);
        std::fs::remove_file(folder.path(&format!("again/{file}"))).expect("it was copied");
        let run = folder.ladder(&["convert", "again", "-o", file, "--force"]);
        told.push_str(&format!("{file} again: {run}"));
        folder.ladder(&["convert", file, "-o", "third/"]);
        for name in folder.names_in("again") {
            let [second, third] = ["again", "third"].map(|of| folder.read(&format!("{of}/{name}")));
            assert_eq!(second, third, "{file}: {name}");
        }
    }
    expect![[r#"
        plant.L5X: exit status 0
        -- stderr
        plant/Pump.clad:1:1: approximated: task Fast: there it interrupts tasks with a larger priority between any two instructions
        plant/Pump.clad: 1 translated, 1 approximated, 0 refused
        plant/Valve.clad: 2 translated, 0 approximated, 0 refused
        plant.L5X again: exit status 0
        -- stderr
        again/Pump.clad:1:1: approximated: task Fast: there it interrupts tasks with a larger priority between any two instructions
        again/Pump.clad: 3 translated, 1 approximated, 0 refused
        again/Valve.clad: 5 translated, 0 approximated, 0 refused
        plant.xml: exit status 0
        -- stderr
        plant/Pump.clad: 1 translated, 0 approximated, 0 refused
        plant/Valve.clad: 1 translated, 0 approximated, 0 refused
        plant.xml again: exit status 0
        -- stderr
        again/Pump.clad: 1 translated, 0 approximated, 0 refused
        again/Valve.clad: 1 translated, 0 approximated, 0 refused
    "#]].assert_eq(&told);
}

#[test]
fn a_task_that_runs_what_is_not_there_is_refused() {
    let mut plant = plant("");
    plant[3].1 = plant[3].1.replace("Pump.clad", "Fan.clad");
    let folder = Folder::with(&plant.each_ref().map(|(name, text)| (*name, text.as_str())));
    let run = folder.ladder(&["convert", "plant", "-o", "plant.L5X"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: plant: task Fast runs Fan.clad, which is not among the programs of this folder
    "#]]
    .assert_eq(&run.to_string());
}

/// The lines of a file that another one does not have, and those that only that has.
fn changed(was: &str, is: &str) -> String {
    let lines = |of: &str, other: &str, sign: char| -> String {
        let all: Vec<&str> = other.lines().map(str::trim).collect();
        let lines = of.lines().map(str::trim).filter(|line| !all.contains(line));
        let lines: Vec<String> = lines.map(|line| format!("{sign} {line}\n")).collect();
        lines.concat()
    };
    lines(was, is, '-') + &lines(is, was, '+')
}

#[test]
fn changed_tasks_are_changed_in_the_file_that_they_come_from() {
    let mut told = String::new();
    for (profile, file, other) in [
        ("# ladder: profile logix #\n", "plant.L5X", "other.L5X"),
        ("", "plant.xml", "other.xml"),
    ] {
        let plant = plant(profile);
        let folder = Folder::with(&plant.each_ref().map(|(name, text)| (*name, text.as_str())));
        folder.ladder(&["convert", "plant", "-o", file]);
        folder.ladder(&["convert", file, "-o", "again/"]);
        let settings = folder.read("again/ladder.toml");
        let both = "[\"Valve.clad\", \"Pump.clad\"]";
        let new = "name = \"New\"\ninterval = \"20ms\"\npriority = 9\nprograms = [\"Valve.clad\"]";
        let slow = &settings[settings.find("name = \"Slow\"").expect("it is there")..].trim_end();
        for (what, edited) in [
            ("an interval", settings.replace("\"5ms\"", "\"500us\"")),
            ("a priority", settings.replace("priority = 7", "priority = 2")),
            ("another task", settings.replace(slow, new)),
            (
                "one task",
                settings
                    .replace(&format!("[[task]]\n{slow}"), "")
                    .replace("[\"Pump.clad\"]", both),
            ),
        ] {
            assert_ne!(edited, settings);
            folder.write("again/ladder.toml", edited.as_bytes());
            let run = folder.ladder(&["convert", "again", "-o", other, "--force"]);
            let files = changed(&folder.read(file), &folder.read(other));
            told.push_str(&format!("{file}, {what}:\n{run}{files}"));
        }
        folder.ladder(&["convert", other, "-o", "last/"]);
        told.push_str(&tasks(&folder, "last"));
    }
    expect![[r#"
        plant.L5X, an interval:
        exit status 0
        - <Task Name="Fast" Type="PERIODIC" Rate="5" Priority="3" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        + <Task Name="Fast" Type="PERIODIC" Rate="0.5" Priority="3" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        plant.L5X, a priority:
        exit status 0
        - <Task Name="Slow" Type="PERIODIC" Rate="1000" Priority="7" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        + <Task Name="Slow" Type="PERIODIC" Rate="1000" Priority="2" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        plant.L5X, another task:
        exit status 0
        - <Task Name="Slow" Type="PERIODIC" Rate="1000" Priority="7" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        + <Task Name="New" Type="PERIODIC" Rate="20" Priority="9" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        plant.L5X, one task:
        exit status 0
        - <Task Name="Slow" Type="PERIODIC" Rate="1000" Priority="7" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        [[task]]
        name = "Fast"
        interval = "5ms"
        priority = 3
        programs = ["Valve.clad", "Pump.clad"]
        plant.xml, an interval:
        exit status 0
        - <task name="Fast" priority="3" interval="T#5ms">
        + <task name="Fast" priority="3" interval="T#500us">
        plant.xml, a priority:
        exit status 0
        - <task name="Slow" priority="7" interval="T#1s">
        + <task name="Slow" priority="2" interval="T#1s">
        plant.xml, another task:
        exit status 0
        - <task name="Slow" priority="7" interval="T#1s">
        + <task name="New" priority="9" interval="T#20ms">
        plant.xml, one task:
        exit status 0
        - <task name="Slow" priority="7" interval="T#1s">
        [[task]]
        name = "Fast"
        interval = "5ms"
        priority = 3
        programs = ["Valve.clad", "Pump.clad"]
    "#]].assert_eq(&told);
}

/// What a link in the folder leads to outside of it is not read.
#[cfg(unix)]
#[test]
fn an_original_outside_of_the_folder_is_not_kept() {
    let folder = Folder::with(&[("cell.L5X", &cell())]);
    folder.ladder(&["convert", "cell.L5X", "-o", "plant/"]);
    let link = folder.path("plant/cell.L5X");
    std::fs::remove_file(&link).unwrap();
    std::os::unix::fs::symlink(folder.path("cell.L5X"), &link).unwrap();
    let run = folder.ladder(&["convert", "plant", "-o", "back.L5X"]);
    assert!(!run.to_string().contains("since it was read from"), "{run}");
    assert_ne!(folder.read("back.L5X"), cell());
}

#[test]
fn what_is_not_written_into_the_file_is_named() {
    let pump = "# ladder: profile logix #\nVAR_GLOBAL go, run : BOOL; END_VAR\n+--[ ]( go )--( )( run )--+\n";
    let clamp = "FUNCTION Clamp : INT\nVAR_INPUT v : INT; END_VAR\n    Clamp := MIN(v, 5);\nEND_FUNCTION\n";
    let folder = Folder::with(&[("plant/Pump.clad", pump), ("plant/more/Clamp.st", clamp)]);
    expect![[r#"
        exit status 1
        -- stderr
        plant/Pump.clad: 1 translated, 0 approximated, 0 refused
        plant/more/Clamp.st:1:1: refused: Structured Text: only ladder text is written there (Logix L5X export): bring this file there by hand
        plant/more/Clamp.st: 0 translated, 0 approximated, 1 refused
    "#]].assert_eq(
        &folder
            .ladder(&["convert", "plant", "-o", "plant.L5X"])
            .to_string(),
    );
}
