//! No circle of imports crosses a room: where two rooms know each other, neither can be read, tested or changed alone.

use ladder_tests::imports::{Circle, Crate, Module};
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
fn no_circle_of_imports_crosses_a_room() {
    let root = project::root();
    let mut problems = Vec::new();
    let crates = crates();
    assert!(crates.len() > 10, "only {crates:?} were found");
    for folder in crates {
        let name = folder.strip_prefix(&root).expect("a crate is in the project");
        let circles = Crate::read(&folder.join("src")).circles();
        problems.extend(
            circles
                .iter()
                .map(|circle| shown(&name.to_string_lossy(), circle)),
        );
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

fn shown(name: &str, circle: &Circle) -> String {
    let path = |module: &Module| [&["crate".to_owned()], &module[..]].concat().join("::");
    let rooms: Vec<String> = circle.rooms.iter().map(path).collect();
    let mut lines = vec![format!(
        "{name}: these rooms import each other: {}",
        rooms.join(", ")
    )];
    for (file, imports) in &circle.files {
        let imports: Vec<String> = imports.iter().map(path).collect();
        lines.push(format!("    {} imports {}", path(file), imports.join(", ")));
    }
    lines.join("\n")
}

/// The rooms of the circles in some sources.
fn circles(sources: &[(&str, &str)]) -> Vec<String> {
    let sources = sources
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
    let circles = Crate::of(sources).circles();
    circles.iter().map(|circle| shown("planted", circle)).collect()
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
        let found = circles(&[
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
    let found = circles(&[
        ("lib.rs", "mod names;\npub use names::Name;\n"),
        ("names/mod.rs", "mod text;"),
        ("names/text.rs", "use crate::Name;"),
    ]);
    assert_eq!(found.len(), 0, "names does not import its text: {found:?}");
    let found = circles(&[
        ("lib.rs", "mod names;\npub use names::Name;\n"),
        ("names/mod.rs", "mod text;\nuse text::Text;"),
        ("names/text.rs", "use crate::Name;"),
    ]);
    assert_eq!(found.len(), 1);
    assert!(found[0].contains("crate, crate::names"), "{}", found[0]);
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
        let found = circles(&[
            ("lib.rs", "mod names;\nmod rules;\n"),
            ("names/mod.rs", "use crate::rules::Rule;"),
            ("rules/mod.rs", text),
        ]);
        assert_eq!(found, Vec::<String>::new(), "{text}");
    }
    // Files of one room may know each other.
    let found = circles(&[
        ("lib.rs", "mod names;\nmod name;\n"),
        ("names.rs", "use crate::name::Name;\nuse names::text::Text;"),
        ("name.rs", "use crate::names::text::Text;"),
        ("names/text.rs", "use crate::name::Name;"),
    ]);
    assert_eq!(found, Vec::<String>::new());
}
