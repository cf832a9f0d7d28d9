//! Conflicts that a merge left in a text (LANGUAGE §7): lines of signs, as git writes them
//!
//! ```text
//! <<<<<<< ours
//! ||||||| base
//! =======
//! >>>>>>> theirs
//! ```
//!
//! or as comments, as `ladder merge` does. Ours is read as if nothing were around it. A line of signs is one token, and so is
//! all from the base, or theirs, to the end of the conflict.

use crate::lexer::blanks_end;
use crate::line::LineKind;
use memchr::memchr2;
use rowan::{TextRange, TextSize};
use std::ops::Range;

/// How many times a sign is on its line.
const SIGNS: usize = 7;

/// What a line of signs begins, or ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// `<<<<<<<`: ours follows.
    Ours,
    /// `|||||||`: what both began with follows.
    Base,
    /// `=======`: theirs follows.
    Theirs,
    /// `>>>>>>>`: the conflict ends.
    End,
}

/// How lines of signs are written. What one form begins, the other does not end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// From the first column on.
    Git,
    /// As a comment that is alone on its line.
    Comment,
}

/// How many conflicts of each form are open where a line begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct OpenConflicts {
    pub(crate) git: u8,
    pub(crate) comment: u8,
}

impl OpenConflicts {
    fn of(&mut self, form: Form) -> &mut u8 {
        match form {
            Form::Git => &mut self.git,
            Form::Comment => &mut self.comment,
        }
    }

    fn has(mut self, form: Form) -> bool {
        *self.of(form) > 0
    }

    /// Whether one is open.
    pub(crate) fn any(self) -> bool {
        self != OpenConflicts::default()
    }
}

/// What the beginning of a physical line is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Within {
    /// Nothing: a logical line begins there.
    Nothing,
    /// A declaration that spans lines.
    Declaration,
    /// A comment that spans lines.
    Comment,
}

/// A line of signs.
#[derive(Debug, Clone, Copy)]
struct Marker {
    sign: Sign,
    form: Form,
    /// After its line end.
    end: usize,
}

impl Marker {
    /// Whether it is one there: a line of `=` may be below a title, and a line of `|` may be rails.
    fn counts(self, open: OpenConflicts, within: Within) -> bool {
        let (is_open, is_alone) = (open.has(self.form), within == Within::Nothing);
        match (self.form, self.sign) {
            (Form::Comment, _) if within == Within::Comment => false,
            (_, Sign::Ours) => true,
            (_, Sign::Base) | (Form::Comment, Sign::Theirs) => is_open,
            (_, Sign::End) | (Form::Git, Sign::Theirs) => is_open || is_alone,
        }
    }
}

/// The line of signs that begins at `at`, where a physical line does.
fn marker(bytes: &[u8], at: usize) -> Option<Marker> {
    let marker = |sign, form| Marker {
        sign,
        form,
        end: line_end(bytes, at),
    };
    match bytes.get(at)? {
        b'<' | b'|' | b'=' | b'>' => {
            let sign = signs(bytes, at)?;
            let is_alone = matches!(bytes.get(at + SIGNS), None | Some(b' ' | b'\t' | b'\n' | b'\r'));
            is_alone.then(|| marker(sign, Form::Git))
        }
        b'#' | b' ' | b'\t' => {
            let hash = blanks_end(bytes, at);
            let first = (bytes.get(hash) == Some(&b'#')).then(|| blanks_end(bytes, hash + 1))?;
            let sign = signs(bytes, first)?;
            let rest = bytes[first + SIGNS..line_end(bytes, first)].trim_ascii_end();
            let closes = memchr::memchr(b'#', rest)? == rest.len() - 1;
            (closes && matches!(rest[0], b' ' | b'\t' | b'#')).then(|| marker(sign, Form::Comment))
        }
        _ => None,
    }
}

/// The sign that is at a place seven times.
fn signs(bytes: &[u8], at: usize) -> Option<Sign> {
    let signs = bytes.get(at..at + SIGNS)?;
    let sign = match signs[0] {
        b'<' => Sign::Ours,
        b'|' => Sign::Base,
        b'=' => Sign::Theirs,
        b'>' => Sign::End,
        _ => return None,
    };
    signs.iter().all(|&sign| sign == signs[0]).then_some(sign)
}

/// Where the physical line ends that holds `at`, its line end included.
fn line_end(bytes: &[u8], at: usize) -> usize {
    match memchr2(b'\n', b'\r', &bytes[at..]) {
        Some(n) if bytes[at + n..].starts_with(b"\r\n") => at + n + 2,
        Some(n) => at + n + 1,
        None => bytes.len(),
    }
}

/// The token of a conflict that begins at `at`, where a physical line does: where it ends, and what is open after it. The lines
/// of signs in it are noted, but for those inside of what is not read.
fn read(
    bytes: &[u8],
    at: usize,
    mut open: OpenConflicts,
    within: Within,
    note: &mut impl FnMut(Sign, Form, Range<usize>),
) -> Option<(usize, OpenConflicts)> {
    let first = marker(bytes, at).filter(|marker| marker.counts(open, within))?;
    let (form, is_open) = (first.form, open.has(first.form));
    let count = open.of(form);
    note(first.sign, form, at..first.end);
    match first.sign {
        Sign::Ours => *count = count.saturating_add(1),
        Sign::End => *count = count.saturating_sub(1),
        Sign::Base | Sign::Theirs if is_open => {
            let (mut at, mut inner) = (first.end, 0u32);
            while at < bytes.len() {
                let Some(next) = marker(bytes, at).filter(|marker| marker.form == form) else {
                    at = line_end(bytes, at);
                    continue;
                };
                if inner == 0 && next.sign != Sign::Ours {
                    note(next.sign, form, at..next.end);
                }
                match next.sign {
                    Sign::End if inner == 0 => {
                        *count -= 1;
                        return Some((next.end, open));
                    }
                    Sign::End => inner -= 1,
                    Sign::Ours => inner += 1,
                    Sign::Base | Sign::Theirs => {}
                }
                at = next.end;
            }
            return Some((at, open));
        }
        Sign::Base | Sign::Theirs => {}
    }
    Some((first.end, open))
}

/// As [`read`], without notes.
pub(crate) fn token(
    text: &str,
    at: usize,
    open: OpenConflicts,
    within: Within,
) -> Option<(usize, OpenConflicts)> {
    read(text.as_bytes(), at, open, within, &mut |_, _, _| {})
}

/// A comment that spans lines, with what it holds of conflicts.
pub(crate) struct Comment {
    /// Where it ends.
    pub(crate) end: usize,
    /// What is open after it.
    pub(crate) open: OpenConflicts,
    /// A line of signs is in it.
    pub(crate) met: bool,
}

/// The comment that opens at `at` and spans lines. A `#` that is not read does not close it.
pub(crate) fn comment(bytes: &[u8], at: usize, mut open: OpenConflicts) -> Comment {
    let (mut at, mut met) = (at + 1, false);
    while let Some(n) = memchr::memchr3(b'#', b'\n', b'\r', &bytes[at..]) {
        if bytes[at + n] == b'#' {
            let end = at + n + 1;
            return Comment { end, open, met };
        }
        at = line_end(bytes, at + n);
        while let Some((end, after)) = read(bytes, at, open, Within::Comment, &mut |_, _, _| {}) {
            (at, open, met) = (end, after, true);
        }
    }
    let end = bytes.len();
    Comment { end, open, met }
}

/// A conflict, or what is left of one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Conflict {
    /// Its lines of signs, from top to bottom, line ends included.
    pub signs: Vec<(Sign, TextRange)>,
}

impl Conflict {
    /// The line of a sign.
    pub fn line(&self, sign: Sign) -> Option<TextRange> {
        self.signs.iter().find(|(s, _)| *s == sign).map(|(_, line)| *line)
    }

    /// Where it is, in a text of this length. Of one that is not finished that is its first line, unless theirs begins: then nothing
    /// is read after it.
    pub fn range(&self, text_len: TextSize) -> TextRange {
        let (first, last) = (self.signs[0], self.signs[self.signs.len() - 1]);
        match (first.0, last.0) {
            (Sign::Ours, Sign::Base | Sign::Theirs) => TextRange::new(first.1.start(), text_len),
            _ => first.1.cover(last.1),
        }
    }
}

/// The conflicts of a text that is not ladder text: each of its lines may be one of signs.
pub fn conflicts(text: &str) -> Vec<Conflict> {
    let mut all = Conflicts::default();
    all.line(
        text,
        LineKind::Conflict,
        TextSize::new(0),
        OpenConflicts::default(),
    );
    all.finish()
}

/// Finds the conflicts of a text in its lines of signs.
#[derive(Default)]
pub(crate) struct Conflicts {
    found: Vec<Conflict>,
    /// Those that are open, from the outermost in, each with how many were found before it.
    open: Vec<(Form, Conflict, usize)>,
}

impl Conflicts {
    /// A logical line that begins at `start`, with `open` before it.
    pub(crate) fn line(&mut self, text: &str, kind: LineKind, start: TextSize, mut open: OpenConflicts) {
        let bytes = text.as_bytes();
        let within = match kind {
            LineKind::Conflict => Within::Nothing,
            LineKind::Declaration | LineKind::StructHeader | LineKind::StructEnd => Within::Declaration,
            _ => Within::Comment,
        };
        let mut at = match within {
            Within::Nothing => text.len() - text.trim_start_matches('\u{feff}').len(),
            _ => line_end(bytes, 0),
        };
        while at < bytes.len() {
            let mut note = |sign, form, place: Range<usize>| {
                let offset = |at: usize| start + TextSize::new(at as u32);
                self.sign(sign, form, TextRange::new(offset(place.start), offset(place.end)));
            };
            match read(bytes, at, open, within, &mut note) {
                Some((end, after)) => (at, open) = (end, after),
                None => at = line_end(bytes, at),
            }
        }
    }

    fn sign(&mut self, sign: Sign, form: Form, line: TextRange) {
        let is_of_form = |(open, ..): &(Form, Conflict, usize)| *open == form;
        let alone = || Conflict {
            signs: vec![(sign, line)],
        };
        if sign == Sign::Ours {
            self.open.push((form, alone(), self.found.len()));
            return;
        }
        let Some(own) = self.open.iter().rposition(is_of_form) else {
            // An end without a beginning is the end of theirs without one.
            match self.found.last_mut().map(|last| &mut last.signs) {
                Some(signs) if sign == Sign::End && matches!(signs[..], [(Sign::Theirs, _)]) => {
                    signs.push((sign, line));
                }
                _ => self.found.push(alone()),
            }
            return;
        };
        let unfinished = self.open.drain(own + 1..).map(|(_, conflict, _)| conflict);
        self.found.extend(unfinished);
        let (_, conflict, found_before) = &mut self.open[own];
        if conflict.line(sign).is_none() {
            conflict.signs.push((sign, line));
        }
        if sign == Sign::End {
            // What is inside of it is for whoever has decided on it.
            self.found.truncate(*found_before);
            self.found
                .extend(self.open.pop().map(|(_, conflict, _)| conflict));
        }
    }

    /// All, from top to bottom.
    pub(crate) fn finish(self) -> Vec<Conflict> {
        let mut all = self.found;
        all.extend(self.open.into_iter().map(|(_, conflict, _)| conflict));
        all.sort_by_key(|conflict| conflict.signs[0].1.start());
        all
    }
}
