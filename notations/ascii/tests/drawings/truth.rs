//! What a drawing becomes, and what that does.

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Outcome, Source, convert, remarks};
use ladder_notation_ascii::Ascii;
use ladder_simulator::Simulation;
use ladder_syntax::parse;

pub(crate) fn converted(drawing: &str) -> Converted {
    let source = Source::alone("test", drawing.as_bytes());
    convert(&Ascii, &source, &Options::default()).expect("it is read")
}

/// The ladder text with what there is to say about it, and what is found in it.
pub(crate) fn read(drawing: &str) -> String {
    let source = Source::alone("test", drawing.as_bytes());
    let converted = match convert(&Ascii, &source, &Options::default()) {
        Ok(converted) => converted,
        Err(error) => return format!("{error}\n"),
    };
    let mut out = converted.written.text.clone();
    for remark in remarks(&converted.report, &converted.findings) {
        out.push_str(&format!(
            "{} {} {}: {}\n",
            remark.place, remark.outcome, remark.element, remark.reason
        ));
    }
    for found in analyze(&parse(&out_of(&converted)).into(), "test").errors() {
        let place = converted.place_of(found.range.start());
        out.push_str(&format!("{place} {}: {}\n", found.rule, found.message));
    }
    out
}

fn out_of(converted: &Converted) -> String {
    converted.written.text.clone()
}

/// Checks a drawing: nothing in it is left unread, and one scan from any values of some tags on makes of an output what `expected`
/// says of them.
#[track_caller]
pub(crate) fn check(drawing: &str, output: &str, tags: &[&str], expected: impl Fn(&[bool]) -> bool) {
    assert!(
        Ascii.recognises(drawing.as_bytes()),
        "it is not recognised:\n{drawing}"
    );
    let converted = converted(drawing);
    let unread = |outcome: &Outcome| matches!(outcome, Outcome::Refused(_));
    let unread: Vec<_> = converted
        .report
        .entries
        .iter()
        .filter(|entry| unread(&entry.outcome))
        .collect();
    assert!(unread.is_empty(), "{drawing}{unread:#?}");
    assert_runs(&converted.written.text, output, tags, expected);
}

#[track_caller]
pub(crate) fn assert_runs(text: &str, output: &str, tags: &[&str], expected: impl Fn(&[bool]) -> bool) {
    let analysis = analyze(&parse(text).into(), "test");
    let program = analysis.program().cloned();
    let program = program.unwrap_or_else(|| panic!("{text}{:#?}", analysis.errors().collect::<Vec<_>>()));
    for row in 0..1_u32 << tags.len() {
        let values: Vec<bool> = (0..tags.len()).map(|tag| row >> tag & 1 == 1).collect();
        let mut simulation =
            Simulation::new(program.clone(), ladder_simulator::Options::default()).expect("it compiles");
        for (tag, value) in tags.iter().zip(&values) {
            let point = simulation
                .resolve(tag)
                .unwrap_or_else(|_| panic!("{tag} in\n{text}"));
            simulation.set(&point, Value::Bool(*value)).expect("it is a BOOL");
        }
        simulation.scan();
        let point = simulation
            .resolve(output)
            .unwrap_or_else(|_| panic!("{output} in\n{text}"));
        let found = simulation.value(&point) == Value::Bool(true);
        assert_eq!(
            found,
            expected(&values),
            "{output} of {tags:?} = {values:?} in\n{text}"
        );
    }
}
