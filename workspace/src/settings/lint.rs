//! `[lint]`: how much the findings of a rule matter.

use super::reader::{Reader, Table, closest};
use ladder_analysis::{Rule, Severity};
use std::collections::BTreeMap;

/// What a rule's findings count as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LintLevel {
    /// They are shown with this severity.
    Shown(Severity),
    /// They are not looked for.
    Off,
}

pub(super) fn read<'t>(table: Table<'t>, reader: &mut Reader<'t>) -> BTreeMap<Rule, LintLevel> {
    let mut levels = BTreeMap::new();
    for (key, given) in table.entries() {
        let Some(rule) = Rule::from_name(key.get_ref()) else {
            reader.wrong(key.span(), unknown_rule(key.get_ref()));
            continue;
        };
        let Some(level) = reader.string(&given, "\"warn\"") else {
            continue;
        };
        match LintLevel::from_name(&level) {
            Some(level) => {
                levels.insert(rule, level);
            }
            None => reader.wrong(
                given.span(),
                format!("`{level}` is no severity: write \"error\", \"warn\", \"info\" or \"off\""),
            ),
        }
    }
    levels
}

impl LintLevel {
    fn from_name(name: &str) -> Option<LintLevel> {
        Some(match name {
            "error" => LintLevel::Shown(Severity::Error),
            "warn" => LintLevel::Shown(Severity::Warning),
            "info" => LintLevel::Shown(Severity::Info),
            "off" => LintLevel::Off,
            _ => return None,
        })
    }
}

fn unknown_rule(name: &str) -> String {
    let names: Vec<&str> = Rule::ALL.iter().map(|rule| rule.name()).collect();
    match closest(name, &names) {
        Some(near) => format!("`{name}` is no rule: did you mean `{near}`?"),
        None => format!("`{name}` is no rule; the reference of the rules lists them all"),
    }
}
