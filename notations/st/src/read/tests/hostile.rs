//! Texts that were made to break the reader: they are read, or refused with a reason, in time that grows with their length.

use crate::read::dialect::Dialect;
use crate::read::program::read;
use std::path::Path;

/// Reads a file in every dialect; what it becomes does not matter.
fn read_all(text: &str) {
    for dialect in [Dialect::Iec, Dialect::Logix, Dialect::Scl, Dialect::Codesys] {
        if let Ok(reading) = read(text, dialect, &[]) {
            assert!(
                !reading
                    .program
                    .write(&ladder_format::Options::default())
                    .text
                    .is_empty()
            );
        }
    }
}

fn program(body: &str) -> String {
    format!("PROGRAM Main VAR a : BOOL; i : INT; END_VAR\n{body}\nEND_PROGRAM\n")
}

#[test]
fn what_nests_deep() {
    for (open, close) in [
        ("IF a THEN ", "END_IF;"),
        ("i := (", ")"),
        ("i := -", ""),
        ("a := NOT ", ""),
        ("CASE i OF 1: ", "END_CASE;"),
        ("FOR i := 1 TO 3 DO ", "END_FOR;"),
        ("i := x[", "]"),
        ("i := ABS(", ")"),
        ("REPEAT ", ""),
        ("(* ", "*)"),
        ("a := a AND ", ""),
        ("i := i := ", ""),
    ] {
        for depth in [50, 5_000] {
            read_all(&program(&format!(
                "{}1{}",
                open.repeat(depth),
                close.repeat(depth)
            )));
        }
    }
    let depth = 5_000;
    read_all(&format!(
        "TYPE x : {}INT; END_TYPE",
        "ARRAY[1..2] OF ".repeat(depth)
    ));
    read_all(&format!("TYPE x : {}", "STRUCT a : ".repeat(depth)));
    read_all(&format!("VAR_GLOBAL a : INT := {}", "[".repeat(depth)));
}

#[test]
fn charts_that_are_long() {
    let mut steps = String::new();
    for step in 0..3_000 {
        steps +=
            &format!("STEP S{step}: a(N); END_STEP TRANSITION FROM S{step} TO S0 := a; END_TRANSITION\n");
    }
    read_all(&program(&format!("INITIAL_STEP I: END_STEP\n{steps}")));
    for part in [
        "STEP ",
        "STEP S: a(",
        "TRANSITION FROM (",
        "ACTION A: IF ",
        "INITIAL_STEP I: ",
    ] {
        read_all(&program(&part.repeat(5_000)));
    }
}

#[test]
fn what_is_long() {
    for part in [
        "i := i + 1;\n",
        "a ",
        "END_IF ",
        "1: ",
        "(* ",
        "{ ",
        "' ",
        "IF a THEN i := 1; ELSIF a THEN ",
        "i := ADR(i);",
        "#",
        "; ) ",
        "CASE i OF ",
        "a, ",
    ] {
        read_all(&program(&part.repeat(5_000)));
    }
    read_all(&program(&format!("a := {}TRUE;", "a OR ".repeat(20_000))));
    read_all(&program(&format!(
        "CASE i OF {}5: i := 1; END_CASE;",
        "1, ".repeat(5_000)
    )));
    read_all(&"FUNCTION_BLOCK a END_FUNCTION_BLOCK\n".repeat(500));
}

#[test]
fn programs_that_end_anywhere() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/structured-text");
    for name in ["iec_case", "iec_user_fb", "iec_numbers"] {
        let path = folder.join(name).join(format!("{name}.st"));
        let text = std::fs::read_to_string(path).expect("the corpus is there");
        for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
            let _ = read(&text[..end], Dialect::Iec, &[]);
            let _ = read(&format!("PROGRAM x {}", &text[end..]), Dialect::Codesys, &[]);
        }
    }
}
