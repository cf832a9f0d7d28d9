//! The fuzzer's inputs, run as plain tests: those that its searches begin with, those that once broke something, and what
//! searches on this machine have kept.

use ladder_invariants::TARGETS;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A target's seeds are at most so many: what else there is to find, the fuzzer finds.
const MOST_FILES: usize = 16;

/// And together at most so long.
const MOST_BYTES: u64 = 24 << 10;

fn fuzz() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz")
}

/// The files of a folder; none if there is no folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    files
}

fn names(folder: &Path) -> BTreeSet<String> {
    let files = files(folder);
    let stems = files.iter().filter_map(|file| file.file_stem());
    stems.map(|stem| stem.to_string_lossy().into_owned()).collect()
}

/// Says which input it was when a check fails.
struct Running<'f>(&'f Path);

impl Drop for Running<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("the input is {}", self.0.display());
        }
    }
}

fn run(target: &str) {
    for folder in ["seeds", "regressions", "corpus"] {
        for file in files(&fuzz().join(folder).join(target)) {
            let running = Running(&file);
            let data = fs::read(&file).expect("an input can be read");
            ladder_invariants::check(target, &data);
            drop(running);
        }
    }
}

macro_rules! targets {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                run(stringify!($name));
            }
        )*

        #[test]
        fn every_target_is_run() {
            let run = BTreeSet::from([$(stringify!($name).to_owned()),*]);
            let known: BTreeSet<String> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
            assert_eq!(run, known);
            assert_eq!(names(&fuzz().join("fuzz_targets")), known);
            assert_eq!(names(&fuzz().join("seeds")), known);
            let broken_once = names(&fuzz().join("regressions"));
            assert!(broken_once.is_subset(&known), "{broken_once:?}");
        }
    };
}

targets! { parse format check editor edits messages notations scenarios settings simulation }

#[test]
fn the_seeds_are_few_and_small() {
    for target in TARGETS {
        let files = files(&fuzz().join("seeds").join(target.name));
        let bytes: u64 = files
            .iter()
            .map(|file| file.metadata().expect("a file").len())
            .sum();
        assert!(
            (1..=MOST_FILES).contains(&files.len()),
            "{} has {} seeds",
            target.name,
            files.len()
        );
        assert!(bytes <= MOST_BYTES, "{} has {bytes} bytes", target.name);
    }
}
