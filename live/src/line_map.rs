//! The text that runs and the text that the editor shows. They differ while the editor's has errors, and where a session
//! was stepped back over a change: then what runs is shown in the lines that are still the same. Of a program of another system its
//! ladder text runs, and is shown in the statements that it was made from.

use std::sync::Arc;

use ladder_syntax::{TextRange, TextSize};
use similar::DiffOp;
use similar::algorithms::{Capture, Compact, Replace, myers};

use ladder_documents::position::Range;
use ladder_documents::{Opened, Revision};

/// Between lines that were changed, no more lines than this are compared.
const MOST_COMPARED: usize = 4000;

/// How places of the text that runs are found in the editor's, and the other way round.
#[derive(Debug)]
pub(crate) struct LineMap {
    /// The ladder text.
    running: Arc<Revision>,
    /// The text that it is made from: itself, or a program of another system.
    source: Arc<Revision>,
    shown: Arc<Revision>,
    /// Of each line of the source the line that shows it. None if both texts are the same.
    lines: Option<Vec<Option<u32>>>,
}

impl LineMap {
    /// Of a text, as it runs and as the editor shows it.
    pub(crate) fn new(source: Arc<Revision>, shown: Arc<Revision>) -> LineMap {
        let running = source.in_ladder();
        LineMap::of(running, source, shown)
    }

    /// The same where its ladder text is known.
    pub(crate) fn of(running: Arc<Revision>, source: Arc<Revision>, shown: Arc<Revision>) -> LineMap {
        let lines = (!source.is(&shown)).then(|| corresponding(&source, &shown));
        LineMap {
            running,
            source,
            shown,
            lines,
        }
    }

    /// The ladder text of the program.
    pub(crate) fn running(&self) -> &Arc<Revision> {
        &self.running
    }

    /// The text of the program, as its file has it.
    pub(crate) fn source(&self) -> &Arc<Revision> {
        &self.source
    }

    /// The text that the editor shows.
    pub(crate) fn shown(&self) -> &Arc<Revision> {
        &self.shown
    }

    /// Whether the editor shows a drawing: else a text that a drawing was made of.
    pub(crate) fn shows_drawing(&self) -> bool {
        self.running.is(&self.source)
    }

    /// What the source is made into, where that is not a drawing itself.
    fn opened(&self) -> Option<&Opened> {
        self.source.opened()?.as_ref().ok()
    }

    /// Where the source has a part of the ladder text.
    fn range_in_source(&self, range: TextRange) -> Option<Range> {
        if self.shows_drawing() {
            return Some(self.running.range(range));
        }
        let own = self.opened()?.foreign().range(range);
        Some(self.source.range(own))
    }

    /// Where the editor shows a stretch of the text that runs. None if its lines are not the same any more, or were made from nothing.
    pub(crate) fn range(&self, range: TextRange) -> Option<Range> {
        self.in_shown(self.range_in_source(range)?)
    }

    /// Where the editor shows an operand, or the name in a declaration.
    pub(crate) fn operand(&self, range: TextRange) -> Option<Range> {
        if self.shows_drawing() {
            return self.range(range);
        }
        let word = self.opened()?.word(range)?;
        self.in_shown(self.source.range(word))
    }

    fn in_shown(&self, mut place: Range) -> Option<Range> {
        let Some(lines) = &self.lines else {
            return Some(place);
        };
        let line = |line: u32| lines.get(line as usize).copied().flatten();
        // A network ends at the start of the line after it.
        let ends_line = place.end.character == 0 && place.end.line > place.start.line;
        place.start.line = line(place.start.line)?;
        place.end.line = if ends_line {
            line(place.end.line - 1)? + 1
        } else {
            line(place.end.line)?
        };
        Some(place)
    }

    /// The same; what is not shown any more is at the start of the next line that is.
    pub(crate) fn range_or_near(&self, range: TextRange) -> Range {
        self.range(range).unwrap_or_else(|| {
            let first = self.range_in_source(range).map_or(0, |place| place.start.line);
            let after = self
                .lines
                .iter()
                .flat_map(|lines| lines.iter().skip(first as usize));
            let line = after.flatten().next().copied();
            let line = line.unwrap_or_else(|| {
                if self.lines.is_some() {
                    self.shown.last_line()
                } else {
                    first
                }
            });
            let start = self.shown.line_start(line);
            self.shown.range(TextRange::empty(start))
        })
    }

    /// The line of the source that a line of the editor shows.
    fn source_line(&self, line: u32) -> Option<u32> {
        match &self.lines {
            None => Some(line),
            Some(lines) => {
                let at = lines.iter().position(|shown| *shown == Some(line))?;
                u32::try_from(at).ok()
            }
        }
    }

    /// Where what a line of the editor shows begins in the text that runs: of a drawing the line, of a text each part that was made of
    /// it.
    pub(crate) fn running_starts(&self, line: u32) -> Vec<TextSize> {
        let Some(line) = self.source_line(line) else {
            return Vec::new();
        };
        if self.shows_drawing() {
            return vec![self.running.line_start(line)];
        }
        self.made_from(line, line + 1)
            .iter()
            .map(|part| part.start())
            .collect()
    }

    /// The parts of the ladder text that were made from what begins in some lines of the source, the last one excluded.
    fn made_from(&self, first: u32, after: u32) -> Vec<TextRange> {
        let Some(opened) = self.opened() else {
            return Vec::new();
        };
        let (start, end) = (self.source.line_start(first), self.source.line_start(after));
        opened
            .foreign()
            .made_from(TextRange::new(start.min(end), end))
            .collect()
    }

    /// The stretches of the text that runs which some lines of the editor show.
    pub(crate) fn stretches(&self, first: u32, last: u32) -> Vec<TextRange> {
        let stretch = |first: u32, after: u32| {
            if !self.shows_drawing() {
                return self.made_from(first, after);
            }
            let (start, end) = (self.running.line_start(first), self.running.line_start(after));
            vec![TextRange::new(start.min(end), end)]
        };
        let Some(lines) = &self.lines else {
            return stretch(first, last.saturating_add(1));
        };
        let mut stretches: Vec<(u32, u32)> = Vec::new();
        for (line, shown) in (0..).zip(lines) {
            if !shown.is_some_and(|shown| (first..=last).contains(&shown)) {
                continue;
            }
            match stretches.last_mut() {
                Some((_, after)) if *after == line => *after += 1,
                _ => stretches.push((line, line + 1)),
            }
        }
        stretches
            .into_iter()
            .flat_map(|(first, after)| stretch(first, after))
            .collect()
    }

    /// The place in the text that runs which the editor shows there.
    pub(crate) fn running_offset(&self, shown: TextSize) -> Option<TextSize> {
        let place = match &self.lines {
            None => shown,
            Some(_) => {
                let line = self.shown.line_of(shown);
                let within = shown - self.shown.line_start(line).min(shown);
                self.source.line_start(self.source_line(line)?) + within
            }
        };
        if self.shows_drawing() {
            return Some(place);
        }
        self.opened()?.in_ladder(place).first().copied()
    }
}

/// Of each line of one text the line of another that is the same.
pub(crate) fn corresponding(old: &Revision, new: &Revision) -> Vec<Option<u32>> {
    let (old_text, new_text) = (old.text(), new.text());
    let old_lines = lines(old, &old_text);
    let new_lines = lines(new, &new_text);
    let mut found = vec![None; old_lines.len()];
    let same = |(old, new): &(&&str, &&str)| old == new;
    let start = old_lines.iter().zip(&new_lines).take_while(same).count();
    let rest = old_lines.len().min(new_lines.len()) - start;
    let ends = old_lines.iter().rev().zip(new_lines.iter().rev());
    let end = ends.take(rest).take_while(same).count();
    for (line, place) in found.iter_mut().enumerate().take(start) {
        *place = Some(line as u32);
    }
    for after in 1..=end {
        found[old_lines.len() - after] = Some((new_lines.len() - after) as u32);
    }
    let (old_middle, new_middle) = (start..old_lines.len() - end, start..new_lines.len() - end);
    if old_middle.len().max(new_middle.len()) > MOST_COMPARED {
        return found;
    }
    let (old, new) = (&old_lines[old_middle], &new_lines[new_middle]);
    // Its function for all algorithms would bring all of them into the program.
    let mut diff = Compact::new(Replace::new(Capture::new()), old, new);
    let Ok(()) = myers::diff(&mut diff, old, 0..old.len(), new, 0..new.len());
    for op in diff.into_inner().into_inner().into_ops() {
        if let DiffOp::Equal {
            old_index,
            new_index,
            len,
        } = op
        {
            for line in 0..len {
                found[start + old_index + line] = Some((start + new_index + line) as u32);
            }
        }
    }
    found
}

/// The lines of a text, without their ends.
fn lines<'t>(revision: &Revision, text: &'t str) -> Vec<&'t str> {
    let starts = (0..=revision.last_line()).map(|line| usize::from(revision.line_start(line)));
    let starts: Vec<usize> = starts.collect();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(&start, end)| {
            text.get(start..end)
                .unwrap_or_default()
                .trim_end_matches(['\r', '\n'])
        })
        .collect()
}
