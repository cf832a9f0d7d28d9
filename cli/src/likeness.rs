//! "Did you mean": the known name that a person probably wanted.

/// The candidate that fewest slips of the fingers lead to, if there is one near enough: a third of its letters
/// may differ, at least one. Capitals do not count.
pub(crate) fn closest<'a>(typed: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let typed = typed.to_lowercase();
    candidates
        .into_iter()
        .filter_map(|candidate| {
            let slips = strsim::damerau_levenshtein(&typed, &candidate.to_lowercase());
            let letters = typed.chars().count().max(candidate.chars().count());
            (slips <= (letters / 3).max(1) && slips < letters).then_some((slips, candidate))
        })
        .min_by_key(|(slips, _)| *slips)
        .map(|(_, candidate)| candidate)
}

/// `; did you mean "start"?`, or nothing, to end a message with.
pub(crate) fn did_you_mean<'a>(typed: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    match closest(typed, candidates) {
        Some(name) => format!("; did you mean `{name}`?"),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_forgiven_and_other_names_are_not() {
        let tags = ["start", "stop", "run", "t1"];
        for (typed, meant) in [
            ("strat", "start"),
            ("STOPP", "stop"),
            ("rum", "run"),
            ("t2", "t1"),
        ] {
            assert_eq!(closest(typed, tags), Some(meant), "{typed}");
        }
        for typed in ["pump", "x", "", "level"] {
            assert_eq!(closest(typed, tags), None, "{typed}");
        }
    }
}
