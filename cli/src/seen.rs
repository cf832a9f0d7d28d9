//! What a command that watches has seen of the files: `ladder check --watch`, `ladder test --watch`.
//!
//! The files are checked a few times a second. That needs no more of the operating system than the command itself does, so
//! it works on network drives and in containers as well, and a file that `.gitignore` names is no news.

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

/// So often a change is waited out, for a file that never rests must be read too.
const RESTS: usize = 10;

/// What a command reads of the files that are named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reads<'a> {
    /// Programs.
    Programs,
    /// Scenarios, and these programs of theirs.
    Scenarios(&'a [PathBuf]),
}

/// The state of all files that the results follow from.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Seen {
    /// How many programs, or files of scenarios, are named.
    pub(crate) named: usize,
    files: BTreeMap<PathBuf, Stamp>,
}

impl Seen {
    /// What there is now.
    pub(crate) fn now(paths: &[PathBuf], reads: Reads<'_>) -> Seen {
        // What cannot be read now may come back: the command says what is wrong with it.
        let (named, _) = match reads {
            Reads::Programs => ladder_workspace::find_programs(paths),
            Reads::Scenarios(_) => ladder_workspace::find_scenarios(paths),
        };
        let mut files: BTreeSet<PathBuf> = named.iter().cloned().collect();
        if let Reads::Scenarios(programs) = reads {
            files.extend(programs.iter().cloned());
        }
        let roots = files.iter().filter_map(|file| Root::of(file).ok());
        let roots: BTreeMap<PathBuf, Root> = roots.map(|root| (root.folder().to_owned(), root)).collect();
        for root in roots.into_values() {
            files.extend(root.settings_file());
            files.extend(root.programs(&Files::default()));
        }
        Seen {
            named: named.len(),
            files: files
                .into_iter()
                .map(|file| (file.clone(), Stamp::of(&file)))
                .collect(),
        }
    }

    /// Waits until something is different, and has come to rest.
    pub(crate) fn next(&self, paths: &[PathBuf], reads: Reads<'_>) -> Seen {
        loop {
            let began = Instant::now();
            let now = Seen::now(paths, reads);
            if now != *self {
                return now.at_rest(paths, reads);
            }
            std::thread::sleep(PAUSE.max(began.elapsed() * SHARE));
        }
    }

    fn at_rest(mut self, paths: &[PathBuf], reads: Reads<'_>) -> Seen {
        for _ in 0..RESTS {
            std::thread::sleep(REST);
            let now = Seen::now(paths, reads);
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
        let before = Seen::now(&paths, Reads::Programs);
        assert_eq!(before.named, 2);
        assert_eq!(before, Seen::now(&paths, Reads::Programs));
        change(folder.path());
        before != Seen::now(&paths, Reads::Programs)
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
