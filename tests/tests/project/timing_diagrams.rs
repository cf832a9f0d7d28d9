//! The timing diagrams that people see of timers are what the simulator does.
//!
//! A diagram has the rows EN, perhaps R, Q and ET, one column for each scan, and says how many columns PT is.

use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_instructions::{Instruction, TABLE};
use ladder_simulator::{Options, Simulation};
use ladder_syntax::parse;
use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;

#[test]
fn timers_do_what_their_diagrams_show() {
    let mut seen = 0;
    for row in TABLE {
        let Some(diagram) = Diagram::of(row) else {
            continue;
        };
        assert_eq!(diagram.played(row), diagram.text, "{}", row.signature());
        seen += 1;
    }
    assert!(seen >= 5, "only {seen} diagrams were found");
}

struct Diagram {
    text: &'static str,
    /// The preset, in columns.
    preset: u32,
    rows: HashMap<&'static str, &'static str>,
}

impl Diagram {
    fn of(row: &Instruction) -> Option<Diagram> {
        let (_, rest) = row.doc.split_once("```text\nPT = ")?;
        let (text, _) = rest.split_once("\n```")?;
        let (preset, lines) = text.split_once(" columns\n")?;
        Some(Diagram {
            text: lines,
            preset: preset.parse().ok()?,
            rows: lines.lines().filter_map(|line| line.split_once(' ')).collect(),
        })
    }

    /// The diagram as the simulator draws it: inputs as they are, Q and ET as they come.
    fn played(&self, row: &Instruction) -> String {
        let mut simulation = simulation(row, self.preset);
        let input = |name| self.rows.get(name).map(|levels: &&str| levels.trim().chars());
        let (power, mut reset) = (input("EN").expect("a row EN"), input("R"));
        let (mut q, mut elapsed) = (String::new(), String::new());
        for level in power {
            set(&mut simulation, "en", level);
            if let Some(level) = reset.as_mut().and_then(Iterator::next) {
                set(&mut simulation, "r", level);
            }
            simulation.scan();
            q.push(if value(&simulation, "q") == Value::Bool(true) {
                '-'
            } else {
                '_'
            });
            let Value::Int(time) = value(&simulation, "t.ET") else {
                panic!("ET is a TIME");
            };
            // Writing to a String does not fail.
            let _ = write!(elapsed, "{}", time / Options::default().interval);
        }
        let rows: Vec<String> = self
            .text
            .lines()
            .map(|line| match line.split_once(' ') {
                Some(("Q", _)) => format!("Q    {q}"),
                Some(("ET", _)) => format!("ET   {elapsed}"),
                _ => line.to_owned(),
            })
            .collect();
        rows.join("\n")
    }
}

/// The timer alone on a rung.
fn simulation(row: &Instruction, preset: u32) -> Simulation {
    let milliseconds = 10 * preset;
    let program = format!(
        "+--[ ]( en )--[{}]( t, {milliseconds}ms, R := r )--( )( q )--+\n",
        row.mnemonic
    );
    let analysis = analyze(&Arc::new(parse(&program)), "timer");
    let program = analysis.program().cloned().expect("no errors");
    Simulation::new(program, Options::default()).expect("a timer runs")
}

fn set(simulation: &mut Simulation, tag: &str, level: char) {
    let point = simulation.resolve(tag).expect("a tag of the program");
    simulation
        .set(&point, Value::Bool(level == '-'))
        .expect("an input");
}

fn value(simulation: &Simulation, tag: &str) -> Value {
    let point = simulation.resolve(tag).expect("a tag of the program");
    simulation.value(&point)
}
