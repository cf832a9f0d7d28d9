//! Programs of the IoT ladder language, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_interchange::notation::{Converted, Notation, Outcome, Source, by_name, convert, recognise};

fn notation() -> &'static dyn Notation {
    by_name("iot").expect("the notation is registered")
}

fn converted(bytes: &[u8]) -> Result<Converted, String> {
    let source = Source::alone("test", bytes);
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// The ladder text, what there is to say about it, and what the editor's checks find; or the mistake.
fn read(text: &str) -> String {
    let converted = match converted(text.as_bytes()) {
        Ok(converted) => converted,
        Err(error) => return format!("{error}\n"),
    };
    let mut out = converted.written.text;
    for entry in converted.report.remarks() {
        let (word, why) = match &entry.outcome {
            Outcome::Approximated(why) => ("approximated", why),
            Outcome::Refused(why) => ("refused", why),
            Outcome::Translated => continue,
        };
        out.push_str(&format!("{} {}: {word}: {why}\n", entry.place, entry.element));
    }
    for found in converted.findings {
        out.push_str(&format!("{} {}: {}\n", found.place, found.check, found.message));
    }
    out
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&read(text));
}

/// The programs of a file that holds many, with their titles.
fn programs() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/corpus/iot");
    let all = std::fs::read_to_string(format!("{folder}/element-programs.txt")).expect("it is there");
    let parts = all.split("= ").filter(|part| !part.trim().is_empty());
    parts
        .map(|part| {
            let title = part.lines().next().unwrap_or_default();
            (title.to_owned(), format!("= {part}"))
        })
        .collect()
}

/// What is wrong with a ladder text, but that its profile may not run yet.
fn errors(text: &str) -> Vec<String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
    let errors = analysis.errors().map(|error| error.message.clone());
    errors
        .filter(|message| !message.contains("is not there yet"))
        .collect()
}

#[test]
fn every_program_of_the_corpus_is_read_whole() {
    let programs = programs();
    assert_eq!(programs.len(), 27);
    for (title, text) in programs {
        let converted = converted(text.as_bytes()).expect("it can be read");
        assert_eq!(converted.report.remarks().count(), 0, "{title}");
        assert_eq!(errors(&converted.written.text), Vec::<String>::new(), "{title}");
    }
}

#[test]
fn timers_counters_and_what_c_converts() {
    check(
        "\
= lamp
# Counts while I1 is on.
NO I1 ; CTU C1 10 ; OUT Q1
P I2 ; ADD MI01 C1:AC I1 ; DIV MF01 MI01 4 ; MOV C1:PRE 5
TON T1 ; GT T1:AC 3 ; AND Q2 C1:AC 4
NO Q2 | ( NC T1:DN ; NO MI02 ) | () ; XOR MI02 MI02 I1 ; RESET T1
> dt 10 / cycle 3
",
        expect![[r#"
            # iot: = lamp #
            # ladder: profile iot #

            VAR_INPUT
                I1 : BOOL;
                I2 : BOOL;
            END_VAR
            VAR_OUTPUT
                Q1 : BOOL;
                Q2 : USINT;
            END_VAR
            VAR
                MI01      : DINT;
                MI02      : BOOL;
                MF01      : LREAL;
                T1        : TON;
                C1        : CTU;
                C1_PRE    : DINT := 10;
                I1_int    : DINT;
                MF01_int  : DINT;
                Q2_int    : DINT;
                T1_AC_int : DINT;
            END_VAR

            # Counts while I1 is on. #
            +--[ ]( I1 )-------------------------------------------------------[CTU]( C1, C1_PRE )--( )( Q1 )--+

            +--[P]( I2 )---[TYP]( I1_int, I1 )--[ADD]( MI01, C1.AC, I1_int )--[DIV]( MF01_int, MI01, 4 )--[MOV]( MF01, MF01_int )--[MOV]( C1_PRE, 5 )--+

            +--[TON]( T1, 1, B := T#100ms )--[TYP]( T1_AC_int, T1.AC )--[GT]( T1_AC_int, 3 )---------------------[AND]( Q2_int, C1.AC, 4 )--[AND]( Q2_int, Q2_int, 255 )--[TYP]( Q2, Q2_int )--+

            +--\--[NE]( Q2, 0 )--------------------\---------------------[XOR]( MI02, MI02, I1 )--(RES)( T1 )--+
            |  /--\--[/]( T1.DN )--[ ]( MI02 )--\--/                                                           |
            |     /-----------------------------/                                                              |

            # iot: > dt 10 / cycle 3 #
        "#]],
    );
}

#[test]
fn what_has_no_counterpart_stays() {
    check(
        "\
NO I1 ; TON T1 5 1000 ; OUT Q1
NO I2 ; TON T1 3 ; SET Q1 ; MOV MI01 7 ; OUT MI01 ; P MI01 ; MOV T1:AC 0
EQ 1 2 ; NO T1:TT ; OR MI01 MF01 1
",
        expect![[r#"
            # ladder: profile iot #

            VAR_INPUT
                I1 : BOOL;
                I2 : BOOL;
            END_VAR
            VAR_OUTPUT
                Q1 : BOOL;
            END_VAR
            VAR
                MI01 : DINT;
                MF01 : LREAL;
                T1   : TON;
            END_VAR

            +--[ ]( I1 )---------[TON]( T1, 5, B := T#1s )--( )( Q1 )--+

            +--[ ]( I2 )--# iot: TON T1 3 #---------------------(S)( Q1 )--[MOV]( MI01, 7 )--# iot: OUT MI01 #--# iot: P MI01 #--# iot: MOV T1:AC 0 #--+

            +--# iot: EQ 1 2 #--[ ]( T1.TT )--# iot: OR MI01 MF01 1 #--+
            2:9 TON T1 3: refused: a timer or counter belongs to one block here, and `T1` has one at 1:9
            2:42 OUT MI01: refused: MI01 is a number in this program, and coils write bits here
            2:53 P MI01: refused: MI01 is a number, and only bits have edges here
            2:62 MOV T1:AC 0: refused: only its own block and RESET write T1:AC here
            3:1 EQ 1 2: refused: it compares two numbers, neither of which changes
            3:10 NO T1:TT: approximated: TT says here whether the timer is timing; in the original it is the time of the last count
            3:21 OR MI01 MF01 1: refused: C has no such operation with MF01
            2:9 iot-element: `TON T1 3` stays as a comment: a timer or counter belongs to one block here, and `T1` has one at 1:9
            2:42 iot-element: `OUT MI01` stays as a comment: MI01 is a number in this program, and coils write bits here
            2:53 iot-element: `P MI01` stays as a comment: MI01 is a number, and only bits have edges here
            2:62 iot-element: `MOV T1:AC 0` stays as a comment: only its own block and RESET write T1:AC here
            3:1 iot-element: `EQ 1 2` stays as a comment: it compares two numbers, neither of which changes
            3:21 iot-element: `OR MI01 MF01 1` stays as a comment: C has no such operation with MF01
        "#]],
    );
}

#[test]
fn checks_of_the_editor() {
    check(
        "NO I1 ; P I2 ; TON T1 0 ; CTU C1 2000000000\nN I2 ; NOT Q1 I1 ; ADD MI01 MI01 -1\n",
        expect![[r#"
            # ladder: profile iot #

            VAR_INPUT
                I1 : BOOL;
                I2 : BOOL;
            END_VAR
            VAR_OUTPUT
                Q1 : USINT;
            END_VAR
            VAR
                MI01    : DINT;
                T1      : TON;
                C1      : CTU;
                I1_byte : USINT;
            END_VAR

            +--[ ]( I1 )--[P]( I2 )---------------------[TON]( T1, 0, B := T#100ms )--[CTU]( C1, 2000000000 )--+

            +--[N]( I2 )------------------[TYP]( I1_byte, I1 )--[NOT]( Q1, I1_byte )--[ADD]( MI01, MI01, -1 )--+
            1:16 iot-preset: the preset 0 is reached at once
            1:27 iot-range: 2000000000 is out of range: -999999999 to 999999999
            2:1 iot-shared-edge: the edge elements on I2 share one memory: the one at 1:9 uses up the edge; use another variable for this one
            2:8 iot-not-of-bit: NOT inverts all bits of a number: of 0 and of 1 it makes something that is not 0; use NC I1
            2:20 iot-negative-number: the editor's compiler makes invalid C of -1; subtract instead
        "#]],
    );
}

#[test]
fn what_is_wrong_has_a_place() {
    let mut out = String::new();
    for text in [
        "",
        "NO I1 ; ; OUT Q1",
        "NO I1 OUT Q1",
        "NO I1 ; BLINK Q1",
        "NO I1 ; TON C1 3",
        "NO I1 ; TON T1 1.5",
        "NO T1 ; OUT Q1",
        "NO T1:CC ; OUT Q1",
        "NO I1 ; ( OUT Q1 | OUT Q2",
        "NO I1 ) ; OUT Q1",
        "NO motor ; OUT Q1",
        "MOV MI01 2147483648",
        "= a\nNO I1\n= b\nNO I2\n",
    ] {
        out.push_str(&read(text));
    }
    expect![[r#"
        there is no rung in the file; a rung is a line like `NO I1 ; OUT Q1`
        1:9: an element is missing here: `NO I1`
        1:7: `OUT` is no number and no variable: those are called I1, Q1, MI01, MF01, T1 and C1
        1:9: `BLINK` is no word of the IoT ladder language
        1:9: behind `TON` stands a timer, its preset, and its time base in milliseconds
        1:9: the numbers behind `TON` are whole
        1:1: a timer or counter has no value as a whole: name a member, such as `T1:DN` or `C1:AC`
        1:4: `T1` has no member `CC`
        1:9: this parenthesis is not closed
        1:7: `;` or `|` is expected here, not `)`
        1:4: `motor` is no number and no variable: those are called I1, Q1, MI01, MF01, T1 and C1
        1:10: `2147483648` is no number and no variable: those are called I1, Q1, MI01, MF01, T1 and C1
        3:1: another program begins here, the first one on line 1: put each into a file of its own
    "#]]
    .assert_eq(&out);
}

#[test]
fn only_its_own_files_are_recognised() {
    let own = |bytes: &[u8]| recognise(bytes).is_some_and(|notation| notation.name() == "iot");
    assert!(own(b"NO I1 ; OUT Q1\n"));
    assert!(!own(b"\n# a lamp\n= lamp\r\n  tmr\r\n"));
    assert!(own(b"\n# a lamp\n= lamp\r\n  ton t1 ; out q1\r\n"));
    assert!(own(b"\xac\xed\x00\x05sr\x00"));
    assert!(!own(b"NOT the first word of a letter\n"));
    assert!(!own(b"+--[ ]( I1 )--( )( Q1 )--+\n"));
    assert!(!own(b""));
}

#[test]
fn stored_objects_are_refused() {
    let error = converted(b"\xac\xed\x00\x05sr\x00\x1ecom.example.Program").unwrap_err();
    expect!["this is a project of iot-ladder-editor, which Java stored as objects that only the editor can read; open it there, and write its rungs into a text file, one a line: `NO I1 ; TON T1 3 100 ; OUT Q1`"].assert_eq(&error);
}
