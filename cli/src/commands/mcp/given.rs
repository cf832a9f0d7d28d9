//! The arguments of a call, as the client has them.

use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// What a call brings.
#[derive(Debug, Clone, Default)]
pub(super) struct Given(pub(super) Map<String, Value>);

impl Given {
    /// A text; none if it is not there.
    pub(super) fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name)?.as_str()
    }

    /// A text that must be there.
    pub(super) fn needed(&self, name: &str) -> Result<&str, String> {
        self.text(name).ok_or_else(|| format!("`{name}` is missing"))
    }

    /// A whole number from 0 on.
    pub(super) fn number(&self, name: &str) -> Option<u64> {
        self.0.get(name)?.as_u64()
    }

    /// Where an answer begins.
    pub(super) fn from(&self) -> usize {
        let from = self.number("from").unwrap_or(0);
        usize::try_from(from).unwrap_or(usize::MAX)
    }

    /// Whether a word is given.
    pub(super) fn is_asked(&self, name: &str) -> bool {
        self.0.get(name).and_then(Value::as_bool).unwrap_or(false)
    }

    /// Several texts.
    pub(super) fn texts(&self, name: &str) -> Vec<&str> {
        let list = self.0.get(name).and_then(Value::as_array);
        list.into_iter().flatten().filter_map(Value::as_str).collect()
    }

    /// Names with their values, as they are written on a command line.
    pub(super) fn values(&self, name: &str) -> Vec<(String, String)> {
        let map = self.0.get(name).and_then(Value::as_object);
        let pairs = map.into_iter().flatten();
        pairs.map(|(name, value)| (name.clone(), plain(value))).collect()
    }

    /// What is given before which scan: a list of objects with `scan` and the values of tags.
    pub(super) fn by_scan(&self, name: &str) -> BTreeMap<u64, BTreeMap<String, String>> {
        let list = self.0.get(name).and_then(Value::as_array);
        let mut scans: BTreeMap<u64, BTreeMap<String, String>> = BTreeMap::new();
        for row in list.into_iter().flatten() {
            if let (Some(scan), Some(values)) = (row["scan"].as_u64(), row["values"].as_object()) {
                let values = values.iter().map(|(name, value)| (name.clone(), plain(value)));
                scans.entry(scan).or_default().extend(values);
            }
        }
        scans
    }
}

/// A value as a table or a command line has it.
fn plain(value: &Value) -> String {
    match value {
        Value::Bool(true) => "TRUE".to_owned(),
        Value::Bool(false) => "FALSE".to_owned(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
