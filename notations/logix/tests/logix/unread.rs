//! What is not read is an unread part, which goes back as it came.

use crate::back::back;
use crate::exports::{controller, routine, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Source, convert};
use ladder_notation_logix::{L5k, L5x, Rslogix500};

/// The networks and the unread parts of a program, and the report.
#[track_caller]
fn shows(notation: &dyn Notation, file: &str, expected: Expect) -> Converted {
    let converted = converted(notation, file.as_bytes());
    let text = &converted.written.text;
    let own = text.find("\n+").unwrap_or_default();
    let kept: Vec<&str> = text[own..]
        .split("\n\n")
        .filter(|part| {
            !part.contains("FUNCTION_BLOCK") || part.contains("# ladder: unread") || part.contains("Add-On")
        })
        .collect();
    let remarks = converted.report.remarks();
    let remarks = remarks.map(|entry| format!("{} {}: {:?}", entry.place, entry.element, entry.outcome));
    let shown = format!(
        "{}\n\n{}",
        kept.join("\n\n").trim(),
        remarks.collect::<Vec<_>>().join("\n")
    );
    expected.assert_eq(&shown);
    converted
}

/// The rungs and routines of what is written from a program.
#[track_caller]
fn goes_back(text: &str, expected: Expect) {
    let (file, again) = back(text).expect("it has no errors");
    let begin = file.rfind("<Routines>").expect("routines");
    let end = file.rfind("</Routines>").expect("routines");
    expected.assert_eq(&file[begin..end]);
    assert_eq!(
        again.matches("# ladder: unread").count(),
        text.matches("# ladder: unread").count()
    );
}

#[test]
fn instructions() {
    let tags = [
        ("a", "BOOL", ""),
        ("y", "BOOL", ""),
        ("n", "DINT", ""),
        ("s", "STRING", ""),
        ("w", "DINT[4]", ""),
        ("i", "DINT", ""),
        ("m", "MESSAGE", ""),
        ("sub", "= w[2]", ""),
    ];
    let rungs = [
        "GRT(s.DATA[1],0)OTE(y);",
        "[XIC(a) ,XIO(s.DATA[i].3) ]OTE(y);",
        "XIC(a)MSG(m)OTE(y);",
        "XIC(a)GSV(WallClockTime,,DateTime,w[0])SSV(Task,Fast,Rate,n);",
        "XIC(a)XYZ(sub,n + i,'it''s')ADD(s.DATA[0],3,n);",
        "JSR(Nowhere,1,n);",
        "MOV(n,Rack:O.Data[i])XIC(Rack:I.Fault)OTE(y);",
        "PID(Rack:I.Ch0,n,0,i,0,0,0)TON(s,?,?);",
    ];
    let read = shows(
        &L5x,
        &controller(&tags, &rungs),
        expect![[r#"
            +-------------------------------------------[$GRT]( 's.DATA[1],0' )--( )( y )--+

            +--\--[ ]( a )----------------------------------------------------\--( )( y )--+
            |  /-------------------------------------[$XIO]( 's.DATA[i].3' )--/            |

            +--[ ]( a )-------------------------------------------[$MSG]( 'm' )--( )( y )--+

            +--[ ]( a )----------------[$GSV]( 'WallClockTime,,DateTime,w[0]' )--[$SSV]( 'Task,Fast,Rate,n' )--+

            +--[ ]( a )------[$XYZ]( 'sub,n + i,$'it$'$'s$'' )--[$ADD]( 's.DATA[0],3,n' )--+

            +-----------------------------------------------------[$JSR]( 'Nowhere,1,n' )--+

            +--[$MOV]( 'n,Rack:O.Data[i]' )--[ ]( Rack_I_Fault )-----------------( )( y )--+

            +---------[$unread_PID]( 'Rack:I.Ch0,n,0,i,0,0,0' )--[$unread_TON]( 's,?,?' )--+

            # GRT: `s` has no such part; it is not run here, and no power passes. #
            FUNCTION_BLOCK [$GRT]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK

            # XIO: `s` has no such part; it is not run here, and no power passes. #
            FUNCTION_BLOCK [$XIO]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK

            # MSG: it has no counterpart here; it is not run here, and power passes. #
            FUNCTION_BLOCK [$MSG]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # GSV: it has no counterpart here; it is not run here, and power passes. #
            FUNCTION_BLOCK [$GSV]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes w #
            END_FUNCTION_BLOCK

            # SSV: it has no counterpart here; it is not run here, and power passes. #
            FUNCTION_BLOCK [$SSV]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            END_FUNCTION_BLOCK

            # XYZ: it has no counterpart here; it is not run here, and power passes. #
            FUNCTION_BLOCK [$XYZ]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # ADD: `s` has no such part; it is not run here, and power passes. #
            FUNCTION_BLOCK [$ADD]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes n #
            END_FUNCTION_BLOCK

            # JSR: there is no routine `Nowhere` in the program; it is not run here, and power passes. #
            FUNCTION_BLOCK [$JSR]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # MOV: `Rack:O` is not declared in the file; it is not run here, and power passes. #
            FUNCTION_BLOCK [$MOV]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            END_FUNCTION_BLOCK

            # PID: `Rack:I` is not declared in the file; it is not run here, and power passes. #
            FUNCTION_BLOCK [$unread_PID]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # TON: `s` is no TIMER; it is not run here, and power passes. #
            FUNCTION_BLOCK [$unread_TON]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes s #
            END_FUNCTION_BLOCK

            22:10 GRT(s.DATA[1],0): Approximated("`s` has no such part: it is not run, and no power passes")
            27:19 XIO(s.DATA[i].3): Approximated("`s` has no such part: it is not run, and no power passes")
            32:16 MSG(m): Approximated("it has no counterpart here: it is not run, and power passes")
            37:16 GSV(WallClockTime,,DateTime,w[0]): Approximated("it has no counterpart here: it is not run, and power passes")
            37:49 SSV(Task,Fast,Rate,n): Approximated("it has no counterpart here: it is not run, and power passes")
            42:16 XYZ(sub,n + i,'it''s'): Approximated("it has no counterpart here: it is not run, and power passes")
            42:38 ADD(s.DATA[0],3,n): Approximated("`s` has no such part: it is not run, and power passes")
            47:10 JSR(Nowhere,1,n): Approximated("there is no routine `Nowhere` in the program: it is not run, and power passes")
            52:10 MOV(n,Rack:O.Data[i]): Approximated("`Rack:O` is not declared in the file: it is not run, and power passes")
            57:10 PID(Rack:I.Ch0,n,0,i,0,0,0): Approximated("`Rack:I` is not declared in the file: it is not run, and power passes")
            57:37 TON(s,?,?): Approximated("`s` is no TIMER: it is not run, and power passes")"#]],
    );
    expect![[r#"
        y
        0"#]]
    .assert_eq(&trace(&read.written.text, "a\n1\n", 1, "y"));
    goes_back(
        &read.written.text,
        expect![[r#"
            <Routines>
            <Routine Name="MainRoutine" Type="RLL">
            <RLLContent>
            <Rung Number="0" Type="N">
            <Text>
            <![CDATA[GRT(s.DATA[1],0)OTE(y);]]>
            </Text>
            </Rung>
            <Rung Number="1" Type="N">
            <Text>
            <![CDATA[[XIC(a) ,XIO(s.DATA[i].3) ]OTE(y);]]>
            </Text>
            </Rung>
            <Rung Number="2" Type="N">
            <Text>
            <![CDATA[XIC(a)MSG(m)OTE(y);]]>
            </Text>
            </Rung>
            <Rung Number="3" Type="N">
            <Text>
            <![CDATA[XIC(a)GSV(WallClockTime,,DateTime,w[0])SSV(Task,Fast,Rate,n);]]>
            </Text>
            </Rung>
            <Rung Number="4" Type="N">
            <Text>
            <![CDATA[XIC(a)XYZ(sub,n + i,'it''s')ADD(s.DATA[0],3,n);]]>
            </Text>
            </Rung>
            <Rung Number="5" Type="N">
            <Text>
            <![CDATA[JSR(Nowhere,1,n);]]>
            </Text>
            </Rung>
            <Rung Number="6" Type="N">
            <Text>
            <![CDATA[MOV(n,Rack:O.Data[i])XIC(Rack_I_Fault)OTE(y);]]>
            </Text>
            </Rung>
            <Rung Number="7" Type="N">
            <Text>
            <![CDATA[PID(Rack:I.Ch0,n,0,i,0,0,0)TON(s,?,?);]]>
            </Text>
            </Rung>
            </RLLContent>
            </Routine>
        "#]],
    );
}

#[test]
fn conditions_without_a_counterpart_give_no_power() {
    shows(
        &L5x,
        &controller(
            &[("r", "REAL", ""), ("s", "STRING", ""), ("y", "BOOL", "")],
            &["IsNAN(r)OTE(y);", "XIC(y)RTOS(r,s);"],
        ),
        expect![[r#"
            +---------------------------------------------------[$IsNAN]( 'r' )--( )( y )--+

            +--[ ]( y )--------------------------------------------------[$RTOS]( 'r,s' )--+

            # IsNAN: it has no counterpart here; it is not run here, and no power passes. #
            FUNCTION_BLOCK [$IsNAN]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK

            # RTOS: it has no counterpart here; it is not run here, and power passes. #
            FUNCTION_BLOCK [$RTOS]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes s #
            END_FUNCTION_BLOCK

            17:10 IsNAN(r): Approximated("it has no counterpart here: it is not run, and no power passes")
            22:16 RTOS(r,s): Approximated("it has no counterpart here: it is not run, and power passes")"#]],
    );
}

#[test]
fn what_a_message_fetches_is_written() {
    let message = |kind: &str| {
        format!(
            "<Tag Name=\"m\" TagType=\"Base\" DataType=\"MESSAGE\"><Data Format=\"Message\"><MessageParameters \
             MessageType=\"{kind}\" LocalElement=\"w[0]\"/></Data></Tag>\n"
        )
    };
    for (kind, writes) in [
        ("CIP Data Table Read", "writes m, w"),
        ("CIP Data Table Write", "writes m #"),
    ] {
        let file = controller(&[("w", "DINT[4]", "")], &["MSG(m);"]);
        let file = file.replace("<Tags>\n<Tag", &format!("<Tags>\n{}<Tag", message(kind)));
        let text = converted(&L5x, file.as_bytes()).written.text;
        assert!(text.contains(&format!("# ladder: unread, {writes}")), "{text}");
    }
}

#[test]
fn routines_in_other_languages() {
    let text = "<Routine Name=\"Calc\" Type=\"ST\">\n<STContent>\n<Line Number=\"0\">\n<![CDATA[IF go THEN // #1]]>\n</Line>\n\
                <Line Number=\"1\">\n<![CDATA[    speed ?= 10;]]>\n</Line>\n<Line Number=\"2\">\n<![CDATA[END_IF;]]>\n</Line>\n\
                </STContent>\n</Routine>\n";
    let chart = "<Routine Name=\"Draw\" Type=\"FBD\"><FBDContent SheetSize=\"Letter\"><Sheet Number=\"1\"/></FBDContent></Routine>\n";
    let file = whole(
        "",
        &[("go", "BOOL", ""), ("speed", "DINT", "")],
        &[(
            "Main",
            &["JSR(Calc,0)OTE(go);", "JSR(Draw,0);", "JSR(Calc,1,speed,speed);"],
        )],
    );
    let file = file.replace("</Routines>", &format!("{text}{chart}</Routines>"));
    let read = shows(
        &L5x,
        &file,
        expect![[r#"
            +---------------------------------------------------<CALL>( Calc )--( )( go )--+

            +--------------------------------------------------------------<CALL>( Draw )--+

            +--------------------------------------------------------------<CALL>( Calc )--+

            +--<FUN>( Calc )---------------------------------------------------------------+

            +-------------------------------------------------------------[$routine_Calc]--+

            +--<FUN>( Draw )---------------------------------------------------------------+

            +-------------------------------------------------------------[$routine_Draw]--+

            # routine Calc: it is structured text, and not read: line 2 does not parse: `:=` is expected here, not `?`; it is not run here. #
            FUNCTION_BLOCK [$routine_Calc]
            # ladder: unread, writes go, speed #
            # IF go THEN // \h1 #
            #     speed ?= 10; #
            # END_IF; #
            END_FUNCTION_BLOCK

            # routine Draw: it is a function block diagram; it is not run here. #
            FUNCTION_BLOCK [$routine_Draw]
            # ladder: unread, writes #
            # <FBDContent SheetSize="Letter"><Sheet Number="1"/></FBDContent> #
            END_FUNCTION_BLOCK

            26:10 JSR(Calc,1,speed,speed): Approximated("the routine takes fewer values than it is given")
            31:1 routine Calc: Approximated("it is structured text, and not read: line 2 does not parse: `:=` is expected here, not `?`: it is not run")
            44:1 routine Draw: Approximated("it is a function block diagram: it is not run")"#]],
    );
    goes_back(
        &read.written.text,
        expect![[r#"
            <Routines>
            <Routine Name="MainRoutine" Type="RLL">
            <RLLContent>
            <Rung Number="0" Type="N">
            <Text>
            <![CDATA[JSR(Calc,0)OTE(go);]]>
            </Text>
            </Rung>
            <Rung Number="1" Type="N">
            <Text>
            <![CDATA[JSR(Draw,0);]]>
            </Text>
            </Rung>
            <Rung Number="2" Type="N">
            <Text>
            <![CDATA[JSR(Calc,0);]]>
            </Text>
            </Rung>
            </RLLContent>
            </Routine>
            <Routine Name="Calc" Type="ST">
            <STContent>
            <Line Number="0">
            <![CDATA[IF go THEN // #1]]>
            </Line>
            <Line Number="1">
            <![CDATA[    speed ?= 10;]]>
            </Line>
            <Line Number="2">
            <![CDATA[END_IF;]]>
            </Line>
            </STContent>
            </Routine>
            <Routine Name="Draw" Type="FBD">
            <FBDContent SheetSize="Letter"><Sheet Number="1"/></FBDContent>
            </Routine>
        "#]],
    );
}

#[test]
fn routines_that_may_be_left() {
    let file = whole(
        "",
        &[("s", "STRING", ""), ("n", "DINT", "")],
        &[
            ("Main", &["JSR(Sub,0,n);"]),
            ("Sub", &["ADD(n,1,n);", "EQU(n,3)RET(s.DATA[0]);", "CLR(n);"]),
        ],
    );
    let read = shows(
        &L5x,
        &file,
        expect![[r#"
            +-----------------------------------------<CALL>( Sub )--[MOV]( n, Sub_RET1 )--+

            +--<FUN>( Sub )----------------------------------------------------------------+

            +--------------------------------------------------------------[$routine_Sub]--+

            # routine Sub: `RET(s.DATA[0])` in it is not read (`s` has no such part); it is not run here. #
            FUNCTION_BLOCK [$routine_Sub]
            # ladder: unread, writes n, s, Sub_RET1 #
            # ADD(n,1,n); #
            # EQU(n,3)RET(s.DATA[0]); #
            # CLR(n); #
            END_FUNCTION_BLOCK

            21:1 routine Sub: Approximated("`RET(s.DATA[0])` in it is not read (`s` has no such part): it is not run")"#]],
    );
    let (file, _) = back(&read.written.text).expect("it has no errors");
    assert!(file.contains("<![CDATA[EQU(n,3)RET(s.DATA[0]);]]>"), "{file}");
}

#[test]
fn add_on_instructions() {
    let parameter = |name: &str, usage: &str| {
        format!(
            "<Parameter Name=\"{name}\" TagType=\"Base\" DataType=\"DINT\" Usage=\"{usage}\" Required=\"true\"/>\n"
        )
    };
    let before = format!(
        "<AddOnInstructionDefinitions>\n<AddOnInstructionDefinition Name=\"Scale\">\n<Parameters>\n{}{}</Parameters>\n<Routines>\n\
         <Routine Name=\"Logic\" Type=\"ST\"><STContent><Line Number=\"0\"><![CDATA[Out ?= In * 2;]]></Line></STContent></Routine>\n\
         </Routines>\n</AddOnInstructionDefinition>\n<EncodedData EncodedType=\"AddOnInstructionDefinition\" Name=\"Secret\">abc</EncodedData>\n\
         </AddOnInstructionDefinitions>\n",
        parameter("In", "Input"),
        parameter("Out", "Output"),
    );
    let file = whole(
        &before,
        &[
            ("n", "DINT", ""),
            ("m", "DINT", ""),
            ("k", "Scale", ""),
            ("x", "Secret", ""),
        ],
        &[("Main", &["Scale(k,n,m);", "Secret(x,n,m);"])],
    );
    let read = shows(
        &L5x,
        &file,
        expect![[r#"
            +--------------------------------------------[$Scale]( k, In := n, Out => m )--+

            +-------------------------------------------------------------------[$Secret]--+

            # Add-On Instruction Scale #
            FUNCTION_BLOCK [$Scale]
            VAR_INPUT
                In : DINT := 0;
            END_VAR
            VAR_OUTPUT
                Out : DINT;
            END_VAR

            +--[/]( EN )------------------------------------------------------------<RET>--+

            # Secret: its source is protected; it is not run here, and power passes. #
            FUNCTION_BLOCK [$Secret]
            # ladder: unread, writes m, n, x #
            # x,n,m #
            # <EncodedData EncodedType="AddOnInstructionDefinition" Name="Secret">abc</EncodedData> #
            END_FUNCTION_BLOCK

            # routine Logic of Scale: it is structured text, and not read: line 1 does not parse: `:=` is expected here, not `?`; it is not run here. #
            FUNCTION_BLOCK [$routine_Logic]
            # ladder: unread, writes In, Out #
            # Out ?= In * 2; #
            END_FUNCTION_BLOCK

            11:1 routine Logic of Scale: Approximated("it is structured text, and not read: line 1 does not parse: `:=` is expected here, not `?`: it is not run")
            14:1 Add-On Instruction Secret: Approximated("its source is protected: its calls are not run")
            35:10 Secret(x,n,m): Approximated("its source is protected: it is not run, and power passes")"#]],
    );
    let (file, _) = back(&read.written.text).expect("it has no errors");
    assert!(file.contains("<Routine Name=\"Logic\" Type=\"ST\">"), "{file}");
    assert!(file.contains("<![CDATA[Secret(x,n,m);]]>"), "{file}");
}

#[test]
fn tasks_that_run_at_other_times() {
    let program = |name: &str, more: &str, rung: &str| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\"{more}>\n<Tags/>\n<Routines>\n{}</Routines>\n</Program>\n",
            routine("Main", &[rung])
        )
    };
    let task = |name: &str, kind: &str, program: &str| {
        format!(
            "<Task Name=\"{name}\" {kind}><ScheduledPrograms><ScheduledProgram Name=\"{program}\"/></ScheduledPrograms></Task>\n"
        )
    };
    let file = controller(
        &[
            ("a", "DINT", ""),
            ("b", "DINT", ""),
            ("c", "DINT", ""),
            ("d", "DINT", ""),
        ],
        &[],
    );
    let begin = file.find("<Programs>").expect("programs");
    let file = format!(
        "{}<Programs>\n{}{}{}{}{}</Programs>\n<Tasks>\n{}{}{}{}{}</Tasks>\n</Controller>\n</RSLogix5000Content>\n",
        &file[..begin],
        program("One", "", "ADD(a,1,a);"),
        program("Two", "", "ADD(b,1,b);"),
        program("Three", "", "ADD(c,1,c);"),
        program("Four", "", "ADD(d,1,d);"),
        program("Five", " Disabled=\"true\"", "ADD(d,1,d);"),
        task("Fast", "Type=\"PERIODIC\" Rate=\"10\"", "Two"),
        task("Main", "Type=\"CONTINUOUS\"", "One"),
        task("Call", "Type=\"EVENT\"", "Three"),
        task("Off", "Type=\"PERIODIC\" InhibitTask=\"true\"", "Four"),
        task("Also", "Type=\"PERIODIC\"", "Five"),
    );
    let read = shows(
        &L5x,
        &file,
        expect![[r#"
            +----------------------------------------------------------<CALL>( Two_Main )--+

            +----------------------------------------------------------<CALL>( One_Main )--+

            # program Three: task Call runs it on an event #
            +--[ ]( SYS.OFF )----------------------------------------<CALL>( Three_Main )--+

            +--<FUN>( One_Main )-----------------------------------------------------------+

            +------------------------------------------------------------[ADD]( a, a, 1 )--+

            +--<FUN>( Two_Main )-----------------------------------------------------------+

            +--------------------------------------------------------------[$program_Two]--+

            +------------------------------------------------------------[ADD]( b, b, 1 )--+

            +--<FUN>( Three_Main )---------------------------------------------------------+

            +------------------------------------------------------------[$program_Three]--+

            +------------------------------------------------------------[ADD]( c, c, 1 )--+

            +--<FUN>( Four_Main )----------------------------------------------------------+

            +------------------------------------------------------------[ADD]( d, d, 1 )--+

            +--<FUN>( Five_Main )----------------------------------------------------------+

            +------------------------------------------------------------[ADD]( d, d, 1 )--+

            # program Two: task Fast runs it at times of its own, whatever else runs; here it runs in each scan. #
            FUNCTION_BLOCK [$program_Two]
            # ladder: unread, at any time, writes b #
            # the checksum of its rungs is 09fefe48171bda51 #
            END_FUNCTION_BLOCK

            # program Three: task Call runs it on an event; it is not run here. #
            FUNCTION_BLOCK [$program_Three]
            # ladder: unread, at any time, writes c #
            # the checksum of its rungs is d00d13880040fe11 #
            END_FUNCTION_BLOCK

            25:1 program Two: Approximated("task Fast runs it at times of its own, whatever else runs; here it runs in each scan")
            39:1 program Three: Approximated("task Call runs it on an event; it is not run here")
            53:1 program Four: Approximated("no task runs its main routine, or it is inhibited: its routines are functions that nothing calls")
            67:1 program Five: Approximated("no task runs its main routine, or it is inhibited: its routines are functions that nothing calls")"#]],
    );
    expect![[r#"
        a,b,c,d
        1,1,0,0
        2,2,0,0"#]]
    .assert_eq(&trace(&read.written.text, "", 2, "a,b,c,d"));
}

#[test]
fn of_other_files() {
    shows(
        &L5k,
        "CONTROLLER Cell ()\nTAG go : BOOL := 0; END_TAG\nPROGRAM P (MAIN := \"Main\")\nROUTINE Main ()\nN: XIC(go)JSR(Calc,0);\n\
         END_ROUTINE\nST_ROUTINE Calc ()\n'go := 1;\n'  (* # *)\nEND_ST_ROUTINE\nEND_PROGRAM\nEND_CONTROLLER\n",
        expect![[r#"
            +--[ ]( go )---------------------------------------------------<CALL>( Calc )--+

            +--<FUN>( Calc )---------------------------------------------------------------+

            +-----------------------------------------------------------[MOV]( go, TRUE )--+

        "#]],
    );
    shows(
        &Rslogix500,
        "SOR XIC B3/1 DDV N7:0 N7:1 OTE B3/2 EOR\nSOR XIC B3/1 SUS 3 EOR\n",
        expect![[r#"
            +-------------------------------------------------------------[$routine_Main]--+

            # routine Main: `SUS 3` in it is not read (it has no counterpart here); it is not run here. #
            FUNCTION_BLOCK [$routine_Main]
            # ladder: unread #
            # SOR XIC B3/1 DDV N7:0 N7:1 OTE B3/2 EOR #
            # SOR XIC B3/1 SUS 3 EOR #
            END_FUNCTION_BLOCK

            1:1 routine Main: Approximated("`SUS 3` in it is not read (it has no counterpart here): it is not run")"#]],
    );
}

#[test]
fn of_two_of_one_name_the_second_is_refused() {
    let two = "<DataTypes><DataType Name=\"T\"><Members><Member Name=\"a\" DataType=\"DINT\"/><Member Name=\"A\" \
               DataType=\"DINT\"/></Members></DataType><DataType Name=\"t\"><Members/></DataType></DataTypes>\n";
    let rungs: &[&str] = &["NOP();"];
    let file = whole(
        two,
        &[("n", "DINT", ""), ("N", "DINT", "")],
        &[("Main", rungs), ("Main", rungs)],
    );
    let read =
        convert(&L5x, &Source::alone("prog", file.as_bytes()), &Options::default()).expect("it is read");
    let refused = read.report.remarks();
    let refused = refused.map(|entry| format!("{} {}: {:?}", entry.place, entry.element, entry.outcome));
    expect![[r#"
        4:12 member A of type T: Refused("there is another one of that name before it")
        4:129 type t: Refused("there is another one of that name before it")
        7:1 tag N: Refused("there is another one of that name before it")
        22:1 routine Main of program MainProgram: Refused("there is another one of that name before it")"#]]
    .assert_eq(&refused.collect::<Vec<_>>().join("\n"));
}
