//! How traces write values that are not numbers.

use crate::support::simulation;
use expect_test::{Expect, expect};
use ladder_simulator::trace::{Format, Trace};

const PROGRAM: &str = "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\nVAR_OUTPUT\n    p : Phase := RUN;\n    s : STRING := 'say \"on\", $'off$'';\nEND_VAR\n+--( )( y )--+\n";

fn check(format: Format, expected: Expect) {
    let mut simulation = simulation(PROGRAM);
    let points = ["p", "s"].map(|name| (name.to_owned(), simulation.resolve(name).unwrap()));
    let mut text = String::new();
    let mut trace = Trace::begin(format, "test.clad", &simulation, &points, &mut text);
    simulation.scan();
    trace.row(&simulation, &mut text);
    trace.end(&mut text);
    expected.assert_eq(&text);
}

#[test]
fn enumerations_and_texts() {
    check(Format::Json, expect![[""]]);
    check(Format::Csv, expect![[""]]);
    check(Format::Vcd, expect![[""]]);
}
