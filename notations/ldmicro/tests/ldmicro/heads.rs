//! The first lines of LDmicro's programs, as releases of its fork wrote them.

use crate::programs::{converted, read, there_and_back};
use expect_test::expect;
use ladder_analysis::Severity;
use ladder_notation::Notation;
use ladder_notation_ldmicro::{Ldmicro, resaved};
use std::path::Path;

fn field(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/field");
    std::fs::read(folder.join(name)).expect("the file can be read")
}

/// A program with this head and one timer, whose delay tells the version.
fn program(head: &str) -> String {
    format!(
        "{head}\nCYCLE=10000\n\nIO LIST\n  Xa at 2\nEND\n\nPROGRAM\nRUNG 1\n  CONTACTS Xa 0\n  TON Ta 50000\n  COIL Ya 0 0 0\nEND\n"
    )
}

#[test]
fn every_header_but_the_first_is_that_of_the_fork() {
    let heads = [
        ("LDmicro0.1", false),
        ("LDmicro 0.1", false),
        ("LDmicro0.2", true),
        ("LDmicro0.3", true),
        ("LDmicro", true),
        ("LDmicroX", true),
        ("\u{feff}LDmicro", true),
        ("; by hand\n\nMICRO=Atmel AVR ATmega8 28-PDIP\nLDmicro", true),
        ("LDmicro0.1\nLDmicro0.2", true),
    ];
    for (head, is_forks) in heads {
        let text = program(head);
        let one_word = !head.contains("o 0.1");
        assert_eq!(Ldmicro.recognises(text.as_bytes()), one_word, "{head}");
        let saved = resaved(text.as_bytes()).expect("it can be read");
        let first = if is_forks { "LDmicro0.2\n" } else { "LDmicro0.1\n" };
        assert!(saved.starts_with(first.as_bytes()), "{head}");
        let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
        let delay = if is_forks { "T#60ms" } else { "T#50ms" };
        assert!(ladder.contains(delay), "{head}\n{ladder}");
        assert_eq!(
            there_and_back(&saved),
            Ok(String::from_utf8(saved).expect("it is text"))
        );
    }
    assert_eq!(
        read(&program("; nothing")),
        "1:1: the first line of an LDmicro program is `LDmicro0.1` or `LDmicro0.2`\n"
    );
}

#[test]
fn what_is_no_program_is_not_recognised() {
    let others = [
        "LDmicro export text\nno MCU assigned\nPROGRAM\n",
        "LDmicro\nis a program for ladder diagrams.\n",
        "IO LIST\nPROGRAM\n",
        "",
    ];
    for other in others {
        assert!(!Ldmicro.recognises(other.as_bytes()), "{other}");
    }
}

#[test]
fn lines_of_the_head_that_nobody_knows_are_kept() {
    let text = program("LDmicro\nOWNER=the mill # 3\nPATH=D:\\x23\\x5C\\\\x23#\nNAME Xa = Xb");
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    let head: String = ladder.split_inclusive('\n').take(8).collect();
    expect![[r#"
        # ldmicro: LDmicro0.2 #
        # ldmicro: CYCLE=10000 #
        # ldmicro: CRYSTAL=4000000 #
        # ldmicro: BAUD=2400 #
        # ldmicro: HEADER OWNER=the mill \x23 3 #
        # ldmicro: HEADER PATH=D:\x5Cx23\x5Cx5C\\x5Cx23\x23 #
        # ldmicro: HEADER NAME Xa = Xb #
        # ladder: profile ldmicro #
    "#]]
    .assert_eq(&head);
    let back = there_and_back(text.as_bytes()).expect("it can be written");
    assert_eq!(back.as_bytes(), resaved(text.as_bytes()).expect("it can be read"));
    expect![[r#"
        LDmicro0.2
        CYCLE=10000
        CRYSTAL=4000000
        BAUD=2400
        OWNER=the mill # 3
        PATH=D:\x23\x5C\\x23#
        NAME Xa = Xb

        IO LIST
          Xa at 2
        END

        PROGRAM
        RUNG 1
          CONTACTS Xa 0
          TON Ta 50000
          COIL Ya 0 0 0
        END
    "#]]
    .assert_eq(&back);
}

#[test]
fn a_header_without_a_version_and_a_named_curve() {
    for name in ["ld_bare_header/input.ld", "ld_named_piecewise/input.ld"] {
        let bytes = field(name);
        assert!(Ldmicro.recognises(&bytes), "{name}");
        let found = converted(&bytes).expect("it can be read").findings;
        let is_error = |severity| severity == Severity::Error;
        assert!(
            !found.iter().any(|found| is_error(found.severity)),
            "{name}: {found:?}"
        );
    }
    let networks = |name: &str| {
        let ladder = converted(&field(name)).expect("it can be read").written.text;
        let comment = "# was: PIECEWISE_LINEAR deg Atemp 3 0 0 150 75 300 150 curve #";
        ladder.replace(&format!("--{comment}"), "").replace('-', "")
    };
    assert_eq!(
        networks("ld_named_piecewise/input.ld"),
        networks("ld_named_piecewise/without_name.ld")
    );
}

/// The fork saves files of the old version, too, with its own escapes.
#[test]
fn escapes_of_the_fork_are_read_in_both_versions() {
    for head in ["LDmicro0.1", "LDmicro0.2"] {
        let rung = "CONTACTS Xa 0\n  FORMATTED_STRING (none) 8 92 97 92 101 92 88 52 49\n  FORMATTED_STRING (none) 2 92 113";
        let text = program(head).replace("CONTACTS Xa 0", rung);
        let converted = converted(text.as_bytes()).expect("it can be read");
        assert!(
            converted.written.text.contains(r"[FMT]( '$07$1BA' )"),
            "{}",
            converted.written.text
        );
        let found = converted
            .findings
            .iter()
            .filter(|found| found.check == "ldmicro-text");
        let found: Vec<&str> = found.map(|found| found.message.as_str()).collect();
        assert_eq!(
            found,
            [r"Bad escape `\q` in the formatted string; a backslash itself is `\\`"]
        );
    }
}
