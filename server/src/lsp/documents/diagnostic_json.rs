//! A finding as the JSON of a diagnostic, in which the numbers of lines can be exchanged.
//!
//! What a finding says stays as it is while text comes or goes above it, and so do the columns of its places. So its JSON is
//! kept with the places of its line numbers, and each of these with the line that it counts from: that of a network or a
//! line of declarations.

use std::cell::{Cell, OnceCell};
use std::fmt::Write;

use ladder_analysis::Diagnostic;
use ladder_syntax::TextRange;
use tower_lsp::ls_types;

use crate::document::positions::Positions;
use crate::document::{Beside, Revision, position};
use crate::lsp::capabilities::Agreed;
use crate::lsp::convert;

/// The rules that mark text without effect: editors show it faded.
const UNNECESSARY: [&str; 3] = ["unreachable", "unused-function", "unused-label"];

/// The JSON of a diagnostic.
#[derive(Debug, Default)]
pub(crate) struct Json {
    text: String,
    numbers: Vec<LineNumber>,
}

/// The number of a line in a text.
#[derive(Debug, Clone, Copy)]
struct LineNumber {
    /// Where it is.
    at: u32,
    digits: u32,
    /// Which of the lines it counts from, and how far it is below that.
    from: u32,
    below: u32,
}

/// Writes the findings of a text.
pub(crate) struct Writer<'r> {
    agreed: Agreed,
    revision: &'r Revision,
    ranges: Ranges<'r>,
    beside: Beside<'r>,
}

impl<'r> Writer<'r> {
    /// Of this text.
    pub(crate) fn new(agreed: Agreed, revision: &'r Revision) -> Self {
        Writer {
            agreed,
            revision,
            ranges: Ranges::new(revision),
            beside: Beside::new(revision),
        }
    }

    /// A finding. Its places count from these lines: all from one, or each from its own; none if they are true for this text
    /// only.
    pub(crate) fn write(&mut self, found: &Diagnostic, lines: &[u32]) -> Json {
        let mut json = Json::default();
        json.text.push_str("{\"range\":");
        json.range(self.ranges.range(found.range), first_line(lines, 0));
        let severity = serde_json::to_string(&convert::severity(found.severity));
        json.member("severity", &severity.unwrap_or_default());
        json.member("code", &quoted(found.rule.name()));
        json.member("source", "\"ladder\"");
        json.text.push_str(",\"message\":\"");
        json.words(&found.message);
        if let Some(help) = &found.help {
            json.words("\n");
            json.words(help);
        }
        if self.agreed.related_information {
            json.text.push('"');
            self.related(&mut json, found, lines);
        } else {
            self.related_in_words(&mut json, found, lines);
            json.text.push('"');
        }
        if self.agreed.unnecessary_tag && UNNECESSARY.contains(&found.rule.name()) {
            json.member("tags", "[1]");
        }
        if self.agreed.diagnostic_data && !found.fixes.is_empty() {
            let titles = found.fixes.iter().map(|fix| quoted(&fix.title));
            let titles: Vec<String> = titles.collect();
            json.member("data", &format!("{{\"fixes\":[{}]}}", titles.join(",")));
        }
        json.text.push('}');
        json.text.shrink_to_fit();
        json.numbers.shrink_to_fit();
        json
    }

    /// A finding in the protocol's own type, for those who send it within something else.
    pub(crate) fn typed(&mut self, found: &Diagnostic) -> Option<ls_types::Diagnostic> {
        serde_json::from_str(self.write(found, &[]).as_str()).ok()
    }

    /// The related places, each with its link.
    fn related(&mut self, json: &mut Json, found: &Diagnostic, lines: &[u32]) {
        let mut own = 1..;
        let mut any = false;
        for related in &found.related {
            let (address, place, from) = match &related.file {
                None => {
                    let place = self.ranges.range(related.range);
                    let from = own.next().and_then(|own| first_line(lines, own));
                    (quoted(&self.revision.uri), place, from)
                }
                Some(file) => {
                    let Some((address, place)) = self.beside.range(file, related.range) else {
                        continue;
                    };
                    (quoted(&address), place, None)
                }
            };
            let before = if any { "," } else { ",\"relatedInformation\":[" };
            any = true;
            let _ = write!(json.text, "{before}{{\"location\":{{\"uri\":{address},\"range\":");
            json.range(place, from);
            json.text.push('}');
            json.member("message", &quoted(&related.message));
            json.text.push('}');
        }
        if any {
            json.text.push(']');
        }
    }

    /// A client that cannot link other places still gets to know of them: by the numbers of their lines, which people count from 1.
    fn related_in_words(&mut self, json: &mut Json, found: &Diagnostic, lines: &[u32]) {
        let mut own = 1..;
        for related in &found.related {
            match &related.file {
                None => {
                    let from = own.next().and_then(|own| first_line(lines, own));
                    json.words("\nline ");
                    json.line_number(self.line(related.range) + 1, from);
                }
                Some(file) => {
                    let Some((_, place)) = self.beside.range(file, related.range) else {
                        continue;
                    };
                    json.words(&format!("\n{file}, line {}", place.start.line + 1));
                }
            }
            json.words(": ");
            json.words(&related.message);
        }
    }

    fn line(&self, place: TextRange) -> u32 {
        self.ranges.range(place).start.line
    }
}

/// The line that a place counts from, and which of the lines that is. The first place is that of the finding itself.
fn first_line(lines: &[u32], place: usize) -> Option<(u32, u32)> {
    let number = if lines.len() == 1 { 0 } else { place };
    Some((*lines.get(number)?, number as u32))
}

/// This many places are looked up one by one; for more a table of all lines costs less.
const FEW: usize = 100;

/// What counts the lines and columns of findings.
struct Ranges<'r> {
    revision: &'r Revision,
    asked: Cell<usize>,
    many: OnceCell<Positions>,
}

impl<'r> Ranges<'r> {
    /// Of a text, for places of which nobody knows yet how many there are.
    fn new(revision: &'r Revision) -> Self {
        Ranges {
            revision,
            asked: Cell::new(0),
            many: OnceCell::new(),
        }
    }

    /// The lines and columns of a stretch.
    fn range(&self, place: TextRange) -> position::Range {
        self.asked.update(|asked| asked + 1);
        if self.asked.get() <= FEW {
            return self.revision.range(place);
        }
        self.many.get_or_init(|| self.revision.positions()).range(place)
    }
}

/// A text as JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

impl Json {
    /// The text.
    pub(crate) fn as_str(&self) -> &str {
        &self.text
    }

    /// Exchanges the numbers of lines: the lines that places count from are these now.
    pub(crate) fn count_from(&mut self, lines: &[u32], room: &mut String) {
        room.clear();
        let mut end = 0;
        for number in &mut self.numbers {
            let at = number.at as usize;
            room.push_str(&self.text[end..at]);
            end = at + number.digits as usize;
            let line = lines.get(number.from as usize).copied().unwrap_or_default();
            number.at = room.len() as u32;
            push_number(room, line + number.below);
            number.digits = room.len() as u32 - number.at;
        }
        room.push_str(&self.text[end..]);
        self.text.clear();
        self.text.push_str(room);
    }

    fn range(&mut self, range: position::Range, from: Option<(u32, u32)>) {
        self.text.push_str("{\"start\":");
        self.position(range.start, from);
        self.text.push_str(",\"end\":");
        self.position(range.end, from);
        self.text.push('}');
    }

    fn position(&mut self, position: position::Position, from: Option<(u32, u32)>) {
        self.text.push_str("{\"line\":");
        self.line_number(position.line, from);
        self.text.push_str(",\"character\":");
        push_number(&mut self.text, position.character);
        self.text.push('}');
    }

    fn line_number(&mut self, number: u32, from: Option<(u32, u32)>) {
        let at = self.text.len() as u32;
        push_number(&mut self.text, number);
        if let Some((line, from)) = from {
            self.numbers.push(LineNumber {
                at,
                digits: self.text.len() as u32 - at,
                from,
                below: number.saturating_sub(line),
            });
        }
    }

    /// Adds to a text that has begun.
    fn words(&mut self, words: &str) {
        let quoted = quoted(words);
        self.text.push_str(&quoted[1..quoted.len() - 1]);
    }

    fn member(&mut self, name: &str, value: &str) {
        for piece in [",\"", name, "\":", value] {
            self.text.push_str(piece);
        }
    }
}

/// Adds a number: most of what is written anew behind an edit are numbers.
fn push_number(text: &mut String, number: u32) {
    let mut digits = [0; 10];
    let mut first = digits.len();
    let mut rest = number;
    loop {
        first -= 1;
        digits[first] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    text.extend(digits[first..].iter().map(|digit| char::from(*digit)));
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::document::Documents;
    use crate::document::position::Encoding;

    /// Findings with a fix, with a related place, and about text without effect.
    const TEXT: &str = "VAR x, y : BOOL; END_VAR\n\n+--[ ]( ö )--( )( y )--+\n\n+--[ ]( y )--( )( y )--+\n\n\
        +--[ ]( y )--( )( x )--+\n\n+--<END>()--+\n\n+--[ ]( y )--( )( x )--+\n";

    /// What a client gets that takes all of this, or nothing of it: a diagnostic a line.
    fn check(can: bool, expected: &Expect) {
        let agreed = Agreed {
            related_information: can,
            unnecessary_tag: can,
            diagnostic_data: can,
            ..Agreed::default()
        };
        let revision = Documents::default().open("file:///a.clad", 1, Encoding::Utf16, TEXT);
        let analysis = revision.analysis().expect("the text is not too large");
        let mut writer = Writer::new(agreed, &revision);
        let mut all = String::new();
        for finding in analysis.findings() {
            all.push_str(writer.write(&finding.diagnostic(), &[]).as_str());
            all.push('\n');
        }
        expected.assert_eq(&all);
    }

    #[test]
    fn all_that_a_diagnostic_consists_of() {
        check(
            true,
            &expect![[r#"
            {"range":{"start":{"line":2,"character":8},"end":{"line":2,"character":9}},"severity":2,"code":"undeclared-tag","source":"ladder","message":"`ö` is not declared\ndeclare it, so that a typing mistake cannot make a new tag","data":{"fixes":["Declare `ö : BOOL` in VAR_INPUT"]}}
            {"range":{"start":{"line":4,"character":18},"end":{"line":4,"character":19}},"severity":2,"code":"double-coil","source":"ladder","message":"`y` is written by 2 coils: the last one alone decides\nlead all conditions to one coil, joined with \\ and /; or use (S) and (R)","relatedInformation":[{"location":{"uri":"file:///a.clad","range":{"start":{"line":2,"character":18},"end":{"line":2,"character":19}}},"message":"`y` is written here as well"}]}
            {"range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}},"severity":2,"code":"unconditional-end","source":"ladder","message":"<END> stops the program for good, and no condition is before it: only one scan runs\na program needs no end; <RET> ends the scan, as END does in other controllers","data":{"fixes":["End the scan only: <RET>"]}}
            {"range":{"start":{"line":10,"character":0},"end":{"line":10,"character":24}},"severity":2,"code":"unreachable","source":"ladder","message":"no scan ever comes to this rung\nput a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it","relatedInformation":[{"location":{"uri":"file:///a.clad","range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}}},"message":"this always ends the program"}],"tags":[1]}
        "#]],
        );
    }

    #[test]
    fn related_places_in_words() {
        check(
            false,
            &expect![[r#"
            {"range":{"start":{"line":2,"character":8},"end":{"line":2,"character":9}},"severity":2,"code":"undeclared-tag","source":"ladder","message":"`ö` is not declared\ndeclare it, so that a typing mistake cannot make a new tag"}
            {"range":{"start":{"line":4,"character":18},"end":{"line":4,"character":19}},"severity":2,"code":"double-coil","source":"ladder","message":"`y` is written by 2 coils: the last one alone decides\nlead all conditions to one coil, joined with \\ and /; or use (S) and (R)\nline 3: `y` is written here as well"}
            {"range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}},"severity":2,"code":"unconditional-end","source":"ladder","message":"<END> stops the program for good, and no condition is before it: only one scan runs\na program needs no end; <RET> ends the scan, as END does in other controllers"}
            {"range":{"start":{"line":10,"character":0},"end":{"line":10,"character":24}},"severity":2,"code":"unreachable","source":"ladder","message":"no scan ever comes to this rung\nput a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it\nline 9: this always ends the program"}
        "#]],
        );
    }
}
