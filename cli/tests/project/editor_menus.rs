//! The menus of VS Code know the files of other systems by their names.

use ladder_notations::NOTATIONS;
use ladder_tests::project;
use std::collections::BTreeSet;

/// Most files that end so are not programs: there the command palette must do.
const OF_MANY: [&str; 5] = ["csv", "json", "py", "txt", "xml"];

#[test]
fn the_explorer_offers_to_convert_the_files_of_other_systems() {
    let manifest = project::read(&project::root().join("editors/vscode/package.json"));
    let manifest: serde_json::Value = serde_json::from_str(&manifest).expect("package.json is JSON");
    let menu = manifest["contributes"]["menus"]["explorer/context"].as_array();
    let entry = menu
        .into_iter()
        .flatten()
        .find(|entry| entry["command"] == "ladder.convertFile");
    let when = entry.and_then(|entry| entry["when"].as_str()).unwrap_or_default();
    let listed = when.split(['(', ')']).nth(1).unwrap_or_default().split('|');
    let listed: BTreeSet<&str> = listed.collect();
    let known = NOTATIONS
        .iter()
        .filter(|notation| notation.is_read())
        .flat_map(|notation| notation.extensions())
        .copied();
    let known: BTreeSet<&str> = known.filter(|ending| !OF_MANY.contains(ending)).collect();
    assert_eq!(listed, known, "in editors/vscode/package.json: {when}");
}

/// The client registers each command of the server under its own name, and does not start where that name is taken.
#[test]
fn the_extension_takes_no_name_of_a_command_of_the_server() {
    let manifest = project::read(&project::root().join("editors/vscode/package.json"));
    let manifest: serde_json::Value = serde_json::from_str(&manifest).expect("package.json is JSON");
    let own = manifest["contributes"]["commands"].as_array();
    let own: BTreeSet<&str> = own
        .into_iter()
        .flatten()
        .filter_map(|command| command["command"].as_str())
        .collect();
    // The page has an example of each, which a test of the server sees to.
    let page = project::read(&project::root().join("docs/protocol.md"));
    let asked: BTreeSet<String> = page
        .split("```json")
        .skip(1)
        .filter_map(|block| serde_json::from_str(block.split("```").next()?).ok())
        .filter(|message: &serde_json::Value| message["method"] == "workspace/executeCommand")
        .filter_map(|message| Some(message["params"]["command"].as_str()?.to_owned()))
        .collect();
    assert!(own.len() > 10 && asked.len() > 5, "{own:?} {asked:?}");
    let both: Vec<&String> = asked
        .iter()
        .filter(|command| own.contains(command.as_str()))
        .collect();
    assert!(both.is_empty(), "{both:?}");
}
