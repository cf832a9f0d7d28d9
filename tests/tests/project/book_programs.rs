//! The programs in the book hold no errors and are in the canonical layout.
//!
//! Every block that is marked `clad` is one program. After the language may be:
//!
//! - `wrong`: it shows an error, and `ladder check` finds something;
//! - `sketch`: it is not in the canonical layout, to show something about the drawing.
//!
//! `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the canonical layout into the pages.

use ladder_analysis::{AnalyzeOptions, RuleSettings, Severity, analyze};
use ladder_format::{Options, format_text};
use ladder_syntax::parse;
use ladder_tests::book::source;
use ladder_tests::instruction_pages::{NOT_RUN, runs};
use ladder_tests::markdown::{self, Fence};
use ladder_tests::project;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The texts for people that hold programs.
fn texts() -> Vec<PathBuf> {
    let root = project::root();
    let mut files = project::files(&root.join("docs"), "md");
    files.push(root.join("README.md"));
    files.retain(|file| file.exists());
    files
}

fn programs(text: &str) -> Vec<Fence> {
    let fences = markdown::read(text).fences;
    fences
        .into_iter()
        .filter(|fence| fence.language() == Some("clad"))
        .collect()
}

fn place(file: &Path, fence: &Fence) -> String {
    format!("{}:{}", file.display(), fence.line)
}

#[test]
fn programs_hold_no_errors() {
    let mut problems = Vec::new();
    for file in texts() {
        for fence in programs(&project::read(&file)) {
            let place = place(&file, &fence);
            let parse = Arc::new(parse(&fence.text));
            if fence.says("wrong") {
                // Pages of rules that are off unless set show programs that only these find fault with.
                if analyze(
                    &parse,
                    AnalyzeOptions::new("program").with_rules(&RuleSettings::everything()),
                )
                .diagnostics()
                .is_empty()
                {
                    problems.push(format!("{place}: nothing is wrong"));
                }
                continue;
            }
            let found = analyze(&parse, "program").diagnostics().to_vec();
            for finding in found {
                // What is not read is what such programs show.
                if finding.severity > Severity::Info && finding.rule.name() != "unread-part" {
                    problems.push(format!("{place}: {}: {}", finding.rule, finding.message));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn programs_stand_in_the_canonical_layout() {
    let update = std::env::var_os("UPDATE_EXPECT").is_some();
    let mut problems = Vec::new();
    for file in texts() {
        let text = project::read(&file);
        let mut new_text = text.clone();
        // From the last to the first, so that the places before stay where they are.
        for fence in programs(&text).iter().rev() {
            if fence.says("sketch") || fence.says("wrong") {
                continue;
            }
            let formatted = format_text(&fence.text, &Options::default());
            if formatted != fence.text {
                problems.push(format!("{}:\n{formatted}", place(&file, fence)));
                new_text.replace_range(fence.range.clone(), &formatted);
            }
        }
        if update && new_text != text {
            std::fs::write(&file, new_text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        }
    }
    assert!(update || problems.is_empty(), "{}", problems.join("\n"));
}

/// What the simulator refuses is reported on the page, and only there. The pages of rules are about what is found.
#[test]
fn pages_say_what_is_not_run() {
    let rules = source().join("rules");
    let mut problems = Vec::new();
    for file in texts().into_iter().filter(|file| !file.starts_with(&rules)) {
        let text = project::read(&file);
        let refused = programs(&text)
            .iter()
            .filter(|fence| !fence.says("wrong"))
            .any(|fence| !runs(&fence.text));
        match (refused, text.contains(NOT_RUN)) {
            (true, false) => problems.push(format!("{} should say `{NOT_RUN} ...`", file.display())),
            (false, true) => problems.push(format!("{}: all of it runs", file.display())),
            _ => {}
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn there_are_programs() {
    let count: usize = texts()
        .iter()
        .map(|file| programs(&project::read(file)).len())
        .sum();
    assert!(count > 100, "only {count} programs were found in the book");
}
