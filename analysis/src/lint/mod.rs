//! What becomes of findings before they are shown: the severities that a workspace asks for, and the comments that
//! switch rules off (LANGUAGE §7).

mod directive;
mod scope;
mod switches;

use crate::context::Context;
use crate::diagnostic::{Applicability, Diagnostic};
use crate::rule::{Rule, Severity};
use crate::rule_settings::{Level, RuleSettings};
use scope::Allow;
use switches::Switches;

/// Gives the findings their severities and takes those away that are switched off. What comes back are the errors
/// that are hidden or count as less now: a program with them does not run all the same.
pub(crate) fn apply(
    context: &Context,
    settings: &RuleSettings,
    findings: &mut Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    let mut allows = scope::allows(context, findings);
    let mut switches = Switches::of(&allows);
    let mut blocking = Vec::new();
    findings.retain_mut(|finding| {
        let shown = level(settings, finding).filter(|_| !switches.hide(finding));
        if finding.severity == Severity::Error && shown != Some(Severity::Error) {
            blocking.push(finding.clone());
        }
        if let Some(severity) = shown {
            finding.severity = severity;
        }
        shown.is_some()
    });
    switches.note_used(&mut allows);
    for allow in &allows {
        findings.extend(unused(allow, settings));
    }
    blocking
}

/// The severity that a finding has by the settings; none if its rule is off.
fn level(settings: &RuleSettings, finding: &Diagnostic) -> Option<Severity> {
    match settings.level(finding.rule) {
        None => Some(finding.severity),
        Some(Level::Shown(severity)) => Some(severity),
        // A rule that is off unless set may still have errors to tell.
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
