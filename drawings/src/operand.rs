//! Names and values of a drawing as operands of ladder text.

use ladder_format::names::Names;
use ladder_format::program::{Expression, Literal, Path, Sign};

/// The members of timers and counters that controllers call with `/` too: `T4:0/DN`.
const MEMBERS: [&str; 10] = ["EN", "TT", "DN", "CU", "CD", "ACC", "PRE", "Q", "ET", "CV"];

/// The words of operands that other systems write otherwise.
#[derive(Debug, Default)]
pub(crate) struct Operands {
    names: Names,
    made: Vec<String>,
}

impl Operands {
    /// A tag, as it is written: `Start`, `%I0.3`, `T4:0/DN`, `Stop button`. None: it is not a name.
    pub(crate) fn tag(&mut self, written: &str) -> Option<Path> {
        let written = written.trim();
        if let Some(address) = written.strip_prefix('%') {
            return address_of(address).map(Path::tag);
        }
        if let Ok(Expression::Path(path)) = Expression::read(written) {
            return Some(path);
        }
        if !written.chars().any(char::is_alphabetic) || written.contains(['=', '<', '>', '"', '\'']) {
            return None;
        }
        if let Some((timer, member)) = written.rsplit_once(['/', '.'])
            && MEMBERS.iter().any(|known| known.eq_ignore_ascii_case(member))
        {
            return Some(Path::tag(self.names.spell(timer)).member(member));
        }
        Some(Path::tag(self.names.spell(written)))
    }

    /// A tag or a literal. None: it is neither.
    pub(crate) fn value(&mut self, written: &str) -> Option<Expression> {
        let written = written.trim();
        match Expression::read(written) {
            Ok(value) if is_literal(&value) => Some(value),
            // `5 s` is not a name.
            _ if duration(written).is_some() => None,
            _ => self.tag(written).map(Expression::from),
        }
    }

    /// What is calculated, or a value.
    pub(crate) fn expression(&mut self, written: &str) -> Option<Expression> {
        let read = Expression::read(written).ok();
        read.or_else(|| self.value(written))
    }

    /// A tag or a time: `T#5s`, `5 s`, `5000` (milliseconds).
    pub(crate) fn time(&mut self, written: &str) -> Option<Expression> {
        match duration(written) {
            Some(time) => Some(time.into()),
            None => self.value(written),
        }
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

/// `-1.5e-3`, `INT#-5`, `T#-5s`, `TRUE`, `'text'`.
fn is_literal(value: &Expression) -> bool {
    match value {
        Expression::Unary(Sign::Minus, inside) => matches!(**inside, Expression::Literal(_)),
        value => matches!(value, Expression::Literal(_)),
    }
}

/// `T#5s`, `TIME#1h30m`, `5 s`, `2.5sec`, `10 min`.
pub(crate) fn duration(written: &str) -> Option<Literal> {
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
    Literal::read(format!("T#{out}"))
        .ok()
        .filter(|_| out.starts_with(|c: char| c.is_ascii_digit()))
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
            let tag = operands.tag(written).map(|tag| tag.to_string());
            assert_eq!(tag.as_deref(), expected, "{written}");
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
            let time = operands.time(written).map(|time| time.to_string());
            assert_eq!(time.as_deref(), expected, "{written}");
        }
        for written in [
            "16#FF",
            "-2.5",
            "-1.5e-3",
            "INT#-5",
            "T#-5s",
            "-16#FF",
            "a[-3]",
            "a[i - 1, -2].b",
            "g[1, 2..4]",
            "'it$'s'",
            "FALSE",
        ] {
            let value = operands.value(written).map(|value| value.to_string());
            assert_eq!(value.as_deref(), Some(written));
        }
        let expression = operands.expression("-a + 3 * -b").map(|value| value.to_string());
        assert_eq!(expression.as_deref(), Some("-a + 3 * -b"));
    }
}
