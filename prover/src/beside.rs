//! Proofs beside plants (LANGUAGE §9): a statement about a model of the machine says which, and whether any machine would do.

use crate::answer::{Answer, Options, Verdict, prove};
use ladder_analysis::program::Program;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::Simulation;
use ladder_simulator::expression::Expression;
use ladder_simulator::scenario::{Form, Monitor, Suite, Watched, bind_properties, parse};
use ladder_syntax::numeral::counted;
use std::sync::Arc;

/// What answers rest on: the plants that run beside the program, and what is assumed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Basis {
    /// The files of the plants, as the scenarios name them.
    pub plants: Vec<String>,
    /// How many assumptions there are.
    pub assumptions: usize,
    /// The outputs of plants that never change: what is proved with them is about a machine that does nothing.
    pub unchanging: Vec<String>,
}

/// So many steps of the solver it is tried whether something holds without the plants, and as many whether their outputs change: about
/// half a second. What is told must not depend on what else the machine does.
const TRIED_STEPS: u64 = 200_000;
/// So many scans are searched then.
const TRIED_SCANS: usize = 30;

impl Basis {
    /// What the answers about the properties of a file rest on. Of what is proved it is tried whether it holds without the plants.
    pub fn of(
        suite: &Suite,
        simulation: &Simulation,
        watched: &Watched,
        answers: &mut [Answer],
        options: &Options,
    ) -> Basis {
        if simulation.program().plants.is_empty() {
            return Basis::default();
        }
        let options = Options {
            steps: Some(TRIED_STEPS),
            scans: TRIED_SCANS,
            ..options.clone()
        };
        note_without_plants(suite, simulation, watched, answers, &options);
        Basis {
            plants: suite.plants.iter().map(|plant| plant.file.clone()).collect(),
            assumptions: suite.assumptions.len(),
            unchanging: unchanging(suite, simulation, &options),
        }
    }

    /// The words after those of an answer: `with tank.clad and 2 assumptions`. Nothing where there is no plant.
    pub fn told(&self, answer: &Answer) -> String {
        if self.plants.is_empty() {
            return String::new();
        }
        if answer.needs_plant == Some(false) {
            return "does not need the plant".to_owned();
        }
        let plants = self.plants.join(", ");
        match self.assumptions {
            0 => format!("with {plants}"),
            some => format!("with {plants} and {}", counted(some, "assumption")),
        }
    }
}

fn names_plant(program: &Program, expression: &Expression) -> bool {
    let mut found = false;
    expression.for_each_point(&mut |point| found |= program.plant_of(&point.name).is_some());
    found
}

/// Tries what is proved once more with inputs that anything may drive, unless it is about the plant.
fn note_without_plants(
    suite: &Suite,
    simulation: &Simulation,
    watched: &Watched,
    answers: &mut [Answer],
    options: &Options,
) {
    let program = simulation.program();
    let is_asked = |(monitor, answer): &(&Monitor, &mut Answer)| {
        matches!(answer.verdict, Verdict::Proved(_))
            && !matches!(monitor.form, Form::NoFaults)
            && !monitor
                .points()
                .iter()
                .any(|point| program.plant_of(&point.name).is_some())
    };
    let mut asked: Vec<(&Monitor, &mut Answer)> =
        watched.properties.iter().zip(answers).filter(is_asked).collect();
    for (_, answer) in &mut asked {
        answer.needs_plant = Some(true);
    }
    let assumptions = suite.assumptions.iter().zip(&watched.assumptions);
    let assumptions = assumptions.filter(|(_, bound)| !names_plant(program, bound));
    let properties = suite.properties.iter();
    let properties =
        properties.filter(|property| asked.iter().any(|(monitor, _)| monitor.name == property.name));
    let suite = Suite {
        assumptions: assumptions.map(|(written, _)| written.clone()).collect(),
        properties: properties.cloned().collect(),
        ..suite.clone()
    };
    let Ok(mut alone) = Simulation::new(without_plants(program), simulation.options()) else {
        return;
    };
    let (mut watched, errors) = bind_properties(&suite, &alone);
    if asked.is_empty() || !errors.is_empty() {
        return;
    }
    let Ok(found) = prove(&mut alone, &mut watched, options.clone()) else {
        return;
    };
    for (monitor, found) in watched.properties.iter().zip(found) {
        if matches!(found.verdict, Verdict::Proved(_)) {
            let asked = asked.iter_mut().filter(|(asked, _)| asked.name == monitor.name);
            asked.for_each(|(_, answer)| answer.needs_plant = Some(false));
        }
    }
}

/// A program of which anything drives the inputs that its plants drive.
fn without_plants(program: &Program) -> Arc<Program> {
    let mut alone = program.clone();
    for plant in std::mem::take(&mut alone.plants) {
        for connection in plant.outputs {
            alone.tags[connection.to.0 as usize].is_input = true;
        }
    }
    alone.wiring = 0..0;
    Arc::new(alone)
}

/// The connected outputs of plants that are after each scan what they were after the first.
fn unchanging(suite: &Suite, simulation: &Simulation, options: &Options) -> Vec<String> {
    let program = simulation.program();
    let outputs = program.plants.iter().flat_map(|plant| &plant.outputs);
    let outputs = outputs.map(|connection| &program.tags[connection.from.0 as usize]);
    let asked = outputs.filter_map(|tag| {
        let name = &tag.name;
        match tag.ty {
            Type::Scalar(Scalar::Bool) => Some((
                name,
                format!("never not SYS.FIRST_SCAN and (rises({name}) or falls({name}))"),
            )),
            Type::Scalar(ty) if !ty.is_string() => {
                Some((name, format!("always SYS.FIRST_SCAN or {name} = was({name})")))
            }
            _ => None,
        }
    });
    let asked: Vec<(&String, String)> = asked.collect();
    let forms: Vec<&str> = asked.iter().map(|(_, form)| form.as_str()).collect();
    let suite = Suite {
        assumptions: suite.assumptions.clone(),
        ..parse(&forms.join("\n"))
    };
    let (mut watched, errors) = bind_properties(&suite, simulation);
    let Ok(mut again) = Simulation::new(Arc::clone(program), simulation.options()) else {
        return Vec::new();
    };
    if asked.is_empty() || !errors.is_empty() || watched.properties.len() != asked.len() {
        return Vec::new();
    }
    let Ok(found) = prove(&mut again, &mut watched, options.clone()) else {
        return Vec::new();
    };
    let still = asked.iter().zip(found);
    still
        .filter(|(_, answer)| matches!(answer.verdict, Verdict::Proved(_)))
        .map(|((name, _), _)| (*name).clone())
        .collect()
}
