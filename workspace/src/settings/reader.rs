//! Tables, keys and values with their places; what is wrong with them is collected.

use super::given::{Entry, Given, Value};
use super::table::{Kind, Section, SetBy, Setting, keys, sections};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value;
use ladder_analysis::with_article;
use ladder_simulator::value_text;
use std::ops::Range;

/// Settings that are being read.
pub(super) struct Reader {
    source: Source,
    errors: Vec<(Range<usize>, String)>,
}

/// Who wrote them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
    /// `ladder.toml`.
    File,
    /// An editor.
    Editor,
}

impl Source {
    fn allows(self, place: SetBy) -> bool {
        match self {
            Source::File => place.is_in_file(),
            Source::Editor => place.is_in_editor(),
        }
    }

    /// What to do with a setting that is not for this place.
    fn where_it_belongs(self) -> &'static str {
        match self {
            Source::File => "every person sets it in the settings of the editor",
            Source::Editor => "it must be the same for everybody, and is in ladder.toml",
        }
    }
}

/// A table whose keys are taken out one by one: what is left at the end is unknown.
pub(super) struct Table {
    /// `format`; empty for the whole.
    name: String,
    entries: Vec<Entry>,
    /// The keys that there are.
    known: Vec<&'static str>,
    /// Keys that belong to the other source.
    of_other_source: Vec<&'static str>,
    range: Range<usize>,
}

impl Reader {
    pub(super) fn new(source: Source) -> Reader {
        Reader {
            source,
            errors: Vec::new(),
        }
    }

    pub(super) fn wrong(&mut self, range: Range<usize>, message: impl Into<String>) {
        self.errors.push((range, message.into()));
    }

    /// What was found to be wrong, in the order of the places.
    pub(super) fn finish(mut self) -> Vec<(Range<usize>, String)> {
        self.errors.sort_by_key(|(range, _)| range.start);
        self.errors
    }

    /// All that is set.
    pub(super) fn top(&self, entries: Vec<Entry>) -> Table {
        Table {
            name: String::new(),
            entries,
            known: sections(|place| self.source.allows(place)),
            of_other_source: sections(|place| !self.source.allows(place)),
            range: 0..0,
        }
    }

    /// Those of a section that may be there several times.
    pub(super) fn sections(&mut self, top: &mut Table, section: &Section) -> Vec<Table> {
        let given = top.known.contains(&section.name).then(|| top.take(section.name));
        let Some(Given { value, range }) = given.flatten() else {
            return Vec::new();
        };
        let name = section.name;
        let heading = format!("write [[{name}]] on a line of its own");
        let Value::List(items) = value else {
            self.wrong(range, heading);
            return Vec::new();
        };
        let mut tables = Vec::new();
        for Given { value, range } in items {
            match value {
                Value::Table(entries) => tables.push(Table::with(section, entries, range, self.source)),
                _ => self.wrong(range, heading.clone()),
            }
        }
        tables
    }

    /// A section, if it is there.
    pub(super) fn section(&mut self, top: &mut Table, section: &Section) -> Option<Table> {
        let (key, inner) = section.outer();
        if !top.known.contains(&key) {
            return None;
        }
        let mut given = top.take(key)?;
        if let (Some(inner), Value::Table(entries)) = (inner, &given.value) {
            let mut around = Table {
                name: key.to_owned(),
                entries: entries.clone(),
                known: vec![inner],
                of_other_source: Vec::new(),
                range: given.range,
            };
            let found = around.take(inner);
            around.finish(self);
            given = found?;
        }
        match given.value {
            Value::Table(entries) => Some(Table::with(section, entries, given.range, self.source)),
            _ => {
                let name = section.name;
                let message = match self.source {
                    Source::File => format!("`{name}` is a table: write [{name}] on a line of its own"),
                    Source::Editor => {
                        let key = section.settings.first().map_or("key", |setting| setting.key);
                        format!("a table of settings is expected here, as in {{ \"{key}\": ... }}")
                    }
                };
                self.wrong(given.range, message);
                None
            }
        }
    }

    /// Reports the first of the settings that is not there and must be.
    pub(super) fn needs(&mut self, table: &Table, section: &Section) {
        let keys = section.list.unwrap_or_default();
        let mut settings = section.settings.iter();
        let lacks = settings.find(|it| keys.contains(&it.key) && !table.has(it.key));
        if let Some(Setting { key, example, .. }) = lacks {
            let one = with_article(section.name);
            let message = format!("{one} has `{key}`, for example {key} = {example}");
            self.wrong(table.range(), message);
        }
    }

    /// The value of a setting, if it is there and may be set in this source.
    pub(super) fn take(&self, table: &mut Table, setting: &Setting) -> Option<Given> {
        if self.source.allows(setting.place) {
            table.take(setting.key)
        } else {
            None
        }
    }

    /// A whole number within the setting's limits.
    pub(super) fn whole(&mut self, table: &mut Table, setting: &Setting) -> Option<i64> {
        let given = self.take(table, setting)?;
        let Kind::Whole { least, most } = setting.kind else {
            return None;
        };
        match given.value {
            Value::Whole(number) if (least..=most).contains(&number) => Some(number),
            _ => {
                let message = if most == i64::MAX {
                    format!("a whole number of at least {least} is expected here")
                } else {
                    format!("a whole number from {least} to {most} is expected here")
                };
                self.wrong(given.range, message);
                None
            }
        }
    }

    /// `true` or `false`.
    pub(super) fn switch(&mut self, table: &mut Table, setting: &Setting) -> Option<bool> {
        let given = self.take(table, setting)?;
        if let Value::Switch(switch) = given.value {
            return Some(switch);
        }
        self.wrong(given.range, "true or false is expected here");
        None
    }

    /// A time longer than 0, in nanoseconds.
    pub(super) fn duration(&mut self, table: &mut Table, setting: &Setting) -> Option<i64> {
        let given = self.take(table, setting)?;
        let text = self.text(&given, setting.example)?;
        match value_text::parse(&text, Scalar::Time) {
            Ok(value::Value::Int(nanoseconds)) if nanoseconds > 0 => Some(nanoseconds),
            Ok(_) => {
                self.wrong(
                    given.range,
                    "the time from one scan to the next must be longer than 0",
                );
                None
            }
            Err(problem) => {
                self.wrong(given.range, problem);
                None
            }
        }
    }

    /// A text. `example` shows what is meant.
    pub(super) fn text(&mut self, given: &Given, example: &str) -> Option<String> {
        if let Value::Text(text) = &given.value {
            return Some(text.clone());
        }
        let message = format!("a text in quotes is expected here, for example {example}");
        self.wrong(given.range.clone(), message);
        None
    }

    /// One of the texts that a setting takes.
    pub(super) fn choice(&mut self, table: &mut Table, setting: &Setting) -> Option<&'static str> {
        let given = self.take(table, setting)?;
        let Kind::Choice(choices) = setting.kind else {
            return None;
        };
        let text = self.text(&given, setting.example)?;
        let choice = choices.iter().find(|choice| **choice == text).copied();
        if choice.is_none() {
            self.wrong(
                given.range,
                format!("`{text}` is not one of them: {}", hint(&text, choices)),
            );
        }
        choice
    }

    /// A list of texts. `example` shows one of them.
    pub(super) fn texts(&mut self, given: &Given, example: &str) -> Vec<(Range<usize>, String)> {
        let Value::List(items) = &given.value else {
            self.wrong(
                given.range.clone(),
                format!("a list of texts is expected here, for example [{example}]"),
            );
            return Vec::new();
        };
        let items = items.iter();
        items
            .filter_map(|item| Some((item.range.clone(), self.text(item, example)?)))
            .collect()
    }

    /// A text, or a list of texts. `example` shows one of them.
    pub(super) fn text_or_texts(&mut self, given: &Given, example: &str) -> Vec<(Range<usize>, String)> {
        match given.value {
            Value::List(_) => self.texts(given, example),
            _ => {
                let text = self.text(given, example);
                text.map(|text| (given.range.clone(), text)).into_iter().collect()
            }
        }
    }

    /// A list of tables, each under a heading like `heading`, with these keys and perhaps others.
    pub(super) fn tables(
        &mut self,
        given: Given,
        heading: &str,
        known: &'static [&'static str],
    ) -> Vec<Table> {
        let Value::List(items) = given.value else {
            self.wrong(given.range, format!("write {heading} on a line of its own"));
            return Vec::new();
        };
        let mut tables = Vec::new();
        for item in items {
            match Table::of(heading, item.clone(), known) {
                Some(table) => tables.push(table),
                None => self.wrong(item.range, format!("write {heading} on a line of its own")),
            }
        }
        tables
    }
}

impl Table {
    fn with(section: &Section, entries: Vec<Entry>, range: Range<usize>, source: Source) -> Table {
        Table {
            name: section.name.to_owned(),
            entries,
            known: keys(section, |place| source.allows(place)),
            of_other_source: keys(section, |place| !source.allows(place)),
            range,
        }
    }

    /// A value that is a table; none if it is anything else.
    pub(super) fn of(name: &str, given: Given, known: &'static [&'static str]) -> Option<Table> {
        match given.value {
            Value::Table(entries) => Some(Table {
                name: name.to_owned(),
                entries,
                known: known.to_vec(),
                of_other_source: Vec::new(),
                range: given.range,
            }),
            _ => None,
        }
    }

    /// Where it is.
    pub(super) fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// Whether a key is there.
    pub(super) fn has(&self, key: &str) -> bool {
        self.entries.iter().any(|entry| entry.key == key)
    }

    /// The value of a key, if it is there.
    pub(super) fn take(&mut self, key: &str) -> Option<Given> {
        let at = self.entries.iter().position(|entry| entry.key == key)?;
        Some(self.entries.remove(at).given)
    }

    /// All keys with their values, for a table whose keys are not fixed.
    pub(super) fn entries(self) -> impl Iterator<Item = Entry> {
        self.entries.into_iter()
    }

    /// Reports what is not known.
    pub(super) fn finish(self, reader: &mut Reader) {
        let of = if self.name.is_empty() {
            String::new()
        } else {
            format!(" in [{}]", self.name)
        };
        for entry in self.entries {
            let name = &entry.key;
            let hint = if self.of_other_source.contains(&name.as_str()) {
                reader.source.where_it_belongs().to_owned()
            } else {
                hint(name, &self.known)
            };
            reader.wrong(entry.range, format!("`{name}` is not a setting{of}: {hint}"));
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
        .map(|name| (strsim::osa_distance(&wanted, &name.to_lowercase()), *name))
        .filter(|(distance, name)| *distance <= 2 && *distance < name.len())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
