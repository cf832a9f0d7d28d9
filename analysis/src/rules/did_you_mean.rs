//! The nearest of some names to a misspelt one.

use ladder_syntax::Name;

/// The name that is nearest: at most two letters away, one for names of up to three letters.
pub(crate) fn closest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let wanted = Name::new(wanted);
    let limit = if wanted.as_str().chars().count() <= 3 {
        1
    } else {
        2
    };
    names
        .map(|name| {
            (
                strsim::osa_distance(wanted.as_str(), Name::new(name).as_str()),
                name,
            )
        })
        .filter(|(distance, _)| *distance <= limit)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
