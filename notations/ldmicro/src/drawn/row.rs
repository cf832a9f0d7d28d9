//! What is in the wire of a line: from its characters to elements.

use super::super::element::{Form, ROWS};
use super::{CELL, TOO_LONG};
use ladder_instructions::Op;

/// An element that was found.
pub(super) struct Found {
    /// Its line in a program file.
    pub(super) text: String,
    /// Its columns in the wire.
    pub(super) length: usize,
}

impl Found {
    fn new(text: String, length: usize) -> Found {
        Found { text, length }
    }
}

/// The element whose body begins at a column of the wire line; `above` is the line over it. Both begin at the left rail.
pub(super) fn element(above: &[char], wire: &[char], column: usize) -> Result<Found, String> {
    let body = Body { above, wire, column };
    match wire[column] {
        '+' => body.constant(),
        ']' => body.contact(),
        '(' => body.coil(),
        '[' => body.bracket(),
        '{' if wire.get(column + 1) == Some(&'"') => body.string(),
        '{' => body.brace(),
        '!' if body.at(TOO_LONG.len()) == TOO_LONG => Ok(Found::new(TOO_LONG.to_owned(), TOO_LONG.len())),
        other => Err(format!("`{}` is nothing that is in a wire", other.escape_debug())),
    }
}

struct Body<'l> {
    above: &'l [char],
    wire: &'l [char],
    column: usize,
}

impl Body<'_> {
    /// As much of the wire line from the column on.
    fn at(&self, length: usize) -> String {
        self.wire.iter().skip(self.column).take(length).collect()
    }

    /// The same columns of the line above.
    fn over(&self, length: usize) -> String {
        self.above.iter().skip(self.column).take(length).collect()
    }

    /// The name above an element, which is centred over this many cells.
    fn name(&self, cells: usize) -> Result<String, String> {
        let start = self.column / CELL * CELL;
        let last = start + cells * CELL - 1;
        let over: String = (start..=last)
            .filter_map(|column| self.above.get(column).copied())
            .enumerate()
            // A vertical wire between two cells is not a part of a name.
            .map(|(column, c)| {
                if c == '|' && column % CELL == CELL - 1 {
                    ' '
                } else {
                    c
                }
            })
            .collect();
        let name = over.trim();
        if name.is_empty() || name.contains(char::is_whitespace) {
            return Err("there is no name above this element".to_owned());
        }
        Ok(name.to_owned())
    }

    fn unknown(&self) -> String {
        let shown: String = self.at(CELL).trim_end_matches('-').to_owned();
        format!("`{shown}` is not an element of LDmicro 2.2")
    }

    fn constant(&self) -> Result<Found, String> {
        match self.at(8).as_str() {
            "+      +" => Ok(Found::new("OPEN".to_owned(), 8)),
            "+------+" => Ok(Found::new("SHORT".to_owned(), 8)),
            _ => Err("wires cross between two cells only".to_owned()),
        }
    }

    fn contact(&self) -> Result<Found, String> {
        let negated = match self.at(3).as_str() {
            "] [" => 0,
            "]/[" => 1,
            _ => return Err(self.unknown()),
        };
        Ok(Found::new(format!("CONTACTS {} {negated}", self.name(1)?), 3))
    }

    fn coil(&self) -> Result<Found, String> {
        let flags = match self.at(3).as_str() {
            "( )" => "0 0 0",
            "(/)" => "1 0 0",
            "(S)" => "0 1 0",
            "(R)" => "0 0 1",
            _ => return Err(self.unknown()),
        };
        Ok(Found::new(format!("COIL {} {flags}", self.name(1)?), 3))
    }

    /// Where a body ends that was centred in this many cells: with a character after which wire goes on.
    fn end(&self, close: char, cells: usize) -> Option<usize> {
        let before = self.column % CELL;
        let room = cells * CELL;
        let longest = room.checked_sub(2 * before)?;
        let is_close = |length: &usize| self.wire.get(self.column + length - 1) == Some(&close);
        [longest, longest.saturating_sub(1)]
            .into_iter()
            .filter(|length| *length > 1)
            .find(is_close)
    }

    fn bracket(&self) -> Result<Found, String> {
        let length = self.end(']', 1).ok_or_else(|| self.unknown())?;
        let body = self.at(length);
        match body.as_str() {
            "[OSR_/ ]" => return Ok(Found::new("OSR".to_owned(), length)),
            "[OSF \\_]" => return Ok(Found::new("OSF".to_owned(), length)),
            _ => {}
        }
        let inside = &body[1..body.len() - 1];
        if inside.starts_with(' ') {
            return self.comparison(inside.trim(), length);
        }
        let (word, value) = inside.split_once(' ').ok_or_else(|| self.unknown())?;
        let text = match word {
            "TON" | "TOF" | "RTO" => {
                let delay = scaled(value, &[("s", 1e6), ("ms", 1e3)]).ok_or_else(|| self.unknown())?;
                format!("{word} {} {delay}", self.name(1)?)
            }
            "CTU" | "CTD" => {
                let limit = value.strip_prefix(">=").ok_or_else(|| self.unknown())?;
                format!("{word} {} {}", self.name(1)?, limit.trim())
            }
            _ => return Err(self.unknown()),
        };
        Ok(Found::new(text, length))
    }

    fn comparison(&self, right: &str, length: usize) -> Result<Found, String> {
        let over = self.over(length);
        let inside = over.strip_prefix('[').and_then(|over| over.strip_suffix(']'));
        let halves = inside.and_then(|inside| inside.trim_end().rsplit_once(' '));
        let (left, sign) = halves.ok_or_else(|| self.unknown())?;
        let op = match sign {
            "==" => Op::Eq,
            "/=" => Op::Ne,
            ">" => Op::Gt,
            ">=" => Op::Ge,
            "<" => Op::Lt,
            "<=" => Op::Le,
            _ => return Err(self.unknown()),
        };
        let is_op = |form: Form| matches!(form, Form::Values(own, _) if own == op);
        let row = ROWS
            .iter()
            .find(|row| is_op(row.form))
            .ok_or_else(|| self.unknown())?;
        Ok(Found::new(
            format!("{} {} {right}", row.word, left.trim()),
            length,
        ))
    }

    fn string(&self) -> Result<Found, String> {
        let length = self.end('}', 2).ok_or_else(|| self.unknown())?;
        let body = self.at(length);
        let text = body.strip_prefix("{\"").and_then(|body| body.strip_suffix("\"}"));
        let text = text.ok_or_else(|| self.unknown())?;
        let variable = self.name(2).unwrap_or_else(|_| "(none)".to_owned());
        let mut line = format!("FORMATTED_STRING {variable} {}", text.chars().count());
        for c in text.chars() {
            let code = u8::try_from(c).map_err(|_| format!("LDmicro cannot send `{c}`"))?;
            line.push_str(&format!(" {code}"));
        }
        Ok(Found::new(line, length))
    }

    fn brace(&self) -> Result<Found, String> {
        let over = self.over(2 * CELL);
        for (word, sign) in [("ADD", " + "), ("SUB", " - "), ("MUL", " * "), ("DIV", " / ")] {
            if let Some(rest) = over.strip_prefix('{').and_then(|over| over.strip_prefix(word)) {
                let end = rest.find('}').ok_or_else(|| self.unknown())?;
                let to = rest[..end]
                    .trim()
                    .strip_suffix(":=")
                    .ok_or_else(|| self.unknown())?;
                let length = rest[..end].chars().count() + 1 + word.len() + 1;
                let body = self.at(length);
                let inside = body.strip_prefix('{').and_then(|body| body.strip_suffix('}'));
                let operands = inside.and_then(|inside| inside.split_once(sign));
                let (left, right) = operands.ok_or_else(|| self.unknown())?;
                let text = format!("{word} {} {} {}", to.trim(), left.trim(), right.trim());
                return Ok(Found::new(text, length));
            }
        }
        let body = self.at(CELL);
        let end = body.find('}').ok_or_else(|| self.unknown())?;
        let inside = &body[1..end];
        let length = inside.chars().count() + 2;
        let over = self.over(length);
        let half = over.strip_prefix('{').and_then(|over| over.strip_suffix('}'));
        let text = match half.map(str::trim) {
            Some("SHIFT REG") => shift(inside.trim()),
            Some(half) => half.strip_suffix(":=").and_then(|to| {
                let to = to.trim();
                let inside = inside.trim();
                match inside.strip_suffix("MOV") {
                    Some(from) => Some(format!("MOVE {to} {}", from.trim())),
                    None => looked_up(to, inside),
                }
            }),
            None => self.plain(inside)?,
        };
        Ok(Found::new(text.ok_or_else(|| self.unknown())?, length))
    }

    /// A box of one line.
    fn plain(&self, inside: &str) -> Result<Option<String>, String> {
        let named = |word: &str| self.name(1).map(|name| Some(format!("{word} {name}")));
        if let Some(limit) = inside.strip_prefix("CTC 0:") {
            return Ok(Some(format!("CTC {} {}", self.name(1)?, limit.trim())));
        }
        if let Some(frequency) = inside.strip_prefix("PWM ") {
            let Some(hertz) = scaled(frequency, &[("Hz", 1.0), ("kHz", 1e3)]) else {
                return Ok(None);
            };
            return Ok(Some(format!("SET_PWM {} {hertz}", self.name(1)?)));
        }
        match inside {
            "MASTER RLY" => Ok(Some("MASTER_RELAY".to_owned())),
            "RES" => named("RES"),
            "READ ADC" => named("READ_ADC"),
            "UART SEND" => named("UART_SEND"),
            "UART RECV" => named("UART_RECV"),
            "PERSIST" => named("PERSIST"),
            _ => Ok(None),
        }
    }
}

/// `500.0 ms` in the smallest unit.
fn scaled(text: &str, units: &[(&str, f64)]) -> Option<u64> {
    let (number, unit) = text.trim().split_once(' ')?;
    let (_, factor) = units.iter().find(|(name, _)| *name == unit)?;
    let value = number.parse::<f64>().ok()? * factor;
    (0.0..1e15).contains(&value).then(|| value.round() as u64)
}

/// `reg0..6`
fn shift(inside: &str) -> Option<String> {
    let (first, last) = inside.split_once("..")?;
    let last: u32 = last.parse().ok()?;
    Some(format!(
        "SHIFT_REGISTER {} {}",
        first.strip_suffix('0')?,
        last.checked_add(1)?
    ))
}

/// `LUT[i]`, `PWL[x]`: the table itself is not there.
fn looked_up(to: &str, inside: &str) -> Option<String> {
    let (table, index) = inside.strip_suffix(']')?.split_once('[')?;
    match table {
        "LUT" => Some(format!("LOOK_UP_TABLE {to} {index} 0 0")),
        "PWL" => Some(format!("PIECEWISE_LINEAR {to} {index} 0")),
        _ => None,
    }
}
