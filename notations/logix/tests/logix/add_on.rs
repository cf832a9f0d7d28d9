//! Add-On Instructions: their parameters, and what an instance begins with.

use crate::exports::{routine, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_notation_logix::L5x;

/// A definition. Each parameter and local is its name, its type and its attributes; a type may have a size.
fn definition(name: &str, parameters: &[(&str, &str, &str)], locals: &str, rungs: &[&str]) -> String {
    let parameters = parameters.iter().map(|(name, ty, rest)| {
        let (ty, sizes) = ty.split_once('[').unwrap_or((ty, "0]"));
        let sizes = sizes.trim_end_matches(']');
        format!("<Parameter Name=\"{name}\" DataType=\"{ty}\" Dimensions=\"{sizes}\" {rest}/>\n")
    });
    format!(
        "<AddOnInstructionDefinition Name=\"{name}\">\n<Parameters>\n{}</Parameters>\n<LocalTags>{locals}</LocalTags>\n\
         <Routines>\n{}</Routines>\n</AddOnInstructionDefinition>\n",
        parameters.collect::<String>(),
        routine("Logic", rungs),
    )
}

const IN: &str = "Usage=\"Input\" Required=\"true\"";
const KEPT: &str = "Usage=\"Input\" Required=\"false\"";
const OUT: &str = "Usage=\"Output\" Required=\"true\"";
const IN_OUT: &str = "Usage=\"InOut\" Required=\"true\"";

/// Runs a controller with definitions, and compares the values after each scan. Nothing in it may be unread.
#[track_caller]
fn check(
    definitions: &[String],
    tags: &[(&str, &str, &str)],
    rungs: &[&str],
    inputs: &str,
    watched: &str,
    expected: Expect,
) -> String {
    let before = format!(
        "<AddOnInstructionDefinitions>\n{}</AddOnInstructionDefinitions>\n",
        definitions.concat()
    );
    let source = whole(&before, tags, &[("Main", rungs)]);
    let converted = converted(&L5x, source.as_bytes());
    let text = converted.written.text;
    let remarks: Vec<_> = converted.report.remarks().collect();
    assert!(remarks.is_empty(), "{remarks:?}\n{text}");
    let scans = inputs.lines().count().saturating_sub(1).max(1) as u64;
    let shown = trace(&text, inputs, scans, watched);
    expected.assert_eq(&shown);
    crate::back::comes_back(&text);
    text
}

#[test]
fn an_instruction_clears_its_own_request() {
    let block = definition(
        "Blk",
        &[("Req", "BOOL", KEPT), ("n", "DINT", OUT)],
        "",
        &["XIC(Req)ADD(n,1,n)OTU(Req);"],
    );
    check(
        &[block],
        &[
            ("b", "Blk[2]", ""),
            ("i", "DINT", "1"),
            ("go", "BOOL", ""),
            ("n", "DINT", ""),
            ("m", "DINT", ""),
            ("s", "BOOL", ""),
            ("was", "BOOL", ""),
        ],
        &[
            "XIC(go)ONS(s)OTL(b[0].Req)OTL(b[i].Req);",
            "Blk(b[0],n);",
            "Blk(b[i],m);",
            "XIC(b[0].Req)OTE(was);",
        ],
        "go\n0\n1\n1\n0\n1\n",
        "n,m,was",
        expect![[r#"
            n,m,was
            0,0,0
            1,1,0
            1,1,0
            1,1,0
            2,2,0"#]],
    );
}

#[test]
fn a_number_that_an_instance_keeps() {
    let block = definition(
        "Blk",
        &[
            ("Count", "DINT", KEPT),
            ("Max", "REAL", KEPT),
            ("On", "BOOL", KEPT),
            ("n", "DINT", OUT),
        ],
        "",
        &["ADD(Count,1,Count)MOV(Count,n);"],
    );
    let outer = definition(
        "Outer",
        &[("n", "DINT", OUT)],
        "<LocalTag Name=\"inner\" DataType=\"Blk\"><DefaultData Format=\"Decorated\"><Structure DataType=\"Blk\">\
         <DataValueMember Name=\"Count\" DataType=\"DINT\" Value=\"40\"/></Structure></DefaultData></LocalTag>",
        &["Blk(inner,n);"],
    );
    let begins = "<Structure DataType=\"Blk\"><DataValueMember Name=\"Count\" DataType=\"DINT\" Value=\"7\"/>\
                  <DataValueMember Name=\"Max\" DataType=\"REAL\" Value=\"2.5\"/>\
                  <DataValueMember Name=\"On\" DataType=\"BOOL\" Value=\"1\"/></Structure>";
    let several = format!(
        "<Array DataType=\"Blk\" Dimensions=\"2\"><Element Index=\"[0]\"><Structure DataType=\"Blk\"/></Element><Element Index=\"[1]\">{begins}</Element></Array>"
    );
    check(
        &[block, outer],
        &[
            ("b", "Blk", begins),
            ("all", "Blk[2]", &several),
            ("o", "Outer", ""),
            ("x", "DINT", ""),
            ("y", "DINT", ""),
            ("z", "DINT", ""),
        ],
        &["Blk(b,x);", "Blk(all[1],y);", "Outer(o,z);"],
        "x\n\n\n",
        "x,y,z,b.Max,b.On,all[0].Max,all[1].Max",
        expect![[r#"
            x,y,z,b.Max,b.On,all[0].Max,all[1].Max
            8,8,41,2.5,1,0.0,2.5
            9,9,42,2.5,1,0.0,2.5"#]],
    );
}

#[test]
fn parameters_named_like_those_of_ladder_text() {
    let block = definition(
        "Blk",
        &[("EN", "BOOL", IN), ("eno", "BOOL", KEPT), ("Q", "BOOL", OUT)],
        "",
        &["XIC(EN)XIC(EnableIn)XIO(eno)OTE(Q);"],
    );
    check(
        &[block],
        &[
            ("b", "Blk", ""),
            ("go", "BOOL", ""),
            ("q", "BOOL", ""),
            ("w", "DINT", ""),
            ("i", "DINT", "2"),
            ("p", "BOOL", ""),
            ("c", "Blk", ""),
        ],
        &["Blk(b,go,q)XIC(go)OTL(b.eno)OTL(w.[i]);", "Blk(c,w.[i],p);"],
        "go\n0\n1\n1\n",
        "q,b.eno_2,p",
        expect![[r#"
            q,b.eno_2,p
            0,0,0
            1,1,1
            0,1,1"#]],
    );
}

#[test]
fn an_instance_in_a_structure_gets_the_size_that_it_needs() {
    let pick = definition(
        "Pick",
        &[("tab", "DINT[1]", IN_OUT), ("y", "DINT", OUT)],
        "",
        &["SIZE(tab,0,y);"],
    );
    let types = "<DataTypes><DataType Name=\"Line\"><Members><Member Name=\"pick\" DataType=\"Pick\" Dimension=\"0\"/>\
                 <Member Name=\"all\" DataType=\"DINT\" Dimension=\"7\"/></Members></DataType></DataTypes>\n";
    let before = format!("{types}<AddOnInstructionDefinitions>\n{pick}</AddOnInstructionDefinitions>\n");
    let file = whole(
        &before,
        &[
            ("a", "Pick", ""),
            ("line", "Line", ""),
            ("four", "DINT[4]", ""),
            ("x", "DINT", ""),
            ("y", "DINT", ""),
        ],
        &[("Main", &["Pick(a,four,x);", "Pick(line.pick,line.all,y);"])],
    );
    let text = converted(&L5x, file.as_bytes()).written.text;
    expect![[r#"
        x,y
        4,7"#]]
    .assert_eq(&trace(&text, "", 1, "x,y"));
}

#[test]
fn arrays_of_any_size() {
    let sum = definition(
        "Pick",
        &[
            ("tab", "DINT[1]", IN_OUT),
            ("at", "DINT", IN),
            ("y", "DINT", OUT),
            ("many", "DINT", OUT),
        ],
        "",
        &["MOV(tab[at],y)SIZE(tab,0,many);"],
    );
    let outer = definition(
        "Outer",
        &[
            ("tab", "DINT[1]", IN_OUT),
            ("y", "DINT", OUT),
            ("many", "DINT", OUT),
        ],
        "<LocalTag Name=\"inner\" DataType=\"Pick\"/>",
        &["Pick(inner,tab[0],1,y,many);"],
    );
    let text = check(
        &[outer, sum],
        &[
            ("a", "Pick", ""),
            ("b", "Pick", ""),
            ("c", "Pick[2]", ""),
            ("o", "Outer", ""),
            ("p", "Outer", ""),
            ("long", "DINT[10]", ""),
            ("short", "DINT[3]", ""),
            ("y", "DINT[5]", ""),
            ("n", "DINT[5]", ""),
        ],
        &[
            "MOV(1,long[1])MOV(7,long[7])MOV(2,short[1]);",
            "Pick(a,long,7,y[0],n[0])Pick(b,short,1,y[1],n[1]);",
            "Pick(c[1],short,1,y[2],n[2]);",
            "Outer(o,short,y[3],n[3])Outer(p,long[0],y[4],n[4]);",
        ],
        "",
        "y[0],n[0],y[1],n[1],y[2],n[2],y[3],n[3],y[4],n[4]",
        expect![[r#"
            y[0],n[0],y[1],n[1],y[2],n[2],y[3],n[3],y[4],n[4]
            7,10,2,3,2,3,2,3,1,10"#]],
    );
    assert_eq!(text.matches("FUNCTION_BLOCK [$Pick").count(), 2);
}
