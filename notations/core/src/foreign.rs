//! A program of another system, next to the ladder text that it becomes: what is found in that text is shown in the
//! file that a person wrote.

use super::convert::UNUSED;
use super::encoding::in_utf8;
use super::{Converted, Entry, LineColumn, Lines, Notation, Outcome, ReadError, Report, Source, convert};
use ladder_analysis::{Diagnostic, Severity};
use ladder_syntax::{TextRange, TextSize};
use std::collections::{HashMap, HashSet};
use std::fmt;

/// What is where the name of a rule would, for an element without a counterpart.
const NOT_TRANSLATED: &str = "not-translated";

/// A foreign program that was read.
pub struct Foreign {
    notation: &'static dyn Notation,
    /// The file as it is shown. Places count as in the file itself.
    text: String,
    lines: Lines,
    converted: Converted,
    /// How many bytes what is at a place takes.
    lengths: HashMap<LineColumn, usize>,
    /// Where each name of the ladder text is used first.
    uses: HashMap<String, LineColumn>,
}

/// What there is to say about a foreign program before it is ladder text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mark {
    /// In the shown text.
    pub range: TextRange,
    /// The check that found it.
    pub check: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong and what to do.
    pub message: String,
}

impl Foreign {
    /// Reads a program.
    ///
    /// # Errors
    ///
    /// As for [`Notation::read`].
    pub fn read(notation: &'static dyn Notation, source: &Source<'_>) -> Result<Foreign, ReadError> {
        let options = ladder_format::Options::default();
        let converted = convert(notation, source, &options)?;
        let text = shown(&in_utf8(source.bytes));
        let lines = Lines::of(&text);
        let mut foreign = Foreign {
            notation,
            text,
            lines,
            converted,
            lengths: HashMap::new(),
            uses: HashMap::new(),
        };
        foreign.uses = foreign.used();
        foreign.lengths = foreign.measured();
        Ok(foreign)
    }

    /// The name of its notation: `ldmicro`.
    pub fn notation(&self) -> &'static str {
        self.notation.name()
    }

    /// Whether its coils are what a run is about.
    pub fn shows_coils(&self) -> bool {
        self.notation.shows_coils()
    }

    /// The file as it is shown.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What it becomes, and what became of each element.
    pub fn converted(&self) -> &Converted {
        &self.converted
    }

    /// What became of each element, where these errors are in the ladder text: what is at the place of one is refused after all.
    pub fn report<'d>(&self, errors: impl IntoIterator<Item = &'d Diagnostic>) -> Report {
        let mut report = self.converted.report.clone();
        let found = self.converted.findings.iter();
        let told: HashMap<LineColumn, &str> = found
            .filter(|found| found.severity == Severity::Error)
            .map(|found| (found.place, found.message.as_str()))
            .collect();
        let mut refused: HashSet<LineColumn> = HashSet::new();
        let mut first: HashMap<LineColumn, usize> = HashMap::new();
        for (number, entry) in report.entries.iter().enumerate() {
            first.entry(entry.place).or_insert(number);
            if matches!(entry.outcome, Outcome::Refused(_)) {
                refused.insert(entry.place);
            }
        }
        for error in errors {
            let place = self.place(error.range);
            if !refused.insert(place) {
                continue;
            }
            let why = told.get(&place).copied().unwrap_or(&error.message);
            match first.get(&place) {
                Some(entry) => report.entries[*entry].outcome = Outcome::Refused(why.to_owned()),
                None => report.refused(place, &self.ladder()[error.range], why),
            }
        }
        report
    }

    /// The same where the files of the project are written, in which some elements are as they were.
    pub fn report_of_files<'d>(&self, errors: impl IntoIterator<Item = &'d Diagnostic>) -> Report {
        let mut report = self.report(errors);
        let exact: HashSet<&(LineColumn, String)> = self.converted.exact_in_files.iter().collect();
        for entry in &mut report.entries {
            if !exact.is_empty() && exact.contains(&(entry.place, entry.element.clone())) {
                entry.outcome = Outcome::Translated;
            }
        }
        report
    }

    /// The ladder text that it becomes.
    pub fn ladder(&self) -> &str {
        &self.converted.written.text
    }

    /// What a part of the ladder text was made from, in the shown text.
    pub fn range(&self, of_ladder: TextRange) -> TextRange {
        self.own_range(of_ladder)
            .unwrap_or_else(|| self.range_at(self.converted.place_of(of_ladder.start())))
    }

    /// The same; none if it was made from nothing and is not used. The name of a tag that the other system does not declare is where
    /// that is used first.
    pub fn own_range(&self, of_ladder: TextRange) -> Option<TextRange> {
        let place = match self.converted.written.origin_around(of_ladder.start()) {
            Some(origin) => self.converted.places.get(origin as usize),
            None => self
                .uses
                .get(self.ladder().get(std::ops::Range::<usize>::from(of_ladder))?),
        };
        place.map(|place| self.range_at(*place))
    }

    /// Where each name of the ladder text is used first.
    fn used(&self) -> HashMap<String, LineColumn> {
        let mut uses = HashMap::new();
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        for (range, origin) in &self.converted.written.places {
            let Some(place) = self.converted.places.get(*origin as usize) else {
                continue;
            };
            for name in self.ladder()[*range].split(|c| !is_name(c)) {
                if !name.is_empty() && !uses.contains_key(name) {
                    uses.insert(name.to_owned(), *place);
                }
            }
        }
        uses
    }

    /// What the other system calls the part of the file that an offset of the shown text is in, where it has a name.
    pub fn name_at(&self, offset: TextSize) -> Option<&str> {
        self.name_before(self.lines.place(&self.text, usize::from(offset)))
    }

    fn name_before(&self, place: LineColumn) -> Option<&str> {
        let names = &self.converted.names;
        let before = names.partition_point(|(start, _)| *start <= place);
        let (_, name) = names.get(before.checked_sub(1)?)?;
        Some(name)
    }

    /// The same of the part that the first thing in a stretch of the ladder text was made from.
    pub fn name_of(&self, of_ladder: TextRange) -> Option<&str> {
        let made = &self.converted.written.places;
        let first = made.partition_point(|(range, _)| range.start() < of_ladder.start());
        let (_, origin) = made
            .get(first)
            .filter(|(range, _)| range.start() < of_ladder.end())?;
        self.name_before(*self.converted.places.get(*origin as usize)?)
    }

    /// Line and column that a part of the ladder text was made from.
    pub fn place(&self, of_ladder: TextRange) -> LineColumn {
        let start = usize::from(self.range(of_ladder).start());
        self.lines.place(&self.text, start)
    }

    /// What the other system itself complains about, and what has no counterpart here; in the order of the file.
    pub fn remarks(&self) -> Vec<Mark> {
        let found = &self.converted.findings;
        let reported: HashSet<LineColumn> = found.iter().map(|found| found.place).collect();
        let found = found.iter().map(|found| Mark {
            range: self.range_at(found.place),
            check: found.check,
            severity: found.severity,
            message: found.message.clone(),
        });
        let refused = self
            .converted
            .report
            .entries
            .iter()
            .filter_map(|entry| match &entry.outcome {
                Outcome::Refused(why) if !reported.contains(&entry.place) => Some(Mark {
                    range: self.range_at(entry.place),
                    check: NOT_TRANSLATED,
                    severity: Severity::Error,
                    message: format!("`{}` stays as a comment: {why}", entry.element),
                }),
                _ => None,
            });
        let mut remarks: Vec<Mark> = found.chain(refused).collect();
        remarks.sort_by_key(|remark| remark.range.start());
        remarks
    }

    /// Whether the other system, too, would not run it, or a part of it has no counterpart.
    pub fn has_errors(&self) -> bool {
        let found = &self.converted.findings;
        found.iter().any(|found| found.severity == Severity::Error)
            || self.converted.report.tally().refused > 0
    }

    /// The findings of the ladder text, with their places in the shown text. The fixes are left out: they would change a
    /// text that is nowhere.
    pub fn in_file(&self, mut findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
        // The comments that switch rules off are the importer's.
        findings.retain(|finding| finding.rule.name() != UNUSED);
        for finding in &mut findings {
            finding.range = self.range(finding.range);
            finding.fixes.clear();
            // What was made from nothing has no place there, and other systems declare what they use where they use it.
            finding.related.retain_mut(|place| {
                if place.file.is_some() {
                    return true;
                }
                let own = self.own_range(place.range);
                place.range = own.unwrap_or(finding.range);
                place.range != finding.range
            });
        }
        findings.sort_by_key(|finding| finding.range.start());
        findings
    }

    /// The parts of the ladder text that were made from what begins in a stretch of the shown text, in their order.
    pub fn made_from(&self, stretch: TextRange) -> impl Iterator<Item = TextRange> {
        let made = self.converted.written.places.iter();
        made.filter(move |(_, origin)| {
            let place = self.converted.places.get(*origin as usize);
            place.is_some_and(|place| self.begins_in(*place, stretch))
        })
        .map(|(range, _)| *range)
    }

    /// The last place before an offset of the shown text that something was made from, or that there is something to say
    /// about.
    pub fn last_before(&self, offset: TextSize) -> Option<TextSize> {
        let end = self.lines.place(&self.text, usize::from(offset));
        let entries = self.converted.report.entries.iter();
        let places = entries.map(|entry| entry.place);
        let places = places.chain(self.converted.places.iter().copied());
        let last = places.filter(|place| *place < end).max()?;
        Some(TextSize::new(self.lines.offset(&self.text, last) as u32))
    }

    /// Whether a line of the shown text only introduces the line below.
    pub fn introduces(&self, line: TextRange) -> bool {
        self.notation.introduces(&self.text[line])
    }

    /// What became of the elements that begin in a stretch of the shown text.
    pub fn entries_in(&self, stretch: TextRange) -> impl Iterator<Item = &Entry> {
        let entries = self.converted.report.entries.iter();
        entries.filter(move |entry| self.begins_in(entry.place, stretch))
    }

    fn begins_in(&self, place: LineColumn, stretch: TextRange) -> bool {
        let at = self.lines.offset(&self.text, place);
        stretch.contains(TextSize::new(at as u32))
    }

    fn range_at(&self, place: LineColumn) -> TextRange {
        let word = self.lines.word(&self.text, place);
        let length = self.lengths.get(&place).copied();
        let length = length.map_or(word.len(), |length| TextSize::new(length as u32));
        TextRange::at(word.start(), length)
    }

    /// The lengths of the elements that are in the file as the report has them.
    fn measured(&self) -> HashMap<LineColumn, usize> {
        let mut lengths: HashMap<LineColumn, usize> = HashMap::new();
        for entry in &self.converted.report.entries {
            let start = usize::from(self.range_at(entry.place).start());
            if !entry.element.is_empty() && self.text[start..].starts_with(&entry.element) {
                let length = lengths.entry(entry.place).or_default();
                *length = entry.element.len().max(*length);
            }
        }
        lengths
    }
}

/// The content of a file as text: what is not UTF-8 is taken as one character for each byte, as old programs for
/// Windows wrote it. Only LF ends a line in other systems, so a lone CR is shown as a blank.
fn shown(bytes: &[u8]) -> String {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().copied().map(char::from).collect(),
    };
    if !text.contains('\r') {
        return text;
    }
    let mut shown = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let lone = c == '\r' && rest.peek() != Some(&'\n');
        shown.push(if lone { ' ' } else { c });
    }
    shown
}

impl fmt::Debug for Foreign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Foreign").field(&self.notation.name()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lone_carriage_returns_end_no_line() {
        assert_eq!(shown(b"a\rb\r\nc\r"), "a b\r\nc ");
    }
}
