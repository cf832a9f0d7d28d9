//! Programs whose verdicts were known before they were asked for: those of the corpus, and one for each kind of block and control,
//! whose verdicts follow from LANGUAGE §7.

use super::answers;
use std::fs;
use std::path::Path;

/// Proves each program of a folder; how many properties they have.
fn check(folder: &str) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut asked = 0;
    let mut wrong = Vec::new();
    let folders = fs::read_dir(folder).expect("the folder is there");
    for folder in folders.map(|entry| entry.expect("it can be read").path()) {
        if !folder.is_dir() {
            continue;
        }
        let read = |name: &str| fs::read_to_string(folder.join(name)).expect(name);
        let expected = read("expected.txt");
        let expected: Vec<&str> = expected
            .lines()
            .take_while(|line| !line.starts_with("same as"))
            .collect();
        let found = answers(&read("program.clad"), &read("properties.txt"));
        let found: Vec<&str> = match &found {
            None => vec!["refused"],
            Some(answers) => answers.iter().map(|(_, answer)| answer.verdict.word()).collect(),
        };
        asked += found.len();
        if found != expected {
            wrong.push(format!("{}: {found:?}, expected {expected:?}", folder.display()));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    asked
}

#[test]
fn the_corpus_has_its_verdicts() {
    let asked = check("../tests/corpus/proof");
    assert!(asked >= 36, "only {asked} were asked");
}

#[test]
fn each_kind_of_block_has_its_verdicts() {
    let asked = check("tests/verdicts");
    assert!(asked >= 130, "only {asked} were asked");
}
