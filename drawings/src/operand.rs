//! Names and values of a drawing as operands of ladder text.

use ladder_format::names::Names;
use ladder_syntax::{SyntaxKind, is_identifier, is_reserved, parse};

/// The members of timers and counters that controllers call with `/` too: `T4:0/DN`.
const MEMBERS: [&str; 10] = ["EN", "TT", "DN", "CU", "CD", "ACC", "PRE", "Q", "ET", "CV"];

/// The words of operands that other systems write otherwise.
#[derive(Debug, Default)]
pub(crate) struct Operands {
    names: Names,
    made: Vec<String>,
}

impl Operands {
    /// A tag, as it is written: `Start`, `%I0.3`, `T4:0/DN`, `Stop button`. None: it is no name.
    pub(crate) fn tag(&mut self, written: &str) -> Option<String> {
        let written = written.trim();
        if let Some(address) = written.strip_prefix('%') {
            return address_of(address);
        }
        let is_part = || {
            matches!(
                kind(written),
                Some(SyntaxKind::INDEX_EXPR | SyntaxKind::MEMBER_EXPR)
            )
        };
        if is_path(written) || written.contains(['[', '.']) && is_part() {
            return Some(written.to_owned());
        }
        if !written.chars().any(char::is_alphabetic) || written.contains(['=', '<', '>', '"', '\'']) {
            return None;
        }
        if let Some((timer, member)) = written.rsplit_once(['/', '.'])
            && MEMBERS.iter().any(|known| known.eq_ignore_ascii_case(member))
        {
            return Some(format!("{}.{member}", self.names.spell(timer)));
        }
        Some(self.names.spell(written).to_owned())
    }

    /// A tag or a number. None: it is neither.
    pub(crate) fn value(&mut self, written: &str) -> Option<String> {
        let written = written.trim();
        if is_number(written) || duration(written).is_some() || is_literal(written) {
            return Some(written.to_owned());
        }
        self.tag(written)
    }

    /// What is calculated, or a value.
    pub(crate) fn expression(&mut self, written: &str) -> Option<String> {
        match kind(written) {
            Some(_) => Some(written.trim().to_owned()),
            None => self.value(written),
        }
    }

    /// A tag or a time: `T#5s`, `5 s`, `5000` (milliseconds).
    pub(crate) fn time(&mut self, written: &str) -> Option<String> {
        let written = written.trim();
        if let Some(time) = duration(written) {
            return Some(time);
        }
        self.value(written)
    }

    /// A name of the reader's own.
    pub(crate) fn fresh(&mut self, like: &str) -> String {
        let name = self.names.fresh(like);
        self.made.push(name.clone());
        name
    }

    /// The names that the drawing does not have.
    pub(crate) fn made(self) -> Vec<String> {
        self.made
    }

    /// The names that are written otherwise than they were, each with its spelling.
    pub(crate) fn changed(&self) -> Vec<(String, String)> {
        let owned = |(one, other): (&str, &str)| (one.to_owned(), other.to_owned());
        self.names.changed().into_iter().map(owned).collect()
    }
}

/// `a`, `t.DN`, `a[3].b`.
fn is_path(written: &str) -> bool {
    let mut parts = written.split('.');
    let is_part = |part: &str| {
        let (name, index) = part
            .split_once('[')
            .map_or((part, None), |(name, rest)| (name, Some(rest)));
        let index = index.is_none_or(|rest| {
            rest.strip_suffix(']')
                .is_some_and(|index| is_identifier(index) || is_number(index))
        });
        index && is_identifier(name)
    };
    parts
        .next()
        .is_some_and(|first| is_part(first) && !is_reserved(first))
        && parts.all(|part| is_part(part) || part.bytes().all(|digit| digit.is_ascii_digit()))
        && !written.ends_with('.')
}

/// `IX0.3`; a bit may be written without its `X`.
fn address_of(address: &str) -> Option<String> {
    let address = address.to_ascii_uppercase();
    let area = address.chars().next().filter(|area| "IQM".contains(*area))?;
    let rest = &address[1..];
    let (size, place) = match rest.chars().next()? {
        size @ ('X' | 'B' | 'W' | 'D' | 'L') => (size, &rest[1..]),
        _ => ('X', rest),
    };
    let is_place = !place.is_empty()
        && place
            .split('.')
            .all(|part| !part.is_empty() && part.bytes().all(|c| c.is_ascii_digit()));
    is_place.then(|| format!("%{area}{size}{place}"))
}

fn is_number(written: &str) -> bool {
    let digits = written.strip_prefix(['-', '+']).unwrap_or(written);
    let is_decimal = digits.starts_with(|c: char| c.is_ascii_digit())
        && digits.ends_with(|c: char| c.is_ascii_digit())
        && digits
            .bytes()
            .all(|c| c.is_ascii_digit() || c == b'.' || c == b'_')
        && digits.matches('.').count() < 2;
    let radix = |written: &str| {
        let (radix, rest) = written.split_once('#')?;
        let known = matches!(radix, "2" | "8" | "16") && !rest.is_empty();
        Some(known && rest.bytes().all(|c| c.is_ascii_hexdigit() || c == b'_'))
    };
    is_decimal || radix(digits).unwrap_or(false)
}

/// What an operand of ladder text is that is written so.
fn kind(written: &str) -> Option<SyntaxKind> {
    if written.contains(['\n', '\r']) {
        return None;
    }
    let parsed = parse(&format!("+--[CALC]( y, {written} )--+"));
    let line = parsed.lines().first().filter(|line| line.errors.is_empty())?;
    let tree = line.syntax();
    let list = tree
        .descendants()
        .find(|node| node.kind() == SyntaxKind::OPERAND_LIST)?;
    let mut operands = list.children().skip(1);
    let operand = operands
        .next()
        .filter(|operand| operand.text() == written.trim())?;
    operands.next().is_none().then(|| operand.kind())
}

/// `-1.5e-3`, `INT#-5`, `T#-5s`, `TRUE`, `'text'`.
fn is_literal(written: &str) -> bool {
    let digits = written.strip_prefix('-').unwrap_or(written).trim_start();
    let is_plain = || {
        let number = digits.replace('_', "");
        number.starts_with(|c: char| c.is_ascii_digit()) && number.parse::<f64>().is_ok()
    };
    let is_word = ["TRUE", "FALSE"]
        .iter()
        .any(|word| word.eq_ignore_ascii_case(written));
    (is_word || digits.contains(['#', '\'']) || is_plain()) && kind(digits) == Some(SyntaxKind::LITERAL_EXPR)
}

/// `T#5s`, `TIME#1h30m`, `5 s`, `2.5sec`, `10 min`.
pub(crate) fn duration(written: &str) -> Option<String> {
    let lower = written.trim().to_ascii_lowercase();
    let bare = ["time#", "t#"]
        .iter()
        .find_map(|prefix| lower.strip_prefix(prefix));
    let bare: String = bare.unwrap_or(&lower).chars().filter(|c| *c != ' ').collect();
    let mut out = String::new();
    let mut rest = bare.as_str();
    while !rest.is_empty() {
        let number = rest.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '_')?;
        let unit = rest[number..]
            .find(|c: char| !c.is_ascii_alphabetic())
            .map_or(rest.len(), |at| number + at);
        let known = match &rest[number..unit] {
            "d" | "h" | "m" | "s" | "ms" | "us" | "ns" => &rest[number..unit],
            "sec" | "second" | "seconds" => "s",
            "min" | "minute" | "minutes" => "m",
            "msec" => "ms",
            _ => return None,
        };
        out.push_str(rest[..number].trim_matches('_'));
        out.push_str(known);
        rest = &rest[unit..];
    }
    (is_first_digit(&out)).then(|| format!("T#{out}"))
}

fn is_first_digit(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_values() {
        let mut operands = Operands::default();
        for (written, expected) in [
            ("start", Some("start")),
            ("t1.DN", Some("t1.DN")),
            ("a[3].b", Some("a[3].b")),
            ("Stop button", Some("Stop_button")),
            ("I:0/1", Some("I_0_1")),
            ("T4:0/DN", Some("T4_0.DN")),
            ("%I0.3", Some("%IX0.3")),
            ("%QX1.7", Some("%QX1.7")),
            ("%MW4", Some("%MW4")),
            ("%Z1", None),
            ("???", None),
            ("5", None),
        ] {
            assert_eq!(operands.tag(written).as_deref(), expected, "{written}");
        }
        for (written, expected) in [
            ("T#5S", Some("T#5s")),
            ("5 s", Some("T#5s")),
            ("1h30m", Some("T#1h30m")),
            ("2.5 sec", Some("T#2.5s")),
            ("5000", Some("5000")),
            ("delay", Some("delay")),
            ("5 apples", Some("_5_apples")),
            ("-", None),
        ] {
            assert_eq!(operands.time(written).as_deref(), expected, "{written}");
        }
        assert_eq!(operands.value("16#FF").as_deref(), Some("16#FF"));
        for written in [
            "-2.5",
            "-1.5e-3",
            "INT#-5",
            "T#-5s",
            "-16#FF",
            "a[-3]",
            "a[i - 1, -2].b",
            "'it$'s'",
            "FALSE",
        ] {
            assert_eq!(operands.value(written).as_deref(), Some(written));
        }
        assert_eq!(operands.expression("-a + 3 * -b").as_deref(), Some("-a + 3 * -b"));
    }
}
