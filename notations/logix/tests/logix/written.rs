//! What programs of the language itself become as L5X.

use expect_test::{Expect, expect};
use ladder_notation::Notation;
use ladder_notation_logix::L5x;

/// A program as a file, and what there is to say of it.
#[track_caller]
fn written(text: &str) -> (String, Vec<String>) {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let writing = L5x.write(&analysis).expect("it is written");
    let remarks = writing.report.remarks();
    let remarks = remarks.map(|entry| format!("{} {}: {:?}", entry.place, entry.element, entry.outcome));
    (
        String::from_utf8(writing.bytes).expect("UTF-8"),
        remarks.collect(),
    )
}

/// Its rungs, then the remarks.
#[track_caller]
fn check(text: &str, expected: Expect) {
    let (file, remarks) = written(text);
    let rungs = file.lines().filter_map(|line| {
        let rung = line.strip_prefix("<![CDATA[")?.strip_suffix("]]>")?;
        rung.ends_with(';').then(|| rung.to_owned())
    });
    let lines: Vec<String> = rungs.chain(remarks).collect();
    expected.assert_eq(&lines.join("\n"));
}

const TAGS: &str = "VAR a, b, c, x, y : BOOL; n, m : DINT; t : TOF; s : TON; p : TP; k : CTU; END_VAR\n";

#[test]
fn a_whole_file() {
    let (file, _) = written(
        "TYPE\n    Motor : STRUCT\n        speed : REAL := 2.5;  # rpm #\n        on : BOOL;\n    END_STRUCT;\nEND_TYPE\n\n\
         VAR_INPUT start : BOOL; END_VAR\nVAR m : ARRAY[0..1] OF Motor; END_VAR\n# ladder: cycle 20ms #\n\n\
         # Runs #\n+--[ ]( start )--( )( m[1].on )--+\n",
    );
    expect![[r#"
        ﻿<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
        <RSLogix5000Content SchemaRevision="1.0" SoftwareRevision="33.01" TargetName="plant" TargetType="Controller" ContainsContext="false" ExportOptions="DecoratedData ForceProtectedEncoding AllProjDocTrans">
        <Controller Use="Target" Name="plant" ProcessorType="1756-L83E" MajorRev="33" MinorRev="1">
        <DataTypes>
        <DataType Name="Motor" Family="NoFamily" Class="User">
        <Members>
        <Member Name="speed" DataType="REAL" Dimension="0" Radix="Float" Hidden="false" ExternalAccess="Read/Write">
        <Description>
        <![CDATA[rpm]]>
        </Description>
        </Member>
        <Member Name="ZZZZZZZZZZMotor1" DataType="SINT" Dimension="0" Radix="Decimal" Hidden="true" ExternalAccess="Read/Write">
        </Member>
        <Member Name="on" DataType="BIT" Dimension="0" Radix="Decimal" Hidden="false" Target="ZZZZZZZZZZMotor1" BitNumber="0" ExternalAccess="Read/Write">
        </Member>
        </Members>
        </DataType>
        </DataTypes>
        <Modules/>
        <AddOnInstructionDefinitions>
        </AddOnInstructionDefinitions>
        <Tags>
        </Tags>
        <Programs>
        <Program Name="MainProgram" TestEdits="false" MainRoutineName="MainRoutine" Disabled="false" UseAsFolder="false">
        <Tags>
        <Tag Name="start" TagType="Base" DataType="BOOL" Radix="Decimal" Usage="Input" Constant="false" ExternalAccess="Read/Write">
        <Data Format="Decorated">
        <DataValue DataType="BOOL" Radix="Decimal" Value="0"/>
        </Data>
        </Tag>
        <Tag Name="m" TagType="Base" DataType="Motor" Dimensions="2" Constant="false" ExternalAccess="Read/Write">
        <Data Format="Decorated">
        <Array DataType="Motor" Dimensions="2">
        <Element Index="[0]">
        <Structure DataType="Motor">
        <DataValueMember Name="speed" DataType="REAL" Radix="Float" Value="2.5"/>
        <DataValueMember Name="on" DataType="BOOL" Radix="Decimal" Value="0"/>
        </Structure>
        </Element>
        <Element Index="[1]">
        <Structure DataType="Motor">
        <DataValueMember Name="speed" DataType="REAL" Radix="Float" Value="2.5"/>
        <DataValueMember Name="on" DataType="BOOL" Radix="Decimal" Value="0"/>
        </Structure>
        </Element>
        </Array>
        </Data>
        </Tag>
        </Tags>
        <Routines>
        <Routine Name="MainRoutine" Type="RLL">
        <RLLContent>
        <Rung Number="0" Type="N">
        <Comment>
        <![CDATA[Runs]]>
        </Comment>
        <Text>
        <![CDATA[XIC(start)OTE(m[1].on);]]>
        </Text>
        </Rung>
        </RLLContent>
        </Routine>
        </Routines>
        </Program>
        </Programs>
        <Tasks>
        <Task Name="MainTask" Type="PERIODIC" Rate="20" Priority="10" Watchdog="500" DisableUpdateOutputs="false" InhibitTask="false">
        <ScheduledPrograms>
        <ScheduledProgram Name="MainProgram"/>
        </ScheduledPrograms>
        </Task>
        </Tasks>
        </Controller>
        </RSLogix5000Content>
    "#]].assert_eq(&file);
}

#[test]
fn outputs_that_are_high_without_power_begin_a_rung() {
    check(
        &format!(
            "{TAGS}+--[ ]( a )--[TOF]( t, T#1s )--( )( x )--+\n\n+--[ ]( a )--[TON]( s, T#2s )--( )( y )--+\n\n\
             +--[ ]( a )--[CTU]( k, 3, R := b )--( )( x )--+\n\n+--[ ]( a )--[TP]( p, T#50ms )--( )( y )--+\n"
        ),
        expect![[r#"
            XIC(S:FS)OTU(k.CU)OTU(risen);
            XIC(a)TOF(t,1000,0);
            XIC(t.DN)OTE(x);
            XIC(a)TON(s,2000,0)XIC(s.DN)OTE(y);
            XIC(a)CTU(k,3,0);
            [XIC(b) MOV(0,k.ACC) OTU(k.DN) AFI() ,XIC(k.DN) ]OTE(x);
            XIC(a)ONS(risen)XIO(p_pulse)OTL(p_pulse);
            [XIC(p_pulse) TON(p,50,0) XIC(p.DN) OTU(p_pulse) RES(p) AFI() ,XIC(p_pulse) ]OTE(y);"#]],
    );
}

#[test]
fn edges_have_their_memory() {
    check(
        &format!(
            "{TAGS}+--[ ]( a )--[P]( b )--[OSR]--(P)( x )--+\n\n+--[ ]( a )--[OSF]--(N)( y )--+\n\n\
             +--[ ]( a )--[NOT]--( )( x )--+\n\n+--[ ]( a )--(/)( y )--( )( x )--+\n"
        ),
        expect![[r#"
            XIC(S:FS)OTU(risen)OTU(risen_2)OTU(risen_3);
            XIC(b)OSR(risen,edge);
            XIC(a)XIC(edge)ONS(risen_2)OSR(risen_3,x);
            XIC(a)OSF(was_high,fell);
            XIC(fell)OSF(was_high_2,y);
            XIC(a)OTE(power);
            XIO(power)OTE(x);
            XIC(a)OTE(power_2);
            [XIO(power_2) OTE(y) AFI() ,XIC(power_2) ]OTE(x);"#]],
    );
}

#[test]
fn a_bridge_is_parted_by_tags() {
    check(
        &format!(
            "{TAGS}+--[ ]( a )--\\--[ ]( b )-----\\--( )( y )--+\n|            /--[/]( n.1 )--\\--/            |\n\
             +--[ ]( c )---------------/--[ ]( m.2 )--( )( x )--+\n\n\
             +--[ ]( a )--\\--[ ]( y )-----\\--( )( y )--+\n|            /--[/]( n.1 )--\\--/            |\n\
             +--[ ]( c )---------------/--[ ]( m.2 )--( )( x )--+\n"
        ),
        expect![[r#"
            XIC(a)OTE(power_1);
            XIC(power_1)XIC(b)OTE(power_2);
            XIC(power_1)XIO(n.1)OTE(power_3);
            [XIC(power_3) ,XIC(c) ]OTE(power_4);
            [XIC(power_2) ,XIC(power_4) ]OTE(y);
            XIC(power_4)XIC(m.2)OTE(x);
            XIC(a)OTE(power_5);
            XIC(power_5)XIC(y)OTE(power_6);
            XIC(power_5)XIO(n.1)OTE(power_7);
            [XIC(power_7) ,XIC(c) ]OTE(power_8);
            [XIC(power_6) ,XIC(power_8) ]OTE(y);
            XIC(power_8)XIC(m.2)OTE(x);"#]],
    );
}

#[test]
fn what_would_be_a_fault_does_nothing() {
    check(
        &format!(
            "{TAGS}+--[DIV]( n, n, m )--( )( x )--+\n\n+--[CALC]( x, a AND NOT (n > 3 OR b) )--+\n\n\
             +--[SEL]( n, a, 1, m )--+\n\n+--[LIMIT]( n, 1, m, 9 )--+\n\n+--[ROL]( n, m, 3 )--+\n"
        ),
        expect![[r#"
            NEQ(m,0)DIV(n,m,n)OTE(x);
            [XIC(a) LEQ(n,3) XIO(b) OTL(x) ,[XIO(a) ,[GRT(n,3) ,XIC(b) ] ] OTU(x) ];
            [XIO(a) MOV(1,n) ,XIC(a) MOV(m,n) ];
            [MOV(m,n) ,LES(n,1) MOV(1,n) ,GRT(n,9) MOV(9,n) ];
            NOP();
            10:1 network: Refused("`[ROL]( n, m, 3 )`: it has no counterpart there")"#]],
    );
}

#[test]
fn names_and_blocks() {
    check(
        "FUNCTION_BLOCK [$Twice]\nVAR_INPUT in : BOOL; size : DINT := 4; END_VAR\nVAR_OUTPUT out : BOOL; END_VAR\n\
         VAR u : TON; END_VAR\n+--[ ]( in )--[OSR]--[TON]( u, T#1s )--( )( out )--+\nEND_FUNCTION_BLOCK\n\n\
         VAR größe, a__b, y : BOOL; one : $Twice; END_VAR\n\n+--[ ]( größe )--[$Twice]( one, a__b, out => y )--+\n\n\
         +--[$Twice]( y )--<CALL>( Rinse )--+\n\n+--<FUN>( Rinse )--+\n\n+--[ ]( one.out )--( )( y )--<RET>--+\n",
        expect![[r#"
            XIC(S:FS)OTU(risen);
            XIC(in)ONS(risen)TON(u,1000,0)XIC(u.DN)OTE(out);
            XIC(S:FS)OTU(risen);
            XIC(in)ONS(risen)TON(u,1000,0)XIC(u.DN)OTE(out);
            XIC(gr_e)Twice(one,a_b,y);
            Twice(Twice,y,unused)JSR(Rinse,0);
            XIC(one.out)OTE(y)RET();
            1:1 a__b: Approximated("its name is a_b there")
            1:1 größe: Approximated("its name is gr_e there")"#]],
    );
}

/// Which blocks of the library can be written, and why the others cannot.
#[test]
fn blocks_of_the_library_are_add_on_instructions() {
    let mut out = String::new();
    for source in ladder_analysis::library::SOURCES {
        let (file, remarks) = written(source.example);
        let definition = format!("<AddOnInstructionDefinition Name=\"{}", &source.name[1..]);
        let is_written = file.contains(&definition);
        out.push_str(&format!("{}: {is_written}\n", source.name));
        for remark in remarks {
            out.push_str(&format!("    {remark}\n"));
        }
    }
    expect![[r#"
        $Alarm: true
            3:5 tag delay: Approximated("there a time is a DINT in milliseconds")
            11:33 [$Alarm]: Approximated("there a time is a DINT in milliseconds")
        $Alternate: true
        $Average: true
        $Blink: true
            3:5 tag on: Approximated("there a time is a DINT in milliseconds")
            4:5 tag off: Approximated("there a time is a DINT in milliseconds")
            9:46 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            9:46 [$Blink]: Approximated("there a time is a DINT in milliseconds")
        $Debounce: true
            4:5 tag wait: Approximated("there a time is a DINT in milliseconds")
            9:35 [$Debounce]: Approximated("there a time is a DINT in milliseconds")
        $Drum: true
            15:33 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            15:33 [$Drum]: Approximated("there a time is a DINT in milliseconds")
        $FirstOut: true
        $Hysteresis: true
        $Interval: true
            5:5 tag passed: Approximated("there a time is a DINT in milliseconds")
            6:5 tag lasted: Approximated("there a time is a DINT in milliseconds")
            8:24 [$Interval]: Approximated("there a time is a DINT in milliseconds")
        $PID: true
            1:1 $PID: Approximated("its name is PID_own there")
            17:29 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            17:29 [$PID]: Approximated("there a time is a DINT in milliseconds")
        $Ramp: true
            11:38 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            11:38 [$Ramp]: Approximated("there a time is a DINT in milliseconds")
        $RunTime: true
            7:5 tag lasted: Approximated("there a time is a DINT in milliseconds")
            10:33 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            10:33 [$RunTime]: Approximated("there a time is a DINT in milliseconds")
        $Scale: true
        $Step: true
            10:5 tag elapsed: Approximated("there a time is a DINT in milliseconds")
            18:50 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            18:50 [$Step]: Approximated("there a time is a DINT in milliseconds")
        $Toggle: true
        $Total: true
            4:5 tag per: Approximated("there a time is a DINT in milliseconds")
            10:42 [$Interval]: Approximated("there a time is a DINT in milliseconds")
            10:42 [$Total]: Approximated("there a time is a DINT in milliseconds")
        $Amount: true
            8:24 [$Amount]: Approximated("the block counts scans and time only while it runs")
            8:24 [$Amount]: Approximated("there a time is a DINT in milliseconds")
            8:24 [$Amount]: Approximated("what is too large for its type is cut there, and no fault")
        $Belt: true
            11:22 [$Amount]: Approximated("the block counts scans and time only while it runs")
            11:22 [$Amount]: Approximated("there a time is a DINT in milliseconds")
            11:22 [$Amount]: Approximated("what is too large for its type is cut there, and no fault")
        $Cylinder: true
            4:5 tag travel: Approximated("there a time is a DINT in milliseconds")
            11:27 [$Cylinder]: Approximated("the block counts scans and time only while it runs")
            11:27 [$Cylinder]: Approximated("there a time is a DINT in milliseconds")
            11:27 [$Cylinder]: Approximated("what is too large for its type is cut there, and no fault")
        $Heater: true
            4:5 tag lag: Approximated("there a time is a DINT in milliseconds")
            10:25 [$Heater]: Approximated("the block counts scans and time only while it runs")
            10:25 [$Heater]: Approximated("there a time is a DINT in milliseconds")
            10:25 [$Heater]: Approximated("what is too large for its type is cut there, and no fault")
        $Motor: true
            5:5 tag run_up: Approximated("there a time is a DINT in milliseconds")
            11:24 [$Motor]: Approximated("the block counts scans and time only while it runs")
            11:24 [$Motor]: Approximated("there a time is a DINT in milliseconds")
            11:24 [$Motor]: Approximated("what is too large for its type is cut there, and no fault")
        $Noise: true
            8:55 [$Noise]: Approximated("what is too large for its type is cut there, and no fault")
        $Tank: true
            10:36 [$Amount]: Approximated("the block counts scans and time only while it runs")
            10:36 [$Amount]: Approximated("there a time is a DINT in milliseconds")
            10:36 [$Amount]: Approximated("what is too large for its type is cut there, and no fault")
            10:36 [$Tank]: Approximated("what is too large for its type is cut there, and no fault")
        $Valve: true
            4:5 tag travel: Approximated("there a time is a DINT in milliseconds")
            10:21 [$Valve]: Approximated("the block counts scans and time only while it runs")
            10:21 [$Valve]: Approximated("there a time is a DINT in milliseconds")
            10:21 [$Valve]: Approximated("what is too large for its type is cut there, and no fault")
    "#]]
    .assert_eq(&out);
}

#[test]
fn what_is_said_below_the_last_network_stays_there() {
    let (file, remarks) = written("+--[$Hysteresis]( x, 1.0, 2.0 )--( )( y )--+\n\n# The end #\n");
    assert_eq!(remarks, Vec::<String>::new());
    let (definition, program) = file
        .split_once("</AddOnInstructionDefinitions>")
        .expect("it has both");
    assert!(definition.contains("A switch with two thresholds"), "{file}");
    assert!(!definition.contains("The end"), "{file}");
    assert!(program.contains("<![CDATA[The end]]>"), "{file}");
}

#[test]
fn the_library_keeps_its_own_arithmetic() {
    let text = "# ladder: profile logix #\n+--[$Hysteresis]( x, 1.0, 2.0 )--( )( y )--+\n";
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "plant.clad");
    let writing = L5x.write(&analysis).expect("the rest is written");
    let told = writing
        .report
        .remarks()
        .map(|entry| format!("{} {}: {:?}\n", entry.place, entry.element, entry.outcome));
    expect![[r#"
        2:1 network: Refused("`[$Hysteresis]( x, 1.0, 2.0 )`: `$Hysteresis` of the library counts and times as IEC 61131-3 says, and this program as logix does: draw what it does on rungs of the program")
        2:4 [$Hysteresis]: Refused("`$Hysteresis` of the library counts and times as IEC 61131-3 says, and this program as logix does: draw what it does on rungs of the program")
    "#]].assert_eq(&told.collect::<String>());
}

#[test]
fn rungs_of_a_tag_that_cannot_be_declared_are_refused_with_it() {
    check(
        "TYPE Row : ARRAY[0..2] OF INT; END_TYPE\nVAR rows : ARRAY[0..1] OF Row; n : INT; END_VAR\n\
         +--[MOV]( n, rows[1, 2] )--+\n+--[MOV]( n, 1 )--+\n",
        expect![[r#"
            NOP();
            MOV(1,n);
            2:5 tag rows: Refused("an array of arrays has no counterpart there")
            3:1 network: Refused("`[MOV]( n, rows[1, 2] )`: `rows` cannot be declared: an array of arrays has no counterpart there")"#]],
    );
}

/// What XML cannot hold is a blank, in comments as in names and texts.
#[test]
fn what_xml_cannot_hold() {
    let text = "VAR\n    s : STRING := 'a]]>\u{fffe}b';  # \u{ffff} ]]> #\nEND_VAR\n\n# \u{fffe}\u{1} ]]> #\n+--[ ]( x )--( )( y )--+\n";
    let (xml, _) = written(text);
    let held = |c: char| !matches!(c, '\u{fffe}' | '\u{ffff}' | '\u{1}');
    assert!(xml.chars().all(held), "{xml}");
    let read = L5x.read(&ladder_notation::Source::alone("test", xml.as_bytes()));
    assert!(read.is_ok(), "{xml}");
}

#[test]
fn presets_and_instances_are_data() {
    let (file, remarks) = written(
        "FUNCTION_BLOCK [$Motor]\nVAR_INPUT speed : DINT := 7; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\nVAR t : TON; END_VAR\n\
         +--[ ]( EN )--[TON]( t, T#2s )--( )( run )--+\nEND_FUNCTION_BLOCK\n\nTYPE\n    Zone : STRUCT\n        watch : TON;\n        on : \
         BOOL;\n    END_STRUCT;\nEND_TYPE\nVAR zone : ARRAY[0..1] OF Zone; k : DINT; c : ARRAY[0..1, 0..1] OF CTU; a : BOOL; m : \
         ARRAY[0..1] OF $Motor; END_VAR\n+--[ ]( a )--[TON]( zone[k].watch, 5s )--( )( zone[0].on )--+\n+--[ ]( a )--[CTU]( c[1, 0], \
         3 )--+\n+--[ ]( a )--[$Motor]( m[1] )--+\n",
    );
    assert_eq!(remarks, Vec::<String>::new());
    let data = file.lines().filter(|line| {
        [
            "\"PRE\"",
            "<Tag ",
            "<LocalTag ",
            "Index=",
            "\"Motor\"",
            "\"speed\"",
            "\"Enable",
        ]
        .iter()
        .any(|word| line.contains(word))
    });
    expect![[r#"
        <AddOnInstructionDefinition Name="Motor" Revision="1.0" ExecutePrescan="false" ExecutePostscan="false" ExecuteEnableInFalse="true" SoftwareRevision="v33.01">
        <Parameter Name="EnableIn" TagType="Base" DataType="BOOL" Usage="Input" Radix="Decimal" Required="false" Visible="false" ExternalAccess="Read/Write">
        <Parameter Name="EnableOut" TagType="Base" DataType="BOOL" Usage="Output" Radix="Decimal" Required="false" Visible="false" ExternalAccess="Read Only">
        <Parameter Name="speed" TagType="Base" DataType="DINT" Usage="Input" Radix="Decimal" Required="false" Visible="false" ExternalAccess="Read/Write">
        <LocalTag Name="t" DataType="TIMER" ExternalAccess="None">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="2000"/>
        <Routine Name="EnableInFalse" Type="RLL">
        <Tag Name="zone" TagType="Base" DataType="Zone" Dimensions="2" Constant="false" ExternalAccess="Read/Write">
        <Element Index="[0]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="5000"/>
        <Element Index="[1]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="5000"/>
        <Tag Name="k" TagType="Base" DataType="DINT" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
        <Tag Name="c" TagType="Base" DataType="COUNTER" Dimensions="2 2" Constant="false" ExternalAccess="Read/Write">
        <Element Index="[0,0]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="0"/>
        <Element Index="[0,1]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="0"/>
        <Element Index="[1,0]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="3"/>
        <Element Index="[1,1]">
        <DataValueMember Name="PRE" DataType="DINT" Radix="Decimal" Value="0"/>
        <Tag Name="a" TagType="Base" DataType="BOOL" Radix="Decimal" Constant="false" ExternalAccess="Read/Write">
        <Tag Name="m" TagType="Base" DataType="Motor" Dimensions="2" Constant="false" ExternalAccess="Read/Write">
        <Array DataType="Motor" Dimensions="2">
        <Element Index="[0]">
        <Structure DataType="Motor">
        <DataValueMember Name="EnableIn" DataType="BOOL" Radix="Decimal" Value="1"/>
        <DataValueMember Name="EnableOut" DataType="BOOL" Radix="Decimal" Value="0"/>
        <DataValueMember Name="speed" DataType="DINT" Radix="Decimal" Value="7"/>
        <Element Index="[1]">
        <Structure DataType="Motor">
        <DataValueMember Name="EnableIn" DataType="BOOL" Radix="Decimal" Value="1"/>
        <DataValueMember Name="EnableOut" DataType="BOOL" Radix="Decimal" Value="0"/>
        <DataValueMember Name="speed" DataType="DINT" Radix="Decimal" Value="7"/>"#]].assert_eq(&data.collect::<Vec<_>>().join("\n"));
}
