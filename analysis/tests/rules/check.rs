//! Shows what is found in a text the way a person reads it.

use expect_test::Expect;
use ladder_analysis::findings::fix;
use ladder_analysis::rules::rule_named;
use ladder_analysis::{AnalyzeOptions, Diagnostic, Exported, Level, Others, RuleSettings, analyze, exports};
use ladder_format::{Options, apply};
use ladder_syntax::{LineIndex, TextRange, parse};
use std::sync::Arc;

/// Rules about what a whole program lacks. A text of two lines that shows something else lacks much.
const ABOUT_WHOLE_PROGRAMS: [&str; 8] = [
    "never-read",
    "never-written",
    "set-without-reset",
    "reset-without-set",
    "unused-function",
    "unused-label",
    "unused-type",
    "never-reset",
];

/// Compares the findings, drawn under their lines, with what is expected. Each fix is shown by the lines that it
/// changes, and whether it is safe; it must make its finding go away.
pub(crate) fn check(text: &str, expected: Expect) {
    expected.assert_eq(&findings(text, &short_text()));
}

/// Nothing is found.
pub(crate) fn clean(text: &str) {
    assert_eq!(findings(text, &short_text()), "", "in:\n{text}");
}

/// As `check`, with every rule.
pub(crate) fn check_program(text: &str, expected: Expect) {
    expected.assert_eq(&findings(text, &RuleSettings::everything()));
}

/// As `clean`, with every rule.
pub(crate) fn clean_program(text: &str) {
    assert_eq!(findings(text, &RuleSettings::everything()), "", "in:\n{text}");
}

/// The messages of a rule, each with the line of its place. What else is wrong is that the state of a block is written, or nothing.
pub(crate) fn found(text: &str, rule: &str) -> Vec<String> {
    let index = LineIndex::new(text);
    let analysis = analyze(
        &Arc::new(parse(text)),
        AnalyzeOptions::new("test.clad")
            .among(&Others::default())
            .with_rules(&RuleSettings::everything()),
    );
    let found = analysis
        .diagnostics()
        .to_vec()
        .into_iter()
        .filter(|found| found.rule.name() == rule);
    let shown = found.map(|found| {
        let line = text
            .lines()
            .nth(index.line(found.range.start()))
            .unwrap_or_default();
        format!("{} <{}>", found.message, line.trim())
    });
    shown.collect()
}

fn short_text() -> RuleSettings {
    let mut settings = RuleSettings::default();
    for name in ABOUT_WHOLE_PROGRAMS {
        settings.set(rule_named(name).expect("a rule"), Level::Off);
    }
    settings
}

/// As [`check`], for the files of a workspace: each begins with a line `%% name.clad`.
pub(crate) fn check_files(texts: &str, expected: Expect) {
    check_files_with(texts, &short_text(), expected);
}

/// As `check_files`, with the rules about what a whole program lacks.
pub(crate) fn check_workspace(texts: &str, expected: Expect) {
    check_files_with(texts, &RuleSettings::default(), expected);
}

fn check_files_with(texts: &str, settings: &RuleSettings, expected: Expect) {
    let files = files(texts);
    let parsed: Vec<_> = files
        .iter()
        .map(|(name, text)| (*name, text, Arc::new(parse(text))))
        .collect();
    let summaries = parsed
        .iter()
        .map(|(name, _, parse)| Arc::new(exports(parse, name)));
    let exported = Arc::new(Exported::new(summaries.collect()));
    let mut shown = String::new();
    for (name, text, parse) in &parsed {
        let found = analyze(
            parse,
            AnalyzeOptions::new(name)
                .among(&exported.others_of(name))
                .with_rules(settings),
        )
        .diagnostics()
        .to_vec();
        if found.is_empty() {
            continue;
        }
        shown.push_str(&format!("== {name}\n"));
        let index = LineIndex::new(text);
        for mut diagnostic in found {
            let line = index.line(diagnostic.range.start());
            shown.push_str(&format!("> {}\n", text[index.range(line)].trim_end()));
            // Those in other files are shown with their text; fixes are tried where files are alone.
            let elsewhere: Vec<_> = diagnostic
                .related
                .extract_if(.., |place| place.file.is_some())
                .collect();
            diagnostic.fixes.clear();
            show(text, &index, &diagnostic, &mut shown);
            for place in elsewhere {
                let file = place.file.unwrap_or_default();
                let (_, text) = files.iter().find(|(name, _)| **name == *file).unwrap();
                let at = LineIndex::new(text).line_column(text, place.range.start());
                let marked = &text[place.range];
                shown.push_str(&format!(
                    "    at {file}:{}:{} `{marked}`: {}\n",
                    at.line, at.column, place.message
                ));
            }
        }
    }
    expected.assert_eq(&shown);
}

/// The names and texts of a fixture of several files.
pub(crate) fn files(texts: &str) -> Vec<(&str, String)> {
    let mut files: Vec<(&str, String)> = Vec::new();
    for line in texts.split_inclusive('\n') {
        match line.strip_prefix("%% ") {
            Some(name) => files.push((name.trim_end(), String::new())),
            None => files
                .last_mut()
                .expect("a fixture begins with `%% name`")
                .1
                .push_str(line),
        }
    }
    files
}

fn findings(text: &str, settings: &RuleSettings) -> String {
    let parsed = Arc::new(parse(text));
    let index = LineIndex::new(text);
    let mut shown = String::new();
    for diagnostic in analyze(
        &parsed,
        AnalyzeOptions::new("test.clad")
            .among(&Others::default())
            .with_rules(settings),
    )
    .diagnostics()
    {
        let line = index.line(diagnostic.range.start());
        // The mark keeps the indentation of the text.
        shown.push_str(&format!("> {}\n", text[index.range(line)].trim_end()));
        show(text, &index, diagnostic, &mut shown);
    }
    shown
}

fn show(text: &str, index: &LineIndex, found: &Diagnostic, out: &mut String) {
    out.push_str(&carets(text, index, found.range));
    out.push_str(&format!(
        " {}[{}]: {}\n",
        found.severity.name(),
        found.rule,
        found.message
    ));
    if let Some(help) = &found.help {
        out.push_str(&format!("    help: {help}\n"));
    }
    for related in &found.related {
        let place = index.line_column(text, related.range.start());
        let marked = text[related.range].lines().next().unwrap_or_default();
        out.push_str(&format!(
            "    at {}:{} `{marked}`: {}\n",
            place.line, place.column, related.message
        ));
    }
    for fix in &found.fixes {
        let fixed = apply(text, &fix::aligned(text, fix, &Options::default()));
        let sure = if fix.is_safe() { "safe " } else { "" };
        out.push_str(&format!("    {sure}fix: {}\n", fix.title));
        for (_, line) in changed_lines(text, &fixed) {
            out.push_str(format!("      {line}").trim_end());
            out.push('\n');
        }
        let (alone, everything) = (Others::default(), RuleSettings::everything());
        let again = analyze(
            &Arc::new(parse(&fixed)),
            AnalyzeOptions::new("test.clad")
                .among(&alone)
                .with_rules(&everything),
        )
        .diagnostics()
        .to_vec();
        let stays = again
            .iter()
            .any(|d| d.rule == found.rule && d.message == found.message && d.range == found.range);
        assert!(
            !stays,
            "the fix `{}` leaves the finding as it is:\n{fixed}",
            fix.title
        );
    }
}

/// The lines of `new` between those that both texts begin and end with.
fn changed_lines<'t>(old: &str, new: &'t str) -> Vec<(usize, &'t str)> {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let head = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let (old_rest, new_rest) = (&old[head..], &new[head..]);
    let tail = old_rest
        .iter()
        .rev()
        .zip(new_rest.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let end = new.len() - tail;
    new[head..end]
        .iter()
        .enumerate()
        .map(|(n, line)| (head + n, *line))
        .collect()
}

/// `^^^` under the range; up to the end of its first line.
fn carets(text: &str, index: &LineIndex, range: TextRange) -> String {
    let line = index.range(index.line(range.start()));
    let before = &text[usize::from(line.start())..usize::from(range.start())];
    let marked = &text[range];
    let marked = marked.split(['\n', '\r']).next().unwrap_or_default();
    let width = marked.chars().count().max(1);
    format!("  {}{}", " ".repeat(before.chars().count()), "^".repeat(width))
}
