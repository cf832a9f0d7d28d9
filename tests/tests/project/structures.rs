//! Tags become a structure and come back, and the states of blocks get tags, in every program that has scenarios: the
//! examples, those of the library, and those of all instructions. The scenarios follow, and hold afterwards.

use crate::tested::Tested;
use ladder_analysis::context::Context;
use ladder_analysis::{Analysis, analyze};
use ladder_format::{Options, apply};
use ladder_ide::{Action, ScenarioFile, Which, Workspace, refactorings};
use ladder_simulator::scenario;
use ladder_syntax::{TextRange, TextSize, parse};
use ladder_tests::project;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// A program and its scenarios.
#[derive(Clone)]
struct Pair {
    program: String,
    scenarios: String,
}

/// The program is asked about; its scenarios are next to it.
struct NextTo<'p>(&'p Pair);

impl Workspace for NextTo<'_> {
    fn file(&self, _: &str) -> Option<Arc<Context>> {
        None
    }

    fn show(&self, _: Which<'_>, _: &(dyn Fn(usize, &Arc<Context>) + Sync)) {}

    fn scenarios(&self) -> Vec<ScenarioFile> {
        vec![ScenarioFile {
            name: "scenarios".into(),
            program: Some("program".into()),
            text: self.0.scenarios.clone(),
            suite: Arc::new(scenario::parse(&self.0.scenarios)),
        }]
    }
}

impl Pair {
    fn analysis(&self) -> Analysis {
        analyze(&Arc::new(parse(&self.program)), "program")
    }

    /// What the first action makes of it whose title begins so, where it is offered for a range. None: it is not.
    fn after(&self, analysis: &Analysis, begin: &str, range: TextRange) -> Option<Pair> {
        let is_it = |action: &Action| action.title.starts_with(begin) && action.disabled.is_none();
        let action = refactorings(analysis, range).into_iter().find(is_it)?;
        let mut after = self.clone();
        for changed in action.everywhere(analysis, &self.program, &Options::default(), &NextTo(self)) {
            let text = match &*changed.file {
                "program" => &mut after.program,
                _ => &mut after.scenarios,
            };
            *text = apply(text, &changed.edits);
        }
        Some(after)
    }

    /// How many scenarios pass; what is wrong with the others is added.
    fn passed(&self, file: &Path, problems: &mut Vec<String>) -> usize {
        let suite = scenario::parse(&self.scenarios);
        let name = file.with_extension("clad");
        Tested::of(file.to_owned(), suite, name, &self.program)
            .passed(problems)
            .len()
    }
}

/// The ranges of all sections of declarations.
fn sections(analysis: &Analysis) -> Vec<TextRange> {
    let parse = &analysis.context.parse;
    let structure = parse.structure();
    let lines = structure.sections.iter().map(|section| section.lines.clone());
    lines
        .map(|lines| {
            TextRange::new(
                parse.line_start(lines.start),
                parse.line_range(lines.end - 1).end(),
            )
        })
        .collect()
}

fn starts_of_blocks(analysis: &Analysis) -> Vec<TextRange> {
    let networks = analysis.context.networks.iter();
    let blocks = networks.flat_map(ladder_analysis::networks::NetworkAt::blocks);
    let users = blocks.filter(|block| block.user_name().is_some());
    users
        .map(|block| TextRange::empty(block.range().start() + TextSize::new(1)))
        .collect()
}

/// Does an action at one place, and runs the scenarios.
fn holds_after(
    pair: &Pair,
    file: &Path,
    begin: &str,
    range: TextRange,
    done: &mut BTreeMap<String, usize>,
) -> Option<Pair> {
    let after = pair.after(&pair.analysis(), begin, range)?;
    *done.entry(begin.to_owned()).or_default() += 1;
    let mut problems = Vec::new();
    let before = pair.passed(file, &mut problems);
    let shown = || {
        format!(
            "{}: {begin} at {range:?}\n{}\n{}",
            file.display(),
            after.program,
            after.scenarios
        )
    };
    assert_eq!(
        after.passed(file, &mut problems),
        before,
        "{problems:#?}\n{}",
        shown()
    );
    assert!(problems.is_empty(), "{problems:#?}\n{}", shown());
    Some(after)
}

#[test]
fn scenarios_hold_after_every_change() {
    let mut done = BTreeMap::new();
    for folder in ["examples", "library/scenarios", "tests/instructions"] {
        for file in project::files(&project::root().join(folder), "ladder-test") {
            let scenarios = project::read(&file);
            let suite = scenario::parse(&scenarios);
            if !suite.plants.is_empty() {
                // A plant finds the program's tags by their names, and these change.
                continue;
            }
            let (name, _) = suite.program.expect("a program is named");
            let pair = Pair {
                program: project::read(&file.with_file_name(name)),
                scenarios,
            };
            let analysis = pair.analysis();
            for range in sections(&analysis) {
                let Some(after) = holds_after(&pair, &file, "Extract", range, &mut done) else {
                    continue;
                };
                // The new tag is what is declared by a type that was not there.
                let at = sections(&after.analysis()).into_iter().find_map(|section| {
                    let lines = after.program[section].split_inclusive('\n');
                    let mut start = section.start();
                    for line in lines {
                        let name = line.len() - line.trim_start().len();
                        let place = TextRange::empty(start + TextSize::new(name as u32));
                        let back = after.after(&after.analysis(), "Replace", place);
                        if back.is_some() && !pair.program.contains(line.trim()) {
                            return Some(place);
                        }
                        start += TextSize::of(line);
                    }
                    None
                });
                if let Some(at) = at {
                    holds_after(&after, &file, "Replace", at, &mut done);
                }
            }
            for range in starts_of_blocks(&analysis) {
                holds_after(&pair, &file, "Give the state", range, &mut done);
            }
        }
    }
    println!("{done:?}");
    for (begin, least) in [("Extract", 20), ("Replace", 20), ("Give the state", 10)] {
        assert!(done.get(begin).is_some_and(|done| *done >= least), "{done:?}");
    }
}
