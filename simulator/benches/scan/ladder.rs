//! The program in the simulator.

use crate::sketch::{Dice, Sketch, Type};
use crate::{BATCHES, Run};
use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Options, Simulation};
use std::fmt::Write;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A program that runs in the simulator.
pub(crate) struct Ladder {
    simulation: Simulation,
    /// From the text to the program model.
    pub(crate) analysed_in: Duration,
    /// From the program model to its first scan.
    pub(crate) compiled_in: Duration,
}

impl Ladder {
    pub(crate) fn new(sketch: &Sketch) -> Ladder {
        let text = text(sketch);
        let begin = Instant::now();
        let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "bench.clad");
        let Some(program) = analysis.program().cloned() else {
            panic!("errors in the program: {:?}", analysis.diagnostics().first());
        };
        let analysed_in = begin.elapsed();
        let begin = Instant::now();
        let options = Options {
            watchdog: u64::MAX,
            ..Options::default()
        };
        let simulation = Simulation::new(program, options).expect("there is memory");
        Ladder {
            compiled_in: begin.elapsed(),
            simulation,
            analysed_in,
        }
    }

    /// Runs batches of so many scans. In each scan one input changes.
    pub(crate) fn run(&mut self, sketch: &Sketch, scans: u64) -> Run {
        let points: Vec<_> = sketch
            .inputs
            .iter()
            .map(|&input| {
                self.simulation
                    .resolve(&sketch.tags[input].name)
                    .expect("it is a tag")
            })
            .collect();
        let mut dice = Dice(7);
        let mut high = vec![false; points.len()];
        let mut fastest = Duration::MAX;
        for _ in 0..BATCHES {
            let begin = Instant::now();
            for _ in 0..scans {
                let input = dice.roll(points.len());
                high[input] = !high[input];
                let taken = self.simulation.set(&points[input], Value::Bool(high[input]));
                taken.expect("a BOOL takes a BOOL");
                assert!(self.simulation.scan());
            }
            fastest = fastest.min(begin.elapsed() / scans as u32);
        }
        Run {
            scan: fastest,
            state: self.state(sketch),
        }
    }

    /// How many parts of the drawing carry power.
    pub(crate) fn elements(&self) -> usize {
        self.simulation.power().count()
    }

    /// How long it takes to ask for the power of all of them.
    pub(crate) fn show_all_power(&self) -> Duration {
        let begin = Instant::now();
        black_box(self.simulation.power().filter(|&(_, _, live)| live).count());
        begin.elapsed()
    }

    /// What all tags hold, as the C sums it up.
    fn state(&self, sketch: &Sketch) -> u64 {
        let mut hash = 14_695_981_039_346_656_037u64;
        let mut show = |tag: &str| {
            let point = self.simulation.resolve(tag).expect("it is a tag");
            let word = match self.simulation.value(&point) {
                Value::Bool(high) => u64::from(high),
                Value::Int(number) => number as u64,
                Value::Real(real) => real.to_bits(),
                Value::Text(_) => 0,
            };
            hash = (hash ^ word).wrapping_mul(1_099_511_628_211);
        };
        for tag in &sketch.tags {
            let name = &tag.name;
            match tag.ty {
                Type::Bool | Type::Dint | Type::Lreal => show(name),
                Type::Ton | Type::Tof => [".Q", ".ET"]
                    .iter()
                    .for_each(|member| show(&format!("{name}{member}"))),
                Type::Ctu => [".Q", ".CV"]
                    .iter()
                    .for_each(|member| show(&format!("{name}{member}"))),
            }
        }
        hash
    }
}

fn text(sketch: &Sketch) -> String {
    let mut text = String::new();
    let is_input = |n: &usize| sketch.inputs.binary_search(n).is_ok();
    for (header, inputs) in [("VAR_INPUT", true), ("VAR", false)] {
        text.push_str(header);
        text.push('\n');
        for (_, tag) in sketch
            .tags
            .iter()
            .enumerate()
            .filter(|(n, _)| is_input(n) == inputs)
        {
            let _ = writeln!(text, "    {} : {};", tag.name, tag.ty.name());
        }
        text.push_str("END_VAR\n");
    }
    text.push_str(&sketch.drawing);
    text
}
