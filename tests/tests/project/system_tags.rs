//! What stands for the tags of `SYS` in files of systems that have none of them does what they do.

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_format::Options;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options as Run, Simulation};
use ladder_syntax::parse;
use std::sync::Arc;

const PROGRAM: &str = "
VAR  c10, c100, c500, c1s, c1m, c1h : BOOL;  scans : DINT;  now, passed : TIME;  END_VAR

+--[ ]( SYS.CLOCK_10MS )--( )( c10 )--+
+--[ ]( SYS.CLOCK_100MS )--( )( c100 )--+
+--[ ]( SYS.CLOCK_500MS )--( )( c500 )--+
+--[ ]( SYS.CLOCK_1S )--( )( c1s )--+
+--[ ]( SYS.CLOCK_1M )--( )( c1m )--+
+--[ ]( SYS.CLOCK_1H )--( )( c1h )--+
+--[MOV]( scans, SYS.SCAN )--[MOV]( now, SYS.TIME )--[MOV]( passed, SYS.SCAN_TIME )--+
";

const TAGS: [&str; 9] = [
    "c10", "c100", "c500", "c1s", "c1m", "c1h", "scans", "now", "passed",
];

const MILLISECOND: i64 = 1_000_000;

/// What a program is in a notation, as ladder text again.
fn again(name: &str, program: &str) -> String {
    let notation = by_name(name).expect("the notation is registered");
    let writing = notation.write(&analyze(&Arc::new(parse(program)), "test.clad"));
    let writing = writing.expect("it has no errors");
    assert_eq!(writing.report.tally().refused, 0, "{:?}", writing.report);
    let source = Source {
        companions: writing.companions,
        ..Source::alone("test", &writing.bytes)
    };
    let read = convert(notation, &source, &Options::default()).expect("it is read");
    read.written.text
}

/// A program with scans of so many milliseconds.
fn simulation(program: &str, interval: i64) -> Simulation {
    let analysis = analyze(&Arc::new(parse(program)), "test.clad");
    let program = Arc::clone(analysis.program().expect("it has no errors"));
    let options = Run {
        interval: interval * MILLISECOND,
        ..Run::default()
    };
    Simulation::new(program, options).expect("it runs")
}

/// Times come back from Logix as whole numbers of milliseconds, so what stands for the tags of `SYS` stays.
#[test]
fn the_block_that_is_written_along_does_what_sys_does() {
    let there = again("l5x", PROGRAM);
    assert!(there.contains("FUNCTION_BLOCK [$LadderSys]"), "{there}");
    // Two timers take turns: all of them are in some scan, the long ones for hours.
    for (interval, scans) in [(3, 500), (37, 500), (700, 500), (61_007, 500), (500_000, 200)] {
        let (mut own, mut other) = (simulation(PROGRAM, interval), simulation(&there, interval));
        for scan in 0..scans {
            own.scan();
            other.scan();
            for tag in TAGS {
                let value = |simulation: &Simulation| {
                    let point = simulation.resolve(tag).expect("the tag is there");
                    simulation.value(&point)
                };
                let expected = match value(&own) {
                    Value::Int(time) if ["now", "passed"].contains(&tag) => Value::Int(time / MILLISECOND),
                    value => value,
                };
                assert_eq!(value(&other), expected, "{interval} ms, scan {scan}: {tag}");
            }
        }
    }
}

/// Where the system has the same types the tags are those of `SYS` again, if the block is as it was written.
#[test]
fn they_are_tags_of_sys_again() {
    let there = again("simatic", PROGRAM);
    assert!(!there.contains("adder_sys"), "{there}");
    for tag in [
        "SYS.CLOCK_1M",
        "SYS.CLOCK_1S",
        "SYS.SCAN )",
        "SYS.TIME",
        "SYS.SCAN_TIME",
    ] {
        assert!(there.contains(tag), "{tag}: {there}");
    }
}

#[test]
fn a_block_that_was_changed_stays() {
    let notation = by_name("simatic").expect("the notation is registered");
    let writing = notation.write(&analyze(&Arc::new(parse(PROGRAM)), "test.clad"));
    let writing = writing.expect("it has no errors");
    let mut companions = writing.companions;
    let block = companions
        .iter_mut()
        .find(|companion| companion.name == "LadderSys.s7dcl");
    let block = block.expect("the block is a file of its own");
    let text = String::from_utf8_lossy(&block.bytes).replace("60000", "59000");
    block.bytes = text.into();
    let source = Source {
        companions,
        ..Source::alone("test", &writing.bytes)
    };
    let read = convert(notation, &source, &Options::default()).expect("it is read");
    assert!(read.written.text.contains("59000"), "{}", read.written.text);
}
