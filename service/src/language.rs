//! The one place where the server asks the language about a text. Places are bytes.

use std::ops::Range;
use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_analysis::names::join::context_while;
use ladder_analysis::{Finding, Others, RuleSettings, analyze_while};
use ladder_format::{Edit, Options, format};
use ladder_ide::{Action, ActionKind, fix_all, quick_fixes, refactorings};
use ladder_ide::{
    Completions, SignatureHelp, Token, Topic, completions, documentation, semantic_tokens,
    semantic_tokens_of, signature_help,
};
use ladder_ide::{Inlay, Lens, Renamed, Workspace};
use ladder_syntax::{Parse, TextRange, TextSize};

/// What one text says: its names, networks and blocks. Enough for most that is asked while a program is typed.
#[derive(Debug, Clone)]
pub(crate) struct Names {
    context: Arc<Context>,
}

impl Names {
    /// Reads a text of at most 24 MiB. Messages of a running program call the file by this name. What an earlier text of
    /// the document has in common with it is not checked again. What concerns the whole file is given up once it is no
    /// longer wanted.
    pub(crate) fn of(
        parse: &Arc<Parse>,
        before: Option<&Names>,
        name: &str,
        others: &Others,
        wanted: &dyn Fn() -> bool,
    ) -> Option<Self> {
        let before = before.map(|before| &*before.context);
        let context = Arc::new(context_while(before, parse, name, others, wanted)?);
        Some(Names { context })
    }

    /// All of it.
    pub(crate) fn context(&self) -> &Arc<Context> {
        &self.context
    }

    /// The text itself, put together from its lines.
    pub(crate) fn text(&self) -> String {
        self.context.parse.to_string()
    }

    /// What can be written at an offset.
    pub(crate) fn completions(&self, offset: TextSize, trigger: Option<char>) -> Completions {
        completions(&self.context, offset, trigger)
    }

    /// What can be given at an offset.
    pub(crate) fn signature_help(&self, offset: TextSize) -> Option<SignatureHelp> {
        signature_help(&self.context, offset)
    }

    /// What each word within a range is, for the colours of an editor.
    pub(crate) fn semantic_tokens(&self, within: TextRange) -> Vec<Token> {
        semantic_tokens(&self.context, Some(within))
    }

    /// The same for some logical lines.
    pub(crate) fn semantic_tokens_of(&self, lines: Range<usize>) -> Vec<Token> {
        semantic_tokens_of(&self.context, lines)
    }

    /// What can be done with its networks.
    pub(crate) fn lenses(&self) -> Vec<Lens> {
        ladder_ide::lenses(&self.context)
    }

    /// What its coils compute, for the lines that touch a range.
    pub(crate) fn inlays(&self, within: TextRange) -> Vec<Inlay> {
        ladder_ide::inlays(&self.context, within)
    }

    /// What a proposal is, in Markdown.
    pub(crate) fn documentation(&self, topic: &Topic) -> Option<String> {
        documentation(&self.context, topic)
    }

    /// The edits that bring the text into its canonical layout: sorted, none touching another.
    pub(crate) fn format(&self, options: &Options) -> Vec<Edit> {
        format(&self.context.parse, options)
    }
}

/// What one text says, and what is found in it.
#[derive(Debug, Clone)]
pub(crate) struct Analysis {
    whole: Arc<ladder_analysis::Analysis>,
}

impl Analysis {
    /// Looks for what is wrong. What an earlier text of the document has in common with it is not checked again. What
    /// concerns a large part of the file is given up once it is no longer wanted.
    pub(crate) fn of(
        names: &Names,
        before: Option<&Analysis>,
        rules: &RuleSettings,
        wanted: &dyn Fn() -> bool,
    ) -> Option<Self> {
        let before = before.map(|before| &*before.whole);
        let whole = analyze_while(before, Arc::clone(&names.context), rules, wanted)?;
        Some(Analysis {
            whole: Arc::new(whole),
        })
    }

    /// What is wrong, in the order of the places.
    pub(crate) fn findings(&self) -> &[Finding] {
        self.whole.findings()
    }

    /// All of it, for those who put the files of a workspace together.
    pub(crate) fn whole(&self) -> &Arc<ladder_analysis::Analysis> {
        &self.whole
    }

    /// The edits of an action in all files that it changes, with the drawing around them put straight. `text` is the text that
    /// was checked.
    pub(crate) fn everywhere(
        &self,
        action: &Action,
        text: &str,
        options: &Options,
        workspace: &dyn Workspace,
    ) -> Vec<Renamed> {
        action.everywhere(&self.whole, text, options, workspace)
    }

    /// What can be done, of the kinds that are wanted, with what a range selects, and against the problems in another.
    pub(crate) fn actions(
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
