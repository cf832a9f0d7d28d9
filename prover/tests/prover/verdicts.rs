//! The programs of the corpus, whose verdicts were known before they were asked for.

use super::answers;
use std::fs;
use std::path::Path;

#[test]
fn the_corpus_has_its_verdicts() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/proof");
    let mut asked = 0;
    let mut wrong = Vec::new();
    let folders = fs::read_dir(corpus).expect("the corpus is there");
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
    assert!(asked >= 36, "only {asked} were asked");
}
