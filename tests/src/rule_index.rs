//! The page of the book that lists all rules, made from the rules themselves.

use crate::book::source;
use crate::project;
use ladder_analysis::{Rule, RuleGroup};
use std::fmt::Write;

const INTRODUCTION: &str = "\
# Rules

`ladder check` and the editors report what looks wrong as **findings**. Every finding belongs to a rule, and every rule has a
name that does not change. A finding names the thing, says what to do, shows the other places that have to do with it, and
offers a fix where there is one.

| severity | means |
| --- | --- |
| error | the program does not run |
| warning | it runs, but this is probably an error |
| info | worth knowing |
| off | a matter of taste: found only where it is switched on |
";

/// The text of the page.
pub fn text() -> String {
    let mut out = INTRODUCTION.to_owned();
    for group in RuleGroup::ALL {
        let title = group.title();
        // Writing to a String does not fail.
        let _ = write!(
            out,
            "\n## {title}\n\n| rule | severity | |\n| --- | --- | --- |\n"
        );
        for rule in ladder_analysis::rules::ALL
            .iter()
            .copied()
            .filter(|rule| rule.group() == group)
        {
            let severity = if rule.on_by_default() {
                rule.default_severity().name()
            } else {
                "off"
            };
            let _ = writeln!(out, "| {} | {severity} | {} |", link(rule), summary(rule));
        }
    }
    out
}

fn link(rule: Rule) -> String {
    let name = rule.name();
    if page(rule).exists() {
        format!("[`{name}`]({name}.md)")
    } else {
        format!("`{name}`")
    }
}

/// The first sentence after the heading of the rule's own page, as Markdown for a table.
pub fn summary(rule: Rule) -> String {
    let page = page(rule);
    if !page.exists() {
        return String::new();
    }
    let text = project::read(&page);
    let first = text
        .split("\n\n")
        .find(|part| !part.trim().is_empty() && !part.starts_with('#'));
    let paragraph = first
        .unwrap_or_default()
        .replace(['\n', '\r'], " ")
        .replace('|', "\\|");
    match paragraph.split_once(". ") {
        Some((sentence, _)) => format!("{sentence}."),
        None => paragraph,
    }
}

fn page(rule: Rule) -> std::path::PathBuf {
    source().join("rules").join(format!("{}.md", rule.name()))
}
