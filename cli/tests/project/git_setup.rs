//! `ladder git install`, and what git does afterwards, in real repositories.

use expect_test::expect;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A repository, and a user with settings of their own.
struct Repository {
    folder: TempDir,
    home: TempDir,
}

impl Repository {
    fn new() -> Repository {
        let repository = Repository {
            folder: tempfile::tempdir().expect("a temporary folder"),
            home: tempfile::tempdir().expect("a temporary folder"),
        };
        let programs = repository.home.path().join("bin");
        std::fs::create_dir(&programs).expect("a folder for programs");
        symlink(env!("CARGO_BIN_EXE_ladder"), programs.join("ladder")).expect("a link");
        symlink(env!("CARGO_BIN_EXE_ldfmt"), programs.join("ldfmt")).expect("a link");
        repository
            .shell("git init -q -b main . && git config user.name t && git config user.email t@example.com");
        repository
    }

    /// Runs commands without a terminal; what they print, and how they end.
    fn run(&self, commands: &str) -> (String, Option<i32>) {
        let home = self.home.path();
        let path = std::env::var("PATH").unwrap_or_default();
        let output = Command::new("sh")
            .args(["-c", commands])
            .current_dir(self.folder.path())
            .env("PATH", format!("{}:{path}", home.join("bin").display()))
            .env("HOME", home)
            .env("XDG_CONFIG_HOME", home.join("settings"))
            .env("GIT_CONFIG_GLOBAL", home.join("gitconfig"))
            .env("GIT_CONFIG_SYSTEM", "/dev/null")
            .stdin(Stdio::null())
            .output()
            .expect("sh runs");
        let told = [output.stdout, output.stderr].concat();
        (String::from_utf8_lossy(&told).into_owned(), output.status.code())
    }

    #[track_caller]
    fn shell(&self, commands: &str) -> String {
        let (told, status) = self.run(commands);
        assert_eq!(status, Some(0), "{commands}\n{told}");
        told
    }

    fn write(&self, name: &str, text: &str) {
        let file = self.folder.path().join(name);
        std::fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
        std::fs::write(file, text).expect("a file in the repository");
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.folder.path().join(name)).unwrap_or_default()
    }

    fn commit(&self, name: &str, text: &str) {
        self.write(name, text);
        self.shell("git add -A && git commit -qm x");
    }
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_default()
}

/// A program of Logix.
fn logix(rung: &str) -> String {
    format!(
        "<RSLogix5000Content><Controller Name=\"C\"><Tags><Tag Name=\"a\" TagType=\"Base\" DataType=\"BOOL\"/>\
         <Tag Name=\"x\" TagType=\"Base\" DataType=\"BOOL\"/></Tags><Programs><Program Name=\"P\" MainRoutineName=\"Main\">\
         <Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent><Rung Number=\"0\" Type=\"N\"><Text><![CDATA[{rung}]]></Text>\
         </Rung></RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>\n"
    )
}

const BASE: &str = "\
+--[ ]( a )--( )( x )--+

+--[ ]( b )--( )( y )--+
";

#[test]
fn nothing_is_written_that_nobody_said_yes_to() {
    let repository = Repository::new();
    let before = repository.read(".git/config");
    let (told, status) = repository.run("ladder git install");
    assert_eq!(status, Some(1));
    expect![[r#"
        .git/info/attributes:
          + # ladder: begin, written by `ladder git install`
          + *.clad diff=ladder merge=ladder
          + *.[rR][uU][nN][gG] diff=ladder-text
          + *.[lL]5[xX] diff=ladder-text
          + *.[lL]5[kK] diff=ladder-text
          + *.[iI][oO][tT] diff=ladder-text
          + *.[sS]7[dD][cC][lL] diff=ladder-text
          + *.[sS][cC][lL] diff=ladder-text
          + *.[tT][cC][pP][oO][uU] diff=ladder-text
          + *.[sS][tT] diff=ladder-text
          + # ladder: end
        git config --local:
          + diff.ladder.xfuncname = ^(#.*|FUNCTION_BLOCK.*|.*<(FUN|LBL)>.*)$
          + diff.ladder.wordRegex = [][()<>+/\]|[^][()<>+/\ -]+
          + diff.ladder-text.textconv = ladder git show
          + diff.ladder-text.xfuncname = ^(#.*|FUNCTION_BLOCK.*|.*<(FUN|LBL)>.*)$
          + difftool.ladder.cmd = ladder diff "$LOCAL" "$REMOTE" ${MERGED:+--among="$MERGED"}
          + merge.ladder.name = networks and declarations of ladder programs
          + merge.ladder.driver = ladder merge --path=%P %O %A %B
        note: nothing is written; `--yes` writes it
    "#]]
    .assert_eq(&told);
    assert_eq!(repository.read(".git/config"), before);
    assert!(!repository.read(".git/info/attributes").contains("clad"));
}

#[test]
fn a_repository_is_as_it_was_after_uninstall() {
    let repository = Repository::new();
    repository.write(".git/info/attributes", "*.png binary\n");
    let state = |repository: &Repository| {
        (
            repository.shell("git config --local --list"),
            repository.read(".git/info/attributes"),
        )
    };
    let before = state(&repository);
    repository.shell("ladder git install --yes");
    let installed = state(&repository);
    assert!(installed.1.starts_with("*.png binary\n") && installed.1.contains("merge=ladder"));
    assert_eq!(repository.shell("ladder git install"), "git is set up already\n");
    // A file without a last line end, settings that a person made, and no file at all.
    repository.write(".git/info/attributes", "*.png binary");
    repository.shell("git config diff.ladder.xfuncname '^X' && git config merge.ladder.name 'mine'");
    let before_that = state(&repository);
    repository.shell("ladder git install --yes && ladder git install --yes && ladder git uninstall --yes");
    assert_eq!(state(&repository), before_that);
    repository.shell("git config --unset diff.ladder.xfuncname && git config --unset merge.ladder.name");
    repository.shell("rm .git/info/attributes && ladder git install --yes && ladder git uninstall --yes");
    assert_eq!(repository.shell("ls .git/info"), "exclude\n");
    repository.write(".git/info/attributes", "*.png binary\n");
    // What a person set differently is shown, replaced by install, and kept by uninstall.
    repository.shell("ladder git uninstall --yes");
    assert_eq!(state(&repository), before);
    assert_eq!(
        repository.shell("ladder git uninstall"),
        "nothing of it is set up\n"
    );
    repository.shell("git config merge.ladder.driver false");
    repository.shell("ladder git uninstall --yes");
    assert_eq!(repository.shell("git config merge.ladder.driver"), "false\n");
    let (told, _) = repository.run("ladder git install");
    assert!(told.contains("  - merge.ladder.driver = false\n"), "{told}");
    assert_eq!(text(&repository.home.path().join("gitconfig")), "");
}

#[test]
fn for_all_repositories_of_a_user() {
    let repository = Repository::new();
    repository.shell("cd .. && ladder git install --global --yes");
    let attributes = repository.home.path().join("settings/git/attributes");
    assert!(text(&attributes).contains("*.clad diff=ladder merge=ladder\n"));
    assert!(text(&repository.home.path().join("gitconfig")).contains("ladder merge"));
    assert_eq!(repository.read(".git/info/attributes").matches("clad").count(), 0);
    repository.shell("ladder git uninstall --global --yes");
    assert!(!text(&attributes).contains("clad"));
    repository.shell("git config --global core.attributesFile '~/mine' && ladder git install --global --yes");
    assert!(text(&repository.home.path().join("mine")).contains("clad"));
}

#[test]
fn outside_of_a_repository() {
    let repository = Repository::new();
    repository.shell("rm -rf .git");
    let (told, status) = repository.run("ladder git install --yes");
    assert_eq!(status, Some(2), "{told}");
    assert!(told.contains("not a git repository"), "{told}");
}

#[test]
fn git_merges_by_network() {
    let repository = Repository::new();
    repository.shell("ladder git install --yes");
    // What git merges line by line would be a conflict: both add at the end.
    repository.commit("plant/p.clad", BASE);
    repository.shell("git checkout -qb other");
    repository.commit(
        "plant/p.clad",
        &format!("{BASE}\n+--[ ]( t )--( )( theirs )--+\n"),
    );
    repository.shell("git checkout -q main");
    repository.commit("plant/p.clad", &format!("{BASE}\n+--[ ]( o )--( )( ours )--+\n"));
    repository.shell("git merge -q -m merged other");
    let merged = repository.read("plant/p.clad");
    assert!(
        merged.contains("( ours )") && merged.contains("( theirs )"),
        "{merged}"
    );
    assert!(!merged.contains("<<<"), "{merged}");
}

#[test]
fn git_knows_of_a_conflict() {
    let repository = Repository::new();
    repository.shell("ladder git install --yes");
    repository.commit("p.clad", BASE);
    repository.shell("git checkout -qb other");
    repository.commit("p.clad", &BASE.replace("[ ]( a )", "[/]( a )"));
    repository.shell("git checkout -q main");
    repository.commit("p.clad", &BASE.replace("[ ]( a )", "[P]( a )"));
    let (told, status) = repository.run("git merge -m merged other");
    assert_eq!(status, Some(1), "{told}");
    assert!(
        told.contains("p.clad: both sides edited the network that writes x"),
        "{told}"
    );
    assert_eq!(repository.shell("git status --short"), "UU p.clad\n");
    let text = repository.read("p.clad");
    assert!(
        text.contains("# <<<<<<< ours #") && text.contains("# >>>>>>> theirs #"),
        "{text}"
    );
}

#[test]
fn git_shows_what_changed() {
    let repository = Repository::new();
    repository.shell("ladder git install --yes");
    repository.commit("p.clad", BASE);
    repository.commit("p.L5X", &logix("XIC(a)OTE(x);"));
    repository.write("p.clad", &BASE.replace("[ ]( a )", "[/]( a )"));
    let shown = repository.shell("git difftool -y -t ladder -- p.clad");
    assert!(
        shown.contains("edited, does another thing: network, line 1, writes x\n"),
        "{shown}"
    );
    assert!(shown.contains("^^^^^^^^"), "{shown}");
    assert!(!shown.contains("git-blob"), "{shown}");
    let folders = repository.shell("git difftool -d --no-symlinks -t ladder -- p.clad");
    assert!(
        folders.contains("edited, does another thing: network"),
        "{folders}"
    );
    repository.write("p.L5X", &logix("XIO(a)OTE(x);"));
    let shown = repository.shell("git diff -- p.L5X");
    assert!(shown.contains("\n++--[/]( a )--"), "{shown}");
    // One that is broken is shown as it is.
    repository.write("p.L5X", "<RSLogix5000Content>\n");
    let shown = repository.shell("git diff -- p.L5X");
    assert!(shown.contains("+<RSLogix5000Content>"), "{shown}");
}

#[test]
fn copies_that_git_makes_are_compared_among_the_files_of_the_folder() {
    let repository = Repository::new();
    repository.shell("ladder git install --yes");
    repository.commit(
        "plant/blocks.clad",
        "FUNCTION_BLOCK [$Both]\nVAR_INPUT\n    one, other : BOOL;\nEND_VAR\n+--[ ]( one )--[ ]( other )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    );
    repository.commit("plant/p.clad", "+--[$Both]( a, b )--( )( x )--+\n");
    repository.write("plant/p.clad", "+--[$Both]( b, a )--( )( x )--+\n");
    let shown = repository.shell("cd plant && git difftool -y -t ladder");
    assert!(
        shown.contains("edited, does the same: network, line 1, writes x\n"),
        "{shown}"
    );
}

#[test]
fn revisions_are_compared_from_any_folder() {
    let repository = Repository::new();
    repository.commit("plant/p.clad", BASE);
    repository.commit("plant/p.clad", &BASE.replace("[ ]( a )", "[/]( a )"));
    repository.write("plant/q.clad", BASE);
    for command in [
        "ladder diff HEAD~1:plant/p.clad HEAD:plant/p.clad",
        "ladder diff HEAD~1:plant/p.clad plant/p.clad",
        "ladder diff HEAD~1:plant HEAD:plant/",
        "ladder diff HEAD~1: HEAD:",
        "cd plant && ladder diff HEAD~1:./p.clad :plant/p.clad",
    ] {
        let (told, status) = repository.run(command);
        assert_eq!(status, Some(1), "{command}\n{told}");
        assert_eq!(
            told.matches("edited, does another thing: network, line 1")
                .count(),
            1,
            "{command}\n{told}"
        );
        assert!(!told.contains("q.clad"), "{told}");
    }
    let (told, status) = repository.run("ladder diff HEAD: .");
    assert_eq!(status, Some(1), "{told}");
    assert!(
        told.contains("+++ plant/q.clad") && !told.contains("p.clad"),
        "{told}"
    );
    for (name, message) in [
        (
            "HEAD:none.clad",
            "git knows no such revision, or no such file in it",
        ),
        (
            "none:plant/p.clad",
            "git knows no such revision, or no such file in it",
        ),
        ("--output=x:p", "is not the name of a revision"),
        ("'HEAD:a\nHEAD:b'", "is not the name of a revision"),
    ] {
        let (told, status) = repository.run(&format!("ladder diff -- {name} plant/p.clad"));
        assert_eq!(status, Some(2), "{told}");
        assert!(told.contains(message), "{told}");
    }
    assert!(!repository.folder.path().join("x").exists());
}

/// What a repository's own settings would run is not run.
#[test]
fn no_program_of_the_repository_is_run() {
    let repository = Repository::new();
    repository.commit("p.clad", BASE);
    repository.commit("p.clad", &BASE.replace("[ ]( a )", "[/]( a )"));
    repository.shell(
        "git config core.fsmonitor 'touch ran' && git config core.pager 'touch ran' && \
         git config diff.external 'touch ran' && git config filter.x.smudge 'touch ran' && \
         git config diff.x.textconv 'touch ran' && echo '*.clad filter=x diff=x' > .git/info/attributes",
    );
    let (told, status) = repository.run("ladder diff HEAD~1: HEAD:");
    assert_eq!(status, Some(1), "{told}");
    assert!(!repository.folder.path().join("ran").exists());
}

#[test]
fn programs_of_other_systems_in_a_revision() {
    let repository = Repository::new();
    repository.commit("p.L5X", &logix("XIC(a)OTE(x);"));
    let (told, status) = repository.run("ladder diff HEAD:p.L5X p.L5X");
    assert_eq!((told.as_str(), status), ("", Some(0)));
    repository.write("p.L5X", &logix("XIO(a)OTE(x);"));
    let (told, status) = repository.run("ladder diff HEAD:p.L5X p.L5X");
    assert_eq!(status, Some(1), "{told}");
    assert!(
        told.contains("edited, does another thing: routine Main of program P, rung 0"),
        "{told}"
    );
}

#[test]
fn a_program_of_a_revision_has_the_blocks_of_that_revision() {
    let repository = Repository::new();
    let block = |time: &str| {
        format!(
            "FUNCTION_BLOCK [$Lift]\nVAR_OUTPUT\n    up : BOOL;\nEND_VAR\nVAR\n    t : TON;\nEND_VAR\n\n\
             +--[ ]( EN )--[TON]( t, {time} )--( )( up )--+\nEND_FUNCTION_BLOCK\n"
        )
    };
    let user = "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR_OUTPUT\n    up : BOOL;\nEND_VAR\n\n+--[ ]( go )--[$Lift]( up )--+\n";
    repository.shell("mkdir -p plant/lib plant/lines");
    repository.write("plant/ladder.toml", "[workspace]\nlibrary = [\"lib\"]\n");
    repository.write("plant/lib/lift.clad", &block("20ms"));
    repository.commit("plant/lines/main.clad", user);
    repository.commit("plant/lib/lift.clad", &block("40ms"));
    repository.write("plant/lib/lift.clad", &block("60ms"));
    let differs = |old: &str, new: &str| {
        let (told, status) = repository.run(&format!("cd plant/lines && ladder diff {old} {new}"));
        let found = told
            .lines()
            .find(|line| line.starts_with("the programs"))
            .unwrap_or("-");
        (found.to_owned(), status)
    };
    let at = |scan: &str, time: &str| (format!("the programs differ in scan {scan}, at {time}"), Some(1));
    assert_eq!(
        differs("HEAD~:plant/lines/main.clad", "HEAD:./main.clad"),
        at("2", "20ms")
    );
    assert_eq!(differs("HEAD:./main.clad", "main.clad"), at("4", "40ms"));
    assert_eq!(differs(":./main.clad", "main.clad"), at("4", "40ms"));
    assert_eq!(differs("HEAD:", "../.."), at("4", "40ms"));
    assert_eq!(
        differs("HEAD:./main.clad", ":./main.clad"),
        ("-".to_owned(), Some(0))
    );
    repository.shell("git add -A");
    assert_eq!(differs(":./main.clad", "main.clad"), ("-".to_owned(), Some(0)));
}
