//! The borders inside the library, around it and around those that it is built of, which the compiler does not watch.

use std::path::Path;

/// The crates that a page has, too.
const CRATES: [&str; 5] = ["host", "documents", "live", "debugger", "service"];

/// The Rust files of a folder, with their paths below the root of the project, without their tests.
fn sources(root: &Path, folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(root, &path, found);
        } else {
            let name = path.strip_prefix(root).unwrap();
            let text = std::fs::read_to_string(&path).unwrap();
            let (text, _) = text.split_once("#[cfg(test)]\nmod tests").unwrap_or((&text, ""));
            found.push((name.to_str().unwrap().replace('\\', "/"), text.to_owned()));
        }
    }
}

fn all_sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut files = Vec::new();
    for name in CRATES {
        sources(root, &root.join(name).join("src"), &mut files);
    }
    files
}

#[test]
fn only_the_folder_lsp_names_the_framework() {
    let files = all_sources();
    let named: Vec<_> = files
        .iter()
        .filter(|(_, text)| text.contains("tower_lsp"))
        .map(|(name, _)| name)
        .collect();
    assert!(named.len() > 5, "the test looks in the wrong place: {named:?}");
    assert!(
        named.iter().all(|name| name.starts_with("service/src/lsp/")),
        "{named:?}"
    );
}

#[test]
fn what_a_page_does_not_have_is_asked_of_the_host() {
    // In a page a clock of the standard library stops the program, its files are not there, and its threads do not start.
    let forbidden = [
        "tokio",
        "std::fs",
        "std::process",
        "std::env::",
        "Instant",
        "SystemTime::now",
        "thread::spawn",
        "thread::sleep",
        "SystemDisk",
        ".canonicalize()",
        ".is_file()",
        ".is_dir()",
        "path.exists()",
        ".is_absolute()",
        ".is_symlink()",
        "Root::of",
        "Named::in_file",
        "ladder_workspace::read",
        "Stamp::of",
    ];
    let wrong: Vec<_> = all_sources()
        .into_iter()
        .filter(|(name, _)| !name.contains("/tests/") && !name.ends_with("/testing.rs"))
        .flat_map(|(name, text)| {
            let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
            let found = lines.filter(|line| forbidden.iter().any(|word| line.contains(word)));
            found
                .map(|line| format!("{name}: {}", line.trim()))
                .collect::<Vec<_>>()
        })
        .collect();
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn notifications_change_documents_before_they_wait() {
    // A handler that awaits first lets a later change overtake it; the functions that change documents
    // are therefore not async, and the handlers do nothing but call them.
    let sync = include_str!("../src/lsp/documents/sync.rs");
    assert!(!sync.contains("async fn") && !sync.contains(".await"));
    let backend = include_str!("../src/lsp/backend.rs");
    for handler in ["did_open", "did_change", "did_close"] {
        let body = backend
            .split(&format!("async fn {handler}("))
            .nth(1)
            .expect("a handler");
        let first = body.split_once("{\n").unwrap().1.trim_start();
        assert!(
            first.starts_with("sync::"),
            "{handler} begins with {}",
            first.lines().next().unwrap()
        );
    }
}
