//! What `--help` says, and what bad arguments are answered with.

use crate::harness::Folder;
use expect_test::expect_file;

/// One file with every help text, so that a change of one is seen.
#[test]
fn help_texts() {
    let folder = Folder::with(&[]);
    let mut pages = String::new();
    for command in [
        "", "check", "fmt", "sim", "test", "render", "explain", "lsp", "tree",
    ] {
        let arguments: Vec<&str> = [command, "--help"]
            .into_iter()
            .filter(|a| !a.is_empty())
            .collect();
        let run = folder.ladder(&arguments);
        assert_eq!(run.status, Some(0));
        pages.push_str(&format!("$ ladder {}\n{}\n", arguments.join(" "), run.stdout));
    }
    pages.push_str(&format!("$ ldfmt --help\n{}", folder.ldfmt(&["--help"]).stdout));
    expect_file!["help.txt"].assert_eq(&pages);
}

#[test]
fn bad_arguments_exit_with_2() {
    let folder = Folder::with(&[]);
    for arguments in [
        &[][..],
        &["check"],
        &["chekc", "a.clad"],
        &["check", "--deny", "nothing", "a.clad"],
        &["check", "--format", "xml", "a.clad"],
        &["fmt"],
        &["fmt", "--range", "3", "a.clad"],
        &["sim", "a.clad", "--scans", "many"],
        &["explain"],
    ] {
        let run = folder.ladder(arguments);
        assert_eq!(run.status, Some(2), "{arguments:?}");
        assert_eq!(run.stdout, "", "{arguments:?}");
        assert_ne!(run.stderr, "", "{arguments:?}");
    }
}

#[test]
fn versions() {
    let folder = Folder::with(&[]);
    let version = env!("CARGO_PKG_VERSION");
    assert_eq!(
        folder.ladder(&["--version"]).stdout,
        format!("ladder {version}\n")
    );
    assert_eq!(folder.ldfmt(&["--version"]).stdout, format!("ldfmt {version}\n"));
}
