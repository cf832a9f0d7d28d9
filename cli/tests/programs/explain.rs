//! `ladder explain`

use crate::harness::Folder;
use expect_test::expect;

#[test]
fn the_page_of_an_instruction() {
    let folder = Folder::with(&[]);
    expect![[r#"
        exit status 0
        -- stdout
        [SEL]( y, g, a, b )  Select one of two

        Puts one of two values into y: a while g is low, b while g is high.

        Any elementary type will do; both values are brought to y's type. IEC 61131-3: SEL.

        Operands
          y  out     The result.
          g  in      The switch: low takes a, high takes b.
          a  in      The value while g is low.
          b  in      The value while g is high.

        Power out
          EN, low on a fault

        Acts
          only while power enters it

        Example
          VAR_INPUT
              fast : BOOL;
          END_VAR
          VAR_OUTPUT
              speed : INT;
          END_VAR

          +--------[SEL]( speed, fast, 10, 50 )--+
    "#]]
    .assert_eq(&folder.ladder(&["explain", "[SEL]"]).to_string());
}

#[test]
fn brackets_are_understood_and_told_apart() {
    let folder = Folder::with(&[]);
    let first_line = |name: &str| {
        let run = folder.ladder(&["explain", name]);
        run.stdout.lines().next().unwrap_or_default().to_owned()
    };
    expect![[r#"
        [TON]( t, PT, R := )  On-delay timer
        (S)( tag )  Set coil
        [ ]( tag )  Open contact
        ( )( tag )  Coil
        <JMP>( name )  Jump
        [EQ]( a, b, ... )  Equal"#]]
    .assert_eq(
        &["ton", "( S )", "[ ]", "()", "<jmp>( name )", "EQU"]
            .map(first_line)
            .join("\n"),
    );
}

#[test]
fn every_row_with_the_name_is_shown() {
    let run = Folder::with(&[]).ladder(&["explain", "NOT"]);
    assert!(
        run.stdout.contains("Inverter") && run.stdout.contains("Bitwise not"),
        "{run}"
    );
}

#[test]
fn the_page_of_a_rule() {
    let folder = Folder::with(&[]);
    let page = folder.ladder(&["explain", "double-coil"]).to_string();
    assert!(
        page.starts_with("exit status 0\n-- stdout\ndouble-coil\n\nA tag is written"),
        "{page}"
    );
    for heading in ["Wrong", "Right", "What to do"] {
        assert!(page.contains(&format!("\n\n{heading}\n\n")), "{page}");
    }
    assert_eq!(folder.ladder(&["explain", "Double_Coil"]).to_string(), page);
}

#[test]
fn an_unknown_name_is_refused_with_what_was_meant() {
    let folder = Folder::with(&[]);
    let explain = |name: &str| folder.ladder(&["explain", name]);
    explain("TOM")
        .refused_with("no rule or instruction is called `TOM`; did you mean `[TON]` (on-delay timer)?");
    explain("XIC").refused_with("no rule or instruction is called `XIC`; did you mean `[ ]` (open contact)?");
    explain("duoble-coil")
        .refused_with("no rule or instruction is called `duoble-coil`; did you mean `double-coil`?");
    explain("blubber").refused_with("no rule or instruction is called `blubber`");
    explain("").refused_with("no rule or instruction is called ``");
}
