//! Plain declarations: nearly all lines of declarations are a few names and the name of a type, `start, stop : BOOL;`. They
//! have one reading, without mistakes, and need no tree for it.
//!
//! What is recognized here is a part of what the tree says; in doubt it is not recognized.

use crate::types::{Scalar, Type};
use ladder_instructions::StateType;
use ladder_syntax::{Line, TextRange};
use smallvec::SmallVec;
use std::ops::Range;

/// A line with more names is read by its tree.
const MOST_NAMES: usize = 16;

/// The names and the type on a line.
#[derive(Debug, PartialEq)]
pub(crate) struct PlainDeclaration<'l> {
    /// As they are written. Places count from the start of the line.
    pub(crate) names: SmallVec<[(&'l str, TextRange); 4]>,
    pub(crate) ty: Type,
}

/// Reads a line, if it is a plain declaration without mistakes.
pub(crate) fn plain_declaration(line: &Line) -> Option<PlainDeclaration<'_>> {
    if !line.errors.is_empty() {
        return None;
    }
    read(line.text())
}

fn read(text: &str) -> Option<PlainDeclaration<'_>> {
    let mut names = SmallVec::new();
    let mut rest = blanks(text.as_bytes(), 0);
    loop {
        let name = word(text, rest)?;
        if names.len() == MOST_NAMES {
            return None;
        }
        let range = TextRange::new((name.start as u32).into(), (name.end as u32).into());
        rest = blanks(text.as_bytes(), name.end);
        names.push((&text[name], range));
        match text.as_bytes().get(rest)? {
            b',' => rest = blanks(text.as_bytes(), rest + 1),
            b':' => break,
            _ => return None,
        }
    }
    let of_type = word(text, blanks(text.as_bytes(), rest + 1))?;
    let behind = blanks(text.as_bytes(), of_type.end);
    let is_last = |rest: &str| rest.bytes().all(|byte| byte.is_ascii_whitespace());
    if !text.get(behind..)?.strip_prefix(';').is_some_and(is_last) {
        return None;
    }
    let of_type = &text[of_type];
    let state = || {
        let mut states = StateType::ALL.into_iter();
        states.find(|state| state.name().eq_ignore_ascii_case(of_type))
    };
    let ty = match Scalar::from_name(of_type) {
        Some(scalar) => Type::Scalar(scalar),
        None => Type::State(state()?),
    };
    Some(PlainDeclaration { names, ty })
}

/// Where the blanks end that begin here.
fn blanks(bytes: &[u8], at: usize) -> usize {
    let is_blank = |byte: &&u8| matches!(byte, b' ' | b'\t');
    at + bytes[at..].iter().take_while(is_blank).count()
}

/// The word that begins here, if there is one, of the letters that need no table.
fn word(text: &str, at: usize) -> Option<Range<usize>> {
    let bytes = text.as_bytes();
    let begins = bytes
        .get(at)
        .is_some_and(|b| b.is_ascii_alphabetic() || *b == b'_');
    let is_in = |byte: &&u8| byte.is_ascii_alphanumeric() || **byte == b'_';
    begins.then(|| at..at + bytes[at..].iter().take_while(is_in).count())
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::analyze;
    use std::sync::Arc;

    fn names(text: &str) -> Option<String> {
        let plain = read(text)?;
        for (name, range) in &plain.names {
            assert_eq!(&text[*range], *name);
        }
        let names: Vec<&str> = plain.names.iter().map(|(name, _)| *name).collect();
        Some(format!("{} {}", names.join(" "), plain.ty))
    }

    #[test]
    fn what_is_plain() {
        for (text, expected) in [
            ("    start, stop : BOOL;\n", "start stop BOOL"),
            ("a:int;", "a INT"),
            ("\t_b1 ,c\t: Ton ; \r\n", "_b1 c TON"),
        ] {
            assert_eq!(names(text).as_deref(), Some(expected), "{text}");
        }
    }

    #[test]
    fn what_is_read_by_its_tree() {
        for text in [
            "",
            "a",
            "a :",
            "a : BOOL",
            "a, : BOOL;",
            "a b : BOOL;",
            "1a : BOOL;",
            "ä : BOOL;",
            "aä : BOOL;",
            "a : BOOL := TRUE;",
            "a AT %IX0.0 : BOOL;",
            "a : ARRAY [0..3] OF INT;",
            "a : STRING[5];",
            "a : BOOLE;",
            "a : BOOL; # why #",
            "a : BOOL;; ",
            "a,\n b : BOOL;",
        ] {
            assert_eq!(names(text), None, "{text}");
        }
    }

    /// All that is declared and found, of lines that end so.
    fn declared(header: &str, end: &str) -> Vec<String> {
        let lines = [
            "a, b : BOOL;",
            "Timer : TON;",
            "s : string;",
            "at_noon : DATE_AND_TIME;",
            "A : INT;",
            "x, y, X : INT;",
            "y : INT;",
            "TRUE : BOOL;",
            "z, ton : BOOL;",
            "I1 : INT;",
        ];
        let lines: String = lines.map(|line| format!("  {line}{end}\n")).concat();
        let text = format!("{header}\n{lines}END_VAR\n");
        let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
        let tags = analysis.context.scopes[0].tags.iter();
        let tags = tags.map(|tag| {
            let place = (tag.declared_at.line, tag.declared_at.range, tag.mistyped);
            format!(
                "{} {:?} {:?} {:?} {} {} {place:?}",
                tag.name, tag.ty, tag.role, tag.origin, tag.retain, tag.constant
            )
        });
        let found = analysis.diagnostics().iter();
        tags.chain(found.map(|found| found.message.clone())).collect()
    }

    #[test]
    fn declares_what_the_tree_declares() {
        for header in ["VAR", "VAR_INPUT", "VAR RETAIN", "VAR CONSTANT", "VAR_GLOBAL"] {
            let plain = declared(header, "");
            assert!(plain.len() > 12, "{plain:#?}");
            assert_eq!(plain, declared(header, " # read by its tree #"), "{header}");
        }
    }
}
