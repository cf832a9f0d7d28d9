//! What `--help` says, and what bad arguments are answered with.

use crate::harness::Folder;
use expect_test::expect_file;

/// Every command of `ladder`.
const COMMANDS: [&str; 18] = [
    "new",
    "check",
    "fmt",
    "sim",
    "run",
    "test",
    "render",
    "diff",
    "merge",
    "git",
    "explain",
    "lsp",
    "mcp",
    "tags",
    "why",
    "tree",
    "completions",
    "man",
];

/// One file with every help text, so that a change of one is seen.
#[test]
fn help_texts() {
    let folder = Folder::with(&[]);
    let mut pages = String::new();
    for command in [""].into_iter().chain(COMMANDS) {
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

/// Every way to ask for help gives the same text, and the short one names the same things.
#[test]
fn help_in_all_its_forms() {
    let folder = Folder::with(&[]);
    for command in COMMANDS {
        let long = folder.ladder(&[command, "--help"]);
        assert_eq!(
            folder.ladder(&["help", command]).to_string(),
            long.to_string(),
            "{command}"
        );
        let short = folder.ladder(&[command, "-h"]);
        assert_eq!(short.status, Some(0), "{command}");
        let words = |text: &str| -> Vec<String> {
            let flags = text
                .split([' ', ',', '\n', '[', ']', '.'])
                .filter(|word| word.starts_with("--"));
            let mut flags: Vec<String> = flags.map(str::to_owned).collect();
            flags.sort();
            flags.dedup();
            flags
        };
        let below =
            |text: &str| text[text.find("Examples:").unwrap_or_else(|| panic!("{command}"))..].to_owned();
        assert_eq!(below(&short.stdout), below(&long.stdout), "{command}");
        let options =
            |text: &str| words(&text[text.find("Options:").unwrap()..text.find("Examples:").unwrap()]);
        for option in options(&short.stdout) {
            assert!(options(&long.stdout).contains(&option), "{command} {option}");
        }
        assert!(short.stdout.contains("Exit status:"), "{command}");
    }
    assert_eq!(
        folder.ladder(&["help"]).to_string(),
        folder.ladder(&["--help"]).to_string()
    );
}

/// Examples that are broken over lines cannot be read.
#[test]
fn examples_fit_on_a_terminal() {
    let folder = Folder::with(&[]);
    for command in COMMANDS {
        let run = folder.run(
            env!("CARGO_BIN_EXE_ladder"),
            &[command, "-h"],
            b"",
            &[("COLUMNS", "500")],
        );
        let (_, examples) = run.stdout.split_once("Examples:\n").unwrap();
        for line in examples.lines().take_while(|line| !line.is_empty()) {
            assert!(line.chars().count() <= 80, "{line}");
        }
    }
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
        &["help", "chekc"],
        &["completions"],
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
    assert_eq!(folder.ladder(&["-V"]).stdout, format!("ladder {version}\n"));
    assert_eq!(folder.ldfmt(&["-V"]).stdout, format!("ldfmt {version}\n"));
    // The commit is not known everywhere: a copy of the source may come without git.
    let built_from = env!("LADDER_BUILT_FROM");
    let target = built_from.split(", ").last().expect("a target");
    assert!(target.contains(std::env::consts::ARCH), "{target}");
    let whole = format!("ladder {version} ({built_from})\n");
    assert_eq!(folder.ladder(&["--version"]).stdout, whole);
    assert_eq!(
        folder.ldfmt(&["--version"]).stdout,
        whole.replace("ladder", "ldfmt")
    );
}
