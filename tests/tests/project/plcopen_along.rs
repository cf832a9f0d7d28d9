//! What is written into a PLCopen project in Structured Text, as the standard has no such thing, does what the simulator does.

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options as Run, Simulation};
use ladder_syntax::parse;
use ladder_tests::structured_text::{Machine, Value as Held};
use std::fmt::Write as _;
use std::sync::Arc;

const PROGRAM: &str = "
VAR  a, r, first, c10, c100, c500, c1s, c1m, c1h : BOOL;  pt : TIME;  k : RTO;  f : RTOF;  c : CTC;  END_VAR
VAR  scans : DINT;  now, passed : TIME;  END_VAR

+--[ ]( a )--[RTO]( k, pt, R := r )--+
+--[ ]( a )--[RTOF]( f, pt, R := r )--+
+--[ ]( a )--[CTC]( c, 3, R := r )--+
+--[ ]( SYS.FIRST_SCAN )--( )( first )--+
+--[ ]( SYS.CLOCK_10MS )--( )( c10 )--+
+--[ ]( SYS.CLOCK_100MS )--( )( c100 )--+
+--[ ]( SYS.CLOCK_500MS )--( )( c500 )--+
+--[ ]( SYS.CLOCK_1S )--( )( c1s )--+
+--[ ]( SYS.CLOCK_1M )--( )( c1m )--+
+--[ ]( SYS.CLOCK_1H )--( )( c1h )--+
+--[MOV]( scans, SYS.SCAN )--[MOV]( now, SYS.TIME )--[MOV]( passed, SYS.SCAN_TIME )--+
";

const MILLISECOND: i64 = 1_000_000;

/// What its networks say, in a program of the interpreter's.
const CALLS: &str = "
PROGRAM main
VAR
    a : BOOL; r : BOOL; pt : TIME;
    sys : LADDER_SYS; k : LADDER_RTO; f : LADDER_RTOF; c : LADDER_CTC;
END_VAR
    sys();
    k(IN := a, PT := pt, R := r);
    f(IN := a, PT := pt, R := r);
    c(CU := a, PV := 3, R := r);
END_PROGRAM
";

/// A value of the simulation, and where the text holds it.
const SAME: &[(&str, &str)] = &[
    ("k.Q", "k.Q"),
    ("k.ET", "k.ET"),
    ("f.Q", "f.Q"),
    ("f.ET", "f.ET"),
    ("c.Q", "c.Q"),
    ("c.CV", "c.CV"),
    ("first", "sys.SYS_FIRST_SCAN"),
    ("c10", "sys.SYS_CLOCK_10MS"),
    ("c100", "sys.SYS_CLOCK_100MS"),
    ("c500", "sys.SYS_CLOCK_500MS"),
    ("c1s", "sys.SYS_CLOCK_1S"),
    ("c1m", "sys.SYS_CLOCK_1M"),
    ("c1h", "sys.SYS_CLOCK_1H"),
    ("scans", "sys.SYS_SCAN"),
    ("now", "sys.SYS_TIME"),
    ("passed", "sys.SYS_SCAN_TIME"),
];

/// The units of a project that are written in Structured Text, as function blocks.
fn units(project: &str) -> String {
    let is = |node: &roxmltree::Node<'_, '_>, name: &str| node.tag_name().name() == name;
    let document = roxmltree::Document::parse(project).expect("a project is XML");
    let mut text = String::new();
    for unit in document.descendants().filter(|node| is(node, "pou")) {
        let Some(body) = unit.descendants().find(|node| is(node, "ST")) else {
            continue;
        };
        let name = unit.attribute("name").expect("a unit has a name");
        let _ = writeln!(text, "FUNCTION_BLOCK {name}");
        for list in unit
            .descendants()
            .filter(|node| node.tag_name().name().ends_with("Vars"))
        {
            let section = match list.tag_name().name() {
                "inputVars" => "VAR_INPUT",
                "localVars" => "VAR",
                _ => "VAR_OUTPUT",
            };
            let _ = writeln!(text, "{section}");
            for variable in list.children().filter(roxmltree::Node::is_element) {
                let ty = variable
                    .first_element_child()
                    .and_then(|ty| ty.first_element_child());
                let ty = ty.expect("a variable has a type");
                let ty = ty.attribute("name").unwrap_or(ty.tag_name().name());
                let _ = writeln!(text, "{} : {ty};", variable.attribute("name").unwrap_or_default());
            }
            let _ = writeln!(text, "END_VAR");
        }
        let told = body
            .descendants()
            .find_map(|node| node.text().filter(|text| !text.trim().is_empty()));
        let _ = writeln!(text, "{}\nEND_FUNCTION_BLOCK", told.expect("the body has a text"));
    }
    text
}

#[test]
fn what_was_changed_since_stays() {
    let text = "VAR  a, lamp : BOOL;  k : RTO;  END_VAR\n+--[ ]( a )--[RTO]( k, 5s )--[ ]( SYS.CLOCK_1S )--( )( lamp )--+\n";
    let analysis = analyze(&Arc::new(parse(text)), "test.clad");
    let notation = by_name("plcopen").expect("the notation is registered");
    let writing = notation.write(&analysis).expect("it has no errors");
    let project = String::from_utf8(writing.bytes).expect("a project is text");
    let read = |project: &str| {
        let source = Source::alone("test", project.as_bytes());
        convert(notation, &source, &Options::default()).expect("it is read")
    };
    assert_eq!(read(&project).report.remarks().count(), 0);
    for (was, is, drawn) in [
        (
            "ET + clock.PASSED",
            "ET + clock.PASSED + PT",
            "ET + clock.PASSED + PT",
        ),
        ("runs := TRUE;", "runs := FALSE;", "[MOV]( runs, FALSE )"),
    ] {
        let changed = project.replace(was, is);
        assert_ne!(changed, project);
        let back = read(&changed);
        assert!(back.written.text.contains(drawn), "{}", back.written.text);
        let told: Vec<String> = back.report.remarks().map(|entry| format!("{entry:?}")).collect();
        assert!(told.is_empty(), "{told:?}");
    }
}

#[test]
fn what_is_written_along_does_the_same() {
    let analysis = analyze(&Arc::new(parse(PROGRAM)), "test.clad");
    let writing = by_name("plcopen")
        .expect("the notation is registered")
        .write(&analysis);
    let writing = writing.expect("it has no errors");
    assert_eq!(writing.report.remarks().count(), 0);
    let text = units(&String::from_utf8_lossy(&writing.bytes)) + CALLS;
    let program = analysis.program().expect("it has no errors");
    // The last ones go over the half hour after which the clocks start again.
    for (seed, interval, scans) in [
        (1, 10, 400),
        (2, 37, 400),
        (3, 700, 200),
        (4, 61_007, 20),
        (5, 1_200_000, 6),
    ] {
        let interval = interval * MILLISECOND;
        let mut machine = Machine::new(&text).unwrap_or_else(|why| panic!("{why}\n{text}"));
        let options = Run {
            interval,
            ..Run::default()
        };
        let mut simulation = Simulation::new(Arc::clone(program), options).expect("it runs");
        let mut dice = Dice::new(seed);
        for scan in 0..scans {
            let mut set = |name: &str, own: Value, held: Held| {
                let point = simulation.resolve(name).expect("the tag is there");
                simulation.set(&point, own).expect("it takes the value");
                let cell = machine.find(name).expect("the variable is there");
                machine.set(cell, held).expect("it takes the value");
            };
            for (name, often) in [("a", 3), ("r", 15)] {
                if dice.one_in(often) || name == "r" {
                    let on = dice.one_in(if name == "r" { 15 } else { 2 });
                    set(name, Value::Bool(on), Held::Bool(on));
                }
            }
            if dice.one_in(10) {
                let time = dice.between(-1, 6) * interval;
                set("pt", Value::Int(time), Held::Time(time));
            }
            simulation.scan();
            machine.scan(scan * interval).expect("the text runs");
            for (own, there) in SAME {
                let point = simulation.resolve(own).expect("the tag is there");
                let cell = machine.find(there).expect("the variable is there");
                let same = match (simulation.value(&point), machine.value(cell).expect("it has one")) {
                    (Value::Bool(own), Held::Bool(held)) => own == held,
                    (Value::Int(own), Held::Int(held, _) | Held::Time(held)) => own == held,
                    _ => false,
                };
                assert!(
                    same,
                    "seed {seed}, scan {scan}: {own} is {:?}",
                    simulation.value(&point)
                );
            }
        }
    }
}
