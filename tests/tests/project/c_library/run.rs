//! Runs of a program in the simulator, told as statements of C that make its library do the same.

use ladder_analysis::program::Program;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_invariants::generator::Dice;
use ladder_simulator::compiled::{Compiled, Home, compile};
use ladder_simulator::scenario::{self, Case, Watched};
use ladder_simulator::{Options, Simulation};
use std::fmt::Write;
use std::sync::Arc;

const SCANS: usize = 12;

/// How many scans go by at most until all is shown, where nothing is given between them.
const MOST_UNSEEN: u64 = 500;

/// A value that can be seen, and set: its name, and where it is in the memory of the library.
struct Place {
    name: String,
    bank: &'static str,
    at: u32,
    ty: Scalar,
    may_be_set: bool,
}

/// What a run shows, and what the library has to be told so that it shows the same.
pub(super) struct Told {
    /// A line each time that something is shown.
    pub shown: String,
    /// Statements of C.
    pub statements: String,
    places: Vec<Place>,
    interval: i64,
}

impl Told {
    fn new(program: &Program, compiled: &Compiled, interval: i64) -> Told {
        Told {
            shown: String::new(),
            statements: String::new(),
            places: places(program, compiled),
            interval,
        }
    }

    /// This run, and after a cold start another.
    pub(super) fn then(mut self, other: Told) -> Told {
        self.shown.push_str(&other.shown);
        self.statements.push_str("    program_init(&s);\n");
        self.statements.push_str(&other.statements);
        self
    }

    fn give(&mut self, place: usize, word: &str) {
        let place = &self.places[place];
        let _ = writeln!(self.statements, "    s.{}[{}] = {word};", place.bank, place.at);
    }

    /// Scans up to one, and what is there after it.
    fn scan(&mut self, scans: std::ops::Range<u64>, ran: bool, words: &[String]) {
        let _ = write!(
            self.statements,
            "    show_inputs(&s);\n    printf(\"{} %d\", some_scans(&s, {}, {}, INT64_C({})));",
            scans.end, scans.start, scans.end, self.interval,
        );
        let _ = write!(self.shown, "{} {}", scans.end, u8::from(ran));
        for (place, word) in self.places.iter().zip(words) {
            let _ = write!(self.shown, " {}={word}", place.name);
            let (name, at) = (place.name.replace('%', "%%"), place.at);
            let _ = match place.bank {
                "t" => writeln!(self.statements, "    printf(\" {name}=\"); show_text(&s, {at});"),
                bank => writeln!(
                    self.statements,
                    "    printf(\" {name}=%lld\", (long long)s.{bank}[{at}]);"
                ),
            };
        }
        self.shown.push('\n');
        self.statements.push_str("    puts(\"\");\n");
    }

    fn words(&self, simulation: &Simulation) -> Vec<String> {
        let word_of = |place: &Place| {
            let point = simulation.resolve(&place.name).expect("the name of a tag");
            word(&simulation.value(&point))
        };
        self.places.iter().map(word_of).collect()
    }
}

/// A run in which values come and go at random.
pub(super) fn at_random(program: &Arc<Program>, seed: u64) -> Option<Told> {
    let options = Options::default();
    let compiled = compile(program, options.interval).ok()?;
    let mut told = Told::new(program, &compiled, options.interval);
    let mut simulation = Simulation::new(program.clone(), options).ok()?;
    let mut dice = Dice::new(seed);
    for scan in 0..SCANS as u64 {
        for n in 0..told.places.len() {
            let place = &told.places[n];
            if !place.may_be_set || !dice.one_in(3) {
                continue;
            }
            let Some(value) = value(&mut dice, place.ty) else {
                continue;
            };
            let point = simulation.resolve(&place.name).expect("the name of a tag");
            if simulation.set(&point, value.clone()).is_ok() {
                told.give(n, &word(&value));
            }
        }
        let ran = simulation.scan();
        if simulation.take_faults().iter().any(|fault| fault.stops) {
            // Loops without an end are stopped sooner here, later there.
            break;
        }
        let words = told.words(&simulation);
        told.scan(scan..scan + 1, ran, &words);
    }
    Some(told)
}

/// The run of a scenario. None: it does not pass, or the program cannot be run.
pub(super) fn as_played(program: &Arc<Program>, interval: i64, case: &Case) -> Option<Told> {
    let options = Options {
        interval,
        ..Options::default()
    };
    let compiled = compile(program, interval).ok()?;
    let mut told = Told::new(program, &compiled, interval);
    let mut simulation = Simulation::new(program.clone(), options).ok()?;
    let mut before = told.words(&simulation);
    let (mut told_of, mut scans, mut ran_last) = (0, 0, true);
    let ran = scenario::run(case, &mut Watched::default(), &mut simulation, |simulation| {
        let now = told.words(simulation);
        let is_given = |n: &usize| told.places[*n].may_be_set && now[*n] != before[*n];
        let given: Vec<usize> = (0..now.len()).filter(is_given).collect();
        if told_of < scans && (!given.is_empty() || scans - told_of == MOST_UNSEEN) {
            told.scan(told_of..scans, ran_last, &before);
            told_of = scans;
        }
        for n in given {
            told.give(n, &now[n]);
        }
        ran_last = simulation.scan();
        scans += 1;
        before = told.words(simulation);
        ran_last
    });
    told.scan(told_of..scans, ran_last, &before);
    ran.passed().then_some(told)
}

fn places(program: &Program, compiled: &Compiled) -> Vec<Place> {
    let mut places = Vec::new();
    for (tag, home) in program
        .tags
        .iter()
        .zip(&compiled.homes)
        .filter(|(tag, _)| tag.block.is_none())
    {
        let name = |n: u32, first: i64| match tag.ty {
            Type::Array { .. } => tag.element_name(first + i64::from(n)),
            _ => tag.name.clone(),
        };
        let mut add = |name: String, bank, at, ty, may_be_set| {
            places.push(Place {
                name,
                bank,
                at,
                ty,
                may_be_set,
            });
        };
        match *home {
            Home::Bits { at, first, len } => {
                (0..len).for_each(|n| add(name(n, first), "b", at.0 + n, Scalar::Bool, !tag.constant));
            }
            Home::Words { at, first, len, ty } => {
                (0..len).for_each(|n| add(name(n, first), "w", at.0 + n, ty, !tag.constant));
            }
            Home::Texts { at, first, len, max } => {
                (0..len).for_each(|n| add(name(n, first), "t", at.0 + n, Scalar::String(max), false));
            }
            Home::State { state, bits, words } => {
                let member = |member: &str| format!("{}.{member}", tag.name);
                if state.is_timer() {
                    add(member("Q"), "b", bits.0 + 1, Scalar::Bool, false);
                    add(member("ET"), "w", words.0 + 1, Scalar::Lint, false);
                } else if state.is_counter() {
                    add(member("CV"), "w", words.0 + 1, Scalar::Dint, false);
                } else {
                    add(member("Q1"), "b", bits.0, Scalar::Bool, false);
                }
            }
            Home::Borrowed(_) => {}
        }
    }
    places
}

fn value(dice: &mut Dice, ty: Scalar) -> Option<Value> {
    Some(match ty {
        Scalar::Bool => Value::Bool(dice.one_in(2)),
        Scalar::Real | Scalar::Lreal => Value::Real([0.0, 1.5, -2.25, 1000.0, 0.1_f32.into()][dice.below(5)]),
        Scalar::Time => Value::Int(dice.between(0, 50) * 1_000_000),
        _ if ty.is_integer() || ty.is_bits() => Value::Int(dice.between(0, 12)),
        _ => return None,
    })
}

fn word(value: &Value) -> String {
    match value {
        Value::Bool(high) => u8::from(*high).to_string(),
        Value::Int(number) => number.to_string(),
        Value::Real(real) => (real.to_bits() as i64).to_string(),
        Value::Text(bytes) => bytes.iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        }),
    }
}
