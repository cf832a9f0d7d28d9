//! `ladder render`

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

#[test]
fn svg_goes_to_stdout_unless_a_file_is_named() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad"]);
    assert_eq!(run.status, Some(0));
    assert!(run.stdout.starts_with("<svg "), "{}", run.stdout);
    let into_file = folder.ladder(&["render", "motor.clad", "-o", "motor.svg"]);
    expect![[r#"
        exit status 0
    "#]]
    .assert_eq(&into_file.to_string());
    assert_eq!(folder.read("motor.svg"), run.stdout);
}

#[test]
fn png_is_made_of_pixels() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad", "-o", "motor.PNG", "--scale", "0.5"]);
    assert_eq!(run.status, Some(0), "{run}");
    let bytes = std::fs::read(folder.path("motor.PNG")).unwrap();
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn a_run_shows_power_and_values() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad", "--scans", "3", "--set", "start=1"]);
    assert!(run.stdout.contains(r#"class="live""#), "{run}");
    let at_rest = folder.ladder(&["render", "motor.clad"]);
    assert!(!at_rest.stdout.contains(r#"class="live""#));
}

#[test]
fn a_name_that_says_no_kind_of_picture() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    expect![[r#"
        exit status 2
        -- stderr
        error: motor.jpg: the name does not say which picture it is; end it in .svg or .png, or add --format
    "#]]
    .assert_eq(
        &folder
            .ladder(&["render", "motor.clad", "-o", "motor.jpg"])
            .to_string(),
    );
}

#[test]
fn a_program_with_errors_is_drawn_but_not_run() {
    let folder = Folder::with(&[("wrong.clad", "+--[ ]( a --( )( b )--+\n")]);
    let drawn = folder.ladder(&["render", "wrong.clad"]);
    assert_eq!(drawn.status, Some(0));
    assert!(drawn.stdout.contains("+--[ ]( a --( )( b )--+"), "{drawn}");
    let run = folder.ladder(&["render", "wrong.clad", "--scans", "1"]);
    assert_eq!(run.status, Some(1), "{run}");
    assert!(run.stdout.is_empty());
}

#[test]
fn a_picture_that_no_machine_could_hold_is_refused() {
    let text = "+--[ ]( a )--( )( b )--+\n\n".repeat(1000);
    let folder = Folder::with(&[("long.clad", &text)]);
    let run = folder.ladder(&["render", "long.clad", "-o", "long.png"]);
    assert_eq!(run.status, Some(2), "{run}");
    assert!(run.stderr.contains("make it smaller with --scale"), "{run}");
}
