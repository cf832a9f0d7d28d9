//! The text that runs and the text that the editor shows. They differ while the editor's has errors, and where a session
//! was stepped back over a change: then what runs is shown in the lines that are still the same.

use std::sync::Arc;

use ladder_syntax::{TextRange, TextSize};
use similar::DiffOp;
use similar::algorithms::{Capture, Compact, Replace, myers};

use ladder_documents::Revision;
use ladder_documents::position::Range;

/// Between lines that were changed, no more lines than this are compared.
const MOST_COMPARED: usize = 4000;

/// How places of the text that runs are found in the editor's, and the other way round.
#[derive(Debug)]
pub(crate) struct LineMap {
    running: Arc<Revision>,
    shown: Arc<Revision>,
    /// Of each line of the text that runs the line that shows it. None if both texts are the same.
    lines: Option<Vec<Option<u32>>>,
}

impl LineMap {
    pub(crate) fn new(running: Arc<Revision>, shown: Arc<Revision>) -> LineMap {
        let lines = (!running.is(&shown)).then(|| corresponding(&running, &shown));
        LineMap {
            running,
            shown,
            lines,
        }
    }

    /// The text of the program.
    pub(crate) fn running(&self) -> &Arc<Revision> {
        &self.running
    }

    /// The text that the editor shows.
    pub(crate) fn shown(&self) -> &Arc<Revision> {
        &self.shown
    }

    /// Where the editor shows a stretch of the text that runs. None if its lines are not the same any more.
    pub(crate) fn range(&self, range: TextRange) -> Option<Range> {
        let mut place = self.running.range(range);
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
            let first = self.running.range(range).start.line as usize;
            let after = self.lines.iter().flat_map(|lines| lines.iter().skip(first));
            let line = after.flatten().next().copied();
            let line = line.unwrap_or_else(|| self.shown.last_line());
            let start = self.shown.line_start(line);
            self.shown.range(TextRange::empty(start))
        })
    }

    /// The line of the program that a line of the editor shows.
    pub(crate) fn running_line(&self, line: u32) -> Option<u32> {
        match &self.lines {
            None => Some(line),
            Some(lines) => {
                let at = lines.iter().position(|shown| *shown == Some(line))?;
                u32::try_from(at).ok()
            }
        }
    }

    /// The stretches of the text that runs which some lines of the editor show.
    pub(crate) fn stretches(&self, first: u32, last: u32) -> Vec<TextRange> {
        let stretch = |first: u32, after: u32| {
            let (start, end) = (self.running.line_start(first), self.running.line_start(after));
            TextRange::new(start.min(end), end)
        };
        let Some(lines) = &self.lines else {
            return vec![stretch(first, last.saturating_add(1))];
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
            .map(|(first, after)| stretch(first, after))
            .collect()
    }

    /// The place in the text that runs which the editor shows there.
    pub(crate) fn running_offset(&self, shown: TextSize) -> Option<TextSize> {
        if self.lines.is_none() {
            return Some(shown);
        }
        let line = self.shown.line_of(shown);
        let within = shown - self.shown.line_start(line).min(shown);
        Some(self.running.line_start(self.running_line(line)?) + within)
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
