//! A rule is switched off in the text of a settings file: the edit that a person would make in `[lint]`.

use super::Settings;
use super::table::LINT;
use ladder_analysis::{Level, Rule};
use ladder_format::{Edit, apply};
use ladder_syntax::{TextRange, TextSize};
use std::path::Path;
use toml::de::{DeTable, DeValue};

impl Settings {
    /// The edit of a settings file's text that switches a rule off. None if it is off, or if the text is written so that no
    /// small edit does it.
    pub fn switch_off(file: &Path, text: &str, rule: Rule) -> Option<Edit> {
        let document = DeTable::parse(text).ok()?;
        let lint = document.get_ref().get(LINT.name);
        let set = lint.and_then(|lint| lint.get_ref().get(rule.name()));
        let edit = match set {
            Some(set) => {
                // Of a table with a reason only the level.
                let value = match set.get_ref() {
                    DeValue::Table(table) => table.get("level")?,
                    _ => set,
                };
                Edit {
                    range: range(value.span())?,
                    text: "\"off\"".to_owned(),
                }
            }
            None => added(text, rule)?,
        };
        // Whatever way it was written: only what says so is right.
        let (before, wrong) = Settings::examine(file, text);
        let (after, still) = Settings::examine(file, &apply(text, std::slice::from_ref(&edit)));
        let is_off = |settings: &Settings| settings.lint.levels.get(&rule) == Some(&Level::Off);
        (!is_off(&before) && is_off(&after) && still.len() <= wrong.len()).then_some(edit)
    }
}

/// A line for the rule below the header of `[lint]`, or with that at the end of the file.
fn added(text: &str, rule: Rule) -> Option<Edit> {
    let line_end = match text.lines().next() {
        Some(first) if text[first.len()..].starts_with("\r\n") => "\r\n",
        _ => "\n",
    };
    let setting = format!("{} = \"off\"{line_end}", rule.name());
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        at += line.len();
        if !is_header(line) {
            continue;
        }
        let before = if line.ends_with('\n') { "" } else { line_end };
        return Some(Edit {
            range: range(at..at)?,
            text: format!("{before}{setting}"),
        });
    }
    let before = if text.is_empty() {
        String::new()
    } else if text.ends_with('\n') {
        line_end.to_owned()
    } else {
        line_end.repeat(2)
    };
    Some(Edit {
        range: range(text.len()..text.len())?,
        text: format!("{before}[{}]{line_end}{setting}", LINT.name),
    })
}

/// Whether a line is `[lint]`, with or without a comment.
fn is_header(line: &str) -> bool {
    let header = line.split('#').next().unwrap_or_default().trim();
    let name = header.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    name.is_some_and(|name| name.trim() == LINT.name)
}

fn range(bytes: std::ops::Range<usize>) -> Option<TextRange> {
    let offset = |at: usize| u32::try_from(at).ok().map(TextSize::new);
    Some(TextRange::new(offset(bytes.start)?, offset(bytes.end)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let rule = ladder_analysis::rules::rule_named("double-coil").expect("a rule");
        let after = match Settings::switch_off(Path::new("/plant/ladder.toml"), text, rule) {
            Some(edit) => apply(text, &[edit]),
            None => "no edit\n".to_owned(),
        };
        expected.assert_eq(&after);
    }

    #[test]
    fn the_section_is_there() {
        check(
            "[format]\nwidth = 100\n\n[lint] # ours\nnever-read = \"off\"\n\n[simulate]\ninterval = \"5ms\"\n",
            expect![[r#"
                [format]
                width = 100

                [lint] # ours
                double-coil = "off"
                never-read = "off"

                [simulate]
                interval = "5ms"
            "#]],
        );
        check(
            "[lint]",
            expect![[r#"
            [lint]
            double-coil = "off"
        "#]],
        );
    }

    #[test]
    fn there_is_no_section() {
        check(
            "",
            expect![[r#"
            [lint]
            double-coil = "off"
        "#]],
        );
        check(
            "[format]\nwidth = 100",
            expect![[r#"
            [format]
            width = 100

            [lint]
            double-coil = "off"
        "#]],
        );
        check(
            "[[lint.overrides]]\nfiles = [\"old/**\"]\ndouble-coil = \"info\"\n",
            expect![[r#"
                [[lint.overrides]]
                files = ["old/**"]
                double-coil = "info"

                [lint]
                double-coil = "off"
            "#]],
        );
    }

    #[test]
    fn the_rule_is_set() {
        check(
            "[lint]\ndouble-coil = \"error\" # for now\n",
            expect![[r#"
            [lint]
            double-coil = "off" # for now
        "#]],
        );
        check(
            "[lint]\ndouble-coil = { level = \"warn\", reason = \"the panel\" }\n",
            expect![[r#"
                [lint]
                double-coil = { level = "off", reason = "the panel" }
            "#]],
        );
        check(
            "lint.double-coil = \"info\"\n",
            expect![[r#"
            lint.double-coil = "off"
        "#]],
        );
        check(
            "[lint]\ndouble-coil = \"off\"\n",
            expect![[r#"
            no edit
        "#]],
        );
    }

    #[test]
    fn what_cannot_be_done_by_a_small_edit() {
        check(
            "lint = { never-read = \"off\" }\n",
            expect![[r#"
            no edit
        "#]],
        );
        check(
            "[lint\n",
            expect![[r#"
            no edit
        "#]],
        );
    }
}
