//! Programs of LDmicro run as LDmicro's own simulator ran them: each is imported, fed with its stimulus, and compared
//! with the trace that LDmicro 2.2 gave, cycle by cycle.

use ladder_analysis::program::{Argument, BlockKind, Expr, ExprKind, Place, Program};
use ladder_analysis::values::value::Value;
use ladder_analysis::{Severity, analyze};
use ladder_instructions::Op;
use ladder_notations::{Converted, Source, by_name, convert};
use ladder_simulator::{Options, Point, Simulation};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What cannot be matched, and why.
const UNMATCHED: &[(&str, &str)] = &[];

#[test]
fn the_elements() {
    check(&Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/ldmicro/elements"));
}

#[test]
fn the_programs() {
    match std::env::var_os("LADDER_CORPUS") {
        Some(folder) => check(&Path::new(&folder).join("ldmicro/programs")),
        None => eprintln!("skipped: LADDER_CORPUS names no folder of real programs"),
    }
}

fn check(folder: &Path) {
    let mut traces: Vec<PathBuf> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "trace"))
        .collect();
    traces.sort();
    assert!(!traces.is_empty(), "{} has traces", folder.display());
    let mut different = Vec::new();
    for path in &traces {
        let name = path
            .file_stem()
            .expect("it has a name")
            .to_string_lossy()
            .into_owned();
        let known = UNMATCHED.iter().any(|(unmatched, _)| *unmatched == name);
        match (compare(path), known) {
            (Err(why), false) => different.push(format!("{name}: {why}")),
            (Ok(()), true) => different.push(format!("{name} is equal now: take it out of UNMATCHED")),
            _ => {}
        }
    }
    println!("{} traces, {} differ", traces.len(), different.len());
    assert!(different.is_empty(), "{}", different.join("\n"));
}

fn compare(trace: &Path) -> Result<(), String> {
    let read = |extension: &str| {
        fs::read_to_string(trace.with_extension(extension)).map_err(|error| format!("{extension}: {error}"))
    };
    let expected = read("trace")?;
    let bytes = fs::read(trace.with_extension("ld")).map_err(|error| error.to_string())?;
    let source = Source::alone("test", &bytes);
    let notation = by_name("ldmicro").expect("the notation is registered");
    let converted =
        convert(notation, &source, &ladder_format::Options::default()).map_err(|error| error.to_string())?;
    let text = &converted.written.text;
    let analysis = analyze(&ladder_syntax::parse(text).into(), "test.clad");
    let fails = expected.lines().any(|line| line == "COMPILE FAILED");
    if fails {
        return compare_refusal(&converted, &analysis, &expected);
    }
    let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
    let Some(program) = analysis.program() else {
        return Err(format!("it has errors: {errors:?}\n{text}"));
    };
    // In both of its codes.
    for in_steps in [false, true] {
        let mut plant = Plant::of(program, &converted, in_steps)?;
        plant.play(&read("stim")?)?;
        let run = plant.finish();
        compare_lines(&run, &expected).map_err(|why| format!("in steps: {in_steps}, {why}\n{text}"))?;
    }
    compare_warnings(&converted, &expected)
}

/// What LDmicro says of the program when it runs into it is reported when it is imported.
fn compare_warnings(converted: &Converted, expected: &str) -> Result<(), String> {
    for line in expected.lines().filter_map(|line| line.strip_prefix("ERROR: ")) {
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let mut found = converted.findings.iter();
        let told = line.starts_with("Division") || found.any(|found| words(&found.message) == words(line));
        if !told {
            return Err(format!("nothing says `{line}`"));
        }
    }
    let unassigned = converted
        .findings
        .iter()
        .filter(|found| found.check == "ldmicro-unassigned");
    match unassigned.count() {
        0 => Ok(()),
        _ if expected.contains("not assigned to") => Ok(()),
        count => Err(format!(
            "LDmicro knows all variables, and {count} are reported as unknown"
        )),
    }
}

/// What LDmicro does not compile, with what it says, is not run here either.
fn compare_refusal(
    converted: &Converted,
    analysis: &ladder_analysis::Analysis,
    expected: &str,
) -> Result<(), String> {
    for line in expected.lines().filter_map(|line| line.strip_prefix("ERROR: ")) {
        let mut found = converted.findings.iter();
        if !found.any(|found| found.message == line && found.severity == Severity::Error) {
            return Err(format!("nothing says `{line}`"));
        }
    }
    let Some(program) = analysis.program() else {
        return Ok(());
    };
    match Simulation::new(Arc::clone(program), options_of(program)) {
        Ok(_) => Err("LDmicro does not compile it, and it runs".to_owned()),
        Err(_) => Ok(()),
    }
}

/// LDmicro's cycle is the scan interval.
fn options_of(program: &Program) -> Options {
    Options {
        interval: program.cycle.unwrap_or(Options::default().interval),
        ..Options::default()
    }
}

/// A program that runs, and what it did so far.
struct Plant {
    /// Each scan is begun and then finished, which plain code does.
    in_steps: bool,
    simulation: Simulation,
    /// The values of a trace by their names, with what shows them.
    points: BTreeMap<String, Point>,
    /// The analog inputs, by the names of their variables.
    analog: BTreeMap<String, Point>,
    cycles: u64,
    lines: Vec<String>,
    shown: BTreeMap<String, i64>,
    faults: Vec<String>,
}

impl Plant {
    fn of(program: &Arc<Program>, converted: &Converted, in_steps: bool) -> Result<Plant, String> {
        let kept = |word: &str| {
            let lines = converted.written.text.lines();
            lines
                .filter_map(|line| line.strip_prefix("# ldmicro: ")?.strip_suffix(" #"))
                .filter_map(|line| Some(line.strip_prefix(word)?.to_owned()))
                .collect::<Vec<String>>()
        };
        let simulation =
            Simulation::new(Arc::clone(program), options_of(program)).map_err(|error| error.message)?;
        let renamed: BTreeMap<String, String> = kept("NAME ")
            .iter()
            .filter_map(|line| line.split_once(" = "))
            .map(|(tag, name)| (tag.to_owned(), name.to_owned()))
            .collect();
        let mut plant = Plant {
            points: BTreeMap::new(),
            analog: BTreeMap::new(),
            cycles: 0,
            lines: Vec::new(),
            shown: BTreeMap::new(),
            faults: Vec::new(),
            in_steps,
            simulation,
        };
        plant.names(program, &renamed)?;
        Ok(plant)
    }

    fn names(&mut self, program: &Program, renamed: &BTreeMap<String, String>) -> Result<(), String> {
        use ladder_analysis::values::types::Type;
        for tag in &program.tags {
            let name = renamed.get(&tag.name).unwrap_or(&tag.name);
            let point = |text: &str| self.simulation.resolve(text).map_err(|error| error.message);
            match tag.ty {
                Type::Compound(_) => {}
                Type::State(state) if state.is_timer() => {
                    self.points
                        .insert(name.clone(), point(&format!("{}.ET", tag.name))?);
                }
                Type::State(_) => {
                    self.points
                        .insert(name.clone(), point(&format!("{}.CV", tag.name))?);
                }
                Type::Array { first, last, .. } => {
                    for index in first..=last {
                        let point = point(&format!("{}[{index}]", tag.name))?;
                        self.points.insert(format!("{name}{index}"), point);
                    }
                }
                Type::Scalar(_) => {
                    self.points.insert(name.clone(), point(&tag.name)?);
                }
            }
        }
        for block in program.networks.iter().flat_map(|network| &network.blocks) {
            let BlockKind::Instruction(row) = block.kind else {
                continue;
            };
            let arguments: Vec<&Argument> = block.arguments.iter().map(|bound| &bound.argument).collect();
            if row.op == Op::Adc
                && let [
                    Argument::Place(Place::Tag(tag), _),
                    Argument::Value(Expr {
                        kind: ExprKind::Constant(Value::Int(channel)),
                        ..
                    }),
                ] = arguments[..]
            {
                let name = &program.tags[tag.0 as usize].name;
                let port = format!("PORT.ADC[{channel}]");
                let port = self.simulation.resolve(&port).map_err(|error| error.message)?;
                self.analog
                    .insert(renamed.get(name).unwrap_or(name).clone(), port);
            }
        }
        Ok(())
    }

    fn play(&mut self, stimulus: &str) -> Result<(), String> {
        for line in stimulus.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words[..] {
                ["cycle"] => self.cycle(),
                ["cycle", count] => {
                    for _ in 0..count.parse().map_err(|_| line.to_owned())? {
                        self.cycle();
                    }
                }
                ["uart", code] => {
                    let code = code.parse().map_err(|_| line.to_owned())?;
                    self.simulation.feed_serial(&[code]);
                }
                [word @ ("set" | "var" | "adc"), name, value] => {
                    let value: i64 = value.parse().map_err(|_| line.to_owned())?;
                    let points = if word == "adc" { &self.analog } else { &self.points };
                    let point = points.get(name).cloned();
                    let point = point.ok_or_else(|| format!("there is no `{name}`"))?;
                    let value = if word == "set" {
                        Value::Bool(value != 0)
                    } else {
                        Value::Int(value)
                    };
                    self.simulation
                        .set(&point, value)
                        .map_err(|error| format!("{error:?}"))?;
                }
                _ => return Err(format!("cannot read `{line}`")),
            }
        }
        Ok(())
    }

    fn cycle(&mut self) {
        let ran = if self.in_steps {
            self.simulation.begin_scan() && self.simulation.finish_scan()
        } else {
            self.simulation.scan()
        };
        if !ran {
            return;
        }
        self.cycles += 1;
        let mut line = format!("{}:", self.cycles);
        for (name, point) in &self.points {
            let value = number(&self.simulation.value(point));
            if self.shown.insert(name.clone(), value).unwrap_or(0) != value {
                line.push_str(&format!(" {name}={value}"));
            }
        }
        for byte in self.simulation.take_serial() {
            let shown = match byte {
                b' '..=b'~' => char::from(byte).to_string(),
                byte => format!("\\x{byte:02x}"),
            };
            line.push_str(&format!(" UART=\"{shown}\""));
        }
        self.lines.push(line);
        let faults = self.simulation.take_faults();
        self.faults.extend(faults.into_iter().map(|fault| fault.message));
    }

    fn finish(self) -> Run {
        Run {
            lines: self.lines,
            end: self.shown,
            faults: self.faults,
        }
    }
}

fn number(value: &Value) -> i64 {
    match value {
        Value::Bool(high) => i64::from(*high),
        Value::Int(number) => *number,
        _ => i64::MIN,
    }
}

struct Run {
    lines: Vec<String>,
    end: BTreeMap<String, i64>,
    faults: Vec<String>,
}

/// A line's changes, sorted: LDmicro has an order of its own.
fn changes(line: &str) -> Vec<&str> {
    let mut changes = Vec::new();
    let mut rest = line;
    while let Some(start) = rest.find(|c: char| c != ' ') {
        rest = &rest[start..];
        // A blank may be between the quotes.
        let end = match rest.find("=\"") {
            Some(at) if !rest[..at].contains(' ') => {
                at + 2
                    + rest[at + 2..]
                        .find('"')
                        .map_or(rest.len() - at - 2, |end| end + 1)
            }
            _ => rest.find(' ').unwrap_or(rest.len()),
        };
        changes.push(&rest[..end]);
        rest = &rest[end..];
    }
    changes.sort_unstable();
    changes
}

fn compare_lines(run: &Run, expected: &str) -> Result<(), String> {
    let mut ours = run.lines.iter();
    for line in expected.lines() {
        let Some((head, rest)) = line.split_once(':') else {
            continue;
        };
        if head == "ERROR" {
            let told = rest.trim();
            let is_division = told.starts_with("Division by zero");
            if is_division && !run.faults.iter().any(|fault| fault.starts_with(told)) {
                return Err(format!("no fault says `{told}`: {:?}", run.faults));
            }
        } else if head == "END" {
            let Some((_, state)) = rest.split_once(':') else {
                continue;
            };
            for change in changes(state) {
                let (name, value) = change.split_once('=').unwrap_or((change, ""));
                let ours = run.end.get(name).map(i64::to_string);
                if ours.as_deref() != Some(value) {
                    return Err(format!("at the end {name} is {value}, here {ours:?}"));
                }
            }
        } else if head.parse::<u64>().is_ok() {
            let line = format!("{head}:{rest}");
            let ours = ours.next().map_or("nothing", String::as_str);
            if changes(ours) != changes(&line) {
                return Err(format!("LDmicro has `{line}`, here `{ours}`"));
            }
        }
    }
    match ours.next() {
        Some(more) => Err(format!("LDmicro stops, here follows `{more}`")),
        None => Ok(()),
    }
}
