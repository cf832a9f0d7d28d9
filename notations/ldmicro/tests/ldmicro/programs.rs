//! LDmicro's programs, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Converted, Finding, Notation, Outcome, Source, convert};
use ladder_notation_ldmicro::{Ldmicro, resaved};
use std::path::{Path, PathBuf};

fn notation() -> &'static dyn Notation {
    &Ldmicro
}

pub(crate) fn converted(bytes: &[u8]) -> Result<Converted, String> {
    let source = Source::alone("test", bytes);
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// The ladder text, what there is to say about it, and LDmicro's own findings; or the error.
pub(crate) fn read(text: &str) -> String {
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

/// The file that is written from a ladder text.
pub(crate) fn write(ladder: &str) -> Result<String, String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let writing = notation().write(&analysis).map_err(|error| error.to_string())?;
    String::from_utf8(writing.bytes).map_err(|error| error.to_string())
}

pub(crate) fn there_and_back(bytes: &[u8]) -> Result<String, String> {
    write(&converted(bytes)?.written.text)
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&read(text));
}

fn program(rungs: &str) -> String {
    format!(
        "LDmicro0.1\nCYCLE=10000\nCRYSTAL=4000000\nBAUD=2400\n\nIO LIST\n    Xa at 2\n    Yout at 0\n    Ain at 4\nEND\n\nPROGRAM\n{rungs}"
    )
}

const EVERYTHING: &str = "\
RUNG
    COMMENT All of it.
END
RUNG
    COMMENT Two lines,\\r\\nin one comment.\\r\\n
END
RUNG
    CONTACTS Xa 1
    TON Ta 500000
    TOF Tb 1500
    PARALLEL
        COIL Yout 0 0 0
        SERIES
            OSR
            COIL Rmem 0 1 0
        END
        COIL Rmem 0 0 1
        COIL Rneg 1 0 0
    END
END
RUNG
    PARALLEL
        EQU n -5
        SERIES
            OPEN
            OSF
        END
        SHORT
    END
    CTU Cup 10
    MOVE n 'A'
END
RUNG
    CONTACTS Rmem 0
    PARALLEL
        CTC Cround 4
        RTO Tlong 2000000
        RES Tlong
        RES n
        SHIFT_REGISTER reg 7
        ADD sum Cup 1
        MUL reg0 n 3
        LOOK_UP_TABLE duty Cround 5 0 10 70 80 70 10
        PIECEWISE_LINEAR y duty 2 0 100 10 200
        SET_PWM duty 10000
        READ_ADC Ain
        PERSIST sum
    END
END
RUNG
    MASTER_RELAY
END
RUNG
    UART_RECV n
    UART_SEND n
    FORMATTED_STRING n 8 72 58 92 45 53 92 114 33
END
RUNG
END
";

#[test]
fn every_element() {
    check(
        &program(EVERYTHING),
        expect![[r#"
            # ldmicro: LDmicro0.1 #
            # ldmicro: CYCLE=10000 #
            # ldmicro: CRYSTAL=4000000 #
            # ldmicro: BAUD=2400 #
            # ladder: profile ldmicro #

            VAR_INPUT
                Xa : BOOL;  # pin 2 #
            END_VAR
            VAR_OUTPUT
                Yout : BOOL;  # no pin #
            END_VAR
            VAR
                Rmem   : BOOL;
                Rneg   : BOOL;
                Ain    : INT;  # pin 4 #
                Ta     : TON;
                Tb     : TOF;
                n      : INT;
                Cup    : CTU;
                Cround : CTC;
                Tlong  : RTO;
                sum    : INT;
                duty   : INT;
                y      : INT;
                reg    : ARRAY[0..6] OF INT;
            END_VAR

            # All of it. #

            # ldmicro: COMMENT Two lines,\r\nin one comment.\r\n #
            +--[/]( Xa )--[TON]( Ta, T#500ms )--[TOF]( Tb, T#1500us )--\-----------------------( )( Yout )--\--+
            |                                                          /--\--[OSR]----------(S)( Rmem )--\--/  |
            |                                                             /--\-----------(R)( Rmem )--\--/     |
            |                                                                /-----------(/)( Rneg )--/        |

            +--\--[EQ]( n, -5 )----------------\--------[CTU]( Cup, 10 )--[MOV]( n, 65 )--# was: MOVE n 'A' #--+
            |  /--\--[ ]( SYS.OFF )--[OSF]--\--/                                                               |
            |     /--[ ]( SYS.ON )----------/                                                                  |

            +--[ ]( Rmem )--\-------------------------------------------------------------------------------[CTC]( Cround, 4 )--\--+
            |               /--\-----------------------------------------------------------------------[RTO]( Tlong, T#2s )--\--/  |
            |                  /--\-----------------------------------------------------------------------(RES)( Tlong )--\--/     |
            |                     /--\--------------------------------------------------[MOV]( n, 0 )--# was: RES n #--\--/        |
            |                        /--\---------------------------------------------[SHIFT]( reg[0..6], reg[0] )--\--/           |
            |                           /--\--------------------------------------------[ADD]( sum, Cup.CV, 1 )--\--/              |
            |                              /--\----------------------------------------[MUL]( reg[0], n, 3 )--\--/                 |
            |                                 /--\-----------[LUT]( duty, Cround.CV, 10, 70, 80, 70, 10 )--\--/                    |
            |                                    /--\----------------[PWL]( y, duty, 0, 100, 10, 200 )--\--/                       |
            |                                       /--\-----------------------[PWM]( duty, 10000 )--\--/                          |
            |                                          /--\----------------------[ADC]( Ain, 4 )--\--/                             |
            |                                             /---------------------[PERSIST]( sum )--/                                |

            +-----------------------------------------------------------------------<MCR>--+

            +----------------------------[URCV]( n )--[USND]( n )--[FMT]( 'H:\-5$R!', n )--+

            # ldmicro: RUNG #
            70:1 RUNG: approximated: the rung is empty
            22:1 ldmicro-period: Timer period too short (needs faster cycle time).
            70:1 ldmicro-empty-row: Empty row; delete it or add instructions before compiling.
        "#]],
    );
}

#[test]
fn every_element_comes_back() {
    let text = program(EVERYTHING);
    assert_eq!(resaved(text.as_bytes()).as_deref(), Ok(text.as_bytes()));
    assert_eq!(there_and_back(text.as_bytes()), Ok(text.clone()));
    let windows = text.replace('\n', "\r\n");
    assert_eq!(there_and_back(windows.as_bytes()), Ok(windows));
}

const FORK: &str = "LDmicro0.2\nMICRO=Atmel AVR ATmega8 28-PDIP\nCYCLE=10000 us at Timer1, YPlcCycleDuty:0\nCRYSTAL=16000000 Hz\n\
BAUD=9600 Hz, RATE=0 Hz, SPEED=0 Hz\nCOMPILER=GNU C\n\nPULL-UP LIST\n  PA: 0xFF\nEND\n\nVAR LIST\n  2 bytes n\nEND\n\n\
IO LIST\n  Xa at 12 0 0\n  Yout at 0 0 0\nEND\n\nPROGRAM\nRUNG 1\n  CONTACTS Xa 0 0\n  GOSUB #sub\n  TON Ta 100000 0\n  \
CTU Cn 10 0 /\n  COIL Yout 0 0 0 0\nEND\n";

#[test]
fn the_fork() {
    check(
        FORK,
        expect![[r#"
            # ldmicro: LDmicro0.2 #
            # ldmicro: MICRO=Atmel AVR ATmega8 28-PDIP #
            # ldmicro: CYCLE=10000 us at Timer1, YPlcCycleDuty:0 #
            # ldmicro: CRYSTAL=16000000 Hz #
            # ldmicro: BAUD=9600 Hz, RATE=0 Hz, SPEED=0 Hz #
            # ldmicro: COMPILER=GNU C #
            # ldmicro: PULL-UP LIST #
            # ldmicro: PA: 0xFF #
            # ldmicro: END #
            # ldmicro: VAR LIST #
            # ldmicro: 2 bytes n #
            # ldmicro: END #
            # ladder: profile ldmicro #

            VAR_INPUT
                Xa : BOOL;  # pin 12 0 0 #
            END_VAR
            VAR_OUTPUT
                Yout : BOOL;  # pin 0 0 0 #
            END_VAR
            VAR
                Ta : TON;
                Cn : INT;
            END_VAR

            +--[ ]( Xa )--# ldmicro: GOSUB \x23sub #------[TON]( Ta, T#110ms )--[$CTU]( Cn, 10 )--( )( Yout )--+

            FUNCTION_BLOCK [$CTU]
            # Counts up to max; there is power from then on. #
            VAR_IN_OUT
                c : INT;
            END_VAR
            VAR_INPUT
                max : INT;
            END_VAR
            +--[ ]( EN )--[OSR]--[LT]( c, max )--------------------------[ADD]( c, c, 1 )--+
            +--[GE]( c, max )--------------------------------------------------( )( ENO )--+
            END_FUNCTION_BLOCK
            24:1 GOSUB #sub: refused: there is no subprogram `#sub` that could be made a function
            24:1 ldmicro-element: `GOSUB #sub` stays as a comment: there is no subprogram `#sub` that could be made a function
            24:1 ldmicro-jump: GOSUB '#sub': there is no SUBPROG '#sub'
        "#]],
    );
    assert_eq!(there_and_back(FORK.as_bytes()), Ok(FORK.to_owned()));
}

#[test]
fn old_headers_and_loose_lines_are_made_canonical() {
    let loose = "LDmicro0.1\nCYCLE=5000 us at Timer1\nnonsense\nIO LIST\n Xa  at 3 0 0\nEND\nPROGRAM\nRUNG 7\n; what\n\n  CONTACTS\tXa 0\nEND\n";
    let saved = resaved(loose.as_bytes()).expect("it can be read");
    expect![[r#"
        LDmicro0.1
        CYCLE=5000
        CRYSTAL=4000000
        BAUD=2400
        nonsense

        IO LIST
            Xa at 3
        END

        PROGRAM
        RUNG
            CONTACTS Xa 0
        END
    "#]]
    .assert_eq(&String::from_utf8_lossy(&saved));
}

#[test]
fn what_is_wrong_has_a_place() {
    for (rungs, expected) in [
        (
            "RUNG\n CONTACTS Xa 0\n",
            "14:1: the file ends inside the rung that begins on line 13; an `END` is missing",
        ),
        (
            "RUNG\n CONTACTS Xa\nEND\n",
            "14:1: `CONTACTS` has 2 fields or more: a name and 0 or 1",
        ),
        ("RUNG\n BLINK Xa\nEND\n", "14:1: LDmicro has no element `BLINK`"),
        (
            "RUNG\nRUNG\n",
            "14:1: a rung begins inside the one of line 13; an `END` is missing",
        ),
        ("END\n", "13:1: `RUNG` is expected here, not `END`"),
    ] {
        assert_eq!(read(&program(rungs)).trim_end(), expected);
    }
    assert_eq!(
        read(&program(&format!("RUNG\n{}", "PARALLEL\n".repeat(100)))).trim_end(),
        "77:1: branches are nested deeper than 64"
    );
}

#[test]
fn comments_that_are_no_elements_do_no_harm() {
    assert!(write("+--#ldmicro:#--( )( y )--+\n").is_ok());
    let written = write("# ladder: profile ldmicro #\n+--# ldmicro: BLINK y #--( )( y )--+\n");
    let written = written.expect("it can be written");
    assert!(!written.contains("    BLINK"), "{written}");
    assert!(resaved(written.as_bytes()).is_ok(), "{written}");
}

#[test]
fn ladder_programs_become_ldmicro_programs() {
    let written = write(
        r"VAR_INPUT
    Xstart, stop : BOOL;
END_VAR
VAR
    Twarm : TON;
END_VAR
# The motor. #
+--\--[ ]( Xstart )--\--[/]( stop )--( )( Yrun )--+
|  /--[ ]( Yrun )----/                             |
+--[ ]( Yrun )--[TON]( Twarm, T#5s )--( )( Yready )--+
+--[ ]( Yrun )--[CALC]( n, n * 2 + 1 )--+
",
    );
    expect![[r#"
        LDmicro0.1
        CYCLE=10000
        CRYSTAL=4000000
        BAUD=2400

        IO LIST
        END

        PROGRAM
        RUNG
            COMMENT The motor.
        END
        RUNG
            PARALLEL
                CONTACTS Xstart 0
                CONTACTS Yrun 0
            END
            CONTACTS Xstop 1
            COIL Yrun 0 0 0
        END
        RUNG
            CONTACTS Yrun 0
            TON Twarm 5000000
            COIL Yready 0 0 0
        END
        RUNG
            COMMENT +--[ ]( Yrun )--[CALC]( n, n * 2 + 1 )--+
        END
    "#]]
    .assert_eq(&written.expect("it can be written"));
}

#[test]
fn wide_rungs_are_refused() {
    let rung = format!("RUNG\nPARALLEL\n{}END\nEND\n", "OSR\n".repeat(65));
    let expected = "79:1: there are more than 64 parts next to each other: make several rungs of it";
    assert_eq!(read(&program(&rung)).trim_end(), expected);
}

#[test]
fn design_rules() {
    let rungs = "RUNG\n TON Ta 5000\n COIL Yout 0 0 0\n OSR\nEND\nRUNG\n RES Ta\nEND\nRUNG\n MOVE 5 70000\nEND\nRUNG\n PIECEWISE_LINEAR a b 2 5 0 5 9\nEND\nRUNG\n CONTACTS foo 0\nEND\nRUNG\n PLACEHOLDER\nEND\n";
    let converted = converted(program(rungs).as_bytes()).expect("it can be read");
    let findings = converted.findings.iter();
    let lines: Vec<String> = findings
        .map(|found| format!("{} {}: {}\n", found.place, found.check, found.message))
        .collect();
    let lines = lines.concat();
    expect![[r#"
        14:1 ldmicro-period: Timer period too short (needs faster cycle time).
        14:1 ldmicro-timer-name: Variable for 'Ta' incorrectly assigned: TON: variable cannot be used elsewhere.
        15:1 ldmicro-rightmost: COIL must be the rightmost element of its rung
        22:1 ldmicro-element: `MOVE 5 70000` stays as a comment: 5 is a number and cannot be written
        22:1 ldmicro-destination: '5' not a valid destination.
        22:1 ldmicro-constant: Constant 70000 out of range: -32768 to 32767 inclusive.
        25:1 ldmicro-curve: x values in piecewise linear table must be strictly increasing.
        25:1 ldmicro-unassigned: Variable 'b' not assigned to, e.g. with a MOV statement, an ADD statement, etc. This is probably a programming error; now it will always be zero.
        28:1 ldmicro-contact-name: the contact 'foo' is not an input (X), output (Y) or relay (R)
        31:1 ldmicro-element: `PLACEHOLDER` stays as a comment: the rung is empty: delete it, or add instructions
        31:1 ldmicro-empty-row: Empty row; delete it or add instructions before compiling.
    "#]].assert_eq(&lines);
}

/// LDmicro's own findings alone.
fn findings(text: &str) -> String {
    let converted = converted(text.as_bytes()).expect("it can be read");
    let line = |found: &Finding| format!("{} {}: {}\n", found.place, found.check, found.message);
    let own = converted.findings.iter();
    own.filter(|found| found.check != "ldmicro-element")
        .map(line)
        .collect()
}

#[test]
fn texts_and_their_variables() {
    let rung = |variable: &str, text: &str| {
        let codes: Vec<String> = text.bytes().map(|byte| byte.to_string()).collect();
        format!(
            "RUNG\n FORMATTED_STRING {variable} {} {}\nEND\n",
            text.len(),
            codes.join(" ")
        )
    };
    let rungs = [
        rung("n", "fine \\3\\r\\n \\xAB \\\\"),
        rung("(none)", "fine"),
        rung("n", "twice \\3 \\-5"),
        rung("n", "bad \\q \\3 \\xZZ \\"),
        rung("n", "without"),
        rung("(none)", "\\1 without"),
    ];
    expect![[r#"
        14:1 ldmicro-unassigned: Variable 'n' not assigned to, e.g. with a MOV statement, an ADD statement, etc. This is probably a programming error; now it will always be zero.
        20:1 ldmicro-text: The formatted string has more than one escape for its variable; one is possible
        23:1 ldmicro-text: Bad escape `\q ` in the formatted string; a backslash itself is `\\`
        23:1 ldmicro-text: Bad escape `\xZ` in the formatted string; a backslash itself is `\\`
        23:1 ldmicro-text: Bad escape `\` in the formatted string; a backslash itself is `\\`
        26:1 ldmicro-text: The formatted string has the variable `n` and no escape such as `\3` that says where it is written
        29:1 ldmicro-text: The formatted string has an escape for a variable, and no variable is given
    "#]].assert_eq(&findings(&program(&rungs.concat())));
}

#[test]
fn checks_of_the_fork() {
    let text = "LDmicro0.2\nPROGRAM\nRUNG 1\n TCY Ta 10000 0\n TON Tb 10000 0\nEND\nRUNG 2\n RES Ta\n MOVE Tb 5\nEND\nRUNG 3\n \
                RES n\n SET_PWM duty 1000 P1 8\n RES P1\nEND\nRUNG 4\n LOOK_UP_TABLE d 3 3 0 1 2 3 tab\n MOVE tab 5\nEND\nRUNG 5\n \
                GOTO start\n GOSUB sub\n BCD2BIN n 0x1A\nEND\nRUNG 6\n LABEL here\nEND\nRUNG 7\n LABEL here\nEND\nRUNG 8\n \
                SUBPROG sub\n OSR\nEND\nRUNG 9\n FORMATTED_STRING n \\t\\x20\\3\\q\nEND\n";
    expect![[r#"
        5:1 ldmicro-name: Variable for 'Tb' incorrectly assigned: TON: variable can only be used for RES elsewhere.
        8:1 ldmicro-rightmost: RES must be the rightmost element of its rung
        12:1 ldmicro-rightmost: RES must be the rightmost element of its rung
        12:1 ldmicro-name: Variable for 'n' incorrectly assigned: RES: Variable is not assigned to COUNTER or TIMER or PWM.
        13:1 ldmicro-rightmost: SET_PWM must be the rightmost element of its rung
        13:1 ldmicro-unassigned: Variable 'duty' not assigned to, e.g. with a MOV statement, an ADD statement, etc. This is probably a programming error; now it will always be zero.
        17:1 ldmicro-rightmost: LOOK_UP_TABLE must be the rightmost element of its rung
        17:1 ldmicro-index: index 3 is outside the table, which has 3 values, from 0 on
        17:1 ldmicro-name: Variable for 'tab' incorrectly assigned: TABLE: the name of a table can only be used for tables elsewhere.
        21:1 ldmicro-jump: GOTO 'start': there is no LABEL 'start'
        23:1 ldmicro-index: 0x1A is not a number in BCD: each of its bytes is a digit from 0 to 9
        29:1 ldmicro-jump: LABEL 'here' is there already, on line 26
        32:1 ldmicro-jump: SUBPROG 'sub': there is no ENDSUB 'sub'
        32:1 ldmicro-jump: SUBPROG must be alone in its rung
        36:1 ldmicro-text: Bad escape `\q` in the formatted string; a backslash itself is `\\`
    "#]].assert_eq(&findings(text));
}

#[test]
fn only_its_own_files_are_recognised() {
    let own = |bytes: &[u8]| Ldmicro.recognises(bytes);
    assert!(own(b"LDmicro0.1\r\nCYCLE=1\r\n"));
    assert!(own(b"LDmicro0.2"));
    assert!(!own(b"SECTIONS\n{\n  .text : { *(.text) }\n}\n"));
    assert!(!own(b"LDmicro export text\n"));
    assert!(!own(b"\xac\xed\x00\x05sr"));
}

/// A generator of numbers, so that failures come back.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

#[test]
fn broken_files_are_read_or_have_a_place() {
    let mut sound = vec![
        program(EVERYTHING).into_bytes(),
        FORK.as_bytes().to_vec(),
        crate::fork::EVERYTHING.as_bytes().to_vec(),
    ];
    if let Some(corpus) = corpus() {
        let real = [files(&corpus.join("programs")), files(&corpus.join("elements"))].concat();
        sound.extend(
            real.iter()
                .map(|file| std::fs::read(file).expect("the file can be read")),
        );
    }
    let mut numbers = Numbers(7);
    for round in 0..600 {
        let mut bytes = sound[round % sound.len()].clone();
        for _ in 0..=numbers.below(3) {
            let at = numbers.below(bytes.len());
            let to = (at + 1 + numbers.below(40)).min(bytes.len());
            match numbers.below(4) {
                0 => bytes.truncate(at),
                1 => drop(bytes.drain(at..to)),
                2 => {
                    let again = bytes[at..to].to_vec();
                    bytes.splice(at..at, again);
                }
                _ => bytes.insert(at, b"\0#\n -9'\xff\\E"[numbers.below(10)]),
            }
            if bytes.is_empty() {
                break;
            }
        }
        let source = Source::alone("test", &bytes);
        match convert(notation(), &source, &Options::default()) {
            Ok(converted) => {
                let Ok(text) = write(&converted.written.text) else {
                    continue;
                };
                let again = resaved(text.as_bytes());
                assert_eq!(again.as_deref(), Ok(text.as_bytes()), "{text}");
            }
            Err(error) => assert!(error.place.is_some(), "{error}"),
        }
    }
}

/// The folder of real programs, where there is one.
pub(crate) fn corpus() -> Option<PathBuf> {
    let folder = std::env::var_os("LADDER_CORPUS").map(|folder| Path::new(&folder).join("ldmicro"));
    if folder.is_none() {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
    }
    folder
}

pub(crate) fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry can be read").path())
        .collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "ld"));
    files.sort();
    files
}

#[test]
fn real_programs_are_saved_as_ldmicro_saves_them_and_come_back() {
    let Some(corpus) = corpus() else { return };
    let mut files = [files(&corpus.join("programs")), files(&corpus.join("elements"))].concat();
    files.retain(|file| !file.to_string_lossy().ends_with(".save.ld"));
    let mut lost = Vec::new();
    let (mut same, mut back) = (0, 0);
    let mut tally = [0; 3];
    for file in &files {
        let bytes = std::fs::read(file).expect("the file can be read");
        let saved = resaved(&bytes).expect("a real program can be read");
        if let Ok(expected) = std::fs::read_to_string(file.with_extension("save.ld")) {
            let expected = if bytes.windows(2).any(|pair| pair == b"\r\n") {
                expected.replace('\n', "\r\n")
            } else {
                expected
            };
            assert_eq!(String::from_utf8_lossy(&saved), expected, "{}", file.display());
            same += 1;
        }
        let converted = converted(&bytes).expect("a real program can be read");
        let counted = converted.report.tally();
        tally[0] += counted.translated;
        tally[1] += counted.approximated;
        tally[2] += counted.refused;
        for entry in converted.report.remarks() {
            println!("{}: {} {:?}", file.display(), entry.element, entry.outcome);
        }
        match there_and_back(&bytes) {
            Ok(text) if text.as_bytes() == saved => back += 1,
            Ok(text) => lost.push(format!("{}: differs\n{text}", file.display())),
            Err(error) => lost.push(format!("{}: {error}", file.display())),
        }
    }
    println!(
        "{} read, {same} saved alike, {back} come back, elements {tally:?}",
        files.len()
    );
    assert!(lost.is_empty(), "{}", lost.join("\n"));
}
