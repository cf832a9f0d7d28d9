//! A finding: what is wrong, where, what to do.

use crate::findings::rule::{Rule, Severity};
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};
use std::borrow::Cow;
use std::sync::Arc;

/// A finding names at most this many other places.
pub const MOST_RELATED: usize = 20;

/// A finding of a rule. Ranges count bytes from the start of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that found it.
    pub rule: Rule,
    /// How much it matters.
    pub severity: Severity,
    /// Where.
    pub range: TextRange,
    /// What is wrong, naming the thing.
    pub message: String,
    /// What to do about it.
    pub help: Option<Cow<'static, str>>,
    /// Other places that have to do with it: the first of them.
    pub related: Vec<Related>,
    /// How many more there are.
    pub more_related: usize,
    /// Ways to fix it; the best first.
    pub fixes: Vec<Fix>,
}

/// Another place that a finding has to do with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// The file, if it is another one of the workspace.
    pub file: Option<Arc<str>>,
    /// Where.
    pub range: TextRange,
    /// What is there.
    pub message: Cow<'static, str>,
}

/// A way to fix a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// What it does, in a few words: "Insert `]`".
    pub title: String,
    /// The edits, sorted and disjoint.
    pub edits: Vec<Edit>,
    /// Whether it may be made unasked.
    pub applicability: Applicability,
}

/// Whether a fix may be made unasked. Of every fix a rule decides it by one question: can the drawing mean something
/// else than what the fix makes of it?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Applicability {
    /// The drawing can mean nothing else. A program that runs does the same afterwards.
    Safe,
    /// A guess, or with a placeholder in it: a person looks at it first.
    Unsafe,
}

impl Applicability {
    /// `safe`, `unsafe`.
    pub const fn name(self) -> &'static str {
        match self {
            Applicability::Safe => "safe",
            Applicability::Unsafe => "unsafe",
        }
    }
}

impl Fix {
    /// A fix of these edits, which are sorted and disjoint.
    pub fn new(applicability: Applicability, title: impl Into<String>, edits: Vec<Edit>) -> Fix {
        Fix {
            title: title.into(),
            edits,
            applicability,
        }
    }

    /// Whether it may be made unasked.
    pub fn is_safe(&self) -> bool {
        self.applicability == Applicability::Safe
    }
}

impl Diagnostic {
    /// A finding with the rule's own severity.
    pub fn new(rule: Rule, range: TextRange, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            rule,
            severity: rule.default_severity(),
            range,
            message: message.into(),
            help: None,
            related: Vec::new(),
            more_related: 0,
            fixes: Vec::new(),
        }
    }

    /// Adds what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<Cow<'static, str>>) -> Diagnostic {
        self.help = Some(help.into());
        self
    }

    /// Adds a related place.
    #[must_use]
    pub fn related(self, range: TextRange, message: impl Into<Cow<'static, str>>) -> Diagnostic {
        self.add_related(None, range, message)
    }

    fn add_related(
        mut self,
        file: Option<&Arc<str>>,
        range: TextRange,
        message: impl Into<Cow<'static, str>>,
    ) -> Diagnostic {
        if self.related.len() == MOST_RELATED {
            self.more_related += 1;
            return self;
        }
        self.related.push(Related {
            file: file.cloned(),
            range,
            message: message.into(),
        });
        self
    }

    /// Whether all places that it names lie in a stretch of the file.
    pub(crate) fn lies_in(&self, stretch: TextRange) -> bool {
        let related = |place: &Related| place.file.is_none() && stretch.contains_range(place.range);
        let edits = |fix: &Fix| fix.edits.iter().all(|edit| stretch.contains_range(edit.range));
        stretch.contains_range(self.range) && self.related.iter().all(related) && self.fixes.iter().all(edits)
    }

    /// Moves all places of this file that it names.
    pub(crate) fn move_by(&mut self, bytes: i64) {
        let moved = |at: TextSize| TextSize::new((i64::from(u32::from(at)) + bytes) as u32);
        let related = self.related.iter_mut().filter(|related| related.file.is_none());
        let edits = self.fixes.iter_mut().flat_map(|fix| &mut fix.edits);
        let places = std::iter::once(&mut self.range)
            .chain(related.map(|related| &mut related.range))
            .chain(edits.map(|edit| &mut edit.range));
        for place in places {
            *place = TextRange::new(moved(place.start()), moved(place.end()));
        }
    }

    /// As it is kept: the last related place says how many more there are.
    pub(crate) fn finished(mut self) -> Diagnostic {
        if self.more_related > 0
            && let Some(last) = self.related.last_mut()
        {
            let more = format!("; and {} more", self.more_related);
            last.message.to_mut().push_str(&more);
        }
        self
    }

    /// Adds a related place in another file.
    #[must_use]
    pub fn related_in(
        self,
        file: &Arc<str>,
        range: TextRange,
        message: impl Into<Cow<'static, str>>,
    ) -> Diagnostic {
        self.add_related(Some(file), range, message)
    }

    /// Adds a related place in another file, or in this one where there is none.
    #[must_use]
    pub(crate) fn related_at(
        self,
        file: Option<&Arc<str>>,
        range: TextRange,
        message: impl Into<Cow<'static, str>>,
    ) -> Diagnostic {
        match file {
            Some(file) => self.related_in(file, range, message),
            None => self.related(range, message),
        }
    }

    /// Adds a fix.
    #[must_use]
    pub fn with(mut self, fix: Fix) -> Diagnostic {
        self.fixes.push(fix);
        self
    }

    /// Adds a fix of one edit.
    #[must_use]
    pub fn fix(
        mut self,
        applicability: Applicability,
        title: impl Into<String>,
        range: TextRange,
        text: impl Into<String>,
    ) -> Diagnostic {
        let text = text.into();
        let edits = vec![Edit { range, text }];
        self.fixes.push(Fix::new(applicability, title, edits));
        self
    }
}
