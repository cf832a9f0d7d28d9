//! Names that Structured Text takes.

use ladder_notation::is_reserved_in_iec;
use std::collections::HashSet;

/// A name of its own for each thing. Case makes no difference.
#[derive(Debug, Clone, Default)]
pub(crate) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// A name like this one, which is free: neither another's nor a word of the language.
    pub(crate) fn name(&mut self, of: &str, kind: &str) -> String {
        let plain = identifier(of);
        let mut name = plain.clone();
        let mut number = 1;
        while !self.take(&name) {
            name = match number {
                1 => format!("{plain}_{kind}"),
                _ => format!("{plain}_{kind}{number}"),
            };
            number += 1;
        }
        name
    }

    /// The first of `base1`, `base2`, .. that is free.
    pub(crate) fn numbered(&mut self, base: &str) -> String {
        let base = identifier(base);
        let mut number = 1;
        loop {
            let name = format!("{base}{number}");
            if self.take(&name) {
                return name;
            }
            number += 1;
        }
    }

    fn take(&mut self, name: &str) -> bool {
        !is_reserved_in_iec(name) && self.used.insert(name.to_ascii_uppercase())
    }
}

/// The name of a member of a structure or block: one that is a word of the language has another.
pub(crate) fn member(of: &str) -> String {
    Names::default().name(of, "member")
}

/// Letters, digits and single `_`, not at the end: anything else becomes the number of the character, or goes.
pub(crate) fn identifier(of: &str) -> String {
    let mut name = String::new();
    for c in of.chars() {
        match c {
            '_' if name.ends_with('_') => {}
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => name.push(c),
            '.' | ' ' | '[' | ',' if !name.ends_with('_') && !name.is_empty() => name.push('_'),
            '.' | ' ' | '[' | ',' | ']' | '$' | '%' => {}
            '-' if name.ends_with('_') => name.push('m'),
            other => name.push_str(&format!("u{:04X}", u32::from(other))),
        }
    }
    let mut name = name.trim_end_matches('_').to_owned();
    if name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert(0, 'x');
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_language_and_letters_of_others_get_names() {
        let mut names = Names::default();
        let mut name = |of: &str| names.name(of, "tag");
        assert_eq!(name("step"), "step_tag");
        assert_eq!(name("motor"), "motor");
        assert_eq!(name("MOTOR"), "MOTOR_tag");
        assert_eq!(name("a__b_"), "a_b");
        assert_eq!(name("höhe"), "hu00F6he");
        assert_eq!(name("%IX0.3"), "IX0_3");
        assert_eq!(name("library.count"), "library_count");
        assert_eq!(name("zones[1, -2].watch[3]"), "zones_1_m2_watch_3");
        assert_eq!(names.numbered("rise"), "rise1");
        assert_eq!(names.numbered("rise"), "rise2");
    }
}
