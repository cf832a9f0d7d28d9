//! Pairs of files: as someone typed it, and as it is drawn.

use ladder_format::{Options, format_text};
use std::fs;
use std::path::Path;

/// Formats every `NAME.in.clad` of a folder and compares it with `NAME.out.clad`, which must stay as it is.
fn check(folder: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in paths {
        let name = path.file_name().unwrap().to_str().unwrap();
        let Some(name) = name.strip_suffix(".in.clad") else {
            continue;
        };
        count += 1;
        let input = fs::read_to_string(&path).unwrap();
        let expected = fs::read_to_string(folder.join(format!("{name}.out.clad"))).unwrap();
        for text in [&input, &expected] {
            let got = format_text(text, &Options::default());
            if got != expected {
                wrong.push(format!("{name}: got\n{got}\nexpected\n{expected}"));
            }
        }
    }
    assert!(count > 0, "no pairs in {}", folder.display());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn one_rule_each() {
    check("../tests/corpus/layout");
}

#[test]
fn harder_drawings() {
    check("tests/drawings");
}
