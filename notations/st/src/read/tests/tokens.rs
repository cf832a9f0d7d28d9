//! The tokens of a text.

use crate::read::dialect::Dialect;
use crate::read::token::{TokenKind, tokens};
use expect_test::{Expect, expect};

fn check_tokens(text: &str, dialect: Dialect, expected: &Expect) {
    let shown = tokens(text, dialect)
        .tokens
        .into_iter()
        .filter(|token| token.kind != TokenKind::End);
    let shown: Vec<String> = shown
        .map(|token| format!("{:?} {}", token.kind, &text[token.span]))
        .collect();
    expected.assert_eq(&(shown.join("\n") + "\n"));
}

#[test]
fn literals_are_one_token() {
    check_tokens(
        "T#-1.5s INT#16#7F D#2026-11-29 1..5 1.5e-3 16#F_F a.3.1 REAL#1.0e-3 INT#1..3 Phase#IDLE %IX0.0 w.%X3",
        Dialect::Iec,
        &expect![[r#"
            Typed T#-1.5s
            Typed INT#16#7F
            Typed D#2026-11-29
            Integer 1
            Sign("..") ..
            Integer 5
            Real 1.5e-3
            Integer 16#F_F
            Word a
            Sign(".") .
            Integer 3
            Sign(".") .
            Integer 1
            Typed REAL#1.0e-3
            Typed INT#1
            Sign("..") ..
            Integer 3
            Typed Phase#IDLE
            Address %IX0.0
            Word w
            Sign(".") .
            Address %X3
        "#]],
    );
}

#[test]
fn comments_nest_where_they_do() {
    check_tokens(
        "a (* x (* y *) z *) b // c\n d /* e */ f",
        Dialect::Iec,
        &expect![[r#"
        Word a
        Word b
        Word d
        Word f
    "#]],
    );
    check_tokens(
        "a (* x (* y *) b",
        Dialect::Logix,
        &expect![[r#"
        Word a
        Word b
    "#]],
    );
    check_tokens(
        "a (* x (* y *) b",
        Dialect::Iec,
        &expect![[r#"
        Word a
        Word b
    "#]],
    );
    check_tokens(
        "#region odd 'name\na [:=] 1; #endregion",
        Dialect::Logix,
        &expect![[r#"
        Word a
        Sign("[:=]") [:=]
        Integer 1
        Sign(";") ;
    "#]],
    );
    check_tokens(
        "REGION it's\n#a.\"odd name\" := \"Global\"; END_REGION",
        Dialect::Scl,
        &expect![[r#"
        Name #a
        Sign(".") .
        Name "odd name"
        Sign(":=") :=
        Name "Global"
        Sign(";") ;
    "#]],
    );
    check_tokens(
        "{attribute 'x'} x {IF defined(b)} 'it$'s' \"w\" '",
        Dialect::Codesys,
        &expect![[r#"
        Word x
        Pragma {IF defined(b)}
        Text 'it$'s'
        Text "w"
        Stray '
    "#]],
    );
}
