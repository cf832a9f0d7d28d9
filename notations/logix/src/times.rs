//! Literals of times and dates: the controller counts microseconds, in its long types nanoseconds.

/// What a duration begins with, and how many nanoseconds its unit has.
const PREFIXES: &[(&str, i64)] = &[
    ("T32#", 1_000),
    ("TIME32#", 1_000),
    ("T#", 1_000),
    ("TIME#", 1_000),
    ("LT#", 1),
    ("LTIME#", 1),
];

/// The units of a duration, each with its nanoseconds; of two that begin alike the longer is first.
const UNITS: &[(&str, f64)] = &[
    ("ms", 1e6),
    ("us", 1e3),
    ("ns", 1.0),
    ("d", 86_400e9),
    ("h", 3_600e9),
    ("m", 60e9),
    ("s", 1e9),
];

fn split(text: &str) -> Option<(&str, i64)> {
    let found = PREFIXES.iter().find_map(|(prefix, unit)| {
        let start = text.get(..prefix.len())?;
        start
            .eq_ignore_ascii_case(prefix)
            .then_some((prefix.len(), *unit))
    });
    found.map(|(length, unit)| (&text[length..], unit))
}

/// Whether a duration begins here.
pub(crate) fn begins(text: &str) -> bool {
    split(text).is_some()
}

/// `T#1m_30s`, as the number that its type counts.
pub(crate) fn duration(text: &str) -> Option<i64> {
    let (mut rest, unit) = split(text)?;
    let mut whole = 0.0;
    if rest.is_empty() {
        return None;
    }
    while !rest.is_empty() {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let number: f64 = rest[..end].parse().ok()?;
        let after = rest[end..].to_ascii_lowercase();
        let (name, length) = UNITS.iter().find(|(name, _)| after.starts_with(name))?;
        whole += number * length;
        rest = rest[end + name.len()..].trim_start_matches('_');
    }
    Some((whole / unit as f64).round_ties_even() as i64)
}

/// `LDT#2026-01-31-12:30:00.25(UTC+00:00)` since the beginning of 1970, as its type counts it.
pub(crate) fn date(text: &str) -> Option<i64> {
    let (prefix, rest) = text.split_once('#')?;
    let unit = match prefix.to_ascii_uppercase().as_str() {
        "DT" => 1_000,
        "LDT" => 1,
        _ => return None,
    };
    let rest = rest.split('(').next()?.trim_end_matches('Z');
    let mut parts = rest.splitn(4, '-');
    let mut number = || parts.next()?.parse::<i64>().ok();
    let (year, month, day) = (number()?, number()?, number()?);
    let mut clock = parts.next().unwrap_or("0:0:0").splitn(3, ':');
    let mut number = || clock.next().unwrap_or("0").replace('_', "").parse::<f64>().ok();
    let (hour, minute, second) = (number()?, number()?, number()?);
    let is_date = (0..10_000).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    let is_clock =
        (0.0..24.0).contains(&hour) && (0.0..60.0).contains(&minute) && (0.0..61.0).contains(&second);
    if !is_date || !is_clock {
        return None;
    }
    let seconds = days(year, month, day) * 86_400 + (hour * 3_600.0 + minute * 60.0) as i64;
    // Nanoseconds do not reach to every year.
    let whole = seconds.checked_mul(1_000_000_000 / unit)?;
    whole.checked_add((second * 1e9 / unit as f64).round_ties_even() as i64)
}

/// The days from the beginning of 1970 to a date.
fn days(year: i64, month: i64, day: i64) -> i64 {
    // Years begin in March, so that the day that is not in every year is their last.
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year - era * 400;
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_and_dates() {
        assert_eq!(duration("T#1s_500ms"), Some(1_500_000));
        assert_eq!(duration("T32#2us"), Some(2));
        assert_eq!(duration("LT#1m1.5s"), Some(61_500_000_000));
        assert_eq!(duration("T#"), None);
        assert_eq!(duration("T#5"), None);
        assert_eq!(
            date("LDT#1970-01-02-00:00:00.000_000_001(UTC+00:00)"),
            Some(86_400_000_000_001)
        );
        assert_eq!(date("DT#2000-03-01-12:00:01.5Z"), Some(951_912_001_500_000));
        assert_eq!(date("DT#2000-13-01"), None);
        assert_eq!(date("LDT#9999-12-31-00:00:00"), None);
        assert_eq!(date("DT#2000-01-01-99999999999999999999:00:00"), None);
    }
}
