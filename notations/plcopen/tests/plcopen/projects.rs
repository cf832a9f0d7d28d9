//! Types, globals, tasks; several programs; the files of a workspace.

use crate::harness::{check, project, short, unit};
use expect_test::expect;
use ladder_format::Options;
use ladder_notation::{Source, convert};
use ladder_notation_plcopen::Plcopen;

const TYPES: &str = r#"
<dataType name="Phase"><baseType><enum><values><value name="IDLE"/><value name="FILLING" value="5"/></values></enum></baseType><initialValue><simpleValue value="FILLING"/></initialValue></dataType>
<dataType name="Motor"><baseType><struct>
  <variable name="speed"><type><REAL/></type><initialValue><simpleValue value="50"/></initialValue></variable>
  <variable name="times"><type><array><dimension lower="0" upper="3"/><baseType><TIME/></baseType></array></type></variable>
</struct></baseType></dataType>
<dataType name="Percent"><baseType><subrangeSigned><range lower="0" upper="100"/><baseType><INT/></baseType></subrangeSigned></baseType></dataType>
<dataType name="Far"><baseType><pointer><baseType><INT/></baseType></pointer></baseType></dataType>
"#;

const VARIABLES: &str = r#"<interface>
<localVars retain="true"><variable name="total"><type><DINT/></type></variable></localVars>
<localVars constant="true"><variable name="limit"><type><INT/></type><initialValue><simpleValue value="80"/></initialValue></variable></localVars>
<localVars>
<variable name="out" address="%QX0.1"><type><BOOL/></type><documentation><xhtml:p>the   pump</xhtml:p></documentation></variable>
<variable name="deep" address="%IX0.1.2"><type><BOOL/></type></variable>
<variable name="phase"><type><derived name="Phase"/></type><initialValue><simpleValue value="IDLE"/></initialValue></variable>
<variable name="motor"><type><derived name="Motor"/></type><initialValue><structValue><value member="speed"><simpleValue value="20"/></value></structValue></initialValue></variable>
<variable name="mix"><type><array><dimension lower="1" upper="4"/><baseType><INT/></baseType></array></type><initialValue><arrayValue><value><simpleValue value="1"/></value><value repetitionValue="3"><simpleValue value="2"/></value></arrayValue></initialValue></variable>
<variable name="text"><type><string length="20"/></type><initialValue><simpleValue value="'it$'s'"/></initialValue></variable>
<variable name="far"><type><derived name="Far"/></type></variable>
<variable name="share"><type><derived name="Percent"/></type></variable>
</localVars>
<tempVars><variable name="hold"><type><BOOL/></type></variable></tempVars>
<externalVars><variable name="level"><type><INT/></type></variable><variable name="gone"><type><INT/></type></variable></externalVars>
</interface>"#;

fn first() -> String {
    let body = short(
        "leftPowerRail 1
         contact 2 from=1 out
         inVariable 3 phase
         inVariable 4 FILLING
         block 5 EQ IN1=3 IN2=4 / OUT
         coil 6 from=5 out
         inVariable 7 motor.speed
         inVariable 8 level
         inVariable 9 mix[2]
         block 10 ADD IN1=8 IN2=9 / OUT
         outVariable 11 from=10 LEVEL
         coil 12 from=2 hold",
    );
    format!("<pou name=\"First\" pouType=\"program\">{VARIABLES}<body><LD>{body}</LD></body></pou>")
}

fn plant() -> String {
    let second = unit(
        "program",
        "Second",
        "out : BOOL\nhold : BOOL",
        &format!(
            "<FBD>{}</FBD>",
            short("inVariable 1 hold\noutVariable 2 from=1 out\nreturn 3 from=1")
        ),
    );
    let idle = unit("program", "Idle", "x : INT", "<ST>x := x + 1;</ST>");
    let instances = r#"<configuration name="c"><globalVars><variable name="level"><type><INT/></type></variable></globalVars><resource name="r">
<task name="slow" interval="T#1s" priority="5"><pouInstance name="a" typeName="First"/></task>
<task name="fast" interval="T#0.02s" priority="1"><pouInstance name="b" typeName="Second"/><pouInstance name="b2" typeName="Second"/><pouInstance name="z" typeName="Nothing"/></task>
</resource></configuration>"#;
    project(TYPES, &(first() + &second + &idle), instances)
}

#[test]
fn several_programs_in_one() {
    check(
        &plant(),
        expect![[r#"
            # ladder: cycle 20ms #

            TYPE
                Phase   : (IDLE, FILLING := 5) := FILLING;
                Motor   : STRUCT
                    speed : REAL := 50.0;
                    times : ARRAY[0..3] OF TIME;
                END_STRUCT;
                Percent : INT(0..100);
            END_TYPE

            VAR_GLOBAL
                level : INT;
            END_VAR

            # First in task slow: it runs every 1s there, between any two networks of the other tasks. #
            FUNCTION_BLOCK [$First_in_task_slow]
            # ladder: unread, at any time, writes total, First_out, phase, motor, mix, text, share, First_hold, level #
            # every 1s #
            END_FUNCTION_BLOCK

            # of Second #
            VAR
                out  : BOOL;
                hold : BOOL;
            END_VAR

            # of Second #
            VAR
                Second_out  : BOOL;  # out in the project #
                Second_hold : BOOL;  # hold in the project #
            END_VAR

            # of First #
            VAR RETAIN
                total : DINT;
            END_VAR
            VAR CONSTANT
                limit : INT := 80;
            END_VAR
            VAR
                First_out  AT %QX0.1 : BOOL;  # out in the project: the pump #
                phase                : Phase              := IDLE;
                motor                : Motor              := (speed := 20.0);
                mix                  : ARRAY[1..4] OF INT := [1, 3(2)];
                text                 : STRING[20]         := 'it$'s';
                share                : Percent;
                First_hold           : BOOL;  # hold in the project #
            END_VAR
            VAR_INPUT
                deep : BOOL;  # AT %IX0.1.2 in the project #
            END_VAR

            # of Idle #
            VAR
                x : INT;
            END_VAR

            +-------------------------------------------------------[$First_in_task_slow]--+

            +------------------------------------------------------------<CALL>( Second )--+

            +----------------------------------------------------------<CALL>( Second_2 )--+

            +-------------------------------------------------------------<CALL>( First )--+

            +--<FUN>( Second )-------------------------------------------------------------+

            +--[ ]( hold )--\-----------------------------------------------( )( out )--\--+
            |               /----------------------------------------------------<RET>--/  |

            +--<FUN>( Second_2 )-----------------------------------------------------------+

            +--[ ]( Second_hold )--\---------------------------------( )( Second_out )--\--+
            |                      /---------------------------------------------<RET>--/  |

            +--<FUN>( First )--------------------------------------------------------------+

            # motor.speed, which nothing is wired to #
            +--[EQ]( phase, FILLING )------------------------------------( )( First_out )--+

            +-----------------------------------------------[ADD]( level, level, mix[2] )--+

            +--[ ]( First_out )-----------------------------------------( )( First_hold )--+

            +--<FUN>( Idle )---------------------------------------------------------------+

            +----------------------------------------------------------[CALC]( x, x + 1 )--+
            approximated type Far: a pointer has no counterpart; it is not declared
            approximated variable out: it is spelled `First_out` here
            approximated variable deep AT %IX0.1.2: there is no such address here: the tag has none
            approximated variable far: the type `Far` is not declared: a pointer has no counterpart; it is not declared
            approximated variable hold: it keeps its value from one scan to the next here
            approximated variable hold: it is spelled `First_hold` here
            approximated variable gone: the project has no global of this name; it is not declared
            approximated input motor.speed: nothing is wired to it: it is a comment
            approximated program Idle: no task runs it: it is a function that nothing calls
            approximated task slow: it runs every 1s there, and in every scan here
            refused instance of Nothing: there is no such program
        "#]],
    );
}

#[test]
fn several_programs_as_files() {
    let xml = plant();
    let converted = convert(
        &Plcopen,
        &Source::alone("plant", xml.as_bytes()),
        &Options::default(),
    );
    let files = converted.expect("the project is read").files;
    let mut all = String::new();
    for file in files {
        all.push_str(&format!(
            "== {}\n{}",
            file.name,
            String::from_utf8_lossy(&file.bytes)
        ));
    }
    expect![[r#"
        == types.clad
        TYPE
            Phase   : (IDLE, FILLING := 5) := FILLING;
            Motor   : STRUCT
                speed : REAL := 50.0;
                times : ARRAY[0..3] OF TIME;
            END_STRUCT;
            Percent : INT(0..100);
        END_TYPE
        == globals.clad
        VAR_GLOBAL
            level : INT;
        END_VAR
        == Second.clad
        VAR
            out  : BOOL;
            hold : BOOL;
        END_VAR

        +--[ ]( hold )--\-----------------------------------------------( )( out )--\--+
        |               /----------------------------------------------------<RET>--/  |
        == Second_2.clad
        VAR
            out  : BOOL;
            hold : BOOL;
        END_VAR

        +--[ ]( hold )--\-----------------------------------------------( )( out )--\--+
        |               /----------------------------------------------------<RET>--/  |
        == First.clad
        VAR RETAIN
            total : DINT;
        END_VAR
        VAR CONSTANT
            limit : INT := 80;
        END_VAR
        VAR
            out   AT %QX0.1 : BOOL;  # the pump #
            phase           : Phase              := IDLE;
            motor           : Motor              := (speed := 20.0);
            mix             : ARRAY[1..4] OF INT := [1, 3(2)];
            text            : STRING[20]         := 'it$'s';
            share           : Percent;
            hold            : BOOL;
        END_VAR
        VAR_INPUT
            deep : BOOL;  # AT %IX0.1.2 in the project #
        END_VAR

        # motor.speed, which nothing is wired to #
        +--[EQ]( phase, FILLING )------------------------------------------( )( out )--+

        +-----------------------------------------------[ADD]( level, level, mix[2] )--+

        +--[ ]( out )-----------------------------------------------------( )( hold )--+
        == Idle.clad
        VAR
            x : INT;
        END_VAR

        +----------------------------------------------------------[CALC]( x, x + 1 )--+
        == ladder.toml
        # A project

        [[task]]
        name = "fast"
        interval = "20ms"
        priority = 1
        programs = ["Second.clad", "Second_2.clad"]

        [[task]]
        name = "slow"
        interval = "1s"
        priority = 5
        programs = ["First.clad"]
    "#]]
    .assert_eq(&all);
}

#[test]
fn charts() {
    let main = r#"<pou name="Main" pouType="program"><interface><localVars><variable name="a"><type><BOOL/></type></variable></localVars></interface>
<actions><action name="Blink"><body><LD><leftPowerRail localId="1"/><coil localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>a</variable></coil></LD></body></action>
<action name="Think"><body><ST>a := FALSE;</ST></body></action></actions>
<transitions><transition name="Go"><body><FBD><inVariable localId="1"><expression>a</expression></inVariable><outVariable localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><expression>Go</expression></outVariable></FBD></body></transition></transitions>
<body><SFC><step localId="1" name="Start" initialStep="true"/><transition localId="2"><condition><reference name="Go"/></condition></transition><jumpStep localId="3" targetName="Start"/></SFC></body></pou>"#;
    check(
        &project("", main, ""),
        expect![[r#"
            # Main (SFC) is not read (line 7: not one line leads to it): a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$Main_SFC]
            # ladder: unread #
            # step localId=1 name=Start initialStep=true #
            # transition localId=2 condition reference name=Go #
            # jumpStep localId=3 targetName=Start #
            #  #
            # action Blink: #
            # +--------------------------------------------------------------------( )( a )--+ #
            #  #
            # action Think: #
            # a := FALSE; #
            #  #
            # transition Go: #
            # +--[ ]( a )---------------------------------------------------------( )( Go )--+ #
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
            END_VAR

            +-----------------------------------------------------------------[$Main_SFC]--+
            approximated body of Main: SFC is not read: a scan runs past it, and what it may write is not known
            approximated action Blink: it is part of what is not read: a scan runs past it, and what it may write is not known
            approximated action Think: it is part of what is not read: a scan runs past it, and what it may write is not known
            approximated transition Go: it is part of what is not read: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn what_is_no_project() {
    let text = |xml: &str| crate::harness::text(xml);
    expect!["3:1: this is not XML as it must be: expected 'types' tag, not 'project'"]
        .assert_eq(&text("<project>\n  <types>\n</project>"));
    expect!["1:1: a PLCopen project begins with `<project>`, not with `<html>`"].assert_eq(&text("<html/>"));
    expect!["1:1: the file has a document type (`<!DOCTYPE`), which no project needs: take it out"]
        .assert_eq(&text(
            "<!DOCTYPE project [<!ENTITY a \"b\">]><project>&a;</project>",
        ));
    expect!["1:1: nothing is in the project: no program, no type, no variable"]
        .assert_eq(&text("<Project xmlns=\"www.iec.ch/public/TC65SC65BWG7TF10\"/>"));
    let deep = format!(
        "<project>{}{}</project>",
        "<a>".repeat(100_000),
        "</a>".repeat(100_000)
    );
    expect!["1:1: nothing is in the project: no program, no type, no variable"].assert_eq(&text(&deep));
    let wide = format!("<project>{}</project>", "<a/>".repeat(2_100_000));
    expect!["1:1: the file has more than 2000000 elements; projects do not"].assert_eq(&text(&wide));
}

#[test]
fn a_program_with_two_instances() {
    let blink = unit(
        "program",
        "Blink",
        "a : BOOL\nt : TON",
        &format!(
            "<LD>{}</LD>",
            short(
                "leftPowerRail 1
                 contact 2 from=1 negated=true a
                 inVariable 3 T#1s
                 block 4 TON t IN=2 PT=3 / Q ET
                 coil 5 from=4.Q a"
            )
        ),
    );
    let instances = "<configuration name=\"c\"><resource name=\"r\"><task name=\"fast\" interval=\"T#20ms\" priority=\"1\"><pouInstance name=\"one\" typeName=\"Blink\"/></task><task name=\"slow\" interval=\"T#20ms\" priority=\"2\"><pouInstance name=\"two\" typeName=\"Blink\"/></task></resource></configuration>";
    check(
        &project("", &blink, instances),
        expect![[r#"
        # ladder: cycle 20ms #

        # of Blink #
        VAR
            a : BOOL;
            t : TON;
        END_VAR

        # of Blink #
        VAR
            Blink_a : BOOL;  # a in the project #
            Blink_t : TON;  # t in the project #
        END_VAR

        +-------------------------------------------------------------<CALL>( Blink )--+

        +-----------------------------------------------------------<CALL>( Blink_2 )--+

        +--<FUN>( Blink )--------------------------------------------------------------+

        +--[/]( a )----------------------------------------[TON]( t, T#1s )--( )( a )--+

        +--<FUN>( Blink_2 )------------------------------------------------------------+

        +--[/]( Blink_a )----------------------[TON]( Blink_t, T#1s )--( )( Blink_a )--+
    "#]],
    );
}

/// In the dialect of CODESYS: lists of globals in its own data, one rail for all networks, titles, a box without positions.
#[test]
fn codesys_and_its_lists_of_globals() {
    let text = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0200">
  <fileHeader companyName="" productName="CODESYS" productVersion="CODESYS V3.5 SP20" creationDateTime="2026-01-02T03:04:05"/>
  <contentHeader name="Plant.project"/>
  <types><dataTypes/><pous>
    <pou name="PLC_PRG" pouType="program">
      <interface><localVars>
        <variable name="delay"><type><derived name="TON"/></type></variable>
      </localVars></interface>
      <body><LD>
        <leftPowerRail localId="0"><position x="0" y="0"/><connectionPointOut formalParameter="none"/></leftPowerRail>
        <comment localId="1" height="0" width="0"><position x="0" y="0"/><content><xhtml xmlns="http://www.w3.org/1999/xhtml">Waits for the tank</xhtml></content></comment>
        <vendorElement localId="2"><position x="0" y="0"/><alternativeText><xhtml xmlns="http://www.w3.org/1999/xhtml">Pump</xhtml></alternativeText>
          <addData><data name="http://www.3s-software.com/plcopenxml/fbdelementtype" handleUnknown="implementation"><ElementType xmlns="">networktitle</ElementType></data></addData></vendorElement>
        <contact localId="3"><position x="0" y="0"/><connectionPointIn><connection refLocalId="0"/></connectionPointIn><connectionPointOut/><variable>GVL.full</variable></contact>
        <inVariable localId="4"><position x="0" y="0"/><connectionPointOut/><expression>GVL.WAIT</expression></inVariable>
        <block localId="5" typeName="TON" instanceName="delay"><position x="0" y="0"/>
          <inputVariables>
            <variable formalParameter="IN"><connectionPointIn><connection refLocalId="3"/></connectionPointIn></variable>
            <variable formalParameter="PT"><connectionPointIn><connection refLocalId="4"/></connectionPointIn></variable>
          </inputVariables><inOutVariables/>
          <outputVariables><variable formalParameter="Q"><connectionPointOut/></variable><variable formalParameter="ET"><connectionPointOut/></variable></outputVariables></block>
        <coil localId="6"><position x="0" y="0"/><connectionPointIn><connection refLocalId="5" formalParameter="Q"/></connectionPointIn><connectionPointOut/><variable>GVL.pump</variable></coil>
        <coil localId="7"><position x="0" y="0"/><connectionPointIn><connection refLocalId="6"/></connectionPointIn><connectionPointOut/><variable>lamp</variable></coil>
        <rightPowerRail localId="2147483647"><position x="0" y="0"/><connectionPointIn/></rightPowerRail>
      </LD></body>
    </pou>
  </pous></types>
  <instances><configurations/></instances>
  <addData>
    <data name="http://www.3s-software.com/plcopenxml/globalvars" handleUnknown="implementation">
      <globalVars name="GVL">
        <variable name="full" address="%IX0.0"><type><BOOL/></type></variable>
        <variable name="pump"><type><BOOL/></type><documentation><xhtml xmlns="http://www.w3.org/1999/xhtml">contactor</xhtml></documentation></variable>
        <variable name="lamp"><type><BOOL/></type></variable>
      </globalVars>
    </data>
    <data name="http://www.3s-software.com/plcopenxml/globalvars" handleUnknown="implementation">
      <globalVars name="Limits" constant="true">
        <variable name="WAIT"><type><TIME/></type><initialValue><simpleValue value="TIME#2s0ms"/></initialValue></variable>
      </globalVars>
    </data>
    <data name="http://www.3s-software.com/plcopenxml/projectstructure" handleUnknown="discard"><ProjectStructure><Object Name="GVL" ObjectId="1"/></ProjectStructure></data>
  </addData>
</project>
"#;
    check(
        text,
        expect![[r#"
        # Plant.project, from CODESYS #

        VAR_GLOBAL
            full AT %IX0.0 : BOOL;
            pump           : BOOL;  # contactor #
            lamp           : BOOL;
        END_VAR
        VAR_GLOBAL CONSTANT
            WAIT : TIME := TIME#2s0ms;
        END_VAR

        VAR
            delay : TON;
        END_VAR

        # Waits for the tank #
        # Pump #
        +--[ ]( full )-----------------[TON]( delay, WAIT )--( )( pump )--( )( lamp )--+
    "#]],
    );
}
