//! How the name of a proposal is like what a person has written of it.

/// Ways in which a name can be meant, the likeliest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Likeness {
    /// It is what is written.
    Whole,
    /// It begins so.
    Beginning,
    /// A word in it begins so: `pump_run` and `PumpRun` for `ru`.
    Word,
    /// It holds the letters next to each other.
    Inside,
    /// It holds the letters in their order.
    Scattered,
}

/// How a name is like what is written, whatever the case; none if it lacks a letter.
pub(super) fn likeness(name: &str, written: &str) -> Option<Likeness> {
    if begins(name, written) {
        let is_whole = begins(written, name);
        return Some(if is_whole {
            Likeness::Whole
        } else {
            Likeness::Beginning
        });
    }
    if !holds(name, written) {
        return None;
    }
    let mut found = Likeness::Scattered;
    let mut before = '_';
    for (at, letter) in name.char_indices() {
        if begins(&name[at..], written) {
            if !before.is_alphanumeric() || before.is_lowercase() && letter.is_uppercase() {
                return Some(Likeness::Word);
            }
            found = Likeness::Inside;
        }
        before = letter;
    }
    Some(found)
}

/// Whether a name begins as it is written.
fn begins(name: &str, written: &str) -> bool {
    // This is asked of each tag, and most differ in their first letter.
    let (letters, wanted) = (name.as_bytes(), written.as_bytes());
    if let (Some(letter), Some(wanted)) = (letters.first(), wanted.first())
        && letter.is_ascii()
        && wanted.is_ascii()
        && !letter.eq_ignore_ascii_case(wanted)
    {
        return false;
    }
    let start = letters.get(..wanted.len());
    if start.unwrap_or(letters).is_ascii() && wanted.is_ascii() {
        return start.is_some_and(|start| start.eq_ignore_ascii_case(wanted));
    }
    begins_in_any_script(name, written)
}

/// The same where letters of other scripts than the Latin one, or with accents, are compared.
fn begins_in_any_script(name: &str, written: &str) -> bool {
    name.to_lowercase().starts_with(&written.to_lowercase())
}

/// Whether a name has the letters that are written, in their order.
fn holds(name: &str, written: &str) -> bool {
    if name.is_ascii() && written.is_ascii() {
        let mut letters = name.bytes();
        let mut wanted = written.bytes();
        return wanted.all(|c| letters.any(|letter| letter.eq_ignore_ascii_case(&c)));
    }
    let mut letters = name.chars().flat_map(char::to_lowercase);
    let mut wanted = written.chars().flat_map(char::to_lowercase);
    wanted.all(|c| letters.any(|letter| letter == c))
}

#[cfg(test)]
mod tests {
    use super::{Likeness, begins, begins_in_any_script, likeness};

    #[test]
    fn words_of_a_name_count_for_more_than_its_letters() {
        for (name, written, expected) in [
            ("TON", "ton", Some(Likeness::Whole)),
            ("TONE", "ton", Some(Likeness::Beginning)),
            ("pump_tone", "ton", Some(Likeness::Word)),
            ("$Tone", "ton", Some(Likeness::Word)),
            ("PumpTone", "ton", Some(Likeness::Word)),
            ("Pumptone", "ton", Some(Likeness::Inside)),
            ("tap_on", "ton", Some(Likeness::Scattered)),
            ("RTO", "ton", None),
            ("größe", "Ö", Some(Likeness::Inside)),
            ("anything", "", Some(Likeness::Beginning)),
        ] {
            assert_eq!(likeness(name, written), expected, "{name} for {written}");
        }
    }

    #[test]
    fn the_first_letters_say_what_the_whole_name_says() {
        // The Kelvin sign is a k in lower case, and a capital sigma at the end of a word has a lower case of its own.
        let words = [
            "",
            "s",
            "S",
            "st",
            "START",
            "start_1",
            "stärt",
            "STÄ",
            "stÄrt_1",
            "sta",
            "ä",
            "Ä",
            "k",
            "\u{212a}",
            "\u{212a}alt",
            "kä",
            "KA",
            "σ",
            "Σ",
            "ας",
            "ΑΣ",
            "ΑΣΑ",
            "İ",
            "i",
            "ix",
            "aß",
            "aẞ",
        ];
        for prefix in words {
            for name in words {
                let expected = begins_in_any_script(name, prefix);
                assert_eq!(begins(name, prefix), expected, "{name} begins with {prefix}");
            }
        }
    }
}
