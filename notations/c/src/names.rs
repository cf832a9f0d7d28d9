//! Names that C takes.

use std::collections::HashSet;

/// Words that C keeps for itself, and those that the library uses in its structures.
const TAKEN: [&str; 49] = [
    "auto",
    "bool",
    "break",
    "case",
    "char",
    "const",
    "continue",
    "default",
    "do",
    "double",
    "else",
    "enum",
    "extern",
    "false",
    "float",
    "for",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "register",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "struct",
    "switch",
    "true",
    "typedef",
    "union",
    "unsigned",
    "void",
    "volatile",
    "while",
    "asm",
    "class",
    "delete",
    "new",
    "private",
    "protected",
    "public",
    "template",
    "this",
    "virtual",
    "errno",
    "NULL",
];

/// Gives each thing a name of its own.
#[derive(Debug, Default)]
pub(crate) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// A name for what a program calls so.
    pub(crate) fn name(&mut self, of: &str) -> String {
        let mut name = identifier(of);
        while TAKEN.contains(&name.as_str()) || !self.used.insert(name.clone()) {
            name.push('_');
        }
        name
    }
}

/// What a library is called, from the name of its program: nothing that C, its callers or the runtime call something else.
pub(crate) fn library(program: &str) -> String {
    let name = identifier(program);
    let is_taken = TAKEN.contains(&name.as_str())
        || OWN.contains(&name.as_str())
        || crate::pieces::PIECES.named(&name).is_some();
    if is_taken { name + "_program" } else { name }
}

/// What every source has, or every program.
const OWN: [&str; 10] = [
    "main",
    "state",
    "frame_of",
    "note",
    "operands",
    "text_at",
    "text_room",
    "take_inputs",
    "show_inputs",
    "put_outputs",
];

/// Letters, digits and `_`; anything else becomes `_`, and letters of other alphabets their number.
pub(crate) fn identifier(of: &str) -> String {
    let mut name = String::new();
    for c in of.chars() {
        match c {
            'a'..='z' | 'A'..='Z' | '_' => name.push(c),
            '0'..='9' if !name.is_empty() => name.push(c),
            '0'..='9' => name.extend(['_', c]),
            _ if c.is_alphabetic() => name.push_str(&format!("u{:x}", c as u32)),
            // `cell[2].run` is `cell_2_run`.
            _ if name.ends_with('_') || name.is_empty() => {}
            _ => name.push('_'),
        }
    }
    let name = name.trim_end_matches('_');
    if name.is_empty() {
        "tag".into()
    } else {
        name.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_are_called_like_nothing_else() {
        let made = ["motor", "main", "int", "ton", "Left", "state"].map(library);
        let expected = [
            "motor",
            "main_program",
            "int_program",
            "ton_program",
            "Left_program",
            "state_program",
        ];
        assert_eq!(made, expected);
    }

    #[test]
    fn names_are_c_and_differ() {
        let mut names = Names::default();
        let made = ["start", "cell[2].run", "cell_2_run", "for", "3rd", "Größe", "$"];
        let made: Vec<String> = made.into_iter().map(|name| names.name(name)).collect();
        assert_eq!(
            made,
            [
                "start",
                "cell_2_run",
                "cell_2_run_",
                "for_",
                "_3rd",
                "Gru00f6u00dfe".replace("u00", "u").as_str(),
                "tag"
            ]
        );
    }
}
