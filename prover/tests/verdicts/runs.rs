//! Runs of programs with inputs of every kind, held and changed, whose values are near the constants of the program.

use super::case::Case;
use super::constants::{literals, numbers};
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, wrap};
use ladder_generator::generator::Dice;
use ladder_prover::Divergence;
use ladder_simulator::scenario::{Monitor, Watched, bind_properties, parse};
use ladder_simulator::{Point, Simulation, Status};

/// For how many scans inputs are held in each run, by and large.
const HELD: [usize; 6] = [1, 2, 3, 6, 12, 30];
const SCANS: usize = 40;

/// A value for an input: one of the constants that its type has in generated programs, one next to it, or any.
pub(crate) fn value(dice: &mut Dice, ty: Scalar) -> Value {
    let number = |dice: &mut Dice, unit: i64| {
        let near = dice.of(numbers(ty)).saturating_add(dice.between(-1, 1) * unit);
        if dice.one_in(8) { dice.any() as i64 } else { near }
    };
    match ty {
        Scalar::Bool => Value::Bool(dice.one_in(2)),
        Scalar::Real | Scalar::Lreal => {
            let near = dice.of(&[0.0, 2.5, -1.0, 100.0]);
            Value::Real(near + dice.of(&[0.0, 0.25, -0.25, 1000.0]))
        }
        Scalar::Enum(id) => {
            let values = &id.get().values;
            Value::Int(values[dice.below(values.len())].1.into())
        }
        ty if ty.is_string() => {
            let text = dice.of(&["", "ab", "abc"]);
            Value::Text(text.as_bytes().into())
        }
        Scalar::Time => Value::Int(number(dice, 10_000_000)),
        ty if ty.is_date() => {
            let literal = dice.of(literals(ty.name()));
            let known = ladder_simulator::value_text::parse(literal, ty);
            let Ok(Value::Int(known)) = known else {
                return Value::Int(0);
            };
            let day = 86_400_000_000_000;
            Value::Int(match ty {
                _ if dice.one_in(4) => dice.any() as i64,
                Scalar::Tod => dice.of(&[0, known, known + 1_000_000_000]),
                _ => dice.of(&[0, known, known + day, known - day]),
            })
        }
        ty => Value::Int(wrap(number(dice, 1), ty)),
    }
}

/// What goes into a run, scan by scan.
struct Inputs<'c> {
    names: &'c [String],
    dice: Dice,
    held: usize,
    values: Vec<Option<Value>>,
}

impl<'c> Inputs<'c> {
    fn new(case: &'c Case, dice: Dice, held: usize) -> Inputs<'c> {
        Inputs {
            names: &case.inputs,
            dice,
            held,
            values: vec![None; case.inputs.len()],
        }
    }

    /// Gives the inputs of the next scan, also again, as the program may write what it is given.
    fn give(&mut self, programs: &mut [&mut Simulation]) {
        for (name, given) in self.names.iter().zip(&mut self.values) {
            let points: Vec<Option<Point>> = programs.iter().map(|it| it.resolve(name).ok()).collect();
            let Some(ty) = points.iter().flatten().map(|point| point.ty).next() else {
                continue;
            };
            if self.dice.one_in(self.held) {
                *given = Some(value(&mut self.dice, ty));
            }
            let Some(value) = given else { continue };
            for (simulation, point) in programs.iter_mut().zip(points) {
                if let Some(point) = point.filter(|point| point.ty == ty) {
                    simulation.set(&point, value.clone()).expect("it is of its type");
                }
            }
        }
    }
}

/// A run that does what a property of the text says that none does: which property, and when. `said`: which are believed.
pub(crate) fn violated(case: &Case, properties: &str, said: &[bool], seed: u64) -> Option<String> {
    let mut simulation = case.running()?;
    let (mut watched, errors) = bind_properties(&parse(properties), &simulation);
    assert_eq!(errors, [], "{case}\n{properties}");
    for (run, held) in HELD.into_iter().enumerate() {
        simulation.reset();
        simulation.take_faults();
        watched.properties.iter_mut().for_each(Monitor::restart);
        let mut inputs = Inputs::new(case, Dice::new(seed ^ run as u64), held);
        for scan in 0..SCANS {
            inputs.give(&mut [&mut simulation]);
            if !simulation.scan() {
                break;
            }
            if let Some(name) = violated_now(&mut simulation, &mut watched, said) {
                return Some(format!("\"{name}\" in run {run}, scan {scan}"));
            }
            if simulation.status() != Status::Ready {
                break;
            }
        }
    }
    None
}

fn violated_now(simulation: &mut Simulation, watched: &mut Watched, said: &[bool]) -> Option<String> {
    let faulted = !simulation.take_faults().is_empty();
    let mut found = None;
    for (monitor, said) in watched.properties.iter_mut().zip(said) {
        let violates = monitor.violates(simulation, faulted);
        if violates && *said {
            found.get_or_insert_with(|| monitor.name.clone());
        }
    }
    found
}

/// Plays a difference that was found, with what is shown of it and no more.
pub(crate) fn is_so(mut old: Simulation, mut new: Simulation, run: &Divergence) -> bool {
    let mut is_so = true;
    for simulation in [&mut old, &mut new] {
        simulation.reset();
        simulation.take_faults();
    }
    for scan in 0..run.scans {
        for simulation in [&mut old, &mut new] {
            for row in &run.given {
                let point = simulation.resolve(&row.name).ok();
                if let Some(point) = point.filter(|point| point.is_input) {
                    simulation.set(&point, row.values[scan].clone()).expect("it fits");
                }
            }
            is_so &= simulation.scan();
        }
        for differing in &run.differs {
            let value = |simulation: &Simulation| {
                simulation.value(&simulation.resolve(&differing.name).expect("both have it"))
            };
            is_so &= value(&old) == differing.old[scan] && value(&new) == differing.new[scan];
        }
        let faulted = [&mut old, &mut new].map(|simulation| !simulation.take_faults().is_empty());
        is_so &= faulted == [run.faults[0][scan], run.faults[1][scan]];
    }
    let last = run.scans - 1;
    let shows = run.differs.iter().any(|tag| tag.old[last] != tag.new[last]);
    is_so && (shows || run.faults[0][last] != run.faults[1][last] || run.ended.is_some())
}

/// A run in which two programs do not show the same: what differs, and when.
pub(crate) fn differing(old: &Case, new: &Case, seed: u64) -> Option<String> {
    let (mut was, mut is, seen) = (old.running()?, new.running()?, old.opened()?);
    let outputs: Vec<(Point, Point)> = (was.points().iter())
        .filter(|point| point.role == Role::Output || point.name.starts_with(['y', 'Q']))
        .filter(|point| !point.ty.is_string() && seen.resolve(&point.name).is_ok())
        .filter_map(|point| Some((point.clone(), is.resolve(&point.name).ok()?)))
        .collect();
    for (run, held) in HELD.into_iter().enumerate() {
        for simulation in [&mut was, &mut is] {
            simulation.reset();
            simulation.take_faults();
        }
        let mut inputs = Inputs::new(old, Dice::new(seed ^ run as u64), held);
        for scan in 0..SCANS {
            inputs.give(&mut [&mut was, &mut is]);
            // A scan that does not come to its end is not compared.
            if !was.scan() || !is.scan() {
                break;
            }
            let faults = [&mut was, &mut is].map(|it| !it.take_faults().is_empty());
            if faults[0] != faults[1] {
                return Some(format!("a fault in run {run}, scan {scan}"));
            }
            let other = (outputs.iter()).find(|(point, other)| was.value(point) != is.value(other));
            if let Some((point, _)) = other {
                return Some(format!("{} in run {run}, scan {scan}", point.name));
            }
        }
    }
    None
}
