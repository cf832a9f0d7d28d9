//! The intervals of tasks.

/// A duration such as `T#20ms`, in nanoseconds.
pub(super) fn nanoseconds(text: &str) -> Option<u64> {
    let rest = text.trim().to_ascii_lowercase();
    let rest = rest.split_once('#').map_or(rest.as_str(), |(_, rest)| rest);
    let mut total: f64 = 0.0;
    let mut rest = rest.replace('_', "");
    while !rest.is_empty() {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let number: f64 = rest[..end].parse().ok()?;
        let after = rest[end..].to_owned();
        let units = [
            ("ms", 1e6),
            ("us", 1e3),
            ("ns", 1.0),
            ("d", 864e11),
            ("h", 36e11),
            ("m", 6e10),
            ("s", 1e9),
        ];
        let (unit, size) = units.iter().find(|(unit, _)| after.starts_with(unit))?;
        total += number * size;
        after[unit.len()..].clone_into(&mut rest);
    }
    (total > 0.0 && total < 1e18).then_some(total as u64)
}

/// A scan's length as settings have it: `20ms`.
pub(super) fn interval(nanoseconds: u64) -> Option<String> {
    let units = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "us")];
    let (size, unit) = units
        .iter()
        .find(|(size, _)| nanoseconds.is_multiple_of(*size) && nanoseconds > 0)?;
    Some(format!("{}{unit}", nanoseconds / size))
}
