//! Programs in Structured Text, in whatever file they are, run as their own systems run them.

use crate::harness::Folder;
use std::fs;
use std::path::Path;

#[test]
fn traces_are_equal() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/structured-text");
    let mut names: Vec<_> = fs::read_dir(&corpus)
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    names.sort();
    assert!(names.len() >= 20, "the corpus is not there");
    let mut wrong = Vec::new();
    for name in &names {
        let folder = Folder::with(&[]);
        for entry in fs::read_dir(corpus.join(name)).unwrap() {
            let path = entry.unwrap().path();
            folder.write(
                path.file_name().unwrap().to_str().unwrap(),
                &fs::read(&path).unwrap(),
            );
        }
        let name = name.to_str().unwrap();
        let arguments = folder.read("args");
        let arguments: Vec<&str> = std::iter::once("sim")
            .chain(arguments.split_whitespace())
            .collect();
        let run = folder.ladder(&arguments);
        let is_equal = run.stdout == folder.read("expected.csv");
        if !is_equal {
            wrong.push(format!("{name}: {run}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
