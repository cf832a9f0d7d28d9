//! The words that begin and end sections and block definitions, also where they are misspelt.

const KEYWORDS: [&str; 11] = [
    "VAR",
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR_GLOBAL",
    "VAR_EXTERNAL",
    "END_VAR",
    "FUNCTION_BLOCK",
    "END_FUNCTION_BLOCK",
    "END_TYPE",
    "END_STRUCT",
];

/// The keyword that a word is, is one letter away from, or begins or ends with.
pub(crate) fn nearest(word: &str) -> Option<&'static str> {
    let longest = KEYWORDS.iter().map(|keyword| keyword.len()).max().unwrap_or(0);
    if word.len() < 2 || word.len() > 2 * longest {
        return None;
    }
    let word = word.to_ascii_uppercase();
    let alike = |keyword: &&&str| {
        let apart = keyword.len().abs_diff(word.len());
        apart <= 1 && keyword.len() > 3 && strsim::osa_distance(keyword, &word) <= 1
    };
    // `xVAR_INPUT` where a line end is missing, `VAR_INPUTstart` where a blank is.
    let glued = |keyword: &&&str| word.starts_with(**keyword) || word.ends_with(**keyword);
    let exact = KEYWORDS.iter().find(|keyword| ***keyword == word);
    exact
        .or_else(|| KEYWORDS.iter().find(alike))
        .or_else(|| KEYWORDS.iter().filter(glued).max_by_key(|keyword| keyword.len()))
        .copied()
}

/// The keyword that a word is one letter away from.
pub(crate) fn misspelt(word: &str) -> Option<&'static str> {
    nearest(word).filter(|keyword| keyword.len().abs_diff(word.len()) <= 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_keywords() {
        for (word, expected) in [
            ("var_input", Some("VAR_INPUT")),
            ("AR_INPUT", Some("VAR_INPUT")),
            ("END_AR", Some("END_VAR")),
            ("xVAR_INPUT", Some("VAR_INPUT")),
            ("VAR_INPUTstart", Some("VAR_INPUT")),
            ("UNCTION_BLOCK", Some("FUNCTION_BLOCK")),
            ("start", None),
            ("a", None),
        ] {
            assert_eq!(nearest(word), expected, "{word}");
        }
    }
}
