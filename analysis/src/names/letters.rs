//! Which letters a name has: most names that cannot be meant by what somebody writes are told apart by that alone.

/// The letters, digits and underscores in a name, upper and lower case alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Letters(u64);

impl Letters {
    /// Those of a name. One with other letters than those of ASCII may have them in several forms: it counts as if it had all.
    pub(crate) fn of(name: &str) -> Letters {
        Letters(bits(name).unwrap_or(u64::MAX))
    }

    /// Those that a name must have to hold all that is written. Nothing is asked for other letters than those of ASCII.
    pub fn asked_by(written: &str) -> Letters {
        Letters(bits(written).unwrap_or(0))
    }

    /// Whether all of these are among them.
    pub(crate) fn have(self, asked: Letters) -> bool {
        asked.0 & !self.0 == 0
    }
}

/// What stands for the letters of a text; none if it has others than those of ASCII.
fn bits(text: &str) -> Option<u64> {
    text.is_ascii()
        .then(|| text.bytes().map(bit).fold(0, |all, bit| all | bit))
}

/// What stands for a letter. Nothing does for signs: they are never asked for.
fn bit(byte: u8) -> u64 {
    let number = match byte {
        b'a'..=b'z' => byte - b'a',
        b'A'..=b'Z' => byte - b'A',
        b'0'..=b'9' => 26 + byte - b'0',
        b'_' => 36,
        _ => return 0,
    };
    1 << number
}

#[cfg(test)]
mod tests {
    use super::Letters;

    #[test]
    fn a_name_that_holds_what_is_written_has_its_letters() {
        let may_hold = |name: &str, written: &str| Letters::of(name).have(Letters::asked_by(written));
        for (name, written) in [
            ("Start_12", ""),
            ("Start_12", "start"),
            ("Start_12", "ST21"),
            ("%IX0.3", "%ix0"),
            ("Größe", "gr"),
            // The Kelvin sign is a k in lower case.
            ("\u{212a}1", "k1"),
            ("k1", "\u{212a}1"),
        ] {
            assert!(may_hold(name, written), "{name} {written}");
        }
        for (name, written) in [
            ("Start_12", "stop"),
            ("Start_12", "start3"),
            ("start", "_"),
            ("", "a"),
        ] {
            assert!(!may_hold(name, written), "{name} {written}");
        }
    }
}
