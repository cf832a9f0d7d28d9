//! `[lint]`: how much the findings of a rule matter, in all files and in some.

use super::files::{covers, patterns};
use super::given::{Entry, Given, Value};
use super::reader::{Reader, Table, closest};
use super::table::OVERRIDES;
use ignore::gitignore::Gitignore;
use ladder_analysis::{Level, Rule, Severity};
use std::collections::BTreeMap;
use std::path::Path;

/// What is set for rules, by rule.
pub type Levels = BTreeMap<Rule, Level>;

/// What the findings of rules count as.
#[derive(Debug, Clone, Default)]
pub struct Lint {
    /// In all files.
    pub levels: Levels,
    /// In files that match these patterns; a later one wins.
    overrides: Vec<(Gitignore, Levels)>,
}

impl Lint {
    /// What holds in a program's file.
    pub(crate) fn levels_of(&self, program: &Path) -> Levels {
        let mut levels = self.levels.clone();
        for (files, own) in &self.overrides {
            if covers(files, program) {
                levels.extend(own);
            }
        }
        levels
    }
}

pub(super) fn read(mut table: Table, folder: &Path, reader: &mut Reader) -> Lint {
    let overrides = reader.take(&mut table, &OVERRIDES);
    Lint {
        levels: levels(table.entries(), reader),
        overrides: overrides.map_or_else(Vec::new, |given| {
            let tables = reader.tables(given, "[[lint.overrides]]", &["files"]);
            tables
                .into_iter()
                .map(|table| read_override(table, folder, reader))
                .collect()
        }),
    }
}

fn read_override(mut table: Table, folder: &Path, reader: &mut Reader) -> (Gitignore, Levels) {
    let files = table.take("files");
    if files.is_none() {
        let range = table.range();
        reader.wrong(range, "say which files are meant: files = [\"old/**\"]");
    }
    let files = files.map_or_else(Gitignore::empty, |given| {
        patterns(&given, "\"old/**\"", folder, reader)
    });
    (files, levels(table.entries(), reader))
}

fn levels(entries: impl Iterator<Item = Entry>, reader: &mut Reader) -> Levels {
    let mut levels = Levels::new();
    for Entry { key, range, given } in entries {
        let Some(rule) = ladder_analysis::rules::rule_named(&key) else {
            reader.wrong(range, unknown_rule(&key));
            continue;
        };
        if let Some(level) = level_of(&key, given, reader) {
            levels.insert(rule, level);
        }
    }
    levels
}

/// `"off"`, or `{ level = "off", reason = "the panel reads it" }`.
fn level_of(rule: &str, given: Given, reader: &mut Reader) -> Option<Level> {
    if !matches!(given.value, Value::Table(_)) {
        return level(&given, reader);
    }
    let mut table = Table::of(rule, given, &["level", "reason"])?;
    let found = table.take("level");
    if let Some(reason) = table.take("reason") {
        reader.text(&reason, "\"the panel reads it\"");
    }
    if found.is_none() {
        reader.wrong(
            table.range(),
            "say what the findings count as: { level = \"off\", reason = \"...\" }",
        );
    }
    table.finish(reader);
    level(&found?, reader)
}

fn level(given: &Given, reader: &mut Reader) -> Option<Level> {
    let name = reader.text(given, "\"warn\"")?;
    let level = match &*name {
        "error" => Level::Shown(Severity::Error),
        "warn" => Level::Shown(Severity::Warning),
        "info" => Level::Shown(Severity::Info),
        "off" => Level::Off,
        _ => {
            reader.wrong(
                given.range.clone(),
                format!("`{name}` is not a severity: write \"error\", \"warn\", \"info\" or \"off\""),
            );
            return None;
        }
    };
    Some(level)
}

fn unknown_rule(name: &str) -> String {
    let names: Vec<&str> = ladder_analysis::rules::ALL
        .iter()
        .map(|rule| rule.name())
        .collect();
    match closest(name, &names) {
        Some(near) => format!("`{name}` is not a rule: did you mean `{near}`?"),
        None => format!("`{name}` is not a rule; the reference of the rules lists them all"),
    }
}
