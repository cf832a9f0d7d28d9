//! What two programs are compared by: what each shows to the outside, or keeps over a restart.

use ladder_analysis::program::{Role, Tag, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::compiled::{CHANNELS, Instr, Routine};
use ladder_simulator::{Point, Simulation};
use rustc_hash::FxHashSet;

/// A value that both programs have.
#[derive(Debug, Clone)]
pub(crate) struct Watched {
    pub(crate) old: Point,
    pub(crate) new: Point,
}

/// The values that are compared.
#[derive(Debug)]
pub(crate) struct Shared {
    pub(crate) watched: Vec<Watched>,
    /// Why they are not all that the programs show.
    pub(crate) untracked: Option<String>,
}

/// Finds what both programs show.
///
/// # Errors
/// A tag has another type in the new program, or there is nothing to compare.
pub(crate) fn shared(old: &Simulation, new: &Simulation) -> Result<Shared, String> {
    let mut untracked = None;
    let mut watched = Vec::new();
    let mut seen: FxHashSet<String> = FxHashSet::default();
    for simulation in [old, new] {
        for point in shown(simulation) {
            if !seen.insert(point.name.to_ascii_lowercase()) {
                continue;
            }
            let (Ok(was), Ok(is)) = (old.resolve(&point.name), new.resolve(&point.name)) else {
                continue;
            };
            if was.ty != is.ty {
                return Err(format!("{} is declared differently", point.name));
            }
            if matches!(point.ty, Scalar::String(_)) {
                untracked.get_or_insert_with(|| format!("texts are not tracked, as in {}", point.name));
            } else {
                watched.push(Watched { old: was, new: is });
            }
        }
        if sends(simulation) {
            untracked.get_or_insert_with(|| String::from("what is sent is not tracked"));
        }
    }
    if watched.is_empty() {
        return Err(untracked.unwrap_or_else(|| String::from("the programs have no output in common")));
    }
    Ok(Shared { watched, untracked })
}

/// Whether it sends something through the serial port.
fn sends(simulation: &Simulation) -> bool {
    let mut instrs = simulation.compiled().code.instrs.iter();
    instrs.any(|instr| {
        matches!(
            instr,
            Instr::Routine {
                routine: Routine::Send | Routine::SendText,
                ..
            }
        )
    })
}

/// What a program shows to the outside, or keeps over a restart.
fn shown(simulation: &Simulation) -> Vec<Point> {
    let program = simulation.program();
    let retained = simulation.compiled().retained.iter();
    let retained: FxHashSet<&str> = retained.map(|retained| retained.name.as_str()).collect();
    let ids = (0..).map(TagId).zip(&program.tags);
    let ids = ids.filter(|(_, tag)| is_shown(tag) || (tag.block.is_none() && retained.contains(&*tag.name)));
    let mut points: Vec<Point> = ids.flat_map(|(id, _)| simulation.in_table(id)).collect();
    for port in ["DUTY", "FREQUENCY"] {
        let channels = (0..CHANNELS).map(|n| simulation.resolve(&format!("PORT.{port}[{n}]")));
        points.extend(channels.flatten());
    }
    points
}

fn is_shown(tag: &Tag) -> bool {
    let is_value = !matches!(tag.ty, Type::State(_) | Type::Compound(_));
    let is_fixed = tag.constant || tag.block.is_some() || tag.role == Role::Input;
    !is_fixed && (tag.role == Role::Output || (tag.shared && is_value))
}
