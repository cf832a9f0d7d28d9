//! Scenarios with the program that they are about.

use ladder_analysis::{PlantFile, analyze, link_with_plants};
use ladder_simulator::scenario::{self, Suite};
use ladder_simulator::{Options, Simulation};
use ladder_tests::project;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scenario file with its program.
pub(crate) struct Tested {
    pub(crate) file: PathBuf,
    pub(crate) suite: Suite,
    pub(crate) program: PathBuf,
    pub(crate) simulation: Simulation,
}

impl Tested {
    /// A file, with the program and the plants next to it that it names.
    pub(crate) fn read(file: PathBuf) -> Tested {
        let suite = scenario::parse(&project::read(&file));
        let (name, _) = suite.program.clone().expect("a program is named");
        let program = file.with_file_name(name);
        let text = project::read(&program);
        Tested::of(file, suite, program, &text)
    }

    /// Scenarios with the text of a program.
    pub(crate) fn of(file: PathBuf, suite: Suite, program: PathBuf, text: &str) -> Tested {
        let read = |path: &Path, text: &str| {
            let parse = Arc::new(ladder_syntax::parse(text));
            Arc::new(analyze(&parse, &path.display().to_string()))
        };
        let analysis = read(&program, text);
        let plants: Vec<PlantFile> = (suite.plants.iter())
            .map(|plant| {
                let path = file.with_file_name(&plant.file);
                PlantFile {
                    analysis: read(&path, &project::read(&path)),
                    name: plant.name.clone(),
                }
            })
            .collect();
        let connects = suite.connections();
        let (linked, errors) = link_with_plants(&analysis, &[], (&plants, &connects), &|_| None)
            .unwrap_or_else(|_| panic!("{}: {:#?}", program.display(), analysis.diagnostics()));
        assert!(errors.is_empty(), "{}: {errors:#?}", file.display());
        let options = Options {
            interval: suite
                .interval
                .map_or(Options::default().interval, |(interval, _)| interval),
            ..Options::default()
        };
        Tested {
            simulation: Simulation::new(linked.program, options).expect("it compiles"),
            file,
            suite,
            program,
        }
    }

    /// The names of the scenarios that pass; what is wrong with the others is added to `problems`.
    pub(crate) fn passed(&mut self, problems: &mut Vec<String>) -> Vec<String> {
        self.passed_by(problems, Simulation::scan)
    }

    /// The same, each scan run by `scan`.
    pub(crate) fn passed_by(
        &mut self,
        problems: &mut Vec<String>,
        mut scan: impl FnMut(&mut Simulation) -> bool,
    ) -> Vec<String> {
        let (cases, errors) = scenario::bind(&self.suite, &self.simulation);
        let (mut watched, of_properties) = scenario::bind_properties(&self.suite, &self.simulation);
        for error in self.suite.errors.iter().chain(&errors).chain(&of_properties) {
            problems.push(format!("{}: {}", self.file.display(), error.message));
        }
        let mut passed = Vec::new();
        for case in &cases {
            let ran = scenario::run(case, &mut watched, &mut self.simulation, &mut scan);
            if ran.passed() {
                passed.push(case.name.clone());
                continue;
            }
            let interval = self.simulation.options().interval;
            let drawing = scenario::draw(case, &ran, interval, 100);
            let lines: Vec<String> = drawing.into_iter().map(|line| line.text).collect();
            problems.push(format!(
                "{}: {}\n{}",
                self.file.display(),
                case.name,
                lines.join("\n")
            ));
        }
        passed
    }
}
