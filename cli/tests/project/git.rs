//! The recipes for git (docs/src/guide/git.md), in real repositories: the settings are taken from the page.

use ladder_tests::{markdown, project};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

/// A repository whose git knows the recipes.
struct Repository {
    folder: tempfile::TempDir,
    /// A folder with `ladder` and `ldfmt`.
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
                    repository.shell(&fence.text);
                    settings += fence.text.lines().count();
                }
                _ => {}
            }
        }
        assert_eq!(settings, 2, "the settings of the page");
        repository
    }

    fn without_recipes() -> Repository {
        let repository = Repository {
            folder: tempfile::tempdir().expect("a temporary folder"),
            programs: tempfile::tempdir().expect("a temporary folder"),
        };
        let programs = [
            ("ladder", env!("CARGO_BIN_EXE_ladder")),
            ("ldfmt", env!("CARGO_BIN_EXE_ldfmt")),
        ];
        for (name, program) in programs {
            symlink(program, repository.programs.path().join(name)).expect("a link to the program");
        }
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
        let told = [output.stdout, output.stderr].concat();
        (
            String::from_utf8_lossy(&told).into_owned(),
            output.status.success(),
        )
    }

    #[track_caller]
    fn shell(&self, commands: &str) -> String {
        let (told, success) = self.run(commands);
        assert!(success, "{commands}\n{told}");
        told
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

/// The base with a long rung.
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
}

#[test]
fn the_same_network_is_a_conflict() {
    let repository = Repository::new();
    repository.commit(BASE);
    repository.shell("git checkout -qb other");
    repository.commit(&BASE.replace("( )( fan )", "(S)( fan )"));
    repository.shell("git checkout -q main");
    repository.commit(&with_long_fan());
    let (told, merged) = repository.run("git merge -q -m merged other");
    assert!(!merged, "{told}");
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
            "-+--[ ]( hot )------------------------------------------------------( )( fan )--+",
            "++--[ ]( hot_in_the_hall )--[ ]( released_by_the_panel )--[/]( fire_alarm )-------------( )( fan )--+",
        ]
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
    let (told, committed) = repository.run("git add -A && git commit -qm x");
    assert!(!committed, "{told}");
    assert!(told.contains("would change: p.clad"), "{told}");
    repository.shell("ldfmt p.clad && git add -A && git commit -qm x");
    repository.write("ladder.toml", "[workspace]\nexclude = [\"q.clad\"]\n");
    repository.write("q.clad", "+-[ ](a)-( )(y)-+\n");
    repository.shell("git add -A && git commit -qm x");
}

/// A name that begins with a dash is the name of a file.
#[test]
fn a_file_that_is_named_like_an_option() {
    let repository = Repository::new();
    for name in ["--check.clad", "-p.clad"] {
        repository.write(name, BASE);
    }
    repository.shell("ldfmt . && git add -A && git commit -qm x && git checkout -qb lamp");
    repository.write("--check.clad", &with_other_lamp());
    repository.shell("ldfmt . && git commit -qam x && git checkout -q main");
    repository.write("--check.clad", &with_long_fan());
    repository.shell("ldfmt . && git commit -qam x && git merge -q -m merged lamp");
    assert!(repository.read("--check.clad").contains("[/]( pump )"));

    let page = project::read(&project::root().join("docs/src/guide/git.md"));
    let fences = markdown::read(&page).fences;
    let hook = fences.iter().find(|fence| fence.text.starts_with("#!/bin/sh"));
    repository.write("-p.clad", "+-[ ](a)-( )(y)-+\n");
    let (told, success) = repository.run(&format!("git add -A && {}", hook.expect("a hook").text));
    assert!(!success && told.contains("would change: -p.clad"), "{told}");

    // pre-commit puts the arguments of a hook between its entry and the names.
    let hooks = project::read(&project::root().join(".pre-commit-hooks.yaml"));
    for hook in hooks.split("- id: ").skip(1) {
        let takes_names = !hook.contains("pass_filenames: false");
        let arguments = if takes_names {
            "  args: [--]\n"
        } else {
            "  args: [.]\n"
        };
        assert!(hook.contains(arguments), "{hook}");
    }
}

/// What pre-commit runs for a hook that takes the program on the `PATH`.
fn hook(id: &str) -> String {
    let hooks = project::read(&project::root().join(".pre-commit-hooks.yaml"));
    let found = hooks.split("- id: ").find(|hook| hook.lines().next() == Some(id));
    let hook = found.unwrap_or_else(|| panic!("no hook {id}"));
    let value = |key: &str| {
        let line = hook.lines().find_map(|line| line.trim().strip_prefix(key));
        line.unwrap_or_else(|| panic!("{id} has no {key}"))
            .trim()
            .to_owned()
    };
    let arguments = value("args:").replace(['[', ']', ','], " ");
    format!("{} {}", value("entry:"), arguments.trim())
}

#[test]
fn the_hooks_check_and_test() {
    let repository = Repository::without_recipes();
    repository.write("p.clad", "+--[ ]( start )--( )( run )--+\n");
    repository.write(
        "p.ladder-test",
        "program p.clad\nstep 10ms\n\nscenario \"s\"\nstart  _-\nrun => _-\n",
    );
    repository.shell(&hook("ladder-check-installed"));
    repository.shell(&hook("ladder-test-installed"));
    repository.write("p.clad", "+--[/]( start )--( )( run )--+\n");
    let (told, success) = repository.run(&hook("ladder-test-installed"));
    assert!(!success && told.contains("1 failed"), "{told}");
    repository.write("q.clad", "+--<JMP>( nowhere )--+\n");
    let (told, success) = repository.run(&hook("ladder-check-installed"));
    assert!(!success && told.contains("error[unknown-label]"), "{told}");
    // The hooks that install the program run the same.
    for id in ["ldfmt", "ladder-check", "ladder-test"] {
        assert_eq!(hook(id), hook(&format!("{id}-installed")));
    }
}

/// What the action does with its input, without downloading the program first.
#[test]
fn the_action_hands_on_its_arguments_as_they_are() {
    let action = project::read(&project::root().join("action.yml"));
    let (_, script) = action.rsplit_once("run: |\n").expect("a script");
    let script = script.replace("\n        ", "\n");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = folder.path().join("ladder/bin/ladder");
    std::fs::create_dir_all(program.parent().expect("a folder")).expect("a folder");
    std::fs::write(&program, "#!/bin/sh\nfor it; do printf '<%s>\\n' \"$it\"; done\n").expect("a program");
    let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    std::fs::set_permissions(&program, mode).expect("a program that runs");
    let run = |command: &str, arguments: &str| {
        let output = Command::new("bash")
            .args(["-euc", script.trim()])
            .current_dir(folder.path())
            .env("RUNNER_TEMP", folder.path())
            .env("LADDER_COMMAND", command)
            .env("LADDER_ARGS", arguments)
            .output()
            .expect("bash runs");
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        (told, output.status.code())
    };
    let hands_on = |command: &str, arguments: &str| {
        let (told, status) = run(command, arguments);
        assert_eq!(status, Some(0), "{told}");
        told
    };
    assert_eq!(
        hands_on("fmt", "--check\n--\n.\n"),
        "<fmt>\n<--check>\n<-->\n<.>\n"
    );
    assert_eq!(
        hands_on("fmt", "--check\n\ntwo words.clad\n*\n$(touch made); `touch made`"),
        "<fmt>\n<--check>\n<two words.clad>\n<*>\n<$(touch made); `touch made`>\n"
    );
    assert_eq!(hands_on("fmt", ""), "<fmt>\n<--check>\n<--diff>\n<-->\n<.>\n");
    assert_eq!(
        hands_on("check", "\n"),
        "<check>\n<--format>\n<github>\n<-->\n<.>\n"
    );
    assert_eq!(
        hands_on("test", "--filter\nstop\n.\n"),
        "<test>\n<--filter>\n<stop>\n<.>\n"
    );
    assert_eq!(run("sim; touch made", "").1, Some(2));
    assert!(!folder.path().join("made").exists());
}
