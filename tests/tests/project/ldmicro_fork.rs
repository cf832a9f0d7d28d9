//! Programs with what only LDmicro's fork has, run here. The traces are computed from what is documented of the
//! elements, scan by scan; they are not measured on LDmicro.

use ladder_analysis::analyze;
use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options, Simulation};
use std::sync::Arc;

/// A program of the fork, whose rungs are given by their elements.
fn program(rungs: &[&str]) -> Arc<Program> {
    let mut file =
        "LDmicro0.2\nCYCLE=10000 us at Timer1\n\nIO LIST\n  Xa at 1 0 0\n  Xb at 2 0 0\nEND\n\nPROGRAM\n"
            .to_owned();
    for (index, rung) in rungs.iter().enumerate() {
        file.push_str(&format!("RUNG {}\n{rung}\nEND\n", index + 1));
    }
    let notation = by_name("ldmicro").expect("the notation is registered");
    let source = Source::alone("test", file.as_bytes());
    let converted = convert(notation, &source, &ladder_format::Options::default());
    let text = converted.expect("it is a program").written.text;
    let analysis = analyze(&ladder_syntax::parse(&text).into(), "test.clad");
    let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
    assert!(errors.is_empty(), "{errors:?}\n{text}");
    Arc::clone(analysis.program().expect("it has no errors"))
}

/// What is seen of a value in each scan, with the input high in the scans that a diagram shows so.
fn trace(rungs: &[&str], input: &str, seen: &[&str]) -> Vec<Vec<i64>> {
    let program = program(rungs);
    let mut traces = Vec::new();
    // In both of the simulator's codes.
    for in_steps in [false, true] {
        let mut simulation = Simulation::new(Arc::clone(&program), Options::default()).expect("it runs");
        let point = |simulation: &Simulation, name: &str| simulation.resolve(name).expect("it is there");
        let mut rows = vec![Vec::new(); seen.len()];
        for level in input.chars() {
            let xa = point(&simulation, "Xa");
            simulation
                .set(&xa, Value::Bool(level == '-'))
                .expect("it is an input");
            let ran = if in_steps {
                simulation.begin_scan() && simulation.finish_scan()
            } else {
                simulation.scan()
            };
            assert!(ran, "{:?}", simulation.take_faults());
            for (row, name) in rows.iter_mut().zip(seen) {
                row.push(match simulation.value(&point(&simulation, name)) {
                    Value::Bool(high) => i64::from(high),
                    Value::Int(number) => number,
                    other => panic!("{name} is {other:?}"),
                });
            }
        }
        traces.push(rows);
    }
    assert_eq!(traces[0], traces[1], "both codes do the same");
    traces.remove(0)
}

fn diagram(row: &[i64]) -> String {
    row.iter()
        .map(|level| if *level == 0 { '_' } else { '-' })
        .collect()
}

/// Elements with power for one scan after the other, the power after them, and their variable. A cycle has 10 ms.
const TRACES: &[(&str, &str, &str, &str)] = &[
    (
        "TON Ta 20000 0",
        "_----_---_",
        "___--___-_",
        "0 1 2 2 2 0 1 2 2 0",
    ),
    (
        "TON Ta 20000 -1",
        "_----_---_",
        "__---__--_",
        "0 1 1 1 1 0 1 1 1 0",
    ),
    (
        "TON Ta 20000 1",
        "_----_----_",
        "____-____-_",
        "0 1 2 3 3 0 1 2 3 3 0",
    ),
    (
        "TOF Ta 20000 0",
        "_--___-______",
        "_----_---____",
        "2 0 0 1 2 2 0 1 2 2 2 2 2",
    ),
    (
        "RTO Ta 20000 0",
        "_-_--__-__",
        "____------",
        "0 1 1 2 2 2 2 2 2 2",
    ),
    (
        "RTL Ta 20000 0",
        "-_-__-_--_",
        "____------",
        "0 1 1 2 2 2 2 2 2 2",
    ),
    (
        "TCY Ta 20000 0",
        "_----------_-----",
        "___---___--_--___",
        "0 1 2 0 1 2 0 1 2 0 1 0 1 2 0 1 2",
    ),
    (
        "THI Ta 20000 0",
        "_-____----_-_",
        "_--___--___--",
        "0 1 2 0 0 0 1 2 2 2 0 1 2",
    ),
    (
        "TLO Ta 20000 0",
        "__--____---_---_",
        "__--__-----__--_",
        "0 0 0 0 1 2 2 2 0 0 0 1 2 0 0 1",
    ),
    (
        "OSL",
        "__--___-_--___",
        "__--_---_--_--",
        "0 0 0 0 0 0 0 0 0 0 0 0 0 0",
    ),
    ("ODR", "__--__-_--", "--_---_-_-", "0 0 0 0 0 0 0 0 0 0"),
    ("OSC", "_-----_--_", "_-_-_-_-__", "0 0 0 0 0 0 0 0 0 0"),
    (
        "COIL Ya 0 0 0 1",
        "_--_-__--_",
        "_--_-__--_",
        "0 1 1 1 0 0 0 1 1 1",
    ),
    (
        "CTU Ca 2 0 /",
        "_-_-_--_-_-",
        "___--------",
        "0 1 1 2 2 2 2 2 2 2 2",
    ),
    ("CTU Ca 2 0 \\", "_-_-_--_-_", "____------", "0 0 1 1 2 2 2 2 2 2"),
    ("CTU Ca 2 0 -", "_--_---", "__-----", "0 1 2 2 2 2 2"),
    ("CTU Ca 2 0 o", "-_--_-__", "____----", "0 1 1 1 2 2 2 2"),
    ("CTD Ca 1 3 /", "_-_-_-_-_-", "---_______", "3 2 2 1 1 1 1 1 1 1"),
    ("CTD Ca 1 3 \\", "_-_-_-_-_-", "----______", "3 3 2 2 1 1 1 1 1 1"),
    ("CTD Ca 1 3 -", "_--_--", "--____", "3 2 1 1 1 1"),
    ("CTD Ca 1 3 o", "-_--_-", "----__", "3 2 2 2 1 1"),
    (
        "CTC Ca 2 0 /",
        "_-_-_-_-_-_--_",
        "_____-_____-__",
        "0 1 1 2 2 0 0 1 1 2 2 0 0 0",
    ),
    (
        "CTC Ca 3 1 \\",
        "_-_-_-_-_-_",
        "______-____",
        "1 1 2 2 3 3 1 1 2 2 3",
    ),
    ("CTC Ca 2 1 -", "_-----_-", "__-_-__-", "1 2 1 2 1 2 2 1"),
    ("CTC Ca 2 1 o", "-_____-_", "__-_-__-", "1 2 1 2 1 2 2 1"),
    (
        "CTR Ca 0 2 /",
        "_-_-_-_-_-_--",
        "_____-_____-_",
        "2 1 1 0 0 2 2 1 1 0 0 2 2",
    ),
    (
        "CTR Ca 1 3 \\",
        "_-_-_-_-_-_",
        "______-____",
        "3 3 2 2 1 1 3 3 2 2 1",
    ),
    ("CTR Ca -1 1 -", "_------", "___-__-", "1 0 -1 1 0 -1 1"),
    ("CTR Ca 0 2 o", "-______", "___-__-", "2 1 0 2 1 0 2"),
];

#[test]
fn timers_counters_and_edges() {
    for (element, input, output, counts) in TRACES {
        let name = element.split(' ').nth(1).filter(|_| !element.starts_with("OS"));
        let shown = match name {
            None => "Yo".to_owned(),
            Some(name)
                if element.starts_with("TON") || element.starts_with("TOF") || element.starts_with("RTO") =>
            {
                format!("{name}.ET")
            }
            Some(name) => name.to_owned(),
        };
        let rung = format!("CONTACTS Xa 0 0\n{element}\nCOIL Yo 0 0 0 0");
        let rows = trace(&[&rung], input, &["Yo", &shown]);
        assert_eq!(diagram(&rows[0]), *output, "{element}: power");
        if name.is_some() {
            let shown: Vec<String> = rows[1].iter().map(i64::to_string).collect();
            assert_eq!(shown.join(" "), *counts, "{element}: its variable");
        }
    }
}

/// Elements on `m`, its value, and what `n` is then.
const RESULTS: &[(&str, i64, i64)] = &[
    ("MOD n m 7", 20, 6),
    ("MOD n m 7", -20, -6),
    ("AND n m 12", 10, 8),
    ("OR n m 12", 10, 14),
    ("XOR n m 12", 10, 6),
    ("NOT n m", 5, -6),
    ("NEG n m", 5, -5),
    ("NEG n m", -32_768, -32_768),
    ("SHL n m 3", 3, 24),
    ("SHL n m 1", 16_384, -32_768),
    ("SR0 n m 1", -2, 32_767),
    ("SHR n m 1", -7, -4),
    ("SHR n m 2", 20, 5),
    ("ROL n m 4", 0x1234, 0x2341),
    ("ROR n m 4", 0x1234, 0x4123),
    ("BIN2BCD n m", 34, 0x0304),
    ("BIN2BCD n m", 1234, 0x0304),
    ("BCD2BIN n m", 0x0304, 34),
    ("BCD2BIN n m", 0x0909, 99),
    ("SET_BIT n m", 3, 8),
    ("SET_BIT n m", 15, -32_768),
    ("SET_BIT n m", 16, 0),
    ("MOVE n -1\nCLEAR_BIT n m", 4, -17),
    ("IF_BIT_SET m m\nMOVE n 7", 0, 0),
    ("IF_BIT_SET m m\nMOVE n 7", 2, 0),
    ("IF_BIT_CLEAR m m\nMOVE n 7", 2, 7),
    ("MOVE k 1\nIF_BIT_SET m k\nMOVE n 7", 2, 7),
    ("SWAP n m", 0x1234, 0x3412),
    ("SWAP n m", 0x00FF, -256),
    ("OPPOSITE n m", 1, -32_768),
    ("OPPOSITE n m", -2, 32_767),
    ("OPPOSITE n m", 0x1234, 0x2C48),
    ("TIME2COUNT n 50000 0", 0, 5),
    ("TIME2COUNT n 59999 2", 0, 7),
    ("7SEGMENTS n m C", 8, 0x7F),
    ("7SEGMENTS n m C", 16, 0xBF),
    ("7SEGMENTS n m C", 65, 0x77),
    ("7SEGMENTS n m C", 176, 0x63),
    ("7SEGMENTS n m C", 129, 0),
    ("7SEGMENTS n m A", 8, !0x7F),
    ("7SEGMENTS n 'H' C", 0, 0x74),
    ("7SEGMENTS n 0xB0 A", 0, !0x63),
];

#[test]
fn calculations() {
    for (element, m, n) in RESULTS {
        let given = format!("MOVE m {m}");
        let rung = format!("CONTACTS Xa 0 0\n{element}");
        let rows = trace(&[&given, &rung], "_-_", &["n"]);
        assert_eq!(rows[0], [0, *n, *n], "{element} with {m}");
    }
}

/// A number that is not a character becomes a blank in its variable, too.
#[test]
fn a_display_changes_what_it_cannot_show() {
    let rows = trace(
        &["CONTACTS Xa 0 0\nMOVE m -5", "CONTACTS Xa 0 0\n7SEGMENTS n m C"],
        "_-",
        &["m", "n"],
    );
    assert_eq!(rows, [[0, 32], [0, 0]]);
    let rows = trace(&["CTU Ca 900 300 /", "7SEGMENTS n Ca C"], "_-", &["Ca", "n"]);
    assert_eq!(rows, [[32, 32], [0, 0]]);
}

/// Power beyond what does nothing here, as the fork's own simulator has it while nothing is connected.
#[test]
fn power_passes_what_does_nothing_or_ends_there() {
    let passes = [
        "DELAY d",
        "SLEEP",
        "CLRWDT",
        "LOCK",
        "RSFR n 5",
        "RANDOM n",
        "NPULSE n 5 Ya",
        "SPI a b c d e f g h",
        "SPI_WR a b c d e f g h",
        "I2C_RD a b c d e f g h",
        "I2C_WR a b c d e f g h",
        "UART_SEND_READY",
        "STRING s n abc",
        "BUS n m 7 6 5 4 3 2 1 0",
    ];
    let ends = [
        "UART_RECV_AVAIL",
        "QUAD_ENCOD n 0 Xa Xb Xz Ya / 5",
        "UART_SEND n 2 0",
        "UART_RECV n 2 0",
        "UART_SENDn n",
    ];
    for (elements, power) in [(&passes[..], "_-_"), (&ends[..], "___")] {
        for element in elements {
            let rung = format!("CONTACTS Xa 0 0\n{element}\nCOIL Yo 0 0 0 0");
            let rows = trace(&[&rung], "_-_", &["Yo"]);
            assert_eq!(diagram(&rows[0]), power, "{element}");
        }
    }
}

#[test]
fn single_bits() {
    let rows = trace(
        &[
            "CONTACTS Xa 0 0\nSET_BIT n 3",
            "IF_BIT_SET n 3\nCOIL Yo 0 0 0 0",
            "IF_BIT_CLEAR n 3\nCOIL Yc 0 0 0 0",
            "CONTACTS Xa 1 0\nCLEAR_BIT n 3",
        ],
        "_-_",
        &["n", "Yo", "Yc"],
    );
    assert_eq!(rows, [[0, 8, 0], [0, 1, 1], [1, 0, 0]]);
}

#[test]
fn delays_and_first_values_that_are_variables() {
    let rows = trace(
        &["MOVE v 2", "CONTACTS Xa 0 0\nTON Ta v 0\nCOIL Yo 0 0 0 0"],
        "-----",
        &["Yo", "Ta"],
    );
    assert_eq!(rows, [[0, 0, 1, 1, 1], [1, 2, 2, 2, 2]]);
    let rows = trace(
        &[
            "MOVE v 5",
            "CONTACTS Xa 0 0\nCTR Ca 4 v /",
            "CONTACTS Xb 1 0\nCTU Cb 9 7 /",
        ],
        "_-_-_",
        &["Ca", "Cb"],
    );
    assert_eq!(rows, [[5, 4, 4, 5, 5], [8, 8, 8, 8, 8]]);
}

#[test]
fn reset_gives_a_counter_its_first_value() {
    let rows = trace(&["CTU Ca 9 3 -", "CONTACTS Xa 0 0\nRES Ca"], "__-__", &["Ca"]);
    assert_eq!(rows[0], [4, 5, 3, 4, 5]);
}

#[test]
fn jumps_and_subprograms() {
    let rungs = [
        "CONTACTS Xa 0 0\nGOTO over",
        "ADD n n 1",
        "LABEL over",
        "GOSUB part",
        "SUBPROG part",
        "ADD m m 1",
        "CONTACTS Xa 0 0\nRETURN",
        "ADD k k 1",
        "ENDSUB part",
        "CONTACTS Xa 0 0\nGOTO 12",
        "ADD a a 1",
        "ADD b b 1",
        "CONTACTS Xa 0 0\nGOTO 99",
        "ADD c c 1",
    ];
    let rows = trace(&rungs, "_-_", &["n", "m", "k", "a", "b", "c"]);
    assert_eq!(
        rows,
        [[1, 1, 2], [1, 2, 3], [1, 1, 2], [1, 1, 2], [1, 2, 3], [1, 1, 2]]
    );
}
