//! The pages of the rules: each shows a wrong and a right program, and both are what they say.

use ladder_analysis::{Diagnostic, Rule, Severity, analyze};
use ladder_syntax::parse;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn page(rule: Rule) -> PathBuf {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/src/rules");
    pages.join(format!("{}.md", rule.name()))
}

/// The programs of a page that are marked with a word.
fn programs<'t>(text: &'t str, mark: &str) -> Vec<&'t str> {
    let fence = format!("```clad {mark}\n");
    text.split(fence.as_str())
        .skip(1)
        .filter_map(|rest| rest.split("```").next())
        .collect()
}

fn found(program: &str) -> Vec<Diagnostic> {
    analyze(&Arc::new(parse(program)), "page.clad").diagnostics
}

#[test]
fn every_rule_has_a_page_that_holds_true() {
    let mut problems = Vec::new();
    for &rule in Rule::ALL {
        let Ok(text) = std::fs::read_to_string(page(rule)) else {
            problems.push(format!("{rule}: there is no page"));
            continue;
        };
        let (wrong, right) = (programs(&text, "wrong"), programs(&text, "right"));
        if wrong.is_empty() || right.is_empty() {
            problems.push(format!("{rule}: a wrong or a right program is missing"));
        }
        for program in wrong {
            if !found(program).iter().any(|d| d.rule == rule) {
                problems.push(format!("{rule}: the wrong program does not show it"));
            }
        }
        for diagnostic in right.into_iter().flat_map(found) {
            if diagnostic.rule == rule || diagnostic.severity > Severity::Info {
                problems.push(format!(
                    "{rule}: right program: {}: {}",
                    diagnostic.rule, diagnostic.message
                ));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn pages_belong_to_rules() {
    let folder = page(Rule::OpenWire);
    let folder = folder.parent().expect("a page stands in a folder");
    let mut strays: Vec<String> = std::fs::read_dir(folder)
        .expect("the pages are there")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name != "index.md")
        .filter(|name| name.strip_suffix(".md").and_then(Rule::from_name).is_none())
        .collect();
    strays.sort();
    assert!(strays.is_empty(), "{strays:?}");
}
