//! A document's place among the files of its workspace.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use ladder_analysis::{Analysis, Others};
use ladder_notations::Foreign;

use crate::neighbours::{Affected, Neighbours};

/// A document's place among the files of its workspace.
#[derive(Debug, Clone)]
pub struct Membership {
    /// The file.
    pub path: PathBuf,
    /// The workspaces.
    pub neighbours: Arc<Neighbours>,
    /// Whether what the file exports was passed on to the others.
    passed_on: Arc<OnceLock<()>>,
    /// How many changes there had been when it was read.
    read_at: Arc<OnceLock<u64>>,
}

impl Membership {
    /// The place of a file that was not passed on yet.
    pub fn new(path: PathBuf, neighbours: &Arc<Neighbours>) -> Membership {
        Membership {
            path,
            neighbours: Arc::clone(neighbours),
            passed_on: Arc::default(),
            read_at: Arc::default(),
        }
    }

    /// As [`Neighbours::view`], for the text that is to be passed on.
    pub(crate) fn view(&self) -> (Arc<str>, Others) {
        let (name, others, changes) = self.neighbours.view_now(&self.path);
        let _ = self.read_at.set(changes);
        (name, others)
    }

    /// The same file, with a text that was not passed on yet.
    pub(crate) fn again(&self) -> Membership {
        Membership::new(self.path.clone(), &self.neighbours)
    }

    /// Tells the others what the file says now. Returns, once, who sees something else than before.
    pub(crate) fn tell(&self, analysis: &Arc<Analysis>, foreign: Option<&Arc<Foreign>>) -> Affected {
        if self.passed_on.set(()).is_err() {
            return Affected::default();
        }
        let read_at = self.read_at.get().copied();
        self.neighbours.analysed(&self.path, (analysis, foreign), read_at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::position::Encoding;
    use crate::revision::Revision;
    use ladder_analysis::rules::is_of_own_text;

    const FUNCTION: &str = "+--( )( y )--+\n+--<FUN>( count )--( )( y )--+\n";

    /// A workspace with these programs.
    fn workspace(programs: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in programs.iter().chain(&[("ladder.toml", "")]) {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        folder
    }

    /// What an editor shows of a file.
    fn shown(neighbours: &Arc<Neighbours>, path: PathBuf, text: &str) -> Revision {
        let name = path.to_string_lossy().into_owned();
        Revision::on_disk(&name, Encoding::Utf8, text, Membership::new(path, neighbours))
    }

    #[test]
    fn a_new_file_is_looked_at_again_if_another_has_changed_meanwhile() {
        let folder = workspace(&[]);
        let neighbours = crate::testing::neighbours();
        let open = |name: &str, text: &str| shown(&neighbours, folder.path().join(name), text);
        let caller = open("caller.clad", "+--( )( z )--<CALL>( count )--+\n");
        let called = open("called.clad", FUNCTION);
        assert!(called.analysis().is_some());
        // Nobody knows of the function yet: the call concerns no other file.
        caller.tell_neighbours();
        let affected = called.tell_neighbours();
        assert!(affected.for_others && affected.for_itself, "{affected:?}");
        assert_eq!(called.tell_neighbours(), Affected::default());
    }

    #[test]
    fn the_text_on_disk_of_an_open_file_is_neither_read_nor_held() {
        let function = |name: &str| format!("+--( )( y )--+\n+--<FUN>( {name} )--( )( y )--+\n");
        let folder = workspace(&[("own.clad", &function("saved")), ("other.clad", "")]);
        let own = folder.path().join("own.clad");
        let other = folder.path().join("other.clad");
        let neighbours = crate::testing::neighbours();
        let open = |path: &PathBuf, text: &str| {
            neighbours.opened(path);
            shown(&neighbours, path.clone(), text)
        };
        let called = open(&own, &function("typed"));
        assert!(!neighbours.holds_text_of(&own));
        let affected = called.tell_neighbours();
        assert!(affected.for_others, "the first that is known of it");
        assert!(neighbours.holds_text_of(&other));
        let call = |name: &str| format!("+--( )( z )--<CALL>( {name} )--+\n");
        let finds = |revision: &Revision| revision.analysis().map(|analysis| analysis.findings().len());
        let caller = open(&other, &call("typed"));
        assert_eq!(finds(&caller), Some(0), "what the editor shows counts");
        caller.tell_neighbours();
        assert!(!neighbours.holds_text_of(&other));
        neighbours.disk_changed(std::slice::from_ref(&own));
        assert!(!neighbours.holds_text_of(&own), "it was saved");
        neighbours.disk_changed(&[folder.path().join("ladder.toml")]);
        neighbours.view(&other);
        assert!(!neighbours.holds_text_of(&own), "the folder was read again");
        // As soon as the editor shows it no more it counts as it was saved.
        assert!(neighbours.closed(&own));
        assert!(neighbours.holds_text_of(&own));
        assert_eq!(finds(&open(&other, &call("saved"))), Some(0));
        assert_ne!(finds(&open(&other, &call("typed"))), Some(0));
    }

    #[test]
    fn of_files_opened_at_once_each_counts_for_the_other_as_it_was_saved() {
        let folder = workspace(&[("called.clad", FUNCTION), ("caller.clad", "")]);
        let called = folder.path().join("called.clad");
        let caller = folder.path().join("caller.clad");
        let neighbours = crate::testing::neighbours();
        neighbours.opened(&called);
        neighbours.opened(&caller);
        let called = shown(&neighbours, called, FUNCTION);
        let caller = shown(&neighbours, caller, "+--( )( z )--<CALL>( count )--+\n");
        let found = caller.analysis().map(|analysis| analysis.findings().len());
        assert_eq!(
            found,
            Some(0),
            "the function is there, though its file was not checked"
        );
        caller.tell_neighbours();
        assert_eq!(
            called.tell_neighbours(),
            Affected::default(),
            "it says what it said on disk"
        );
    }

    #[test]
    fn what_a_person_looks_at_is_known_before_large_files_are_read() {
        let large = format!("{}{FUNCTION}", "# a line of a long list #\n".repeat(90_000));
        let folder = workspace(&[("large.clad", &large), ("small.clad", "")]);
        let own = folder.path().join("own.clad");
        let text = "+--( )( z )<CALL>( count )--+\n";
        std::fs::write(&own, text).unwrap();
        let neighbours = crate::testing::neighbours();
        neighbours.opened(&own);
        let own = shown(&neighbours, own, text);
        let is_whole = |revision: &Revision| revision.first_context().map(|(_, is_whole)| is_whole);
        assert_eq!(
            is_whole(&own),
            Some(false),
            "the large file is read by nobody yet"
        );
        assert_eq!(is_whole(&own), Some(false));
        let rules = |analysis: &crate::language::Analysis| -> Vec<&str> {
            let found = analysis.findings().iter();
            found.map(|finding| finding.rule.name()).collect()
        };
        let early = own
            .first_analysis()
            .expect("the large file is read by nobody yet");
        assert_eq!(rules(&early), ["missing-wire", "unknown-function"]);
        let own_text = early.findings().iter().map(|found| is_of_own_text(found.rule));
        assert_eq!(own_text.collect::<Vec<_>>(), [true, false]);
        assert_eq!(
            rules(own.analysis().unwrap()),
            ["missing-wire"],
            "the large file counts"
        );
        assert!(own.first_analysis().is_none() && own.was_shown_early());
        assert_eq!(is_whole(&own), Some(true));
        // A workspace without large files is read at once.
        let folder = workspace(&[("small.clad", "")]);
        assert_eq!(
            is_whole(&shown(&neighbours, folder.path().join("own.clad"), text)),
            Some(true)
        );
    }
}
