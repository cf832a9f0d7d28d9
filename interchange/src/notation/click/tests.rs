//! Programs in Python as ladder text, and back.

use super::super::{Converted, Notation, Source, convert};
use super::Click;
use expect_test::{expect, expect_file};

const BOTTLING: &str = include_str!("../../../tests/click/bottling.py");

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

/// What the analysis says about a converted program, whose profile does not run yet.
fn complaints(text: &str) -> String {
    let text = text.replace("# ladder: profile click #", "");
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&text).into(), "test.clad");
    let mut out = String::new();
    for diagnostic in analysis.diagnostics.iter() {
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
fn every_construct_becomes_ladder_text() {
    let converted = converted(BOTTLING);
    expect_file!["../../../tests/click/bottling.clad"].assert_eq(&converted.written.text);
    expect![[r#"
        1:1 `c.FoundSeven`: Approximated("it is spelled `FoundSeven_2` here")
        1:1 `dh.Word`: Approximated("it is spelled `_Word` here")
        1:1 `c.Step`: Approximated("it is spelled `Step_2` here")
        1:1 `ds.Temperature`: Approximated("it is spelled `Temperature_2` here")
        115:12 `sc.FirstScan`: Approximated("Click's controller sets it, and nothing does here")
        81:9 `shift(c[301:317])`: Approximated("nothing says what enters it: the rung shifts, and the first bit stays")
    "#]].assert_eq(&remarks(&converted));
    expect![""].assert_eq(&complaints(&converted.written.text));
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
    expect_file!["../../../tests/click/bottling_again.py"].assert_eq(&python);
    expect![""].assert_eq(&remarks);
    // What is written says the same, and is written the same again.
    assert_eq!(converted(BOTTLING).written.text, converted(&python).written.text);
    assert_eq!(written_back(&python).0, python);
}
