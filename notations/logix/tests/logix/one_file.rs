//! The files of a folder as one export, and as the one that they come from.

use crate::exports::routine;
use crate::files::corpus_files;
use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{OneFile, Outcome, ProjectTask, Source, convert, write_one_file};
use ladder_notation_logix::L5x;

type Files = Vec<(String, String)>;

/// The files that an export becomes.
fn folder(export: &str) -> Files {
    let source = Source::alone("cell", export.as_bytes());
    let converted = convert(&L5x, &source, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let programs = converted.files.iter().filter(|file| file.name != "ladder.toml");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("it is UTF-8");
    let files: Files = programs
        .map(|file| (file.name.clone(), text(&file.bytes)))
        .collect();
    if files.is_empty() {
        return vec![("cell.clad".to_owned(), converted.written.text)];
    }
    files
}

/// Writes files into the export that they come from.
fn back(export: &str, files: &Files) -> OneFile {
    let source = Source::alone("cell", export.as_bytes());
    write_one_file(&L5x, files, &[], "cell", Some(&source)).unwrap_or_else(|error| panic!("{error}"))
}

fn text(written: &OneFile) -> String {
    String::from_utf8(written.bytes.clone()).expect("it is UTF-8")
}

/// The lines that are otherwise, and what there is to say.
fn difference(before: &str, written: &OneFile) -> String {
    let after = text(written);
    let mut out = String::new();
    for change in similar::TextDiff::from_lines(before, &after).iter_all_changes() {
        let sign = match change.tag() {
            similar::ChangeTag::Equal => continue,
            similar::ChangeTag::Delete => '-',
            similar::ChangeTag::Insert => '+',
        };
        out.push_str(&format!("{sign}{}", change.value()));
    }
    for (file, report) in &written.reports {
        for entry in report.remarks() {
            let (Outcome::Approximated(why) | Outcome::Refused(why)) = &entry.outcome else {
                continue;
            };
            out.push_str(&format!("{file}:{}: {}: {why}\n", entry.place, entry.element));
        }
    }
    out
}

/// Edits the ladder text of an export: in the file of this name the line with something becomes another one.
#[track_caller]
fn check(export: &str, edits: &[(&str, &str, &str)], expected: Expect) {
    let mut files = folder(export);
    for (name, from, to) in edits {
        let file = files.iter_mut().find(|(own, _)| own == name);
        let (_, text) = file.unwrap_or_else(|| panic!("there is no {name}"));
        // Wires are as long as their line has room for.
        let from = text
            .lines()
            .find(|line| line.replace("--", "").contains(&from.replace("--", "")));
        let from = from.unwrap_or_else(|| panic!("{text}")).to_owned();
        *text = text.replacen(&from, to, 1);
    }
    let written = back(export, &files);
    expected.assert_eq(&difference(export, &written));
}

/// Two programs and a task, a module, and a routine that is a diagram.
fn cell() -> String {
    let diagram = "<Routine Name=\"Level\" Type=\"FBD\">\n<FBDContent SheetSize=\"A\"/>\n</Routine>\n";
    let program = |name: &str, tags: &str, routines: &str| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\" Disabled=\"false\">\n<Tags>\n{tags}</Tags>\n<Routines>\n{routines}</Routines>\n</Program>\n"
        )
    };
    let tag = |name: &str, ty: &str, value: &str| {
        format!(
            "<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"{ty}\" ExternalAccess=\"Read Only\">\n<Data Format=\"L5K\">\n<![CDATA[{value}]]>\n</Data>\n\
             <Data Format=\"Decorated\">\n<DataValue DataType=\"{ty}\" Radix=\"Hex\" Value=\"{value}\"/>\n</Data>\n</Tag>\n"
        )
    };
    let pump = [
        routine("Main", &["JSR(Sub,0);", "JSR(Level,0);"]),
        diagram.to_owned(),
        routine(
            "Sub",
            &[
                "XIC(go)OTE(run);",
                "TON(timer,100,0);",
                "XIC(timer.DN)ADD(step,1,step);",
            ],
        ),
    ];
    let valve = [
        routine("Main", &["XIO(run)OTE(shut);"]),
        routine("Sub", &["MOV(3,step);"]),
    ];
    format!(
        "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<RSLogix5000Content SchemaRevision=\"1.0\" \
         TargetName=\"Cell\">\n<Controller Use=\"Target\" Name=\"Cell\" ProcessorType=\"1769-L33ER\">\n<Modules>\n<Module Name=\"Local\" \
         CatalogNumber=\"1769-L33ER\"/>\n</Modules>\n<Tags>\n{}{}</Tags>\n<Programs>\n{}{}</Programs>\n<Tasks>\n<Task Name=\"Fast\" \
         Type=\"PERIODIC\" Rate=\"5\" Priority=\"3\">\n<ScheduledPrograms>\n<ScheduledProgram Name=\"Pump\"/>\n<ScheduledProgram \
         Name=\"Valve\"/>\n</ScheduledPrograms>\n</Task>\n</Tasks>\n</Controller>\n</RSLogix5000Content>\n",
        tag("go", "BOOL", "0"),
        tag("run", "BOOL", "0"),
        program(
            "Pump",
            &(tag("step", "DINT", "7") + "<Tag Name=\"timer\" TagType=\"Base\" DataType=\"TIMER\"/>\n"),
            &pump.concat()
        ),
        program(
            "Valve",
            &(tag("step", "DINT", "1") + &tag("shut", "BOOL", "0")),
            &valve.concat()
        ),
    )
}

#[test]
fn what_is_not_edited_stays_to_the_letter() {
    let mut count = 0;
    for (name, export) in corpus_files() {
        let mut files = folder(&export);
        assert_eq!(text(&back(&export, &files)), export, "{name}");
        // A blank line is no edit.
        files[0].1.push('\n');
        if name.contains("ER013") {
            continue;
        }
        let written = back(&export, &files);
        assert_eq!(text(&written), export, "{name}");
        assert_eq!(difference(&export, &written), "", "{name}");
        count += 1;
    }
    assert!(count == 0 || count == 48, "{count}");
}

/// The lines about what runs: without comments for the tools, and a number that stands for rungs.
fn bare(files: &Files) -> Vec<String> {
    let told = ["# ladder: allow", "# Controller", "# the checksum"];
    let lines = files.iter().flat_map(|(_, text)| text.lines());
    let kept = lines.filter(|line| !line.is_empty() && !told.iter().any(|begin| line.starts_with(begin)));
    // Tags that are new are declared after the others.
    let mut kept: Vec<String> = kept.map(|line| line.split_whitespace().collect()).collect();
    kept.sort();
    kept
}

/// Of each file the first contacts are made their opposites, one by one: one rung is otherwise then, and is read again as it was edited.
#[test]
fn one_contact_changes_one_rung() {
    let mut tried = 0;
    for (name, export) in corpus_files() {
        if name.contains("ER013") {
            continue;
        }
        let files = folder(&export);
        let places = files.iter().enumerate().flat_map(|(number, (_, text))| {
            let rungs = text.find("FUNCTION_BLOCK").map_or(&text[..], |end| &text[..end]);
            rungs
                .match_indices("--[ ]( ")
                .map(move |(at, _)| (number, at + 2))
        });
        for (number, at) in places.take(12) {
            let mut files = files.clone();
            // What never runs is the order of the tasks.
            if files[number].1[at..].starts_with("[ ]( SYS.OFF )") {
                continue;
            }
            tried += 1;
            files[number].1.replace_range(at..at + 3, "[/]");
            let written = back(&export, &files);
            let told = difference(&export, &written);
            let is_drawn = told.contains("it is ladder logic there now");
            assert!(is_drawn || told.lines().count() == 2, "{name}\n{told}");
            let again = bare(&folder(&text(&written)));
            // A branch without anything on it is not drawn again, and what was structured text in another way.
            if !is_drawn && !name.contains("l5x2c.ex1") {
                let is = bare(&files);
                let other = again.iter().zip(&is).find(|(again, is)| again != is);
                assert!(
                    other.is_none() && again.len() == is.len(),
                    "{name}\n{told}{other:?}"
                );
            }
        }
    }
    assert!(tried == 0 || tried > 50, "{tried}");
}

#[test]
fn a_rung_is_edited_added_and_taken_out() {
    let pump = "Pump.clad";
    check(
        &cell(),
        &[(pump, "( )( run )", "+--[ ]( go )--(S)( run )--+")],
        expect![[r#"
        -<![CDATA[XIC(go)OTE(run);]]>
        +<![CDATA[XIC(go)OTL(run);]]>
    "#]],
    );
    check(
        &cell(),
        &[(
            pump,
            "[$TON]( timer )",
            "# a new one #\n+--[ ]( go )--( )( lamp )--+\n\n+--[$TON]( timer )--+",
        )],
        expect![[r#"
            +<Tag Name="lamp" TagType="Base" DataType="BOOL" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="BOOL" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +<Comment>
            +<![CDATA[a new one]]>
            +</Comment>
            -<![CDATA[TON(timer,100,0);]]>
            +<![CDATA[XIC(go)OTE(lamp);]]>
            +<![CDATA[TON(timer,100,0);]]>
            +</Text>
            +</Rung>
            +<Rung Number="3" Type="N">
            +<Text>
        "#]],
    );
    check(
        &cell(),
        &[(pump, "[$TON]( timer )", "")],
        expect![[r#"
            -<![CDATA[TON(timer,100,0);]]>
            -</Text>
            -</Rung>
            -<Rung Number="2" Type="N">
            -<Text>
        "#]],
    );
}

#[test]
fn tags_are_changed_renamed_and_taken_out() {
    let pump = "Pump.clad";
    check(
        &cell(),
        &[(pump, "DINT  := 7", "    Pump_step : DINT := 8;  # step #")],
        expect![[r#"
        -<Data Format="L5K">
        -<![CDATA[7]]>
        -</Data>
        -<DataValue DataType="DINT" Radix="Hex" Value="7"/>
        +<DataValue DataType="DINT" Radix="Decimal" Value="8"/>
    "#]],
    );
    check(
        &cell(),
        &[
            (pump, "DINT  := 7", "    count : DINT := 7;"),
            (
                pump,
                "[ ]( timer.DN )",
                "+--[ ]( timer.DN )--[CALC]( count, count + 1 )--+",
            ),
        ],
        expect![[r#"
            -<Tag Name="step" TagType="Base" DataType="DINT" ExternalAccess="Read Only">
            -<Data Format="L5K">
            -<![CDATA[7]]>
            -</Data>
            +<Tag Name="count" TagType="Base" DataType="DINT" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            -<DataValue DataType="DINT" Radix="Hex" Value="7"/>
            +<DataValue DataType="DINT" Radix="Decimal" Value="7"/>
            -<![CDATA[XIC(timer.DN)ADD(step,1,step);]]>
            +<![CDATA[XIC(timer.DN)CPT(count,count + 1);]]>
        "#]],
    );
}

#[test]
fn programs_come_and_go() {
    let text = "# ladder: profile logix #\nVAR n : DINT := 2; END_VAR\n+--[ ]( go )--[MOV]( n, 3 )--+\n";
    let mut files = folder(&cell());
    files.push(("Fan.clad".to_owned(), text.to_owned()));
    expect![[r#"
        +<Program Name="Fan" TestEdits="false" MainRoutineName="MainRoutine" Disabled="false" UseAsFolder="false">
        +<Tags>
        +<Tag Name="n" TagType="Base" DataType="DINT" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
        +<Data Format="Decorated">
        +<DataValue DataType="DINT" Radix="Decimal" Value="2"/>
        +</Data>
        +</Tag>
        +</Tags>
        +<Routines>
        +<Routine Name="MainRoutine" Type="RLL">
        +<RLLContent>
        +<Rung Number="0" Type="N">
        +<Text>
        +<![CDATA[XIC(go)MOV(3,n);]]>
        +</Text>
        +</Rung>
        +</RLLContent>
        +</Routine>
        +</Routines>
        +</Program>
        +<ScheduledProgram Name="Fan"/>
    "#]].assert_eq(&difference(&cell(), &back(&cell(), &files)));
    let mut files = folder(&cell());
    files.retain(|(name, _)| name != "Valve.clad");
    let lines = files[0].1.lines().filter(|line| !line.contains("Valve_Main"));
    files[0].1 = lines.collect::<Vec<_>>().join("\n") + "\n";
    expect![[r#"
        -<Program Name="Valve" MainRoutineName="Main" Disabled="false">
        -<Tags>
        -<Tag Name="step" TagType="Base" DataType="DINT" ExternalAccess="Read Only">
        -<Data Format="L5K">
        -<![CDATA[1]]>
        -</Data>
        -<Data Format="Decorated">
        -<DataValue DataType="DINT" Radix="Hex" Value="1"/>
        -</Data>
        -</Tag>
        -<Tag Name="shut" TagType="Base" DataType="BOOL" ExternalAccess="Read Only">
        -<Data Format="L5K">
        -<![CDATA[0]]>
        -</Data>
        -<Data Format="Decorated">
        -<DataValue DataType="BOOL" Radix="Hex" Value="0"/>
        -</Data>
        -</Tag>
        -</Tags>
        -<Routines>
        -<Routine Name="Main" Type="RLL">
        -<RLLContent>
        -<Rung Number="0" Type="N">
        -<Text>
        -<![CDATA[XIO(run)OTE(shut);]]>
        -</Text>
        -</Rung>
        -</RLLContent>
        -</Routine>
        -<Routine Name="Sub" Type="RLL">
        -<RLLContent>
        -<Rung Number="0" Type="N">
        -<Text>
        -<![CDATA[MOV(3,step);]]>
        -</Text>
        -</Rung>
        -</RLLContent>
        -</Routine>
        -</Routines>
        -</Program>
        -<ScheduledProgram Name="Valve"/>
    "#]]
    .assert_eq(&difference(&cell(), &back(&cell(), &files)));
}

#[test]
fn what_no_program_of_a_controller_can_be_is_refused() {
    check(
        &cell(),
        &[
            (
                "Valve.clad",
                "[/]( run )",
                "+--[ ]( go )--<CALL>( Pump_Sub )--+\n\n+--[/]( run )--( )( shut )--+",
            ),
            ("Cell.clad", "END_VAR", "END_VAR\n\n+--[ ]( go )--( )( run )--+"),
        ],
        expect![[r#"
            +<Comment>
            +<![CDATA[not written: `<CALL>( Pump_Sub )`: `Pump_Sub` is in another program, whose routines this one cannot call
            ++--[ ]( go )-----------------------------------------------<CALL>( Pump_Sub )--+
            +]]>
            +</Comment>
            +<Text>
            +<![CDATA[NOP();]]>
            +</Text>
            +</Rung>
            +<Rung Number="1" Type="N">
            Cell.clad:8:4: network: it runs outside of the programs there: put it into the file of one of them
            Valve.clad:12:4: network: `<CALL>( Pump_Sub )`: `Pump_Sub` is in another program, whose routines this one cannot call
        "#]],
    );
}

#[test]
fn what_a_program_runs_first_is_its_main_routine() {
    let pump = "Pump.clad";
    let go = "+--[ ]( go )--<CALL>( Pump_Main )--+";
    check(
        &cell(),
        &[(pump, "<CALL>( Pump_Main )", go)],
        expect![[r#"
        -<Program Name="Pump" MainRoutineName="Main" Disabled="false">
        +<Program Name="Pump" MainRoutineName="MainRoutine" Disabled="false">
        +<Routine Name="MainRoutine" Type="RLL">
        +<RLLContent>
        +<Rung Number="0" Type="N">
        +<Text>
        +<![CDATA[XIC(go)JSR(Main,0);]]>
        +</Text>
        +</Rung>
        +</RLLContent>
        +</Routine>
    "#]],
    );
    // Of one that is not the first file, too.
    let both = "+--<CALL>( Valve_Main )--+\n\n+--<CALL>( Valve_Sub )--+";
    check(
        &cell(),
        &[("Valve.clad", "<CALL>( Valve_Main )", both)],
        expect![[r#"
        -<Program Name="Valve" MainRoutineName="Main" Disabled="false">
        +<Program Name="Valve" MainRoutineName="MainRoutine" Disabled="false">
        +<Routine Name="MainRoutine" Type="RLL">
        +<RLLContent>
        +<Rung Number="0" Type="N">
        +<Text>
        +<![CDATA[JSR(Main,0);]]>
        +</Text>
        +</Rung>
        +<Rung Number="1" Type="N">
        +<Text>
        +<![CDATA[JSR(Sub,0);]]>
        +</Text>
        +</Rung>
        +</RLLContent>
        +</Routine>
    "#]],
    );
    // Another routine is the first.
    let sub = "+--<CALL>( Valve_Sub )--+";
    check(
        &cell(),
        &[("Valve.clad", "<CALL>( Valve_Main )", sub)],
        expect![[r#"
        -<Program Name="Valve" MainRoutineName="Main" Disabled="false">
        +<Program Name="Valve" MainRoutineName="Sub" Disabled="false">
    "#]],
    );
}

#[test]
fn a_program_of_a_new_controller_begins_with_what_it_runs_first() {
    let calls = "# ladder: profile logix #\nVAR n : DINT; END_VAR\n+--<CALL>( Main )--+\n\n+--<FUN>( Main )--+\n\n+--[MOV]( n, 1 )--+\n";
    let files: Files = ["Fan.clad", "Pump.clad"]
        .map(|name| (name.to_owned(), calls.to_owned()))
        .to_vec();
    let written = write_one_file(&L5x, &files, &[], "plant", None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        written
            .reports
            .iter()
            .map(|(_, report)| report.remarks().count())
            .sum::<usize>(),
        0
    );
    let again = folder(&text(&written));
    let shown: Vec<String> = again
        .iter()
        .map(|(name, text)| format!("{name}\n{text}"))
        .collect();
    expect![[r#"
        Fan.clad
        # ladder: profile logix #

        VAR
            Fan_n : DINT;  # n #
        END_VAR

        +----------------------------------------------------------<CALL>( Fan_Main )--+

        +--<FUN>( Fan_Main )-----------------------------------------------------------+

        +-----------------------------------------------------------[MOV]( Fan_n, 1 )--+
        Pump.clad
        # ladder: profile logix #

        VAR
            Pump_n : DINT;  # n #
        END_VAR

        +---------------------------------------------------------<CALL>( Pump_Main )--+

        +--<FUN>( Pump_Main )----------------------------------------------------------+

        +----------------------------------------------------------[MOV]( Pump_n, 1 )--+
    "#]]
    .assert_eq(&shown.concat());
}

/// The tasks of an export, written with other tasks.
fn with_tasks(export: &str, change: impl Fn(&mut Vec<ProjectTask>)) -> String {
    let source = Source::alone("cell", export.as_bytes());
    let converted = convert(&L5x, &source, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let mut tasks = converted.tasks;
    change(&mut tasks);
    let files = folder(export);
    let written = write_one_file(&L5x, &files, &tasks, "cell", Some(&source));
    difference(export, &written.unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn a_continuous_task_with_another_interval_is_periodic() {
    let export = cell().replace(
        "Type=\"PERIODIC\" Rate=\"5\" Priority=\"3\"",
        "Type=\"CONTINUOUS\" Watchdog=\"80\"",
    );
    expect![[r#""#]].assert_eq(&with_tasks(&export, |_| {}));
    let slower = |tasks: &mut Vec<ProjectTask>| tasks[0].interval *= 2;
    expect![[r#"
        -<Task Name="Fast" Type="CONTINUOUS" Watchdog="80">
        +<Task Name="Fast" Type="PERIODIC" Watchdog="80" Priority="15" Rate="20">
        Pump.clad:1:1: task Fast: its priority is 15 there: those of tasks are 1 to 15
    "#]]
    .assert_eq(&with_tasks(&export, slower));
}

#[test]
fn events_and_inhibited_tasks_stay() {
    let event = "<Task Name=\"Event\" Type=\"EVENT\">\n<ScheduledPrograms>\n<ScheduledProgram Name=\"Valve\"/>\n</ScheduledPrograms>\n</Task>\n</Tasks>";
    let export = cell()
        .replace("<ScheduledProgram Name=\"Valve\"/>\n", "")
        .replace("</Tasks>", event);
    let slower = |tasks: &mut Vec<ProjectTask>| tasks[0].interval *= 2;
    expect![[r#"
        -<Task Name="Fast" Type="PERIODIC" Rate="5" Priority="3">
        +<Task Name="Fast" Type="PERIODIC" Rate="10" Priority="3">
    "#]]
    .assert_eq(&with_tasks(&export, slower));
    // What a task runs now is run by no other.
    let more = |tasks: &mut Vec<ProjectTask>| tasks[0].programs.push("Valve.clad".to_owned());
    expect![[r#"
        +<ScheduledProgram Name="Valve"/>
        -<ScheduledProgram Name="Valve"/>
    "#]]
    .assert_eq(&with_tasks(&export, more));
}

/// The files of a folder as a new export.
#[track_caller]
fn written(files: &[(&str, &str)], expected: Expect) {
    let files: Files = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
        .collect();
    let written = write_one_file(&L5x, &files, &[], "plant", None).unwrap_or_else(|error| panic!("{error}"));
    expected.assert_eq(&difference("", &written));
}

#[test]
fn files_are_the_programs_of_a_controller() {
    written(
        &[
            (
                "Plant.clad",
                "# ladder: profile logix #\nVAR_GLOBAL go, run : BOOL; END_VAR\n+--<CALL>( Valve_Main )--+\n\n+--<CALL>( Pump )--+\n",
            ),
            (
                "Pump.clad",
                "# ladder: profile logix #\nVAR_EXTERNAL run : BOOL; END_VAR\nVAR step : DINT; END_VAR\n+--<FUN>( Pump )--+\n\n+--[ ]( go )--( )( run )--+\n\n+--<CALL>( Sub )--+\n\n+--<FUN>( Sub )--+\n\n+--[MOV]( step, 1 )--+\n",
            ),
            (
                "Valve.clad",
                "# ladder: profile logix #\nVAR step : DINT; END_VAR\n+--<FUN>( Valve_Main )--+\n\n+--[ ]( run )--[MOV]( step, 2 )--+\n",
            ),
        ],
        expect![[r#"
            +﻿<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
            +<RSLogix5000Content SchemaRevision="1.0" SoftwareRevision="33.01" TargetName="Plant" TargetType="Controller" ContainsContext="false" ExportOptions="DecoratedData ForceProtectedEncoding AllProjDocTrans">
            +<Controller Use="Target" Name="Plant" ProcessorType="1756-L83E" MajorRev="33" MinorRev="1">
            +<DataTypes>
            +</DataTypes>
            +<Modules/>
            +<AddOnInstructionDefinitions>
            +</AddOnInstructionDefinitions>
            +<Tags>
            +<Tag Name="go" TagType="Base" DataType="BOOL" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="BOOL" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +<Tag Name="run" TagType="Base" DataType="BOOL" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="BOOL" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +</Tags>
            +<Programs>
            +<Program Name="Pump" TestEdits="false" MainRoutineName="Pump" Disabled="false" UseAsFolder="false">
            +<Tags>
            +<Tag Name="step" TagType="Base" DataType="DINT" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="DINT" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +</Tags>
            +<Routines>
            +<Routine Name="Pump" Type="RLL">
            +<RLLContent>
            +<Rung Number="0" Type="N">
            +<Text>
            +<![CDATA[XIC(go)OTE(run);]]>
            +</Text>
            +</Rung>
            +<Rung Number="1" Type="N">
            +<Text>
            +<![CDATA[JSR(Sub,0);]]>
            +</Text>
            +</Rung>
            +</RLLContent>
            +</Routine>
            +<Routine Name="Sub" Type="RLL">
            +<RLLContent>
            +<Rung Number="0" Type="N">
            +<Text>
            +<![CDATA[MOV(1,step);]]>
            +</Text>
            +</Rung>
            +</RLLContent>
            +</Routine>
            +</Routines>
            +</Program>
            +<Program Name="Valve" TestEdits="false" MainRoutineName="Main" Disabled="false" UseAsFolder="false">
            +<Tags>
            +<Tag Name="step" TagType="Base" DataType="DINT" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
            +<Data Format="Decorated">
            +<DataValue DataType="DINT" Radix="Decimal" Value="0"/>
            +</Data>
            +</Tag>
            +</Tags>
            +<Routines>
            +<Routine Name="Main" Type="RLL">
            +<RLLContent>
            +<Rung Number="0" Type="N">
            +<Text>
            +<![CDATA[XIC(run)MOV(2,step);]]>
            +</Text>
            +</Rung>
            +</RLLContent>
            +</Routine>
            +</Routines>
            +</Program>
            +</Programs>
            +<Tasks>
            +<Task Name="MainTask" Type="CONTINUOUS" Priority="10" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
            +<ScheduledPrograms>
            +<ScheduledProgram Name="Valve"/>
            +<ScheduledProgram Name="Pump"/>
            +</ScheduledPrograms>
            +</Task>
            +</Tasks>
            +</Controller>
            +</RSLogix5000Content>
        "#]],
    );
}

/// Why files cannot be one export.
fn why(files: &[(&str, &str)]) -> String {
    let files: Files = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
        .collect();
    let error = write_one_file(&L5x, &files, &[], "plant", None).expect_err("it cannot be written");
    format!("{error}\n")
}

#[test]
fn files_that_cannot_be_one_say_why() {
    let block = "FUNCTION_BLOCK [$Motor]\nVAR q : BOOL; END_VAR\n+--( )( q )--+\nEND_FUNCTION_BLOCK\n";
    let coil = "+--( )( y )--+\n";
    let own = format!("# ladder: profile logix #\n{coil}");
    let found = [
        why(&[("a.clad", block), ("b.clad", block)]),
        why(&[("a.clad", &own), ("b.clad", coil)]),
        why(&[("a.clad", "+--( )( y--+\n")]),
        why(&[]),
    ];
    expect![[r#"
        b.clad:2:1: among the other files as one program: the block `$Motor` is defined twice
        b.clad has the profile iec, and a.clad the profile logix: what is written counts and times in one way; give all files one profile
        a.clad:1:7: `( y` is not closed: `)` is missing
        there are no programs
    "#]].assert_eq(&found.concat());
}

#[test]
fn an_original_that_is_none_says_so() {
    let files = folder(&cell());
    let with = |original: &str| {
        let source = Source::alone("cell", original.as_bytes());
        let error =
            write_one_file(&L5x, &files, &[], "cell", Some(&source)).expect_err("it cannot be written");
        format!("{error}\n")
    };
    let jump = cell().replace("XIC(go)OTE(run);", "XIC(go)JMP(nowhere);");
    expect![[r#"
        the file that the programs come from: it is XML, but no export of Logix Designer: those begin with <RSLogix5000Content>
        the file that the programs come from: 1:1: this is not XML as it must be: unknown token
        the file that the programs come from: Pump.clad:22:69: there is no label `nowhere` to jump to
    "#]].assert_eq(&[with("<a/>"), with("none"), with(&jump)].concat());
}
