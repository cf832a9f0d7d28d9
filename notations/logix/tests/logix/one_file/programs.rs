//! Programs and tasks of an export come, go and change.

use super::{back, cell, check, difference, folder};
use expect_test::expect;
use ladder_format::Options;
use ladder_notation::{ProjectTask, Source, convert, write_one_file};
use ladder_notation_logix::L5x;

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
