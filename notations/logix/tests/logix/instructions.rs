//! What instructions do, scan by scan.

use crate::back::comes_back;
use crate::exports::{controller, routine, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_notation_logix::L5x;

/// Runs rungs and compares the values after each scan.
#[track_caller]
pub(crate) fn check(
    tags: &[(&str, &str, &str)],
    rungs: &[&str],
    inputs: &str,
    scans: u64,
    watched: &str,
    expected: Expect,
) {
    let text = converted(&L5x, controller(tags, rungs).as_bytes()).written.text;
    comes_back(&text);
    expected.assert_eq(&trace(&text, inputs, scans, watched));
}

#[test]
fn one_shots_are_silent_at_the_start() {
    check(
        &[
            ("a", "BOOL", "1"),
            ("s", "DINT", ""),
            ("p", "BOOL", ""),
            ("r", "BOOL", ""),
            ("f", "BOOL", ""),
        ],
        &["XIC(a)ONS(s.0)OTE(p);", "XIC(a)OSR(s.1,r);", "XIC(a)OSF(s.2,f);"],
        "a\n1\n1\n0\n1\n1\n",
        5,
        "p,r,f,s",
        expect![[r#"
            p,r,f,s
            0,0,0,7
            0,0,0,7
            0,0,1,0
            1,1,0,7
            0,0,0,7"#]],
    );
}

#[test]
fn the_prescan_clears_coils_and_keeps_latches() {
    check(
        &[
            ("a", "BOOL", ""),
            ("y", "BOOL", "1"),
            ("l", "BOOL", "1"),
            ("w", "DINT", "5"),
        ],
        &["JMP(over);", "XIC(a)OTE(y)OTL(l)OTE(w.2);", "LBL(over)NOP();"],
        "",
        1,
        "y,l,w",
        expect![[r#"
            y,l,w
            0,1,1"#]],
    );
}

#[test]
fn timers() {
    let timer = "<Structure DataType=\"TIMER\"><DataValueMember Name=\"PRE\" DataType=\"DINT\" Value=\"20\"/></Structure>";
    check(
        &[
            ("a", "BOOL", ""),
            ("f", "TIMER", timer),
            ("r", "TIMER", timer),
            ("x", "BOOL", ""),
        ],
        &["XIC(a)TOF(f,?,?);", "XIC(a)RTO(r,?,?);", "XIC(x)RES(r);"],
        "a,x\n1,\n,\n0,\n,\n1,\n,\n,\n0,1\n",
        8,
        "f.EN,f.TT,f.DN,f.ACC,r.EN,r.TT,r.DN,r.ACC",
        expect![[r#"
            f.EN,f.TT,f.DN,f.ACC,r.EN,r.TT,r.DN,r.ACC
            1,0,1,0,1,1,0,0
            1,0,1,0,1,1,0,10
            0,1,1,0,0,0,0,10
            0,1,1,10,0,0,0,10
            1,0,1,0,1,1,0,10
            1,0,1,0,1,0,1,20
            1,0,1,0,1,0,1,20
            0,1,1,0,0,0,0,0"#]],
    );
}

#[test]
fn up_and_down_share_a_counter() {
    check(
        &[
            ("u", "BOOL", ""),
            ("d", "BOOL", ""),
            ("c", "COUNTER", ""),
            ("m", "COUNTER", ""),
        ],
        &[
            "XIC(u)CTU(c,2,0);",
            "XIC(d)CTD(c,?,?);",
            "XIC(u)CTU(m,0,2147483647);",
        ],
        "u,d\n0,0\n1,0\n0,0\n1,1\n0,0\n1,0\n",
        6,
        "c.ACC,c.DN,c.CU,c.CD,m.ACC,m.OV",
        expect![[r#"
            c.ACC,c.DN,c.CU,c.CD,m.ACC,m.OV
            0,0,0,0,2147483647,0
            1,0,1,0,-2147483648,1
            1,0,0,0,-2147483648,1
            1,0,1,1,-2147483647,1
            1,0,0,0,-2147483647,1
            2,1,1,0,-2147483646,1"#]],
    );
}

#[test]
fn arithmetic() {
    check(
        &[
            ("a", "DINT", "2147483647"),
            ("i", "INT", "-7"),
            ("r", "REAL", "2.5"),
            ("sum", "DINT", ""),
            ("half", "DINT", ""),
            ("three", "DINT", ""),
            ("q", "DINT", ""),
            ("m", "INT", ""),
            ("z", "DINT", ""),
            ("zero", "DINT", ""),
            ("f", "REAL", ""),
            ("s", "SINT", ""),
        ],
        &[
            "ADD(a,1,sum)MOV(r,half)MUL(r,1.4,three)DIV(i,2,q)MOD(i,3,m);",
            "DIV(a,zero,z)CPT(f,(a-2147483640)/r+SQR(16));",
            "MOVE(300,s);",
        ],
        "",
        1,
        "sum,half,three,q,m,z,f,s",
        expect![[r#"
            sum,half,three,q,m,z,f,s
            -2147483648,2,4,-3,-1,2147483647,6.800000190734863,44"#]],
    );
}

#[test]
fn comparisons() {
    check(
        &[
            ("x", "DINT", ""),
            ("r", "REAL", "1.5"),
            ("low", "DINT", "8"),
            ("high", "DINT", "3"),
            ("out", "BOOL[32]", ""),
        ],
        &[
            "LIM(2,x,4)OTE(out[0]);",
            "LIMIT(low,x,high)OTE(out[1]);",
            "MEQ(x,16#0000_0001,1)OTE(out[2]);",
            "CMP(x + 1 > r * 2)OTE(out[3]);",
            "GEQ(x,r)OTE(out[4]);",
            "LIM(8,x,3)OTE(out[5]);",
        ],
        "x\n2\n3\n5\n9\n",
        4,
        "out[0],out[1],out[2],out[3],out[4],out[5]",
        expect![[r#"
            out[0],out[1],out[2],out[3],out[4],out[5]
            1,1,0,0,1,1
            1,1,1,1,1,1
            0,0,1,1,1,0
            0,1,1,1,1,1"#]],
    );
}

#[test]
fn words_and_bits() {
    check(
        &[
            ("a", "DINT", "16#0000_00f3"),
            ("m", "DINT", "16#00f0"),
            ("d", "DINT", "16#0f"),
            ("b", "DINT", "-1"),
            ("n", "DINT", ""),
            ("i", "DINT", "4"),
            ("y", "BOOL", ""),
            ("z", "DINT", "9"),
        ],
        &["MVM(a,m,d)BTD(a,4,b,8,4)NOT(a,n)XIC(a.[i])OTE(y);", "CLR(z);"],
        "",
        1,
        "d,b,n,y,z",
        expect![[r#"
            d,b,n,y,z
            255,-1,-244,1,0"#]],
    );
}

#[test]
fn files() {
    let control = |length: u32| {
        format!(
            "<Structure DataType=\"CONTROL\"><DataValueMember Name=\"LEN\" DataType=\"DINT\" Value=\"{length}\"/></Structure>"
        )
    };
    let (three, bits) = (control(3), control(40));
    check(
        &[
            ("a", "BOOL", ""),
            ("u", "BOOL", ""),
            ("n", "DINT", ""),
            ("fifo", "DINT[4]", ""),
            ("fc", "CONTROL", &three),
            ("got", "DINT", ""),
            ("shift", "DINT[2]", ""),
            ("sc", "CONTROL", &bits),
            ("steps", "DINT[4]", ""),
            ("qc", "CONTROL", &three),
            ("out", "DINT", ""),
            ("copy", "DINT[4]", ""),
            ("full", "REAL[3]", ""),
        ],
        &[
            "XIC(a)[FFL(n,fifo,fc,?,?) ,BSL(shift,sc,a,?) ];",
            "XIC(u)FFU(fifo[0],got,fc,?,?);",
            "FLL(7,steps[1],2)XIC(a)SQO(steps,16#5,out,qc,?,?);",
            "COP(fifo,copy,4)FLL(1,full,3);",
        ],
        "a,u,n\n0,0,11\n1,0,11\n0,0,12\n1,0,12\n0,1,0\n",
        5,
        "fc.POS,fc.DN,got,fifo[0],fifo[1],shift[0],sc.POS,out,qc.POS,copy[1],full[2]",
        expect![[r#"
            fc.POS,fc.DN,got,fifo[0],fifo[1],shift[0],sc.POS,out,qc.POS,copy[1],full[2]
            0,0,0,0,0,0,0,0,0,0,1.0
            1,0,0,11,0,1,40,5,1,0,1.0
            1,0,0,11,0,1,0,5,1,0,1.0
            2,0,0,11,12,3,40,5,2,12,1.0
            1,0,11,12,0,3,0,5,2,0,1.0"#]],
    );
}

#[test]
fn arithmetic_on_files() {
    check(
        &[
            ("a", "BOOL", ""),
            ("all", "CONTROL", ""),
            ("inc", "CONTROL", ""),
            ("from", "DINT[3]", ""),
            ("to", "DINT[3]", ""),
            ("each", "DINT[3]", ""),
        ],
        &[
            "FLL(4,from,3)MOV(7,from[1]);",
            "XIC(a)FAL(all,3,0,ALL,to[all.POS],from[all.POS] * 10 + all.POS);",
            "XIC(a)FAL(inc,3,0,INC,each[inc.POS],from[inc.POS]);",
        ],
        "a\n0\n1\n1\n0\n1\n",
        5,
        "to[0],to[1],to[2],all.POS,all.DN,each[0],each[1],inc.POS,inc.DN",
        expect![[r#"
            to[0],to[1],to[2],all.POS,all.DN,each[0],each[1],inc.POS,inc.DN
            0,0,0,0,0,0,0,0,0
            40,71,42,3,1,4,0,1,0
            40,71,42,3,1,4,0,1,0
            40,71,42,0,0,4,0,1,0
            40,71,42,3,1,4,7,2,0"#]],
    );
}

#[test]
fn zones_and_ends() {
    check(
        &[
            ("a", "BOOL", ""),
            ("x", "BOOL", ""),
            ("y", "BOOL", ""),
            ("z", "BOOL", ""),
            ("l", "BOOL", "1"),
        ],
        &[
            "XIC(a)MCR();",
            "OTE(x);",
            "OTL(l);",
            "MCR();",
            "OTE(y);",
            "XIC(a)TND();",
            "AFI()OTE(x);",
            "OTE(z);",
        ],
        "a\n0\n1\n",
        2,
        "x,y,z,l",
        expect![[r#"
            x,y,z,l
            0,1,1,1
            1,1,1,1"#]],
    );
}

#[test]
fn subroutines_take_and_give_values() {
    let source = whole(
        "",
        &[
            ("n", "DINT", "4"),
            ("p", "DINT", ""),
            ("r", "REAL", ""),
            ("double", "REAL", ""),
        ],
        &[
            ("Main", &["JSR(Twice,1,n,double);"]),
            ("Twice", &["SBR(p);", "MUL(p,2,r);", "RET(r);"]),
        ],
    );
    let text = converted(&L5x, source.as_bytes()).written.text;
    expect![[r#"
        double
        8.0"#]]
    .assert_eq(&trace(&text, "", 1, "double"));
}

const RAMP: &str = r#"<AddOnInstructionDefinitions>
<AddOnInstructionDefinition Name="My_Ramp">
<Parameters>
<Parameter Name="EnableIn" TagType="Base" DataType="BOOL" Usage="Input"/>
<Parameter Name="EnableOut" TagType="Base" DataType="BOOL" Usage="Output"/>
<Parameter Name="Up" TagType="Base" DataType="BOOL" Usage="Input" Required="true" Visible="true"/>
<Parameter Name="Step" TagType="Base" DataType="DINT" Usage="Input" Required="false"><DefaultData Format="Decorated"><DataValue DataType="DINT" Value="1"/></DefaultData></Parameter>
<Parameter Name="Total" TagType="Base" DataType="DINT" Usage="InOut" Required="true"/>
<Parameter Name="Level" TagType="Base" DataType="DINT" Usage="Output" Required="true"/>
</Parameters>
<LocalTags><LocalTag Name="once" DataType="BOOL"/></LocalTags>
<Routines>
"#;

#[test]
fn add_on_instructions_are_blocks() {
    let logic = routine(
        "Logic",
        &["XIC(Up)ONS(once)ADD(Level,Step,Level);", "ADD(Total,Step,Total);"],
    );
    let before =
        format!("{RAMP}{logic}</Routines>\n</AddOnInstructionDefinition>\n</AddOnInstructionDefinitions>\n");
    let second = "<Structure DataType=\"My_Ramp\"><DataValueMember Name=\"Step\" DataType=\"DINT\" Value=\"5\"/></Structure>";
    let source = whole(
        &before,
        &[
            ("a", "BOOL", ""),
            ("on", "BOOL", ""),
            ("r1", "My_Ramp", ""),
            ("r2", "My_Ramp", second),
            ("x", "DINT", ""),
            ("y", "DINT", ""),
            ("all", "DINT", ""),
        ],
        &[(
            "Main",
            &[
                "XIC(on)My_Ramp(r1,a,all,x);",
                "My_Ramp(r2,a,all,y);",
                "XIC(a)MOV(10,r1.Step);",
            ],
        )],
    );
    let text = converted(&L5x, source.as_bytes()).written.text;
    expect![[r#"
        x,y,all
        0,0,5
        0,5,10
        0,5,15
        0,10,30
        0,10,45"#]]
    .assert_eq(&trace(&text, "a,on\n0,0\n1,0\n0,0\n1,1\n1,1\n", 5, "x,y,all"));
}

#[test]
fn structures_aliases_and_arrays() {
    let types = r#"<DataTypes><DataType Name="Motor" Family="NoFamily" Class="User"><Members>
<Member Name="ZZZZMotor0" DataType="SINT" Dimension="0" Hidden="true"/>
<Member Name="Run" DataType="BIT" Dimension="0" Hidden="false" Target="ZZZZMotor0" BitNumber="0"/>
<Member Name="Delay" DataType="TIMER" Dimension="0"/>
<Member Name="Speeds" DataType="REAL" Dimension="3"/>
</Members></DataType></DataTypes>
"#;
    let source = whole(
        types,
        &[
            ("m", "Motor[4]", ""),
            ("i", "DINT", "2"),
            ("first", "= m[0].Run", ""),
            ("go", "= Local:1:I.Data.3", ""),
            ("grid", "INT[2 3]", ""),
            ("shown", "INT", ""),
            ("PumpSYS", "Motor", ""),
        ],
        &[(
            "Main",
            &[
                "XIC(go)OTE(first)OTE(PumpSYS.Run)MOV(20,m[2].Delay.PRE);",
                "XIC(m[0].Run)TON(m[i].Delay,?,?)OTE(m[i].Run);",
                "MOV(2.5,m[1].Speeds[i])MOV(m[1],m[3])MOV(m[3].Speeds[2],grid[1,i])MOV(grid[1,2],shown);",
            ],
        )],
    );
    let text = converted(&L5x, source.as_bytes()).written.text;
    expect![[r#"
        m[0].Run,m[2].Run,m[2].Delay.ACC,m[3].Speeds[2],shown,PumpSYS.Run
        1,1,0,2.5,2,1
        1,1,10,2.5,2,1"#]]
    .assert_eq(&trace(
        &text,
        "go\n1\n",
        2,
        "m[0].Run,m[2].Run,m[2].Delay.ACC,m[3].Speeds[2],shown,PumpSYS.Run",
    ));
}

#[test]
fn the_same_from_l5k() {
    let source = r#"(* an export *)
IE_VER := 2.19;

CONTROLLER Cell (ProcessorType := "1756-L63",
                 Major := 20)
    DATATYPE Motor (FamilyType := NoFamily, Description := "a motor; with (brackets)")
        SINT ZZZZMotor0 (Hidden := 1);
        BIT Run ZZZZMotor0 : 0 (Description := "it runs");
        DINT Speeds[3] (Radix := Decimal);
        TIMER Delay;
    END_DATATYPE
    MODULE Local (Parent := "Local", CatalogNumber := "1756-L63")
    END_MODULE
    ADD_ON_INSTRUCTION_DEFINITION Twice (Revision := "1.0")
        PARAMETERS
            EnableIn : BOOL (Usage := Input, RADIX := Decimal, Required := No);
            EnableOut : BOOL (Usage := Output, RADIX := Decimal, Required := No);
            Value : DINT (Usage := Input, RADIX := Decimal, Required := Yes, Visible := Yes, DefaultData := 0);
            Double : DINT (Usage := Output, RADIX := Decimal, Required := Yes, Visible := Yes, DefaultData := 0);
        END_PARAMETERS
        LOCAL_TAGS
        END_LOCAL_TAGS
        ROUTINE Logic
            N: ADD(Value,Value,Double);
        END_ROUTINE
    END_ADD_ON_INSTRUCTION_DEFINITION
    TAG
        go OF Local:1:I.Data.3 (Description := "the button");
        m : Motor (Description := "first := one") := [1,[5,6,7],[0,20,0]];
        twice : Twice (RADIX := Decimal) := [1,0,0];
        n : DINT (RADIX := Decimal) := 4;
        d : DINT[2] := [1,2];
    END_TAG
    PROGRAM Main (MAIN := "Begin", MODE := 0)
        TAG
        END_TAG
        ROUTINE Begin
            RC: "The first rung; it says $Qgo$Q";
            N: XIC(go)TON(m.Delay,?,?);
            N: Twice(twice,n,d[1])MOV(m.Speeds[2],n);
        END_ROUTINE
        ST_ROUTINE Other
            'x := 1;
        END_ST_ROUTINE
    END_PROGRAM
    TASK Main (Type := PERIODIC, Rate := 20, Priority := 10)
        Main;
    END_TASK
END_CONTROLLER
"#;
    let converted = converted(&ladder_notation_logix::L5k, source.as_bytes());
    let text = converted.written.text;
    assert!(text.contains("# ladder: cycle 20ms #"), "{text}");
    assert!(text.contains("# The first rung; it says \"go\" #"), "{text}");
    expect![[r#"
        m.Delay.ACC,m.Run,d[1],n
        0,0,8,7
        10,0,14,7"#]]
    .assert_eq(&trace(&text, "go\n1\n", 2, "m.Delay.ACC,m.Run,d[1],n"));
    let remarks = converted
        .report
        .remarks()
        .map(|entry| format!("{} {}", entry.place, entry.element));
    expect!["42:20 x := 1"].assert_eq(&remarks.collect::<Vec<_>>().join("\n"));
}

#[test]
fn lengths_of_texts_and_what_clears_them() {
    let text = converted(
        &L5x,
        controller(
            &[
                ("s", "STRING", ""),
                ("t", "STRING[5]", ""),
                ("big", "BOOL", ""),
                ("n", "DINT", ""),
                ("d", "DINT", "7"),
                ("x", "REAL", "100.0"),
            ],
            &[
                "GRT(s.LEN,0)OTE(big);",
                "ADD(s.LEN,3,n);",
                "CPT(n,t[1].LEN + n)CMP(s.LEN < 2)FLL(0,d,1)FLL(0,s,1);",
                "FLL(0,t[0],5);",
                "CPT(x,x * .5);",
            ],
        )
        .as_bytes(),
    );
    expect![[r#"
        big,n,d,x
        0,3,0,50.0"#]]
    .assert_eq(&trace(&text.written.text, "", 1, "big,n,d,x"));
    comes_back(&text.written.text);
}

/// The same for what is written in another way, which does the same.
#[track_caller]
fn check_one_way(
    tags: &[(&str, &str, &str)],
    rungs: &[&str],
    inputs: &str,
    scans: u64,
    watched: &str,
    expected: Expect,
) {
    let text = converted(&L5x, controller(tags, rungs).as_bytes()).written.text;
    expected.assert_eq(&trace(&text, inputs, scans, watched));
}

#[test]
fn computed_bits_are_written() {
    check(
        &[
            ("a", "BOOL", ""),
            ("i", "DINT", "3"),
            ("w", "DINT", "1"),
            ("s", "SINT", ""),
            ("y", "BOOL", ""),
        ],
        &["XIC(a)OTE(w.[i])OTE(s.[i])OTE(y);", "XIC(a)ADD(i,1,i);"],
        "a\n0\n1\n1\n0\n0\n",
        5,
        "w,s,i,y",
        expect![[r#"
            w,s,i,y
            1,0,3,0
            9,8,4,1
            25,24,5,1
            25,24,5,0
            25,24,5,0"#]],
    );
    // A latch of a computed bit is a formula, with a shift that has no way back.
    check_one_way(
        &[("a", "BOOL", ""), ("i", "DINT", "3"), ("l", "DINT", "")],
        &["XIC(a)OTL(l.[i])ADD(i,1,i);", "XIO(a)OTU(l.[3]);"],
        "a\n0\n1\n1\n0\n0\n",
        5,
        "l,i",
        expect![[r#"
            l,i
            0,3
            8,4
            24,5
            16,5
            16,5"#]],
    );
}

#[test]
fn angles_of_points() {
    check_one_way(
        &[
            ("y", "REAL", "1.0"),
            ("x", "REAL", "-1.0"),
            ("n", "DINT", "0"),
            ("a", "REAL", ""),
            ("b", "REAL", ""),
            ("c", "REAL", ""),
            ("d", "REAL", ""),
            ("e", "DINT", ""),
        ],
        &[
            "ATAN2(y,x,a)ATAN2(-1,x,b)ATAN2(y,n,c)CPT(d,ATAN2(0,x) * 2 + ATAN2(n,n))ATAN2(-2.0,0,e);",
            "EOT(f);",
        ],
        "",
        1,
        "a,b,c,d,e,f",
        expect![[r#"
            a,b,c,d,e,f
            2.356194496154785,-2.356194496154785,1.5707963705062866,6.2831854820251465,-2,1"#]],
    );
}

#[test]
fn numbers_become_texts_and_times_numbers() {
    check_one_way(
        &[
            ("n", "DINT", "-42"),
            ("s", "STRING", ""),
            ("m", "DINT", ""),
            ("t", "TIME", ""),
            ("u", "TIME32", ""),
            ("l", "LTIME", ""),
        ],
        &[
            "DTOS(n,s)STOD(s,m);",
            "MOV(T#1s_5ms,t)MOV(T32#2ms,u)ADD(l,LT#3us,l);",
        ],
        "",
        2,
        "s,m,t,u,l",
        expect![[r#"
            s,m,t,u,l
            Text([45, 52, 50]),-42,1005000,2000,3000
            Text([45, 52, 50]),-42,1005000,2000,6000"#]],
    );
}

/// A rung that only has NOP says that nothing is forgotten; one that acts need not.
#[test]
fn rungs_with_nop() {
    let rungs = [
        "NOP();",
        "XIC(a)[XIO(b) ,]NOP();",
        "XIC(a)NOP()OTE(b);",
        "LBL(over)NOP();",
    ];
    let file = controller(&[("a", "BOOL", ""), ("b", "BOOL", "")], &rungs);
    let text = converted(&L5x, file.as_bytes()).written.text;
    let own = text.find("END_VAR").unwrap_or_default();
    expect![[r#"
        END_VAR

        # ladder: allow(no-output): NOP does nothing #
        +--# NOP #---------------------------------------------------------------------+

        # ladder: allow(no-output): NOP does nothing #
        +--[ ]( a )--\--[/]( b )--\--# NOP #-------------------------------------------+
        |            /------------/                                                    |

        +--[ ]( a )--# NOP #-------------------------------------------------( )( b )--+

        +--<LBL>( over )--# NOP #------------------------------------------------------+
    "#]]
    .assert_eq(&text[own..]);
    comes_back(&text);
}

#[test]
fn members_of_what_an_alias_of_a_module_stands_for() {
    let source = whole(
        "",
        &[("ai", "= Rack:1:I", ""), ("x", "DINT", ""), ("y", "BOOL", "")],
        &[("Main", &["MOV(ai.Ch01.Data,x)XIC(ai.Ch01.Fault)OTE(y);"])],
    );
    expect![[r#"
        # ladder: profile logix #
        # Controller Cell #

        VAR_INPUT
            Rack_1_I_Ch01_Data  : DINT;  # Rack:1:I.Ch01.Data #
            Rack_1_I_Ch01_Fault : BOOL;  # Rack:1:I.Ch01.Fault #
        END_VAR

        VAR
            x : DINT;
            y : BOOL;
        END_VAR

        +--[MOV]( x, Rack_1_I_Ch01_Data )--[ ]( Rack_1_I_Ch01_Fault )--------( )( y )--+
    "#]]
    .assert_eq(&converted(&L5x, source.as_bytes()).written.text);
}
