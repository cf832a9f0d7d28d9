//! Literals of all types.

use super::dice::Dice;
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar};

/// Every elementary type.
pub(super) const SCALARS: [Scalar; 20] = [
    Scalar::Bool,
    Scalar::Byte,
    Scalar::Word,
    Scalar::Dword,
    Scalar::Lword,
    Scalar::Sint,
    Scalar::Int,
    Scalar::Dint,
    Scalar::Lint,
    Scalar::Usint,
    Scalar::Uint,
    Scalar::Udint,
    Scalar::Ulint,
    Scalar::Real,
    Scalar::Lreal,
    Scalar::Time,
    Scalar::Date,
    Scalar::Tod,
    Scalar::Dt,
    Scalar::String(DEFAULT_STRING),
];

/// A literal that fits a type.
pub(super) fn literal(dice: &mut Dice, ty: Scalar) -> String {
    match ty {
        Scalar::Bool => dice.of(&["TRUE", "FALSE", "true", "1", "BOOL#0"]).to_owned(),
        Scalar::Real | Scalar::Lreal => {
            let plain = [
                "0.0", "1.0", "-2.5", "3.25", "1.0e-3", "0.1", "1_000.5", "-1.0E2", "7", "-3",
            ];
            match dice.below(8) {
                0 => format!("{}#1.5", ty.name()),
                _ => dice.of(&plain).to_owned(),
            }
        }
        Scalar::Time => {
            let times = [
                "T#5s",
                "5s",
                "T#1h30m",
                "250ms",
                "TIME#-250ms",
                "T#1.5s",
                "0s",
                "10ms",
                "T#30ms",
                "T#2d_4h",
            ];
            dice.of(&times).to_owned()
        }
        Scalar::Date => dice
            .of(&["D#2026-11-21", "DATE#1999-12-31", "D#2024-02-29"])
            .to_owned(),
        Scalar::Tod => dice
            .of(&["TOD#13:45:00.5", "TIME_OF_DAY#00:00:00", "TOD#23:59:59"])
            .to_owned(),
        Scalar::Dt => dice
            .of(&["DT#2026-11-21-13:45:00", "DATE_AND_TIME#2000-01-01-00:00:00"])
            .to_owned(),
        Scalar::String(_) => dice
            .of(&[
                "'text'",
                "''",
                "'it$'s'",
                "'12'",
                "'-7.5'",
                "'a$$b$41'",
                "'öl # 1'",
            ])
            .to_owned(),
        _ => integer(dice, ty),
    }
}

fn integer(dice: &mut Dice, ty: Scalar) -> String {
    let (least, most) = ty.bounds().expect("an integer or bit string has bounds");
    let most = i64::try_from(most).unwrap_or(i64::MAX);
    let least = i64::try_from(least).unwrap_or(i64::MIN);
    let number = match dice.below(6) {
        0 => least,
        1 => most,
        2 => dice.between(least, most),
        _ => dice.between(least.max(-3), most.min(20)),
    };
    match dice.below(8) {
        0 if number >= 0 => format!("16#{number:X}"),
        1 if number >= 0 => format!("2#{number:b}"),
        2 if number >= 0 => format!("8#{number:o}"),
        3 => format!("{}#{number}", ty.name()),
        _ => number.to_string(),
    }
}
