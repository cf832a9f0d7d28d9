//! How traces write values that are not numbers.

use crate::support::simulation;
use ladder_simulator::trace::{Format, Trace};

const PROGRAM: &str = "TYPE\n    Phase : (IDLE, RUN);\nEND_TYPE\nVAR_OUTPUT\n    p : Phase := RUN;\n    s : STRING := 'say \"on\", $'off$'';\nEND_VAR\n+--( )( y )--+\n";

fn written(format: Format) -> String {
    let mut simulation = simulation(PROGRAM);
    let points = ["p", "s"].map(|name| (name.to_owned(), simulation.resolve(name).unwrap()));
    let mut text = String::new();
    let mut trace = Trace::begin(format, "test.clad", &simulation, &points, &mut text);
    simulation.scan();
    trace.row(&simulation, &mut text);
    trace.end(&mut text);
    text
}

#[test]
fn enumerations_are_written_by_their_names() {
    let json = written(Format::Json);
    assert!(
        json.contains("{ \"name\": \"p\", \"type\": \"Phase\" }"),
        "{json}"
    );
    assert!(json.contains("\"values\": [\"RUN\", \"say \\\"on\\\""), "{json}");
    let csv = written(Format::Csv);
    assert!(csv.contains("0,0,RUN,\"say \"\"on\"\""), "{csv}");
    let vcd = written(Format::Vcd);
    assert!(vcd.contains("sRUN "), "{vcd}");
}
