//! The one place where the server asks the language about a text. Places are bytes.

use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_analysis::{AnalyzeOptions, Cancel, Finding, RuleSettings};
use ladder_format::Options;
use ladder_ide::{Action, ActionKind, Renamed, Workspace, fix_all, quick_fixes, refactorings};
use ladder_syntax::TextRange;

/// What one text says, and what is found in it.
#[derive(Debug, Clone)]
pub struct Analysis {
    whole: Arc<ladder_analysis::Analysis>,
}

impl From<Arc<ladder_analysis::Analysis>> for Analysis {
    fn from(whole: Arc<ladder_analysis::Analysis>) -> Analysis {
        Analysis { whole }
    }
}

impl Analysis {
    /// Looks for what is wrong. What an earlier text of the document has in common with it is not checked again. What
    /// concerns a large part of the file is given up once it is cancelled.
    pub fn of(
        context: &Arc<Context>,
        before: Option<&Analysis>,
        rules: &RuleSettings,
        cancel: &Cancel,
    ) -> Option<Self> {
        let before = before.map(|before| &*before.whole);
        let options = AnalyzeOptions::new(&context.name).with_rules(rules).after(before);
        let whole = options.check_unless(Arc::clone(context), cancel)?;
        Some(Analysis {
            whole: Arc::new(whole),
        })
    }

    /// What is wrong, in the order of the places.
    pub fn findings(&self) -> &[Finding] {
        self.whole.findings()
    }

    /// All of it, for those who put the files of a workspace together.
    pub fn whole(&self) -> &Arc<ladder_analysis::Analysis> {
        &self.whole
    }

    /// The edits of an action in all files that it changes, with the drawing around them put straight. `text` is the text that
    /// was checked.
    pub fn everywhere(
        &self,
        action: &Action,
        text: &str,
        options: &Options,
        workspace: &dyn Workspace,
    ) -> Vec<Renamed> {
        action.everywhere(&self.whole, text, options, workspace)
    }

    /// What can be done, of the kinds that are wanted, with what a range selects, and against the problems in another.
    pub fn actions(
        &self,
        range: TextRange,
        problems: TextRange,
        wants: impl Fn(ActionKind) -> bool,
    ) -> Vec<Action> {
        use ActionKind::{Extract, FixAll, Inline, QuickFix, Rewrite};
        let mut actions = Vec::new();
        if wants(QuickFix) {
            actions.extend(quick_fixes(&self.whole, problems));
        }
        if [Extract, Inline, Rewrite].into_iter().any(&wants) {
            actions.extend(refactorings(&self.whole, range));
        }
        if wants(FixAll) {
            actions.extend(fix_all(&self.whole));
        }
        actions.retain(|action| wants(action.kind));
        actions
    }
}
