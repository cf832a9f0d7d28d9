//! Programs of any wiring as SIMATIC source documents, and back.

use ladder_analysis::analyze;
use ladder_format::Options;
use ladder_invariants::generator::{Mode, program};
use ladder_invariants::trace::{Stimulus, next_to};
use ladder_notations::{Source, Writing, by_name, convert};
use ladder_syntax::parse;
use std::sync::Arc;

/// Any wiring and any instruction: what is written without a remark does the same when it is read, and is written the same again.
#[test]
fn simatic_says_what_it_cannot() {
    let notation = by_name("simatic").expect("the notation is registered");
    let mut written = 0;
    for seed in 0..400 {
        let mode = [Mode::Boolean, Mode::Boolean, Mode::Sensible, Mode::Wild][seed as usize % 4];
        let text = program(seed, mode);
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        let Ok(writing) = notation.write(&analysis) else {
            continue;
        };
        let is_whole = writing.report.remarks().next().is_none();
        let read = |writing: Writing| {
            let shown = String::from_utf8_lossy(&writing.bytes).into_owned();
            let source = Source {
                companions: writing.companions,
                ..Source::alone("test", &writing.bytes)
            };
            let back = convert(notation, &source, &Options::default());
            (
                back.unwrap_or_else(|error| panic!("{error}\n{shown}\nof\n{text}"))
                    .written
                    .text,
                shown,
            )
        };
        let (ladder, shown) = read(writing);
        let analysis = analyze(&Arc::new(parse(&ladder)), "test.clad");
        let errors: Vec<&str> = analysis.errors().map(|error| error.message.as_str()).collect();
        if is_whole {
            written += 1;
            assert!(errors.is_empty(), "{errors:?}\n{ladder}\nof\n{shown}\nof\n{text}");
            let different = next_to(&text, &ladder, Stimulus { seed, scans: 60 });
            assert_eq!(different, None, "{ladder}\nof\n{shown}\nof\n{text}");
            let again = notation.write(&analysis).expect("it was written once");
            let (same, shown) = read(again);
            // The states of functions are declared in a section of their own: where it is does not matter.
            let drawn = |text: &str| {
                let lines = text
                    .lines()
                    .filter(|line| !line.is_empty() && !line.starts_with('#'));
                let (rungs, mut rest): (Vec<_>, Vec<_>) =
                    lines.partition(|line| line.starts_with(['+', '|']));
                rest.sort_unstable();
                (rungs.join("\n"), rest.join("\n"))
            };
            assert_eq!(drawn(&same), drawn(&ladder), "{shown}\nof\n{text}");
        }
    }
    println!("{written} of 400 programs without a remark");
    assert!(written > 80, "{written}");
}
