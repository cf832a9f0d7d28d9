//! Ladder text is spelled in `format` alone: readers and writers of other notations make blocks and networks of its sketch.

use ladder_tests::project;

/// What only ladder text has.
const SIGNS: [&str; 6] = ["+--", "--+", ")--", "--[", "--(", "FUNCTION_BLOCK ["];

#[test]
fn no_notation_pastes_rungs_together() {
    let mut pasted = Vec::new();
    let files = project::files(&project::root().join("notations"), "rs");
    let is_test = |path: &str| path.contains("/tests/") || path.ends_with("/tests.rs");
    let files = files.iter().filter(|path| !is_test(&path.display().to_string()));
    for path in files {
        let text = project::read(path);
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
