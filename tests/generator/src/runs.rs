//! Runs of programs with inputs of every kind, held and changed, whose values are near the constants of generated programs.

use crate::constants::{literals, numbers};
use crate::generator::Dice;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, wrap};
use ladder_simulator::{Point, Simulation};

/// For how many scans inputs are held in each run, by and large.
pub const HELD: [usize; 6] = [1, 2, 3, 6, 12, 30];
/// How long each run is.
pub const SCANS: usize = 40;

/// A value for an input: one of the constants that its type has in generated programs, one next to it, or any.
pub fn value(dice: &mut Dice, ty: Scalar) -> Value {
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
#[derive(Debug)]
pub struct Inputs<'c> {
    names: &'c [String],
    dice: Dice,
    held: usize,
    values: Vec<Option<Value>>,
}

impl<'c> Inputs<'c> {
    /// For the inputs of these names, which are held for so many scans by and large.
    pub fn new(names: &'c [String], dice: Dice, held: usize) -> Inputs<'c> {
        Inputs {
            names,
            dice,
            held,
            values: vec![None; names.len()],
        }
    }

    /// Returns the inputs of the next scan, also again, as the program may write what it is given.
    pub fn give(&mut self, programs: &mut [&mut Simulation]) {
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

/// A run in which two programs do not show the same: which of the outputs differs, or that one alone has a fault, and when.
pub fn differing(
    [was, is]: [&mut Simulation; 2],
    inputs: &[String],
    outputs: &[(Point, Point)],
    seed: u64,
) -> Option<String> {
    for (run, held) in HELD.into_iter().enumerate() {
        for simulation in [&mut *was, &mut *is] {
            simulation.reset();
            simulation.take_faults();
        }
        let mut inputs = Inputs::new(inputs, Dice::new(seed ^ run as u64), held);
        for scan in 0..SCANS {
            inputs.give(&mut [&mut *was, &mut *is]);
            // A scan that does not come to its end is not compared.
            if !was.scan() || !is.scan() {
                break;
            }
            let faults = [&mut *was, &mut *is].map(|it| !it.take_faults().is_empty());
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
