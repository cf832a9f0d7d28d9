//! Values as L5K writes them, and L5X too.

use crate::model::Raw;

/// A value as L5K writes it: `[0,1000,[1,2],'text']`.
pub(crate) fn value(text: &str) -> Option<Raw> {
    let mut reader = Values {
        rest: text.trim(),
        depth: 0,
    };
    let value = reader.value()?;
    reader.rest.trim().is_empty().then_some(value)
}

struct Values<'t> {
    rest: &'t str,
    depth: usize,
}

/// Values nest no deeper.
const DEEPEST: usize = 40;

impl Values<'_> {
    fn value(&mut self) -> Option<Raw> {
        self.rest = self.rest.trim_start();
        if let Some(rest) = self.rest.strip_prefix('[') {
            self.depth += 1;
            if self.depth > DEEPEST {
                return None;
            }
            self.rest = rest;
            let mut values = Vec::new();
            loop {
                values.push(self.value()?);
                self.rest = self.rest.trim_start();
                if let Some(rest) = self.rest.strip_prefix(',') {
                    self.rest = rest;
                    continue;
                }
                self.rest = self.rest.strip_prefix(']')?;
                self.depth -= 1;
                return Some(Raw::List(values));
            }
        }
        let end = if self.rest.starts_with('\'') {
            let mut escaped = false;
            let inner = self.rest.char_indices().skip(1).find(|(_, c)| {
                let ends = *c == '\'' && !escaped;
                escaped = *c == '$' && !escaped;
                ends
            });
            inner?.0 + 1
        } else {
            self.rest.find([',', ']']).unwrap_or(self.rest.len())
        };
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(Raw::Scalar(String::new(), text.trim().to_owned()))
    }
}
