//! Reasons in words: each node of the tree has a sentence, and the text for a terminal is made of them.

use super::{Cause, Judged, Judgement, Reason, Since, Why, Write};
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::program::Location;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_syntax::{LineColumn, LineIndex};
use std::fmt;

impl Why {
    /// The reasons for people, a line for each tag: `run is 0 since scan 12 (120 ms): line 3, ( )( run ) wrote it;
    /// blocked by [/]( stop ) (line 3, column 20): stop is 1`. `texts` are those of the program's files, whose
    /// names are in the same order.
    pub fn text(&self, texts: &[&str], files: &[String]) -> String {
        Wording::new(texts, files).text(self)
    }

    /// What wrote the tag, then what keeps it off now.
    pub fn writes(&self) -> impl Iterator<Item = &Write> {
        let then = match &self.cause {
            Cause::Block(write) => Some(write),
            _ => None,
        };
        then.into_iter().chain(&self.now).map(AsRef::as_ref)
    }
}

/// Puts the nodes of a tree of reasons into words.
#[derive(Debug)]
pub struct Wording<'t> {
    texts: &'t [&'t str],
    files: &'t [String],
    indexes: Vec<LineIndex>,
    places: Option<Places<'t>>,
}

/// Where blocks are in files that are translated where they are read.
struct Places<'t>(&'t dyn Fn(Location) -> Option<LineColumn>);

impl fmt::Debug for Places<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Places")
    }
}

impl<'t> Wording<'t> {
    /// For a program whose files have these texts and names.
    pub fn new(texts: &'t [&'t str], files: &'t [String]) -> Wording<'t> {
        let indexes = texts.iter().map(|text| LineIndex::new(text)).collect();
        Wording {
            texts,
            files,
            indexes,
            places: None,
        }
    }

    /// The same where some of the files are translated where they are read: `places` says of those where a block is in the file.
    #[must_use]
    pub fn with_places(self, places: &'t dyn Fn(Location) -> Option<LineColumn>) -> Wording<'t> {
        let places = Some(Places(places));
        Wording { places, ..self }
    }

    /// As [`Why::text`].
    pub fn text(&self, why: &Why) -> String {
        let mut lines = Vec::new();
        self.lines(why, 0, &mut lines);
        lines.join("\n")
    }

    /// Why a tag holds what it holds: one sentence, without what lies deeper.
    pub fn why(&self, why: &Why) -> String {
        let since = match why.since {
            Since::Start => "since the start".to_owned(),
            Since::Longer => "since before the scans that are kept".to_owned(),
            Since::Scan { scan, time } => {
                format!("since scan {scan} ({} ms)", value_text::milliseconds(time))
            }
        };
        let value = value(&why.point, &why.value);
        let cause = match &why.cause {
            Cause::Initial if why.point.is_input => "nothing else was given".to_owned(),
            Cause::Initial => "nothing has written it".to_owned(),
            Cause::Given => "it was given from outside".to_owned(),
            Cause::Forced => "it is forced".to_owned(),
            Cause::System => "the simulation keeps it".to_owned(),
            Cause::Unknown => "what wrote it is not known".to_owned(),
            Cause::Block(write) => self.write(write),
        };
        let mut line = format!("{} is {value} {since}: {cause}", why.point.name);
        if let Some(now) = &why.now {
            line.push_str(&format!("; now, in scan {}, it is {}", now.scan, self.way(now)));
        }
        line
    }

    /// The reasons of a judgement for people: a line for each tag, those that it was followed back to below it.
    pub fn judged_text(&self, judged: &Judged) -> String {
        let mut lines = Vec::new();
        self.judged_lines(judged, 0, &mut lines);
        lines.join("\n")
    }

    fn judged_lines(&self, judged: &Judged, depth: usize, lines: &mut Vec<String>) {
        lines.push(format!(
            "{:indent$}{}",
            "",
            self.judged(judged),
            indent = depth * 2
        ));
        for because in &judged.because {
            self.judged_lines(because, depth + 1, lines);
        }
    }

    /// Why a tag holds what a table says, or what contradicts that: one sentence, without the tags that it was followed back to.
    pub fn judged(&self, judged: &Judged) -> String {
        let point = &judged.point;
        let mut line = format!("{} is {}", point.name, value(point, &judged.value));
        if !judged.is_given {
            line.push_str(", though not in the table");
        }
        if judged.contradiction().is_some() {
            line.push_str(", against the program");
        } else if !judged.missing.is_empty() {
            line.push_str(", as far as the table goes");
        } else if let [first, ..] = judged.undecided() {
            let name = &first.name;
            line.push_str(&format!(
                ", which the table does not decide ({name} is written after it was read)"
            ));
        }
        let blocks = match (judged.writers, judged.judgements.is_empty()) {
            (0, _) if point.is_input => "it is an input".to_owned(),
            (0, _) => "no network writes it".to_owned(),
            (1, true) => "the block that writes it is not reached".to_owned(),
            (writers, true) => format!("none of the {writers} blocks that write it is reached"),
            _ => {
                let blocks = judged.judgements.iter();
                let blocks: Vec<String> = blocks.map(|it| self.judgement(point, it)).collect();
                blocks.join("; then ")
            }
        };
        format!("{line}: {blocks}")
    }

    fn judgement(&self, point: &Point, judgement: &Judgement) -> String {
        let (line, block) = self.line(judgement.write.block);
        let does = if judgement.writes {
            format!("writes {}", value(point, &judgement.leaves))
        } else {
            "does not write it".to_owned()
        };
        let indices = in_brackets(&judgement.write.indices);
        let called = self.called(&judgement.write);
        format!(
            "{line}, {block} {does}{called}{indices}; {}",
            self.way(&judgement.write)
        )
    }

    fn lines(&self, why: &Why, depth: usize, lines: &mut Vec<String>) {
        let line = self.why(why);
        // The same tag may be in several contacts.
        if lines.iter().any(|known| known.trim_start() == line) {
            return;
        }
        lines.push(format!("{:indent$}{line}", "", indent = depth * 2));
        for write in why.writes() {
            let reasons = write.reasons.iter().flatten();
            let because = reasons.flat_map(|reason| &reason.because);
            for because in because.chain(&write.because) {
                self.lines(because, depth + 1, lines);
            }
        }
    }

    fn write(&self, write: &Write) -> String {
        let (line, block) = self.line(write.block);
        let indices = write.indices.iter().filter(|index| !write.read.contains(index));
        let read: Vec<(Point, Value)> = write.read.iter().chain(indices).cloned().collect();
        let read = in_brackets(&read);
        let called = self.called(write);
        format!("{line}, {block} wrote it{called}{read}; {}", self.way(write))
    }

    /// Through which of the calls of a function.
    fn called(&self, write: &Write) -> String {
        write.called.map_or_else(String::new, |call| {
            let (line, call) = self.line(call);
            format!(", called by {call} ({line})")
        })
    }

    /// How power came, or what blocked it.
    fn way(&self, write: &Write) -> String {
        let ways: Vec<String> = write
            .reasons
            .iter()
            .filter(|way| !way.is_empty())
            .map(|way| {
                let reasons: Vec<String> = way.iter().map(|reason| self.reason(reason)).collect();
                reasons.join(if write.power { ", " } else { " and by " })
            })
            .collect();
        match (write.power, ways.as_slice()) {
            (true, []) => "power came straight from the rail".to_owned(),
            (true, _) => format!("power came through {}", ways.join("; ")),
            (false, []) => "no power can reach it".to_owned(),
            (false, _) => format!("blocked by {}", ways.join("; or else by ")),
        }
    }

    /// What passes power on or stops it, and what it read: `[ ]( start ) (line 1, column 7): start is 1`.
    pub fn reason(&self, reason: &Reason) -> String {
        let (line, block) = self.line(reason.block);
        if reason.is_rail {
            return format!("the left rail ({line}): an <MCR> has switched it off");
        }
        let (_, column, _) = self.place(reason.block);
        let place = format!("{block} ({line}, column {column})");
        if reason.values.is_empty() {
            place
        } else {
            format!("{place}: {}", values(&reason.values))
        }
    }

    /// A block as it is drawn.
    pub fn drawn(&self, block: Location) -> &'t str {
        self.place(block).2
    }

    /// The line of a block in words, with its file where that is another; and the block as it is drawn.
    fn line(&self, location: Location) -> (String, &'t str) {
        let (line, _, block) = self.place(location);
        let other = self
            .files
            .get(location.file as usize)
            .filter(|_| location.file > 0);
        let words = match other {
            Some(file) => format!("line {line} of {file}"),
            None => format!("line {line}"),
        };
        (words, block)
    }

    /// Line, column and text of a block, as far as its first line goes.
    pub fn place(&self, location: Location) -> (u32, u32, &'t str) {
        let file = location.file as usize;
        let (Some(text), Some(index)) = (self.texts.get(file), self.indexes.get(file)) else {
            return (0, 0, "");
        };
        let range = usize::from(location.range.start())..usize::from(location.range.end());
        let Some(drawn) = text.get(range) else {
            return (0, 0, "");
        };
        let elsewhere = self.places.as_ref().and_then(|places| (places.0)(location));
        let place = elsewhere.unwrap_or_else(|| index.line_column(text, location.range.start()));
        (place.line, place.column, drawn.lines().next().unwrap_or_default())
    }
}

/// ` (x is 1, n is 7)`; nothing where there is none.
fn in_brackets(of: &[(Point, Value)]) -> String {
    if of.is_empty() {
        String::new()
    } else {
        format!(" ({})", values(of))
    }
}

/// `x is 1, n is 7`
fn values(values: &[(Point, Value)]) -> String {
    let values: Vec<String> = values
        .iter()
        .map(|(point, it)| format!("{} is {}", point.name, value(point, it)))
        .collect();
    values.join(", ")
}

/// BOOL as 0 and 1, all else as the language writes it.
fn value(point: &Point, value: &Value) -> String {
    if point.ty == Scalar::Bool {
        value_text::cell(value, point.ty)
    } else {
        value_text::display(value, point.ty)
    }
}
