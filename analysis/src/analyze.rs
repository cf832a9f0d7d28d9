//! A file, analysed.

use crate::checking::{self, Ledger, Shown, Work};
use crate::context::{Context, context_after};
use crate::diagnostic::Diagnostic;
use crate::findings::Finding;
use crate::others::Others;
use crate::program::Program;
use crate::resolve::{self, Resolved, numbers::Unit};
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::still_wanted::StillWanted;
use ladder_syntax::{Parse, TextSize};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// What is known of a file.
#[derive(Debug)]
pub struct Analysis {
    /// Names, networks and blocks.
    pub context: Arc<Context>,
    shown: Shown,
    /// All that is shown, once somebody wants it all.
    findings: OnceLock<Vec<Finding>>,
    /// Errors that settings or comments hide, or count as less, beside those that [`Shown`] keeps.
    hidden_anew: Vec<Diagnostic>,
    /// All of them, once somebody wants them.
    hidden_errors: OnceLock<Vec<Diagnostic>>,
    /// What was looked at to find them.
    pub work: Work,
    /// The findings with all that they say, once somebody wants them all.
    diagnostics: OnceLock<Vec<Diagnostic>>,
    /// Until the analysis of the next text takes it.
    ledger: Mutex<Option<Ledger>>,
    program: OnceLock<Option<Arc<Program>>>,
}

impl Analysis {
    /// What is found, in the order of the places.
    pub fn findings(&self) -> &[Finding] {
        self.findings.get_or_init(|| self.shown.all(&self.context))
    }

    /// How many findings there are.
    pub fn count(&self) -> usize {
        self.shown.len()
    }

    /// At most this many of the findings, in the order of their places: errors come before all others, and then what is near
    /// to a place.
    pub fn findings_near(&self, most: usize, place: TextSize) -> Vec<Finding> {
        self.shown.nearest(&self.context, most, place)
    }

    /// The same with all that each finding says.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        let all = || self.findings().iter();
        self.diagnostics
            .get_or_init(|| all().map(|found| found.diagnostic(&self.context)).collect())
    }

    /// Errors that settings or comments hide, or count as less, in the order of their places: the program does not run all the
    /// same.
    pub fn hidden_errors(&self) -> &[Diagnostic] {
        self.hidden_errors.get_or_init(|| {
            let kept = self.shown.hidden_errors(&self.context);
            let mut all: Vec<Diagnostic> = kept.iter().map(|found| found.diagnostic(&self.context)).collect();
            all.extend_from_slice(&self.hidden_anew);
            all.sort_by_key(|found| (found.range.start(), found.range.end(), found.rule));
            all
        })
    }

    /// Changes a finding of a rule that looks at the text itself, if there is one for which `wanted` holds.
    pub fn change_finding(
        &mut self,
        rule: Rule,
        wanted: impl Fn(&Diagnostic) -> bool,
        change: impl FnOnce(&mut Diagnostic),
    ) {
        if !self.shown.finds_anew(rule) {
            return;
        }
        let context = &self.context;
        let mut all = self.findings().to_vec();
        let mut of_rule = all.iter_mut().filter(|found| found.rule == rule);
        let found = of_rule.find_map(|finding| {
            let found = finding.diagnostic(context);
            wanted(&found).then_some((finding, found))
        });
        if let Some((finding, mut found)) = found {
            change(&mut found);
            *finding = Finding::from(found);
            self.hidden_anew = self.hidden_errors().to_vec();
            self.shown = Shown::Listed(all);
            self.findings = OnceLock::new();
            self.diagnostics = OnceLock::new();
        }
    }

    /// Whether a finding is an error: the program is not simulated.
    pub fn has_errors(&self) -> bool {
        self.shown.has_errors() || self.shown.hides_errors() || !self.hidden_anew.is_empty()
    }

    /// The program, if there are no errors and it uses no function or block of another file: see
    /// [`link()`](crate::link()). It is put together when it is first asked for.
    pub fn program(&self) -> Option<&Arc<Program>> {
        let program = || {
            if self.has_errors() {
                return None;
            }
            let alone = Unit {
                context: &self.context,
                name: &self.context.name,
                bodies: None,
            };
            let Resolved {
                program,
                unresolved,
                linked,
            } = resolve::program(&[alone]);
            (unresolved.is_none() && linked).then(|| Arc::new(program))
        };
        self.program.get_or_init(program).as_ref()
    }

    /// What keeps the program from being simulated.
    pub fn errors(&self) -> impl Iterator<Item = &Diagnostic> {
        let shown = self.diagnostics().iter();
        let shown = shown.filter(|found| found.severity == Severity::Error);
        shown.chain(self.hidden_errors())
    }

    /// What the analysis of the next text begins with; the first that asks gets it.
    fn take_ledger(&self) -> Option<Ledger> {
        self.ledger.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

impl Clone for Analysis {
    /// The next text begins with what the original keeps: a copy has nothing to hand on.
    fn clone(&self) -> Analysis {
        Analysis {
            context: Arc::clone(&self.context),
            shown: self.shown.clone(),
            findings: self.findings.clone(),
            hidden_anew: self.hidden_anew.clone(),
            hidden_errors: self.hidden_errors.clone(),
            work: self.work,
            diagnostics: self.diagnostics.clone(),
            ledger: Mutex::default(),
            program: self.program.clone(),
        }
    }
}

/// Analyses a file that is alone. `name` is how messages of a running program call it.
pub fn analyze(parse: &Arc<Parse>, name: &str) -> Analysis {
    analyze_in(parse, name, &Others::default())
}

/// Analyses a file among the others of its workspace, whose [`Exports`](crate::Exports) go by the same names.
pub fn analyze_in(parse: &Arc<Parse>, name: &str, others: &Others) -> Analysis {
    analyze_with(parse, name, others, &RuleSettings::default())
}

/// As [`analyze_in()`], with settings of the rules.
pub fn analyze_with(parse: &Arc<Parse>, name: &str, others: &Others, settings: &RuleSettings) -> Analysis {
    analyze_after(None, parse, name, others, settings)
}

/// As [`analyze_with()`], for a text that came from another one by edits: what both have is taken over from the
/// analysis of the earlier one. What comes out does not depend on it.
pub fn analyze_after(
    before: Option<&Analysis>,
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    settings: &RuleSettings,
) -> Analysis {
    let known = before.map(|before| &*before.context);
    let context = Arc::new(context_after(known, parse, name, others));
    analyze_context(before, context, settings)
}

/// Analyses a file whose names, networks and blocks are known. `before` is the analysis of an earlier text of it.
pub fn analyze_context(
    before: Option<&Analysis>,
    context: Arc<Context>,
    settings: &RuleSettings,
) -> Analysis {
    match analyze_while(before, context, settings, &|| true) {
        Some(analysis) => analysis,
        None => unreachable!("it is always wanted"),
    }
}

/// As [`analyze_context()`], while `wanted` holds: that is asked between each [`BETWEEN`](crate::BETWEEN) networks or tags. None
/// once it does not. What an edit usually concerns is less, and is always looked at.
pub fn analyze_while(
    before: Option<&Analysis>,
    context: Arc<Context>,
    settings: &RuleSettings,
    wanted: &dyn Fn() -> bool,
) -> Option<Analysis> {
    let ledger = before.and_then(Analysis::take_ledger);
    let found = checking::find(ledger, &context, settings, &StillWanted::new(wanted))?;
    Some(Analysis {
        context,
        shown: found.shown,
        findings: OnceLock::new(),
        hidden_anew: found.hidden_errors,
        hidden_errors: OnceLock::new(),
        work: found.work,
        diagnostics: OnceLock::new(),
        ledger: Mutex::new(Some(found.ledger)),
        program: OnceLock::new(),
    })
}
