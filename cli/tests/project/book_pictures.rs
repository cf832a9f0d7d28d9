//! The pictures of programs in the book are what `ladder render` draws. `UPDATE_EXPECT=1 cargo test -p ladder-cli`
//! draws them again; look at them before you keep them.

use expect_test::expect_file;
use ladder_tests::{book, markdown, project};
use std::path::Path;
use std::process::Command;

fn rendered(example: &str, arguments: &[&str]) -> String {
    rendered_in(&project::root().join("examples"), example, arguments)
}

fn rendered_in(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .current_dir(folder)
        .args(["render", program])
        .args(arguments)
        .output()
        .expect("the program starts");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && told.is_empty(), "{program}: {told}");
    String::from_utf8(output.stdout).expect("a picture is UTF-8")
}

#[test]
fn the_motor_at_rest_and_running() {
    let pictures = project::root().join("docs/src/guide/pictures");
    expect_file![pictures.join("motor.svg")].assert_eq(&rendered("motor.clad", &[]));
    let running = rendered("motor.clad", &["--scans", "200", "--set", "start=1"]);
    expect_file![pictures.join("running.svg")].assert_eq(&running);
}

/// The program of a chapter, as it is when its pumps are an array.
#[test]
fn the_pumps_of_a_chapter() {
    let chapter = project::read(&book::source().join("guide/data.md"));
    let fences = markdown::read(&chapter).fences;
    let program = fences
        .iter()
        .find(|fence| fence.words.iter().any(|word| word == "file=arrays.clad"))
        .expect("the chapter has the program");
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("arrays.clad"), &program.text)
        .expect("a program in the temporary folder");
    let picture = book::source().join("guide/pictures/pumps.svg");
    expect_file![picture].assert_eq(&rendered_in(folder.path(), "arrays.clad", &[]));
}
