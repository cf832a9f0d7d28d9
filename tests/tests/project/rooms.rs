//! No circle of imports crosses a room: where two rooms know each other, neither can be read, tested or changed alone.

use ladder_tests::imports::{Crate, Module, Room};
use ladder_tests::project;
use std::path::PathBuf;

/// The folders of all crates.
fn crates() -> Vec<PathBuf> {
    let manifests = project::files(&project::root(), "toml").into_iter();
    let manifests = manifests.filter(|path| path.ends_with("Cargo.toml"));
    let folders = manifests.filter_map(|path| path.parent().map(PathBuf::from));
    folders.filter(|folder| folder.join("src").is_dir()).collect()
}

#[test]
fn rooms_form_a_line() {
    let root = project::root();
    let crates = crates();
    assert!(crates.len() > 10, "only {crates:?} were found");
    let broken = crates.iter().flat_map(|folder| {
        let name = folder.strip_prefix(&root).expect("a crate is in the project");
        broken(&name.to_string_lossy(), &Crate::read(&folder.join("src")))
    });
    let broken: Vec<String> = broken.collect();
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// The rooms of a crate whose parts are in no order, each with the order that is kept best and the imports that break it.
fn broken(name: &str, read: &Crate) -> Vec<String> {
    let rooms = read.rooms().into_iter().filter(|room| !room.against.is_empty());
    rooms.map(|room| shown(name, &room)).collect()
}

fn shown(name: &str, room: &Room) -> String {
    let path = |module: &Module| [&["crate".to_owned()], &module[..]].concat().join("::");
    let order: Vec<String> = room.order.iter().map(path).collect();
    let against = room.against.iter();
    let against = against.map(|(from, to)| format!("    {} imports {}\n", path(from), path(to)));
    format!(
        "{name}: the parts of {} are in no order; nearest is {}, but\n{}",
        path(&room.name),
        order.join(", "),
        against.collect::<String>()
    )
}

/// What is broken in some sources.
fn broken_in(sources: &[(&str, &str)]) -> Vec<String> {
    let sources = sources
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
    broken("planted", &Crate::of(sources))
}

#[test]
fn a_circle_is_found_however_it_is_imported() {
    let imports = [
        "use crate::names::Name;",
        "use crate::{names::Name, other};",
        "use crate::names;",
        "use super::names::*;",
        "use super::names::{self as n, Name};",
        "fn f() -> crate::names::Name { todo!() }",
        "fn f() { let _ = 'a'; super::names::name(\"\\\"\") }",
    ];
    for import in imports {
        let found = broken_in(&[
            ("lib.rs", "mod names;\nmod rules;\n"),
            ("names/mod.rs", "use crate::rules::{Rule};"),
            ("rules/mod.rs", import),
        ]);
        assert_eq!(found.len(), 1, "{import}");
        assert!(found[0].contains("crate::names, crate::rules"), "{}", found[0]);
    }
}

#[test]
fn a_circle_through_the_facade_is_found() {
    let found = broken_in(&[
        ("lib.rs", "mod names;\npub use names::Name;\n"),
        ("names/mod.rs", "mod text;"),
        ("names/text.rs", "use crate::Name;"),
    ]);
    assert_eq!(found.len(), 1);
    assert!(found[0].contains("crate imports crate::names"), "{}", found[0]);
}

#[test]
fn rooms_are_in_a_circle_also_where_no_files_are() {
    let found = broken_in(&[
        ("lib.rs", "mod names;\nmod rules;\n"),
        ("names/mod.rs", "mod text;\nmod scope;"),
        ("names/text.rs", ""),
        ("names/scope.rs", "use crate::rules::Rule;"),
        ("rules/mod.rs", "mod spelling;"),
        ("rules/spelling.rs", "use crate::names::text::Text;"),
    ]);
    assert_eq!(found.len(), 1);
    assert!(
        found[0].contains("crate::names::scope imports crate::rules"),
        "{}",
        found[0]
    );
    let found = broken_in(&[
        ("lib.rs", "mod names;\n"),
        ("names/mod.rs", "mod text;\nmod scope;"),
        ("names/text/mod.rs", "mod letter;"),
        ("names/text/letter.rs", "use crate::names::scope::Scope;"),
        ("names/text/word.rs", ""),
        ("names/scope.rs", "use super::text::word::Word;"),
    ]);
    assert_eq!(found.len(), 1, "a room in a room");
}

#[test]
fn what_imports_nothing_is_no_circle() {
    let nothing = [
        "// use crate::names::Name;",
        "/* use crate::names::Name; /* and */ crate::names::a() */",
        "const TEXT: &str = \"use crate::names::Name;\";",
        "const TEXT: &str = r#\"\" crate::names::Name\"#;",
        "pub(in crate::names) fn f<'a>(_: &'a str) {}",
        "#[cfg(test)]\nmod tests { use crate::names::Name; }",
        "#[cfg(test)]\nuse crate::names::{Name};",
        "use other::names::Name;",
    ];
    for text in nothing {
        let found = broken_in(&[
            ("lib.rs", "mod names;\nmod rules;\n"),
            ("names/mod.rs", "use crate::rules::Rule;"),
            ("rules/mod.rs", text),
        ]);
        assert_eq!(found, Vec::<String>::new(), "{text}");
    }
    let found = broken_in(&[
        ("lib.rs", "mod names;\nmod rules;\n"),
        ("names/mod.rs", "use crate::rules::Rule;"),
        ("rules/mod.rs", "#[cfg(test)]\nmod tests;"),
        ("rules/tests.rs", "use crate::names::Name;"),
    ]);
    assert_eq!(found, Vec::<String>::new());
    // Files of one room may know each other.
    let found = broken_in(&[
        ("lib.rs", "mod names;\nmod name;\n"),
        ("names.rs", "use crate::name::Name;\nuse names::text::Text;"),
        ("name.rs", "use crate::names::text::Text;"),
        ("names/text.rs", "use crate::name::Name;"),
    ]);
    assert_eq!(found, Vec::<String>::new());
}
