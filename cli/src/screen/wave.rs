//! A tag's past as a row of characters.

use super::record::Bucket;
use super::theme::Charset;

/// How a tag's past is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// High and low with edges, as an oscilloscope shows it.
    Bit,
    /// Bars between the least and the greatest value.
    Number,
}

impl Shape {
    /// How many buckets fit into a column.
    pub(super) fn buckets_in_column(self, charset: Charset) -> usize {
        match (self, charset) {
            (Shape::Bit, Charset::Unicode) => 2,
            _ => 1,
        }
    }
}

/// The past in so many columns as its buckets fill.
pub(super) fn wave(shape: Shape, charset: Charset, buckets: &[Option<Bucket>]) -> String {
    match (shape, charset) {
        (Shape::Bit, Charset::Unicode) => braille(buckets),
        (Shape::Bit, Charset::Ascii) => buckets
            .iter()
            .map(|bucket| match level(bucket.as_ref()) {
                Level::Unknown => ' ',
                Level::Low => '_',
                Level::High => '-',
                Level::Both => '|',
            })
            .collect(),
        (Shape::Number, Charset::Unicode) => bars(buckets, &['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█']),
        (Shape::Number, Charset::Ascii) => bars(buckets, &['_', '.', ':', '-', '=', '+', '*', '#']),
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Level {
    Unknown,
    Low,
    High,
    /// It changed within the bucket.
    Both,
}

fn level(bucket: Option<&Bucket>) -> Level {
    match bucket {
        None => Level::Unknown,
        Some(bucket) if bucket.least > 0.5 => Level::High,
        Some(bucket) if bucket.greatest < 0.5 => Level::Low,
        Some(_) => Level::Both,
    }
}

/// Two buckets a column. Dots of a column from top to bottom: 1 2 4 40, of its right half 8 10 20 80.
fn braille(buckets: &[Option<Bucket>]) -> String {
    let mut before = Level::Unknown;
    let mut dots = buckets.iter().map(|bucket| {
        let level = level(bucket.as_ref());
        let edge = matches!(
            (before, level),
            (Level::Low, Level::High) | (Level::High, Level::Low)
        );
        before = level;
        match level {
            Level::Unknown => (0, 0),
            Level::Both => (0x47, 0xb8),
            _ if edge => (0x47, 0xb8),
            Level::High => (0x01, 0x08),
            Level::Low => (0x40, 0x80),
        }
    });
    let mut drawn = String::new();
    while let Some((left, _)) = dots.next() {
        let right = dots.next().map_or(0, |(_, right)| right);
        drawn.push(match left | right {
            0 => ' ',
            dots => char::from_u32(0x2800 + dots).unwrap_or(' '),
        });
    }
    drawn
}

fn bars(buckets: &[Option<Bucket>], steps: &[char; 8]) -> String {
    let known = || buckets.iter().flatten();
    let least = known().map(|bucket| bucket.least).fold(f64::INFINITY, f64::min);
    let greatest = known()
        .map(|bucket| bucket.greatest)
        .fold(f64::NEG_INFINITY, f64::max);
    let span = greatest - least;
    let height = |value: f64| {
        if span > 0.0 && span.is_finite() {
            ((value - least) / span * 7.0).round() as usize
        } else if value == 0.0 {
            0
        } else {
            3
        }
    };
    buckets
        .iter()
        .map(|bucket| {
            bucket
                .as_ref()
                .map_or(' ', |bucket| steps[height(bucket.last).min(7)])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::record::Record;
    use expect_test::{Expect, expect};
    use ladder_analysis::program::Program;
    use ladder_analysis::value::Value;
    use ladder_simulator::{Options, Simulation};
    use std::sync::Arc;

    /// The wave of a tag that held these values in the last scans of so many.
    fn check(
        shape: Shape,
        charset: Charset,
        values: &[i64],
        scans: u64,
        now: u64,
        columns: usize,
        wave_is: Expect,
    ) {
        let simulation = Simulation::new(Arc::new(Program::default()), Options::default()).unwrap();
        // Any point will do: its name and values are given here.
        let point = simulation.resolve("SYS.SCAN").unwrap();
        let mut record = Record::default();
        record.add(
            point,
            &values.iter().map(|&value| Value::Int(value)).collect::<Vec<_>>(),
        );
        let count = columns * shape.buckets_in_column(charset);
        let buckets = record.tracks()[0].buckets(count, scans, now);
        wave_is.assert_eq(&format!("[{}]", wave(shape, charset, &buckets)));
    }

    const PULSES: [i64; 12] = [0, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0, 1];

    #[test]
    fn bits() {
        check(
            Shape::Bit,
            Charset::Unicode,
            &PULSES,
            1,
            12,
            8,
            expect![[r#"[  ⣀⣸⠉⢹⣸⣿]"#]],
        );
        check(
            Shape::Bit,
            Charset::Ascii,
            &PULSES,
            1,
            12,
            14,
            expect![[r#"[  ___----__-_-]"#]],
        );
        check(
            Shape::Bit,
            Charset::Ascii,
            &PULSES,
            2,
            12,
            7,
            expect![[r#"[ _|-|||]"#]],
        );
    }

    #[test]
    fn buckets_begin_at_whole_multiples() {
        check(
            Shape::Bit,
            Charset::Ascii,
            &[0, 0, 1, 1],
            2,
            5,
            3,
            expect![[r#"[_|-]"#]],
        );
    }

    #[test]
    fn numbers() {
        let ramp: Vec<i64> = (0..16).collect();
        check(
            Shape::Number,
            Charset::Unicode,
            &ramp,
            2,
            16,
            9,
            expect![[r#"[ ▁▂▃▄▅▆▇█]"#]],
        );
        check(
            Shape::Number,
            Charset::Ascii,
            &ramp,
            2,
            16,
            8,
            expect![[r#"[_.:-=+*#]"#]],
        );
        check(
            Shape::Number,
            Charset::Unicode,
            &[7; 3],
            1,
            3,
            3,
            expect![[r#"[▄▄▄]"#]],
        );
        check(
            Shape::Number,
            Charset::Unicode,
            &[0; 3],
            1,
            3,
            3,
            expect![[r#"[▁▁▁]"#]],
        );
    }
}
