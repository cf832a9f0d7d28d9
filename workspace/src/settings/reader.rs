//! Tables, keys and values with their places; what is wrong with them is collected.

use super::error::{Mistake, SettingsError};
use ladder_syntax::{LineIndex, TextRange, TextSize};
use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A settings file that is being read.
pub(super) struct Reader<'t> {
    text: &'t str,
    mistakes: Vec<(Range<usize>, String)>,
}

/// A table whose keys are taken out one by one: what is left at the end is unknown.
pub(super) struct Table<'t> {
    /// `[format]`; empty for the file itself.
    name: String,
    entries: DeTable<'t>,
    /// The keys that were asked for.
    known: Vec<&'static str>,
    span: Range<usize>,
}

/// A value and where it stands.
pub(super) type Given<'t> = Spanned<DeValue<'t>>;

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str) -> Reader<'t> {
        Reader {
            text,
            mistakes: Vec::new(),
        }
    }

    /// The file's tables. None if it is no TOML.
    pub(super) fn document(&mut self) -> Option<Table<'t>> {
        match DeTable::parse(self.text) {
            Ok(document) => {
                let span = document.span();
                Some(Table::new(String::new(), document.into_inner(), span))
            }
            Err(error) => {
                let range = error.span().unwrap_or(0..0);
                self.wrong(range, format!("this is no TOML: {}", error.message()));
                None
            }
        }
    }

    pub(super) fn wrong(&mut self, range: Range<usize>, message: impl Into<String>) {
        self.mistakes.push((range, message.into()));
    }

    /// What was found to be wrong.
    pub(super) fn finish(mut self, file: &Path) -> Result<(), SettingsError> {
        if self.mistakes.is_empty() {
            return Ok(());
        }
        self.mistakes.sort_by_key(|(range, _)| range.start);
        let index = LineIndex::new(self.text);
        let offset = |at: usize| TextSize::new(at.min(self.text.len()) as u32);
        let mistakes = self.mistakes.into_iter().map(|(range, message)| {
            let (start, end) = (offset(range.start), offset(range.end));
            Mistake {
                range: TextRange::new(start, end.max(start)),
                place: index.line_column(self.text, start),
                message,
            }
        });
        Err(SettingsError::Mistakes {
            file: file.to_owned(),
            mistakes: mistakes.collect(),
        })
    }

    /// A whole number from `least` to `most`.
    pub(super) fn number(&mut self, given: &Given<'t>, least: i64, most: i64) -> Option<i64> {
        let number = match given.get_ref() {
            DeValue::Integer(digits) => {
                i64::from_str_radix(&digits.as_str().replace('_', ""), digits.radix()).ok()
            }
            _ => None,
        };
        let number = number.filter(|number| (least..=most).contains(number));
        if number.is_none() {
            let message = if most == i64::MAX {
                format!("a whole number of at least {least} is expected here")
            } else {
                format!("a whole number from {least} to {most} is expected here")
            };
            self.wrong(given.span(), message);
        }
        number
    }

    /// A text. `example` shows what is meant.
    pub(super) fn string(&mut self, given: &Given<'t>, example: &str) -> Option<Cow<'t, str>> {
        match given.get_ref() {
            DeValue::String(text) => Some(text.clone()),
            _ => {
                self.wrong(
                    given.span(),
                    format!("a text in quotes is expected here, for example {example}"),
                );
                None
            }
        }
    }

    /// A list of tables, each under a heading like `heading`.
    pub(super) fn tables(&mut self, given: Given<'t>, heading: &str) -> Vec<Table<'t>> {
        let span = given.span();
        let DeValue::Array(items) = given.into_inner() else {
            self.wrong(span, format!("write {heading} on a line of its own"));
            return Vec::new();
        };
        let mut tables = Vec::new();
        for item in items {
            let span = item.span();
            match item.into_inner() {
                DeValue::Table(entries) => tables.push(Table::new(heading.to_owned(), entries, span)),
                _ => self.wrong(span, format!("write {heading} on a line of its own")),
            }
        }
        tables
    }

    /// A list of texts.
    pub(super) fn strings(&mut self, given: &Given<'t>, example: &str) -> Vec<(Range<usize>, Cow<'t, str>)> {
        let DeValue::Array(items) = given.get_ref() else {
            self.wrong(
                given.span(),
                format!("a list of texts is expected here, for example [{example}]"),
            );
            return Vec::new();
        };
        let items = items.iter();
        items
            .filter_map(|item| Some((item.span(), self.string(item, example)?)))
            .collect()
    }
}

impl<'t> Table<'t> {
    fn new(name: String, entries: DeTable<'t>, span: Range<usize>) -> Table<'t> {
        Table {
            name,
            entries,
            known: Vec::new(),
            span,
        }
    }

    /// A value that is a table in braces; none if it is anything else.
    pub(super) fn inline(name: &str, given: &Given<'t>) -> Option<Table<'t>> {
        match given.get_ref() {
            DeValue::Table(entries) => Some(Table::new(name.to_owned(), entries.clone(), given.span())),
            _ => None,
        }
    }

    /// Where it stands.
    pub(super) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The value of a key, if it is there.
    pub(super) fn take(&mut self, key: &'static str) -> Option<Given<'t>> {
        self.known.push(key);
        self.entries.remove(key)
    }

    /// A table in this one.
    pub(super) fn table(&mut self, reader: &mut Reader<'t>, key: &'static str) -> Option<Table<'t>> {
        let given = self.take(key)?;
        let span = given.span();
        match given.into_inner() {
            DeValue::Table(entries) => Some(Table::new(key.to_owned(), entries, span)),
            _ => {
                reader.wrong(
                    span,
                    format!("`{key}` is a table: write [{key}] on a line of its own"),
                );
                None
            }
        }
    }

    /// All keys with their values, for a table whose keys are not fixed.
    pub(super) fn entries(self) -> impl Iterator<Item = (Spanned<Cow<'t, str>>, Given<'t>)> {
        self.entries.into_iter()
    }

    /// Complains of what nobody asked for.
    pub(super) fn finish(self, reader: &mut Reader<'t>) {
        let of = if self.name.is_empty() {
            String::new()
        } else {
            format!(" in [{}]", self.name)
        };
        for key in self.entries.keys() {
            let name = key.get_ref();
            let hint = hint(name, &self.known);
            reader.wrong(key.span(), format!("`{name}` is no setting{of}: {hint}"));
        }
    }
}

/// What was probably meant, or all there is.
pub(super) fn hint(wanted: &str, known: &[&str]) -> String {
    match closest(wanted, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("known here are {}", known.join(", ")),
    }
}

/// The nearest name: at most two letters away.
pub(super) fn closest<'k>(wanted: &str, known: &[&'k str]) -> Option<&'k str> {
    let wanted = wanted.to_lowercase();
    known
        .iter()
        .map(|name| (strsim::osa_distance(&wanted, name), *name))
        .filter(|(distance, name)| *distance <= 2 && *distance < name.len())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
