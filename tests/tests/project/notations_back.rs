//! Generated programs to each notation and back: nothing is remarked on, the networks are the same, and they do the same
//! in every scan under the profile of the notation.

mod logix;
mod plcopen;
mod says;
mod simatic;
mod tables;
mod whole;

use ladder_analysis::analyze;
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_invariants::trace::{Stimulus, next_to};
use ladder_notations::{Notation, Source, by_name, convert};
use ladder_syntax::parse;
use says::{Rungs, Says, networks};
use std::sync::Arc;
use tables::{ASCII, CLICK, CLICK_CSV, CPLC_DRAFT, IOT, LDMICRO, LDMICRO_TEXT, LOGIX, SIMATIC, TEXTBOOK};

fn check(says: &Says) {
    let notation: &dyn Notation = by_name(says.notation).expect("the notation is registered");
    for seed in 0..60 {
        let mut dice = Dice::new(seed);
        let text = says.program(&mut dice);
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
        assert!(errors.is_empty(), "{errors:?}\n{text}");
        let writing = notation
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let remarks: Vec<_> = writing.report.remarks().collect();
        assert!(remarks.is_empty(), "{remarks:?}\n{text}");
        let shown = String::from_utf8_lossy(&writing.bytes);
        assert!(notation.recognises(&writing.bytes), "{shown}");
        let source = Source {
            companions: writing.companions,
            ..Source::alone("test", &writing.bytes)
        };
        let back = convert(notation, &source, &Options::default());
        let back = back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"));
        let remarks: Vec<_> = back.report.remarks().collect();
        // A program of Click ends with END, and a counter is after an edge: its own software says so.
        let findings = back.findings.iter().filter(|_| says.rungs == Rungs::Any).count();
        assert!(
            remarks.is_empty() && findings == 0,
            "{remarks:?} {:?}\n{shown}",
            back.findings
        );
        let ladder = back.written.text;
        assert_eq!(networks(&ladder), networks(&text), "{shown}");
        let different = next_to(&ladder, &text, Stimulus { seed, scans: 60 });
        assert_eq!(different, None, "{ladder}\nof\n{shown}\nof\n{text}");
    }
}

#[test]
fn ldmicro() {
    check(&LDMICRO);
}

#[test]
fn ldmicro_text() {
    check(&LDMICRO_TEXT);
}

#[test]
fn iot() {
    check(&IOT);
}

#[test]
fn logix() {
    check(&LOGIX);
}

#[test]
fn click() {
    check(&CLICK);
}

#[test]
fn click_csv() {
    check(&CLICK_CSV);
}

#[test]
fn textbook() {
    check(&TEXTBOOK);
}

#[test]
fn cplc_draft() {
    check(&CPLC_DRAFT);
}

#[test]
fn simatic() {
    check(&SIMATIC);
    check(&Says {
        notation: "simaticml",
        ..SIMATIC
    });
}

#[test]
fn ascii() {
    let notation = by_name(ASCII.notation).expect("the notation is registered");
    for seed in 0..120 {
        let text = ASCII.program(&mut Dice::new(seed));
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let writing = notation
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let shown = String::from_utf8_lossy(&writing.bytes);
        assert!(notation.recognises(&writing.bytes), "{shown}");
        let back = convert(
            notation,
            &Source::alone("test", &writing.bytes),
            &Options::default(),
        );
        let back = back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"));
        assert!(back.findings.is_empty(), "{:?}\n{shown}", back.findings);
        let end = text.rfind("END_VAR").expect("there are declarations") + "END_VAR\n".len();
        let ladder = format!("{}\n{}", &text[..end], back.written.text);
        let different = next_to(&ladder, &text, Stimulus { seed, scans: 60 });
        assert_eq!(different, None, "{ladder}\nof\n{shown}\nof\n{text}");
    }
}
