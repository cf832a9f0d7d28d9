//! Where the projects are that tests read.

use ladder_format::Options;
use ladder_notation::{Converted, Source, convert};
use ladder_notation_plcopen::Plcopen;
use std::path::{Path, PathBuf};

/// The projects of this repository.
pub(crate) fn own() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/plcopen-xml")
}

/// A folder of projects of others, where they are at hand.
pub(crate) fn others(folder: &str) -> Option<PathBuf> {
    let corpus = std::env::var_os("LADDER_CORPUS").map(|corpus| Path::new(&corpus).join(folder));
    if corpus.is_none() {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
    }
    corpus
}

/// The XML files of a folder, sorted.
pub(crate) fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let files = entries.map(|entry| entry.expect("an entry can be read").path());
    let mut files: Vec<PathBuf> = files
        .filter(|path| path.extension().is_some_and(|it| it == extension))
        .collect();
    files.sort();
    files
}

/// A project as ladder text.
pub(crate) fn converted(file: &Path) -> Converted {
    let bytes = std::fs::read(file).expect("the file can be read");
    let source = Source::alone("test", &bytes);
    convert(&Plcopen, &source, &Options::default())
        .unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// The name of a file without its ends: `kato.practice01`.
pub(crate) fn stem(file: &Path) -> String {
    let name = file
        .file_name()
        .expect("it has a name")
        .to_string_lossy()
        .into_owned();
    let ends = [".xml", ".expected.csv", ".in.csv"];
    let end = ends
        .iter()
        .find(|end| name.ends_with(*end))
        .map_or(0, |end| end.len());
    name[..name.len() - end].to_owned()
}
