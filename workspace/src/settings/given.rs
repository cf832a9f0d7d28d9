//! What was written: a settings file as TOML, or an editor as JSON.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and where it is.
#[derive(Debug, Clone)]
pub(super) struct Given {
    /// In bytes of the file; in an editor's settings the number of the path, see [`Paths`].
    pub(super) range: Range<usize>,
    pub(super) value: Value,
}

/// A value.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Switch(bool),
    Whole(i64),
    Text(String),
    List(Vec<Given>),
    Table(Vec<Entry>),
    /// A date, a number with a fraction, and any other value that no setting takes.
    Other,
}

/// A key with its value.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) key: String,
    /// Where the key is.
    pub(super) range: Range<usize>,
    pub(super) given: Given,
}

/// What an editor says of settings, before it is checked.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    /// Nothing: as if the key were not there.
    Nothing,
    /// `true` or `false`.
    Switch(bool),
    /// A whole number.
    Whole(i64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Tree>),
    /// A table.
    Table(Vec<(String, Tree)>),
    /// Anything else.
    Other,
}

/// The paths of an editor's values (`format.width`), by their numbers.
#[derive(Debug, Default)]
pub(super) struct Paths(Vec<String>);

impl Paths {
    /// The path of a place; empty for the whole.
    pub(super) fn of(&self, range: &Range<usize>) -> &str {
        self.0.get(range.start).map_or("", String::as_str)
    }

    fn add(&mut self, path: String) -> Range<usize> {
        self.0.push(path);
        let last = self.0.len() - 1;
        last..last
    }
}

/// A file's tables as they were read.
pub(super) fn from_toml(document: Spanned<DeTable<'_>>) -> Vec<Entry> {
    entries(document.into_inner())
}

fn entries(table: DeTable<'_>) -> Vec<Entry> {
    let entries = table.into_iter().map(|(key, value)| Entry {
        range: key.span(),
        key: key.into_inner().into_owned(),
        given: given(value),
    });
    entries.collect()
}

fn given(value: Spanned<DeValue<'_>>) -> Given {
    Given {
        range: value.span(),
        value: match value.into_inner() {
            DeValue::String(text) => Value::Text(text.into_owned()),
            DeValue::Boolean(switch) => Value::Switch(switch),
            DeValue::Integer(digits) => {
                let text = digits.as_str().replace('_', "");
                i64::from_str_radix(&text, digits.radix()).map_or(Value::Other, Value::Whole)
            }
            DeValue::Array(items) => Value::List(items.into_iter().map(given).collect()),
            DeValue::Table(table) => Value::Table(entries(table)),
            DeValue::Float(_) | DeValue::Datetime(_) => Value::Other,
        },
    }
}

/// An editor's tables. None if it is something else.
pub(super) fn from_tree(tree: &Tree, paths: &mut Paths) -> Option<Vec<Entry>> {
    match tree {
        Tree::Nothing => Some(Vec::new()),
        Tree::Table(table) => Some(entries_at("", table, paths)),
        _ => None,
    }
}

fn entries_at(path: &str, table: &[(String, Tree)], paths: &mut Paths) -> Vec<Entry> {
    let set = table.iter().filter(|(_, value)| *value != Tree::Nothing);
    set.map(|(key, value)| {
        let path = if path.is_empty() {
            key.clone()
        } else {
            format!("{path}.{key}")
        };
        let given = given_at(&path, value, paths);
        Entry {
            key: key.clone(),
            range: given.range.clone(),
            given,
        }
    })
    .collect()
}

fn given_at(path: &str, value: &Tree, paths: &mut Paths) -> Given {
    let range = paths.add(path.to_owned());
    let value = match value {
        Tree::Switch(switch) => Value::Switch(*switch),
        Tree::Whole(number) => Value::Whole(*number),
        Tree::Text(text) => Value::Text(text.clone()),
        Tree::List(items) => {
            let items = items.iter().enumerate();
            Value::List(
                items
                    .map(|(nth, item)| given_at(&format!("{path}[{nth}]"), item, paths))
                    .collect(),
            )
        }
        Tree::Table(table) => Value::Table(entries_at(path, table, paths)),
        Tree::Nothing | Tree::Other => Value::Other,
    };
    Given { range, value }
}
