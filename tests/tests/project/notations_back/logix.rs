//! Programs of the language as L5X, and back: they do the same there.

use super::tables::TO_LOGIX;
use ladder_analysis::analyze;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_invariants::trace::compile;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options as Run, Point, Simulation};
use ladder_syntax::parse;
use std::sync::Arc;

/// The values of tags after each scan.
fn values(text: &str, names: &[&str], seed: u64) -> Vec<String> {
    let program = compile(text).unwrap_or_else(|| panic!("this is no program:\n{text}"));
    let mut simulation = Simulation::new(program, Run::default()).expect("it can be run");
    let mut dice = Dice::new(seed);
    let point = |simulation: &Simulation, name: &str| {
        simulation.resolve(name).unwrap_or_else(|e| panic!("{e}\n{text}"))
    };
    let points: Vec<Point> = names.iter().map(|name| point(&simulation, name)).collect();
    let inputs: Vec<Point> = TO_LOGIX
        .inputs
        .iter()
        .map(|name| point(&simulation, name))
        .collect();
    let mut out = Vec::new();
    for scan in 0..60 {
        for input in &inputs {
            if dice.one_in(3) {
                let value = Value::Bool(dice.one_in(2));
                simulation.set(input, value).expect("an input takes a value");
            }
        }
        simulation.scan();
        let shown: Vec<String> = points
            .iter()
            .map(|point| format!("{:?}", simulation.value(point)))
            .collect();
        out.push(format!("{scan}: {}", shown.join(" ")));
    }
    out
}

#[test]
fn programs_of_the_language_do_the_same_in_logix() {
    let notation = by_name("l5x").expect("the notation is registered");
    let names = ["run", "lamp", "held", "n", "m", "small"];
    let mut whole = 0;
    for seed in 0..200 {
        let text = TO_LOGIX.program(&mut Dice::new(seed));
        let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
        assert!(
            !analysis.has_errors(),
            "{:?}\n{text}",
            analysis.errors().collect::<Vec<_>>()
        );
        let writing = notation
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        // What cannot be written is reported.
        if writing.report.tally().refused > 0 {
            continue;
        }
        whole += 1;
        let shown = String::from_utf8_lossy(&writing.bytes);
        let back = convert(
            notation,
            &Source::alone("test", &writing.bytes),
            &Options::default(),
        );
        let ladder = back
            .unwrap_or_else(|error| panic!("{error}\n{shown}"))
            .written
            .text;
        let (one, other) = (values(&text, &names, seed), values(&ladder, &names, seed));
        for (one, other) in one.iter().zip(&other) {
            assert_eq!(one, other, "{seed}: {text}\nof\n{shown}");
        }
    }
    assert!(whole > 100, "only {whole}");
}

#[test]
fn examples_do_the_same_in_logix() {
    let notation = by_name("l5x").expect("the notation is registered");
    let mut whole = Vec::new();
    for path in ladder_tests::project::files(&ladder_tests::project::root().join("examples"), "clad") {
        let text = std::fs::read_to_string(&path).expect("an example can be read");
        let analysis = analyze(&Arc::new(parse(&text)), "example.clad");
        let Ok(writing) = notation.write(&analysis) else {
            continue;
        };
        if writing.report.tally().refused > 0 {
            continue;
        }
        let back = convert(
            notation,
            &Source::alone("example", &writing.bytes),
            &Options::default(),
        );
        let ladder = back.expect("what is written is read").written.text;
        let start =
            |text: &str| Simulation::new(compile(text).expect("a program"), Run::default()).expect("it runs");
        let (mut one, mut other) = (start(&text), start(&ladder));
        // Bits and numbers, which have their names and types in both.
        let points: Vec<(Point, Point)> = one
            .points()
            .iter()
            .filter(|point| point.ty == Scalar::Bool || point.ty.is_number())
            .filter_map(|point| Some((point.clone(), other.resolve(&point.name).ok()?)))
            .filter(|(point, same)| point.ty == same.ty)
            .collect();
        assert!(points.len() > 3, "{}", path.display());
        let mut dice = Dice::new(7);
        for scan in 0..4_000 {
            let inputs = points.iter().filter(|(point, _)| point.role == Role::Input);
            for (point, same) in inputs.filter(|(point, _)| point.ty == Scalar::Bool) {
                if dice.one_in(200) {
                    let value = Value::Bool(dice.one_in(2));
                    one.set(point, value.clone()).expect("an input takes a value");
                    other.set(same, value).expect("an input takes a value");
                }
            }
            one.scan();
            other.scan();
            for (point, same) in &points {
                let (value, there) = (one.value(point), other.value(same));
                assert_eq!(value, there, "{}: {} in scan {scan}", path.display(), point.name);
            }
        }
        whole.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
    }
    whole.sort();
    assert_eq!(
        whole,
        [
            "conveyor",
            "conveyor_plant",
            "garage_door",
            "garage_door_plant",
            "level_control",
            "mixer",
            "mixer_plant",
            "motor",
            "pump_alternation",
            "pump_group",
            "tank",
            "tank_level",
            "tank_plant",
            "traffic_light"
        ]
    );
}
