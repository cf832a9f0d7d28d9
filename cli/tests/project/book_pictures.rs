//! The pictures of programs in the book are what `ladder render` draws. `UPDATE_EXPECT=1 cargo test -p ladder-cli`
//! draws them again; look at them before you keep them.

use expect_test::expect_file;
use ladder_tests::project;
use std::process::Command;

fn rendered(example: &str, arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .current_dir(project::root().join("examples"))
        .args(["render", example])
        .args(arguments)
        .output()
        .expect("the program starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{example}: {said}");
    String::from_utf8(output.stdout).expect("a picture is UTF-8")
}

#[test]
fn the_motor_at_rest_and_running() {
    let pictures = project::root().join("docs/src/guide/pictures");
    expect_file![pictures.join("motor.svg")].assert_eq(&rendered("motor.clad", &[]));
    let running = rendered("motor.clad", &["--scans", "200", "--set", "start=1"]);
    expect_file![pictures.join("running.svg")].assert_eq(&running);
}
