//! What a rule is: its name, group and default severity (LANGUAGE §7), and when what it finds is true. Each is in the file of the
//! rule, and the list of all is [`rules::ALL`](crate::rules::ALL).

use super::diagnostic::Applicability;
use std::fmt;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing.
    Info,
    /// Probably an error.
    Warning,
    /// The program is not simulated.
    Error,
}

impl Severity {
    /// `error`, `warning`, `info`.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Info => "info",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// What a rule is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum RuleGroup {
    Text,
    Connectors,
    Blocks,
    Names,
    Wiring,
    Program,
}

impl RuleGroup {
    /// All of them, in the order of the reference.
    pub const ALL: [RuleGroup; 6] = [
        RuleGroup::Text,
        RuleGroup::Connectors,
        RuleGroup::Blocks,
        RuleGroup::Names,
        RuleGroup::Wiring,
        RuleGroup::Program,
    ];

    /// The heading that its rules are under.
    pub const fn title(self) -> &'static str {
        match self {
            RuleGroup::Text => "Text",
            RuleGroup::Connectors => "Connectors",
            RuleGroup::Blocks => "Blocks",
            RuleGroup::Names => "Names",
            RuleGroup::Wiring => "Wiring",
            RuleGroup::Program => "The program",
        }
    }
}

/// A rule. Its name is stable: people write it in settings and in comments that switch it off.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Rule(pub(crate) &'static RuleFacts);

/// All that a rule's file says of it, besides what it finds.
#[derive(PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct RuleFacts {
    group: RuleGroup,
    name: &'static str,
    severity: Severity,
    fixed: Option<Applicability>,
    on: bool,
    when: When,
    about_types: bool,
    without_effect: bool,
    /// It is about comments that speak to the tools.
    about_directives: bool,
    /// An error that is none where a comment allows it, see [`RuleFacts::runs_if_allowed`].
    runs_if_allowed: bool,
}

impl RuleFacts {
    /// A rule that looks unless it is set otherwise, and is always right.
    pub(crate) const fn new(group: RuleGroup, name: &'static str, severity: Severity) -> RuleFacts {
        RuleFacts {
            group,
            name,
            severity,
            fixed: None,
            on: true,
            when: When::Always,
            about_types: false,
            without_effect: false,
            about_directives: false,
            runs_if_allowed: false,
        }
    }

    /// Its findings come with fixes, of which the best may be made so.
    pub(crate) const fn fixed(self, best: Applicability) -> RuleFacts {
        RuleFacts {
            fixed: Some(best),
            ..self
        }
    }

    /// It is a matter of taste: it looks only where it is switched on.
    pub(crate) const fn off(self) -> RuleFacts {
        RuleFacts { on: false, ..self }
    }

    /// What it finds is true only then.
    pub(crate) const fn when(self, when: When) -> RuleFacts {
        RuleFacts { when, ..self }
    }

    /// What it finds at a block depends on how the tags are declared that the block names.
    pub(crate) const fn about_types(self) -> RuleFacts {
        RuleFacts {
            about_types: true,
            ..self
        }
    }

    /// It is about the comments that say how the program is to be read.
    pub(crate) const fn about_directives(self) -> RuleFacts {
        RuleFacts {
            about_directives: true,
            ..self
        }
    }

    /// What it finds has a meaning, which is hardly ever what was meant: where a comment allows it the program runs.
    pub(crate) const fn runs_if_allowed(self) -> RuleFacts {
        RuleFacts {
            runs_if_allowed: true,
            ..self
        }
    }

    /// It finds text that has no effect.
    pub(crate) const fn without_effect(self) -> RuleFacts {
        RuleFacts {
            without_effect: true,
            ..self
        }
    }
}

impl Rule {
    /// Whether a comment or a setting may switch it off: not what is an error, for a program with a hidden error does not run either,
    /// nor what is found about such comments themselves.
    pub const fn may_be_switched_off(self) -> bool {
        !matches!(self.0.severity, Severity::Error) && !self.0.about_directives
    }

    /// Whether a comment may: also what is an error only where no comment allows it.
    pub const fn may_be_allowed(self) -> bool {
        self.may_be_switched_off() || self.0.runs_if_allowed
    }

    /// Whether a program runs in which a comment allows what it finds, though that is an error.
    pub(crate) const fn runs_if_allowed(self) -> bool {
        self.0.runs_if_allowed
    }

    /// The name in kebab case.
    pub const fn name(self) -> &'static str {
        self.0.name
    }

    /// What it is about.
    pub const fn group(self) -> RuleGroup {
        self.0.group
    }

    /// How much its findings matter unless set otherwise.
    pub const fn default_severity(self) -> Severity {
        self.0.severity
    }

    /// How the best fix of its findings may be made, if they come with one.
    pub const fn fixed(self) -> Option<Applicability> {
        self.0.fixed
    }

    /// Whether it looks for findings unless set otherwise. What is a matter of taste is off.
    pub const fn on_by_default(self) -> bool {
        self.0.on
    }

    /// Whether what it finds is text without effect, which editors show faded.
    pub const fn is_about_no_effect(self) -> bool {
        self.0.without_effect
    }

    /// When what it finds is true.
    pub(crate) const fn when(self) -> When {
        self.0.when
    }

    /// Whether what it finds at a block depends on how the tags are declared that the block names.
    pub(crate) const fn is_about_types(self) -> bool {
        self.0.about_types
    }
}

impl fmt::Debug for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What is known of the file as a whole.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Known {
    /// Everything could be read, every block is known and nothing is an error: what the text does not hold is not there.
    pub(crate) whole: bool,
    /// No tag is undeclared that should not be: a slip in a name is one finding.
    pub(crate) names: bool,
}

/// When what a rule finds is true.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum When {
    Always,
    /// Where the file as a whole is known.
    Whole,
    /// Where its names are known too.
    WholeAndNames,
}

impl When {
    /// Whether it is true where so much is known.
    pub(crate) const fn holds(self, known: Known) -> bool {
        match self {
            When::Always => true,
            When::Whole => known.whole,
            When::WholeAndNames => known.whole && known.names,
        }
    }
}
