//! A program's text, and the places in it as people count them.

use ladder_analysis::program::{Location, Program};
use ladder_analysis::{Analysis, NotWhole};
use ladder_syntax::{LineColumn, LineIndex, TextRange, TextSize};
use ladder_workspace::{Workspace, shown};
use std::borrow::Cow;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// A text that was checked.
pub(crate) struct Source {
    /// The file as it was named.
    pub(crate) file: String,
    /// The text, byte for byte where the program has its own.
    pub(crate) text: String,
    index: LineIndex,
    /// The workspace around the file, once it is needed. None: there is none that can be used.
    workspace: OnceLock<Option<Arc<Workspace>>>,
    analysis: OnceLock<Arc<Analysis>>,
    program: OnceLock<Result<Arc<Program>, NotWhole>>,
}

impl Source {
    pub(crate) fn new(file: String, text: String) -> Source {
        let index = LineIndex::new(&text);
        Source {
            file,
            text,
            index,
            workspace: OnceLock::new(),
            analysis: OnceLock::new(),
            program: OnceLock::new(),
        }
    }

    /// In a workspace that is loaded already.
    pub(crate) fn within(workspace: Arc<Workspace>, file: String, text: String) -> Source {
        let source = Source::new(file, text);
        let _ = source.workspace.set(Some(workspace));
        source
    }

    /// The same file with another text.
    pub(crate) fn with_text(&self, text: String) -> Source {
        let source = Source::new(self.file.clone(), text);
        if let Some(workspace) = self.workspace.get() {
            let _ = source.workspace.set(workspace.clone());
        }
        source
    }

    /// What the file says among the others of its workspace.
    pub(crate) fn analyze(&self) -> Arc<Analysis> {
        let analysis = self.analysis.get_or_init(|| {
            let Some(workspace) = self.workspace() else {
                let parse = Arc::new(ladder_syntax::parse(&self.text));
                return Arc::new(ladder_analysis::analyze(&parse, &self.file));
            };
            match workspace.program_at(Path::new(&self.file)) {
                Some(program) if program.text == self.text => workspace.analysis(program),
                // Mended, or changed since it was read.
                Some(program) => workspace.analyze_guest(&self.text, &program.name),
                None => workspace.analyze_guest(&self.text, &self.file),
            }
        });
        Arc::clone(analysis)
    }

    /// What runs: the program with what it uses of other files.
    pub(crate) fn program(&self) -> Result<Arc<Program>, NotWhole> {
        let program = self.program.get_or_init(|| {
            let analysis = self.analyze();
            match self.workspace() {
                Some(workspace) => workspace.link(&analysis),
                None => ladder_analysis::link(&analysis, &|_| None),
            }
        });
        program.clone()
    }

    /// The layout that its workspace asks for.
    pub(crate) fn format_options(&self) -> ladder_format::Options {
        let workspace = self.workspace();
        workspace.map_or_else(Default::default, |workspace| workspace.settings().format.clone())
    }

    /// Another file of the workspace, by the name that findings and programs know it by.
    pub(crate) fn other(&self, name: &str) -> Option<Source> {
        let workspace = self.workspace()?;
        let program = workspace.program_named(name)?;
        Some(Source::within(
            Arc::clone(workspace),
            name.to_owned(),
            program.text.clone(),
        ))
    }

    /// The workspace around the file. Settings that cannot be used are told by the commands, which read them first.
    fn workspace(&self) -> Option<&Arc<Workspace>> {
        let load = || Workspace::of(Path::new(&self.file)).ok().map(Arc::new);
        self.workspace.get_or_init(load).as_ref()
    }

    /// A place of the program, in whichever file it lies: `motor.clad:3:12`.
    pub(crate) fn place_name(&self, location: Location) -> String {
        let elsewhere = match (location.file, self.program.get()) {
            (1.., Some(Ok(program))) => self.other(&program.files[location.file as usize]),
            _ => None,
        };
        let source = elsewhere.as_ref().unwrap_or(self);
        let place = source.place(location.range.start());
        format!("{}:{}:{}", shown::line(&source.file), place.line, place.column)
    }

    pub(crate) fn place(&self, offset: TextSize) -> LineColumn {
        self.index.line_column(&self.text, offset)
    }

    /// Every line with its line end, from first to last.
    #[cfg(feature = "screen")]
    pub(crate) fn line_ranges(&self) -> impl Iterator<Item = TextRange> + '_ {
        (0..self.index.line_count()).map(|line| self.index.range(line))
    }

    /// The whole lines that a range touches, and the number of the first, from 1. A range that ends with a line
    /// end does not touch the line behind it.
    pub(crate) fn lines(&self, range: TextRange) -> Lines {
        let first = self.index.line(range.start());
        let last = self.index.line(range.end()).max(first);
        let behind_line_end = last > first && self.index.range(last).start() == range.end();
        Lines {
            first,
            last: if behind_line_end { last - 1 } else { last },
        }
    }

    /// The lines as they are shown, and where they begin in the text.
    pub(crate) fn excerpt(&self, lines: Lines) -> (Cow<'_, str>, TextSize) {
        let mut start = self.index.range(lines.first).start();
        let end = self.index.range(lines.last).end();
        // The byte order mark is no character of the first line.
        if start == TextSize::new(0) && self.text.starts_with('\u{feff}') {
            start = TextSize::of('\u{feff}');
        }
        (
            with_line_feeds(&self.text[TextRange::new(start, end.max(start))]),
            start,
        )
    }
}

/// Some lines of a text, counted from 0, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Lines {
    pub(crate) first: usize,
    pub(crate) last: usize,
}

impl Lines {
    /// The lines of both, and those between.
    pub(crate) fn join(self, other: Lines) -> Lines {
        Lines {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }

    /// How many lines stand between the two; 0 if they touch or overlap.
    pub(crate) fn distance(self, other: Lines) -> usize {
        let between = |upper: usize, lower: usize| lower.saturating_sub(upper).saturating_sub(1);
        between(self.last, other.first).max(between(other.last, self.first))
    }
}

/// Terminals, and the drawing of excerpts, do not know a lone CR as a line end. One byte stands for one byte, so
/// that ranges stay true.
pub(crate) fn with_line_feeds(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let lone = |at: usize| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    if !(0..bytes.len()).any(lone) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        shown.push(if lone(at) { '\n' } else { letter });
    }
    Cow::Owned(shown)
}
