//! Instructions that go through elements, bytes and digits, or call a routine several times.

use crate::back::comes_back;
use crate::exports::{controller, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_notation_logix::L5x;

/// Runs rungs after some that fill tags in the first scan, and compares the values after each scan.
#[track_caller]
fn check(
    tags: &[(&str, &str, &str)],
    first: &[(&str, &str)],
    rungs: &[&str],
    inputs: &str,
    scans: u64,
    watched: &str,
    expected: Expect,
) {
    let mut fill = String::from("XIC(S:FS)");
    for (tag, value) in first {
        fill.push_str(&format!("MOV({value},{tag})"));
    }
    fill.push(';');
    let mut all = vec![fill.as_str()];
    all.extend(rungs);
    let text = converted(&L5x, controller(tags, &all).as_bytes()).written.text;
    comes_back(&text);
    expected.assert_eq(&trace(&text, inputs, scans, watched));
}

#[test]
fn bytes_are_swapped() {
    check(
        &[
            ("i", "INT", ""),
            ("j", "INT", ""),
            ("d", "DINT", ""),
            ("r", "DINT", ""),
            ("w", "DINT", ""),
            ("h", "DINT", ""),
        ],
        &[("i", "-21829"), ("d", "305419896")],
        &["SWPB(i,REVERSE,j)SWPB(d,REVERSE,r)SWPB(d,WORD,w)SWPB(d,HIGH/LOW,h);"],
        "",
        1,
        "j,r,w,h",
        // 16#AABB, 16#12345678: 16#BBAA, 16#78563412, 16#56781234, 16#34127856
        expect![[r#"
            j,r,w,h
            -17494,2018915346,1450709556,873625686"#]],
    );
}

#[test]
fn decimal_digits() {
    check(
        &[
            ("n", "DINT", ""),
            ("b", "DINT", ""),
            ("back", "DINT", ""),
            ("i", "INT", ""),
            ("c", "INT", ""),
        ],
        &[("n", "12345678"), ("i", "9876")],
        &["TOD(n,b)FRD(b,back)TO_BCD(i,c)BCD_TO(c,i);"],
        "",
        1,
        "b,back,c,i",
        expect![[r#"
            b,back,c,i
            305419896,12345678,-26506,9876"#]],
    );
}

#[test]
fn average_deviation_order_and_size() {
    check(
        &[
            ("a", "BOOL", ""),
            ("t", "REAL[4]", ""),
            ("n", "DINT[5]", ""),
            ("mean", "REAL", ""),
            ("dev", "REAL", ""),
            ("whole", "DINT", ""),
            ("size", "DINT", ""),
            ("c", "CONTROL", ""),
            ("d", "CONTROL", ""),
            ("e", "CONTROL", ""),
            ("f", "CONTROL", ""),
        ],
        &[
            ("t[0]", "2.0"),
            ("t[1]", "4.0"),
            ("t[2]", "4.0"),
            ("t[3]", "6.0"),
            ("n[0]", "5"),
            ("n[1]", "-1"),
            ("n[2]", "9"),
            ("n[3]", "0"),
            ("n[4]", "5"),
        ],
        &[
            "XIC(a)AVE(t[0],0,mean,c,4,0)STD(t[0],0,dev,d,4,0);",
            "XIC(a)AVE(n[0],0,whole,e,5,0);",
            "XIC(a)SRT(n[0],0,f,4,0);",
            "SIZE(n[0],0,size);",
        ],
        "a\n0\n1\n1\n",
        3,
        "mean,dev,whole,n[0],n[1],n[2],n[3],n[4],size,c.DN,f.POS",
        expect![[r#"
            mean,dev,whole,n[0],n[1],n[2],n[3],n[4],size,c.DN,f.POS
            0.0,0.0,0,5,-1,9,0,5,5,0,0
            4.0,1.632993221282959,4,-1,0,5,9,5,5,1,4
            4.0,1.632993221282959,4,-1,0,5,9,5,5,1,4"#]],
    );
}

#[test]
fn bytes_of_one_array_in_another() {
    check(
        &[
            ("d", "DINT[2]", ""),
            ("s", "SINT[8]", ""),
            ("i", "INT[4]", ""),
            ("e", "DINT[2]", ""),
        ],
        &[("d[0]", "16909060"), ("d[1]", "-2")],
        &["COP(d[0],s[0],8)COP(s[0],i[0],4)COP(i[0],e[0],2);"],
        "",
        1,
        "s[0],s[1],s[2],s[3],s[4],s[7],i[0],i[1],i[2],e[0],e[1]",
        // 16#01020304
        expect![[r#"
            s[0],s[1],s[2],s[3],s[4],s[7],i[0],i[1],i[2],e[0],e[1]
            4,3,2,1,-2,-1,772,258,-2,16909060,-2"#]],
    );
}

#[test]
fn so_many_elements_in_a_scan() {
    check(
        &[("a", "BOOL", ""), ("to", "DINT[5]", ""), ("c", "CONTROL", "")],
        &[],
        &["XIC(a)FAL(c,5,0,2,to[c.POS],c.POS + 1);"],
        "a\n0\n1\n0\n0\n0\n0\n",
        6,
        "to[0],to[1],to[2],to[3],to[4],c.POS,c.DN,c.EN",
        // It goes on while the rung is low, until it is done.
        expect![[r#"
            to[0],to[1],to[2],to[3],to[4],c.POS,c.DN,c.EN
            0,0,0,0,0,0,0,0
            1,2,0,0,0,2,0,1
            1,2,3,4,0,4,0,1
            1,2,3,4,5,5,1,1
            1,2,3,4,5,0,0,0
            1,2,3,4,5,0,0,0"#]],
    );
}

#[test]
fn an_element_is_searched() {
    check(
        &[
            ("a", "BOOL", ""),
            ("go", "BOOL", ""),
            ("t", "DINT[6]", ""),
            ("c", "CONTROL", ""),
        ],
        &[("t[2]", "7"), ("t[4]", "9")],
        &["XIC(go)OTU(c.IN);", "XIC(a)FSC(c,6,0,ALL,t[c.POS] > 5);"],
        "a,go\n0,0\n1,0\n1,0\n1,1\n1,1\n0,1\n",
        6,
        "c.POS,c.FD,c.IN,c.DN",
        // A hit stops it; without IN it goes on after the hit.
        expect![[r#"
            c.POS,c.FD,c.IN,c.DN
            0,0,0,0
            2,1,1,0
            2,1,1,0
            4,1,1,0
            6,0,0,1
            0,0,0,0"#]],
    );
}

#[test]
fn a_routine_is_called_several_times() {
    let tags: &[(&str, &str, &str)] = &[
        ("a", "BOOL", ""),
        ("i", "DINT", ""),
        ("sum", "DINT", ""),
        ("calls", "DINT", ""),
        ("most", "DINT", "100"),
    ];
    let main: &[&str] = &["XIC(a)FOR(Each,i,2,8,3);", "OTE(after);"];
    let main = [main[0], "NOP();"];
    let each = [
        "ADD(sum,i,sum)ADD(calls,1,calls);",
        "GEQ(sum,most)BRK();",
        "ADD(calls,100,calls);",
    ];
    let file = whole("", tags, &[("Main", &main), ("Each", &each)]);
    let text = converted(&L5x, file.as_bytes()).written.text;
    comes_back(&text);
    let inputs = "a,most\n0,100\n1,100\n1,20\n";
    // 2, 5, 8; in the third scan the loop is left when the sum is 17 + 5.
    expect![[r#"
        i,sum,calls
        0,0,0
        11,15,303
        5,22,405"#]]
    .assert_eq(&trace(&text, inputs, 3, "i,sum,calls"));
}
