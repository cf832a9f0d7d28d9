//! Programs as people describe them, with the symbols that the editor shows and the columns of its grid:
//!
//! ```text
//! 6. IoT Lamp
//!    rung 0:  0:| |MI01   1:( )Q1
//!    rung 1:  0:TMR ON T1 (PRE 3)   1:|P|I1   2:XOR MI01, I1 -> MI01   3:RESET T1
//! ```
//!
//! A title may say `n = 1..8`; a rung with `In` or `Qn` in it is then there for each of these numbers. All other lines
//! are comments.

use super::model::{Element, Family, File, IotLine};
use super::parse;
use ladder_format::Circuit;
use ladder_notation::{LineColumn, ReadError};
use std::ops::RangeInclusive;

/// More rungs are not made of what titles say.
const MOST_RUNGS: u32 = 10_000;
/// As many lines are checked to recognise a program.
const HEAD: usize = 50;

/// Whether one of the first lines of a text is a rung in this form.
pub(super) fn begins(text: &str) -> bool {
    let mut lines = text.lines().take(HEAD);
    lines.any(|line| rung(line).is_some_and(|rung| rung.circuit(1, 1).is_ok()))
}

/// Reads a program in this form.
pub(super) fn parse(text: &str) -> Result<File, ReadError> {
    let mut file = File::default();
    let mut title: Option<u32> = None;
    let mut numbers: Option<RangeInclusive<u32>> = None;
    let mut made = 0;
    for (number, line) in (1..).zip(text.lines()) {
        let told = line.trim();
        if line.len() > parse::LONGEST_LINE {
            return Err(ReadError::at(LineColumn::line(number), parse::long_line()));
        }
        if let Some(name) = titled(line) {
            if let Some(first) = title.replace(number) {
                return Err(ReadError::at(LineColumn::line(number), parse::another(first)));
            }
            numbers = range(name);
            let name: Vec<&str> = name.split_whitespace().collect();
            file.parts.push(IotLine::Beside(format!("= {}", name.join(" "))));
        } else if let Some(rung) = rung(line) {
            let each = match (rung.number.parse::<u32>(), &numbers) {
                (Ok(_), _) => 1..=1,
                (Err(_), Some(numbers)) => numbers.clone(),
                (Err(_), None) => {
                    let message = "for which numbers this rung is there, the title does not say: `n = 1..8`";
                    return Err(ReadError::at(LineColumn::line(number), message));
                }
            };
            made += each.end() - each.start();
            if made > MOST_RUNGS {
                let message = format!("more than {MOST_RUNGS} rungs are made of rungs with an `n` in them");
                return Err(ReadError::at(LineColumn::line(number), message));
            }
            for n in each {
                file.parts.push(IotLine::Rung(rung.circuit(number, n)?));
            }
        } else if !told.is_empty() {
            file.parts.push(IotLine::Comment(told.to_owned()));
        }
    }
    Ok(file)
}

/// The title in `3. AllKeys      (eight rungs, n = 1..8)`.
fn titled(line: &str) -> Option<&str> {
    let (number, title) = line.split_once(". ")?;
    let is_number = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| title.trim())
}

/// The numbers in `n = 1..8`.
fn range(title: &str) -> Option<RangeInclusive<u32>> {
    let (_, after) = title.split_once("n = ")?;
    let (first, after) = after.split_once("..")?;
    let end = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
    let (first, last): (u32, u32) = (first.trim().parse().ok()?, after[..end].parse().ok()?);
    (first <= last && last - first < MOST_RUNGS).then_some(first..=last)
}

/// A line that is a rung.
struct Line<'l> {
    /// `0` in `rung 0:`, or `n-1`.
    number: &'l str,
    /// What is in the columns, each with its place in the line.
    parts: Vec<(u32, &'l str)>,
}

fn rung(line: &str) -> Option<Line<'_>> {
    if line.len() > parse::LONGEST_LINE {
        return None;
    }
    let (number, columns) = line.trim_start().strip_prefix("rung ")?.split_once(':')?;
    let number = number.trim();
    let is_number = number.bytes().all(|byte| byte.is_ascii_digit()) || number.starts_with('n');
    let start = line.len() - columns.len();
    let mut starts: Vec<(usize, usize)> = Vec::new();
    for (at, _) in columns.match_indices(':') {
        let digits = columns[..at].trim_end_matches(|c: char| c.is_ascii_digit());
        if digits.len() < at && digits.ends_with(char::is_whitespace) {
            starts.push((digits.len(), at + 1));
        }
    }
    let nothing_before = starts
        .first()
        .is_some_and(|(at, _)| columns[..*at].trim().is_empty());
    if !is_number || number.is_empty() || !nothing_before {
        return None;
    }
    let ends = starts.iter().skip(1).map(|(end, _)| *end).chain([columns.len()]);
    let parts = starts.iter().zip(ends).map(|((_, from), to)| {
        let column = line[..start + from].chars().count() as u32 + 1;
        (column, columns[*from..to].trim())
    });
    let parts = parts.collect();
    Some(Line { number, parts })
}

impl Line<'_> {
    /// The rung for one of the numbers that `n` stands for.
    fn circuit(&self, line: u32, n: u32) -> Result<Circuit<Element>, ReadError> {
        if self.parts.len() > parse::MOST_PARTS {
            let message = format!(
                "the rung has more than {} elements: make several rungs of it",
                parse::MOST_PARTS
            );
            return Err(ReadError::at(LineColumn::line(line), message));
        }
        let mut series = Vec::with_capacity(self.parts.len());
        for (column, text) in &self.parts {
            let place = LineColumn {
                line,
                column: *column,
            };
            let branches = text
                .split(" in parallel with ")
                .take(parse::MOST_PARTS)
                .map(|one| {
                    let words = words(&numbered(one.trim(), n)).ok_or_else(|| {
                        let shown: String = one.chars().take(40).collect();
                        let message = format!("`{shown}` is not an element of the IoT ladder language");
                        ReadError::at(place, message)
                    })?;
                    parse::element_at(&words, place)
                });
            let mut branches: Vec<Circuit<Element>> = branches
                .map(|branch| branch.map(Circuit::Element))
                .collect::<Result<_, _>>()?;
            series.push(match branches.len() {
                1 => branches.remove(0),
                _ => Circuit::Parallel(branches),
            });
        }
        Ok(Circuit::Series(series))
    }
}

/// `In` with its number.
fn numbered(text: &str, n: u32) -> String {
    let mut out = String::with_capacity(text.len());
    for word in text.split_inclusive(|c: char| !c.is_ascii_alphanumeric()) {
        let end = word.trim_end_matches(|c: char| !c.is_ascii_alphanumeric()).len();
        let is_variable = |letters: &&str| Family::ALL.into_iter().any(|family| family.letters() == *letters);
        match word[..end].strip_suffix('n').filter(is_variable) {
            Some(letters) => out.push_str(&format!("{letters}{n}{}", &word[end..])),
            None => out.push_str(word),
        }
    }
    out
}

/// An element in the words of the small notation.
fn words(text: &str) -> Option<String> {
    const SYMBOLS: [(&str, &str); 13] = [
        ("| |", "NO"),
        ("|/|", "NC"),
        ("|P|", "P"),
        ("|N|", "N"),
        ("( )", "OUT"),
        ("(/)", "NOUT"),
        ("(S)", "SET"),
        ("(R)", "RST"),
        ("(M)", "M"),
        ("(SM)", "SM"),
        ("(RM)", "RM"),
        ("(P)", "PC"),
        ("(N)", "NCOIL"),
    ];
    const STATES: [(&str, &str, [&str; 2]); 4] = [
        ("TMR ON ", "TON", ["PRE", "B"]),
        ("TMR OFF ", "TOF", ["PRE", "B"]),
        ("COUNT UP ", "CTU", ["PRE", "AC"]),
        ("COUNT DOWN ", "CTD", ["PRE", "AC"]),
    ];
    for (symbol, word) in SYMBOLS {
        if let Some(operand) = text.strip_prefix(symbol) {
            return Some(format!("{word} {}", operand.trim()));
        }
    }
    for (symbol, word, members) in STATES {
        if let Some(rest) = text.strip_prefix(symbol) {
            return state(word, rest, members);
        }
    }
    if text == "SCAN TIME" {
        return Some("SCANTIME".to_owned());
    }
    let (word, rest) = text.split_once(' ')?;
    let (operands, result) = match rest.split_once("->") {
        Some((operands, result)) => (operands, Some(result.trim())),
        None => (rest, None),
    };
    let is_bitwise = matches!(word, "AND" | "OR" | "XOR");
    let operands = operands.split(',').map(str::trim).map(|operand| {
        // The editor shows whole numbers so.
        let whole = operand.strip_suffix(".0").filter(|_| is_bitwise);
        whole.unwrap_or(operand)
    });
    let all: Vec<&str> = [word].into_iter().chain(result).chain(operands).collect();
    Some(all.join(" "))
}

/// `T1 (PRE 3, B 50)`: what is not given has the editor's default.
fn state(word: &str, text: &str, members: [&str; 2]) -> Option<String> {
    let Some((name, told)) = text.split_once('(') else {
        return Some(format!("{word} {}", text.trim()));
    };
    let (told, after) = told.split_once(')')?;
    if !after.trim().is_empty() {
        return None;
    }
    let mut values = if members[1] == "B" {
        ["1", "100"]
    } else {
        ["0", "0"]
    };
    for one in told.split(',') {
        let (member, value) = one.trim().split_once(' ')?;
        let at = members.iter().position(|own| *own == member)?;
        values[at] = value.trim();
    }
    Some(format!("{word} {} {}", name.trim(), values.join(" ")))
}
