//! What becomes of findings before they are shown: the severities that a workspace asks for, and the comments that
//! switch rules off (LANGUAGE §7).

mod directive;
mod scope;
mod switches;

use crate::context::Context;
use crate::diagnostic::{Applicability, Diagnostic};
use crate::rule::{Rule, Severity};
use crate::rule_settings::{Level, RuleSettings};
use ladder_syntax::TextSize;
use scope::Allow;
use switches::Switches;

/// The comments of a file that switch rules off, while its findings are gone through.
pub(crate) struct Allows {
    allows: Vec<Allow>,
    switches: Switches,
}

impl Allows {
    /// None in a file without comments to the tools.
    pub(crate) fn none() -> Allows {
        Allows {
            allows: Vec::new(),
            switches: Switches::of(&[]),
        }
    }

    /// Those of a file, of which these are the lines with directives. What is wrong with directives goes to `out`.
    pub(crate) fn of(
        context: &Context,
        asking: impl Iterator<Item = usize>,
        out: &mut Vec<Diagnostic>,
    ) -> Allows {
        let allows = scope::allows(context, asking, out);
        let switches = Switches::of(&allows);
        Allows { allows, switches }
    }

    /// Whether a comment hides what a rule finds at a place.
    pub(crate) fn hide(&mut self, rule: Rule, at: TextSize) -> bool {
        !self.allows.is_empty() && self.switches.hide(rule, at)
    }

    /// The comments that hide nothing, once all findings are gone through.
    pub(crate) fn unused(mut self, settings: &RuleSettings) -> Vec<Diagnostic> {
        self.switches.note_used(&mut self.allows);
        let unused = self.allows.iter().filter_map(|allow| unused(allow, settings));
        unused.collect()
    }
}

/// The severity that a finding has by the settings; none if its rule is off.
pub(crate) fn level(settings: &RuleSettings, rule: Rule, severity: Severity) -> Option<Severity> {
    match settings.level(rule) {
        None => Some(severity),
        Some(Level::Shown(severity)) => Some(severity),
        // A rule that is off unless set may still have errors to report.
        Some(Level::Off) => None,
    }
}

/// A comment that switches off what finds nothing.
fn unused(allow: &Allow, settings: &RuleSettings) -> Option<Diagnostic> {
    let severity = match settings.level(Rule::SuppressionUnused) {
        None => Rule::SuppressionUnused.default_severity(),
        Some(Level::Shown(severity)) => severity,
        Some(Level::Off) => return None,
    };
    let idle: Vec<&str> = allow
        .rules
        .iter()
        .filter(|switched| !switched.used)
        .map(|switched| switched.rule.name())
        .collect();
    if idle.is_empty() {
        return None;
    }
    let all = idle.len() == allow.rules.len();
    let names: Vec<String> = idle.iter().map(|name| format!("`{name}`")).collect();
    let mut found = Diagnostic::new(
        Rule::SuppressionUnused,
        allow.comment,
        format!(
            "{} {} nothing here that could be switched off",
            names.join(", "),
            if names.len() == 1 { "finds" } else { "find" }
        ),
    )
    .help("remove it: it would hide a mistake that is made later");
    found.severity = severity;
    Some(match allow.removal.filter(|_| all) {
        Some(line) => found.fix(Applicability::Safe, "Remove the comment", line, ""),
        None => found,
    })
}
