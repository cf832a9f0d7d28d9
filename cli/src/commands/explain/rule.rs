//! The page of a rule, as the book has it.

use super::look::Look;
use super::markdown;
use ladder_analysis::Rule;
use ladder_ide::rule_page;
use std::io::{self, Write};

/// The rule of a name, as findings show it; capitals, and blanks or underscores for the hyphens, do not matter.
pub(super) fn find(name: &str) -> Option<Rule> {
    ladder_analysis::rules::rule_named(&name.trim().to_lowercase().replace(['_', ' '], "-"))
}

/// The first sentence of its page.
pub(super) fn summary(rule: Rule) -> String {
    let parts = rule_page(rule).split("\n\n");
    let first = parts
        .map(str::trim)
        .find(|part| !part.is_empty() && !part.starts_with('#'));
    let paragraph = first.unwrap_or_default().replace(['\n', '\r'], " ");
    match paragraph.split_once(". ") {
        Some((sentence, _)) => format!("{sentence}."),
        None => paragraph,
    }
}

/// The rules whose name has this word in it, as `coil` is in `double-coil`.
pub(super) fn with_word(word: &str) -> impl Iterator<Item = &'static str> {
    let word = word.trim().to_lowercase();
    let names = ladder_analysis::rules::ALL.iter().map(|rule| rule.name());
    names.filter(move |name| name.split('-').any(|part| part == word))
}

/// The name of a rule that is spelt almost like this.
pub(super) fn closest(name: &str) -> Option<&'static str> {
    ladder_analysis::rules::ALL
        .iter()
        .map(|rule| {
            (
                strsim::osa_distance(&name.to_lowercase(), rule.name()),
                rule.name(),
            )
        })
        // The names are long: a third of the letters may be wrong before it is another word.
        .filter(|(slips, rule)| *slips <= rule.len() / 3)
        .min_by_key(|(slips, _)| *slips)
        .map(|(_, rule)| rule)
}

/// Writes the page.
pub(super) fn print(rule: Rule, look: &Look, out: &mut impl Write) -> io::Result<()> {
    markdown::print(rule_page(rule).trim_end(), look, out)?;
    writeln!(
        out,
        "\n{heading}Severity{heading:#}\n\n{}{}",
        rule.default_severity().name(),
        if rule.on_by_default() {
            ""
        } else {
            "; off unless it is switched on"
        },
        heading = look.heading
    )
}
