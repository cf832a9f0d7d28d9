//! The guide describes every option there is, and of no other.

use ladder_tests::{book, project};
use std::collections::BTreeSet;
use std::process::Command;

const COMMANDS: [&str; 19] = [
    "check",
    "fmt",
    "sim",
    "run",
    "online",
    "tags",
    "test",
    "prove",
    "render",
    "convert",
    "diff",
    "merge",
    "git",
    "explain",
    "lsp",
    "mcp",
    "tree",
    "why",
    "completions",
];

#[test]
fn the_guide_tells_of_every_option() {
    let guide: String = project::files(&book::source().join("guide"), "md")
        .iter()
        .map(|page| project::read(page))
        .collect();
    let there: BTreeSet<String> = COMMANDS
        .into_iter()
        .flat_map(|command| options(&help(command)))
        .collect();
    let described = options(&guide);
    let missing: Vec<&String> = there.difference(&described).collect();
    assert!(missing.is_empty(), "the guide does not describe {missing:?}");
    // Other programs' options.
    let foreign = [
        "--path",
        "--headless",
        "--install-extension",
        "--cached",
        "--health",
        "--no-server",
        "--data-urlencode",
        "--diff-filter",
        "--name-only",
        "--no-textconv",
        "--word-diff",
        // Of package managers.
        "--global",
        "--package",
        "--repo",
        "--rm",
        "--save-dev",
        "--version",
        // A colour of the theme, in a scene.
        "--ladder-on",
    ]
    .map(str::to_owned);
    let wrong: Vec<&String> = described
        .difference(&there)
        .filter(|option| !foreign.contains(option))
        .collect();
    assert!(wrong.is_empty(), "there is no {wrong:?}");
}

fn help(command: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_ladder"))
        .args([command, "--help"])
        .output()
        .expect("the program starts");
    String::from_utf8(output.stdout).expect("help is UTF-8")
}

/// What begins with two dashes, after a blank or a backtick: the wires of a drawing begin with `+`.
fn options(text: &str) -> BTreeSet<String> {
    let named = |word: &str| {
        let name: String = word
            .chars()
            .take_while(|c| c.is_ascii_lowercase() || *c == '-')
            .collect();
        let is_option = name.starts_with("--") && name.len() > 3 && name.as_bytes()[2].is_ascii_lowercase();
        is_option.then_some(name)
    };
    text.split([' ', '\n', '`', '[', '(', ','])
        .filter_map(named)
        .collect()
}
