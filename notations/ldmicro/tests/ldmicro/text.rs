//! The text that LDmicro exports, read and written.

use crate::programs::{corpus, files};
use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Outcome, Source, convert};
use ladder_notation_ldmicro::{Ldmicro, LdmicroText};
use std::path::{Path, PathBuf};

fn converted(from: &dyn Notation, bytes: &[u8]) -> Result<Converted, String> {
    let source = Source::alone("test", bytes);
    convert(from, &source, &Options::default()).map_err(|error| error.to_string())
}

/// The text that LDmicro would export for a program.
fn exported(program: &[u8]) -> Result<String, String> {
    let ladder = converted(&Ldmicro, program)?.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "test.clad");
    let writing = LdmicroText.write(&analysis).map_err(|error| error.to_string())?;
    String::from_utf8(writing.bytes).map_err(|error| error.to_string())
}

/// The programs with the text that LDmicro 2.2 exported for each.
fn pairs() -> Vec<(PathBuf, PathBuf)> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/ldmicro/elements");
    let mut programs = files(&own);
    if let Some(corpus) = corpus() {
        programs.extend(files(&corpus.join("elements")));
        programs.extend(files(&corpus.join("programs")));
    }
    let pair = |program: PathBuf| {
        let text = program.with_extension("export.txt");
        text.exists().then_some((program, text))
    };
    programs.into_iter().filter_map(pair).collect()
}

#[test]
fn what_is_exported_is_what_ldmicro_exported() {
    let mut different = Vec::new();
    let mut same = 0;
    for (program, text) in pairs() {
        let bytes = std::fs::read(&program).expect("the file can be read");
        let expected = std::fs::read_to_string(&text).expect("the file can be read");
        let exported = exported(&bytes).unwrap_or_else(|error| panic!("{}: {error}", program.display()));
        if exported.replace("\r\n", "\n") == expected {
            same += 1;
        } else {
            different.push(format!("{}\n{exported}", program.display()));
        }
    }
    println!("{same} are the same");
    assert!(
        different.is_empty(),
        "{} differ:\n{}",
        different.len(),
        different.join("\n")
    );
}

/// The networks of a ladder text without columns and tables, which an exported text does not hold.
fn networks(ladder: &str) -> String {
    let start = ladder.rfind("END_VAR").unwrap_or(0);
    let mut out = String::new();
    for line in ladder[start..].lines() {
        let words: Vec<&str> = line
            .split("--")
            .map(|word| word.trim_matches('-'))
            .filter(|word| !word.is_empty())
            .map(|word| match word {
                _ if word.starts_with("[LUT]") || word.contains("LOOK_UP_TABLE") => "a table",
                _ if word.starts_with("[PWL]") || word.contains("PIECEWISE_LINEAR") => "a curve",
                word => word,
            })
            .collect();
        out.push_str(words.join("-").trim_end_matches(['+', '|', ' ']));
        out.push('\n');
    }
    out
}

#[test]
fn what_ldmicro_exported_is_the_program_again() {
    let mut different = Vec::new();
    for (program, text) in pairs() {
        let program = std::fs::read_to_string(&program).expect("the file can be read");
        // Blanks at the end of a line are not seen in a drawing.
        let program = program.replace("high \\r\\n", "high\\r\\n");
        let bytes = std::fs::read(&text).expect("the file can be read");
        let whole = converted(&Ldmicro, program.as_bytes()).expect("it can be read");
        match converted(&LdmicroText, &bytes) {
            Ok(read) => {
                let (whole, read) = (networks(&whole.written.text), networks(&read.written.text));
                if whole != read {
                    different.push(format!("{}\n{whole}\n{read}", text.display()));
                }
            }
            Err(error) => different.push(format!("{}: {error}", text.display())),
        }
    }
    assert!(
        different.is_empty(),
        "{} differ:\n{}",
        different.len(),
        different.join("\n")
    );
}

/// A program of the settings that every program has, its text, and what there is to say about both ways.
#[track_caller]
fn check(rungs: &str, expected: Expect) {
    let program = format!(
        "LDmicro0.1\nCYCLE=10000\nMICRO=Atmel AVR ATmega8 28-PDIP\n\nIO LIST\n    Xa at 2\n    Yout at 4\nEND\n\nPROGRAM\n{rungs}"
    );
    let ladder = converted(&Ldmicro, program.as_bytes())
        .expect("it can be read")
        .written
        .text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "test.clad");
    let writing = LdmicroText.write(&analysis).expect("it can be written");
    let mut out = String::from_utf8(writing.bytes).expect("it is UTF-8");
    let read = converted(&LdmicroText, out.as_bytes()).expect("it can be read again");
    for (way, report) in [("written", writing.report), ("read", read.report)] {
        for entry in report.remarks() {
            let (word, why) = match &entry.outcome {
                Outcome::Approximated(why) => ("approximated", why),
                Outcome::Refused(why) => ("refused", why),
                Outcome::Translated => continue,
            };
            out.push_str(&format!("{way} {}: {word}: {why}\n", entry.element));
        }
    }
    expected.assert_eq(&out);
}

#[test]
fn gaps_and_junctions_look_alike() {
    check(
        "RUNG\n CONTACTS Xa 0\n PARALLEL\n  OPEN\n  SERIES\n   SHORT\n   OPEN\n   PARALLEL\n    CONTACTS Yout 1\n    SHORT\n   END\n  END\n \
         END\n OPEN\n PARALLEL\n  COIL Yout 0 0 0\n  SERIES\n   OSR\n   UART_SEND ch\n  END\n END\nEND\n",
        expect![[r#"
            LDmicro export text
            for 'Atmel AVR ATmega8 28-PDIP', 4.000000 MHz crystal, 10.0 ms cycle time


            LADDER DIAGRAM:

               ||                                                                                                                       ||
               ||       Xa                                                                                                   Yout       ||
             1 ||-------] [------+----+      +--------------------------------------+----+      +----+------------------------( )-------||
               ||                |                                                  |                |                                  ||
               ||                |                                        Yout      |                |          _             ch        ||
               ||                +----+------+---------+      +----+-------]/[------+                +----[OSR_/ ]--------{UART SEND}---||
               ||                                                  |                |                                                   ||
               ||                                                  |                |                                                   ||
               ||                                                  +----+------+----+                                                   ||
               ||                                                                                                                       ||
               ||                                                                                                                       ||
               ||                                                                                                                       ||
               ||------[END]------------------------------------------------------------------------------------------------------------||
               ||                                                                                                                       ||
               ||                                                                                                                       ||


            I/O ASSIGNMENT:

              Name                       | Type               | Pin
             ----------------------------+--------------------+------
              Xa                         | digital in         | <UART needs!>
              Yout                       | digital out        | 4
              ch                         | UART tx            | 3
        "#]],
    );
}

#[test]
fn what_the_drawing_does_not_hold() {
    check(
        "RUNG\n COMMENT A comment that is longer than the drawing is wide otherwise.\nEND\nRUNG\nEND\nRUNG\n TON Ta 1234567\n \
         LOOK_UP_TABLE d i 2 0 10 20\nEND\nRUNG\n SET_PWM duty 12345\nEND\nRUNG\n MOVE a_long_name 5\nEND\nRUNG\n EQU a 12345\n \
         FORMATTED_STRING (none) 3 72 105 33\nEND\n",
        expect![[r#"
            LDmicro export text
            for 'Atmel AVR ATmega8 28-PDIP', 4.000000 MHz crystal, 10.0 ms cycle time


            LADDER DIAGRAM:

               ||                                                                    ||
               || ; A comment that is longer than the drawing is wide otherwise.     ||
             1 ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
             2 ||                                                                    ||
               ||                                                                    ||
               ||       Ta                                           { d :=       }  ||
             3 ||--[TON 1.235 s]-------------------------------------{  LUT[i]    }--||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                         duty       ||
             4 ||----------------------------------------------------{PWM 12.3 kHz}--||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
             5 ||----------------------------------------------------!!!too long!!!--||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||    [a ==  ]                                                        ||
             6 ||----[ 12345]------------------{"Hi!"}--------------                 ||
               ||                                                                    ||
               ||                                                                    ||
               ||                                                                    ||
               ||------[END]---------------------------------------------------------||
               ||                                                                    ||
               ||                                                                    ||


            I/O ASSIGNMENT:

              Name                       | Type               | Pin
             ----------------------------+--------------------+------
              duty                       | PWM out            | 17
              Ta                         | turn-on delay      | 
              a_long_name                | general var        | 
              d                          | general var        | 
            written TON Ta 1234567: approximated: its delay is rounded to 1.235 s
            written LOOK_UP_TABLE d i 2 0 10 20: approximated: the drawing does not hold its table
            written SET_PWM duty 12345: approximated: its frequency is rounded to 12.3 kHz
            written MOVE a_long_name 5: approximated: it is too long for the drawing
            read RUNG: approximated: the rung is empty
            read LOOK_UP_TABLE d i 0 0: refused: the exported text does not hold its table
            read !!!too long!!!: refused: LDmicro left the element out, since it was too long for the drawing
        "#]],
    );
}

#[test]
fn what_is_wrong_has_a_place() {
    let text = "LDmicro export text\nno MCU assigned, 4.000000 MHz crystal, 10.0 ms cycle time\n\nLADDER DIAGRAM:\n\n   ||                 ||\n   \
                ||       Yo        ||\n 1 ||-------( )-------||\n   ||                 ||\n   ||------[END]------||\n";
    let mut out = String::new();
    for (from, to) in [
        ("", ""),
        ("4.000000 MHz", "fast"),
        ("LADDER", "SNAKE"),
        ("( )-------||", "( )------||"),
        (" 1 ||---", " 1 ||- -"),
        ("( )", "(X)"),
        ("       Yo ", "          "),
        ("[END]", "-----"),
        ("-------( )", "---+---( )"),
        ("-------( )", "[BLINK 3]-"),
        ("   ||       Yo        ||", "    ||       Yo        ||"),
    ] {
        let broken = text.replacen(from, to, 1);
        let found = match converted(&LdmicroText, broken.as_bytes()) {
            Ok(_) => "it can be read".to_owned(),
            Err(error) => error,
        };
        out.push_str(&format!("{found}\n"));
    }
    expect![[r#"
        it can be read
        2:1: here are the crystal and the cycle time: `.., 4.000000 MHz crystal, 10.0 ms cycle time`
        there is no `LADDER DIAGRAM:` in the text
        8:1: between the rails are cells of 17 columns, at most 256 of them
        8:8: `-` is nothing that is in a wire
        8:13: `(X)` is not an element of LDmicro 2.2
        8:13: there is no name above this element
        there is no `[END]` in the diagram
        8:9: wires cross between two cells only
        8:6: `[BLINK 3]` is not an element of LDmicro 2.2
        7:1: this is a text of LDmicro's fork; only those of LDmicro 2.2 are read
    "#]]
    .assert_eq(&out);
}
