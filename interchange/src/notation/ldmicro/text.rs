//! The texts of `FORMATTED_STRING`: characters by their codes, with LDmicro's escapes.

/// Where the number goes in a text, and how LDmicro writes it.
const NUMBER: &str = "\\-5";

/// The text of `var length c0 c1 ..` in the spelling that export gives it, and whether that says exactly the same.
pub(super) fn read(fields: &[&str]) -> Option<(String, bool)> {
    let length: usize = fields.get(1)?.parse().ok()?;
    let codes = fields.get(2..)?;
    if codes.len() != length {
        return None;
    }
    let text: Option<String> = codes
        .iter()
        .map(|code| code.parse::<u8>().ok().map(char::from))
        .collect();
    let text = text?;
    let mut out = String::new();
    let mut exact = true;
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        let minus = chars.next_if_eq(&'-').is_some();
        match chars.next()? {
            '1'..='5' => {
                exact = false;
                out.push_str(NUMBER);
            }
            _ if minus => return None,
            c @ ('r' | 'n' | '\\') => out.extend(['\\', c]),
            _ => return None,
        }
    }
    Some((out, exact))
}

/// The line for a text in that spelling.
pub(super) fn line(variable: &str, text: &str) -> String {
    let mut line = format!("FORMATTED_STRING {variable} {}", text.chars().count());
    text.chars()
        .for_each(|c| line.push_str(&format!(" {}", u32::from(c))));
    line
}

/// A text in that spelling as a literal of ladder text, and how many numbers it has.
pub(super) fn literal(text: &str) -> (String, usize) {
    let numbers = text.matches(NUMBER).count();
    let mut out = String::from("'");
    let mut chars = text
        .replace(NUMBER, "\u{0}")
        .chars()
        .collect::<Vec<_>>()
        .into_iter();
    while let Some(c) = chars.next() {
        match c {
            '\u{0}' => out.push_str("%d"),
            '\\' => match chars.next() {
                Some('r') => out.push_str("$R"),
                Some('n') => out.push_str("$N"),
                _ => out.push('\\'),
            },
            '\'' => out.push_str("$'"),
            '$' => out.push_str("$$"),
            c if c.is_control() || !c.is_ascii() => out.push_str(&format!("${:02X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('\'');
    (out, numbers)
}

/// The other way: from the text that `[FMT]` has. None if LDmicro cannot send it.
pub(super) fn from_value(text: &str) -> Option<String> {
    let mut out = String::new();
    for c in text.replace("%d", "\u{0}").chars() {
        match c {
            '\u{0}' => out.push_str(NUMBER),
            '\r' => out.push_str("\\r"),
            '\n' => out.push_str("\\n"),
            '\\' => out.push_str("\\\\"),
            '%' => return None,
            c if c.is_control() || u32::from(c) > 255 => return None,
            c => out.push(c),
        }
    }
    Some(out)
}
