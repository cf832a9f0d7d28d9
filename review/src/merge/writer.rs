//! The result of a merge as it is written, and the check that it holds what it should.

use super::conflict::{Clash, Conflict};
use super::{Merged, NotMerged, Sides};
use crate::outline::{Entry, Kind, Outline};
use ladder_analysis::context;
use ladder_syntax::TextRange;
use std::sync::Arc;

/// Puts the text together.
pub(super) struct Writer<'o> {
    sides: Sides<'o>,
    line_end: &'static str,
    text: String,
    conflicts: Vec<Conflict>,
    /// The entries that the text should hold, in order.
    expected: Vec<&'o Entry>,
    /// The last line is a comment, which whatever is right below it would take for its own.
    ends_in_comment: bool,
}

impl<'o> Writer<'o> {
    pub(super) fn new(sides: Sides<'o>) -> Writer<'o> {
        let ours = sides.ours.context.parse.lines().first();
        let ours = ours.map_or("", |line| line.text());
        Writer {
            sides,
            line_end: if ours.ends_with("\r\n") {
                "\r\n"
            } else if ours.ends_with('\r') {
                "\r"
            } else {
                "\n"
            },
            text: String::new(),
            conflicts: Vec::new(),
            expected: Vec::new(),
            ends_in_comment: false,
        }
    }

    /// An entry; of one that holds others its first line.
    pub(super) fn entry(&mut self, outline: &Outline, entry: &'o Entry) {
        let takes_comments = !matches!(entry.kind, Kind::Setting | Kind::Unread);
        if self.ends_in_comment && takes_comments && entry.range.start() == entry.shown.start() {
            self.text.push_str(self.line_end);
        }
        self.copy(outline, entry.range);
        self.expected.push(entry);
        self.ends_in_comment = entry.kind == Kind::Comment;
    }

    /// The last line of an entry that holds others.
    pub(super) fn end(&mut self, outline: &Outline, entry: &Entry) {
        if entry.kind.holds_others() {
            self.copy(outline, entry.end);
            self.ends_in_comment = false;
        }
    }

    /// Both forms of an entry, between comments.
    pub(super) fn conflict(&mut self, clash: Clash, ours: Option<&'o Entry>, theirs: Option<&'o Entry>) {
        let Some(entry) = ours.or(theirs) else { return };
        self.begin_conflict(clash, entry);
        self.line(match clash {
            Clash::OursRemoved => "# <<<<<<< ours: removed #",
            _ => "# <<<<<<< ours #",
        });
        self.form(self.sides.ours, ours);
        self.line("# ======= #");
        // Theirs is not read: it is in the text as it is, next to ours.
        let expected = self.expected.len();
        self.form(self.sides.theirs, theirs);
        self.expected.truncate(expected);
        self.line(match clash {
            Clash::TheirsRemoved => "# >>>>>>> theirs: removed #",
            _ => "# >>>>>>> theirs #",
        });
        self.ends_in_comment = true;
    }

    /// The comments of an entry that ours has with others: those of theirs, as a conflict.
    pub(super) fn comments(&mut self, theirs: &Entry) {
        self.begin_conflict(Clash::BothEdited, theirs);
        self.line("# <<<<<<< ours: as below #");
        self.line("# ======= #");
        let comments = theirs.comments.trim().to_owned();
        if !comments.is_empty() {
            self.line(&comments);
        }
        self.line("# >>>>>>> theirs #");
        self.ends_in_comment = true;
    }

    fn begin_conflict(&mut self, clash: Clash, entry: &Entry) {
        self.conflicts.push(Conflict {
            clash,
            kind: entry.kind,
            place: entry.place.to_string(),
            title: entry.title.clone(),
        });
        self.text.push_str(self.line_end);
    }

    fn form(&mut self, outline: &Outline, entry: Option<&'o Entry>) {
        let Some(entry) = entry else { return };
        self.copy(outline, entry.shown);
        self.expected.push(entry);
        self.inside(outline, entry);
    }

    fn inside(&mut self, outline: &Outline, entry: &'o Entry) {
        for inner in &entry.inside {
            self.copy(outline, inner.range);
            self.expected.push(inner);
            self.inside(outline, inner);
        }
        if entry.kind.holds_others() {
            self.copy(outline, entry.end);
        }
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(self.line_end);
    }

    /// A stretch of a text, with the line ends of ours and one at its end.
    fn copy(&mut self, outline: &Outline, range: TextRange) {
        let text = outline.text(range);
        let text = text.trim_start_matches('\u{feff}');
        let mut rest = text;
        while let Some(at) = rest.find(['\n', '\r']) {
            self.text.push_str(&rest[..at]);
            self.text.push_str(self.line_end);
            let end = if rest[at..].starts_with("\r\n") { 2 } else { 1 };
            rest = &rest[at + end..];
        }
        if !rest.is_empty() {
            self.text.push_str(rest);
            self.text.push_str(self.line_end);
        }
    }

    /// The text, if it holds what it should.
    pub(super) fn finish(self) -> Result<Merged, NotMerged> {
        let parse = Arc::new(ladder_syntax::parse(&self.text));
        let read = Outline::new(Arc::new(context(&parse, "")));
        let mut found = Vec::new();
        flatten(&read.entries, &mut found);
        // The signs of conflicts are comments, too.
        let counts = |entry: &&Entry| self.conflicts.is_empty() || entry.kind != Kind::Comment;
        let found = found.into_iter().filter(counts);
        let expected = self.expected.iter().copied().filter(counts);
        let is_whole = found.map(says).eq(expected.map(says));
        let comments_stay = !self.conflicts.is_empty() || {
            let all = self.expected.iter().map(|entry| entry.comments.as_str());
            let mut found = Vec::new();
            flatten(&read.entries, &mut found);
            found.iter().map(|entry| entry.comments.as_str()).eq(all)
        };
        if !is_whole || !comments_stay {
            return Err(NotMerged::Mixed);
        }
        let mut text = self.text;
        let ours = &self.sides.ours.context.parse;
        if ours
            .lines()
            .first()
            .is_some_and(|line| line.text().starts_with('\u{feff}'))
        {
            text.insert(0, '\u{feff}');
        }
        Ok(Merged {
            text,
            conflicts: self.conflicts,
            refused: Vec::new(),
        })
    }
}

fn says(entry: &Entry) -> (Kind, &str) {
    (entry.kind, &entry.told.key)
}

fn flatten<'e>(entries: &'e [Entry], out: &mut Vec<&'e Entry>) {
    for entry in entries {
        out.push(entry);
        flatten(&entry.inside, out);
    }
}
