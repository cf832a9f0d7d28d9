//! From lines to the model, with limits.

use super::model::{Element, Family, File, IotLine, Member, Number, Operand, Variable};
use super::prose;
use super::word::{Form, Row, row_of};
use ladder_format::Circuit;
use ladder_notation::{LineColumn, ReadError, Source};

/// A longer line is not read.
pub(super) const LONGEST_LINE: usize = 64 << 10;
/// Parentheses nest no deeper.
pub(super) const DEEPEST: usize = 64;
/// As many parts are next to each other at most; each branch is a line of the drawing, and moves the next one right.
pub(super) const MOST_PARTS: usize = 64;
/// A rung with more elements is not read.
pub(super) const MOST_IN_RUNG: usize = 256;

/// Whether the first line that is part of a program can be read, as far as it is checked.
pub(super) fn begins(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(LONGEST_LINE)];
    let text = match std::str::from_utf8(head) {
        Ok(text) => text,
        Err(error) => std::str::from_utf8(&head[..error.valid_up_to()]).unwrap_or_default(),
    };
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(['#', '=', '>']));
    first.is_some_and(|line| rung(line, 1).is_ok()) || prose::begins(text)
}

/// The element that a text is, which another form of it says at a place.
pub(super) fn element_at(text: &str, place: LineColumn) -> Result<Element, ReadError> {
    match rung(text, place.line) {
        Ok(Circuit::Element(element)) => Ok(Element { place, ..element }),
        Ok(_) => Err(ReadError::at(place, "one element is expected here")),
        Err(error) => Err(ReadError::at(place, error.message)),
    }
}

/// Why a long line is not read.
pub(super) fn long_line() -> String {
    format!("the line is longer than {LONGEST_LINE} bytes")
}

/// Why a second program in a file is not read.
pub(super) fn another(first: u32) -> String {
    format!("another program begins here, the first one on line {first}: put each into a file of its own")
}

/// The element that a text is, if it is one.
pub(super) fn element(text: &str) -> Option<Element> {
    match rung(text, 1) {
        Ok(Circuit::Element(element)) => Some(element),
        _ => None,
    }
}

/// Reads a program.
pub(super) fn parse(source: &Source<'_>) -> Result<File, ReadError> {
    let text = source.text()?;
    if prose::begins(text.trim_start_matches('\u{feff}')) {
        return prose::parse(text.trim_start_matches('\u{feff}'));
    }
    let mut file = File::default();
    let mut title = None;
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let number = index as u32 + 1;
        if line.len() > LONGEST_LINE {
            return Err(ReadError::at(LineColumn::line(number), long_line()));
        }
        let told = line.trim();
        file.parts.push(match told.chars().next() {
            None => continue,
            Some('#') => IotLine::Comment(told[1..].trim().to_owned()),
            Some('=') => {
                if let Some(first) = title.replace(number) {
                    return Err(ReadError::at(LineColumn::line(number), another(first)));
                }
                IotLine::Beside(told.to_owned())
            }
            Some('>') => IotLine::Beside(told.to_owned()),
            Some(_) => IotLine::Rung(rung(line, number)?),
        });
    }
    if !file.parts.iter().any(|part| matches!(part, IotLine::Rung(_))) {
        return Err(ReadError::whole(
            "there is no rung in the file; a rung is a line like `NO I1 ; OUT Q1`",
        ));
    }
    Ok(file)
}

/// A line as a rung.
fn rung(line: &str, number: u32) -> Result<Circuit<Element>, ReadError> {
    let mut reader = Reader {
        words: words(line, number),
        at: 0,
        depth: 0,
        count: 0,
        end: LineColumn {
            line: number,
            column: line.trim_end().chars().count() as u32 + 1,
        },
    };
    let circuit = reader.series()?;
    match reader.words.get(reader.at) {
        None => Ok(circuit),
        Some((word, place)) => Err(ReadError::at(
            *place,
            format!("`;` or `|` is expected here, not `{}`", shown(word)),
        )),
    }
}

/// What is between blanks; signs are alone.
fn words(line: &str, number: u32) -> Vec<(&str, LineColumn)> {
    let mut words = Vec::new();
    let mut start: Option<(usize, u32)> = None;
    let at = |column: u32| LineColumn {
        line: number,
        column: column + 1,
    };
    for (column, (offset, c)) in (0..).zip(line.char_indices()) {
        let is_sign = matches!(c, ';' | '|' | '(' | ')');
        if is_sign || c.is_whitespace() {
            if let Some((start, column)) = start.take() {
                words.push((&line[start..offset], at(column)));
            }
            if is_sign {
                words.push((&line[offset..=offset], at(column)));
            }
        } else if start.is_none() {
            start = Some((offset, column));
        }
    }
    if let Some((start, column)) = start {
        words.push((&line[start..], at(column)));
    }
    words
}

/// As much of a word of the file as fits a message.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}

struct Reader<'l> {
    words: Vec<(&'l str, LineColumn)>,
    at: usize,
    depth: usize,
    /// Elements so far.
    count: usize,
    /// After the last word.
    end: LineColumn,
}

impl<'l> Reader<'l> {
    fn peek(&self) -> Option<&'l str> {
        self.words.get(self.at).map(|(word, _)| *word)
    }

    fn place(&self) -> LineColumn {
        self.words.get(self.at).map_or(self.end, |(_, place)| *place)
    }

    fn take(&mut self, sign: &str) -> bool {
        let found = self.peek() == Some(sign);
        self.at += usize::from(found);
        found
    }

    fn series(&mut self) -> Result<Circuit<Element>, ReadError> {
        self.parts(";", Circuit::Series, |reader| {
            reader.parts("|", Circuit::Parallel, Reader::one)
        })
    }

    /// Parts with a sign between them; one alone is itself.
    fn parts(
        &mut self,
        sign: &str,
        wrap: fn(Vec<Circuit<Element>>) -> Circuit<Element>,
        part: fn(&mut Self) -> Result<Circuit<Element>, ReadError>,
    ) -> Result<Circuit<Element>, ReadError> {
        let mut parts = vec![part(self)?];
        while self.take(sign) {
            if parts.len() == MOST_PARTS {
                let message = format!(
                    "there are more than {MOST_PARTS} parts next to each other: make several rungs of it"
                );
                return Err(ReadError::at(self.place(), message));
            }
            parts.push(part(self)?);
        }
        Ok(match parts.len() {
            1 => parts.remove(0),
            _ => wrap(parts),
        })
    }

    fn one(&mut self) -> Result<Circuit<Element>, ReadError> {
        let place = self.place();
        if !self.take("(") {
            return self.element().map(Circuit::Element);
        }
        if self.take(")") {
            return Ok(Circuit::Series(Vec::new()));
        }
        if self.depth == DEEPEST {
            let message = format!("parentheses are nested more than {DEEPEST} deep");
            return Err(ReadError::at(place, message));
        }
        self.depth += 1;
        let inside = self.series()?;
        self.depth -= 1;
        if !self.take(")") {
            return Err(ReadError::at(place, "this parenthesis is not closed"));
        }
        Ok(inside)
    }

    fn element(&mut self) -> Result<Element, ReadError> {
        let place = self.place();
        let word = match self.peek() {
            None | Some(";" | "|" | ")") => {
                return Err(ReadError::at(place, "an element is missing here: `NO I1`"));
            }
            Some(word) => word,
        };
        let Some(row) = row_of(word) else {
            let message = format!("`{}` is not a word of the IoT ladder language", shown(word));
            return Err(ReadError::at(place, message));
        };
        self.count += 1;
        if self.count > MOST_IN_RUNG {
            let message = format!("the rung has more than {MOST_IN_RUNG} elements: make several rungs of it");
            return Err(ReadError::at(place, message));
        }
        self.at += 1;
        let mut operands = Vec::new();
        while let Some(word) = self.peek().filter(|word| !matches!(*word, ";" | "|" | "(" | ")")) {
            let place = self.place();
            operands.push(operand(word).map_err(|message| ReadError::at(place, message))?);
            self.at += 1;
        }
        let (least, most) = row.operands();
        if !(least..=most).contains(&operands.len()) {
            let message = format!("after `{}` is {}", row.word, row.usage());
            return Err(ReadError::at(place, message));
        }
        check(row, &operands).map_err(|message| ReadError::at(place, message))?;
        Ok(Element { place, row, operands })
    }
}

fn operand(word: &str) -> Result<Operand, String> {
    let unknown = || {
        format!(
            "`{}` is neither a number nor a variable: those are called I1, Q1, MI01, MF01, T1 and C1",
            shown(word)
        )
    };
    if word.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) {
        return number(word).map(Operand::Number).ok_or_else(unknown);
    }
    let (name, member) = match word.split_once(':') {
        Some((name, member)) => (name, Some(member)),
        None => (word, None),
    };
    let variable = variable(name).ok_or_else(unknown)?;
    let Some(member) = member else {
        return Ok(Operand::Variable(variable));
    };
    match Member::named(member, variable.family).filter(|_| variable.family.is_state()) {
        Some(member) => Ok(Operand::Member(variable, member)),
        None => Err(format!("`{variable}` has no member `{}`", shown(member))),
    }
}

/// A whole number that 32 bits hold, or a float.
fn number(word: &str) -> Option<Number> {
    let digits = word.trim_start_matches(['-', '+']);
    let is_number = digits.starts_with(|c: char| c.is_ascii_digit())
        && digits
            .bytes()
            .all(|c| c.is_ascii_digit() || matches!(c, b'.' | b'e' | b'E' | b'-' | b'+'));
    let value: f64 = word.parse().ok().filter(|_| is_number)?;
    let number = Number {
        text: word.trim_start_matches('+').to_owned(),
        value,
    };
    (value.is_finite() && (number.is_float() || number.whole().is_some())).then_some(number)
}

/// The variable with this name.
pub(super) fn variable(name: &str) -> Option<Variable> {
    let start = name.find(|c: char| c.is_ascii_digit())?;
    let (letters, digits) = name.split_at(start);
    let family = Family::ALL
        .into_iter()
        .find(|family| family.letters().eq_ignore_ascii_case(letters))?;
    let is_number = digits.len() <= 6 && digits.bytes().all(|c| c.is_ascii_digit());
    Some(Variable {
        family,
        number: digits.parse().ok().filter(|_| is_number)?,
        digits: digits.to_owned(),
    })
}

/// Whether the operands are of the kind that the word wants.
fn check(row: &Row, operands: &[Operand]) -> Result<(), String> {
    let wrong = || Err(format!("after `{}` is {}", row.word, row.usage()));
    let family = |index: usize| match operands.get(index) {
        Some(Operand::Variable(variable)) => Some(variable.family),
        _ => None,
    };
    let is_instance = |operand: &Operand| matches!(operand, Operand::Variable(v) if v.family.is_state());
    let is_number =
        |operand: &Operand| matches!(operand, Operand::Number(number) if number.whole().is_some());
    let others = operands.get(1..).unwrap_or_default();
    match row.form {
        Form::Timer(_) if family(0) != Some(Family::Timer) => wrong(),
        Form::Counter(_) if family(0) != Some(Family::Counter) => wrong(),
        Form::Timer(_) | Form::Counter(_) if others.iter().all(is_number) => Ok(()),
        Form::Timer(_) | Form::Counter(_) => Err(format!("the numbers after `{}` are whole", row.word)),
        Form::Reset => match &operands[0] {
            Operand::Number(_) => wrong(),
            _ => Ok(()),
        },
        _ if operands.iter().any(is_instance) => Err(
            "a timer or counter has no value as a whole: name a member, such as `T1:DN` or `C1:AC`"
                .to_owned(),
        ),
        Form::Contact(_) | Form::Coil(_) | Form::Calculate(_) | Form::Not | Form::Assign => {
            match &operands[0] {
                Operand::Number(_) => wrong(),
                _ => Ok(()),
            }
        }
        Form::Compare(_) | Form::ScanTime => Ok(()),
    }
}
