//! Programs in Python as ladder text, and back.

use super::Click;
use expect_test::{Expect, expect, expect_file};
use ladder_notation::{Converted, Notation, Source, convert};

const BOTTLING: &str = include_str!("../tests/click/bottling.py");

fn converted(text: &str) -> Converted {
    let source = Source::alone("test", text.as_bytes());
    convert(&Click, &source, &ladder_format::Options::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// What there is to say about a conversion.
fn remarks(converted: &Converted) -> String {
    let mut out = String::new();
    for entry in converted.report.remarks() {
        out.push_str(&format!(
            "{} `{}`: {:?}\n",
            entry.place, entry.element, entry.outcome
        ));
    }
    for finding in &converted.findings {
        out.push_str(&format!(
            "{} {:?} {}: {}\n",
            finding.place, finding.severity, finding.check, finding.message
        ));
    }
    out
}

/// What the analysis says about a converted program.
fn complaints(text: &str) -> String {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
    let mut out = String::new();
    for diagnostic in analysis.diagnostics() {
        let line = text[..usize::from(diagnostic.range.start())].lines().count();
        let shown = text.lines().nth(line.saturating_sub(1)).unwrap_or("").trim();
        out.push_str(&format!(
            "{:?} {}: {}\n    {shown}\n",
            diagnostic.severity,
            diagnostic.rule.name(),
            diagnostic.message
        ));
    }
    out
}

#[test]
fn a_condition_that_has_no_counterpart_is_off() {
    let converted =
        converted("def main():\n    if txt.A == 'é':\n        out(y[1])\n    if True:\n        end()\n");
    let rung = converted
        .written
        .text
        .lines()
        .find(|line| line.starts_with("+--"));
    expect![[r#"
        +--# click: txt.A == "é" #--[/]( SYS.ON )-------------------------( )( Y[1] )--+"#]]
    .assert_eq(rung.unwrap_or_default());
}

#[test]
fn every_construct_becomes_ladder_text() {
    let converted = converted(BOTTLING);
    expect_file!["../tests/click/bottling.clad"].assert_eq(&converted.written.text);
    expect![[r#"
        1:1 `c.FoundSeven`: Approximated("it is spelled `FoundSeven_2` here")
        1:1 `dh.Word`: Approximated("it is spelled `_Word` here")
        1:1 `c.Step`: Approximated("it is spelled `Step_2` here")
        1:1 `ds.Temperature`: Approximated("it is spelled `Temperature_2` here")
        115:12 `sc.FirstScan`: Approximated("Click's controller sets it, and nothing does here")
        81:9 `shift(c[301:317])`: Approximated("nothing says what enters it: the rung shifts, and the first bit stays")
        33:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        34:9 Info click-rtof: Click itself keeps time with the on-delay alone: it has no rtof
        34:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        43:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        43:9 Warning click-setpoint: dd.BatchSize is wider than a set point of the DSL, an int16 or an address of ds; Click's own counters take it
        44:9 Info click-c0208: Click itself wants a reset here: reset=lambda: ..
        44:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        45:9 Info click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
        81:9 Info click-shift-clock: Click itself wants a clock here, and shifts on its rise: clock=lambda: ..
    "#]].assert_eq(&remarks(&converted));
    expect![[r#"
        Info set-without-reset: `C[20..23]` is set, and nothing resets it: once on, it stays on
            |               /--\-----------------------------------(S)( C[20..23] )--\--/  |
        Info reset-without-set: `C[30..33]` is reset, and nothing sets it: it is never on
            |                  /-----------------------------------(R)( C[30..33] )--/     |
    "#]]
    .assert_eq(&complaints(&converted.written.text));
}

#[test]
fn only_what_is_found_is_switched_off() {
    let tank = "def main():\n    if all(c.A, ds[3] > 1):\n        copy(ds[3], ds[4])\n        copy(1, ds.B)\n        out(y[1])\n    if True:\n        out(c.A)\n";
    let converted = converted(tank);
    expect![[r#"
        Info read-before-write: `A` is written further down: this rung sees its value of the scan before
            +--[ ]( A )--[GT]( DS[3], 1 )--\---------------------[MOV]( DS[4], DS[3] )--\--+
        Info never-written: `DS[3]` is read, and nothing writes this element: it stays 0
            +--[ ]( A )--[GT]( DS[3], 1 )--\---------------------[MOV]( DS[4], DS[3] )--\--+
    "#]]
    .assert_eq(&complaints(&converted.written.text));
    let first: Vec<&str> = converted.written.text.lines().take(3).collect();
    expect![[r#"
        # ladder: profile click #

        VAR_OUTPUT"#]]
    .assert_eq(&first.join("\n"));
}

/// A program written in Python again, from its ladder text.
fn written_back(text: &str) -> (String, String) {
    let converted = converted(text);
    let analysis =
        ladder_analysis::analyze(&ladder_syntax::parse(&converted.written.text).into(), "test.clad");
    let writing = Click
        .write(&analysis)
        .unwrap_or_else(|error| panic!("{error}\n{}", converted.written.text));
    let mut remarks = String::new();
    for entry in writing.report.remarks() {
        remarks.push_str(&format!(
            "{} `{}`: {:?}\n",
            entry.place, entry.element, entry.outcome
        ));
    }
    (String::from_utf8(writing.bytes).expect("it is text"), remarks)
}

#[test]
fn ladder_text_becomes_python_again() {
    let (python, remarks) = written_back(BOTTLING);
    expect_file!["../tests/click/bottling_again.py"].assert_eq(&python);
    expect![""].assert_eq(&remarks);
    // What is written says the same, and is written the same again.
    assert_eq!(converted(BOTTLING).written.text, converted(&python).written.text);
    assert_eq!(written_back(&python).0, python);
}

/// What is found in the rungs of a main program that ends as it should.
#[track_caller]
fn check_rungs(rungs: &str, expected: Expect) {
    let text = format!("def main():\n{rungs}\n    if True:\n        end()\n");
    let source = Source::alone("test", text.as_bytes());
    let mut out = String::new();
    match Click.read(&source) {
        Err(error) => out.push_str(&format!("not read: {error}\n")),
        Ok(reading) => {
            for finding in reading.findings {
                out.push_str(&format!(
                    "{} {:?} {}: {}\n",
                    finding.place, finding.severity, finding.check, finding.message
                ));
            }
        }
    }
    expected.assert_eq(&out);
}

#[test]
fn ends_loops_and_calls_are_checked() {
    check_rungs(
        "
    if c.A:
        for _ in range(3):
            pass
    if c.A:
        for _ in range(40000):
            pass
    if c.A:
        next_loop()
        ton(t[1], 5, Ts)
    if True:
        next_loop()
    if c.A:
        return
    if c.A:
        call(nowhere)
    if True:
        for _ in range(3):
            pass
    if c.A:
        tof(t[1], ds.A, Ts)
",
        expect![[r#"
            7:9 Error click-c0103: loops do not nest: end the loop above with next_loop() first
            7:9 Error click-setpoint: 40000 is not a number of loops: write a whole number from 0 to 32767, or an address of ds
            10:9 Error click-c0009: next_loop() is alone on its rung, without contacts: under `if True:`
            13:9 Error click-c0102: there is no loop that this next_loop() could end
            15:9 Error click-end: return is for subroutines: the main program ends with end()
            17:9 Error click-c010c: there is no subroutine `nowhere`: write it with @sub above it
            19:9 Error click-c0101: the loop has no end: write next_loop() under `if True:` after what it repeats
            22:9 Warning click-c1004: a timer in a loop counts the scan several times
            22:9 Error click-c010a: the timer t[1] is at 11:9 already: it has one place in a program
        "#]],
    );
    let text = "def main():\n    if c.A:\n        end()\n@sub\ndef one():\n    if c.A:\n        call(one)\n        return\n@sub\ndef one():\n    if c.A:\n        end()\n";
    let source = Source::alone("test", text.as_bytes());
    let reading = Click.read(&source).expect("it is of the DSL");
    let found: Vec<String> = reading
        .findings
        .iter()
        .map(|finding| format!("{} {}: {}", finding.place, finding.check, finding.message))
        .collect();
    expect![[r#"
        1:5 click-c0201: the main program needs an unconditional end(): write it under `if True:` at its end
        5:5 click-c0105: the subroutine `one` needs an unconditional return: write it under `if True:` at its end
        7:9 click-nested-call: a subroutine calls no other: Click has one level of them
        10:5 click-c0105: the subroutine `one` needs an unconditional return: write it under `if True:` at its end
        10:5 click-subroutine: there is another `one`
        12:9 click-end: end() is for the main program: a subroutine goes back with return"#]].assert_eq(&found.join("\n"));
}

#[test]
fn addresses_and_kinds_are_checked() {
    check_rungs(
        "
    if all(x[17], ds[1], c[2001], t[9], y[10:25]):
        out(x[1])
        out(ds.A)
        set(sc[1])
        reset(sc[50])
    if any(ds.A == dh.B, txt[1] < \"a\", dd.A > 1.5, df.A == 0x10, c.A == 1, ds[ds.I] == 2, dh.B == 0xFF):
        copy(70000, ds.A)
        copy(c.A, ds.A)
        copy(\"text\", dd.A)
        copy(1, c.A)
        copy(ds[c.A], ds.B)
        copy(ds[ds.A], x[ds.A])
        copy_block(ds[1:5], dd[1])
        copy_block(ds[1:5], ds[4499])
        copy_fill(ds.A, txt[1:5])
        copy_pack(c[1:34], dd.A)
        copy_pack(ds[1:4], dd.A)
        copy_pack(x[1:5], ds.A)
        copy_unpack(dh.A, ds[1:3])
        shift(x[1:5])
        search(\"eq\", 1.5, dh[1], dh[9], df.A, y.A)
        calc(\"ds.A + dh.B\", ds.C)
        calc(\"ds.A AND 3\", ds.C)
        calc(\"ds[ds.A] + 1\", ds.C)
        calc(\"((((((((((ds.A)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2\", ds.C)
        math_hex(\"dh.A ^ 2\", dh.B)
        math_hex(\"dh.A\", ds.B)
        ton(c[1], -5, Ts)
        ctu(t[1], df.A)
        copy(1, ct[3])
        rton(t[3], 99999, Tms)
        ctud(ct[5], 4)
",
        expect![[r#"
            3:12 Error click-address: x[17] does not exist: x has 1 to 16, 21 to 36, and 101 to 116 up to 801 to 816
            3:19 Error click-contact: a contact is a bit, and ds[1] is an integer: compare it
            3:26 Error click-address: c[2001] does not exist: c has 1 to 2000
            3:35 Warning click-c1002: no timer of the program has the bit t[9]
            3:41 Error click-address: y[10:25] does not exist: y has 1 to 16, 21 to 36, and 101 to 116 up to 801 to 816
            4:9 Error click-read-only: x[1] cannot be written: it is an input
            4:9 Error click-coil: a coil is an address of y, c or sc, and x[1] is none
            5:9 Error click-coil: a coil is an address of y, c or sc, and ds.A is none
            6:9 Error click-read-only: sc[1] cannot be written: the controller alone writes it
            8:12 Error click-compare: `ds.A == dh.B` compares what cannot be compared: numbers go with numbers, words with words, texts with texts
            8:26 Error click-compare: texts are compared with == and != only
            8:40 Warning click-compare: `dd.A > 1.5` compares int32 with float32, and the DSL asks for one type; Click itself compares them as numbers
            8:52 Error click-compare: `df.A == 0x10` compares what cannot be compared: numbers go with numbers, words with words, texts with texts
            8:66 Error click-compare: `c.A == 1` compares what cannot be compared: numbers go with numbers, words with words, texts with texts
            8:76 Warning click-pointer: `ds[ds.I]` is a pointer, and Click has them in copy() alone
            9:9 Warning click-constant: 70000 does not fit its destination, which takes the nearest value that does
            10:9 Error click-copy: a bit does not turn into an integer: c.A
            11:9 Error click-copy: "text" does not turn into an integer
            13:9 Error click-pointer: a pointer is an address of ds, and c.A is none
            14:9 Error click-pointer: a pointer does not lead into the bank x
            14:9 Error click-copy: an integer does not turn into a bit: ds[ds.A]
            16:9 Error click-address: ds[4499:4503] does not exist: ds has 1 to 4500
            17:9 Error click-copy: an integer does not turn into a text: ds.A
            18:9 Error click-pack: no more than 32 addresses go into it, and these are 33
            19:9 Error click-pack: no more than 2 addresses go into it, and these are 3
            20:9 Error click-pack: x is not packed into ds
            21:9 Error click-pack: dh is not unpacked into ds
            22:9 Info click-shift-clock: Click itself wants a clock here, and shifts on its rise: clock=lambda: ..
            22:9 Error click-read-only: x[1] cannot be written: it is an input
            22:9 Error click-shift: a shift register is a range of c, and x[1:5] is none
            23:9 Error click-search: the flag of a search is an address of c, and y.A is none
            23:9 Error click-search: the result of a search is a number of an address, and df.A holds none
            23:9 Error click-search: 1.5 is not found among dh[1:10]
            24:9 Error click-math: calc() computes with decimal numbers, and this is a hexadecimal word
            25:9 Error click-math: AND is for math_hex() alone
            26:9 Warning click-pointer: Click itself has pointers in copy() alone: copy the value to an address first
            27:9 Error click-element: `calc("((((((((((ds.A)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2+1)*2", ds.C)` stays as a comment: Click has no more than eight parentheses in one another
            28:9 Error click-math: ^ is for calc() alone
            29:9 Error click-math: math_hex() computes with hexadecimal words, and this is an integer
            30:9 Error click-timer: a timer is an address of t, and c[1] is none
            30:9 Error click-setpoint: -5 is not a set point: write a whole number from 0 to 32767, or an address of ds
            31:9 Warning click-c0208: a counter needs its reset: reset=lambda: ..
            31:9 Info click-counter-level: whether Click counts the rise of a rung or every scan depends on who is asked: write re(..) in its condition
            31:9 Error click-counter: a counter is an address of ct, and t[1] is none
            31:9 Error click-setpoint: df.A is not a set point: write a whole number from 0 to 2147483647, or an address of ds or dd
            32:9 Error click-read-only: ct[3] cannot be written: its timer or counter alone writes it
            33:9 Warning click-c0205: a retentive timer needs its reset: reset=lambda: ..
            33:9 Error click-setpoint: 99999 is not a set point: write a whole number from 0 to 32767, or an address of ds
            34:9 Warning click-c0207: a counter of both directions needs count_down=lambda: ..
            34:9 Info click-c0208: Click itself wants a reset here: reset=lambda: ..
            34:9 Info click-counter-level: whether Click counts the rise of a rung or every scan depends on who is asked: write re(..) in its condition
        "#]],
    );
}

#[test]
fn outputs_and_timers_that_stand_twice_are_found() {
    check_rungs(
        "
    if c.A:
        out(y[1:4])
    if c.B:
        out(y[2])
        ton(t.A, 5, Ts)
    if t.A:
        ton(t.A, 6, Ts)
    if t.B:
        rtof(t.C, 6, Ts, reset=lambda: ct.C)
",
        expect![[r#"
            6:9 Warning click-c1001: y[2] has an out() at 4:9 too: the last one in the scan wins
            9:9 Error click-c010a: the timer t.A is at 7:9 already: it has one place in a program
            10:8 Warning click-c1002: no timer of the program has the bit t.B
            11:9 Info click-rtof: Click itself keeps time with the on-delay alone: it has no rtof
            11:40 Warning click-c1002: no counter of the program has the bit ct.C
        "#]],
    );
}

#[test]
fn what_is_not_of_the_dsl_is_named() {
    check_rungs(
        "    if x[1] and c.A or not c.B:\n        out(c.C)",
        expect![[r#"
            not read: 2:8: `or` is not in the DSL: write any(a, b)
        "#]],
    );
    check_rungs(
        "    if not c.B:\n        out(c.C)\n    elif c.D:\n        pass\n    else:\n        pass",
        expect![[r#"
            not read: 2:8: `not` is not in the DSL: write nc(a) for a normally closed contact; 4:5: `elif` is not in the DSL: write a rung of its own; 6:5: `else` is not in the DSL: write a rung of its own with nc(..)
        "#]],
    );
    check_rungs(
        "    if 1 < ds.A < 3:\n        out(c.C)",
        expect![[r#"
        not read: 2:8: chained comparisons are not in the DSL: write all(a < b, b < c)
    "#]],
    );
    check_rungs(
        "    if c.A:\n        if c.B:\n            out(c.C)",
        expect![[r#"
            not read: 3:9: an `if` inside another is not in the DSL: write all(..) with both
        "#]],
    );
    check_rungs(
        "    out(c.A)\n    x = 5\n    import os\n    os.system('true')",
        expect![[r#"
            not read: 2:5: an action is under an `if`: write `if True:` above it; 3:5: an assignment is not in the DSL: a function has rungs, each under an `if`; 4:5: an import is not in the DSL: a function has rungs, each under an `if`; 5:5: a call outside a rung is not in the DSL
        "#]],
    );
    check_rungs(
        "    if __import__('os').system('true'):\n        exec('1')",
        expect![[r#"
            not read: 2:8: `__import__('os').system` is not a condition of the DSL: it has all, any, nc, re and fe; 3:9: `exec` is not an instruction of the DSL
        "#]],
    );
    check_rungs(
        "    if c.A:\n        copy(f'{open(1)}', txt[1])\n        calc(f'{1}', ds.A)\n        out(c[1:3:2])",
        expect![[r#"
            not read: 3:14: an f-string is not a value of the DSL: it has numbers, texts and addresses; 4:14: `formula` is a text in quotes, and this is an f-string; 5:19: a range of the DSL has no step: its addresses are consecutive
        "#]],
    );
    check_rungs(
        "    if q[1]:\n        out(c[-1])\n        out(c[1 if c else 2])\n        ton(t.A, 5)",
        expect![[r#"
            not read: 2:8: there is no bank `q`: the banks are x y c t ct sc ds dd dh df xd yd td ctd sd txt; 3:15: a sign or `not` is not an address: write a number, or ds[..] as a pointer; 4:15: a conditional expression is not an address: write a number, or ds[..] as a pointer; 5:9: `ton` lacks its argument `unit`
        "#]],
    );
    check_rungs(
        "    if c.A:\n        out(c.B, oneshot=1)\n        out(*c)\n        out()\n        out(c.A, c.B, c.D)\n        out(c.A, address=c.B)",
        expect![[r#"
            not read: 3:26: `oneshot` is True or False; 4:13: `*` is not in the DSL: give the arguments one by one; 5:9: `out` lacks its argument `address`; 6:23: `out` has no more than 2 arguments; 7:18: `address` is given twice
        "#]],
    );
    check_rungs(
        "    if c.A:\n        rton(t.A, 5, Ts, reset=c.B)\n        rton(t.A, 5, Ts, reset=lambda q: c.B)\n        foo.bar(1)",
        expect![[r#"
            not read: 3:32: `reset` is a condition under a lambda: reset=lambda: c.Name; 4:32: `reset` is a condition under a lambda: reset=lambda: c.Name; 5:9: `foo.bar` is not an instruction of the DSL
        "#]],
    );
    check_rungs(
        "    if c.A:\n        while True:\n            pass\n        for i in range(3):\n            out(c.A)\n        calc('1 +', ds.A)\n        search('about', 1, ds[1], dd[2], ds.A, c.B)",
        expect![[r#"
            not read: 3:9: `while` is not in the DSL; 5:13: a loop of the DSL counts with `_`: for _ in range(n):; 7:14: the formula cannot be read at its end: a number, an address or a function is expected here; 8:16: the condition of a search is eq, ne, gt, ge, lt or le
        "#]],
    );
}

#[track_caller]
fn check_file(text: &str, expected: Expect) {
    let source = Source::alone("test", text.as_bytes());
    let shown = match Click.read(&source) {
        Ok(_) => "read".to_owned(),
        Err(error) => error.to_string(),
    };
    expected.assert_eq(&shown);
}

#[test]
fn what_is_no_python_has_place_and_reason() {
    check_file(
        "def main():\n    if c.A\n        out(c.B)\n",
        expect!["2:11: this is not Python: Expected `:`, found newline"],
    );
    check_file(
        "def main():\n    if c.A:\n        out(c.B\n",
        expect!["4:1: this is not Python: unexpected EOF while parsing"],
    );
    check_file(
        "def main():\n    if c.A:\n        out(c.B)\n      out(c.C)\n",
        expect!["4:1: this is not Python: unindent does not match any outer indentation level"],
    );
    check_file(
        "def main(:\n",
        expect!["1:10: this is not Python: Expected a parameter or the end of the parameter list"],
    );
    check_file(
        "",
        expect!["1:1: a program of the DSL has `def main():`, and this one does not"],
    );
    check_file(
        "print('x')\n",
        expect!["1:1: an expression by itself outside a function is not in the DSL"],
    );
    check_file(
        "def other():\n    pass\n",
        expect!["1:5: `other` is not `main`, so it is a subroutine and has @sub above it"],
    );
    check_file(
        "import os\nos.system('true')\n@os.system\ndef main(a=1):\n    pass\n@sub\n@property\ndef two() -> int:\n    pass\nclass A: pass\n",
        expect![
            "1:1: an import outside a function is not in the DSL; 2:1: an expression by itself outside a function is not in the DSL; 3:2: the main program has no decorator, and this is @os.system; 4:9: functions of the DSL have no parameters; 7:2: @property is not in the DSL: the only decorator is @sub; 8:14: functions of the DSL have no types; 10:1: a class outside a function is not in the DSL"
        ],
    );
    check_file(
        "def main():\n    if c.A:\n        copy(\"\u{1F600}\", txt[1])\n",
        expect!["read"],
    );
}

#[test]
fn what_is_too_large_or_too_deep_is_refused() {
    let deep = |inside: &str| format!("def main():\n    if {inside}:\n        out(c.A)\n");
    check_file(
        &deep(&format!("{}c.A{}", "all(".repeat(500), ")".repeat(500))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&"(".repeat(5_000)),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&format!("{}c.A", "not ".repeat(2_000))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&format!("{}c.A", "-".repeat(9_000))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&format!("c{}", ".A".repeat(4_000))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&format!("{}1", "lambda a, b: ".repeat(500))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&format!("c.A{}", " if c.B else c.C".repeat(500))),
        expect!["2:1: what is written here nests too deeply to be read"],
    );
    check_file(
        &deep(&"x".repeat(20_000)),
        expect!["2:1: a line of more than 10000 characters is not read"],
    );
    let steps: Vec<String> = (1..500).map(|n| format!("{}if c.A:", " ".repeat(n))).collect();
    check_file(
        &format!("def main():\n{}\n", steps.join("\n")),
        expect!["26:1: what is written here nests too deeply to be read"],
    );
    let many = format!("def main():\n    if c.A:\n{}", "        out(c.B)\n".repeat(300));
    check_file(
        &many,
        expect!["2:5: more than 200 actions under one `if` are not read: write the `if` again for the rest"],
    );
    let wide = format!(
        "def main():\n    if any({}):\n        out(c.B)\n",
        "c.A,\n".repeat(600)
    );
    check_file(
        &wide,
        expect![
            "2:8: a condition of more than 500 contacts is not read: put parts of it into control relays"
        ],
    );
    check_file(
        &"# \n".repeat(400_000),
        expect!["a Python file of more than 1 MB is not read"],
    );
}

#[test]
fn what_is_planted_does_not_run() {
    let planted = std::env::temp_dir().join(format!("ladder-planted-{}", std::process::id()));
    let path = planted.display();
    for text in [
        format!("import os\nos.system('touch {path}')\ndef main():\n    if True:\n        end()\n"),
        format!("def main():\n    if True:\n        copy(open('{path}', 'w'), ds.A)\n        end()\n"),
        format!("@open('{path}', 'w')\ndef main():\n    if True:\n        end()\n"),
        format!("def main(a=open('{path}', 'w')):\n    if True:\n        end()\n"),
        format!(
            "def main():\n    if True:\n        calc(f\"{{open('{path}', 'w')}}\", ds.A)\n        end()\n"
        ),
        format!(
            "def main():\n    if True:\n        ton(t.A, 5, Ts, reset=lambda: open('{path}', 'w'))\n        end()\n"
        ),
    ] {
        let source = Source::alone("test", text.as_bytes());
        let refused = Click.read(&source).expect_err("it is not of the DSL");
        assert!(refused.place.is_some(), "{refused}");
    }
    // A text is a text, whatever is in it.
    let harmless = format!(
        "def main():\n    if True:\n        copy(\"__import__('os').system('touch {path}')\", txt[1])\n        end()\n"
    );
    converted(&harmless);
    assert!(!planted.exists(), "{path} was written by reading a program");
}

#[test]
fn a_file_is_recognised_by_its_first_rung() {
    let is = |text: &str| Click.recognises(text.as_bytes());
    assert!(is(BOTTLING));
    assert!(is(
        "\u{feff}# told\r\ndef main():  # told\r\n    if x[1]:\r\n        out(y[1])\r\n"
    ));
    assert!(is(
        "def main():\n    if True:\n        for _ in range(3):\n            pass\n"
    ));
    assert!(!is(
        "def main():\n    print('hello')\n\nif __name__ == '__main__':\n    main()\n"
    ));
    assert!(!is("def main():\n    if True:\n        print(1)\n"));
    assert!(!is("import x\nif x[1]:\n    out(y[1])\n"));
    assert!(!is(""));
}
