//! What operands are: computed bits, values of several types, texts and whole structures.

use crate::back::comes_back;
use crate::exports::whole;
use crate::instructions::check;
use crate::run::{converted, trace};
use expect_test::expect;
use ladder_notation_logix::L5x;

#[test]
fn one_shots_of_computed_bits() {
    let rungs = [
        "XIC(a)ONS(w.[i])ADD(n,1,n);",
        "XIC(a)OSR(w.[5],r)ADD(m,1,m);",
        "XIC(a)OSR(s,w.[k]);",
        "XIC(w.[k])OTE(p);",
        "XIC(a)OTL(v.[k])OTU(v.[i]);",
    ];
    check(
        &[
            ("a", "BOOL", "1"),
            ("s", "BOOL", ""),
            ("w", "DINT", ""),
            ("v", "INT", ""),
            ("i", "DINT", "3"),
            ("k", "DINT", "9"),
            ("n", "DINT", ""),
            ("m", "DINT", ""),
            ("r", "BOOL", ""),
            ("p", "BOOL", ""),
        ],
        &rungs,
        "a\n1\n1\n0\n1\n1\n",
        5,
        "n,m,r,p,w",
        expect![[r#"
            n,m,r,p,w
            0,1,1,0,40
            0,2,0,0,40
            0,2,0,0,0
            1,3,1,1,552
            1,4,0,0,40"#]],
    );
}

#[test]
fn integers_are_compared_with_reals_as_reals() {
    let rungs = [
        "GRT(d,r)OTE(gt);",
        "EQU(d,r)OTE(eq);",
        "GRT(16777217,16777216.0)OTE(con);",
        "CMP(d > r)OTE(cmp);",
        "GRT(i,r)OTE(small);",
        "GRT(l,e)OTE(long);",
    ];
    check(
        &[
            ("d", "DINT", "16777217"),
            ("r", "REAL", "16777216.0"),
            ("i", "INT", "5"),
            ("l", "LINT", "7"),
            ("e", "LREAL", "6.5"),
            ("gt", "BOOL", ""),
            ("eq", "BOOL", ""),
            ("con", "BOOL", ""),
            ("cmp", "BOOL", ""),
            ("small", "BOOL", ""),
            ("long", "BOOL", ""),
        ],
        &rungs,
        "",
        1,
        "gt,eq,con,cmp,small,long",
        expect![[r#"
            gt,eq,con,cmp,small,long
            0,1,0,0,0,1"#]],
    );
}

#[test]
fn structures_are_cleared() {
    let types = "<DataTypes><DataType Name=\"Line\"><Members><Member Name=\"n\" DataType=\"DINT\" Dimension=\"0\"/>\
                 <Member Name=\"t\" DataType=\"TIMER\" Dimension=\"0\"/></Members></DataType></DataTypes>\n";
    let one = "<Structure DataType=\"Line\"><DataValueMember Name=\"n\" DataType=\"DINT\" Value=\"7\"/></Structure>";
    let file = whole(
        types,
        &[
            ("d", "Line", one),
            ("e", "Line", one),
            ("all", "Line[4]", ""),
            ("i", "DINT", "3"),
        ],
        &[(
            "Main",
            &[
                "MOV(5,all[1].n)MOV(5,all[2].n)MOV(5,all[i].n)MOV(9,e.t.PRE);",
                "FLL(0,d,1)FLL(0,all[0],2)FLL(0,all[i],1)FLL(0,e.t,1);",
            ],
        )],
    );
    let text = converted(&L5x, file.as_bytes()).written.text;
    expect![[r#"
        d.n,all[1].n,all[2].n,all[3].n,e.n,e.t.PRE
        0,0,5,0,7,0"#]]
    .assert_eq(&trace(&text, "", 1, "d.n,all[1].n,all[2].n,all[3].n,e.n,e.t.PRE"));
    comes_back(&text);
}

#[test]
fn a_text_is_cut_at_its_length() {
    check(
        &[
            ("s", "STRING", ""),
            ("t", "STRING", ""),
            ("n", "DINT", "2"),
            ("m", "DINT", ""),
        ],
        &["MOV('abcd',s)MOV('abc',t)CLR(t.LEN)MOV(n,s.LEN)MOV(s.LEN,m);"],
        "",
        1,
        "s,t,m",
        expect![[r#"
            s,t,m
            Text([97, 98]),Text([]),2"#]],
    );
}
