//! The texts of a `.s7res`: for each id a text in one language or more.

use super::pragma::Pragma;
use std::collections::HashMap;

/// Texts by their ids.
#[derive(Debug, Default)]
pub(crate) struct Texts(HashMap<String, String>);

/// Of several languages the one that is taken.
const FIRST: &str = "en-US";

/// What an id begins with.
pub(crate) const ID: &str = "MLC_";

impl Texts {
    /// The texts of a file. What is not in its form is passed over: nothing of a program is in it.
    pub(crate) fn of(text: &str) -> Texts {
        let mut texts = HashMap::new();
        let mut id: Option<String> = None;
        for line in text.trim_start_matches('\u{feff}').lines() {
            let Some((name, value)) = line.trim().split_once(':') else {
                continue;
            };
            let name = name.trim_start_matches("- ").trim();
            let value = unquoted(value.trim());
            if name == "id" {
                id = Some(value);
            } else if let Some(id) = &id
                && !value.is_empty()
                && (name == FIRST || !texts.contains_key(id))
            {
                texts.insert(id.clone(), value);
            }
        }
        Texts(texts)
    }

    /// The texts that a pragma has under these names; text in the place of an id is taken as it is.
    pub(super) fn told<const N: usize>(&self, pragma: &Pragma, names: [&str; N]) -> Vec<String> {
        let mut told: Vec<String> = Vec::new();
        for value in names.iter().filter_map(|name| pragma.get(name)) {
            let text = match self.0.get(value) {
                Some(text) => text.as_str(),
                None if value.starts_with(ID) => continue,
                None => value,
            };
            if !text.trim().is_empty() && !told.iter().any(|other| other == text) {
                told.push(text.to_owned());
            }
        }
        told
    }
}

/// A value of YAML on one line, without its quotes.
fn unquoted(value: &str) -> String {
    if let Some(inner) = value.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\'')) {
        return inner.replace("''", "'");
    }
    let Some(inner) = value.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) else {
        return value.to_owned();
    };
    let mut out = String::new();
    let mut signs = inner.chars();
    while let Some(c) = signs.next() {
        match c {
            '\\' => match signs.next() {
                Some('n') => out.push('\n'),
                Some('t') => out.push('\t'),
                Some(other) => out.push(other),
                None => {}
            },
            c => out.push(c),
        }
    }
    out
}

/// The file of these texts, each under its id.
pub(crate) fn written(texts: &[(String, String)]) -> String {
    let mut out = String::from("\u{feff}MultiLingualTexts:\r\n");
    for (id, text) in texts {
        let text = text
            .replace('\\', "\\\\")
            .replace('"', "\\\"")
            .replace('\n', "\\n");
        out.push_str(&format!("  - id: {id}\r\n    {FIRST}: \"{text}\"\r\n"));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_found_by_their_ids() {
        let text = "\u{feff}MultiLingualTexts:\r\n  - id: MLC_a\r\n    zh-CN: 互锁\r\n    en-US: \"one: \\\"two\\\"\"\r\n  - id: MLC_b\r\n    de-DE: 'it''s'\r\n<root />\n";
        let texts = Texts::of(text);
        assert_eq!(texts.0["MLC_a"], "one: \"two\"");
        assert_eq!(texts.0["MLC_b"], "it's");
        let back = written(&[("MLC_a".to_owned(), "a \\ \"b\"\nc".to_owned())]);
        assert_eq!(Texts::of(&back).0["MLC_a"], "a \\ \"b\"\nc");
    }
}
