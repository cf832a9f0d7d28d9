//! What writes other notations: ladder text is spelled in `format` alone, and what a stage knows is few things.

use ladder_tests::project;
use std::path::PathBuf;

/// The sources of the notations, without tests.
fn sources() -> impl Iterator<Item = PathBuf> {
    let files = project::files(&project::root().join("notations"), "rs").into_iter();
    files.filter(|path| {
        let path = path.display().to_string();
        path.contains("/src/") && !path.contains("/tests/") && !path.ends_with("/tests.rs")
    })
}

/// What only ladder text has.
const SIGNS: [&str; 6] = ["+--", "--+", ")--", "--[", "--(", "FUNCTION_BLOCK ["];

#[test]
fn no_notation_pastes_rungs_together() {
    let mut pasted = Vec::new();
    for path in sources() {
        let text = project::read(&path);
        let own = text.split("#[cfg(test)]").next().unwrap_or_default();
        for (at, _) in own.match_indices("format!(") {
            let literal = own[at..].split('"').nth(1).unwrap_or_default();
            if SIGNS.iter().any(|sign| literal.contains(sign)) {
                pasted.push(format!("{}: {literal}", path.display()));
            }
        }
    }
    assert!(pasted.is_empty(), "{}", pasted.join("\n"));
}

/// A structure of a writer has no more fields: what belongs to another stage has a type of its own.
const MOST_FIELDS: usize = 8;

#[test]
fn writers_know_few_things() {
    let writes = ["/write", "/export", "/read_back", "/st/src"];
    let is_field = |line: &&str| {
        let own = line
            .strip_prefix("    ")
            .filter(|own| !own.starts_with([' ', '/', '#']));
        let name = own.and_then(|own| own.split(' ').find(|word| !word.starts_with("pub")));
        name.is_some_and(|name| name.ends_with(':'))
    };
    let mut large = Vec::new();
    let files = sources().filter(|path| {
        let path = path.display().to_string();
        writes.iter().any(|part| path.contains(part)) && !path.contains("/read/")
    });
    for path in files {
        let text = project::read(&path);
        for (at, _) in text.match_indices("struct ") {
            let structure = text[at..].split("\n}").next().unwrap_or_default();
            let mut lines = structure.lines();
            let head = lines.next().unwrap_or_default();
            if head.ends_with('{') && lines.filter(is_field).count() > MOST_FIELDS {
                large.push(format!("{}: {head}", path.display()));
            }
        }
    }
    assert!(large.is_empty(), "{}", large.join("\n"));
}
