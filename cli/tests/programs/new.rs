//! `ladder new`

use crate::harness::Folder;
use expect_test::expect;

#[test]
fn what_it_makes_passes_as_it_is() {
    let folder = Folder::with(&[]);
    let run = folder.ladder(&["new", "lines/press-2"]);
    expect![[r#"
        exit status 0
        -- stderr
        made lines/press-2: a program, press-2.clad, its scenarios and what checks them. In that folder

          ladder test .
          ladder prove .
          ladder sim press-2.clad

        run the scenarios, decide what must hold in every run, and run the program live on this terminal.
    "#]]
    .assert_eq(&run.to_string());
    let checked = folder.ladder(&["check", "--deny", "warnings", "lines"]);
    assert_eq!(
        checked.to_string(),
        "exit status 0\n-- stdout\nChecked 1 file: no errors found.\n"
    );
    assert_eq!(folder.ladder(&["fmt", "--check", "lines"]).status, Some(0));
    // A folder is searched for programs; the hooks name scenarios, too.
    let scenarios = "lines/press-2/press-2.ladder-test";
    assert_eq!(folder.ladder(&["fmt", "--check", scenarios]).status, Some(0));
    let tested = folder.ladder(&["test", "--coverage", "lines"]);
    assert!(
        tested.stdout.contains("3 scenarios in 1 file: 3 passed"),
        "{tested}"
    );
    assert!(!tested.stdout.contains("never"), "{tested}");
    let proved = folder.ladder(&["prove", "lines"]);
    assert!(proved.stdout.contains(": 2 proved, in "), "{proved}");
    let wanted = concat!("ladder-logic==", env!("CARGO_PKG_VERSION"));
    for (file, times) in [
        (".github/workflows/ladder.yml", 1),
        (".pre-commit-config.yaml", 3),
    ] {
        let text = folder.read(&format!("lines/press-2/{file}"));
        assert_eq!(text.matches(wanted).count(), times, "{file}:\n{text}");
    }
    for file in [
        ".github/workflows/ladder.yml",
        ".pre-commit-config.yaml",
        ".vscode/settings.json",
        "README.md",
    ] {
        for word in ["NAME", "VERSION", "OWNER"] {
            assert!(
                !folder.read(&format!("lines/press-2/{file}")).contains(word),
                "{file} has {word}"
            );
        }
    }
}

/// Other files may be there, and stay; a repository that holds a licence is a place to begin in.
#[test]
fn nothing_is_replaced() {
    let folder = Folder::with(&[("press/LICENSE", "mine"), ("full/README.md", "mine")]);
    assert_eq!(folder.ladder(&["new", "press"]).status, Some(0));
    assert_eq!(folder.read("press/LICENSE"), "mine");
    for name in ["press", "full"] {
        let run = folder.ladder(&["new", name]);
        assert_eq!(run.status, Some(2), "{name}");
        assert!(run.stderr.contains("there already"), "{run}");
    }
    assert_eq!(folder.read("full/README.md"), "mine");
    assert!(!folder.path("full/full.clad").exists());
}

#[cfg(unix)]
#[test]
fn a_link_does_not_carry_files_elsewhere() {
    let folder = Folder::with(&[("elsewhere/kept", ""), ("press/kept", "")]);
    std::os::unix::fs::symlink(folder.path("elsewhere"), folder.path("press/.github")).unwrap();
    let run = folder.ladder(&["new", "press"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: press/.github: this is no folder of its own; nothing was made
    "#]]
    .assert_eq(&run.to_string());
    assert!(!folder.path("press/press.clad").exists() && !folder.path("elsewhere/workflows").exists());
}

#[test]
fn a_name_that_means_something_elsewhere_is_refused() {
    let folder = Folder::with(&[]);
    for name in ["a b", "x\"y", "$(id)", "a.b"] {
        let run = folder.ladder(&["new", "--", name]);
        assert_eq!(run.status, Some(2), "{name}: {run}");
    }
    assert!(folder.names().is_empty());
}
