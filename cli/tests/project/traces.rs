//! The timing diagram in the book is what the program draws.
//!
//! `UPDATE_EXPECT=1 cargo test -p ladder-cli` draws it again; look at it before you believe it.

use expect_test::expect_file;
use ladder_tests::{book, project};
use std::process::Command;

#[test]
fn the_timing_diagram_of_the_book() {
    let examples = project::root().join("examples");
    let arguments = project::read(&examples.join("motor.args"));
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .current_dir(examples)
        .args(["sim", "motor.clad", "--inputs", "motor.in.csv", "--format", "svg"])
        .args(arguments.split_whitespace())
        .output()
        .expect("the program starts");
    assert!(output.status.success() && output.stderr.is_empty());
    let picture = String::from_utf8(output.stdout).expect("a picture is UTF-8");
    expect_file![book::source().join("guide/traces/motor.svg")].assert_eq(&picture);
}
