//! A program with edits, as another program, and where each of its lines comes from.

use crate::{LineColumn, Outcome, Report, WriteError, Writing};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::program::Network;
use ladder_analysis::{Analysis, AnalyzeOptions, analyze};
use ladder_syntax::{Item, LineKind, TextRange, TextSize, parse};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// What is different. Lines count from 0.
#[derive(Default)]
pub(crate) struct Edits {
    /// What stands in the place of something, in the order of the text.
    pub(crate) instead: Vec<(TextRange, String)>,
    /// Whole lines that stand before a line, and after one.
    pub(crate) before: HashMap<usize, String>,
    pub(crate) after: HashMap<usize, String>,
    /// Lines that are missing.
    pub(crate) gone: HashSet<usize>,
    /// Whole lines at the end.
    pub(crate) end: String,
    /// Declarations of more tags, of each block that has some, and of the program.
    declared: HashMap<Option<usize>, String>,
}

/// An edited program.
pub(crate) struct Edited {
    program: Analysis,
    /// For each line of its text the line that it was; both count from 1. None: it stands at the end, for nothing that the program
    /// says itself.
    lines: Vec<Option<u32>>,
}

/// Writes an edited program, or the program itself if there is none. The report is about the program itself.
///
/// # Errors
///
/// Those of `write`.
pub(crate) fn write_edited(
    analysis: &Analysis,
    edited: Option<Edited>,
    write: &dyn Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    let Some(edited) = edited else {
        return write(analysis);
    };
    let mut writing = write(&edited.program)?;
    edited.restore(&mut writing.report);
    Ok(writing)
}

/// The networks of the file itself, and what each is in. None: the program has errors.
pub(crate) fn own_networks(analysis: &Analysis) -> Option<Vec<(&Network, Body)>> {
    let context = &analysis.context;
    let bodies: HashMap<TextSize, Body> = (context.networks.iter())
        .map(|network| (network.range.start(), context.bodies[network.index]))
        .collect();
    let networks = analysis.program()?.networks.iter();
    let own = networks.filter(|network| network.location.file == 0);
    own.map(|network| Some((network, *bodies.get(&network.location.range.start())?)))
        .collect()
}

/// The first line of a network, with the comments above it.
pub(crate) fn first_line(context: &Context, network: usize) -> usize {
    let first = context.parse.structure().networks[network].lines.start;
    let is_comment = |line: &usize| context.parse.lines()[*line].kind == LineKind::Comment;
    first - (0..first).rev().take_while(is_comment).count()
}

impl Edits {
    pub(crate) fn is_empty(&self) -> bool {
        self.instead.is_empty() && self.before.is_empty()
    }

    /// Declares a tag where the networks of a body see it, by what stands between `VAR` and `END_VAR`.
    pub(crate) fn declare(&mut self, body: Body, declaration: &str) {
        let block = match body {
            Body::Block(block) => Some(block),
            _ => None,
        };
        let declared = self.declared.entry(block).or_default();
        declared.push_str(&format!("    {declaration}\n"));
    }

    /// The edited program. None: it has errors.
    pub(crate) fn program(self, context: &Context) -> Option<Edited> {
        let (text, lines) = self.written(context);
        let program = analyze(
            &parse(&text).into(),
            AnalyzeOptions::new(&context.name).among(&context.others),
        );
        program.program().is_some().then_some(Edited { program, lines })
    }

    fn written(mut self, context: &Context) -> (String, Vec<Option<u32>>) {
        self.instead.sort_by_key(|(at, _)| at.start());
        let parse = &context.parse;
        let structure = parse.structure();
        for item in &structure.items {
            if let Item::BlockHeader(block) = item
                && let Some(declared) = self.declared.get(&Some(*block))
            {
                let line = structure.blocks[*block].lines.start;
                let after = self.after.entry(line).or_default();
                after.push_str(&format!("VAR\n{declared}END_VAR\n"));
            }
        }
        let (mut out, mut lines) = (String::new(), Vec::new());
        let mut push = |more: &str, from: Option<u32>, step: u32| {
            let numbers = (0..).map(|number| from.map(|from| from + number * step));
            lines.extend(more.split_inclusive('\n').zip(numbers).map(|(_, from)| from));
            out.push_str(more);
        };
        for line in 0..parse.lines().len() {
            let from = Some(context.line_number(parse.line_start(line)) as u32);
            if let Some(more) = self.before.get(&line) {
                push(more, from, 0);
            }
            if !self.gone.contains(&line) {
                let mut own = edited_line(context, line, &self.instead);
                if !own.ends_with('\n') {
                    own.push('\n');
                }
                // A comment may have several.
                push(&own, from, 1);
            }
            if let Some(more) = self.after.get(&line) {
                push(more, from, 0);
            }
        }
        if let Some(declared) = self.declared.get(&None) {
            push(&format!("\nVAR\n{declared}END_VAR\n"), None, 0);
        }
        push(&format!("\n{}", self.end), None, 0);
        (out, lines)
    }
}

impl Edited {
    /// Makes the places of a report on the edited program those of the program. Of what stands at the end only that is said which has
    /// no counterpart.
    fn restore(&self, report: &mut Report) {
        report.entries.retain_mut(|entry| {
            let line = (entry.place.line as usize).checked_sub(1);
            match line.and_then(|line| self.lines.get(line)) {
                Some(Some(line)) => entry.place.line = *line,
                Some(None) if matches!(entry.outcome, Outcome::Refused(_)) => entry.place = LineColumn::START,
                Some(None) => return false,
                None => {}
            }
            true
        });
        report.entries.sort_by_key(|entry| entry.place);
        report.entries.dedup();
    }
}

/// A line with edits, which are in the order of the text.
pub(crate) fn edited_line(context: &Context, line: usize, edits: &[(TextRange, String)]) -> String {
    let start = context.parse.line_start(line);
    let own = context.parse.lines()[line].text();
    let mut text = own.to_owned();
    let range = TextRange::at(start, (own.len() as u32).into());
    let from = edits.partition_point(|(at, _)| at.start() < range.start());
    let own = edits[from..].iter().take_while(|(at, _)| at.end() <= range.end());
    for (at, with) in own.collect::<Vec<_>>().into_iter().rev() {
        text.replace_range(Range::<usize>::from(*at - start), with);
    }
    text
}
