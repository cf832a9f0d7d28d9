//! Nothing in the book, and in the other texts for people, points to where nothing is.

use ladder_tests::book::{Page, pages, source};
use ladder_tests::{markdown, project};
use std::collections::HashSet;
use std::path::{Component, Path, PathBuf};

#[test]
fn every_page_is_in_the_summary_once() {
    let mut named = HashSet::new();
    for page in pages() {
        assert!(
            named.insert(page.path.clone()),
            "{} is named twice",
            page.path.display()
        );
    }
    for file in project::files(&source(), "md") {
        let is_summary = file.ends_with("SUMMARY.md");
        assert!(
            is_summary || named.contains(&file),
            "{} is in no chapter",
            file.display()
        );
    }
}

#[test]
fn links_of_the_book_lead_somewhere() {
    let pages = pages();
    let problems: Vec<String> = pages
        .iter()
        .flat_map(|page| {
            let links = page.content.links.iter();
            links.filter_map(|link| problem(link, page, &pages))
        })
        .collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// What is wrong with a link on a page, if anything is.
fn problem(link: &str, page: &Page, pages: &[Page]) -> Option<String> {
    if is_external(link) {
        return None;
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let file = if path.is_empty() {
        page.path.clone()
    } else {
        next_to(&page.path, path)
    };
    let here = page.path.display();
    match pages.iter().find(|other| other.path == file) {
        None if file.starts_with(source()) && file.exists() => None,
        None => Some(format!("{here}: `{link}` leads to no page of the book")),
        Some(target) if anchor.is_empty() || target.content.anchors.contains(anchor) => None,
        Some(_) => Some(format!("{here}: `{link}` leads to no heading")),
    }
}

#[test]
fn links_of_the_other_texts_lead_to_files() {
    let root = project::root();
    let mut problems = Vec::new();
    for file in project::files(&root, "md") {
        // Pages of the book link to each other as they are rendered, and are checked above.
        if file.starts_with(root.join("docs")) {
            continue;
        }
        for link in markdown::read(&project::read(&file)).links {
            let path = link.split('#').next().unwrap_or_default();
            if !is_external(&link) && !path.is_empty() && !next_to(&file, path).exists() {
                problems.push(format!("{}: `{link}` leads to no file", file.display()));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

fn is_external(link: &str) -> bool {
    link.contains("://") || link.starts_with("mailto:")
}

/// A path as it is seen from the folder of a file, without `..` in it.
fn next_to(file: &Path, path: &str) -> PathBuf {
    let mut whole = file.parent().expect("a file is in a folder").to_owned();
    for component in Path::new(path).components() {
        match component {
            Component::ParentDir => {
                whole.pop();
            }
            Component::CurDir => {}
            other => whole.push(other),
        }
    }
    whole
}
