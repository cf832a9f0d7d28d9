//! Routines in Structured Text beside those of ladder logic.

use crate::exports::{routine, whole};
use crate::run::{converted, trace};
use expect_test::{Expect, expect};
use ladder_notation_logix::L5x;

/// A routine in Structured Text.
fn text(name: &str, lines: &[&str]) -> String {
    let lines = lines
        .iter()
        .map(|line| format!("<Line><![CDATA[{line}]]></Line>\n"));
    let lines: String = lines.collect();
    format!("<Routine Name=\"{name}\" Type=\"ST\"><STContent>\n{lines}</STContent></Routine>\n")
}

/// Runs a main routine with others in Structured Text. Nothing in it may be unread.
#[track_caller]
fn check(
    tags: &[(&str, &str, &str)],
    rungs: &[&str],
    texts: &[String],
    inputs: &str,
    watched: &str,
    expected: Expect,
) {
    let file = whole("", tags, &[("Main", rungs)]);
    let main = routine("Main", rungs);
    let file = file.replace(&main, &format!("{main}{}", texts.concat()));
    let converted = converted(&L5x, file.as_bytes());
    let text = converted.written.text;
    let remarks: Vec<_> = converted.report.remarks().collect();
    assert!(remarks.is_empty(), "{remarks:?}\n{text}");
    let scans = inputs.lines().count().saturating_sub(1).max(1) as u64;
    expected.assert_eq(&trace(&text, inputs, scans, watched));
}

#[test]
fn a_subroutine_with_parameters() {
    check(
        &[("n", "DINT", "4"), ("p", "DINT", ""), ("y", "DINT", "")],
        &["JSR(Twice,1,n,y);"],
        &[text("Twice", &["SBR(p);", "RET(p * 2);"])],
        "",
        "y",
        expect![[r#"
            y
            8"#]],
    );
}

#[test]
fn bits_whose_number_is_computed() {
    check(
        &[
            ("w", "DINT", "8"),
            ("v", "DINT", ""),
            ("i", "DINT", "3"),
            ("y", "BOOL", ""),
        ],
        &["JSR(Bits,0);"],
        &[text(
            "Bits",
            &[
                "y := w.[i];",
                "v.[i + 1] := w.[i];",
                "IF w.[i] AND NOT w.[0] THEN v.[0] := 1; END_IF;",
            ],
        )],
        "",
        "y,v",
        expect![[r#"
            y,v
            1,17"#]],
    );
}

#[test]
fn timers_whose_inputs_are_members() {
    check(
        &[
            ("t", "FBD_TIMER", ""),
            ("r", "FBD_TIMER", ""),
            ("run", "BOOL", ""),
            ("rst", "BOOL", ""),
            ("n", "DINT", ""),
        ],
        &["JSR(Times,0)XIC(t.DN)OTE(n.0);"],
        &[text(
            "Times",
            &[
                "t.PRE := 25; t.TimerEnable := run; t.Reset := rst; TONR(t);",
                "r.PRE := 30; r.TimerEnable := run; r.Reset := rst; RTOR(r);",
            ],
        )],
        "run,rst\n0,0\n1,\n,\n,\n,\n0,\n1,\n,1\n,0\n,\n,\n,\n,\n",
        "t.DN,t.ACC,t.TT,n,r.DN,r.ACC",
        expect![[r#"
            t.DN,t.ACC,t.TT,n,r.DN,r.ACC
            0,0,0,0,0,0
            0,0,1,0,0,0
            0,10,1,0,0,10
            0,20,1,0,0,20
            1,25,0,1,1,30
            0,0,0,0,1,30
            0,0,1,0,1,30
            0,0,0,0,0,0
            0,0,1,0,0,0
            0,10,1,0,0,10
            0,20,1,0,0,20
            1,25,0,1,1,30
            1,25,0,1,1,30"#]],
    );
}

#[test]
fn a_scaled_value() {
    check(
        &[("s", "SCALE", ""), ("raw", "DINT", ""), ("y", "REAL", "")],
        &["JSR(Scale,0);"],
        &[text(
            "Scale",
            &[
                "s.In := raw; s.InRawMin := 0; s.InRawMax := 4000; s.InEUMin := -10.0; s.InEUMax := 30; s.Limiting := 1;",
                "SCL(s); y := s.Out;",
            ],
        )],
        "raw\n0\n1000\n4001\n-1\n",
        "y,s.MaxAlarm,s.MinAlarm",
        expect![[r#"
            y,s.MaxAlarm,s.MinAlarm
            -10.0,0,0
            0.0,0,0
            30.0,1,0
            -10.0,0,1"#]],
    );
}
