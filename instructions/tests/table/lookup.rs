//! From a spelling to its row, or to the row that was probably meant.

use std::fmt::Write;

use expect_test::{Expect, expect};
use ladder_instructions::{Instruction, Op, Shape, TABLE, closest, in_other_shape, lookup};

fn ops(shape: Shape, spelling: &str) -> Vec<Op> {
    lookup(shape, spelling).map(|row| row.op).collect()
}

#[test]
fn every_spelling_finds_its_row_in_any_case() {
    for row in TABLE {
        for spelling in row.spellings() {
            for typed in [
                spelling.to_owned(),
                spelling.to_lowercase(),
                format!(" {spelling}\t"),
            ] {
                assert!(ops(row.shape, &typed).contains(&row.op), "{typed:?}");
            }
        }
    }
}

#[test]
fn a_blank_is_the_open_contact_or_the_coil() {
    for blank in ["", " ", " \t "] {
        assert_eq!(ops(Shape::Logical, blank), [Op::Contact]);
        assert_eq!(ops(Shape::Coil, blank), [Op::Coil]);
        assert_eq!(ops(Shape::Function, blank), []);
    }
}

#[test]
fn case_folds_as_in_the_rest_of_the_language() {
    assert_eq!(ops(Shape::Logical, "ſet"), [Op::Mov]);
    assert_eq!(ops(Shape::Logical, "PAC\u{212a}"), [Op::Pack]);
}

#[test]
fn not_has_two_rows() {
    assert_eq!(ops(Shape::Logical, "Not"), [Op::Inverter, Op::Not]);
}

#[test]
fn what_is_no_mnemonic_is_not_found() {
    for text in [
        "TO",
        "TONN",
        "T ON",
        "SCANTIMES",
        "\0TON",
        "É",
        "(",
        "ÀDD",
        "$B",
        "🦀",
    ] {
        assert_eq!(ops(Shape::Logical, text), [], "{text:?}");
    }
}

fn blocks<'a>(rows: impl IntoIterator<Item = &'a Instruction>) -> String {
    let blocks: Vec<_> = rows.into_iter().map(Instruction::signature).collect();
    if blocks.is_empty() {
        "nothing".to_owned()
    } else {
        blocks.join(" or ")
    }
}

fn typed(shape: Shape, text: &str) -> String {
    let (open, close) = shape.brackets();
    format!("{open}{text}{close}")
}

fn check(typos: &[(Shape, &str)], answer: impl Fn(Shape, &str) -> String, expected: &Expect) {
    let mut text = String::new();
    for &(shape, spelling) in typos {
        writeln!(text, "{} -> {}", typed(shape, spelling), answer(shape, spelling)).unwrap();
    }
    expected.assert_eq(&text);
}

#[test]
fn rows_in_other_brackets() {
    use Shape::*;
    check(
        &[
            (Logical, "R"),
            (Logical, "S"),
            (Logical, "SET"),
            (Logical, "RESET"),
            (Logical, "SM"),
            (Logical, "RES"),
            (Logical, "JMP"),
            (Logical, "OUT"),
            (Coil, "TON"),
            (Coil, "RET"),
            (Coil, "NOT"),
            (Coil, "SET"),
            (Function, "ton"),
            (Function, " "),
            (Function, "/"),
            (Function, "XIC"),
            (Logical, "TON"),
            (Logical, "XYZ"),
        ],
        |shape, text| blocks(in_other_shape(shape, text)),
        &expect![[r#"
            [R] -> (R)( tag )
            [S] -> (S)( tag )
            [SET] -> (S)( tag )
            [RESET] -> (R)( tag )
            [SM] -> (SM)( tag )
            [RES] -> (RES)( tag )
            [JMP] -> <JMP>( name )
            [OUT] -> ( )( tag )
            (TON) -> [TON]( t, PT, R := )
            (RET) -> <RET>
            (NOT) -> [NOT] or [NOT]( y, a )
            (SET) -> [MOV]( y, a )
            <ton> -> [TON]( t, PT, R := )
            < > -> [ ]( tag ) or ( )( tag )
            </> -> [/]( tag ) or (/)( tag )
            <XIC> -> [ ]( tag )
            [TON] -> nothing
            [XYZ] -> nothing
        "#]],
    );
}

#[test]
fn nearest_spellings() {
    use Shape::*;
    check(
        &[
            (Logical, "TNO"),
            (Logical, "TOM"),
            (Logical, "CTDU"),
            (Logical, "GTR"),
            (Logical, "GREATER"),
            (Logical, "MOEV"),
            (Logical, "ADDD"),
            (Logical, "LIMT"),
            (Logical, "SERACH"),
            (Logical, "R_TRG"),
            (Logical, "SCANTIM"),
            (Logical, "X"),
            (Logical, "QQQ"),
            (Logical, ""),
            (Logical, "a_very_long_name_of_something"),
            (Logical, "XIC"),
            (Logical, "CAL"),
            (Logical, "CALLS"),
            (Logical, "NXET"),
            (Logical, "COPY"),
            (Coil, "SS"),
            (Coil, "SET"),
            (Coil, "RST"),
            (Coil, "OTE"),
            (Function, "JUMP"),
            (Function, "CAL"),
            (Function, "GOTO"),
            (Function, "RETURN"),
            (Function, "NEX"),
        ],
        |shape, text| closest(shape, text).map_or_else(|| "nothing".to_owned(), Instruction::signature),
        &expect![[r#"
            [TNO] -> [TON]( t, PT, R := )
            [TOM] -> [TON]( t, PT, R := )
            [CTDU] -> [CTU]( c, PV, R := )
            [GTR] -> [GT]( a, b, ... )
            [GREATER] -> nothing
            [MOEV] -> [MOV]( y, a )
            [ADDD] -> [ADD]( y, a, b, ... )
            [LIMT] -> [LIMIT]( y, low, a, high )
            [SERACH] -> [SEARCH]( y, op, a, t, NEXT :=, FOUND => )
            [R_TRG] -> [OSR]
            [SCANTIM] -> [SCANTIME]( y )
            [X] -> nothing
            [QQQ] -> nothing
            [] -> nothing
            [a_very_long_name_of_something] -> nothing
            [XIC] -> [ ]( tag )
            [CAL] -> [CALC]( y, expression )
            [CALLS] -> <CALL>( name )
            [NXET] -> <NEXT>
            [COPY] -> [BMOV]( y, a )
            (SS) -> (S)( tag )
            (SET) -> (S)( tag )
            (RST) -> (R)( tag )
            (OTE) -> ( )( tag )
            <JUMP> -> <JMP>( name )
            <CAL> -> <CALL>( name )
            <GOTO> -> <JMP>( name )
            <RETURN> -> <RET>
            <NEX> -> <NEXT>
        "#]],
    );
}
