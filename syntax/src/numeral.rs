//! Numbers in sentences.

/// `1st`, `2nd`, `3rd`, `11th`: counted from 1.
pub fn nth(number: usize) -> String {
    let suffix = match (number % 100, number % 10) {
        (11..=13, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    format!("{number}{suffix}")
}

/// `1 file`, `2 files`: of things whose name takes an `s`.
pub fn counted(count: usize, one: &str) -> String {
    format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinals() {
        let spelled: Vec<String> = [1, 2, 3, 4, 11, 12, 13, 21, 111, 122].map(nth).to_vec();
        assert_eq!(
            spelled,
            [
                "1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "111th", "122nd"
            ]
        );
    }

    #[test]
    fn one_has_no_s() {
        assert_eq!(
            [0, 1, 2].map(|count| counted(count, "file")),
            ["0 files", "1 file", "2 files"]
        );
    }
}
