//! A program of another system that is open: the ladder text that it becomes, and what is found in that.

use std::path::Path;
use std::sync::Arc;

use crate::language;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_ide::markdown;
use ladder_notations::{Foreign, Notation, Outcome, ReadError, Source};
use ladder_syntax::{LineIndex, Parse, TextRange, TextSize, line_around};
use ladder_workspace::ForeignPrograms;

/// A hover shows no more lines of a drawing.
const MOST_LINES: usize = 40;

/// A program of another system, read.
#[derive(Debug)]
pub struct Opened {
    foreign: Arc<Foreign>,
    analysis: language::Analysis,
    /// What is found in the ladder text, with its places in the file.
    findings: Vec<Diagnostic>,
}

impl Opened {
    /// Reads a program; `file` is where it lies, if it is a file, `name` the stem of its name, and `analyse` looks at the
    /// ladder text that it becomes. Takes as long as a conversion: for a blocking thread.
    pub(crate) fn read(
        notation: &'static dyn Notation,
        name: &str,
        text: &str,
        file: Option<(&ForeignPrograms, &Path)>,
        analyse: impl FnOnce(&Arc<Parse>) -> Analysis,
    ) -> Result<Opened, ReadError> {
        let bytes = text.as_bytes();
        let source = match file {
            Some((programs, file)) => programs
                .source(notation, file, bytes)
                .map_err(|error| ReadError::whole(error.to_string()))?,
            None => Source::alone(name, bytes),
        };
        let foreign = Foreign::read(notation, &source)?;
        let analysis = Arc::new(analyse(&Arc::new(ladder_syntax::parse(foreign.ladder()))));
        Ok(Opened {
            findings: foreign.in_file(analysis.diagnostics().to_vec()),
            foreign: Arc::new(foreign),
            analysis: language::Analysis::from(analysis),
        })
    }

    /// The program, next to its ladder text.
    pub fn foreign(&self) -> &Arc<Foreign> {
        &self.foreign
    }

    /// What is known of the ladder text.
    pub(crate) fn analysis(&self) -> &language::Analysis {
        &self.analysis
    }

    /// What is found in the ladder text, with its places in the file.
    pub fn findings(&self) -> &[Diagnostic] {
        &self.findings
    }

    /// What the line around an offset becomes, in Markdown, and where it is.
    pub fn hover(&self, offset: TextSize) -> Option<(TextRange, String)> {
        let text = self.foreign.text();
        let lines = LineIndex::new(text);
        let line = self.line_with_parts(&lines, lines.line(offset))?;
        let mut shown: Vec<String> = Vec::new();
        let networks = self.networks(line);
        if !networks.is_empty() {
            shown.push(markdown::drawing("clad", &cut(&networks.join("\n\n"))));
        }
        for entry in self.foreign.entries_in(line) {
            let (what, why) = match &entry.outcome {
                Outcome::Translated => continue,
                Outcome::Approximated(why) => ("approximated", why),
                Outcome::Refused(why) => ("no counterpart", why),
            };
            let (element, why) = (markdown::code(&entry.element), markdown::escaped(why));
            shown.push(format!("**{what}** {element}: {why}"));
        }
        (!shown.is_empty()).then(|| (trimmed(text, line), shown.join("\n\n")))
    }

    /// Where the word at an offset is in the ladder text that its line becomes.
    pub fn in_ladder(&self, offset: TextSize) -> Vec<TextSize> {
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let text = self.foreign.text();
        let Some((before, after)) = text.split_at_checked(usize::from(offset)) else {
            return Vec::new();
        };
        let before = before.rsplit(|c| !is_name(c)).next().unwrap_or_default();
        let after = after.split(|c| !is_name(c)).next().unwrap_or_default();
        let word = format!("{before}{after}");
        let lines = LineIndex::new(text);
        let Some(line) = self
            .line_with_parts(&lines, lines.line(offset))
            .filter(|_| !word.is_empty())
        else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for part in self.foreign.made_from(line) {
            let mut at = part.start();
            for piece in self.foreign.ladder()[part].split_inclusive(|c| !is_name(c)) {
                if piece
                    .trim_end_matches(|c| !is_name(c))
                    .eq_ignore_ascii_case(&word)
                {
                    found.push(at);
                }
                at += TextSize::of(piece);
            }
        }
        found
    }

    /// The word of the file that a name in the ladder text was made from: in the statement that its block was made from. None: the
    /// statement has no such word.
    pub fn word(&self, of_ladder: TextRange) -> Option<TextRange> {
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let name = &self.foreign.ladder()[of_ladder];
        let text = self.foreign.text();
        let start = usize::from(self.foreign.own_range(of_ladder)?.start());
        let statement = text[start..].split(';').next().unwrap_or_default();
        let mut after = 0;
        let found = std::iter::from_fn(|| {
            let rest = statement.get(after..)?;
            let (at, _) = rest.char_indices().find(|(at, _)| {
                let here = rest.get(*at..*at + name.len());
                here.is_some_and(|here| here.eq_ignore_ascii_case(name))
            })?;
            let at = after + at;
            after = at + name.len();
            Some(at)
        });
        let mut whole = found.filter(|at| {
            let before = statement[..*at].chars().next_back();
            let next = statement[at + name.len()..].chars().next();
            !name.is_empty()
                && before.is_none_or(|c| !is_name(c) && c != '.')
                && next.is_none_or(|c| !is_name(c))
        });
        let at = start + whole.next()?;
        Some(TextRange::at(
            TextSize::new(at as u32),
            TextSize::of(&statement[at - start..at - start + name.len()]),
        ))
    }

    /// The line, or the one where the statement begins that goes on in it, if anything was made from that. A line that
    /// only introduces the next has no part of its own.
    fn line_with_parts(&self, lines: &LineIndex, number: usize) -> Option<TextRange> {
        let text = self.foreign.text();
        let line = lines.content(text, number);
        let has_parts = |line| {
            self.foreign.made_from(line).next().is_some() || self.foreign.entries_in(line).next().is_some()
        };
        if has_parts(line) {
            return Some(line);
        }
        if self.foreign.introduces(line) {
            let below = lines.content(text, number + 1);
            return (below.start() > line.end() && has_parts(below)).then_some(below);
        }
        let before = self.foreign.last_before(line.start())?;
        let between = &text[TextRange::new(before, line.start())];
        let count = |of: [char; 3]| between.chars().filter(|c| of.contains(c)).count();
        let goes_on = count(['(', '[', '{']) > count([')', ']', '}']);
        let first = lines.content(text, lines.line(before));
        (goes_on && has_parts(first)).then_some(first)
    }

    /// The networks with something that was made from a line, each once.
    fn networks(&self, line: TextRange) -> Vec<&str> {
        let ladder = self.foreign.ladder();
        let mut found: Vec<&str> = Vec::new();
        let mut shown = TextSize::new(0);
        for part in self.foreign.made_from(line) {
            if part.start() < shown {
                continue;
            }
            if let Some(network) = network_around(ladder, part.start()) {
                shown = network.end();
                found.push(&ladder[network]);
            }
        }
        found
    }
}

/// The lines of the network around an offset of ladder text in canonical layout; none in a declaration or comment.
fn network_around(ladder: &str, offset: TextSize) -> Option<TextRange> {
    let mut first = line_around(ladder, offset);
    while !ladder[first].starts_with('+') {
        if first.start() == TextSize::new(0) || !ladder[first].starts_with('|') {
            return None;
        }
        first = line_around(ladder, first.start() - TextSize::new(1));
    }
    let mut end = first.end();
    while ladder[usize::from(end)..].starts_with("\n|") {
        end = line_around(ladder, end + TextSize::new(1)).end();
    }
    Some(TextRange::new(first.start(), end))
}

/// The line without the blanks around what is on it.
fn trimmed(text: &str, line: TextRange) -> TextRange {
    let whole = &text[line];
    let start = whole.len() - whole.trim_start().len();
    TextRange::at(
        line.start() + TextSize::new(start as u32),
        TextSize::of(whole.trim()),
    )
}

/// As many lines as a hover can show.
fn cut(drawing: &str) -> String {
    let lines: Vec<&str> = drawing.lines().collect();
    if lines.len() <= MOST_LINES {
        return drawing.to_owned();
    }
    let more = lines.len() - MOST_LINES;
    format!("{}\n... and {more} more lines", lines[..MOST_LINES].join("\n"))
}
