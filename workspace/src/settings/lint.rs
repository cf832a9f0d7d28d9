//! `[lint]`: how much the findings of a rule matter, in all files and in some.

use super::files::{covers, patterns};
use super::reader::{Given, Reader, Table, closest};
use ignore::gitignore::Gitignore;
use ladder_analysis::{Level, Rule, Severity};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;
use toml::Spanned;

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
    pub fn levels_of(&self, program: &Path) -> Levels {
        let mut levels = self.levels.clone();
        for (files, own) in &self.overrides {
            if covers(files, program) {
                levels.extend(own);
            }
        }
        levels
    }
}

pub(super) fn read<'t>(mut table: Table<'t>, folder: &Path, reader: &mut Reader<'t>) -> Lint {
    let overrides = table.take("overrides");
    Lint {
        levels: levels(table.entries(), reader),
        overrides: overrides.map_or_else(Vec::new, |given| {
            let tables = reader.tables(given, "[[lint.overrides]]");
            tables
                .into_iter()
                .map(|mut table| {
                    let files = table.take("files");
                    if files.is_none() {
                        let span = table.span();
                        reader.wrong(span, "say which files are meant: files = [\"old/**\"]");
                    }
                    let files = files.map_or_else(Gitignore::empty, |given| {
                        patterns(&given, "\"old/**\"", folder, reader)
                    });
                    (files, levels(table.entries(), reader))
                })
                .collect()
        }),
    }
}

fn levels<'t>(
    entries: impl Iterator<Item = (Spanned<Cow<'t, str>>, Given<'t>)>,
    reader: &mut Reader<'t>,
) -> Levels {
    let mut levels = Levels::new();
    for (key, given) in entries {
        let Some(rule) = Rule::from_name(key.get_ref()) else {
            reader.wrong(key.span(), unknown_rule(key.get_ref()));
            continue;
        };
        if let Some(level) = level_of(key.get_ref(), given, reader) {
            levels.insert(rule, level);
        }
    }
    levels
}

/// `"off"`, or `{ level = "off", reason = "the panel reads it" }`.
fn level_of<'t>(rule: &str, given: Given<'t>, reader: &mut Reader<'t>) -> Option<Level> {
    let Some(mut table) = Table::inline(rule, &given) else {
        return level(&given, reader);
    };
    let found = table.take("level");
    if let Some(reason) = table.take("reason") {
        reader.string(&reason, "\"the panel reads it\"");
    }
    if found.is_none() {
        reader.wrong(
            given.span(),
            "say what the findings count as: { level = \"off\", reason = \"...\" }",
        );
    }
    table.finish(reader);
    level(&found?, reader)
}

fn level<'t>(given: &Given<'t>, reader: &mut Reader<'t>) -> Option<Level> {
    let name = reader.string(given, "\"warn\"")?;
    let level = match &*name {
        "error" => Level::Shown(Severity::Error),
        "warn" => Level::Shown(Severity::Warning),
        "info" => Level::Shown(Severity::Info),
        "off" => Level::Off,
        _ => {
            reader.wrong(
                given.span(),
                format!("`{name}` is no severity: write \"error\", \"warn\", \"info\" or \"off\""),
            );
            return None;
        }
    };
    Some(level)
}

fn unknown_rule(name: &str) -> String {
    let names: Vec<&str> = Rule::ALL.iter().map(|rule| rule.name()).collect();
    match closest(name, &names) {
        Some(near) => format!("`{name}` is no rule: did you mean `{near}`?"),
        None => format!("`{name}` is no rule; the reference of the rules lists them all"),
    }
}
