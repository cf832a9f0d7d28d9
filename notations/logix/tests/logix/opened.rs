//! Types that a file uses and does not declare.

use crate::back::back;
use crate::exports::{controller, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_notation_logix::L5x;

/// The types, and what is reported.
#[track_caller]
fn types(file: &str, expected: Expect) -> String {
    let converted = converted(&L5x, file.as_bytes());
    let text = converted.written.text;
    let begin = text.find("TYPE").expect("types");
    let end = text.find("END_TYPE").expect("types");
    let remarks = converted.report.remarks();
    let remarks = remarks.map(|entry| format!("{} {}: {:?}\n", entry.place, entry.element, entry.outcome));
    let shown = format!("{}{}", &text[begin..end], remarks.collect::<String>());
    expected.assert_eq(&shown);
    text
}

#[test]
fn members_are_those_that_are_used() {
    let file = controller(
        &[
            ("m", "MESSAGE", ""),
            ("idle", "MESSAGE[2]", ""),
            ("x", "AXIS_CIP_DRIVE", ""),
            ("card", "AB:1756_IF8:I:0", ""),
            ("loop", "PID", ""),
            ("i", "DINT", ""),
            ("r", "REAL", ""),
            ("y", "BOOL", ""),
            ("s", "STRING", ""),
        ],
        &[
            "XIC(m.DN)OTE(y)MOV(m.ERR,i);",
            "MOV(m.Path,s);",
            "XIC(x.ServoActionStatus)GRT(x.ActualPosition,10)OTE(y);",
            "MOV(card.Ch[3].Data,r)XIC(card.Ch[i].Fault)OTE(y);",
            "XIC(card.Status.4)EQU(card.Count,i)MOV(card.Words[1],i)MOV(card.Words[i],i)OTE(y);",
            "PID(loop,r,0,r,0,0,0);",
        ],
    );
    types(
        &file,
        expect![[r#"
        TYPE
            MESSAGE        : STRUCT
                DN   : BOOL;
                ERR  : INT;
                Path : STRING[82];
            END_STRUCT;
            AXIS_CIP_DRIVE : STRUCT
                ServoActionStatus : BOOL;
                ActualPosition    : REAL;
            END_STRUCT;
            # AB:1756_IF8:I:0: the file does not declare it; these members are used #
            AB_1756_IF8_I_0 : STRUCT
                Ch     : ARRAY[0..3] OF AB_1756_IF8_I_0_Ch;
                Status : DINT;
                Count  : DINT;
                Words  : ARRAY[0..1] OF DINT;
            END_STRUCT;
            PID             : STRUCT
                SP : REAL;
                KP : REAL;
                KI : REAL;
                KD : REAL;
            END_STRUCT;
            # AB:1756_IF8:I:0_Ch: the file does not declare it; these members are used #
            AB_1756_IF8_I_0_Ch : STRUCT
                Data  : REAL;
                Fault : BOOL;
            END_STRUCT;
        8:1 tag card: Approximated("its type AB:1756_IF8:I:0 is not declared in the file: its members are those that are used, with the types of their use")
        48:10 PID(loop,r,0,r,0,0,0): Approximated("it is the controller of the library: in parallel form, with an output from 0 to 100, without tieback, hold and cascade")
    "#]],
    );
}

#[test]
fn in_structures_and_add_on_instructions() {
    let before = r#"<DataTypes><DataType Name="Drive"><Members>
<Member Name="Info" DataType="MESSAGE" Dimension="0"/><Member Name="In" DataType="AB:PF525:I:0" Dimension="0"/>
</Members></DataType></DataTypes>
<AddOnInstructionDefinitions><AddOnInstructionDefinition Name="Run">
<Parameters>
<Parameter Name="Ref" DataType="AB:PF525:I:0" Usage="InOut" Required="true"/>
<Parameter Name="On" DataType="BOOL" Usage="Output" Required="true"/>
</Parameters>
<Routines><Routine Name="Logic" Type="RLL"><RLLContent>
<Rung Number="0" Type="N"><Text><![CDATA[XIC(Ref.Active)OTE(On);]]></Text></Rung>
</RLLContent></Routine></Routines></AddOnInstructionDefinition></AddOnInstructionDefinitions>
"#;
    let file = whole(
        before,
        &[("d", "Drive", ""), ("r", "Run", ""), ("y", "BOOL", "")],
        &[("Main", &["XIC(d.Info.EN)OTL(d.In.Active);", "Run(r,d.In,y);"])],
    );
    let text = types(
        &file,
        expect![[r#"
        TYPE
            Drive   : STRUCT
                Info : MESSAGE;
                In   : AB_PF525_I_0;
            END_STRUCT;
            MESSAGE : STRUCT
                EN : BOOL;
            END_STRUCT;
            # AB:PF525:I:0: the file does not declare it; these members are used #
            AB_PF525_I_0 : STRUCT
                Active : BOOL;
            END_STRUCT;
    "#]],
    );
    let (_, again) = back(&text).expect("it has no errors");
    for text in [text, again] {
        let shown = trace(&text, "d.Info.EN\n1\n", 1, "y");
        expect!["y\n1"].assert_eq(&shown);
    }
}
