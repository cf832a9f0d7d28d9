//! A program of another system, beside the ladder text that it becomes: what is found in that text is shown in the
//! file that a person wrote.

use crate::outcome::Failure;
use ladder_analysis::Severity;
use ladder_interchange::notation::{
    Companion, Converted, Lines, Notation, Outcome, Place, ReadError, Source, convert,
};
use ladder_syntax::{TextRange, TextSize};
use std::collections::{HashMap, HashSet};
use std::fmt;
use std::path::Path;

/// What stands where the name of a rule would, for an element without a counterpart.
const NOT_TRANSLATED: &str = "not-translated";

/// A foreign program that was read.
pub(crate) struct Foreign {
    notation: &'static dyn Notation,
    /// The file as it is shown. Places count as in the file itself.
    text: String,
    lines: Lines,
    converted: Converted,
    /// How many bytes what stands at a place takes.
    lengths: HashMap<Place, usize>,
    /// Where each name of the ladder text is used first.
    uses: HashMap<String, Place>,
}

/// What there is to say about a foreign program before it is ladder text.
pub(crate) struct Remark {
    /// In the shown text.
    pub(crate) range: TextRange,
    /// The check that found it.
    pub(crate) check: &'static str,
    pub(crate) severity: Severity,
    pub(crate) message: String,
}

impl Foreign {
    /// Reads a program.
    ///
    /// # Errors
    /// As for [`Notation::read`].
    pub(crate) fn read(notation: &'static dyn Notation, source: &Source<'_>) -> Result<Foreign, ReadError> {
        let options = ladder_format::Options::default();
        let converted = convert(notation, source, &options)?;
        let text = shown(source.bytes);
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
    pub(crate) fn notation(&self) -> &'static str {
        self.notation.name()
    }

    /// Whether its coils are what a run is about.
    pub(crate) fn shows_coils(&self) -> bool {
        self.notation.shows_coils()
    }

    /// The file as it is shown.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// The ladder text that it becomes.
    pub(crate) fn ladder(&self) -> &str {
        &self.converted.written.text
    }

    /// What a part of the ladder text was made from, in the shown text.
    pub(crate) fn range(&self, of_ladder: TextRange) -> TextRange {
        let place = self.first_use(of_ladder);
        self.range_at(place.unwrap_or_else(|| self.converted.place_of(of_ladder.start())))
    }

    /// Of a name in something that was made from nothing, such as the declaration of a tag that the other system does not
    /// declare: where that name is used first.
    fn first_use(&self, of_ladder: TextRange) -> Option<Place> {
        let written = &self.converted.written;
        if written
            .places
            .iter()
            .any(|(range, _)| range.contains(of_ladder.start()))
        {
            return None;
        }
        let name = self.ladder().get(std::ops::Range::<usize>::from(of_ladder))?;
        self.uses.get(name).copied()
    }

    /// Where each name of the ladder text is used first.
    fn used(&self) -> HashMap<String, Place> {
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

    /// Line and column that a part of the ladder text was made from.
    #[cfg(feature = "screen")]
    pub(crate) fn place(&self, of_ladder: TextRange) -> Place {
        let start = usize::from(self.range(of_ladder).start());
        self.lines.place(&self.text, start)
    }

    /// What the other system itself complains about, and what has no counterpart here; in the order of the file.
    pub(crate) fn remarks(&self) -> Vec<Remark> {
        let found = &self.converted.findings;
        let told: HashSet<Place> = found.iter().map(|found| found.place).collect();
        let found = found.iter().map(|found| Remark {
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
                Outcome::Refused(why) if !told.contains(&entry.place) => Some(Remark {
                    range: self.range_at(entry.place),
                    check: NOT_TRANSLATED,
                    severity: Severity::Error,
                    message: format!("`{}` stays as a comment: {why}", entry.element),
                }),
                _ => None,
            });
        let mut remarks: Vec<Remark> = found.chain(refused).collect();
        remarks.sort_by_key(|remark| remark.range.start());
        remarks
    }

    /// Whether the other system, too, would not run it, or a part of it has no counterpart.
    pub(crate) fn has_errors(&self) -> bool {
        let found = &self.converted.findings;
        found.iter().any(|found| found.severity == Severity::Error)
            || self.converted.report.tally().refused > 0
    }

    fn range_at(&self, place: Place) -> TextRange {
        let start = self.lines.offset(&self.text, place);
        let rest = &self.text[start..];
        let blanks = rest.len() - rest.trim_start_matches([' ', '\t', '\u{feff}']).len();
        let start = start + blanks;
        let length = self.lengths.get(&place).copied();
        let length = length.unwrap_or_else(|| word(&self.text[start..]));
        TextRange::at(TextSize::new(start as u32), TextSize::new(length as u32))
    }

    /// The lengths of the elements that stand in the file as the report has them.
    fn measured(&self) -> HashMap<Place, usize> {
        let mut lengths: HashMap<Place, usize> = HashMap::new();
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

/// The files beside a program of another system that belong to it.
///
/// # Errors
/// One of them cannot be read.
pub(crate) fn companions(notation: &'static dyn Notation, program: &Path) -> Result<Vec<Companion>, Failure> {
    let stem = program
        .file_stem()
        .map(|stem| stem.to_string_lossy())
        .unwrap_or_default();
    let wanted = |file: &str| notation.has_companion(&stem, file);
    let found = ladder_workspace::read_beside(program, &wanted)?;
    Ok(found
        .into_iter()
        .map(|(name, bytes)| Companion { name, bytes })
        .collect())
}

/// The length of the first word.
fn word(text: &str) -> usize {
    text.find(|c: char| c.is_whitespace() || ",;(){}<>".contains(c))
        .unwrap_or(text.len())
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
    use ladder_interchange::notation::by_name;

    fn read(notation: &str, bytes: &[u8]) -> Foreign {
        let notation = by_name(notation).expect("the notation is registered");
        Foreign::read(notation, &Source::alone("test", bytes)).unwrap_or_else(|error| panic!("{error}"))
    }

    /// What the first part of the ladder text with this spelling was made from.
    fn origin<'f>(foreign: &'f Foreign, spelling: &str) -> &'f str {
        let at = foreign.ladder().find(spelling).expect("it is in the ladder text");
        let range = TextRange::at(TextSize::new(at as u32), TextSize::of(spelling));
        &foreign.text()[foreign.range(range)]
    }

    #[test]
    fn what_something_was_made_from() {
        let foreign = read("textbook", b"start open contact I0.1 &\r\n  active coil Q0 end\n");
        assert_eq!(origin(&foreign, "[ ]( I0 )"), "open contact I0.1");
        assert_eq!(origin(&foreign, "( )( Q0 )"), "active coil Q0");
    }

    #[test]
    fn a_tag_that_is_declared_nowhere_is_where_it_is_used() {
        let foreign = read(
            "ldmicro",
            b"LDmicro0.1\nIO LIST\nEND\nPROGRAM\nRUNG\n    CONTACTS Xa 0\n    COIL Rb 0 0 0\nEND\n",
        );
        assert!(foreign.ladder().contains("Rb : BOOL;"));
        assert_eq!(origin(&foreign, "Rb"), "COIL Rb 0 0 0");
    }

    #[test]
    fn old_encodings() {
        let program = b"LDmicro0.1\nIO LIST\nEND\nPROGRAM\nRUNG\n COMMENT T\xfcr\nEND\nRUNG\n    COIL Y\xfc 0 0 0\nEND\n";
        let foreign = read("ldmicro", program);
        assert!(foreign.text().contains("COMMENT Tür"));
        assert_eq!(origin(&foreign, "( )("), "COIL Yü 0 0 0");
    }

    #[test]
    fn lone_carriage_returns_end_no_line() {
        assert_eq!(shown(b"a\rb\r\nc\r"), "a b\r\nc ");
    }
}
