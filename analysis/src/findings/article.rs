//! The article before a name in a message: "an INT", "a DINT".

use std::fmt::Display;

/// A noun with "a" or "an" before it, as it is spoken: `an INT`, `a UINT`, `an LREAL`, `an 8-bit`. Brackets and quotes
/// in front of it do not matter.
pub fn with_article(noun: impl Display) -> String {
    let noun = noun.to_string();
    let article = if begins_with_a_vowel(noun.trim_start_matches(|c: char| !c.is_alphanumeric())) {
        "an"
    } else {
        "a"
    };
    format!("{article} {noun}")
}

/// Whether the first sound is a vowel.
fn begins_with_a_vowel(noun: &str) -> bool {
    let mut letters = noun.chars();
    let (first, second) = (letters.next(), letters.next());
    match (first, second) {
        (Some('8'), _) => true,
        // Eleven and eighteen, but not 110 or 1800.
        (Some('1'), Some('1' | '8')) => !letters.next().is_some_and(|third| third.is_ascii_digit()),
        (Some('a' | 'e' | 'i' | 'o' | 'A' | 'E' | 'I' | 'O'), _) => true,
        (Some('u'), _) => !["uni", "use", "usu"].iter().any(|you| noun.starts_with(you)),
        (Some(first), Some(second)) => is_spelled(first, second),
        _ => false,
    }
}

/// Whether capitals are read letter by letter, and the name of the first one (ar, ess, em) begins with a vowel: no word
/// begins with RT, SR or LW.
fn is_spelled(first: char, second: char) -> bool {
    let consonant = second.is_ascii_uppercase() && !matches!(second, 'A' | 'E' | 'I' | 'O' | 'U');
    match first {
        'F' => consonant && !matches!(second, 'L' | 'R'),
        'S' => consonant && !matches!(second, 'C' | 'H' | 'K' | 'L' | 'M' | 'N' | 'P' | 'T' | 'W'),
        // The L of LREAL is a letter, though REAL is a word.
        'L' | 'M' | 'N' | 'R' | 'X' => consonant,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::with_article;

    #[test]
    fn as_one_speaks() {
        for noun in [
            "an INT",
            "a DINT",
            "a SINT",
            "a LINT",
            "a UINT",
            "a USINT",
            "a UDINT",
            "a ULINT",
            "a REAL",
            "an LREAL",
            "a BOOL",
            "a BYTE",
            "a WORD",
            "a DWORD",
            "an LWORD",
            "a TIME",
            "a DATE",
            "a TOD",
            "a DT",
            "a STRING[8]",
            "an ARRAY[1..3] OF INT",
            "a TON",
            "a TOF",
            "a TP",
            "an RTO",
            "an RTOF",
            "a CTU",
            "a CTD",
            "a CTUD",
            "a CTC",
            "an SR",
            "an RS",
            "an [ADD]",
            "a `[SUB]`",
            "an <MCR>",
            "a <RET>",
            "an 8-bit",
            "an 11",
            "a 110",
            "a 1",
            "an 18",
            "a 21",
            "an unused label",
            "a unit",
            "an output",
            "a timer",
            "a user-defined block",
            "an input",
        ] {
            let (_, bare) = noun.split_once(' ').unwrap();
            assert_eq!(with_article(bare), noun);
        }
        assert_eq!(with_article(""), "a ");
    }
}
