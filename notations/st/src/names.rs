//! Names that Structured Text takes.

use std::collections::HashSet;

/// Words that the standard, or a common system, keeps for itself: keywords, types, standard functions and blocks.
const TAKEN: &str = "ABS ABSTRACT ACOS ACTION ADD AND AND_THEN ANY ARRAY ASIN AT ATAN BOOL BY BYTE CAL CALC CASE CONCAT \
    CONFIGURATION CONSTANT CONTINUE COS CTD CTU CTUD DATE DATE_AND_TIME DELETE DINT DIV DO DT DWORD ELSE ELSIF EN \
    END_ACTION END_CASE END_CONFIGURATION END_FOR END_FUNCTION END_FUNCTION_BLOCK END_IF END_PROGRAM END_REPEAT END_RESOURCE \
    END_STEP END_STRUCT END_TRANSITION END_TYPE END_VAR END_WHILE ENO EQ EXIT EXP EXPT EXTENDS F_EDGE F_TRIG FALSE FIND \
    FOR FROM FUNCTION FUNCTION_BLOCK GE GT IF IMPLEMENTS INITIAL_STEP INSERT INT INTERFACE INTERVAL JMP LD LE LEFT LEN \
    LIMIT LINT LN LOG LREAL LT LTIME LWORD MAX METHOD MID MIN MOD MOVE MUL MUX NE NON_RETAIN NOT OF ON OR OR_ELSE OVERRIDE \
    POINTER PRIORITY PROGRAM PROPERTY R_EDGE R_TRIG READ_ONLY READ_WRITE REAL REF REF_TO REFERENCE \
    REPEAT REPLACE RESOURCE RET RETAIN RETURN RIGHT ROL ROR RS RTC SEL SEMA SHL SHR SIN SINGLE SINT SIZEOF SQRT SR ST \
    STEP STN STRING STRUCT SUB SUPER TAN TASK THEN THIS TIME TIME_OF_DAY TO TOD TOF TON TP TRANSITION TRUE TRUNC TYPE \
    UDINT UINT ULINT UNION UNTIL USINT VAR VAR_ACCESS VAR_CONFIG VAR_EXTERNAL VAR_GLOBAL VAR_IN_OUT VAR_INPUT VAR_INST \
    VAR_OUTPUT VAR_STAT VAR_TEMP WHILE WITH WORD WSTRING XOR";

/// A name of its own for each thing. Case makes no difference.
#[derive(Debug, Clone, Default)]
pub(crate) struct Names {
    used: HashSet<String>,
}

impl Names {
    /// Without the words that are taken.
    pub(crate) fn new() -> Names {
        Names {
            used: TAKEN.split_whitespace().map(str::to_owned).collect(),
        }
    }

    /// Of the members of a structure, which may be called as anything but keywords.
    pub(crate) fn name(&mut self, of: &str, kind: &str) -> String {
        let plain = identifier(of);
        let mut name = plain.clone();
        let mut number = 1;
        while !self.used.insert(name.to_ascii_uppercase()) {
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
            if self.used.insert(name.to_ascii_uppercase()) {
                return name;
            }
            number += 1;
        }
    }
}

/// The name of a member of a structure or block: one that is a word of the language has another.
pub(crate) fn member(of: &str) -> String {
    Names::new().name(of, "member")
}

/// Letters, digits and single `_`, not at the end: anything else becomes the number of the character, or goes.
pub(crate) fn identifier(of: &str) -> String {
    let mut name = String::new();
    for c in of.chars() {
        match c {
            '_' if name.ends_with('_') => {}
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => name.push(c),
            '.' | ' ' if !name.ends_with('_') && !name.is_empty() => name.push('_'),
            '.' | ' ' | '$' | '%' => {}
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
        let mut names = Names::new();
        let mut name = |of: &str| names.name(of, "tag");
        assert_eq!(name("step"), "step_tag");
        assert_eq!(name("motor"), "motor");
        assert_eq!(name("MOTOR"), "MOTOR_tag");
        assert_eq!(name("a__b_"), "a_b");
        assert_eq!(name("höhe"), "hu00F6he");
        assert_eq!(name("%IX0.3"), "IX0_3");
        assert_eq!(name("library.count"), "library_count");
        assert_eq!(names.numbered("rise"), "rise1");
        assert_eq!(names.numbered("rise"), "rise2");
    }
}
