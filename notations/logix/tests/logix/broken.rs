//! Files that are broken: none makes a panic, and nothing of a rung is lost in silence.

use crate::exports::{controller, whole};
use ladder_format::Options;
use ladder_notation::{Converted, Notation, ReadError, Source, convert};
use ladder_notation_logix::{L5k, L5x, Rslogix500};
use proptest::prelude::*;
use std::collections::HashMap;

fn read(notation: &dyn Notation, text: &str) -> Result<Converted, ReadError> {
    convert(
        notation,
        &Source::alone("prog", text.as_bytes()),
        &Options::default(),
    )
}

/// What rungs are put together from, well or badly.
const PIECES: [&str; 30] = [
    "XIC(a)",
    "XIO(w.3)",
    "OTE(b)",
    "ONS(w.0)",
    "TON(t,?,?)",
    "CTU(c,5,0)",
    "RES(t)",
    "MOV(r,w)",
    "ADD(w,1,w)",
    "CPT(w,(w+1)*2)",
    "CMP(w>1)",
    "LIM(1,w,5)",
    "JSR(Sub,0)",
    "JMP(x)",
    "LBL(x)",
    "FFL(w,arr,k,?,?)",
    "COP(arr,arr,2)",
    "MSG(m)",
    "XIC()",
    "OTE(nobody)",
    "MOV(arr[w],arr[9])",
    "[",
    ",",
    "]",
    "(",
    ")",
    "'",
    "XIC(t",
    "NOP()",
    " ",
];

const TAGS: [(&str, &str, &str); 8] = [
    ("a", "BOOL", ""),
    ("b", "BOOL", ""),
    ("w", "DINT", ""),
    ("r", "REAL", ""),
    ("t", "TIMER", ""),
    ("c", "COUNTER", ""),
    ("k", "CONTROL", ""),
    ("arr", "DINT[4]", ""),
];

/// How often each instruction begins in a text, by its name.
fn begun(texts: impl Iterator<Item = String>) -> HashMap<String, usize> {
    let mut names = HashMap::new();
    for text in texts {
        let end = text.find('(').unwrap_or(text.len());
        *names.entry(text[..end].to_owned()).or_default() += 1;
    }
    names
}

/// The pieces that leave no operand list open: what is inside of another's operands is not an instruction.
fn closed() -> Vec<&'static str> {
    let is_closed = |piece: &&str| !matches!(*piece, "XIC(t" | "(" | "'");
    PIECES.into_iter().filter(is_closed).collect()
}

proptest! {
    #[test]
    fn every_instruction_of_a_rung_is_accounted_for(pieces in prop::collection::vec(prop::sample::select(closed()), 1..14)) {
        let rung = pieces.concat();
        let source = whole("", &TAGS, &[("Main", &["NOP();", rung.as_str()][..]), ("Sub", &["NOP();"])]);
        let line = 1 + source[..source.find(&format!("[{rung}]]>")).expect("it is there")].matches('\n').count() as u32;
        let converted = read(&L5x, &source).expect("the envelope is whole");
        let here = || converted.report.entries.iter().filter(|entry| entry.place.line == line);
        let is_refused = here().any(|entry| matches!(entry.outcome, ladder_notation::Outcome::Refused(_)) && entry.element != "XIC()");
        if !is_refused {
            let whole = pieces.iter().filter(|piece| piece.ends_with(')') && piece.len() > 1);
            let expected = begun(whole.map(|piece| (*piece).to_owned()));
            let found = begun(here().map(|entry| entry.element.clone()));
            for (name, count) in expected {
                prop_assert_eq!(found.get(&name).copied().unwrap_or(0), count, "{} in {}", name, rung);
            }
        }
    }

    #[test]
    fn mutated_files_are_read_or_refused(
        which in 0..3usize,
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0..9usize, prop::sample::select(&PIECES)), 1..5),
    ) {
        let l5k = "CONTROLLER C\nTAG\nt : TIMER := [0,5,0];\na OF b.3;\nEND_TAG\nPROGRAM P (MAIN := \"M\")\nROUTINE M\nRC: \"x\";\nN: XIC(a)TON(t,?,?);\nEND_ROUTINE\nEND_PROGRAM\nEND_CONTROLLER\n";
        let slc = "SOR BST XIC I:0/0 NXB XIC N7:[N7:1]/3 BND TON T4:0 1.0 5 0 EOR\nXIC B3/18 COP #N7:0 #N9:2 4\n";
        let (notation, mut text): (&dyn Notation, String) = match which {
            0 => (&L5x, controller(&TAGS, &["XIC(a)[ONS(w.0) ,XIO(b) ]TON(t,?,?)OTE(b);", "CPT(w,w+1)FFL(w,arr,k,?,?);"])),
            1 => (&L5k, l5k.to_owned()),
            _ => (&Rslogix500, slc.to_owned()),
        };
        for (at, length, piece) in cuts {
            let mut start = at.index(text.len() + 1);
            while !text.is_char_boundary(start) {
                start -= 1;
            }
            let mut end = (start + length).min(text.len());
            while !text.is_char_boundary(end) {
                end += 1;
            }
            text.replace_range(start..end, piece);
        }
        if let Ok(converted) = read(notation, &text) {
            let written = &converted.written.text;
            let errors = ladder_syntax::parse(written).errors();
            prop_assert!(errors.is_empty(), "{:?}\n{}", errors, written);
            prop_assert_eq!(&ladder_format::format_text(written, &Options::default()), written);
        }
    }
}

#[test]
fn hostile_xml_is_refused_with_a_message() {
    let bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE x [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n<RSLogix5000Content>&b;</RSLogix5000Content>";
    let deep = format!("<RSLogix5000Content>{}", "<a>\n".repeat(100_000));
    let closed = format!(
        "<RSLogix5000Content>{}{}<Controller/></RSLogix5000Content>",
        "<a>\n".repeat(100_000),
        "</a>\n".repeat(100_000)
    );
    // Depth alone is no harm where nothing is read.
    assert!(read(&L5x, &closed).is_ok_and(|converted| converted.report.entries.is_empty()));
    let message = |text: &str| read(&L5x, text).expect_err("it is refused").to_string();
    assert_eq!(
        message(bomb),
        "1:1: the file has a document type (`<!DOCTYPE`), which no project needs: take it out"
    );
    assert!(
        message(&deep).contains("the file ends too early"),
        "{}",
        message(&deep)
    );
    assert!(message("<RSLogix5000Content><Controller>").contains("the file ends too early"));
    assert_eq!(
        message("<plist/>"),
        "it is XML, but no export of Logix Designer: those begin with <RSLogix5000Content>"
    );
    assert_eq!(
        message("<RSLogix5000Content/>"),
        "the file has no <Controller>: there is nothing to read"
    );
}

#[test]
fn deep_branches_and_long_rungs_are_refused_where_they_are() {
    let deep = format!("{}XIC(a)", "[".repeat(5_000));
    let long = "XIC(a)".repeat(5_000);
    let formula = format!("CPT(w,{}w{})", "(".repeat(5_000), ")".repeat(5_000));
    let source = controller(&TAGS, &[&deep, &long, &formula, "XIC(a)OTE(b);"]);
    let converted = read(&L5x, &source).expect("the rest is read");
    let remarks = converted.report.remarks();
    let shown: Vec<String> = remarks
        .map(|entry| {
            let why = match &entry.outcome {
                ladder_notation::Outcome::Refused(why) | ladder_notation::Outcome::Approximated(why) => why,
                ladder_notation::Outcome::Translated => "",
            };
            format!("{}: {why}", entry.place)
        })
        .collect();
    expect_test::expect![[r#"
        22:35: branches are nested deeper than 24
        27:12016: the rung has more than 2000 parts
        32:10: the operand is nested deeper than 40: it is not run, and power passes"#]]
    .assert_eq(&shown.join("\n"));
    assert!(converted.written.text.contains("( )( b )"));
}

#[test]
fn a_long_line_is_refused_with_a_message() {
    let long = format!(
        "CONTROLLER C\nPROGRAM P\nROUTINE M\n{}",
        "N: XIC(a)OTE(b);".repeat(100_000)
    );
    let error = read(&L5k, &long).expect_err("it is refused").to_string();
    assert!(error.starts_with("4:1: there is too much on one line"), "{error}");
    for text in [
        "(*",
        "CONTROLLER C (*",
        "CONTROLLER C TAG a : DINT[0] := 5; END_TAG END_CONTROLLER",
    ] {
        let _ = read(&L5k, text);
    }
    let wide = controller(
        &[("a", "DINT[4000000000 4000000000 4000000000]", "")],
        &["MOV(1,a[5,6,3999999999]);"],
    );
    let _ = read(&L5x, &wide);
}
