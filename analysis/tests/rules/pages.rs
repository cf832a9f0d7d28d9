//! The pages of the rules: each shows a wrong and a right program, and both are what they say.

use ladder_analysis::findings::fix;
use ladder_analysis::{AnalyzeOptions, Diagnostic, Others, Rule, RuleSettings, Severity, analyze};
use ladder_format::{Options, apply, format_text};
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

/// What every rule finds, also those that are off unless set.
fn found(program: &str) -> Vec<Diagnostic> {
    analyze(
        &Arc::new(parse(program)),
        AnalyzeOptions::new("page.clad")
            .among(&Others::default())
            .with_rules(&RuleSettings::everything()),
    )
    .diagnostics()
    .to_vec()
}

/// The headings of a page, in their order.
const SECTIONS: [&str; 5] = [
    "## Wrong",
    "## Right",
    "## What to do",
    "## Switching it off",
    "## In other tools",
];

#[test]
fn every_rule_has_a_page_that_holds_true() {
    let mut problems = Vec::new();
    for &rule in ladder_analysis::rules::ALL {
        let Ok(text) = std::fs::read_to_string(page(rule)) else {
            problems.push(format!("{rule}: there is no page"));
            continue;
        };
        let (wrong, right) = (programs(&text, "wrong"), programs(&text, "right"));
        if wrong.is_empty() || right.is_empty() {
            problems.push(format!("{rule}: a wrong or a right program is missing"));
        }
        for program in &wrong {
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
    let folder = page(ladder_analysis::rules::rule_named("open-wire").expect("a rule"));
    let folder = folder.parent().expect("a page is in a folder");
    let mut strays: Vec<String> = std::fs::read_dir(folder)
        .expect("the pages are there")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name != "index.md")
        .filter(|name| {
            name.strip_suffix(".md")
                .and_then(ladder_analysis::rules::rule_named)
                .is_none()
        })
        .collect();
    strays.sort();
    assert!(strays.is_empty(), "{strays:?}");
}

/// What is wrong, why that matters, a wrong and a right rung, what to do, how to switch it off, and how others
/// call it: in this order on every page.
#[test]
fn every_page_tells_all() {
    let mut problems = Vec::new();
    for &rule in ladder_analysis::rules::ALL {
        let Ok(text) = std::fs::read_to_string(page(rule)) else {
            problems.push(format!("{rule}: there is no page"));
            continue;
        };
        let headings: Vec<&str> = text.lines().filter(|line| line.starts_with("## ")).collect();
        if headings != SECTIONS {
            problems.push(format!("{rule}: its sections are {headings:?}"));
        }
        let introduction = text.split("## Wrong").next().unwrap_or_default();
        // The heading, what is wrong, why it matters on a machine.
        let paragraphs = introduction.split("\n\n").filter(|part| !part.trim().is_empty());
        if !text.starts_with(&format!("# `{rule}`\n")) || paragraphs.count() < 3 {
            problems.push(format!("{rule}: what is wrong and why it matters are missing"));
        }
        let off = text.split("## Switching it off").nth(1).unwrap_or_default();
        let ways = [
            format!("# ladder: allow({rule}): reason #"),
            format!("# ladder: allow-file({rule}): reason #"),
            format!("[lint]\n{rule} = "),
        ];
        for way in ways.iter().filter(|way| !off.contains(way.as_str())) {
            problems.push(format!("{rule}: `{way}` is missing"));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// A rule says how the best fix of its findings may be made: the wrong programs of its page show it.
#[test]
fn rules_fix_their_wrong_programs_as_they_say() {
    let mut problems = Vec::new();
    for &rule in ladder_analysis::rules::ALL {
        let Some(expected) = rule.fixed() else { continue };
        let text = std::fs::read_to_string(page(rule)).unwrap_or_default();
        let mut best = None;
        for program in programs(&text, "wrong") {
            let found = found(program).into_iter().filter(|found| found.rule == rule);
            let fixes: Vec<_> = found.flat_map(|found| found.fixes).collect();
            if fixes.is_empty() {
                problems.push(format!("{rule}: no fix for\n{program}"));
            }
            best = fixes.iter().map(|fix| fix.applicability).chain(best).min();
        }
        if best.is_some_and(|best| best < expected) {
            problems.push(format!(
                "{rule}: a fix is {}",
                best.map_or("", |best| best.name())
            ));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Over all wrong programs: a fix takes its finding away, brings no error but the place of what a person has to write,
/// and leaves what it touches in the canonical layout.
#[test]
fn fixes_are_safe_and_leave_the_drawing_aligned() {
    let mut problems = Vec::new();
    for &rule in ladder_analysis::rules::ALL {
        let text = std::fs::read_to_string(page(rule)).unwrap_or_default();
        for program in programs(&text, "wrong") {
            // A page's program need not be in the canonical layout.
            let canonical = format_text(program, &Options::default());
            let shows_it = found(&canonical).iter().any(|d| d.rule == rule);
            let program = if shows_it { &canonical } else { program };
            let before = found(program);
            for finding in &before {
                for fix in &finding.fixes {
                    let fixed = apply(program, &fix::aligned(program, fix, &Options::default()));
                    let problem = unsafe_fix(program, &before, finding, &fixed);
                    problems.extend(problem.map(|problem| {
                        format!(
                            "{}: `{}` {problem}:\n{program}\nbecomes\n{fixed}",
                            finding.rule, fix.title
                        )
                    }));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

fn unsafe_fix(program: &str, before: &[Diagnostic], finding: &Diagnostic, fixed: &str) -> Option<String> {
    let after = found(fixed);
    let of_rule = |found: &[Diagnostic]| found.iter().filter(|d| d.rule == finding.rule).count();
    if of_rule(&after) >= of_rule(before) {
        return Some("leaves its finding".to_owned());
    }
    let errors = |found: &[Diagnostic]| found.iter().filter(|d| d.severity == Severity::Error).count();
    let first_new = after
        .iter()
        .filter(|d| !d.message.ends_with("holds its place"))
        .find(|d| d.severity == Severity::Error && before.iter().all(|b| b.message != d.message));
    if let Some(new) = first_new.filter(|_| errors(&after) >= errors(before)) {
        return Some(format!("brings the error {}: {}", new.rule, new.message));
    }
    let (old, formatted) = (program, format_text(fixed, &Options::default()));
    let crooked = fixed
        .lines()
        .find(|line| old.lines().all(|old| old != *line) && formatted.lines().all(|other| other != *line));
    crooked.map(|line| format!("leaves the line `{line}` crooked"))
}
