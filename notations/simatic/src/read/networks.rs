//! Networks: rungs, each from a point on, with parts and the points in between.

use super::pragma::{Pragma, templates};
use super::resource::Texts;
use crate::cursor::{Cursor, Result, without_comments};
use crate::model::{Argument, Body, MOST_PARTS, Net, Network, Part, RAIL, Value, Wire};
use std::collections::HashMap;

/// A network, with its end.
pub(super) fn network(cursor: &mut Cursor<'_>, pragma: &Pragma, texts: &Texts) -> Result<Network> {
    let place = cursor.place();
    let Some(end) = cursor.find_word("END_NETWORK") else {
        return cursor.error("the file ends without `END_NETWORK`");
    };
    let mut inside = cursor.clone();
    inside.end = end;
    cursor.at = end + "END_NETWORK".len();
    let mut network = Network {
        place,
        told: texts.told(pragma, ["S7_NetworkTitle", "S7_NetworkComment"]),
        ..Network::default()
    };
    network.set_text(&inside);
    let language = pragma.get("S7_Language").unwrap_or("LAD");
    if !language.eq_ignore_ascii_case("LAD") {
        network.body = Body::in_language(language);
        return Ok(network);
    }
    let mut reader = Reader {
        points: HashMap::new(),
        net: Net {
            points: 1,
            ..Net::default()
        },
        parts: 0,
    };
    match reader.rungs(&mut inside, &mut network) {
        Ok(()) => network.body = Body::Ladder(reader.net),
        Err(error) => {
            network.place = error.place.unwrap_or(place);
            let why = format!("the network cannot be read: {}", error.message);
            network.body = Body::Text("LAD".to_owned(), why);
        }
    }
    Ok(network)
}

/// The statements of a block that has no networks, up to its end. None: there are networks, or nothing.
pub(super) fn statements(cursor: &mut Cursor<'_>, end: &str) -> Option<Network> {
    let is_network = cursor.is("{")
        || ["NETWORK", end]
            .iter()
            .any(|word| cursor.peek_word().eq_ignore_ascii_case(word));
    let last = cursor.find_word(end).filter(|_| !is_network)?;
    let mut inside = cursor.clone();
    inside.end = last;
    let mut network = Network {
        place: cursor.place(),
        body: Body::in_language("SCL"),
        ..Network::default()
    };
    network.set_text(&inside);
    cursor.at = last;
    Some(network)
}

/// A text without blank lines around it, and without the blanks that all of its lines begin with; and where each of its lines
/// begins, in it and in the text.
fn unindented(text: &str) -> (String, Vec<(usize, usize)>) {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    let first = lines
        .iter()
        .position(|line| !line.is_empty())
        .unwrap_or(lines.len());
    let last = lines
        .iter()
        .rposition(|line| !line.is_empty())
        .map_or(0, |last| last + 1);
    let lines = &lines[first.min(last)..last];
    let blanks = |line: &&str| line.len() - line.trim_start_matches([' ', '\t']).len();
    let own = lines.iter().filter(|line| !line.is_empty());
    let shared = own.map(blanks).min().unwrap_or(0);
    let (mut out, mut starts) = (String::new(), Vec::new());
    for line in lines {
        let own = line.get(shared..).unwrap_or_default();
        // The lines are parts of the text.
        let start = line.as_ptr() as usize - text.as_ptr() as usize + line.len() - own.len();
        starts.push((out.len(), start));
        out.push_str(own);
        out.push('\n');
    }
    out.pop();
    (out, starts)
}

impl Network {
    /// The text is what a cursor has before it.
    fn set_text(&mut self, inside: &Cursor<'_>) {
        let (text, starts) = unindented(inside.rest());
        self.text = text;
        let place = |start: usize| inside.lines.place(inside.text, inside.at + start);
        self.places = starts.into_iter().map(|(at, start)| (at, place(start))).collect();
    }
}

struct Reader {
    points: HashMap<String, usize>,
    net: Net,
    parts: usize,
}

impl Reader {
    fn rungs(&mut self, cursor: &mut Cursor<'_>, network: &mut Network) -> Result<()> {
        while !cursor.is_done() {
            if cursor.eat_word("LABEL") {
                if network.label.is_some() {
                    return cursor.error("a network has one label");
                }
                let place = cursor.place();
                cursor.expect("(")?;
                network.label = Some((place, cursor.name()?));
                cursor.expect(")")?;
                cursor.eat(";");
                continue;
            }
            if !cursor.eat_word("RUNG") {
                return cursor.error("a network in LAD has RUNG .. END_RUNG, and a Label before them");
            }
            self.rung(cursor)?;
        }
        Ok(())
    }

    fn rung(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        let Some(mut from) = self.wire(cursor)? else {
            return cursor.error("a rung begins at a wire: RUNG wire#powerrail");
        };
        let mut parts = Vec::new();
        loop {
            if cursor.eat_word("END_RUNG") {
                let to = self.wire(cursor)?;
                self.net.wires.push(Wire { from, to, parts });
                return Ok(());
            }
            if let Some(point) = self.wire(cursor)? {
                self.net.wires.push(Wire {
                    from,
                    to: Some(point),
                    parts: std::mem::take(&mut parts),
                });
                from = point;
                continue;
            }
            if cursor.is_done() {
                return cursor.error("a rung ends with END_RUNG");
            }
            self.parts += 1;
            if self.parts > MOST_PARTS {
                return cursor.error(format!("a network has no more than {MOST_PARTS} parts"));
            }
            parts.push(self.part(cursor)?);
        }
    }

    /// `wire#name`, if that is next.
    fn wire(&mut self, cursor: &mut Cursor<'_>) -> Result<Option<usize>> {
        if !cursor.is("wire#") {
            return Ok(None);
        }
        cursor.at += "wire#".len();
        let name = cursor.name()?;
        Ok(Some(self.point(&name)))
    }

    fn point(&mut self, name: &str) -> usize {
        if name.eq_ignore_ascii_case("powerrail") {
            return RAIL;
        }
        let next = self.net.points;
        let point = *self.points.entry(name.to_ascii_lowercase()).or_insert(next);
        self.net.points = self.net.points.max(point + 1);
        point
    }

    /// `[pragma] [instance.] NAME [{templates}] ( arguments )`
    fn part(&mut self, cursor: &mut Cursor<'_>) -> Result<Part> {
        let pragma = super::pragma_of(cursor)?;
        cursor.blanks();
        let place = cursor.place();
        let start = cursor.at;
        let head = cursor.until("({")?;
        let mut part = Part {
            place,
            templates: pragma.templates(),
            formula: pragma.get("S7_Expression").map(str::to_owned),
            ..Part::default()
        };
        let is_word = |word: &str| word.chars().all(|c| c.is_alphanumeric() || c == '_');
        match head.rsplit_once('.') {
            Some((instance, name)) if is_word(name) && is_instruction(name) => {
                part.instance = Some(instance.trim().to_owned());
                name.clone_into(&mut part.name);
            }
            _ => head.clone_into(&mut part.name),
        }
        if !is_head(head) {
            return cursor.error("an instruction is expected here, with its operands in parentheses");
        }
        if cursor.eat("{") {
            let text = cursor.until("}")?;
            if text.contains(['\n', '(', '{']) {
                return cursor.error("templates stand on one line: { SrcType := Int }");
            }
            part.templates.extend(templates(text));
            cursor.expect("}")?;
        }
        cursor.expect("(")?;
        while !cursor.eat(")") {
            let argument = self.argument(cursor)?;
            part.arguments.push(argument);
            if !cursor.is(")") {
                cursor.expect(",")?;
            }
        }
        let shown = &cursor.text[start..cursor.at];
        part.text = part_text(shown);
        Ok(part)
    }

    fn argument(&mut self, cursor: &mut Cursor<'_>) -> Result<Argument> {
        let text = without_comments(cursor.until(",)")?);
        let (pin, value, is_output) = if let Some((pin, value)) = text.split_once("=>") {
            (Some(pin.trim()), value, true)
        } else if let Some((pin, value)) = text.split_once(":=") {
            (Some(pin.trim()), value, false)
        } else {
            (None, text.as_str(), false)
        };
        let value = value.trim();
        let value = match value.strip_prefix("wire#") {
            Some(name) => Value::Power(self.point(name.trim_matches('"'))),
            None if value.is_empty() => Value::Open,
            None => Value::Operand(value.to_owned()),
        };
        Ok(Argument {
            pin: pin.map(|pin| pin.trim_matches('"').to_owned()),
            value,
            is_output,
        })
    }
}

/// Whether a text is a name: of an instruction, or a path to what holds a state.
fn is_head(text: &str) -> bool {
    let mut quoted = false;
    let mut depth = 0usize;
    let is_right = |c: char| {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => return c != '\n',
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ if depth > 0 => {}
            _ => return c.is_alphanumeric() || "_#.%".contains(c),
        }
        true
    };
    !text.is_empty() && text.chars().all(is_right)
}

/// Whether a word after an instance is an instruction, and not a member that is called.
fn is_instruction(word: &str) -> bool {
    crate::standard::with_instance(word)
}

/// A part in one line.
fn part_text(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ")
}
