//! What passes between types without `[TYP]`: the paragraph of LANGUAGE §5.2, pair by pair.

use crate::support::get;
use expect_test::expect;
use ladder_analysis::{Severity, analyze};
use ladder_simulator::{Options, Simulation};
use std::collections::BTreeSet;
use std::sync::Arc;

const TYPES: [&str; 20] = [
    "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
    "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT", "STRING",
];

/// "a value passes along these chains", as the paragraph has them.
const CHAINS: &[&str] = &[
    "SINT INT DINT LINT",
    "USINT UINT UDINT ULINT",
    "USINT INT",
    "UINT DINT",
    "UDINT LINT",
    "SINT REAL LREAL",
    "INT REAL LREAL",
    "USINT REAL LREAL",
    "UINT REAL LREAL",
    "DINT LREAL",
    "UDINT LREAL",
    "BYTE WORD DWORD LWORD",
];

/// "a bit string to and from the integers of its width": one step, which no chain goes on from.
const SAME_WIDTH: &[[&str; 3]] = &[
    ["BYTE", "SINT", "USINT"],
    ["WORD", "INT", "UINT"],
    ["DWORD", "DINT", "UDINT"],
    ["LWORD", "LINT", "ULINT"],
];

fn passes(from: &str, to: &str) -> bool {
    let mut reached = BTreeSet::from([from]);
    loop {
        let before = reached.len();
        for chain in CHAINS {
            let names: Vec<&str> = chain.split(' ').collect();
            for pair in names.windows(2) {
                if reached.contains(pair[0]) {
                    reached.insert(pair[1]);
                }
            }
        }
        if reached.len() == before {
            break;
        }
    }
    let width = SAME_WIDTH.iter().any(|[bits, signed, unsigned]| {
        let integers = [signed, unsigned];
        (from == *bits && integers.contains(&&to)) || (to == *bits && integers.contains(&&from))
    });
    reached.contains(to) || width
}

/// The simulation of a rung, or None if it is a `type-mismatch` and nothing else.
fn program(declarations: &str, rung: &str) -> Option<Simulation> {
    let text = format!("VAR\n{declarations}\nok : BOOL;\nEND_VAR\n{rung}\n");
    let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "table.clad");
    let errors: Vec<_> = analysis
        .diagnostics()
        .iter()
        .filter(|found| found.severity == Severity::Error)
        .collect();
    if let Some(program) = analysis.program() {
        return Some(Simulation::new(Arc::clone(program), Options::default()).unwrap());
    }
    assert!(
        errors.iter().all(|found| found.rule.name() == "type-mismatch"),
        "{text}: {errors:?}"
    );
    None
}

/// Values of a type at its borders, as they are written, with their number where they are one.
fn borders(ty: &str) -> Vec<(String, Option<i128>)> {
    let numbers = |numbers: &[i128]| numbers.iter().map(|n| (n.to_string(), Some(*n))).collect();
    let unsigned = |bits: u32| numbers(&[0, 1, (1 << (bits - 1)) - 1, 1 << (bits - 1), (1 << bits) - 1]);
    let signed = |bits: u32| numbers(&[-(1 << (bits - 1)), -1, 0, 1, (1 << (bits - 1)) - 1]);
    let texts = |texts: &[&str]| texts.iter().map(|text| ((*text).to_owned(), None)).collect();
    match ty {
        "BOOL" => texts(&["FALSE", "TRUE"]),
        "BYTE" | "USINT" => unsigned(8),
        "WORD" | "UINT" => unsigned(16),
        "DWORD" | "UDINT" => unsigned(32),
        "LWORD" | "ULINT" => unsigned(64),
        "SINT" => signed(8),
        "INT" => signed(16),
        "DINT" => signed(32),
        "LINT" => signed(64),
        "REAL" | "LREAL" => texts(&["0.0", "-1.5", "16777216.0"]),
        "TIME" => texts(&["T#0s", "T#-1ns", "T#1d2h"]),
        "DATE" => texts(&["D#1970-01-01", "D#2026-11-21"]),
        "TOD" => texts(&["TOD#00:00:00", "TOD#23:59:59.999"]),
        "DT" => texts(&["DT#2026-11-21-13:45:00"]),
        "STRING" => texts(&["''", "'a$'b'"]),
        _ => unreachable!("{ty}"),
    }
}

fn width(ty: &str) -> u32 {
    SAME_WIDTH
        .iter()
        .position(|types| types.contains(&ty))
        .map_or(0, |row| 8 << row)
}

/// What a number is in another type: the same number, or between a bit string and an integer the same bits.
fn in_type(number: i128, to: &str) -> String {
    if matches!(to, "REAL" | "LREAL") {
        return format!("{:?}", number as f64);
    }
    let bits = width(to);
    let kept = number.rem_euclid(1 << bits);
    let signed = matches!(to, "SINT" | "INT" | "DINT" | "LINT");
    if signed && kept >= 1 << (bits - 1) {
        return (kept - (1 << bits)).to_string();
    }
    kept.to_string()
}

#[test]
fn every_pair_of_types() {
    let mut passed = 0;
    for from in TYPES {
        for to in TYPES {
            for (value, number) in borders(from) {
                let declarations = format!("a : {from} := {value}; y : {to}; b : {from} := {value};");
                let simulation = program(&declarations, "+--[MOV]( y, a )--( )( ok )--+");
                assert_eq!(simulation.is_some(), passes(from, to), "{from} to {to}");
                let Some(mut simulation) = simulation else { break };
                assert!(simulation.scan());
                let expected = match number {
                    Some(number) => in_type(number, to),
                    None => get(&simulation, "b"),
                };
                assert_eq!(get(&simulation, "y"), expected, "{from} {value} to {to}");
                assert_eq!(get(&simulation, "ok"), "1");
                passed += 1;
            }
        }
    }
    assert!(passed > 250, "{passed} values passed");
}

#[test]
fn a_word_of_ones_is_minus_one() {
    let mut simulation = program("w : WORD := 16#FFFF; i : INT;", "+--[MOV]( i, w )--( )( ok )--+").unwrap();
    simulation.scan();
    assert_eq!(get(&simulation, "i"), "-1");
}

const INTEGERS: [&str; 8] = ["SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT"];

#[test]
fn integers_of_any_two_types_compare_by_value() {
    for a in INTEGERS {
        for b in INTEGERS {
            for (x, left) in borders(a) {
                for (y, right) in borders(b) {
                    let declarations =
                        format!("a : {a} := {x}; b : {b} := {y}; eq, ne, lt, le, gt, ge : BOOL;");
                    let rung = ["EQ", "NE", "LT", "LE", "GT", "GE"]
                        .map(|op| format!("+--[{op}]( a, b )--( )( {} )--+", op.to_lowercase()));
                    let mut simulation = program(&declarations, &rung.join("\n")).unwrap();
                    simulation.scan();
                    let found = ["eq", "ne", "lt", "le", "gt", "ge"].map(|tag| get(&simulation, tag) == "1");
                    let expected = [
                        left == right,
                        left != right,
                        left < right,
                        left <= right,
                        left > right,
                        left >= right,
                    ];
                    assert_eq!(found, expected, "{a} {x} with {b} {y}");
                }
            }
        }
    }
}

#[test]
fn other_comparisons_are_made_where_one_type_of_the_chains_holds_both() {
    for a in TYPES {
        for b in TYPES {
            let integers = INTEGERS.contains(&a) && INTEGERS.contains(&b);
            let holds = integers || TYPES.iter().any(|ty| passes(a, ty) && passes(b, ty));
            let declarations = format!("a : {a}; b : {b};");
            let equal = program(&declarations, "+--[EQ]( a, b )--( )( ok )--+");
            assert_eq!(equal.is_some(), holds, "{a} = {b}");
            let less = program(&declarations, "+--[LT]( a, b )--( )( ok )--+");
            assert_eq!(less.is_some(), holds && a != "BOOL", "{a} < {b}");
        }
    }
}

#[test]
fn an_untyped_literal_takes_the_other_sides_type() {
    // 16777217 is not a REAL: as one it is 16777216.
    let mut simulation = program(
        "r : REAL := 16777216; d : DINT := 16777216; e, f : BOOL;",
        "+--[EQ]( r, 16777217 )--( )( e )--+\n+--[EQ]( d, 16777217 )--( )( f )--+",
    )
    .unwrap();
    simulation.scan();
    assert_eq!(
        (get(&simulation, "e"), get(&simulation, "f")),
        ("1".into(), "0".into())
    );
}

/// For each instruction the types that it takes, all its operands being of one.
#[test]
fn what_each_instruction_takes() {
    let mut table = String::new();
    for (instruction, operands) in [
        ("MOV", "y, a"),
        ("SEL", "y, g, a, b"),
        ("MUX", "y, n, a, b"),
        ("LUT", "y, n, a, b"),
        ("BMOV", "l[1..2], m[1..2]"),
        ("FILL", "l[1..2], a"),
        ("SHIFT", "l[1..2], a"),
        ("ADD", "y, a, b"),
        ("SUB", "y, a, b"),
        ("MUL", "y, a, b"),
        ("DIV", "y, a, b"),
        ("MOD", "y, a, b"),
        ("EXP", "y, a, b"),
        ("NEG", "y, a"),
        ("ABS", "y, a"),
        ("MIN", "y, a, b"),
        ("LIMIT", "y, a, b, a"),
        ("TRUNC", "y, a"),
        ("SQRT", "y, a"),
        ("AND", "y, a, b"),
        ("NOT", "y, a"),
        ("SHL", "y, a, n"),
        ("ROR", "y, a, n"),
        ("CONCAT", "y, a, b"),
    ] {
        let takes = |ty: &&&str| {
            let declarations = format!("a, b, y : {ty}; l, m : ARRAY[1..2] OF {ty}; n : INT; g : BOOL;");
            program(
                &declarations,
                &format!("+--[{instruction}]( {operands} )--( )( ok )--+"),
            )
            .is_some()
        };
        let types: Vec<&str> = TYPES.iter().filter(takes).copied().collect();
        let types = match types.len() {
            20 => "all".to_owned(),
            _ => types.join(" "),
        };
        table.push_str(&format!("{instruction}: {types}\n"));
    }
    expect![[r#"
        MOV: all
        SEL: all
        MUX: all
        LUT: all
        BMOV: all
        FILL: all
        SHIFT: all
        ADD: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME
        SUB: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME
        MUL: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        DIV: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        MOD: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        EXP: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        NEG: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        ABS: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        MIN: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME
        LIMIT: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME
        TRUNC: SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL
        SQRT: REAL LREAL
        AND: BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT
        NOT: BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT
        SHL: BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT
        ROR: BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT
        CONCAT: STRING
    "#]]
    .assert_eq(&table);
}

/// Which mixtures of times, dates and numbers each operator takes, and in which type the result is.
#[test]
fn times_and_dates() {
    let mut table = String::new();
    for op in ["ADD", "SUB", "MUL", "DIV", "MOD"] {
        for y in ["TIME", "DATE", "TOD", "DT", "INT"] {
            for a in ["TIME", "DATE", "TOD", "DT", "INT", "REAL"] {
                for b in ["TIME", "DATE", "TOD", "DT", "INT", "LREAL"] {
                    let declarations = format!("y : {y}; a : {a}; b : {b};");
                    let integers = y == "INT" && a == "INT" && b == "INT";
                    let rung = format!("+--[{op}]( y, a, b )--( )( ok )--+");
                    if !integers && program(&declarations, &rung).is_some() {
                        table.push_str(&format!("{op}: {y} from {a}, {b}\n"));
                    }
                }
            }
        }
    }
    expect![[r#"
        ADD: TIME from TIME, TIME
        ADD: DT from DT, TIME
        SUB: TIME from TIME, TIME
        SUB: TIME from TOD, TOD
        SUB: TIME from DT, DT
        MUL: TIME from TIME, INT
        MUL: TIME from TIME, LREAL
        MUL: TIME from INT, TIME
        MUL: TIME from REAL, TIME
        DIV: TIME from TIME, INT
        DIV: TIME from TIME, LREAL
    "#]]
    .assert_eq(&table);
}

#[test]
fn all_operands_are_brought_to_the_results_type() {
    // In SINT 100 + 100 would wrap; in INT it does not.
    let mut simulation = program(
        "y : INT; a, b : SINT := 100; z : LREAL; i : DINT := 16777217; u : UINT;",
        "+--[ADD]( y, a, b )--[DIV]( z, i, 2 )--[SHL]( u, 1, a )--( )( ok )--+",
    )
    .unwrap();
    simulation.scan();
    let values = ["y", "z", "u", "ok"].map(|tag| get(&simulation, tag));
    assert_eq!(values, ["200", "8388608.5", "0", "1"]);
    // A wider operand does not pass to the result.
    assert!(program("y : INT; a : DINT;", "+--[ADD]( y, a, 1 )--( )( ok )--+").is_none());
}

#[test]
fn counts_selectors_and_indices_are_any_integer_and_take_no_part() {
    for ty in TYPES {
        let declarations = format!("n : {ty}; y : BYTE; z : SINT; a : ARRAY[0..3] OF SINT;");
        for rung in [
            "+--[SHL]( y, y, n )--( )( ok )--+",
            "+--[MUX]( z, n, 1, 2 )--( )( ok )--+",
            "+--[MOV]( z, a[n] )--( )( ok )--+",
        ] {
            assert_eq!(
                program(&declarations, rung).is_some(),
                INTEGERS.contains(&ty),
                "{ty} in {rung}"
            );
        }
    }
}

#[test]
fn an_integer_wraps_in_the_results_width() {
    for ty in INTEGERS {
        let (low, high) = (borders(ty)[0].1.unwrap(), borders(ty)[4].1.unwrap());
        let declarations = format!("y, z : {ty}; a : {ty} := {high}; b : {ty} := {low};");
        let rung = "+--[ADD]( y, a, 1 )--[SUB]( z, b, 1 )--( )( ok )--+";
        let mut simulation = program(&declarations, rung).unwrap();
        simulation.scan();
        assert_eq!(get(&simulation, "y"), low.to_string(), "{ty}");
        assert_eq!(get(&simulation, "z"), high.to_string(), "{ty}");
    }
}
