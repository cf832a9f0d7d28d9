//! The project's texts are on their own: they name no places that only one machine has.

use ladder_tests::project;
use std::path::PathBuf;

/// What a text must not hold. Written in two parts, so that this file does not hold them either.
const FORBIDDEN: [(&str, &str); 6] = [
    ("/wo", "rk/"),
    ("shared/", "corpus"),
    ("shared/", "references"),
    ("/tmp/w", "t/"),
    ("LANGUAGE", ".md"),
    ("DESIGN", ".md"),
];

const EXTENSIONS: [&str; 16] = [
    "rs", "toml", "md", "clad", "csv", "args", "lua", "vim", "txt", "ts", "mjs", "cjs", "json", "js", "css",
    "yml",
];

#[test]
fn texts_name_no_place_outside_the_project() {
    let root = project::root();
    let mut files: Vec<PathBuf> = EXTENSIONS
        .iter()
        .flat_map(|extension| project::files(&root, extension))
        .collect();
    // Continuous integration alone may say where the machine that runs it keeps foreign programs: `.ci/run` is not
    // among these.
    files.extend(["test", "try", "tests/setup", "fuzz/run"].map(|script| root.join(script)));
    let mut problems = Vec::new();
    for file in files.iter().filter(|file| file.exists()) {
        // What is not text is not checked.
        let Ok(text) = std::fs::read_to_string(file) else {
            continue;
        };
        for (number, line) in text.lines().enumerate() {
            for (first, second) in FORBIDDEN {
                if line.contains(&format!("{first}{second}")) {
                    problems.push(format!("{}:{}: {line}", file.display(), number + 1));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// A chapter of the language's definition may be cited in the code's own comments, not where people read.
#[test]
fn texts_for_people_cite_no_clauses() {
    let root = project::root();
    let mut files = project::files(&root, "md");
    files.extend(project::files(&root.join("examples"), "clad"));
    files.retain(|file| project::read(file).contains(concat!("LANGUAGE", " §")));
    assert!(files.is_empty(), "{files:?}");
}

/// Whether a name takes "a" or "an" is for `with_article` to say: "an INT", but "a DINT".
#[test]
fn no_message_guesses_the_article_of_a_name() {
    let guesses = [" a {", " an {", "\"a {", "\"an {", " a [{", " an [{"];
    let mut problems = Vec::new();
    for file in project::files(&project::root(), "rs") {
        if !file.components().any(|part| part.as_os_str() == "src") {
            continue;
        }
        for (number, line) in project::read(&file).lines().enumerate() {
            if line.contains('"') && guesses.iter().any(|guess| line.contains(guess)) {
                problems.push(format!("{}:{}: {line}", file.display(), number + 1));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn there_are_texts_to_look_at() {
    let count: usize = ["rs", "md"]
        .iter()
        .map(|extension| project::files(&project::root(), extension).len())
        .sum();
    assert!(count > 100, "only {count} files were found");
}
