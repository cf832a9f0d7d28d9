//! Timing diagrams as pictures: a lane for each tag, time from left to right.
//!
//! BOOL is a waveform; other values are drawn as a bus with the value in it, or, where they change too often to be
//! read, as a curve. The picture follows the light or dark scheme of its reader, and its text stays text.

mod draw;

use super::{Header, Write};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// What a timing diagram shows.
#[derive(Debug, Clone, PartialEq)]
struct Timing {
    /// Said to those who cannot see the picture, and shown where a pointer rests on it.
    title: String,
    /// Nanoseconds that a column stands for.
    interval: i64,
    /// How many columns there are.
    columns: u64,
    /// From top to bottom.
    lanes: Vec<Lane>,
}

/// One line of a timing diagram.
#[derive(Debug, Clone, PartialEq)]
struct Lane {
    /// What is at its left.
    name: String,
    /// What it draws.
    signal: Signal,
}

/// What a lane draws. A change is a column and what holds from there on; the first is at column 0.
#[derive(Debug, Clone, PartialEq)]
enum Signal {
    /// A waveform.
    Levels(Vec<(u64, bool)>),
    /// Values: as they are read, and as a number if they are one.
    Values(Vec<Change>),
}

/// A new value.
#[derive(Debug, Clone, PartialEq)]
struct Change {
    column: u64,
    text: String,
    number: Option<f64>,
}

impl Timing {
    /// The picture: one SVG document.
    fn svg(&self) -> String {
        draw::svg(self)
    }
}

/// Collects the changes of a run; the picture is drawn at its end.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    lanes: Vec<Lane>,
    before: Vec<Value>,
}

impl Write for Recorder {
    fn begin(&mut self, header: &Header, _: &mut String) {
        let lanes = header.tags.iter().map(|tag| Lane {
            name: tag.name.clone(),
            signal: match tag.ty() {
                Scalar::Bool => Signal::Levels(Vec::new()),
                _ => Signal::Values(Vec::new()),
            },
        });
        self.lanes = lanes.collect();
    }

    fn row(&mut self, header: &Header, scan: u64, values: &[Value], _: &mut String) {
        for (index, value) in values.iter().enumerate() {
            if self.before.get(index) == Some(value) {
                continue;
            }
            match (&mut self.lanes[index].signal, value) {
                (Signal::Levels(changes), value) => changes.push((scan, *value == Value::Bool(true))),
                (Signal::Values(changes), value) => {
                    let ty = header.tags[index].ty();
                    changes.push(Change {
                        column: scan,
                        text: shown(value, ty),
                        number: number(value, ty),
                    });
                }
            }
        }
        self.before.clear();
        self.before.extend_from_slice(values);
    }

    fn end(&mut self, header: &Header, scans: u64, out: &mut String) {
        let timing = Timing {
            title: format!("Timing diagram of {}", header.program),
            interval: header.interval,
            columns: scans,
            lanes: std::mem::take(&mut self.lanes),
        };
        out.push_str(&timing.svg());
    }
}

/// A value as it is in a bus: `1s500ms` is a time even without its type.
fn shown(value: &Value, ty: Scalar) -> String {
    let text = value_text::display(value, ty);
    match text.strip_prefix("T#") {
        Some(duration) if ty == Scalar::Time => duration.to_owned(),
        _ => text,
    }
}

fn number(value: &Value, ty: Scalar) -> Option<f64> {
    match value {
        Value::Int(_) if ty.is_date() => None,
        Value::Int(number) if matches!(ty, Scalar::Ulint | Scalar::Lword) => Some(*number as u64 as f64),
        Value::Int(number) => Some(*number as f64),
        Value::Real(real) => Some(*real),
        _ => None,
    }
}
