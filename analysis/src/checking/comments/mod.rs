//! The comments that speak to the tools, and what those that switch rules off hide (LANGUAGE §7).

mod directive;
mod scope;
mod switches;
mod unread_names;

use scope::{Allow, Directives, directives, idle_words};

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Rule;
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::rules::suppression_unused;
use ladder_syntax::{TextRange, TextSize};
use switches::Switches;

/// The comments of a file that switch rules off, while all of its findings are gone through.
pub(crate) struct Allows<'c> {
    context: &'c Context,
    all: Vec<Allow>,
    switches: Switches,
}

impl<'c> Allows<'c> {
    /// Those of a file. What is wrong with directives goes to `out`.
    pub(crate) fn of(context: &'c Context, out: &mut Vec<Diagnostic>) -> Allows<'c> {
        let Directives {
            allows, says, wrong, ..
        } = directives(context);
        out.extend(wrong);
        out.extend(idle_words(context, says.into_iter()));
        let switches = Switches::of(context, &allows);
        Allows {
            context,
            all: allows,
            switches,
        }
    }

    /// Whether a comment hides what a rule finds at a place.
    pub(crate) fn hide(&mut self, rule: Rule, at: TextSize) -> bool {
        if self.all.is_empty() {
            return false;
        }
        let line = self.context.parse.line_at(at);
        self.switches.hide(rule, line.unwrap_or_default())
    }

    /// The comments that hide nothing, once all findings are gone through. Nobody knows that of a rule that is silent.
    pub(crate) fn unused(self, is_silent: impl Fn(Rule) -> bool, settings: &RuleSettings) -> Vec<Diagnostic> {
        let of_allow = |allow: &Allow| {
            let covers = allow.covers.lines(self.context);
            let is_used = |rule| is_silent(rule) || self.switches.is_used(covers.as_ref(), rule);
            unused(&allow.rules, is_used, (allow.comment, allow.removal), settings)
        };
        self.all.iter().filter_map(of_allow).collect()
    }
}

/// A comment that switches off what finds nothing. `removal` is what to take out to be rid of it.
fn unused(
    rules: &[Rule],
    is_used: impl Fn(Rule) -> bool,
    (comment, removal): (TextRange, Option<TextRange>),
    settings: &RuleSettings,
) -> Option<Diagnostic> {
    let severity = settings.severity_of(
        suppression_unused::RULE,
        suppression_unused::RULE.default_severity(),
    )?;
    let idle = rules.iter().filter(|rule| !is_used(**rule));
    let names: Vec<String> = idle.map(|rule| format!("`{}`", rule.name())).collect();
    if names.is_empty() {
        return None;
    }
    let all = names.len() == rules.len();
    let mut found = Diagnostic::new(
        suppression_unused::RULE,
        comment,
        format!(
            "{} {} nothing here that could be switched off",
            names.join(", "),
            if names.len() == 1 { "finds" } else { "find" }
        ),
    )
    .help("remove it: it would hide an error that is made later");
    found.severity = severity;
    Some(match removal.filter(|_| all) {
        Some(line) => found.fix(Applicability::Safe, "Remove the comment", line, ""),
        None => found,
    })
}
