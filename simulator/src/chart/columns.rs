//! Tracks in as many columns as a client can show: what is drawn of each.

use super::Tick;
use super::track::{Change, Kind, Track};
use super::{text, time_axis};
use ladder_analysis::values::value::Value;

/// The scans that are drawn, and in how many columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Window {
    /// The first of them.
    pub first: u64,
    /// The last of them, which may lie after the newest.
    pub last: u64,
    /// How many scans a column stands for.
    pub per: u64,
}

/// What a BOOL did in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// It was low.
    Low,
    /// It was high.
    High,
    /// It was both.
    Both,
}

/// What is drawn of a tag in a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// Of a BOOL.
    Bit(Level),
    /// Of a number: TIME in milliseconds. Values that are no number (NaN, infinite) do not count.
    Number {
        /// The least value.
        least: f64,
        /// The greatest value.
        greatest: f64,
        /// The last value.
        last: f64,
    },
    /// Of a text or date: the last value. Also of a column with nothing but values that are no number.
    Text(String),
}

/// What is drawn in a column and in those after it, up to the next that is listed.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The column: its first scan is this many times the length of a column.
    pub number: u64,
    /// What is drawn.
    pub mark: Mark,
}

impl Window {
    /// `span` scans up to `last`, in no more columns than that. The first scan is 1: where fewer scans were done than are
    /// to be shown, the window begins there and has room after them.
    pub fn new(last: u64, span: u64, columns: u64) -> Window {
        let span = span.max(1);
        let first = last.saturating_sub(span - 1).max(1);
        // Columns at whole multiples of their length may stick out at both ends.
        let per = span.div_ceil(columns.max(1));
        Window {
            first,
            last: first.saturating_add(span - 1),
            per,
        }
    }

    /// The column that a scan belongs to.
    pub(crate) fn column(&self, scan: u64) -> u64 {
        scan / self.per
    }

    /// The ticks of the time axis, in nanoseconds, for this time from scan to scan.
    pub fn ticks(&self, interval: i64, most: u64) -> Vec<Tick> {
        let time = |scan: u64| scan as f64 * interval as f64;
        time_axis::ticks(time(self.first), time(self.last.saturating_add(1)), most as f64)
    }
}

impl Track {
    /// What is drawn of the scans from `since` on that lie in a window, up to `newest`. What follows the last column that is
    /// listed, up to the newest scan, looks like it.
    pub fn columns(&self, window: &Window, since: u64, newest: u64) -> Vec<Column> {
        let mut drawn: Vec<Column> = Vec::new();
        let Some(first) = self.first() else {
            return drawn;
        };
        let from = window.column(window.first.max(since)).max(window.column(first));
        let to = window.column(window.last.min(newest));
        let mut draw = |number: u64, mark: Mark| {
            if drawn.last().is_none_or(|before: &Column| before.mark != mark) {
                drawn.push(Column { number, mark });
            }
        };
        // The change whose value holds where the next column begins.
        let mut next = self.changes_until(from * window.per);
        let mut column = from;
        while column <= to {
            let (start, end) = (column * window.per, (column + 1) * window.per);
            let holds = next.checked_sub(1).and_then(|at| self.change(at));
            let mut values: Vec<&Value> = Vec::new();
            if let Some(change) = holds
                && self.change(next).is_none_or(|next| next.scan > start)
            {
                values.push(&change.value);
            }
            while let Some(Change { scan, value }) = self.change(next)
                && *scan < end
            {
                values.push(value);
                next += 1;
            }
            draw(column, self.mark(&values));
            // Nothing changes up to the column of the next change; the one after this one is drawn as it stays.
            column = match self.change(next) {
                _ if values.len() > 1 => column + 1,
                Some(change) => window.column(change.scan),
                None => break,
            };
        }
        drawn
    }

    fn mark(&self, values: &[&Value]) -> Mark {
        match self.kind() {
            Kind::Bit => {
                let is_high = |value: &&&Value| ***value == Value::Bool(true);
                let high = values.iter().filter(is_high).count();
                Mark::Bit(match high {
                    0 => Level::Low,
                    _ if high == values.len() => Level::High,
                    _ => Level::Both,
                })
            }
            Kind::Number => {
                let numbers = values.iter().filter_map(|value| self.number(value));
                let range = numbers.fold(None, |range: Option<(f64, f64, f64)>, it| match range {
                    Some((least, greatest, _)) => Some((least.min(it), greatest.max(it), it)),
                    None => Some((it, it, it)),
                });
                match range {
                    Some((least, greatest, last)) => Mark::Number {
                        least,
                        greatest,
                        last,
                    },
                    None => self.words(values),
                }
            }
            Kind::Text => self.words(values),
        }
    }

    fn words(&self, values: &[&Value]) -> Mark {
        let last = values.last().map(|value| text::reading(value, self.point.ty));
        Mark::Text(last.unwrap_or_default())
    }
}
