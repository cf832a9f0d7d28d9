//! The reader and the simulator next to a generator and a machine that know neither: random drawings and the projects of the
//! corpus, scan by scan.
//!
//! `LADDER_PLCOPEN_PROGRAMS` is how many drawings are tried.

mod boxes;
mod controls;
mod drawing;
mod generator;
mod machine;

use crate::corpus::{files, others, own, stem};
use crate::harness::text;
use drawing::Dice;
use ladder_analysis::values::value::Value;
use ladder_notation::{Source, convert};
use ladder_notation_plcopen::Plcopen;
use ladder_simulator::{Options, Simulation};
use machine::Frame;
use std::sync::Arc;

/// A scan, in milliseconds.
const STEP: i64 = 100;

/// How a project differs from what it does there. The error is why it cannot be compared.
fn difference(xml: &str, scans: usize, dice: &mut Dice) -> Result<Option<String>, String> {
    let (units, main) = generator::units(xml)?;
    let mut frame = Frame::new(&units, &main)?;
    let source = Source::alone("test", xml.as_bytes());
    let converted =
        convert(&Plcopen, &source, &ladder_format::Options::default()).map_err(|error| error.to_string())?;
    let ladder = converted.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "main.clad");
    let Some(program) = analysis.program() else {
        let text = text(xml);
        let errors: Vec<&str> = text.lines().filter(|line| line.starts_with("error")).collect();
        return Ok(Some(format!("{}\n{text}", errors.join("; "))));
    };
    let options = Options {
        interval: STEP * 1_000_000,
        ..Options::default()
    };
    let mut simulation = Simulation::new(Arc::clone(program), options).map_err(|error| error.message)?;
    let written: Vec<String> = written(xml);
    let names = frame.names();
    for scan in 0..scans {
        for name in &names {
            if frame.is_of(name, "BOOL") && !written.contains(name) && dice.below(4) == 0 {
                let high = dice.below(2) == 1;
                frame.set(name, f64::from(u8::from(high)));
                let point = simulation.resolve(name).map_err(|error| error.message)?;
                simulation
                    .set(&point, Value::Bool(high))
                    .map_err(|error| format!("{error:?}"))?;
            }
        }
        frame.run(&units, scan as f64 * STEP as f64)?;
        simulation.scan();
        let faults = simulation.take_faults();
        if !faults.is_empty() {
            return Err(format!("{faults:?}"));
        }
        for name in &names {
            let point = simulation.resolve(name).map_err(|error| error.message)?;
            let here = match simulation.value(&point) {
                Value::Bool(high) => f64::from(u8::from(high)),
                Value::Int(number) if frame.is_of(name, "TIME") => number as f64 / 1e6,
                Value::Int(number) => number as f64,
                Value::Real(number) => number,
                Value::Text(_) => continue,
            };
            let there = frame.get(name);
            if (here - there).abs() > 1e-4 * there.abs().max(1.0) {
                return Ok(Some(format!(
                    "scan {scan}: {name} is {here}, and {there} there\n{ladder}\n{:#?}",
                    units[&main].steps
                )));
            }
        }
    }
    Ok(None)
}

/// The variables that a project writes, in small letters.
fn written(xml: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(xml).expect("it is XML");
    let nodes = document.descendants();
    let writes =
        nodes.filter(|node| matches!(node.tag_name().name(), "coil" | "outVariable" | "inOutVariable"));
    let names = writes.flat_map(|node| node.descendants());
    let names = names.filter(|node| matches!(node.tag_name().name(), "variable" | "expression"));
    names
        .filter_map(|node| Some(node.text()?.trim().to_lowercase()))
        .collect()
}

/// Drawings in which what a comparison with EN decided is asked for again by a later coil, or is read before a block changes it,
/// or in which a contact sees an edge of the output of a block that feeds it.
const RARE: [u64; 6] = [102, 1009, 1160, 2840, 3350, 5702];

#[test]
fn random_drawings_do_what_the_generator_says() {
    let count = std::env::var("LADDER_PLCOPEN_PROGRAMS").ok();
    let count = count.and_then(|count| count.parse().ok()).unwrap_or(60);
    let first = std::env::var("LADDER_PLCOPEN_FIRST")
        .ok()
        .and_then(|it| it.parse().ok())
        .unwrap_or(0);
    let mut different = Vec::new();
    for seed in (first..first + count).chain(RARE) {
        let mut dice = Dice(seed * 2 + 1);
        let xml = drawing::project(&mut dice);
        match difference(&xml, 50, &mut dice) {
            Ok(None) => {}
            Ok(Some(why)) => different.push(format!("seed {seed}: {why}\n{xml}")),
            Err(why) => different.push(format!("seed {seed} cannot be compared: {why}\n{xml}")),
        }
    }
    different.sort_by_key(String::len);
    let first: Vec<&str> = different.iter().filter_map(|why| why.lines().next()).collect();
    assert!(
        different.is_empty(),
        "{} of {count} differ:\n{}\n{}",
        different.len(),
        first.join("\n"),
        different[0]
    );
}

/// A wire that comes back without a block between: the generator does not end.
const ENDLESS: &str = "a loop";

#[test]
fn random_boxes_do_what_the_generator_says() {
    let count = std::env::var("LADDER_PLCOPEN_PROGRAMS").ok();
    let count: u64 = count.and_then(|count| count.parse().ok()).unwrap_or(400);
    for seed in 0..count {
        let mut dice = Dice(seed * 2 + 1);
        let xml = boxes::project(&mut dice, seed % 3 > 0);
        match difference(&xml, 30, &mut dice) {
            Ok(None) => {}
            Err(why) if why == ENDLESS => {}
            // A function that takes its own result and may be off is approximated.
            Ok(Some(_)) if text(&xml).contains("as it was here") => {}
            Ok(Some(why)) => panic!("seed {seed}: {why}\n{xml}"),
            Err(why) => panic!("seed {seed} cannot be compared: {why}\n{xml}"),
        }
    }
}

/// A program with one block, whose inputs are variables and values, and its output in a variable.
#[track_caller]
fn check_block(block: &str, inputs: &[(&str, &str)], output: &str) {
    let is_real = output == "XOUT";
    let mut body = String::new();
    let mut pins = String::new();
    for (number, (pin, value)) in inputs.iter().enumerate() {
        let id = number + 10;
        body.push_str(&format!("inVariable {id} {value}\n"));
        pins.push_str(&format!(" {pin}={id}"));
    }
    body.push_str(&format!(
        "block 3 {block} it{pins} / {output}\noutVariable 4 from=3.{output} y\n"
    ));
    // The value that is controlled goes up and down with an input.
    body.push_str("inVariable 30 a\ninVariable 31 x\ninVariable 32 1.5\nblock 33 ADD IN1=31 IN2=32 / OUT\n");
    body.push_str("block 34 SUB IN1=31 IN2=32 / OUT\nblock 35 SEL G=30 IN0=34.OUT IN1=33.OUT / OUT\noutVariable 36 from=35.OUT x\n");
    let ty = if is_real { "REAL" } else { "BOOL" };
    let variables = format!("a : BOOL\nb : BOOL\nc : BOOL\nx : REAL\ny : {ty}\nit : {block}");
    let xml = crate::harness::project("", &crate::harness::program(&variables, &body), "");
    let found = difference(&xml, 60, &mut Dice(11));
    assert_eq!(
        found,
        Ok(None),
        "{}\n{}",
        text(&xml),
        found.clone().ok().flatten().unwrap_or_default()
    );
}

#[test]
fn additional_blocks_do_what_the_standard_says() {
    let cycle = ("CYCLE", "T#100ms");
    check_block("SEMA", &[("CLAIM", "b"), ("RELEASE", "c")], "BUSY");
    check_block(
        "HYSTERESIS",
        &[("XIN1", "x"), ("XIN2", "1.0"), ("EPS", "2.0")],
        "Q",
    );
    check_block(
        "INTEGRAL",
        &[("RUN", "b"), ("R1", "c"), ("XIN", "x"), ("X0", "5.0"), cycle],
        "XOUT",
    );
    check_block("DERIVATIVE", &[("RUN", "b"), ("XIN", "x"), cycle], "XOUT");
    let gains = [("KP", "2.0"), ("TR", "4.0"), ("TD", "0.5")];
    let values = [("AUTO", "b"), ("PV", "x"), ("SP", "1.0"), ("X0", "3.0")];
    check_block("PID", &[&values[..], &gains[..], &[cycle]].concat(), "XOUT");
    let ramp = [
        ("RUN", "b"),
        ("X0", "1.0"),
        ("X1", "9.0"),
        ("TR", "T#400ms"),
        cycle,
    ];
    check_block("RAMP", &ramp, "XOUT");
    check_block("RAMP", &ramp, "BUSY");
}

#[test]
fn projects_do_what_the_generator_says() {
    let mut folders = vec![own()];
    folders.extend(others("plcopen-xml"));
    let mut different = Vec::new();
    for project in folders.iter().flat_map(|folder| files(folder, "xml")) {
        let xml = std::fs::read_to_string(&project).expect("the file can be read");
        match difference(&xml, 200, &mut Dice(7)) {
            Ok(None) => {}
            Ok(Some(why)) => different.push(format!("{}: {why}", stem(&project))),
            Err(why) => eprintln!("{} is not compared: {why}", stem(&project)),
        }
    }
    assert!(
        different.is_empty(),
        "{} differ:\n{}",
        different.len(),
        different.join("\n")
    );
}
