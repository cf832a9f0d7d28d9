//! Files that become an export of their own.

use super::{Files, difference, folder, text};
use expect_test::{Expect, expect};
use ladder_notation::write_one_file;
use ladder_notation_logix::L5x;

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
