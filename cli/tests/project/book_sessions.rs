//! What the book shows of a terminal is what one sees there.
//!
//! A block that is marked `console` holds commands after `$ ` and their output. They run in an empty folder, one for
//! each page, in which every block that says `file=NAME` is a file. The folder `examples` of the project is there too.
//! A page about another person's program names it, `<!-- corpus: plcopen-xml/NAME.xml -->`: that file of the folder
//! `LADDER_CORPUS` is there as well, and without that folder the page is skipped.
//!
//! `UPDATE_EXPECT=1 cargo test -p ladder-cli` writes the output into the pages.
#![cfg(unix)]

use ladder_tests::{console, markdown, project};
use std::ops::Range;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

#[test]
fn sessions_show_what_happens() {
    let update = std::env::var_os("UPDATE_EXPECT").is_some();
    let programs = programs();
    let root = project::root();
    let mut files = project::files(&root.join("docs"), "md");
    files.push(root.join("README.md"));
    let mut problems = Vec::new();
    for file in files.iter().filter(|file| file.exists()) {
        let text = project::read(file);
        let Some(foreign) = foreign_programs(&text) else {
            eprintln!("skipped: {} needs LADDER_CORPUS", file.display());
            continue;
        };
        let mut new_text = text.clone();
        // From the last to the first, so that the places before stay where they are.
        for session in sessions(&text, &foreign, programs.path()).into_iter().rev() {
            if session.shown == session.replayed {
                continue;
            }
            new_text.replace_range(session.range, &session.replayed);
            let place = format!("{}:{}", file.display(), session.line);
            problems.push(format!(
                "{place} shows\n\n{}\nbut it is\n\n{}",
                session.shown, session.replayed
            ));
        }
        if update && new_text != text {
            std::fs::write(file, new_text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        }
    }
    assert!(update || problems.is_empty(), "{}", problems.join("\n\n"));
}

/// A session on a page.
struct Session {
    /// As the page has it.
    shown: String,
    /// As it goes.
    replayed: String,
    /// Where it is in the page.
    range: Range<usize>,
    line: usize,
}

/// The examples themselves, not a link to them: what a scenario names stays inside the folder.
fn copy_examples(folder: &Path) {
    std::fs::create_dir(folder).expect("a folder for the examples");
    for entry in std::fs::read_dir(project::root().join("examples")).expect("the examples") {
        let entry = entry.expect("an example");
        if entry.path().is_dir() {
            continue;
        }
        std::fs::copy(entry.path(), folder.join(entry.file_name())).expect("a copy of an example");
    }
}

/// The programs of others that a page is about. None: the folder that has them is not here.
fn foreign_programs(text: &str) -> Option<Vec<PathBuf>> {
    let named = text
        .lines()
        .filter_map(|line| line.strip_prefix("<!-- corpus: ")?.strip_suffix(" -->"));
    let corpus = std::env::var_os("LADDER_CORPUS").map(PathBuf::from);
    named.map(|name| Some(corpus.as_ref()?.join(name))).collect()
}

/// The sessions of a page, played in their order.
fn sessions(text: &str, foreign: &[PathBuf], programs: &Path) -> Vec<Session> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    copy_examples(&folder.path().join("examples"));
    for file in foreign {
        let name = file.file_name().expect("the name of a file");
        std::fs::copy(file, folder.path().join(name))
            .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
    let mut sessions = Vec::new();
    for fence in markdown::read(text).fences {
        if let Some(name) = fence.words.iter().find_map(|word| word.strip_prefix("file=")) {
            let file = folder.path().join(name);
            let parent = file.parent().expect("the file is in a folder");
            std::fs::create_dir_all(parent).expect("a folder in the temporary folder");
            std::fs::write(file, &fence.text).expect("a file in the temporary folder");
        }
        if fence.language() == Some("console") {
            sessions.push(Session {
                replayed: console::replay(&fence.text, folder.path(), programs),
                shown: fence.text,
                range: fence.range,
                line: fence.line,
            });
        }
    }
    sessions
}

/// A folder with `ladder` and `ldfmt`.
fn programs() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let programs = [
        ("ladder", env!("CARGO_BIN_EXE_ladder")),
        ("ldfmt", env!("CARGO_BIN_EXE_ldfmt")),
    ];
    for (name, program) in programs {
        symlink(program, folder.path().join(name)).expect("a link to the program");
    }
    folder
}
