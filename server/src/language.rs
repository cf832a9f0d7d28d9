//! The one place where the server asks the language about a text. Places are bytes.

use std::sync::Arc;

use ladder_analysis::fix::aligned;
use ladder_analysis::{Diagnostic, Fix, Others, RuleSettings, analyze_with};
use ladder_format::{Edit, Options, format};
use ladder_ide::{Completions, Hover, Topic, completions, documentation, hover};
use ladder_syntax::{TextSize, parse};

/// All that is known of one text.
#[derive(Debug)]
pub(crate) struct Analysis(Arc<ladder_analysis::Analysis>);

impl Analysis {
    /// Analyses a text of at most 64 MiB. Messages of a running program call the file by this name.
    pub(crate) fn of(text: &str, name: &str, others: &Others, rules: &RuleSettings) -> Self {
        Analysis(Arc::new(analyze_with(
            &Arc::new(parse(text)),
            name,
            others,
            rules,
        )))
    }

    /// What is wrong, in the order of the places.
    pub(crate) fn diagnostics(&self) -> &[Diagnostic] {
        &self.0.diagnostics
    }

    /// All of it, for those who put the files of a workspace together.
    pub(crate) fn whole(&self) -> &Arc<ladder_analysis::Analysis> {
        &self.0
    }

    /// What stands at an offset.
    pub(crate) fn hover(&self, offset: TextSize) -> Option<Hover> {
        hover(&self.0, offset)
    }

    /// What can be written at an offset.
    pub(crate) fn completions(&self, offset: TextSize, trigger: Option<char>) -> Completions {
        completions(&self.0, offset, trigger)
    }

    /// What a proposal is, in Markdown.
    pub(crate) fn documentation(&self, topic: &Topic) -> Option<String> {
        documentation(&self.0, topic)
    }

    /// The edits that make fixes together, with the drawing around them put straight. They are given as edits that
    /// do not touch each other.
    pub(crate) fn mend(&self, edits: Vec<Edit>) -> Vec<Edit> {
        let fix = Fix {
            title: String::new(),
            edits,
        };
        aligned(&self.0.context.parse.to_string(), &fix, &Options::default())
    }

    /// The edits that bring the text into its canonical layout: sorted, none touching another.
    pub(crate) fn format(&self, options: &Options) -> Vec<Edit> {
        format(&self.0.context.parse, options)
    }
}
