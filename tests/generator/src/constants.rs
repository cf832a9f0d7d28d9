//! The constants of generated programs. The values that go into their runs are chosen around them.

use ladder_analysis::values::types::Scalar;

/// The literals of a type, by its name.
pub fn literals(ty: &str) -> &'static [&'static str] {
    match ty {
        "REAL" | "LREAL" => &["2.5", "-1.0", "100.0"],
        "TIME" => &["T#30ms", "T#0ms", "T#5s"],
        "DATE" => &["D#2026-11-21"],
        "TOD" => &["TOD#06:00:00"],
        "DT" => &["DT#2026-11-21-06:00:00"],
        "Phase" => &["Phase.IDLE", "Phase.RUNNING"],
        "STRING" => &["'ab'", "''"],
        "SINT" | "INT" | "DINT" | "LINT" => &["0", "1", "3", "7", "100", "-2"],
        _ => &["0", "1", "3", "7", "100"],
    }
}

/// The numbers among them, and the times, as the simulator holds them.
pub fn numbers(ty: Scalar) -> &'static [i64] {
    match ty {
        Scalar::Time => &[0, 30_000_000, 5_000_000_000],
        _ => &[0, 1, 3, 7, 100, -2],
    }
}
