//! Names that C takes.

use crate::pieces::PIECES;
use std::collections::HashSet;
use std::sync::LazyLock;

/// The words of C and C++.
const KEYWORDS: &str = include_str!("reserved/keywords.txt");

/// Macros without parameters, and constants, of the headers of C17 and POSIX: wherever one of these words stands, it is replaced.
const MACROS: &str = include_str!("reserved/macros.txt");

/// The functions, types and variables of those headers, and those that the GNU library has with them.
const NAMES: &str = include_str!("reserved/names.txt");

fn words(lists: &[&'static str]) -> HashSet<&'static str> {
    lists.iter().flat_map(|list| list.split_whitespace()).collect()
}

/// What nothing can be called, not even a member of a structure.
static REPLACED: LazyLock<HashSet<&str>> = LazyLock::new(|| words(&[KEYWORDS, MACROS]));

/// What nothing outside of structures can be called.
static TAKEN: LazyLock<HashSet<&str>> = LazyLock::new(|| words(&[KEYWORDS, MACROS, NAMES]));

/// The words of the runtime, and of what is written around it.
static OWN: LazyLock<HashSet<String>> = LazyLock::new(|| {
    let runtime = PIECES.all();
    let code = runtime.split("*/").filter_map(|piece| piece.split("/*").next());
    let is_in_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words = code.flat_map(|code| code.split(|c: char| !is_in_word(c)));
    words
        .chain(AROUND.split_whitespace())
        .map(str::to_owned)
        .collect()
});

/// Names each thing, no two alike.
#[derive(Debug, Default)]
pub(crate) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// Those of a library's members: none is a macro of its header.
    pub(crate) fn of_members(library: &str) -> Names {
        let upper = library.to_ascii_uppercase();
        Names {
            used: [format!("{upper}_H"), format!("{upper}_RETAINED")].into(),
        }
    }

    /// Those of a library's constants: none is called as something else in its header.
    pub(crate) fn of_constants(library: &str) -> Names {
        let mut names = Names::of_members(library);
        names.used.extend(derived(library));
        names
    }

    /// A name for what a program calls so.
    pub(crate) fn name(&mut self, of: &str) -> String {
        let mut name = identifier(of);
        while REPLACED.contains(name.as_str()) || !self.used.insert(name.clone()) {
            name.push('_');
        }
        name
    }
}

/// What a library is called, from the name of its program: nothing that C, its callers or the runtime call something else.
pub(crate) fn library(program: &str) -> String {
    let name = identifier(program);
    // `FAULT_RANGE` and `TYPE_REAL` are the runtime's.
    let is_own = OWN.contains(&name) || ["fault", "type"].contains(&name.to_ascii_lowercase().as_str());
    if is_own || derived(&name).iter().any(|name| TAKEN.contains(name.as_str())) {
        name + "_program"
    } else {
        name
    }
}

/// The names that a library makes of its own.
fn derived(library: &str) -> [String; 7] {
    ["", "_inputs", "_outputs", "_init", "_scan", "_save", "_restore"].map(|end| format!("{library}{end}"))
}

/// The words around the runtime.
const AROUND: &str = "main state self now then bytes value bits at n b w s o frame_of back rail body after left turn noted note loops loop \
    fault line faults fault_line faulted operands text_at text_room first_words first_bits take_inputs show_inputs put_outputs \
    put_word take_word done stopped depth frame held turns exact in out ended scans began user receive send analog pulse length \
    chars none channel duty frequency byte";

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
    let is_reserved = |rest: &str| rest.starts_with(|c: char| c == '_' || c.is_ascii_uppercase());
    match name.strip_prefix('_') {
        _ if name.is_empty() => "tag".into(),
        // C keeps these for itself.
        Some(rest) if is_reserved(rest) => format!("tag{name}"),
        _ => name.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_are_called_like_nothing_else() {
        assert_eq!(library("motor"), "motor");
        // Words of C, of its library and POSIX (`sem_init`), of the runtime, and the beginnings of its constants.
        for taken in [
            "main", "int", "class", "printf", "time", "sem", "index", "ton", "Left", "state", "self",
            "Fault", "type",
        ] {
            assert_eq!(library(taken), format!("{taken}_program"));
        }
    }

    #[test]
    fn the_runtime_is_not_called_as_the_library_of_c_is() {
        let marks = PIECES.names();
        let clash: Vec<&str> = marks.filter(|name| TAKEN.contains(name)).collect();
        assert_eq!(clash, [""; 0]);
    }

    #[test]
    fn members_are_no_macros() {
        let mut names = Names::of_members("motor");
        let made = [
            "MOTOR_H",
            "MOTOR_RETAINED",
            "EOF",
            "errno",
            "linux",
            "_Bool",
            "__FILE__",
            "time",
            "or",
        ];
        let made = made.map(|name| names.name(name));
        let expected = [
            "MOTOR_H_",
            "MOTOR_RETAINED_",
            "EOF_",
            "errno_",
            "linux_",
            "tag_Bool",
            "tag__FILE",
            "time",
            "or_",
        ];
        assert_eq!(made, expected);
        assert_eq!(Names::of_constants("MOTOR").name("MOTOR_init"), "MOTOR_init_");
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
