//! Formatting changes no finding but those about looks, and no program.

#[path = "../../../format/tests/properties/programs.rs"]
mod programs;

use ladder_analysis::{Rule, analyze};
use ladder_format::{Options, format_text};
use ladder_syntax::parse;
use ladder_tests::project;
use proptest::prelude::*;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// The findings of a text, without those that formatting takes away. Their places move. Where a `|` cuts a wire,
/// formatting gives each half at least some of it, and what is reported about the dead half depends on that.
fn findings(text: &str) -> Vec<(Rule, String)> {
    let analysis = analyze(&Arc::new(parse(text)), "main");
    let cut = analysis
        .diagnostics()
        .iter()
        .any(|d| d.rule.name() == "misplaced-rail");
    let mut findings: Vec<_> = analysis
        .diagnostics()
        .iter()
        .filter(|d| !matches!(d.rule.name(), "missing-wire" | "misleading-alignment"))
        .filter(|d| !(cut && d.rule.name() == "open-wire"))
        // A message may name a line, and lines come and go.
        .map(|d| (d.rule, d.message.replace(|c: char| c.is_ascii_digit(), "")))
        .collect();
    findings.sort();
    findings
}

fn program() -> impl Strategy<Value = String> {
    prop::collection::vec(any::<u8>(), 0..300)
        .prop_map(|bytes| programs::file(&mut programs::Choices::new(&bytes)))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn findings_stay(text in program()) {
        let found = findings(&text);
        // A rung that begins with two connectors looks like a comment of another language, until it is laid out.
        prop_assume!(found.iter().all(|(_, message)| !message.starts_with("`//` begins no comment")));
        // And a block right between two `|` looks like a contact of a drawing.
        prop_assume!(found.iter().all(|(_, message)| !message.starts_with("this looks like a ladder diagram")));
        let new = format_text(&text, &Options::default());
        prop_assert_eq!(found, findings(&new), "{}\n=>\n{}", text, new);
    }
}

/// What a program does, run as the files next to it say; empty if it does not run.
fn run(program: &Path, next_to: &Path) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ladder"));
    command.arg("sim").arg(program);
    let inputs = next_to.with_extension("in.csv");
    if inputs.exists() {
        command.arg("--inputs").arg(inputs);
    }
    // What has none is a machine: it runs, and nothing comes in.
    let arguments = std::fs::read_to_string(next_to.with_extension("args"));
    let arguments = arguments.unwrap_or_else(|_| "--scans 50".to_owned());
    let output = command.args(arguments.split_whitespace()).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn programs_do_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let formatted = folder.path().join("formatted.clad");
    let mut count = 0;
    for folder in ["examples", "tests/corpus/semantics"] {
        for program in project::files(&project::root().join(folder), "clad") {
            let text = format_text(&project::read(&program), &Options::default());
            std::fs::write(&formatted, text).unwrap();
            let trace = run(&program, &program);
            count += usize::from(!trace.is_empty());
            assert_eq!(run(&formatted, &program), trace, "{}", program.display());
        }
    }
    assert!(count > 20, "only {count} programs ran");
}
