//! What two programs are compared by: what each shows to the outside, or keeps over a restart.

use crate::divergence::Which;
use ladder_analysis::program::{Role, Tag, TagId};
use ladder_analysis::values::types::Type;
use ladder_simulator::compiled::{CHANNELS, Instr, Routine};
use ladder_simulator::{Point, Simulation};
use rustc_hash::{FxHashMap, FxHashSet};

/// A value that both programs have.
#[derive(Debug, Clone)]
pub(crate) struct Watched {
    pub(crate) old: Point,
    pub(crate) new: Point,
}

/// Tags at direct addresses that have other names in the new program: these, by their names in the old one.
#[derive(Debug, Default)]
pub(crate) struct Renamed {
    new_of: FxHashMap<String, String>,
}

impl Renamed {
    /// Finds them.
    ///
    /// # Errors
    /// A tag is at another address.
    fn of(old: &Simulation, new: &Simulation) -> Result<Renamed, String> {
        let tags = |simulation: &Simulation, name: fn(&Tag) -> Option<&str>| -> FxHashMap<String, Tag> {
            let tags = simulation.program().tags.iter().filter(|tag| tag.block.is_none());
            tags.filter_map(|tag| Some((name(tag)?.to_ascii_lowercase(), tag.clone())))
                .collect()
        };
        let by_name = tags(new, |tag| Some(&tag.name));
        let by_address = tags(new, |tag| tag.address.as_deref());
        let mut renamed = Renamed::default();
        for (name, was) in tags(old, |tag| Some(&tag.name)) {
            if let Some(is) = by_name.get(&name) {
                if is.address != was.address {
                    return Err(format!("{} is at another address", was.name));
                }
                continue;
            }
            let address = was.address.map(|address| address.to_ascii_lowercase());
            if let Some(is) = address.and_then(|address| by_address.get(&address)) {
                renamed.new_of.insert(name, is.name.clone());
            }
        }
        Ok(renamed)
    }

    /// The name in the new program of a tag of the old one.
    pub(crate) fn now<'n>(&'n self, name: &'n str) -> &'n str {
        self.new_of
            .get(&name.to_ascii_lowercase())
            .map_or(name, String::as_str)
    }

    /// The names in the old program by those in the new one, in lower case.
    pub(crate) fn formerly(&self) -> FxHashMap<String, String> {
        let names = self.new_of.iter();
        names
            .map(|(was, is)| (is.to_ascii_lowercase(), was.clone()))
            .collect()
    }
}

/// The values that are compared.
#[derive(Debug, Default)]
pub(crate) struct Shared {
    pub(crate) watched: Vec<Watched>,
    /// Why they are not all that the programs show.
    pub(crate) untracked: Option<String>,
    pub(crate) renamed: Renamed,
}

/// Finds what both programs show; of two that show nothing all tags that both have.
///
/// # Errors
/// A tag has another type in the new program, or there is nothing to compare.
pub(crate) fn shared(old: &Simulation, new: &Simulation) -> Result<Shared, String> {
    let renamed = Renamed::of(old, new)?;
    let mut shared = of_both((old, new), &renamed, is_shown)?;
    if shared.watched.is_empty() && shared.untracked.is_none() {
        shared = of_both((old, new), &renamed, |tag| {
            is_value(tag) && tag.role != Role::Input
        })?;
    }
    shared.renamed = renamed;
    if let Some(name) = kept_by_one(old, new) {
        let why = format!("{name} is kept over a restart in one of them only");
        shared.untracked.get_or_insert(why);
    }
    if [old, new].into_iter().any(sends) {
        let why = || String::from("what is sent is not tracked");
        shared.untracked.get_or_insert_with(why);
    }
    match shared {
        shared if shared.watched.is_empty() => {
            let why = || String::from("the programs have no output in common");
            Err(shared.untracked.unwrap_or_else(why))
        }
        shared => Ok(shared),
    }
}

fn of_both(
    (old, new): (&Simulation, &Simulation),
    renamed: &Renamed,
    is_compared: impl Fn(&Tag) -> bool,
) -> Result<Shared, String> {
    let mut shared = Shared::default();
    let mut seen: FxHashSet<String> = FxHashSet::default();
    let formerly = renamed.formerly();
    for simulation in [old, new] {
        for point in points(simulation, &is_compared) {
            let name = point.name.to_ascii_lowercase();
            let name = formerly.get(&name).cloned().unwrap_or(name);
            if !seen.insert(name.clone()) {
                continue;
            }
            let (Ok(was), Ok(is)) = (old.resolve(&name), new.resolve(renamed.now(&name))) else {
                continue;
            };
            if was.ty != is.ty {
                return Err(format!("{} is declared differently", point.name));
            }
            if point.ty.is_string() {
                let why = || format!("texts are not tracked, as in {}", point.name);
                shared.untracked.get_or_insert_with(why);
            } else {
                shared.watched.push(Watched { old: was, new: is });
            }
        }
    }
    Ok(shared)
}

/// The outputs that only one of two programs has.
pub(crate) fn outputs_of_one(old: &Simulation, new: &Simulation) -> Vec<(Which, String)> {
    let mut found = Vec::new();
    let renamed = Renamed::of(old, new).unwrap_or_default();
    let formerly = renamed.formerly();
    for (which, simulation, other) in [(Which::Old, old, new), (Which::New, new, old)] {
        let outputs = points(simulation, &|tag: &Tag| tag.role == Role::Output && is_shown(tag));
        let there = |name: &str| match which {
            Which::Old => renamed.now(name).to_owned(),
            Which::New => {
                let was = formerly.get(&name.to_ascii_lowercase());
                was.map_or(name, String::as_str).to_owned()
            }
        };
        let missing = outputs
            .into_iter()
            .filter(|point| other.resolve(&there(&point.name)).is_err());
        found.extend(missing.map(|point| (which, point.name)));
    }
    found
}

fn retained(simulation: &Simulation) -> FxHashSet<&str> {
    let retained = simulation.compiled().retained.iter();
    retained.map(|retained| retained.name.as_str()).collect()
}

/// A tag of both programs that one of them keeps over a restart.
fn kept_by_one(old: &Simulation, new: &Simulation) -> Option<String> {
    let (was, is) = (retained(old), retained(new));
    let tags = new.program().tags.iter().filter(|tag| tag.block.is_none());
    let mut tags = tags.filter(|tag| was.contains(&*tag.name) != is.contains(&*tag.name));
    let is_in_both = |tag: &&Tag| old.program().tags.iter().any(|other| other.name == tag.name);
    tags.find(is_in_both).map(|tag| tag.name.clone())
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

/// The values of tags that are compared, of those that are kept over a restart, and of ports.
fn points(simulation: &Simulation, is_compared: &dyn Fn(&Tag) -> bool) -> Vec<Point> {
    let retained = retained(simulation);
    let is_kept = |tag: &Tag| tag.block.is_none() && retained.contains(&*tag.name);
    let ids = (0..).map(TagId).zip(&simulation.program().tags);
    let ids = ids.filter(|(_, tag)| is_compared(tag) || is_kept(tag));
    let mut points: Vec<Point> = ids.flat_map(|(id, _)| simulation.in_table(id)).collect();
    for port in ["DUTY", "FREQUENCY"] {
        let channels = (0..CHANNELS).map(|n| simulation.resolve(&format!("PORT.{port}[{n}]")));
        points.extend(channels.flatten());
    }
    points
}

/// Whether it is an elementary tag, or an array of such.
fn is_value(tag: &Tag) -> bool {
    !matches!(tag.ty, Type::State(_) | Type::Compound(_)) && !tag.constant && tag.block.is_none()
}

/// Whether a tag is shown to the outside.
fn is_shown(tag: &Tag) -> bool {
    let is_fixed = tag.constant || tag.block.is_some() || tag.role == Role::Input;
    !is_fixed && (tag.role == Role::Output || (tag.shared && is_value(tag)))
}
