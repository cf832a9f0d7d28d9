//! Programs of any wiring as SIMATIC source documents and as SimaticML, and back.

use ladder_analysis::analyze;
use ladder_format::Options;
use ladder_invariants::generator::{Mode, program};
use ladder_invariants::trace::{Stimulus, next_to};
use ladder_notations::{Notation, Source, Writing, by_name, convert};
use ladder_syntax::parse;
use std::sync::Arc;

/// Any wiring and any instruction: what is written without a remark does the same when it is read, and is written the same again. As
/// SimaticML it is the same program.
#[test]
fn simatic_says_what_it_cannot() {
    let notation = by_name("simatic").expect("the notation is registered");
    let export = by_name("simaticml").expect("the notation is registered");
    let (mut written, mut same_there) = (0, 0);
    for seed in 0..400 {
        let mode = [Mode::Boolean, Mode::Boolean, Mode::Sensible, Mode::Wild][seed as usize % 4];
        let text = program(seed, mode);
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let Ok(writing) = notation.write(&analysis) else {
            continue;
        };
        let remarks = |writing: &Writing| writing.report.remarks().cloned().collect::<Vec<_>>();
        let told = remarks(&writing);
        let (ladder, shown) = read(notation, writing, &text);
        let writing = export.write(&analysis).expect("it is written as a document");
        let said_there = remarks(&writing);
        let (ladder_there, shown_there) = read(export, writing, &text);
        let analysis = analyze(&Arc::new(parse(&ladder)), "test.clad");
        let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
        if told.is_empty() {
            written += 1;
            // First values are written one by one there, and wires that join the rail come first.
            same_there += usize::from(drawn(&ladder_there).0 == drawn(&ladder).0);
            assert_eq!(said_there, [], "{text}");
            assert!(errors.is_empty(), "{errors:?}\n{ladder}\nof\n{shown}\nof\n{text}");
            let different = next_to(&text, &ladder, Stimulus { seed, scans: 60 });
            assert_eq!(different, None, "{ladder}\nof\n{shown}\nof\n{text}");
            let different = next_to(&text, &ladder_there, Stimulus { seed, scans: 60 });
            assert_eq!(different, None, "{ladder_there}\nof\n{shown_there}\nof\n{text}");
            let again = notation.write(&analysis).expect("it was written once");
            let (same, shown) = read(notation, again, &text);
            assert_eq!(drawn(&same), drawn(&ladder), "{shown}\nof\n{text}");
        }
    }
    println!("{written} of 400 programs without a remark, {same_there} of them drawn the same as SimaticML");
    assert!(
        written > 80 && same_there * 10 > written * 9,
        "{written} {same_there}"
    );
}

/// What is written of a text, read again, and as it is written.
fn read(notation: &'static dyn Notation, writing: Writing, text: &str) -> (String, String) {
    let shown = String::from_utf8_lossy(&writing.bytes).into_owned();
    let source = Source {
        companions: writing.companions,
        ..Source::alone("test", &writing.bytes)
    };
    let back = convert(notation, &source, &Options::default());
    let back = back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"));
    (back.written.text, shown)
}

/// The rungs of a text and what it declares, without what is reported. The states of functions are declared in a section of their own: where
/// it is does not matter.
fn drawn(text: &str) -> (String, String) {
    let lines = text
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    let (rungs, mut rest): (Vec<_>, Vec<_>) = lines.partition(|line| line.starts_with(['+', '|']));
    rest.sort_unstable();
    (rungs.join("\n"), rest.join("\n"))
}
