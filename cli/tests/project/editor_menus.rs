//! The menus of VS Code know the files of other systems by their names.

use ladder_interchange::notation::NOTATIONS;
use ladder_tests::project;
use std::collections::BTreeSet;

/// Most files that end so are no programs: there the command palette must do.
const OF_MANY: [&str; 5] = ["csv", "json", "py", "txt", "xml"];

#[test]
fn the_explorer_offers_to_convert_the_files_of_other_systems() {
    let manifest = project::read(&project::root().join("editors/vscode/package.json"));
    let manifest: serde_json::Value = serde_json::from_str(&manifest).expect("package.json is JSON");
    let menu = manifest["contributes"]["menus"]["explorer/context"].as_array();
    let entry = menu
        .into_iter()
        .flatten()
        .find(|entry| entry["command"] == "ladder.convert");
    let when = entry.and_then(|entry| entry["when"].as_str()).unwrap_or_default();
    let listed = when.split(['(', ')']).nth(1).unwrap_or_default().split('|');
    let listed: BTreeSet<&str> = listed.collect();
    let known = NOTATIONS
        .iter()
        .flat_map(|notation| notation.extensions())
        .copied();
    let known: BTreeSet<&str> = known.filter(|ending| !OF_MANY.contains(ending)).collect();
    assert_eq!(listed, known, "in editors/vscode/package.json: {when}");
}
