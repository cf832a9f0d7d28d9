//! A finding as the JSON of a diagnostic, in which the numbers of lines can be exchanged.
//!
//! What a finding says stays as it is while text comes or goes above it, and so do the columns of its places. So its JSON is
//! kept with the places of its line numbers, and each of these with the line that it counts from: that of a network or a
//! line of declarations.

use std::fmt::Write;

use ladder_analysis::Diagnostic;
use ladder_syntax::TextRange;

use crate::document::{Beside, Revision, position};
use crate::lsp::capabilities::Agreed;
use crate::lsp::convert::{self, Ranges};

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

    /// A finding as [`convert::diagnostics`] gives it. Its places count from these lines: all from one, or each from its own; none if
    /// they are true for this text only.
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
        if convert::is_unnecessary(self.agreed, found) {
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
