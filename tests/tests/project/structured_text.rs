//! The Structured Text of programs does what the simulator shows, scan by scan: read and run by an interpreter of its own.
//!
//! `LADDER_ST_FOLDER` keeps the texts and their programs, `LADDER_ST_PROGRAMS` is how many generated programs are tried of each kind.

use ladder_analysis::program::Program;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_analysis::{Analysis, analyze, link_files};
use ladder_instructions::StateType;
use ladder_invariants::generator::{Dice, Mode, program};
use ladder_simulator::{Options, Simulation};
use ladder_tests::project;
use ladder_tests::structured_text::{Machine, Value as Held};
use std::cell::Cell;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

const SCANS: usize = 12;

/// A loop that does not end stops soon.
const WATCHDOG: u64 = 20_000;

/// A value that can be seen, and set: as the simulator calls it, and the cell that holds it.
struct Place {
    name: String,
    cell: usize,
    ty: Scalar,
    may_be_set: bool,
    is_input: bool,
}

/// What comes of a program.
enum Outcome {
    Same,
    /// It is not written: why.
    Refused(String),
}

fn written(analysis: &Analysis) -> Result<String, String> {
    let notation = ladder_notations::by_name("st").expect("Structured Text is known");
    let text = notation
        .write(analysis)
        .map(|writing| String::from_utf8(writing.bytes).expect("text is UTF-8"));
    keep(&analysis.context.parse.to_string(), text.as_deref().ok());
    text.map_err(|error| error.message)
}

thread_local! {
    /// How many programs this test has kept: tests run side by side, and a program has the same name in every run.
    static KEPT: Cell<usize> = const { Cell::new(0) };
}

/// Puts a program and its text into the folder `LADDER_ST_FOLDER`, if there is one: for those who read them with something else.
fn keep(program: &str, text: Option<&str>) {
    if let Ok(folder) = std::env::var("LADDER_ST_FOLDER") {
        let number = KEPT.replace(KEPT.get() + 1);
        let thread = std::thread::current();
        let test = thread
            .name()
            .and_then(|name| name.rsplit("::").next())
            .unwrap_or("program");
        let keep = |end: &str, text: &str| {
            std::fs::write(Path::new(&folder).join(format!("{test}_{number}.{end}")), text)
                .expect("the folder takes files");
        };
        keep("clad", program);
        if let Some(text) = text {
            keep("st", text);
        }
    }
}

/// The names that variables have instead of their own, from the comments that say so.
fn renamed(text: &str) -> HashMap<String, String> {
    let mut names = HashMap::new();
    for line in text.lines() {
        if let Some((declaration, called)) = line.split_once("(* called ")
            && let Some(name) = declaration.split_whitespace().next()
        {
            let called = called.split(['*', ';']).next().unwrap_or_default().trim();
            names.insert(called.to_owned(), name.to_owned());
        }
    }
    names
}

/// Where the text has what a path of the ladder program names.
fn find(machine: &mut Machine, names: &HashMap<String, String>, path: &str) -> Result<usize, String> {
    let mut path = path.to_owned();
    let longest = names
        .keys()
        .filter(|name| path.starts_with(name.as_str()))
        .max_by_key(|name| name.len());
    if let Some(name) = longest {
        let rest = &path[name.len()..];
        if rest.is_empty() || rest.starts_with(['.', '[']) {
            path = format!("{}{rest}", names[name]);
        }
    }
    let mut found = String::new();
    for (number, step) in path.split('.').enumerate() {
        let (member, index) = step.split_at(step.find('[').unwrap_or(step.len()));
        let plain = if number == 0 {
            step.to_owned()
        } else {
            format!("{found}.{step}")
        };
        // A member that is a word of the language.
        let other = format!("{found}.{member}_member{index}");
        found = match machine.find(&plain) {
            Err(_) if machine.find(&other).is_ok() => other,
            _ => plain,
        };
    }
    machine.find(&found)
}

fn places(
    program: &Program,
    machine: &mut Machine,
    names: &HashMap<String, String>,
) -> Result<Vec<Place>, String> {
    let mut places = Vec::new();
    for tag in program.tags.iter().filter(|tag| tag.block.is_none()) {
        // The inside of a block has names of its own.
        if tag
            .column
            .as_ref()
            .is_some_and(|column| column.declared.0 != column.root)
        {
            continue;
        }
        let mut add = |name: String, path: &str, ty, may_be_set| {
            let cell = find(machine, names, path).map_err(|why| format!("{name}: {why}"))?;
            places.push(Place {
                name,
                cell,
                ty,
                may_be_set,
                is_input: tag.is_input,
            });
            Ok::<(), String>(())
        };
        match tag.ty {
            Type::Scalar(ty) => add(tag.name.clone(), &tag.name, ty, !tag.constant)?,
            Type::Array { first, last, element } => {
                for number in first..=last {
                    let name = tag.element_name(number);
                    add(name.clone(), &name, element, !tag.constant)?;
                }
            }
            // One in an array or structure has a variable only where it is used.
            Type::State(_) if tag.column.is_some() && !names.contains_key(&tag.name) => {}
            Type::State(state) => {
                let members: &[(&str, Scalar)] = match state {
                    StateType::Sr | StateType::Rs => &[("Q1", Scalar::Bool)],
                    state if state.is_timer() => &[("Q", Scalar::Bool), ("ET", Scalar::Time)],
                    _ => &[("Q", Scalar::Bool), ("CV", Scalar::Dint)],
                };
                for (member, ty) in members {
                    let path = format!("{}.{member}", tag.name);
                    add(path.clone(), &path, *ty, false)?;
                }
            }
            Type::Compound(_) => {}
        }
    }
    Ok(places)
}

fn any_value(dice: &mut Dice, ty: Scalar) -> Option<Value> {
    Some(match ty {
        Scalar::Bool => Value::Bool(dice.one_in(2)),
        Scalar::Real | Scalar::Lreal => Value::Real([0.0, 1.5, -2.25, 1000.0, 0.1_f32.into()][dice.below(5)]),
        Scalar::Time => Value::Int(dice.between(0, 50) * 1_000_000),
        _ if ty.is_integer() || ty.is_bits() => Value::Int(dice.between(0, 12)),
        _ => return None,
    })
}

/// A value as the interpreter takes it.
fn given(value: &Value, ty: Scalar) -> Option<Held> {
    Some(match (value, ty) {
        (Value::Bool(high), _) => Held::Bool(*high),
        (Value::Int(time), Scalar::Time) => Held::Time(*time),
        (Value::Int(_), _) if ty.is_date() => return None,
        (Value::Int(number), Scalar::Enum(id)) => Held::Named(id.get().name_of(*number)?.to_uppercase()),
        (Value::Int(number), _) => Held::Int(*number, None),
        (Value::Real(real), _) => Held::Real(*real, None),
        (Value::Text(text), _) => Held::Text(text.to_vec()),
    })
}

fn is_same(own: &Value, other: &Held, ty: Scalar) -> bool {
    match (own, other) {
        (Value::Bool(a), Held::Bool(b)) => a == b,
        (Value::Int(a), Held::Int(b, _)) => a == b,
        (Value::Int(a), Held::Time(b) | Held::Clock(b, _)) => a == b,
        (Value::Int(number), Held::Named(name)) => match ty {
            Scalar::Enum(id) => id.get().name_of(*number).is_some_and(|own| {
                let own = own.to_uppercase();
                *name == own || *name == format!("{own}_VALUE")
            }),
            _ => false,
        },
        // Functions such as SIN differ in their last digits.
        (Value::Real(a), Held::Real(b, _)) => (a - b).abs() <= 1e-6 * a.abs().max(b.abs()).max(1e-9),
        (Value::Text(a), Held::Text(b)) => **a == **b,
        _ => false,
    }
}

/// What is set before each scan: by the name of the tag.
type Inputs = dyn FnMut(&mut Simulation, &[Place], usize) -> Vec<(usize, Value)>;

/// Runs a program both ways.
fn compare(analysis: &Analysis, interval: i64, scans: usize, inputs: &mut Inputs) -> Result<Outcome, String> {
    let linked = link_files(&Arc::new(analysis.clone()), &|_| None).map_err(|_| "no program".to_owned())?;
    let program = Arc::clone(&linked.program);
    let text = match written(&analysis.with_others(linked)) {
        Ok(text) => text,
        Err(why) => return Ok(Outcome::Refused(why)),
    };
    let with_text = |why: String| format!("{why}\n{text}");
    let options = Options {
        watchdog: WATCHDOG,
        interval,
    };
    let mut simulation = Simulation::new(program.clone(), options).map_err(|error| error.message)?;
    let mut machine = Machine::new(&text).map_err(with_text)?;
    let names = renamed(&text);
    let places = places(&program, &mut machine, &names).map_err(with_text)?;
    for scan in 0..scans {
        for (place, value) in inputs(&mut simulation, &places, scan) {
            let place = &places[place];
            let point = simulation.resolve(&place.name).map_err(|_| place.name.clone())?;
            if let Some(given) = given(&value, place.ty)
                && simulation.set(&point, value).is_ok()
            {
                machine.set(place.cell, given).map_err(with_text)?;
            }
        }
        let ran = simulation.scan();
        if simulation.take_faults().iter().any(|fault| fault.stops) {
            // Loops without an end are stopped sooner here, later there.
            break;
        }
        machine
            .scan(scan as i64 * interval)
            .map_err(|why| with_text(format!("scan {scan}: {why}")))?;
        for place in &places {
            let point = simulation.resolve(&place.name).map_err(|_| place.name.clone())?;
            let (own, other) = (simulation.value(&point), machine.value(place.cell)?);
            if !is_same(&own, &other, place.ty) {
                return Err(with_text(format!(
                    "scan {scan}: {} is {own:?}, in Structured Text {other:?}",
                    place.name
                )));
            }
        }
        if !ran {
            break;
        }
    }
    Ok(Outcome::Same)
}

fn with_dice(seed: u64) -> Box<Inputs> {
    let mut dice = Dice::new(seed);
    Box::new(move |_, places, scan| {
        let mut set = Vec::new();
        // What has its initial value by a statement of the first scan is set from outside after it.
        let is_set = |place: &Place| place.may_be_set && (scan > 0 || place.is_input);
        for (number, place) in places.iter().enumerate().filter(|(_, place)| is_set(place)) {
            if dice.one_in(3)
                && let Some(value) = any_value(&mut dice, place.ty)
            {
                set.push((number, value));
            }
        }
        set
    })
}

/// The inputs of a table with a header of names.
fn with_table(table: String) -> Box<Inputs> {
    Box::new(move |simulation, places, scan| {
        let mut lines = table.lines();
        let header = lines.next().unwrap_or_default();
        let row = lines.nth(scan).unwrap_or_default();
        let cells = header
            .split(',')
            .zip(row.split(','))
            .filter(|(_, cell)| !cell.trim().is_empty());
        let given = cells.filter_map(|(name, cell)| {
            let number = places
                .iter()
                .position(|place| place.name.eq_ignore_ascii_case(name.trim()))?;
            let point = simulation.resolve(&places[number].name).ok()?;
            let value = ladder_simulator::value_text::parse(cell.trim(), point.ty).ok()?;
            Some((number, value))
        });
        given.collect()
    })
}

/// A program of the project with the run next to it, then with any inputs.
fn check_file(path: &Path) -> Result<Outcome, String> {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(&project::read(path))), "program");
    let arguments = std::fs::read_to_string(path.with_extension("args")).unwrap_or_default();
    let words: Vec<&str> = arguments.split_whitespace().collect();
    let after = |word: &str| {
        words
            .iter()
            .position(|own| *own == word)
            .and_then(|at| words.get(at + 1))
    };
    let scans = after("--scans")
        .and_then(|scans| scans.parse().ok())
        .unwrap_or(SCANS);
    let interval = after("--dt").map_or(Ok(Value::Int(10_000_000)), |dt| {
        ladder_simulator::value_text::parse(dt, Scalar::Time)
    });
    let Ok(Value::Int(interval)) = interval else {
        return Err(format!("{words:?}"));
    };
    let table = std::fs::read_to_string(path.with_extension("in.csv")).unwrap_or_default();
    match compare(&analysis, interval, scans, &mut *with_table(table))? {
        Outcome::Same => compare(&analysis, interval, scans.max(SCANS), &mut *with_dice(1)),
        refused @ Outcome::Refused(_) => Ok(refused),
    }
}

fn check_folder(folder: &str) -> (usize, Vec<String>) {
    let (mut same, mut refused, mut wrong) = (0, Vec::new(), Vec::new());
    for path in project::files(&project::root().join(folder), "clad") {
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        match check_file(&path) {
            Ok(Outcome::Same) => same += 1,
            Ok(Outcome::Refused(why)) => refused.push(format!("{name}: {why}")),
            Err(why) => wrong.push(format!("{name}: {why}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    (same, refused)
}

#[test]
fn examples_do_the_same_in_structured_text() {
    let (same, refused) = check_folder("examples");
    println!("{same} do the same; refused: {refused:#?}");
    assert!(refused.is_empty(), "{refused:#?}");
}

#[test]
fn semantics_are_the_same_in_structured_text() {
    let (same, mut refused) = check_folder("tests/corpus/semantics");
    println!("{same} do the same; refused: {refused:#?}");
    // Compilers that are built on matiec have no arrays of blocks: what chooses among them stays refused.
    refused.retain(|why| !why.contains("that a computed index chooses"));
    assert!(refused.len() * 6 < same, "{refused:#?}");
}

#[test]
fn generated_programs_do_the_same_in_structured_text() {
    let count: u64 = std::env::var("LADDER_ST_PROGRAMS")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(40);
    let (mut same, mut refused, mut wrong) = (0, Vec::new(), Vec::new());
    for (mode, seed) in [Mode::Sensible, Mode::Boolean, Mode::Wild, Mode::Typed]
        .into_iter()
        .flat_map(|mode| (0..count).map(move |seed| (mode, seed)))
    {
        let text = program(seed, mode);
        let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "program");
        match compare(&analysis, 10_000_000, SCANS, &mut *with_dice(seed)) {
            Ok(Outcome::Same) => same += 1,
            Ok(Outcome::Refused(why)) => refused.push(format!("{mode:?} {seed}: {why}")),
            Err(why) => wrong.push(format!("{mode:?} {seed}: {why}\n{text}")),
        }
    }
    let mut reasons: HashMap<&str, usize> = HashMap::new();
    for why in &refused {
        *reasons
            .entry(why.rsplit("cannot say this: ").next().unwrap_or(why))
            .or_default() += 1;
    }
    println!("{same} do the same, {} are refused: {reasons:#?}", refused.len());
    let first: Vec<&String> = wrong.iter().take(6).collect();
    assert!(
        wrong.is_empty(),
        "{} differ\n{}",
        wrong.len(),
        first
            .iter()
            .map(|why| why.as_str())
            .collect::<Vec<_>>()
            .join("\n\n")
    );
}
