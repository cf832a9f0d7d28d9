//! A file, analysed.

use crate::cancel::Cancel;
use crate::checking::{self, Memo, keep_nearest};
use crate::cplc_draft;
use crate::findings::Finding;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Severity;
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::names::join;
use crate::other_files::others::Others;
use crate::program::Program;
use crate::resolve::{self, Resolved, numbers::Unit};
use ladder_syntax::{Parse, TextRange, TextSize};
use std::sync::{Arc, OnceLock};

/// What is known of a file.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// Names, networks and blocks.
    pub context: Arc<Context>,
    findings: Vec<Finding>,
    hidden_errors: Vec<Diagnostic>,
    /// The findings with all that they say, once they are asked for.
    diagnostics: OnceLock<Vec<Diagnostic>>,
    program: OnceLock<Option<Arc<Program>>>,
    others: Option<Arc<[Arc<Analysis>]>>,
    memo: Memo,
}

impl Analysis {
    /// What is found, in the order of the places.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Errors that settings or comments hide, or count as less, in the order of their places: the program does not run all the
    /// same.
    pub fn hidden_errors(&self) -> &[Diagnostic] {
        &self.hidden_errors
    }

    /// At most this many of the findings, in the order of their places: errors come before all others, and then what is near
    /// to a place.
    pub fn findings_near(&self, most: usize, place: TextSize) -> Vec<Finding> {
        let mut some = self.findings.clone();
        keep_nearest(&mut some, most, |found| {
            let away = u32::from(found.range.start()).abs_diff(u32::from(place));
            (found.severity != Severity::Error, away)
        });
        some
    }

    /// The findings with all that they say.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        let all = || self.findings.iter().map(Finding::diagnostic).collect();
        self.diagnostics.get_or_init(all)
    }

    /// Whether a finding is an error: the program is not simulated.
    pub fn has_errors(&self) -> bool {
        let is_error = |found: &Finding| found.severity == Severity::Error;
        !self.hidden_errors.is_empty() || self.findings.iter().any(is_error)
    }

    /// Where the text turns out to be in the first draft of the language, if that is what is wrong with it: the only finding
    /// says so then.
    pub fn cplc_draft(&self) -> Option<TextRange> {
        self.has_errors()
            .then(|| cplc_draft::beginning(&self.context.parse))?
    }

    /// The program, if there are no errors and it uses no function or block of another file: see
    /// `link`. It is put together when it is first asked for.
    pub fn program(&self) -> Option<&Arc<Program>> {
        let program = || {
            if self.has_errors() {
                return None;
            }
            let alone = Unit {
                context: &self.context,
                name: &self.context.name,
                bodies: None,
                plant: None,
            };
            let Resolved {
                program,
                unresolved,
                linked,
                ..
            } = resolve::program(&[alone]);
            (unresolved.is_none() && linked).then(|| Arc::new(program))
        };
        self.program.get_or_init(program).as_ref()
    }

    /// The same file with a program of several files, and the others of these.
    pub(crate) fn with_files(&self, program: Arc<Program>, others: Vec<Arc<Analysis>>) -> Analysis {
        Analysis {
            program: OnceLock::from(Some(program)),
            others: Some(others.into()),
            ..self.clone()
        }
    }

    /// The other files that its program is made of, if it [has](Analysis::with_others) them.
    pub fn others(&self) -> Option<&[Arc<Analysis>]> {
        self.others.as_deref()
    }

    /// What keeps the program from being simulated.
    pub fn errors(&self) -> impl Iterator<Item = &Diagnostic> {
        let shown = self.diagnostics().iter();
        let shown = shown.filter(|found| found.severity == Severity::Error);
        shown.chain(&self.hidden_errors)
    }
}

/// How a file is read and analysed. Its name alone is enough for one that is alone.
#[derive(Clone, Copy)]
pub struct AnalyzeOptions<'a> {
    name: &'a str,
    others: Option<&'a Others>,
    rules: Option<&'a RuleSettings>,
    known: Option<&'a Context>,
    memo: Option<&'a Memo>,
}

impl<'a> AnalyzeOptions<'a> {
    /// Alone, with all rules at their defaults. `name` is how messages call the file.
    pub fn new(name: &'a str) -> AnalyzeOptions<'a> {
        AnalyzeOptions {
            name,
            others: None,
            rules: None,
            known: None,
            memo: None,
        }
    }

    /// Among the others of its workspace, whose [`Exports`](crate::Exports) go by the same names.
    #[must_use]
    pub fn among(mut self, others: &'a Others) -> AnalyzeOptions<'a> {
        self.others = Some(others);
        self
    }

    /// With settings of the rules.
    #[must_use]
    pub fn with_rules(mut self, rules: &'a RuleSettings) -> AnalyzeOptions<'a> {
        self.rules = Some(rules);
        self
    }

    /// For a text that came from another one by edits: what both have is taken over from the analysis of the earlier one. What
    /// comes out does not depend on it.
    #[must_use]
    pub fn after(mut self, before: Option<&'a Analysis>) -> AnalyzeOptions<'a> {
        self.memo = before.map(|before| &before.memo);
        self.after_context(before.map(|before| &*before.context))
    }

    /// As [`AnalyzeOptions::after`], where only names, networks and blocks of the earlier text are known.
    #[must_use]
    pub fn after_context(mut self, before: Option<&'a Context>) -> AnalyzeOptions<'a> {
        self.known = before;
        self
    }

    /// As [`context()`]; none once it is cancelled, about which it asks between each [`BETWEEN`](crate::BETWEEN) networks, tags or
    /// declarations.
    pub fn context_unless(self, parse: &Arc<Parse>, cancel: &Cancel) -> Option<Context> {
        let alone = Others::alone();
        let others = self.others.unwrap_or(&alone);
        join::read(parse, self.name, others, self.known, &cancel.clone())
    }

    /// Looks for what is wrong in a file whose context is known; none once it is cancelled.
    pub fn check_unless(self, context: Arc<Context>, cancel: &Cancel) -> Option<Analysis> {
        let (no_memo, defaults) = (Memo::default(), RuleSettings::default());
        let (memo, rules) = (self.memo.unwrap_or(&no_memo), self.rules.unwrap_or(&defaults));
        let found = checking::find(memo, &context, rules, &cancel.clone())?;
        Some(Analysis {
            context,
            findings: found.shown,
            hidden_errors: found.hidden_errors,
            diagnostics: OnceLock::new(),
            program: OnceLock::new(),
            others: None,
            memo: found.memo,
        })
    }
}

impl<'a, T: AsRef<str> + ?Sized> From<&'a T> for AnalyzeOptions<'a> {
    fn from(name: &'a T) -> AnalyzeOptions<'a> {
        AnalyzeOptions::new(name.as_ref())
    }
}

const NOT_CANCELLED: &str = "nothing cancels it";

/// Reads a file's names, networks and blocks.
pub fn context<'a>(parse: &Arc<Parse>, options: impl Into<AnalyzeOptions<'a>>) -> Context {
    options
        .into()
        .context_unless(parse, &Cancel::default())
        .expect(NOT_CANCELLED)
}

/// Analyses a file.
pub fn analyze<'a>(parse: &Arc<Parse>, options: impl Into<AnalyzeOptions<'a>>) -> Analysis {
    let options = options.into();
    let context = Arc::new(context(parse, options));
    options
        .check_unless(context, &Cancel::default())
        .expect(NOT_CANCELLED)
}
