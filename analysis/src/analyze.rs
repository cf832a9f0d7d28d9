//! A file, analysed.

use crate::context::{Context, context_after};
use crate::diagnostic::Diagnostic;
use crate::others::Others;
use crate::program::Program;
use crate::resolve::{self, Resolved, numbers::Unit};
use crate::rule::Severity;
use crate::rule_settings::RuleSettings;
use crate::{lint, rules, stamp};
use ladder_syntax::Parse;
use std::sync::{Arc, OnceLock};

/// What is known of a file.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// Names, networks and blocks.
    pub context: Arc<Context>,
    /// The findings, in the order of their places.
    pub diagnostics: Vec<Diagnostic>,
    /// Errors that settings or comments hide, or count as less: the program does not run all the same.
    pub hidden_errors: Vec<Diagnostic>,
    program: OnceLock<Option<Arc<Program>>>,
}

impl Analysis {
    /// Whether a finding is an error: the program is not simulated.
    pub fn has_errors(&self) -> bool {
        self.errors().next().is_some()
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
        let shown = self.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        shown.chain(&self.hidden_errors)
    }
}

/// Analyses a file that stands alone. `name` is how messages of a running program call it.
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
    let before = before.map(|before| &*before.context);
    analyze_context(Arc::new(context_after(before, parse, name, others)), settings)
}

/// Analyses a file whose names, networks and blocks are known.
pub fn analyze_context(context: Arc<Context>, settings: &RuleSettings) -> Analysis {
    let parse = &context.parse;
    let mut diagnostics = context.found.clone();
    let stamps = stamp::stamps(&context);
    let unresolved = resolve::check_all(&context, &stamps, &mut diagnostics);
    rules::check(&context, &stamps, settings, &mut diagnostics);
    rules::unclosed_comment::hide_what_follows(parse, &mut diagnostics);
    rules::cplc_draft::hide_all_else(parse, &mut diagnostics);
    diagnostics.iter_mut().for_each(Diagnostic::say_how_many_more);
    let hidden_errors = lint::apply(&context, settings, &mut diagnostics);
    diagnostics.sort_by_key(|d| (d.range.start(), d.range.end(), d.rule));
    // The first says it best: what is found while types are inferred comes before what follows from it.
    diagnostics.dedup_by(|later, first| later.rule == first.rule && later.range == first.range);
    let mut analysis = Analysis {
        context,
        diagnostics,
        hidden_errors,
        program: OnceLock::new(),
    };
    if let Some(block) = unresolved.filter(|_| !analysis.has_errors()) {
        analysis.diagnostics.push(rules::bad_operand::meaningless(block));
    }
    analysis
}
