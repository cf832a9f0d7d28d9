//! The recipes for git (docs/src/guide/git.md), in real repositories: the settings are taken from the page.

use ladder_tests::{markdown, project};
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A repository whose git knows the recipes.
struct Repository {
    folder: tempfile::TempDir,
    /// A folder with `ldfmt`.
    programs: tempfile::TempDir,
}

impl Repository {
    fn new() -> Repository {
        let repository = Repository::without_recipes();
        let page = project::read(&project::root().join("docs/src/guide/git.md"));
        let mut settings = 0;
        for fence in markdown::read(&page).fences {
            match fence.language() {
                Some("gitattributes") => repository.write(".gitattributes", &fence.text),
                Some("sh") if fence.text.starts_with("git config") => {
                    let place = project::root().display().to_string();
                    repository.shell(&fence.text.replace("/path/to/ladder", &place));
                    settings += fence.text.lines().count();
                }
                _ => {}
            }
        }
        assert_eq!(settings, 5, "the settings of the page");
        repository
    }

    fn without_recipes() -> Repository {
        let repository = Repository {
            folder: tempfile::tempdir().expect("a temporary folder"),
            programs: tempfile::tempdir().expect("a temporary folder"),
        };
        let program = PathBuf::from(env!("CARGO_BIN_EXE_ladder-under-test"));
        symlink(program, repository.programs.path().join("ldfmt")).expect("a link to the program");
        repository
            .shell("git init -q -b main . && git config user.name t && git config user.email t@example.com");
        repository
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.folder.path().join(name), text).expect("a file in the repository");
    }

    fn read(&self, name: &str) -> String {
        project::read(&self.folder.path().join(name))
    }

    /// Runs commands; what they print, and whether they succeed.
    fn run(&self, commands: &str) -> (String, bool) {
        let path = std::env::var("PATH").unwrap_or_default();
        let output = Command::new("sh")
            .args(["-c", commands])
            .current_dir(self.folder.path())
            .env("PATH", format!("{}:{path}", self.programs.path().display()))
            .env("GIT_CONFIG_GLOBAL", "/dev/null")
            .env("GIT_CONFIG_SYSTEM", "/dev/null")
            .output()
            .expect("sh runs");
        let said = [output.stdout, output.stderr].concat();
        (
            String::from_utf8_lossy(&said).into_owned(),
            output.status.success(),
        )
    }

    #[track_caller]
    fn shell(&self, commands: &str) -> String {
        let (said, success) = self.run(commands);
        assert!(success, "{commands}\n{said}");
        said
    }

    /// Writes the program, aligned, and commits it.
    fn commit(&self, program: &str) {
        self.write("p.clad", program);
        self.shell("ldfmt p.clad && git add -A && git commit -qm x");
    }
}

const BASE: &str = "\
# the pump #
+--[ ]( start )--[/]( stop )--( )( pump )--+

# the fan #
+--[ ]( hot )--( )( fan )--+

# the lamp #
+--[ ]( pump )--( )( lamp )--+
";

/// The base with a rung that moves the rail.
fn with_long_fan() -> String {
    BASE.replace(
        "[ ]( hot )",
        "[ ]( hot_in_the_hall )--[ ]( released_by_the_panel )--[/]( fire_alarm )",
    )
}

fn with_other_lamp() -> String {
    BASE.replace("[ ]( pump )", "[/]( pump )")
}

/// `main` has a long rung, the branch `lamp` another contact.
fn branches(repository: &Repository) {
    repository.commit(BASE);
    repository.shell("git checkout -qb lamp");
    repository.commit(&with_other_lamp());
    repository.shell("git checkout -q main");
    repository.commit(&with_long_fan());
}

#[test]
fn different_networks_merge() {
    let repository = Repository::new();
    branches(&repository);
    repository.shell("git merge -q -m merged lamp");
    let merged = repository.read("p.clad");
    repository.write(
        "expected.clad",
        &with_long_fan().replace("[ ]( pump )", "[/]( pump )"),
    );
    repository.shell("ldfmt expected.clad");
    assert_eq!(merged, repository.read("expected.clad"));
    assert!(
        merged.lines().any(|line| line.len() > 60),
        "the rail has moved\n{merged}"
    );
}

#[test]
fn without_the_driver_they_do_not() {
    let repository = Repository::without_recipes();
    branches(&repository);
    let (said, merged) = repository.run("git merge -q -m merged lamp");
    assert!(!merged, "{said}");
}

#[test]
fn the_same_network_is_a_conflict() {
    let repository = Repository::new();
    repository.commit(BASE);
    repository.shell("git checkout -qb other");
    repository.commit(&BASE.replace("( )( fan )", "(S)( fan )"));
    repository.shell("git checkout -q main");
    repository.commit(&with_long_fan());
    let (said, merged) = repository.run("git merge -q -m merged other");
    assert!(!merged, "{said}");
    let text = repository.read("p.clad");
    assert_eq!(text.matches("<<<<<<<").count(), 1, "{text}");
    assert!(
        text.contains("(S)( fan )") && text.contains("fire_alarm"),
        "{text}"
    );
    // Nothing but the conflict is in question.
    assert_eq!(text.matches("( )( lamp )").count(), 1, "{text}");
    assert_eq!(text.matches("( )( pump )").count(), 1, "{text}");
}

#[test]
fn a_difference_shows_the_rung_that_changed() {
    let repository = Repository::new();
    repository.commit(BASE);
    repository.commit(&with_long_fan());
    let shown = repository.shell("git diff -U0 HEAD~1");
    let changed: Vec<&str> = shown
        .lines()
        .filter(|line| {
            line.starts_with(['+', '-', '@']) && !line.starts_with("+++") && !line.starts_with("---")
        })
        .collect();
    assert_eq!(
        changed,
        [
            "@@ -5 +5 @@ # the fan #",
            "-+--[ ]( hot )--( )( fan )--+",
            "++--[ ]( hot_in_the_hall )--[ ]( released_by_the_panel )--[/]( fire_alarm )--( )( fan )--+",
        ]
    );
    // As the lines are, all have changed.
    let lines = repository.shell("git diff -U0 --no-textconv HEAD~1");
    assert_eq!(
        lines.lines().filter(|line| line.starts_with("-+--")).count(),
        3,
        "{lines}"
    );
    let words = repository.shell("git diff --word-diff=porcelain HEAD~1");
    assert!(words.contains("hot_in_the_hall"), "{words}");
}

/// What the hooks and the action run is what the programs take.
#[test]
fn the_hook_of_the_page_refuses_what_is_not_aligned() {
    let repository = Repository::new();
    let page = project::read(&project::root().join("docs/src/guide/git.md"));
    let fences = markdown::read(&page).fences;
    let hook = fences
        .iter()
        .find(|fence| fence.text.starts_with("#!/bin/sh"))
        .expect("a hook");
    let place: &Path = &repository.folder.path().join(".git/hooks/pre-commit");
    std::fs::write(place, &hook.text).expect("the hook is written");
    repository.shell("chmod +x .git/hooks/pre-commit");
    repository.write("p.clad", "+-[ ](a)-( )(y)-+\n");
    let (said, committed) = repository.run("git add -A && git commit -qm x");
    assert!(!committed, "{said}");
    assert!(said.contains("would change: p.clad"), "{said}");
    repository.shell("ldfmt p.clad && git add -A && git commit -qm x");
    repository.write("ladder.toml", "[workspace]\nexclude = [\"q.clad\"]\n");
    repository.write("q.clad", "+-[ ](a)-( )(y)-+\n");
    repository.shell("git add -A && git commit -qm x");
}
