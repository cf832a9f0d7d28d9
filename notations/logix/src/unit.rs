//! Routines with their rungs as parts.

use crate::mnemonic::operands_in_ascii;
use crate::model::{Family, Project, Routine};
use crate::operand::{Expr, parse};
use crate::slc;
use ladder_drawings::neutral::{self, Part, Wrong};

/// A routine.
#[derive(Debug)]
pub(crate) struct Unit<'p> {
    pub(crate) scope: usize,
    pub(crate) owner: Owner,
    pub(crate) routine: &'p Routine,
    /// Its rungs, or what is wrong with them.
    pub(crate) rungs: Vec<Result<Vec<Part<'p>>, Wrong>>,
}

/// What a routine belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Owner {
    Program(usize),
    Aoi(usize),
}

impl Unit<'_> {
    /// Whether nothing is in it, in whatever language.
    pub(crate) fn is_empty(&self) -> bool {
        self.rungs.is_empty() && self.routine.foreign.is_none()
    }
}

/// All routines, those of the programs first.
pub(crate) fn units(project: &Project) -> Vec<Unit<'_>> {
    let mut units = Vec::new();
    for (number, program) in project.programs.iter().enumerate() {
        units.extend(of(1 + number, Owner::Program(number), &program.routines));
    }
    for (number, aoi) in project.aois.iter().enumerate() {
        let scope = 1 + project.programs.len() + number;
        units.extend(of(scope, Owner::Aoi(number), &aoi.routines));
    }
    units
}

fn of(scope: usize, owner: Owner, routines: &[Routine]) -> impl Iterator<Item = Unit<'_>> {
    routines.iter().map(move |routine| Unit {
        scope,
        owner,
        routine,
        rungs: routine
            .rungs
            .iter()
            .map(|rung| neutral::parse(&rung.text, &operands_in_ascii))
            .collect(),
    })
}

/// An operand as its family writes it.
pub(crate) fn operand(family: Family, text: &str) -> Result<Expr, String> {
    match family {
        Family::Logix => parse(text),
        Family::Slc => slc::operand(text),
    }
}
