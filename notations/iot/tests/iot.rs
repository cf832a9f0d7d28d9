//! Programs of the IoT ladder language, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Outcome, Source, convert};
use ladder_notation_iot::Iot;

fn notation() -> &'static dyn Notation {
    &Iot
}

fn converted(bytes: &[u8]) -> Result<Converted, String> {
    let source = Source::alone("test", bytes);
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// The ladder text, what there is to say about it, and what the editor's checks find; or the error.
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
pub(crate) fn programs() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/corpus/iot");
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
        // The default time base is written out.
        let expected: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
        let written = write(&converted.written.text).expect("it can be written");
        assert_eq!(written.0, expected.join("\n") + "\n", "{title}");
        assert_eq!(written.1, "", "{title}");
    }
}

/// The program that is written from a ladder text, and what there is to say about it.
fn write(ladder: &str) -> Result<(String, String), String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let writing = notation().write(&analysis).map_err(|error| error.to_string())?;
    let mut remarks = String::new();
    for entry in writing.report.remarks() {
        let (word, why) = match &entry.outcome {
            Outcome::Approximated(why) => ("approximated", why),
            Outcome::Refused(why) => ("refused", why),
            Outcome::Translated => continue,
        };
        remarks.push_str(&format!("{} {}: {word}: {why}\n", entry.place, entry.element));
    }
    let text = String::from_utf8(writing.bytes).map_err(|error| error.to_string())?;
    Ok((text, remarks))
}

#[test]
fn branches_and_what_was_refused_come_back() {
    let text = "\
= lamp
# Counts while I1 is on.
NO I1 ; CTU C1 10 ; OUT Q1
P I2 ; ADD MI01 C1:AC I1 ; DIV MF01 MI01 4 ; MOV C1:PRE 5
TON T1 1 100 ; GT T1:AC 3 ; AND Q2 C1:AC 4 ; ADD MF02 MF01 2.5
# was: iot: nothing
NO Q2 | ( NC T1:DN ; NO MI02 | ( P I3 ; N I4 ) ) | () ; XOR MI02 MI02 I1 ; RESET T1
OUT T1:DN ; NO I1 | EQ 1 2 ; SCANTIME ; MOV MI01 -5
# iot: = no title
> dt 10 / cycle 3
";
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    assert_eq!(write(&ladder), Ok((text.to_owned(), String::new())), "{ladder}");
}

#[test]
fn ladder_programs_become_iot_programs() {
    let (text, remarks) = write(
        r"VAR_INPUT
    start, stop : BOOL;
    level : DINT;
END_VAR
VAR_OUTPUT run, Q2 : BOOL; END_VAR
VAR warm : TON; off : TOF; total : LREAL; name : STRING; memory : BOOL; END_VAR
VAR CONSTANT limit : DINT := 80; END_VAR
# The motor. #
+--\--[ ]( start )--\--[/]( stop )--( )( run )--+  # main pump #
|  /--[ ]( run )----/                             |
+--[ ]( run )--[TON]( warm, T#5s )--(S)( Q2 )--( )( memory )--+
+--[ ]( run )--[TOF]( off, T#5s )--( )( Q2 )--+
+--[GT]( level, limit )--[ADD]( total, total, 0.5 )--(R)( warm )--+
+--[ ]( run )--[CALC]( level, level * 2 + 1 )--+
"
        .replace("\\\\", "\\")
        .as_str(),
    )
    .expect("it can be written");
    expect![[r#"
        # The motor.
        # main pump
        NO I1 | NO Q1 ; NC I2 ; OUT Q1
        NO Q1 ; TON T1 50 100 ; SET Q2 ; OUT MI02
        # +--[ ]( run )--[TOF]( off, T#5s )--( )( Q2 )--+
        GT MI01 80 ; ADD MF01 MF01 0.5 ; RESET T1
        # +--[ ]( run )--[CALC]( level, level * 2 + 1 )--+

        1:1 program: approximated: arithmetic, timers and counters are those of iot-ladder-editor there, not of the profile of this file
        2:5 tag `start`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `I1` there
        2:12 tag `stop`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `I2` there
        3:5 tag `level`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `MI01` there
        5:12 tag `run`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `Q1` there
        6:5 tag `warm`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `T1` there
        6:17 tag `off`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `T2` there
        6:28 tag `total`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `MF01` there
        6:58 tag `memory`: approximated: the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `MI02` there
        12:1 network: refused: `[TOF]( off, T#5s )`: there it does something else: it counts while power reaches it, from the first rise on
        14:1 network: refused: `[CALC]( level, level * 2 + 1 )`: the IoT ladder language has no [CALC] like this
    "#]].assert_eq(&format!("{text}\n{remarks}"));
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
                MI01   : DINT;
                MI02   : DINT;
                MF01   : REAL;
                T1     : TON;
                C1     : CTU;
                C1_PRE : DINT := 10;
            END_VAR

            # Counts while I1 is on. #
            +--[ ]( I1 )-----------------------------------[CTU]( C1, C1_PRE )--( )( Q1 )--+

            +--[P]( I2 )-----------------[ADD]( MI01, C1.AC, I1 )--[DIV]( MF01, MI01, 4 )--[MOV]( C1_PRE, 5 )--+

            +--[TON]( T1, 1, B := T#100ms )--[GT]( T1.AC, 3 )-------[AND]( Q2, C1.AC, 4 )--+

            +--\--[ ]( Q2 )------------------------\---------------------[XOR]( MI02, MI02, I1 )--(RES)( T1 )--+
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
                MF01 : REAL;
                T1   : TON;
            END_VAR

            +--[ ]( I1 )-----------------------------[TON]( T1, 5, B := T#1s )--( )( Q1 )--+

            +--[ ]( I2 )--[TON]( T1, 3, B := T#100ms )--(S)( Q1 )--[MOV]( MI01, 7 )--( )( MI01 )--[P]( MI01 )---[MOV]( T1.AC, 0 )--+

            +--# iot: EQ 1 2 #--[ ]( T1.TT )--# iot: OR MI01 MF01 1 #----------------------+
            3:1 EQ 1 2: refused: it compares two numbers, neither of which changes
            3:10 NO T1:TT: approximated: TT says here whether the timer is timing; in the original it is the time of the last count
            3:21 OR MI01 MF01 1: refused: C has no such operation with MF01
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
                MI01 : DINT;
                T1   : TON;
                C1   : CTU;
            END_VAR

            +--[ ]( I1 )--[P]( I2 )---------------------[TON]( T1, 0, B := T#100ms )--[CTU]( C1, 2000000000 )--+

            +--[N]( I2 )-------------------------[NOT]( Q1, I1 )--[ADD]( MI01, MI01, -1 )--+
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
        1:7: `OUT` is neither a number nor a variable: those are called I1, Q1, MI01, MF01, T1 and C1
        1:9: `BLINK` is not a word of the IoT ladder language
        1:9: after `TON` is a timer, its preset, and its time base in milliseconds
        1:9: the numbers after `TON` are whole
        1:1: a timer or counter has no value as a whole: name a member, such as `T1:DN` or `C1:AC`
        1:4: `T1` has no member `CC`
        1:9: this parenthesis is not closed
        1:7: `;` or `|` is expected here, not `)`
        1:4: `motor` is neither a number nor a variable: those are called I1, Q1, MI01, MF01, T1 and C1
        1:10: `2147483648` is neither a number nor a variable: those are called I1, Q1, MI01, MF01, T1 and C1
        3:1: another program begins here, the first one on line 1: put each into a file of its own
    "#]]
    .assert_eq(&out);
}

#[test]
fn only_its_own_files_are_recognised() {
    let own = |bytes: &[u8]| Iot.recognises(bytes);
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

const LAMPS: &str = "\
2. Lamps      (two of them, n = 3..4; I5 lets them go out)
   rung 0:    0:TMR ON T1 (PRE 30)   1:COUNT UP C1 (PRE 2, AC 1)   2:RESET T1
   rung n:    0:| |In in parallel with |P|Qn   5:|/|I5   11:( )Qn
   rung 3:    0:AND C1:AC, 1.0 -> Q1   1:NOT MI01 -> MI02   2:ASSIGNMENT 2.0 -> MF01
   rung 4:    0:GT MI01, 5   1:TMR OFF T2 (B 50)   2:(SM)Q2   3:SCAN TIME

   (what else there is to say)
";

#[test]
fn rungs_in_the_columns_of_the_grid() {
    check(
        LAMPS,
        expect![[r#"
            # iot: = Lamps (two of them, n = 3..4; I5 lets them go out) #
            # ladder: profile iot #

            VAR_INPUT
                I3 : BOOL;
                I4 : BOOL;
                I5 : BOOL;
            END_VAR
            VAR_OUTPUT
                Q1 : USINT;
                Q2 : BOOL;
                Q3 : BOOL;
                Q4 : BOOL;
            END_VAR
            VAR
                MI01 : DINT;
                MI02 : DINT;
                MF01 : REAL;
                T1   : TON;
                T2   : TOF;
                C1   : CTU;
            END_VAR

            +---------[TON]( T1, 30, B := T#100ms )--[CTU]( C1, 2, AC := 1 )--(RES)( T1 )--+

            +--\--[ ]( I3 )--\--[/]( I5 )---------------------------------------( )( Q3 )--+
            |  /--[P]( Q3 )--/                                                             |

            +--\--[ ]( I4 )--\--[/]( I5 )---------------------------------------( )( Q4 )--+
            |  /--[P]( Q4 )--/                                                             |

            +--------------[AND]( Q1, C1.AC, 1 )--[NOT]( MI02, MI01 )--[MOV]( MF01, 2.0 )--+

            +--[GT]( MI01, 5 )--------[TOF]( T2, 1, B := T#50ms )--(SM)( Q2 )--[SCANTIME]--+

            # (what else there is to say) #
        "#]],
    );
    let converted = converted(LAMPS.as_bytes()).expect("it can be read");
    assert!(Iot.recognises(LAMPS.as_bytes()));
    assert_eq!(errors(&converted.written.text), Vec::<String>::new());
    let (again, remarks) = write(&converted.written.text).expect("it can be written");
    expect![[r#"
        = Lamps (two of them, n = 3..4; I5 lets them go out)
        TON T1 30 100 ; CTU C1 2 1 ; RESET T1
        NO I3 | P Q3 ; NC I5 ; OUT Q3
        NO I4 | P Q4 ; NC I5 ; OUT Q4
        AND Q1 C1:AC 1 ; NOT MI02 MI01 ; MOV MF01 2.0
        GT MI01 5 ; TOF T2 1 50 ; SM Q2 ; SCANTIME
        # (what else there is to say)
    "#]]
    .assert_eq(&again);
    assert_eq!(remarks, "");
}

#[test]
fn what_is_wrong_in_the_columns_has_a_place() {
    for (text, expected) in [
        (
            "1. a\n rung 0:  0:| |I1  1:( )Q1\n2. b\n",
            "3:1: another program begins here, the first one on line 1: put each into a file of its own",
        ),
        (
            "1. a\n rung 0:  0:| |I1  1:( )Q1\n rung 1:  0:| |I1  1:( )X1\n",
            "3:22: `X1` is neither a number nor a variable: those are called I1, Q1, MI01, MF01, T1 and C1",
        ),
        (
            "1. a\n rung 0:  0:| |I1\n rung 1:  0:TMR ON T1 (AC 3)\n",
            "3:13: `TMR ON T1 (AC 3)` is not an element of the IoT ladder language",
        ),
        (
            "1. a\n rung 0:  0:| |I1\n rung n:  0:| |In\n",
            "3:1: for which numbers this rung is there, the title does not say: `n = 1..8`",
        ),
    ] {
        assert_eq!(read(text).trim_end(), expected);
    }
}

#[test]
fn the_examples_of_the_editor() {
    let Some(folder) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
        return;
    };
    let file = std::path::Path::new(&folder).join("iot/examples.txt");
    let text = std::fs::read_to_string(file).expect("the examples can be read");
    let mut programs: Vec<String> = Vec::new();
    for line in text.lines() {
        if line.starts_with(|c: char| c.is_ascii_digit()) {
            programs.push(String::new());
        }
        if let Some(program) = programs.last_mut() {
            program.push_str(&format!("{line}\n"));
        }
    }
    assert_eq!(programs.len(), 6);
    for program in programs {
        let converted = converted(program.as_bytes()).expect("it can be read");
        assert_eq!(converted.report.remarks().count(), 0, "{program}");
        assert_eq!(errors(&converted.written.text), Vec::<String>::new(), "{program}");
        let (again, remarks) = write(&converted.written.text).expect("it can be written");
        assert_eq!(remarks, "", "{program}");
        println!("{again}");
    }
}

/// A number is not latched: what sets or resets it puts a number there, and says so.
#[test]
fn set_and_reset_of_numbers() {
    let field = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/corpus/field/iot_reset_int.iot"
    );
    let field = std::fs::read_to_string(field).expect("the file can be read");
    let text = format!(
        "{field}NO I1 ; SET MI02\nNO I1 ; RST MF01\nNO I1 ; SET Q1\nNO I1 ; RESET Q1\nADD Q2 Q2 I1 ; RESET Q2\n"
    );
    check(
        &text,
        expect![[r#"
        # ladder: profile iot #

        VAR_INPUT
            I01 : BOOL;
            I1  : BOOL;
        END_VAR
        VAR_OUTPUT
            Q01 : BOOL;
            Q1  : BOOL;
            Q2  : USINT;
        END_VAR
        VAR
            MI01 : DINT;
            MI02 : DINT;
            MF01 : REAL;
        END_VAR

        +--[ ]( I01 )------------------------------------[MOV]( MI01, 0 )--( )( Q01 )--+

        +--[ ]( I1 )-------------------------------------------------[MOV]( MI02, 1 )--+

        +--[ ]( I1 )-------------------------------------------------[MOV]( MF01, 0 )--+

        +--[ ]( I1 )--------------------------------------------------------(S)( Q1 )--+

        +--[ ]( I1 )--------------------------------------------------------(R)( Q1 )--+

        +-----------------------------------------[ADD]( Q2, Q2, I1 )--[MOV]( Q2, 0 )--+
    "#]],
    );
}
