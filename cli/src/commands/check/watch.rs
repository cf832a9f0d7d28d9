//! `ladder check --watch`: the same check again whenever something changes.
//!
//! The files are checked a few times a second. That needs no more of the operating system than a check does, so it
//! works on network drives and in containers as well, and a file that `.gitignore` names is no news.

use super::{Arguments, Format, Round, check_files};
use crate::outcome::{Failure, Outcome};
use crate::terminal;
use ladder_syntax::numeral::counted;
use ladder_workspace::{Files, Root, Stamp};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The pause between two looks.
const PAUSE: Duration = Duration::from_millis(200);

/// Looking takes at most this part of the time, however many files there are.
const SHARE: u32 = 20;

/// An editor may write a file in several steps; after the last of them the files are the same for so long.
const REST: Duration = Duration::from_millis(30);

/// So often a change is waited out, for a file that never rests must be checked too.
const RESTS: usize = 10;

/// Checks, and checks again, until nobody reads any more. Ctrl-C ends the process as it ends any other.
pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut seen = Seen::now(&arguments.paths);
    loop {
        let for_people = matches!(arguments.format, Format::Full | Format::Concise);
        if for_people {
            terminal::clear();
        }
        let Round {
            outcome,
            nobody_reads,
            // Not for the time until a file changes.
            workspaces: _,
        } = check_files(arguments)?;
        if nobody_reads || seen.programs == 0 {
            return Ok(outcome);
        }
        terminal::note(&format_args!(
            "watching {}; Ctrl-C ends this",
            counted(seen.programs, "program")
        ));
        seen = seen.next(&arguments.paths);
    }
}

/// The state of all files that the findings follow from.
#[derive(Debug, PartialEq, Eq)]
struct Seen {
    /// How many programs are checked.
    programs: usize,
    files: BTreeMap<PathBuf, Stamp>,
}

impl Seen {
    fn now(paths: &[PathBuf]) -> Seen {
        // What cannot be read now may come back: a check says what is wrong with it.
        let (programs, _) = ladder_workspace::find_programs(paths);
        let roots = programs.iter().filter_map(|program| Root::of(program).ok());
        let roots: BTreeMap<PathBuf, Root> = roots.map(|root| (root.folder().to_owned(), root)).collect();
        let mut files: BTreeSet<PathBuf> = programs.iter().cloned().collect();
        for root in roots.into_values() {
            files.extend(root.settings_file());
            files.extend(root.programs(&Files::default()));
        }
        Seen {
            programs: programs.len(),
            files: files
                .into_iter()
                .map(|file| (file.clone(), Stamp::of(&file)))
                .collect(),
        }
    }

    /// Waits until something is different, and has come to rest.
    fn next(&self, paths: &[PathBuf]) -> Seen {
        loop {
            let began = Instant::now();
            let now = Seen::now(paths);
            if now != *self {
                return now.at_rest(paths);
            }
            std::thread::sleep(PAUSE.max(began.elapsed() * SHARE));
        }
    }

    fn at_rest(mut self, paths: &[PathBuf]) -> Seen {
        for _ in 0..RESTS {
            std::thread::sleep(REST);
            let now = Seen::now(paths);
            if now == self {
                break;
            }
            self = now;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    /// What is written while `change` is done is seen, or is not.
    fn is_seen(change: impl Fn(&Path)) -> bool {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let file = folder.path().join(name);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        };
        write("plant/ladder.toml", "");
        write("plant/.gitignore", "old/\n");
        write("plant/old/a.clad", "");
        write("plant/a.clad", "");
        write("plant/b.clad", "");
        write("plant/line/c.clad", "");
        write("next to it.clad", "");
        let paths = [
            folder.path().join("plant/a.clad"),
            folder.path().join("plant/line"),
        ];
        let before = Seen::now(&paths);
        assert_eq!(before.programs, 2);
        assert_eq!(before, Seen::now(&paths));
        change(folder.path());
        before != Seen::now(&paths)
    }

    #[test]
    fn what_is_looked_at() {
        assert!(is_seen(|at| fs::write(at.join("plant/a.clad"), "+--+").unwrap()));
        assert!(is_seen(
            |at| fs::remove_file(at.join("plant/line/c.clad")).unwrap()
        ));
        assert!(is_seen(
            |at| fs::write(at.join("plant/line/new.clad"), "").unwrap()
        ));
        // Another program of the workspace may declare what this one uses.
        assert!(is_seen(|at| fs::write(at.join("plant/b.clad"), "+--+").unwrap()));
        assert!(is_seen(
            |at| fs::write(at.join("plant/ladder.toml"), "[lint]\n").unwrap()
        ));
        assert!(is_seen(
            |at| fs::write(at.join("plant/line/ladder.toml"), "").unwrap()
        ));
        assert!(!is_seen(
            |at| fs::write(at.join("next to it.clad"), "+--+").unwrap()
        ));
        assert!(!is_seen(
            |at| fs::write(at.join("plant/notes.txt"), "new").unwrap()
        ));
        assert!(!is_seen(
            |at| fs::write(at.join("plant/old/a.clad"), "+--+").unwrap()
        ));
    }
}
