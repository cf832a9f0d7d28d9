//! Scenarios are the unit tests of programs: every example has some, and so has every instruction.
//!
//! `tests/instructions/` has a program for each section of the table of instructions, and next to it the scenarios of
//! its rows. A scenario is about the row whose block its name begins with: `[TON] delays the rise`.

use crate::tested::Tested;
use ladder_analysis::program::{BlockKind, Program};
use ladder_instructions::{Op, TABLE};
use ladder_tests::project;
use std::collections::{BTreeSet, HashSet};
use std::path::{Path, PathBuf};

fn ops(program: &Program) -> impl Iterator<Item = Op> + '_ {
    let blocks = program.networks.iter().flat_map(|network| &network.blocks);
    blocks.filter_map(|block| match block.kind {
        BlockKind::Instruction(row) => Some(row.op),
        BlockKind::User(_) => None,
    })
}

fn scenario_files(folder: &Path) -> Vec<Tested> {
    let files = project::files(folder, "ladder-test");
    files.into_iter().map(Tested::read).collect()
}

#[test]
fn every_instruction_has_a_scenario() {
    let mut problems = Vec::new();
    let mut shown: HashSet<(Op, String)> = HashSet::new();
    for mut tested in scenario_files(&project::root().join("tests/instructions")) {
        let passed = tested.passed(&mut problems);
        let used: BTreeSet<Op> = ops(tested.simulation.program()).collect();
        for row in TABLE.iter().filter(|row| used.contains(&row.op)) {
            let block = row.block();
            if passed.iter().any(|name| name.starts_with(&block)) {
                shown.insert((row.op, block));
            }
        }
    }
    for row in TABLE {
        if !shown.contains(&(row.op, row.block())) {
            problems.push(format!(
                "{} has no scenario in tests/instructions whose name begins with {}",
                row.signature(),
                row.block()
            ));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}

#[test]
fn every_example_has_scenarios() {
    let folder = project::root().join("examples");
    let mut problems = Vec::new();
    let mut tested: BTreeSet<PathBuf> = BTreeSet::new();
    for mut example in scenario_files(&folder) {
        if !example.passed(&mut problems).is_empty() {
            let plants = example.suite.plants.iter();
            tested.extend(plants.map(|plant| example.file.with_file_name(&plant.file)));
            tested.insert(example.program);
        }
    }
    for program in project::files(&folder, "clad") {
        if !tested.contains(&program) {
            problems.push(format!("{} has no scenarios", program.display()));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}
