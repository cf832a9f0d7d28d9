//! What is found in programs of both notations, in the words of each.

use crate::{Click, ClickGrid};
use expect_test::{Expect, expect};
use ladder_notation::{Notation, ReadError, Reading, Source};

fn found(read: Result<Reading, ReadError>) -> String {
    let reading = read.expect("it is read");
    let lines = reading.findings.iter().map(|found| {
        format!(
            "{} {:?} {}: {}\n",
            found.place, found.severity, found.check, found.message
        )
    });
    lines.collect()
}

#[track_caller]
fn check_dsl(rungs: &str, expected: Expect) {
    let text = format!("def main():\n{rungs}    if True:\n        end()\n");
    expected.assert_eq(&found(Click.read(&Source::alone("test", text.as_bytes()))));
}

/// Rows without the cells that are wire up to the output: those stand for `..`.
#[track_caller]
fn check_grid(rows: &str, expected: Expect) {
    let header = "marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF";
    let mut text = format!("{header}\n");
    for row in rows.lines().chain(["R,..,end()"]) {
        let (cells, output) = row.split_once(",..,").unwrap_or((row, ""));
        let missing = 32 - cells.split(',').count();
        let fill = if output.is_empty() { "," } else { ",-" };
        text.push_str(&format!("{cells}{},{output}\n", fill.repeat(missing)));
    }
    expected.assert_eq(&found(ClickGrid.read(&Source::alone("main", text.as_bytes()))));
}

#[test]
fn a_rung_is_no_larger_than_its_sheet() {
    let contacts: Vec<String> = (1..=31).map(|number| format!("c[{number}]")).collect();
    let row = contacts.join(", ");
    check_dsl(
        &format!(
            "    if all({row}):\n        out(y[1])\n    if all({row}, c[99]):\n        out(y[2])\n    if c[1:33]:\n        out(y[3])\n"
        ),
        expect![[r#"
            4:5 Warning click-c0005: the rung is too complicated: it has 32 contacts in series, and Click draws 31; make several rungs of it
            6:5 Warning click-c0005: the rung is too complicated: it has 32 contacts in series, and Click draws 31; make several rungs of it
        "#]],
    );
    let outs = |first: u32, count: u32| {
        let coils: Vec<String> = (first..first + count)
            .map(|number| format!("        out(c[{number}])\n"))
            .collect();
        coils.concat()
    };
    check_dsl(
        &format!(
            "    if x[1]:\n{}    if any({row}, c[99]):\n        out(y[1])\n    if x[1]:\n{}",
            outs(100, 33),
            outs(200, 32)
        ),
        expect![[r#"
            2:5 Warning click-c0005: the rung is too complicated: it has 33 rows, and Click draws 32; make several rungs of it
        "#]],
    );
}

#[test]
fn the_inputs_of_a_box_come_from_one_branch() {
    let dsl = "    if re(c.A):
        out(y.B)
        ctu(ct.C, 5, reset=lambda: c.D)
    if re(c.A):
        ctu(ct.E, 5, reset=lambda: c.D)
    if True:
        out(y.F)
        rton(t.G, 5, Ts, reset=lambda: c.D)
";
    check_dsl(
        dsl,
        expect![[r#"
            4:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
            9:9 Info click-c0107: Click itself wants a contact before this instruction: sc[1] always conducts
        "#]],
    );
    check_grid(
        "R,rise(C1),T,..,out(Y001)\n,,T:C2,..,\"count_up(CT1,CTD1,preset=5)\"\n,C3,..,.reset()",
        expect![[r#"
            3:66 Warning click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        "#]],
    );
}

#[test]
fn what_wants_a_contact() {
    check_dsl(
        "    if True:\n        out(y.A)\n        ton(t.B, 5, Ts)\n    if sc[1]:\n        tof(t.C, 5, Ts)\n",
        expect![[r#"
            4:9 Info click-c0107: Click itself wants a contact before this instruction: sc[1] always conducts
        "#]],
    );
    check_grid(
        "R,..,out(Y001)\nR,SC1,..,out(Y002)\nR,..,\"for(3)\"\nR,C1,..,\"copy(1,DS1)\"\nR,..,next()",
        expect![[r#"
            2:65 Warning click-c0107: Click itself wants a contact before this instruction: SC1 always conducts
        "#]],
    );
}

#[test]
fn formulas_that_can_never_be_computed() {
    check_dsl(
        "    if c.A:
        calc(\"ds.A / 0\", ds.B)
        calc(\"ds.A MOD (0)\", ds.B)
        calc(\"1 / ds.A\", ds.B)
        calc(\"SQRT(-4) + LOG(0) * LN(-1)\", df.B)
        calc(\"ASIN(1.5) + ACOS(1)\", df.B)
        math_hex(\"dh.A / 0x00\", dh.B)
",
        expect![[r#"
            3:9 Warning click-c0108: the formula cannot be computed: it divides by 0
            4:9 Warning click-c0108: the formula cannot be computed: it divides by 0
            6:9 Warning click-c0108: the formula cannot be computed: a negative number has no square root
            7:9 Warning click-c0108: the formula cannot be computed: a sine or cosine lies between -1 and 1
            8:9 Warning click-c0108: the formula cannot be computed: it divides by 0
        "#]],
    );
    check_grid(
        "R,C1,..,\"calc(DS1 / 0,DS2,mode=decimal)\"",
        expect![[r#"
            2:66 Warning click-c0108: the formula cannot be computed: it divides by 0
        "#]],
    );
}

#[test]
fn a_line_that_is_missing() {
    check_grid(
        "R,X001,,..,out(Y001)\nR,X001,T,..,out(Y002)\n,,X002,X003",
        expect![[r#"
            2:67 Error click-c0202: the rung stays as a comment, for `out(Y001)`: nothing joins it to the left rail
            4:3 Error click-c0202: a line is missing at `X002`: no output depends on it: what it lets through leads nowhere, or a wire leads round it
            4:8 Error click-c0202: a line is missing at `X003`: no output depends on it: what it lets through leads nowhere, or a wire leads round it
        "#]],
    );
}

#[test]
fn bits_of_two_registers() {
    check_dsl(
        "    if c.A:
        shift(c[1:9], clock=lambda: c[50])
    if c.A:
        shift(c[8:12], clock=lambda: c[50])
    if c.A:
        shift(c[20:30], clock=lambda: c[50])
",
        expect![[r#"
            5:9 Warning click-c0204: c[8] is in the shift register at 3:9 already
        "#]],
    );
}

#[test]
fn the_grid_has_words_of_its_own() {
    check_grid(
        "R,C1,..,\"for(DD1)\"
R,C1,..,\"for(2)\"
R,C1,..,next()
R,C1,..,return()
R,C1,..,\"call(\"\"nowhere\"\")\"
R,C1,..,\"on_delay(T1,TD1,preset=DD1,unit=Ts)\"
R,C1,..,\"on_delay(T1,TD1,preset=5,unit=Ts)\"
R,C1,..,\"count_up(CT1,CTD1,preset=5)\"
R,C1,..,\"count_up(CT2,CTD2,preset=5)\"
,C2,..,.down()
R,C1,..,shift(C10..C17)
R,C1,..,out(X001)
R,T9,..,out(Y001)
R,DS1==DH1,..,out(Y001)
R,C1,..,\"copy(C1,DS1)\"
R,C1,..,\"copy(DD[DD1],DS1)\"
R,C1,..,\"blockcopy(DS1..DS4,DD1..DD4)\"
R,C1,..,\"pack_bits(X001..X004,DS1)\"
R,C1,..,\"search(\"\"<\"\",\"\"A\"\",TXT1..TXT9,DF1,Y003)\"
R,C1,..,\"calc(DH1 AND 3,DS1,mode=decimal)\"
R,C1,..,\"calc(DS1 + 1,DH1,mode=hex)\"",
        expect![[r#"
            2:66 Error click-setpoint: DD1 is not a number of loops: write a whole number from 0 to 32767, or an address of DS
            3:66 Error click-c0103: loops do not nest: end the loop above with next() first
            4:66 Error click-c0009: next() is alone on its rung, without contacts
            5:66 Error click-end: return() is for subroutines: the main program ends with end()
            6:66 Error click-c010c: there is no subroutine `nowhere`: its file lies next to this one
            7:66 Error click-setpoint: DD1 is not a set point: write a whole number from 0 to 32767, or an address of DS
            8:66 Error click-c010a: the timer T1 is at 7:66 already: it has one place in a program
            9:66 Warning click-c0208: a counter needs its reset: a row below it with .reset()
            9:66 Info click-counter-level: whether Click counts the rise of a rung or every scan depends on who is asked: write rise(..) in its condition
            10:66 Info click-c0208: Click itself wants a reset here: a row below it with .reset()
            10:66 Info click-counter-level: whether Click counts the rise of a rung or every scan depends on who is asked: write rise(..) in its condition
            12:66 Info click-shift-clock: Click itself wants a clock here, and shifts on its rise: a row below it with .clock()
            13:66 Error click-read-only: X001 cannot be written: it is an input
            13:66 Error click-coil: a coil is an address of Y, C or SC, and X001 is none
            14:3 Warning click-c1002: no timer of the program has the bit T9
            15:3 Error click-compare: `DS1 == DH1` compares what cannot be compared: numbers go with numbers, words with words, texts with texts
            15:72 Warning click-c1001: Y001 has an out() at 14:66 too: the last one in the scan wins
            16:66 Error click-copy: a bit does not turn into an integer: C1
            17:66 Error click-pointer: a pointer is an address of DS, and DD1 is none
            19:66 Error click-pack: X is not packed into DS
            20:66 Error click-search: the flag of a search is an address of C, and Y003 is none
            20:66 Error click-search: the result of a search is a number of an address, and DF1 holds none
            20:66 Error click-search: texts are searched with == and != only
            21:66 Error click-math: calc(mode=decimal) computes with decimal numbers, and this is a hexadecimal word
            21:66 Error click-math: AND is for calc(mode=hex) alone
            22:66 Error click-math: calc(mode=hex) computes with hexadecimal words, and this is an integer
        "#]],
    );
}
