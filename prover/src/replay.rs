//! Runs that were found, in the simulator: only what happens there too is shown.

use crate::decide::Run;
use crate::encode::Input;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::Watched;
use ladder_simulator::{Point, Simulation, Status};

/// A run as it went in the simulator: for each scan the values of the tags that are shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The tags that go in, with their values in each scan.
    pub given: Vec<(Point, Vec<Value>)>,
    /// The tags that the property names and that do not go in, likewise.
    pub seen: Vec<(Point, Vec<Value>)>,
    /// In which scans a block recorded a fault.
    pub faults: Vec<bool>,
    /// The system tag that shows the last of them a scan later: that of the program, or of a plant.
    pub fault_tag: String,
}

impl Shown {
    /// How many scans it has.
    pub fn scans(&self) -> usize {
        self.faults.len()
    }
}

/// What a run is to show in its last scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// That the property is violated, or has come true.
    Property,
    /// A fault in one of its expressions.
    Fault,
}

/// Plays a run. None: what it is to show does not happen in its last scan, or what is assumed does not hold.
pub(crate) fn replay(
    simulation: &mut Simulation,
    watched: &mut Watched,
    (property, wanted): (usize, Wanted),
    (run, inputs): (&Run, &[Input]),
) -> Option<Shown> {
    simulation.unforce_all();
    simulation.reset();
    simulation.take_faults();
    watched.restart();
    let monitor = &watched.properties[property];
    let mut shown = Shown {
        given: Vec::new(),
        seen: monitor
            .points()
            .into_iter()
            .map(|point| (point, Vec::new()))
            .collect(),
        faults: Vec::new(),
        fault_tag: String::new(),
    };
    for (input, scans) in inputs.iter().zip(&run.inputs) {
        if scans.is_empty() {
            continue;
        }
        let point = simulation.resolve(&input.tag.name).ok()?;
        let values = scans.iter().map(|bits| value(point.ty, bits)).collect();
        shown.given.push((point, values));
    }
    // What it names comes first.
    let is_named = |point: &Point| shown.seen.iter().any(|(seen, _)| seen.name == point.name);
    let mut given = std::mem::take(&mut shown.given);
    given.sort_by_key(|(point, _)| !is_named(point));
    shown.given = given;
    // What the property names and was not asked for is shown as it is.
    shown
        .seen
        .retain(|(point, _)| !shown.given.iter().any(|(given, _)| given.name == point.name));
    let mut is_shown = false;
    for scan in 0..run.scans {
        for (point, values) in &shown.given {
            simulation.set(point, values[scan].clone()).ok()?;
        }
        if simulation.status() != Status::Ready || !simulation.scan() {
            return None;
        }
        let faulted = !simulation.take_faults().is_empty();
        if watched.broken_assumption(simulation).is_some() {
            return None;
        }
        let monitor = &mut watched.properties[property];
        let violates = monitor.violates(simulation, faulted);
        is_shown = match wanted {
            Wanted::Property => violates,
            Wanted::Fault => monitor.faulted(),
        };
        shown.faults.push(faulted);
        shown.fault_tag = match simulation.faulted_plant() {
            Some(plant) => format!("{plant}.SYS.FAULT"),
            None => "SYS.FAULT".to_owned(),
        };
        for (point, values) in &mut shown.seen {
            values.push(simulation.value(point));
        }
    }
    is_shown.then_some(shown)
}

/// The value of an input from its bits.
pub(crate) fn value(ty: Scalar, bits: &[bool]) -> Value {
    let mut number = 0i64;
    for (n, bit) in bits.iter().enumerate().take(64) {
        number |= i64::from(*bit) << n;
    }
    match ty {
        Scalar::Bool => Value::Bool(number & 1 == 1),
        Scalar::Real | Scalar::Lreal => Value::Real(f64::from_bits(number as u64)),
        Scalar::Enum(_) => Value::Int(i64::from(number as i32)),
        ty => Value::Int(ladder_analysis::values::value::wrap(number, ty)),
    }
}
