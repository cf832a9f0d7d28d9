//! Values as they are next to the diagram: short.

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text;

/// A value for a narrow place. A TIME is in its largest unit with one decimal, so that it does not jump about
/// while it runs.
pub(super) fn short(value: &Value, ty: Scalar) -> String {
    match (value, ty) {
        (Value::Int(nanoseconds), Scalar::Time) => time(*nanoseconds),
        _ => value_text::display(value, ty),
    }
}

/// `250ms`, `1.2s`, `3m05s`, `2h07m`
fn time(nanoseconds: i64) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let all = nanoseconds.unsigned_abs();
    let milliseconds = all / 1_000_000;
    let seconds = milliseconds / 1000;
    let text = match seconds {
        0 if milliseconds == 0 && all > 0 => format!("{}us", all / 1000),
        0 if milliseconds == 0 => "0s".to_owned(),
        0 => format!("{milliseconds}ms"),
        1..60 => {
            let tenths = milliseconds / 100;
            format!("{}.{}s", tenths / 10, tenths % 10)
        }
        60..3600 => format!("{}m{:02}s", seconds / 60, seconds % 60),
        _ => format!("{}h{:02}m", seconds / 3600, seconds / 60 % 60),
    };
    format!("{sign}{text}")
}

/// A time that was chosen, such as a preset: whole, without the prefix.
pub(super) fn goal(value: &Value, ty: Scalar) -> String {
    let text = value_text::display(value, ty);
    match text.strip_prefix("T#") {
        Some(duration) => duration.to_owned(),
        None => text,
    }
}

/// The clock of the simulation: `12.34 s`, `3:05.20`, `2:07:30`.
pub(super) fn clock(nanoseconds: i64) -> String {
    let milliseconds = nanoseconds.max(0) / 1_000_000;
    let (minutes, rest) = (milliseconds / 60_000, milliseconds % 60_000);
    let seconds = format!("{:02}.{:02}", rest / 1000, rest % 1000 / 10);
    match minutes {
        0 => format!("{}.{:02} s", rest / 1000, rest % 1000 / 10),
        1..60 => format!("{minutes}:{seconds}"),
        _ => format!("{}:{:02}:{seconds}", minutes / 60, minutes % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times() {
        for (milliseconds, shown) in [
            (0.0, "0s"),
            (0.25, "250us"),
            (250.0, "250ms"),
            (999.9, "999ms"),
            (1000.0, "1.0s"),
            (1290.0, "1.2s"),
            (59_999.0, "59.9s"),
            (65_000.0, "1m05s"),
            (3_600_000.0, "1h00m"),
            (-1500.0, "-1.5s"),
        ] {
            assert_eq!(time((milliseconds * 1e6) as i64), shown);
        }
    }

    #[test]
    fn clocks() {
        for (milliseconds, shown) in [
            (0, "0.00 s"),
            (12_345, "12.34 s"),
            (185_200, "3:05.20"),
            (7_650_000, "2:07:30.00"),
        ] {
            assert_eq!(clock(milliseconds * 1_000_000), shown);
        }
    }
}
