//! What a program does, whole: every tag and every power in every scan, with inputs that a seed gives.

use crate::generator::Dice;
use crate::generator::typed::{INPUTS, Typed};
use crate::reference::Boolean;
use crate::running::Running;
use ladder_analysis::program::{ElementKind, Program, Role};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::{Value, wrap};
use ladder_analysis::{analyze, link};
use ladder_simulator::value_text::cell;
use ladder_simulator::{HistoryLimits, Options, Point, Session, Simulation};
use ladder_syntax::parse;
use std::fmt::Write;
use std::sync::Arc;

/// A stimulus and how long it goes on.
#[derive(Debug, Clone, Copy)]
pub struct Stimulus {
    /// From this seed come the inputs.
    pub seed: u64,
    /// So many scans.
    pub scans: usize,
}

/// How a program is run: these must give the same trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Engine {
    /// As it runs when nothing is forced.
    Fused,
    /// As it runs when something is forced: a tag that the program does not use.
    Plain,
}

/// A loop that does not end stops soon.
const WATCHDOG: u64 = 20_000;

/// The name of the tag that is forced for [`Engine::Plain`].
const UNUSED: &str = "nothing_uses_this";

/// The program of a text; none if it has errors.
pub fn compile(text: &str) -> Option<Arc<Program>> {
    let analysis = Arc::new(analyze(&Arc::new(parse(text)), "program"));
    link(&analysis, &|_| None).ok()
}

/// The trace of a text that is a program.
///
/// # Panics
/// It is none.
pub fn trace(text: &str, stimulus: Stimulus, engine: Engine) -> String {
    // The unused tag is there in both cases, so that both have the same memory. A line of its own ends what is open.
    let line_end = if text.contains('\n') || !text.contains('\r') {
        "\n"
    } else {
        "\r"
    };
    let whole = format!("{text}{line_end}VAR {UNUSED} : BOOL; END_VAR{line_end}");
    let program = compile(&whole).unwrap_or_else(|| panic!("this is not a program:\n{text}"));
    let options = Options {
        watchdog: WATCHDOG,
        ..Options::default()
    };
    let mut simulation =
        Simulation::new(program, options).unwrap_or_else(|error| panic!("it is refused: {error:?}\n{text}"));
    if engine == Engine::Plain {
        let unused = simulation.resolve(UNUSED).expect("it is declared");
        simulation
            .force(&unused, Value::Bool(false))
            .expect("a BOOL takes FALSE");
    }
    record(&mut simulation, &whole, stimulus)
}

fn record(simulation: &mut Simulation, source: &str, stimulus: Stimulus) -> String {
    let points = points(simulation);
    let inputs: Vec<Point> = points
        .iter()
        .filter(|p| p.role == Role::Input && !p.read_only)
        .cloned()
        .collect();
    let mut dice = Dice::new(stimulus.seed);
    let mut text = String::new();
    for scan in 0..stimulus.scans {
        for input in &inputs {
            if dice.one_in(3) {
                let value = any_value(&mut dice, input.ty);
                simulation
                    .set(input, value)
                    .expect("an input takes a value of its type");
            }
        }
        if dice.one_in(4) {
            simulation.feed_serial(&[dice.any() as u8]);
        }
        let ran = simulation.scan();
        // Writing to a String does not fail.
        let _ = write!(text, "{scan} {ran}");
        for point in &points {
            let _ = write!(
                text,
                " {}={}",
                point.name,
                cell(&simulation.value(point), point.ty)
            );
        }
        text.push_str("\n ");
        // Formatting makes wires longer and draws those that were missing.
        let elements = simulation.power().filter(|(kind, ..)| *kind != ElementKind::Wire);
        for (number, (_, location, power)) in elements.enumerate() {
            let drawn = &source[std::ops::Range::<usize>::from(location.range)];
            // Of its operands only a few letters, without blanks: they say which block it is.
            let drawn = drawn.chars().filter(|c| !c.is_whitespace()).take(12);
            let drawn: String = drawn.flat_map(char::to_uppercase).collect();
            let _ = write!(text, " {number}:{drawn}={}", u8::from(power));
        }
        text.push('\n');
        for fault in simulation.take_faults() {
            let _ = writeln!(text, "  fault in scan {}: {}", fault.scan, fault.message);
        }
        let _ = writeln!(text, "  sent {:?}", simulation.take_serial());
        if !ran {
            break;
        }
    }
    text
}

/// Runs a program next to another that should do the same: all values of the first are checked in both, in every scan,
/// with inputs that the first has. The first difference; none if there is none. Both stop where the first does.
///
/// # Panics
/// One of the texts is not a program.
pub fn next_to(text: &str, other: &str, stimulus: Stimulus) -> Option<String> {
    let program = |text: &str| compile(text).unwrap_or_else(|| panic!("this is not a program:\n{text}"));
    programs_next_to(
        (program(text), program(other)),
        &|name| Some(name.to_owned()),
        stimulus,
    )
}

/// The same of two programs. `named`: how a tag of the first is called in the second; one that has no name there is not compared.
///
/// # Panics
/// One of them is refused.
pub fn programs_next_to(
    (one, other): (Arc<Program>, Arc<Program>),
    named: &dyn Fn(&str) -> Option<String>,
    stimulus: Stimulus,
) -> Option<String> {
    let start = |program| {
        let options = Options {
            watchdog: WATCHDOG,
            ..Options::default()
        };
        Simulation::new(program, options).unwrap_or_else(|error| panic!("it is refused: {error:?}"))
    };
    let (mut one, mut two) = (start(one), start(other));
    let mut points = Vec::new();
    for point in self::points(&one) {
        let Some(name) = named(&point.name) else { continue };
        match two.resolve(&name) {
            Ok(same) => points.push((point, same)),
            Err(_) => return Some(format!("`{}` is gone", point.name)),
        }
    }
    let mut dice = Dice::new(stimulus.seed);
    for scan in 0..stimulus.scans {
        for (point, same) in &points {
            if point.role == Role::Input && !point.read_only && dice.one_in(3) {
                let value = any_value(&mut dice, point.ty);
                one.set(point, value.clone())
                    .expect("an input takes a value of its type");
                two.set(same, value).expect("it is the same tag");
            }
        }
        if dice.one_in(4) {
            let byte = [dice.any() as u8];
            one.feed_serial(&byte);
            two.feed_serial(&byte);
        }
        // Where the one is stopped by its watchdog the other may do a few blocks more.
        if !one.scan() {
            return None;
        }
        two.scan();
        for (point, same) in &points {
            let (left, right) = (one.value(point), two.value(same));
            if left != right {
                return Some(format!("{} in scan {scan}: {left:?} and {right:?}", point.name));
            }
        }
        let (left, right) = (one.take_faults().len(), two.take_faults().len());
        if left != right {
            return Some(format!("{left} and {right} faults in scan {scan}"));
        }
        if one.take_serial() != two.take_serial() {
            return Some(format!("what is sent in scan {scan}"));
        }
    }
    None
}

/// Every value that the program has, elements of arrays too.
fn points(simulation: &Simulation) -> Vec<Point> {
    let mut points = simulation.points().to_vec();
    let program = simulation.program().clone();
    for tag in program.tags.iter().filter(|tag| tag.block.is_none()) {
        if let Type::Array { first, last, .. } = tag.ty {
            let elements = (first..=last).map(|index| tag.element_name(index));
            points.extend(elements.map(|name| simulation.resolve(&name).expect("an element")));
        }
    }
    points
}

fn any_value(dice: &mut Dice, ty: Scalar) -> Value {
    match ty {
        Scalar::Bool => Value::Bool(dice.one_in(2)),
        Scalar::Real | Scalar::Lreal => Value::Real(dice.between(-200, 200) as f64 / 8.0),
        Scalar::Time => Value::Int(dice.between(-2, 12) * 10_000_000),
        Scalar::Date => Value::Int(dice.between(0, 20_000) * 86_400_000_000_000),
        Scalar::Tod => Value::Int(dice.between(0, 86_399) * 1_000_000_000),
        Scalar::Dt => Value::Int(dice.between(0, 2_000_000_000) * 1_000_000_000),
        Scalar::String(_) => {
            let texts: [&[u8]; 5] = [b"", b"a", b"12", b"-3", b"long enough for a cut"];
            Value::Text(dice.of(&texts).into())
        }
        Scalar::Enum(id) => {
            let values = id.get();
            Value::Int(i64::from(values.values[dice.below(values.values.len())].1))
        }
        _ => {
            let number = if dice.one_in(4) {
                dice.any() as i64
            } else {
                dice.between(-2, 9)
            };
            Value::Int(wrap(number, ty))
        }
    }
}

/// Runs a program of contacts and coils next to the reference, with the same values in all tags now and then.
///
/// # Panics
/// A tag, or the power of a block, differs.
pub fn compare(text: &str, reference: &mut Boolean, stimulus: Stimulus) {
    let program = compile(text).unwrap_or_else(|| panic!("this is not a program:\n{text}"));
    let mut simulation = Simulation::new(program, Options::default()).expect("contacts and coils run");
    let names: Vec<String> = reference.tags.keys().cloned().collect();
    let mut dice = Dice::new(stimulus.seed);
    for scan in 0..stimulus.scans {
        for name in &names {
            if dice.one_in(3) {
                let high = dice.one_in(2);
                let point = simulation.resolve(name).expect("a tag of the program");
                simulation
                    .set(&point, Value::Bool(high))
                    .expect("a BOOL takes a BOOL");
                reference.tags.insert(name.clone(), high);
            }
        }
        assert!(simulation.scan());
        reference.scan();
        for name in &names {
            let point = simulation.resolve(name).expect("a tag of the program");
            let expected = Value::Bool(reference.tags[name]);
            assert_eq!(
                simulation.value(&point),
                expected,
                "{name} in scan {scan} of\n{text}"
            );
        }
        // The simulator lists its blocks in the order of evaluation.
        let mut blocks: Vec<(u32, bool)> = simulation
            .power()
            .filter(|(kind, ..)| *kind == ElementKind::Block)
            .map(|(_, location, power)| (location.range.start().into(), power))
            .collect();
        blocks.sort_unstable();
        let power: Vec<bool> = blocks.into_iter().map(|(_, power)| power).collect();
        assert_eq!(power, reference.power, "power in scan {scan} of\n{text}");
    }
}

/// Runs a program with types of its own next to the reference, with the same inputs now and then; with edits, it is changed
/// while it runs.
///
/// # Panics
/// A part of a tag differs, or how many faults there were.
pub fn compare_typed(typed: &Typed, stimulus: Stimulus, edits: usize) {
    let mut typed = typed.clone();
    let mut text = typed.to_string();
    let simulation = Simulation::new(typed_program(&text), Options::default())
        .unwrap_or_else(|error| panic!("it is refused: {error:?}\n{text}"));
    let mut session = Session::of(simulation, HistoryLimits::default());
    let mut reference = Running::new(&typed);
    let mut dice = Dice::new(stimulus.seed);
    for scan in 0..stimulus.scans {
        for input in 0..INPUTS {
            let (high, number) = (dice.one_in(2), dice.between(-1, 3));
            (reference.switches[input], reference.numbers[input]) = (high, number);
            for (name, value) in [("e", Value::Bool(high)), ("i", Value::Int(number))] {
                let point = session.simulation().resolve(&format!("{name}{input}"));
                let set = session.set(&point.expect("an input"), value);
                set.expect("an input takes a value of its type");
            }
        }
        assert!(session.scan(), "scan {scan} of\n{text}");
        reference.scan();
        same_values(&session, &reference, &format!("scan {scan} of\n{text}"));
        let faults = session.faults_of(scan as u64);
        assert_eq!(
            faults.len(),
            reference.faults,
            "{faults:?} in scan {scan} of\n{text}"
        );
        if edits > 0 && scan % (stimulus.scans / (edits + 1)).max(1) == 2 {
            typed = typed.edited(&mut dice);
            let before = std::mem::replace(&mut text, typed.to_string());
            let changed = session.change(typed_program(&text));
            changed.unwrap_or_else(|error| panic!("it is refused: {error:?}\n{text}"));
            reference.change(&typed);
            let shown = format!("the edit after scan {scan} of\n{before}\n=>\n{text}");
            same_values(&session, &reference, &shown);
        }
    }
}

fn typed_program(text: &str) -> Arc<Program> {
    compile(text).unwrap_or_else(|| {
        let analysis = analyze(&Arc::new(parse(text)), "program");
        let errors = analysis.errors().map(|found| &found.message);
        panic!("this is not a program: {:#?}\n{text}", errors.collect::<Vec<_>>())
    })
}

fn same_values(session: &Session, reference: &Running, shown: &str) {
    let simulation = session.simulation();
    for (name, expected) in reference.values() {
        let point = simulation.resolve(&name);
        let point = point.unwrap_or_else(|error| panic!("{error} in {shown}"));
        let found = cell(&simulation.value(&point), point.ty);
        assert_eq!(found, expected, "{name} in {shown}");
    }
}

/// The first scan in which two traces differ, and in what; none if they are equal.
pub fn difference(one: &str, other: &str) -> Option<String> {
    let scan = |lines: &[&str], at: usize| {
        let starts = |line: &&&str| !line.starts_with(' ');
        lines[..=at]
            .iter()
            .rfind(starts)
            .map_or("", |line| line.split(' ').next().unwrap_or_default())
            .to_owned()
    };
    let lines: (Vec<&str>, Vec<&str>) = (one.lines().collect(), other.lines().collect());
    let at = lines.0.iter().zip(&lines.1).position(|(one, other)| one != other);
    let Some(at) = at else {
        return (one != other).then(|| format!("{} lines and {} lines", lines.0.len(), lines.1.len()));
    };
    let (left, right) = (lines.0[at], lines.1[at]);
    let words = left
        .split(' ')
        .zip(right.split(' '))
        .filter(|(left, right)| left != right);
    let words: Vec<String> = words.map(|(left, right)| format!("{left} | {right}")).collect();
    Some(format!("scan {}:\n{}", scan(&lines.0, at), words.join("\n")))
}
