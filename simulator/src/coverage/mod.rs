//! Coverage: which parts of a program its scenarios have exercised.
//!
//! A network is exercised when a scan has reached it; a contact or comparison when power has come to it and it has
//! both let it through (closed) and held it back (open); a coil when it has been with power and without. What is
//! recorded is the power after each scan. Where code may run several times in one, in a loop or a function, the scan
//! halts after each turn, and each counts.
//!
//! Recording is cheap because it looks only at what has changed and is still to be seen: a contact that was seen both
//! ways is not asked again.

mod watch;

use crate::code::ElementPlace;
use crate::simulation::Simulation;
use ladder_analysis::program::{BlockKind, ElementKind, Location, Network, Step};
use ladder_instructions::{Group, Op, Power};
use std::collections::HashMap;
use watch::Watch;

/// What a part of a program is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CoverageItemKind {
    /// A contact, or an edge.
    Contact,
    /// A comparison.
    Comparison,
    /// A coil.
    Coil,
}

/// A contact, comparison or coil, and how it was seen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CoverageItem {
    /// What it is.
    pub kind: CoverageItemKind,
    /// Where it is.
    pub location: Location,
    /// It was seen closed; a coil with power.
    pub on: bool,
    /// It was seen open; a coil without power, or it is one that can never be without.
    pub off: bool,
    /// The element whose power comes to it, and the one that carries what leaves it.
    input: Option<u32>,
    output: u32,
}

impl CoverageItem {
    /// It was seen both ways.
    pub(crate) fn is_exercised(&self) -> bool {
        self.on && self.off
    }
}

/// A network, and how often it was reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NetworkScans {
    /// From its first rung to its last.
    pub location: Location,
    /// Places on its rungs: each rung has at least one.
    pub elements: Vec<Location>,
    /// How many scans have reached it.
    pub scans: u64,
    index: usize,
}

/// How the scans are run that are observed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Runs {
    /// Straight through: no network runs twice in a scan.
    Through,
    /// With a halt where code may run a second time.
    ByTurns,
}

/// What has been seen of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coverage {
    /// Names of the program's files.
    pub files: Vec<String>,
    /// All networks, in the order of the program.
    pub networks: Vec<NetworkScans>,
    /// All contacts, comparisons and coils, in the order of the program.
    pub parts: Vec<CoverageItem>,
    runs: Runs,
    watch: Watch,
    /// Networks that some scans may not reach.
    skippable: Vec<u32>,
    /// How many scans were observed since the last check of the networks that every scan reaches.
    scans: u64,
}

impl Coverage {
    /// Nothing has been seen yet.
    pub fn of(simulation: &mut Simulation) -> Coverage {
        let runs = if simulation.mark_turns() {
            Runs::ByTurns
        } else {
            Runs::Through
        };
        let simulation = &*simulation;
        let program = simulation.program();
        let elements = simulation.elements();
        let mut carriers: HashMap<(u32, u32), u32> = HashMap::new();
        for (index, element) in elements.iter().enumerate() {
            carriers
                .entry((element.network, element.step))
                .or_insert(index as u32);
        }
        let has_mcr = (program.networks.iter())
            .flat_map(|network| &network.blocks)
            .any(|block| matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::Mcr));
        let always: Vec<Vec<bool>> = if has_mcr {
            Vec::new()
        } else {
            program.networks.iter().map(always_powered).collect()
        };
        // What scenarios are to exercise is the program, and not its machine.
        let is_covered = |number: usize| {
            let file = program.networks[number].location.file;
            let is_of_plant = program.plants.iter().any(|plant| plant.file == file);
            !is_of_plant && !program.wiring.contains(&number)
        };
        let part = |(index, element): (usize, &ElementPlace)| {
            let network = &program.networks[element.network as usize];
            let Step::Block { block, en } = network.steps[element.step as usize] else {
                return None;
            };
            let kind = kind(network.blocks[block].kind)?;
            let is_on = always
                .get(element.network as usize)
                .is_some_and(|steps| steps[en]);
            Some(CoverageItem {
                kind,
                location: element.location,
                on: false,
                off: is_on && kind == CoverageItemKind::Coil,
                input: carriers.get(&(element.network, en as u32)).copied(),
                output: index as u32,
            })
        };
        let mut parts: Vec<CoverageItem> = elements
            .iter()
            .enumerate()
            .filter(|(_, element)| element.kind == ElementKind::Block && is_covered(element.network as usize))
            .filter_map(part)
            .collect();
        parts.sort_by_key(|part| (part.location.file, part.location.range.start()));
        let networks: Vec<NetworkScans> = program
            .networks
            .iter()
            .enumerate()
            .filter(|(index, _)| is_covered(*index))
            .map(|(index, network)| NetworkScans {
                location: network.location,
                elements: network
                    .elements
                    .iter()
                    .map(|element| Location {
                        file: network.location.file,
                        range: element.range,
                    })
                    .collect(),
                scans: 0,
                index,
            })
            .collect();
        Coverage {
            files: program.files.clone(),
            runs,
            watch: Watch::of(
                simulation,
                runs,
                parts.iter().enumerate().map(|(index, part)| {
                    let place = |element: u32| &elements[element as usize];
                    let places = [part.input.map(place), Some(place(part.output))];
                    (index as u32, places)
                }),
            ),
            skippable: (0..networks.len())
                .filter(|&at| simulation.is_skippable(networks[at].index))
                .map(|at| at as u32)
                .collect(),
            networks,
            parts,
            scans: 0,
        }
    }

    /// Runs a scan, as [`Simulation::scan`] does, and observes it. The simulation must be the one that this was made for.
    pub fn scan(&mut self, simulation: &mut Simulation) -> bool {
        let (parts, watch) = (&mut self.parts, &mut self.watch);
        let has_run = match self.runs {
            Runs::Through => simulation.scan(),
            Runs::ByTurns => simulation.scan_by_turns(|simulation| {
                watch.within_scan(|index| see(&mut parts[index as usize], simulation));
            }),
        };
        if !has_run {
            return false;
        }
        self.scans += 1;
        for &index in &self.skippable {
            let network = &mut self.networks[index as usize];
            network.scans += u64::from(simulation.has_reached(network.index));
        }
        watch.changed(simulation, |index| see(&mut parts[index as usize], simulation));
        true
    }

    /// Counts the scans of the networks that every scan reaches. To be called when all have been observed.
    pub fn finish(&mut self, simulation: &Simulation) {
        let scans = std::mem::take(&mut self.scans);
        for network in &mut self.networks {
            if !simulation.is_skippable(network.index) {
                network.scans += scans;
            }
        }
    }
}

/// Sees what a part does now; whether nothing of it remains to be seen.
fn see(part: &mut CoverageItem, simulation: &Simulation) -> bool {
    // Two places may lead to it.
    if part.is_exercised() {
        return true;
    }
    let elements = simulation.elements();
    let power = |index: u32| simulation.element_power(&elements[index as usize]);
    // What no power can come to never shows what it does.
    let Some(input) = part.input.and_then(power) else {
        return false;
    };
    let on = match part.kind {
        CoverageItemKind::Coil => Some(input),
        CoverageItemKind::Contact | CoverageItemKind::Comparison => power(part.output).filter(|_| input),
    };
    part.on |= on == Some(true);
    part.off |= on == Some(false);
    part.is_exercised()
}

/// For each step of a network whether it has power in each scan that reaches it: nothing but coils is between it and the left rail.
/// Of a program that no master control switches.
fn always_powered(network: &Network) -> Vec<bool> {
    let mut always: Vec<bool> = Vec::with_capacity(network.steps.len());
    for step in &network.steps {
        always.push(match *step {
            Step::Start { rail } => rail,
            Step::Join { upper, lower } => always[upper] || always[lower],
            Step::Block { block, en } => {
                always[en] && kind(network.blocks[block].kind) == Some(CoverageItemKind::Coil)
            }
        });
    }
    always
}

fn kind(block: BlockKind) -> Option<CoverageItemKind> {
    let BlockKind::Instruction(row) = block else {
        return None;
    };
    match (row.group, row.power) {
        // An inverter decides nothing.
        (Group::Condition, Power::Inverts) => None,
        (Group::Condition, Power::Compares) => Some(CoverageItemKind::Comparison),
        (Group::Condition, _) => Some(CoverageItemKind::Contact),
        (Group::Coil, _) => Some(CoverageItemKind::Coil),
        _ => None,
    }
}
