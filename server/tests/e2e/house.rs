//! The borders inside the server, which the compiler does not watch.

use std::path::Path;

/// The Rust files of a folder, with their paths below `src/`.
fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else {
            let name = path
                .strip_prefix(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))
                .unwrap();
            found.push((
                name.to_str().unwrap().replace('\\', "/"),
                std::fs::read_to_string(&path).unwrap(),
            ));
        }
    }
}

#[test]
fn only_the_folder_lsp_names_the_framework() {
    let mut files = Vec::new();
    sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src")), &mut files);
    let named: Vec<_> = files
        .iter()
        .filter(|(_, text)| text.contains("tower_lsp"))
        .map(|(name, _)| name)
        .collect();
    assert!(named.len() > 5, "the test looks in the wrong place: {named:?}");
    assert!(named.iter().all(|name| name.starts_with("lsp/")), "{named:?}");
}

#[test]
fn notifications_change_documents_before_they_wait() {
    // A handler that awaits first lets a later change overtake it; the functions that change documents
    // are therefore not async, and the handlers do nothing but call them.
    let sync = include_str!("../../src/lsp/documents/sync.rs");
    assert!(!sync.contains("async fn") && !sync.contains(".await"));
    let backend = include_str!("../../src/lsp/backend.rs");
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
