//! The programs in `examples/` hold no errors, are in the canonical layout, and do what their traces say.
//!
//! Beside `NAME.clad` are `NAME.in.csv`, what the plant does; `NAME.args`, how it is run; and `NAME.expected.csv`,
//! what comes of it. `UPDATE_EXPECT=1 cargo test -p ladder-cli` writes the last; read it before you believe it. A model of
//! the machine, `NAME_plant.clad`, has no trace: it runs beside its program in the scenarios of `NAME_plant.ladder-test`.

use expect_test::expect_file;
use ladder_analysis::analyze;
use ladder_format::{Options, format_text};
use ladder_syntax::parse;
use ladder_tests::project;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

fn examples() -> Vec<PathBuf> {
    let examples = project::files(&project::root().join("examples"), "clad");
    assert!(examples.len() >= 3, "only {} examples were found", examples.len());
    examples
}

#[test]
fn nothing_is_found_in_them() {
    for example in examples() {
        let parse = Arc::new(parse(&project::read(&example)));
        let findings = analyze(&parse, "example").diagnostics().to_vec();
        assert!(findings.is_empty(), "{}: {findings:#?}", example.display());
    }
}

#[test]
fn they_stand_in_the_canonical_layout() {
    for example in examples() {
        let text = project::read(&example);
        assert_eq!(
            format_text(&text, &Options::default()),
            text,
            "{}",
            example.display()
        );
    }
}

#[test]
fn they_run_as_their_traces_say() {
    for example in examples() {
        if example.to_string_lossy().ends_with("_plant.clad") {
            continue;
        }
        let trace = run(&example);
        expect_file![example.with_extension("expected.csv")].assert_eq(&trace);
    }
}

fn run(example: &Path) -> String {
    let arguments = project::read(&example.with_extension("args"));
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .arg("sim")
        .arg(example)
        .arg("--inputs")
        .arg(example.with_extension("in.csv"))
        .args(arguments.split_whitespace())
        .output()
        .expect("the program starts");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && told.is_empty(),
        "{}: {told}",
        example.display()
    );
    String::from_utf8(output.stdout).expect("a table is UTF-8")
}
