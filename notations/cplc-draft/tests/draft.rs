//! The first draft of CPLC-LD, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Entry, Notation, Outcome, Source, convert};
use ladder_notation_cplc_draft::CplcDraft;

fn remark(entry: &Entry) -> String {
    let why = match &entry.outcome {
        Outcome::Translated => return String::new(),
        Outcome::Approximated(why) => format!("approximated: {why}"),
        Outcome::Refused(why) => format!("refused: {why}"),
    };
    format!("{} {}: {why}\n", entry.place, entry.element)
}

/// The ladder text with what there is to say about it, and what the analysis finds in it; or the error.
fn read(text: &str) -> String {
    let source = Source::alone("test", text.as_bytes());
    let converted = match convert(&CplcDraft, &source, &Options::default()) {
        Ok(converted) => converted,
        Err(error) => return format!("{error}\n"),
    };
    let mut out = converted.written.text.clone();
    out.extend(converted.report.entries.iter().map(remark));
    let analysis =
        ladder_analysis::analyze(&ladder_syntax::parse(&converted.written.text).into(), "test.clad");
    for found in analysis.diagnostics() {
        let place = converted.place_of(found.range.start());
        out.push_str(&format!("{place} {}: {}\n", found.rule, found.message));
    }
    out
}

fn write(ladder: &str) -> String {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    assert!(!analysis.has_errors(), "{:?}", analysis.diagnostics());
    let writing = CplcDraft.write(&analysis).expect("it can be written");
    let mut out = String::from_utf8(writing.bytes).expect("it is text");
    out.extend(writing.report.entries.iter().map(remark));
    out
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&read(text));
}

#[test]
fn a_motor_with_decoration() {
    check(
        "// the motor of line 2\r\nIN = {DI start, DI reset, AI weight}\r\nOUT = {DO run}\r\n\
         VAR = {INT x, FLOAT w,\r\n   INT[32] a}\r\n\r\n\
         +---\\----[]<start>----\\----[/](stop)----()<run>----+ // seal-in\r\n    |                 |\r\n    \
         /----[ ](run)------/",
        expect![[r#"
            # the motor of line 2 #

            VAR_INPUT
                start  : BOOL;
                reset  : BOOL;
                weight : REAL;
            END_VAR
            VAR_OUTPUT
                run : BOOL;
            END_VAR
            VAR
                x : DINT;
                w : REAL;
                a : ARRAY[0..31] OF DINT;
            END_VAR
            VAR
                stop : BOOL;
            END_VAR

            # seal-in #
            +--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
            |  /--[ ]( run )----/                                                          |
            7:28 stop: approximated: no header declares it; it is an internal BOOL here
            2:1 never-read: the input `reset` is declared, and nothing reads it
            2:1 never-read: the input `weight` is declared, and nothing reads it
            4:1 never-read: `x` is declared and never used
            4:1 never-read: `w` is declared and never used
            5:1 never-read: `a` is declared and never used
            7:28 never-written: `stop` is read, and nothing writes it: it stays off
        "#]],
    );
}

#[test]
fn timers_counters_comparisons_and_sums() {
    check(
        "IN = { DI go, DI clear }\nOUT = { DO lamp, DO full }\nVAR = { INT t, INT n, INT x }\n\
         +--[]<go>--[TON]<slow><clear><t><500>--+\n\
         +--[]<slow>--[CTU]<parts><clear><n><10>--+\n\
         +--[GRT]<many><n><5>--()<lamp>--+\n\
         +--[]<many>--[ADD]<done><x><n><x>--+\n\
         +--[]<parts>--[OSR]<once>--(S)<full>--+\n\
         +--[]<go>--[PID]<a><b>--()<lamp>--+\n",
        expect![[r#"
            VAR_INPUT
                go    : BOOL;
                clear : BOOL;
            END_VAR
            VAR_OUTPUT
                lamp : BOOL;
                full : BOOL;
            END_VAR
            VAR
                x : DINT;
            END_VAR
            VAR
                many  : BOOL;
                parts : CTU;
                slow  : TON;
            END_VAR

            +--[ ]( go )-----------------------------------[TON]( slow, 500, R := clear )--+

            +--[ ]( slow.Q )-------------------------------[CTU]( parts, 10, R := clear )--+

            +--[GT]( parts.CV, 5 )-------------------------------( )( many )--( )( lamp )--+

            +--[ ]( many )----------------------------------------[ADD]( x, x, parts.CV )--+

            +--[ ]( parts.Q )--[OSR]------------------------------------------(S)( full )--+

            +--[ ]( go )--# [PID]<a><b> #-------------------------------------( )( lamp )--+
            9:12 [PID]<a><b>: refused: the draft has no such block
            3:1 INT t: approximated: it is `slow.ET` here
            3:1 INT n: approximated: it is `parts.CV` here
            6:4 many: approximated: no header declares it; it is an internal BOOL here
            8:28 set-without-reset: `full` is set, and nothing resets it: once on, it stays on
            9:25 double-coil: `lamp` is written by 2 coils: the last one alone decides
        "#]],
    );
}

#[test]
fn what_cannot_be_read() {
    for (text, expected) in [
        (
            "",
            expect![[r#"
            there is no rung in the file
        "#]],
        ),
        (
            "IN = { DI a",
            expect![[r#"
            1:1: the header that begins here has no `}`
        "#]],
        ),
        (
            "IN = { a }\n+--()<a>--+",
            expect![[r#"
            1:1: `a` has no type before its name, as in `DI start`
        "#]],
        ),
        (
            "IN = { WORD a }\n+--()<a>--+",
            expect![[r#"
            1:1: `WORD` is not a type of the draft: DI DO AI AO SI SO INT FLOAT STRING BOOL are
        "#]],
        ),
        (
            "IN = { DI a }\n+--[ ]<a--+",
            expect![[r#"
            2:4: the `>` of this block is missing on its line
        "#]],
        ),
        (
            "IN = { DI a }\n+--[ ]<a>--% ()<a>--+",
            expect![[r#"
            2:12: `%` is nothing that a rung is drawn with
        "#]],
        ),
        (
            "IN = { DI a }\n+--[EQU]<x><&a><5>--()<a>--+",
            expect![[r#"
                2:4: `&a` is not an operand: that is a name, a number, or an element such as `a[3]`
            "#]],
        ),
        (
            "IN = { DI a }\n+--[EQU]<x><a><+-5>--()<a>--+",
            expect![[r#"
                2:4: `+-5` is not an operand: that is a name, a number, or an element such as `a[3]`
            "#]],
        ),
        (
            "IN = { DI a }\n/* never closed",
            expect![[r#"
            2:1: the comment that begins here has no `*/`
        "#]],
        ),
    ] {
        check(text, expected);
    }
}

const LADDER: &str = "\
VAR_INPUT
    go, clear : BOOL;
END_VAR
VAR_OUTPUT
    lamp : BOOL;
END_VAR
VAR
    t : TON;
    x : INT;
END_VAR

+--\\--[ ]( go )----\\--[/]( clear )-----( )( lamp )--+
|  /--[ ]( lamp )--/                                |

+--[ ]( go )---------[TON]( t, 5s, R := clear )--+
+--[ ]( t.Q )--------------[ADD]( x, x, 1 )------+
+--[GT]( x, 3 )----------------( )( high )-------+
+--[ ]( high )--[SQRT]( y, 2.0 )--( )( root )----+
";

#[test]
fn a_program_is_written() {
    expect![[r#"
        IN = {DI go, DI clear}
        OUT = {DO lamp, DO root}
        VAR = {INT x, BOOL high, FLOAT y}

        +--\--[ ]<go>----\--[/]<clear>--( )<lamp>--------------------------------------+
        |  /--[ ]<lamp>--/                                                             |

        +--[ ]<go>--[TON]<t><clear><t_time><5000>--------------------------------------+

        +--[ ]<t>--[ADD]<sum1><x><1><x>------------------------------------------------+

        +--[GRT]<greater1><x><3>--( )<high>--------------------------------------------+

        // +--[ ]( high )--[SQRT]( y, 2.0 )--( )( root )----+
        18:1 network: refused: the draft has no [SQRT] as it is here
    "#]]
    .assert_eq(&write(LADDER));
}

#[test]
fn what_is_written_is_read_again() {
    let kept: Vec<&str> = LADDER.lines().filter(|line| !line.contains("SQRT")).collect();
    let ladder = kept.join("\n");
    let draft = write(&ladder);
    expect![[r#"
        VAR_INPUT
            go    : BOOL;
            clear : BOOL;
        END_VAR
        VAR_OUTPUT
            lamp : BOOL;
            high : BOOL;
        END_VAR
        VAR
            x : DINT;
        END_VAR
        VAR
            t : TON;
        END_VAR

        +--\--[ ]( go )----\--[/]( clear )--------------------------------( )( lamp )--+
        |  /--[ ]( lamp )--/                                                           |

        +--[ ]( go )-------------------------------------[TON]( t, 5000, R := clear )--+

        +--[ ]( t.Q )------------------------------------------------[ADD]( x, x, 1 )--+

        +--[GT]( x, 3 )---------------------------------------------------( )( high )--+
    "#]]
    .assert_eq(&read(&draft));
}

#[test]
fn its_files_are_recognised() {
    let is_draft = |text: &str| CplcDraft.recognises(text.as_bytes());
    assert!(is_draft("// x\n\nIN = {DI a}\n"));
    assert!(!is_draft("+--[ ]( a )--( )( b )--+\n"));
}
