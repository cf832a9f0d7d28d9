//! Programs of the IoT ladder language run as the code of iot-ladder-editor ran them: each is read from the small notation,
//! fed with its script, and compared with the trace scan by scan.

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options, Simulation};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// What cannot be matched, and why.
const UNMATCHED: &[(&str, &str)] = &[];

/// The programs that the editor brings along, whose traces name them only.
const EXAMPLES: &[(&str, &str)] = &[
    (
        "ExampleFactory AllKeys",
        "NO I1 ; OUT Q1\nNO I2 ; OUT Q2\nNO I3 ; OUT Q3\nNO I4 ; OUT Q4\n\
         NO I5 ; OUT Q5\nNO I6 ; OUT Q6\nNO I7 ; OUT Q7\nNO I8 ; OUT Q8\n",
    ),
    (
        "ExampleFactory BlinkLed",
        "TON T1 1 100 ; OUT Q1 ; TON T2 1 100 ; RESET T1\n",
    ),
    (
        "ExampleFactory ParallelSerial",
        "NO I1 | NO I2 ; OUT Q1\nNO I3 ; NO I4 ; OUT Q2\n",
    ),
];

#[test]
fn all_traces() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/iot/traces");
    let mut files: Vec<_> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "txt"))
        .collect();
    files.sort();
    assert!(!files.is_empty());
    let mut different = Vec::new();
    for path in &files {
        let name = path
            .file_stem()
            .expect("it has a name")
            .to_string_lossy()
            .into_owned();
        let text = fs::read_to_string(path).expect("the file can be read");
        let known = UNMATCHED.iter().any(|(unmatched, _)| *unmatched == name);
        match (compare(&text), known) {
            (Err(why), false) => different.push(format!("{name}: {why}")),
            (Ok(()), true) => different.push(format!("{name} is equal now: take it out of UNMATCHED")),
            _ => {}
        }
    }
    println!("{} traces, {} differ", files.len(), different.len());
    assert!(different.is_empty(), "{}", different.join("\n"));
}

fn compare(text: &str) -> Result<(), String> {
    // In both of its codes.
    run(text, false)?;
    run(text, true).map_err(|why| format!("in steps: {why}"))
}

fn run(text: &str, in_steps: bool) -> Result<(), String> {
    let (program, rest) = text
        .strip_prefix("program:\n")
        .and_then(|text| text.split_once("script: "))
        .ok_or("there is no program")?;
    let (script, trace) = rest.split_once("trace").ok_or("there is no trace")?;
    let named = EXAMPLES.iter().find(|(name, _)| *name == program.trim());
    let program = named.map_or(program, |(_, program)| program);
    let source = Source::alone("test", program.as_bytes());
    let notation = by_name("iot").expect("the notation is registered");
    let converted =
        convert(notation, &source, &ladder_format::Options::default()).map_err(|error| error.to_string())?;
    let ladder = &converted.written.text;
    let analysis = analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
    let Some(program) = analysis.program() else {
        return Err(format!("it has errors: {errors:?}\n{ladder}"));
    };
    let mut words = script.split_whitespace().filter(|word| *word != "/").peekable();
    let mut options = Options::default();
    if words.next_if_eq(&"dt").is_some() {
        options.interval = 1_000_000 * words.next().and_then(|dt| dt.parse().ok()).unwrap_or(10);
    }
    let mut simulation = Simulation::new(Arc::clone(program), options).map_err(|error| error.message)?;
    let end = trace
        .lines()
        .find(|line| line.starts_with("END"))
        .unwrap_or_default();
    // All that the trace knows, 0 at first.
    let mut known: BTreeMap<&str, &str> = changes(end).map(|(name, _)| (name, "0")).collect();
    let mut scans = trace.lines().filter(|line| {
        let head = line.split_once(':').map_or("", |(head, _)| head);
        head.parse::<u64>().is_ok()
    });
    while let Some(word) = words.next() {
        if word == "cycle" {
            let count = words.next().and_then(|count| count.parse().ok()).unwrap_or(1_u64);
            for _ in 0..count {
                let ran = if in_steps {
                    simulation.begin_scan() && simulation.finish_scan()
                } else {
                    simulation.scan()
                };
                if !ran {
                    return Err("it stops".to_owned());
                }
                let line = scans.next().ok_or("there are more scans than the trace has")?;
                let scan = simulation.scans();
                known.extend(changes(line));
                compare_values(&simulation, &known).map_err(|why| format!("scan {scan}: {why}\n{ladder}"))?;
            }
        } else {
            let (name, value) = word.split_once('=').ok_or_else(|| word.to_owned())?;
            let point = simulation.resolve(name).map_err(|error| error.message)?;
            simulation
                .set(&point, Value::Bool(value == "1"))
                .map_err(|error| format!("{error:?}"))?;
        }
    }
    known.extend(changes(end));
    compare_values(&simulation, &known).map_err(|why| format!("at the end: {why}\n{ladder}"))
}

/// What a line of the trace tells: `8: Q1=1 T1:AC=3`. The memory of an edge is not a tag here.
fn changes(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let (_, changes) = line.split_once(':').unwrap_or_default();
    changes
        .split_whitespace()
        .filter_map(|change| change.split_once('='))
        .filter(|(name, _)| !name.starts_with("LAST_"))
}

fn compare_values(simulation: &Simulation, known: &BTreeMap<&str, &str>) -> Result<(), String> {
    for (name, expected) in known {
        let point = simulation
            .resolve(&name.replace(':', "."))
            .map_err(|error| error.message)?;
        let shown = match simulation.value(&point) {
            Value::Bool(high) => u8::from(high).to_string(),
            Value::Int(number) => number.to_string(),
            Value::Real(real) => real.to_string(),
            text @ Value::Text(_) => format!("{text:?}"),
        };
        if shown != *expected {
            return Err(format!("{name} is {expected} in the original, here {shown}"));
        }
    }
    Ok(())
}
