//! A tag's past as a row of characters.

use super::theme::Charset;
use ladder_simulator::chart::{Kind, Level, Mark, Track, Window};

/// The past of a tag in this many columns of `scans` each, up to the scan that is done now; the newest column is the last. Columns
/// begin at whole multiples of their length, so that the picture does not flicker while it moves. Texts have none.
pub(super) fn wave(track: &Track, columns: usize, scans: u64, now: u64, charset: Charset) -> String {
    match (track.kind(), charset) {
        (Kind::Bit, Charset::Unicode) => braille(track, columns, scans, now),
        (Kind::Bit, Charset::Ascii) => {
            let marks = marks(track, columns, scans, now).into_iter();
            let drawn = marks.map(|mark| match level(mark.as_ref()) {
                None => ' ',
                Some(Level::Low) => '_',
                Some(Level::High) => '-',
                Some(Level::Both) => '|',
            });
            drawn.collect()
        }
        (Kind::Number, charset) => {
            let steps = match charset {
                Charset::Unicode => &['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'],
                Charset::Ascii => &['_', '.', ':', '-', '=', '+', '*', '#'],
            };
            bars(&marks(track, columns, scans, now), steps)
        }
        (Kind::Text, _) => String::new(),
    }
}

/// What is drawn in each of the columns; nothing where nothing is known.
fn marks(track: &Track, columns: usize, per: u64, now: u64) -> Vec<Option<Mark>> {
    if track.first().is_none_or(|first| now < first) {
        return vec![None; columns];
    }
    let newest = now / per;
    let back = |column: usize| newest.checked_sub((columns - 1 - column) as u64);
    let window = Window {
        first: (newest.saturating_sub(columns as u64) * per).max(1),
        last: now,
        per,
    };
    // One that is listed is drawn up to the next.
    let drawn = track.columns(&window, 0, now);
    let at = |column: u64| {
        let after = drawn.partition_point(|drawn| drawn.number <= column);
        drawn.get(after.checked_sub(1)?).map(|drawn| drawn.mark.clone())
    };
    (0..columns).map(|column| at(back(column)?)).collect()
}

fn level(mark: Option<&Mark>) -> Option<Level> {
    match mark {
        Some(Mark::Bit(level)) => Some(*level),
        _ => None,
    }
}

/// Two marks a column. Dots of a column from top to bottom: 1 2 4 40, of its right half 8 10 20 80.
fn braille(track: &Track, columns: usize, scans: u64, now: u64) -> String {
    let marks = if scans.is_multiple_of(2) {
        // The newest column may be half full: then its other half is not there yet.
        let half = scans / 2;
        let is_half = (now / half).is_multiple_of(2);
        let mut marks = marks(track, 2 * columns - usize::from(is_half), half, now);
        marks.extend(is_half.then_some(None));
        marks
    } else {
        // One scan fills a whole column.
        let marks = marks(track, columns, scans, now).into_iter();
        marks.flat_map(|mark| [mark.clone(), mark]).collect()
    };
    let mut before = None;
    let mut dots = marks.iter().map(|mark| {
        let level = level(mark.as_ref());
        let edge = matches!(
            (before, level),
            (Some(Level::Low), Some(Level::High)) | (Some(Level::High), Some(Level::Low))
        );
        before = level;
        match level {
            None => (0, 0),
            Some(Level::Both) => (0x47, 0xb8),
            Some(_) if edge => (0x47, 0xb8),
            Some(Level::High) => (0x01, 0x08),
            Some(Level::Low) => (0x40, 0x80),
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

fn bars(marks: &[Option<Mark>], steps: &[char; 8]) -> String {
    let known = || {
        marks.iter().flatten().filter_map(|mark| match mark {
            Mark::Number { least, greatest, .. } => Some((*least, *greatest)),
            Mark::Bit(_) | Mark::Text(_) => None,
        })
    };
    let least = known().map(|(least, _)| least).fold(f64::INFINITY, f64::min);
    let greatest = known()
        .map(|(_, greatest)| greatest)
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
    let bar = |mark: &Option<Mark>| match mark {
        Some(Mark::Number { last, .. }) => steps[height(*last).min(7)],
        _ => ' ',
    };
    marks.iter().map(bar).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};
    use ladder_analysis::values::value::Value;
    use ladder_simulator::chart::Recorder;
    use ladder_simulator::{HistoryLimits, Options, Session};

    /// The wave of a tag that held these values in the last of this many scans.
    fn check(charset: Charset, tag: &str, values: &[i64], scans: u64, now: u64, columns: usize, is: Expect) {
        let text = "VAR  bit : BOOL; number : INT;  END_VAR\n";
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad");
        let program = analysis.program().cloned().unwrap();
        let mut session = Session::new(program, Options::default(), HistoryLimits::default()).unwrap();
        let point = session.simulation().resolve(tag).unwrap();
        for _ in values.len() as u64..now {
            session.run_scan();
        }
        let mut recorder = Recorder::default();
        let mut known = false;
        for &value in values {
            let value = if tag == "bit" {
                Value::Bool(value == 1)
            } else {
                Value::Int(value)
            };
            session.set(&point, value).unwrap();
            session.run_scan();
            if !std::mem::replace(&mut known, true) {
                recorder.watch(vec![point.clone()], &session);
            }
            recorder.look(&session);
        }
        is.assert_eq(&format!(
            "[{}]",
            wave(&recorder.tracks()[0], columns, scans, now, charset)
        ));
    }

    const PULSES: [i64; 12] = [0, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0, 1];

    #[test]
    fn bits() {
        check(Charset::Unicode, "bit", &PULSES, 1, 12, 8, expect!["[⠉⠉⠉⣇⣀⡏⣇⡏]"]);
        check(
            Charset::Ascii,
            "bit",
            &PULSES,
            1,
            12,
            14,
            expect![[r#"[  ___----__-_-]"#]],
        );
        check(Charset::Ascii, "bit", &PULSES, 2, 12, 7, expect!["[__--_|-]"]);
    }

    #[test]
    fn buckets_begin_at_whole_multiples() {
        check(Charset::Ascii, "bit", &[0, 0, 1, 1], 2, 5, 3, expect!["[__-]"]);
    }

    #[test]
    fn numbers() {
        let ramp: Vec<i64> = (0..16).collect();
        check(
            Charset::Unicode,
            "number",
            &ramp,
            2,
            16,
            9,
            expect!["[▁▂▃▄▅▆▇██]"],
        );
        check(Charset::Ascii, "number", &ramp, 2, 16, 8, expect!["[.:-=+*##]"]);
        check(
            Charset::Unicode,
            "number",
            &[7; 3],
            1,
            3,
            3,
            expect![[r#"[▄▄▄]"#]],
        );
        check(
            Charset::Unicode,
            "number",
            &[0; 3],
            1,
            3,
            3,
            expect![[r#"[▁▁▁]"#]],
        );
    }
}
