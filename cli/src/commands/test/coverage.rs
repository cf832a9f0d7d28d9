//! What the scenarios of a run exercised, file by file: of a program that several scenario files test, and of a
//! file that several programs share, what any of them exercised.

use super::report::FileReport;
use crate::findings::{FileRange, Source};
use ladder_simulator::coverage::{Coverage, CoverageItem, CoverageItemKind, NetworkScans};
use ladder_workspace::shown;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What was exercised of all programs.
#[derive(Default)]
pub(super) struct Covered {
    pub(super) files: BTreeMap<String, CoveredFile>,
}

/// What was exercised of one file.
pub(super) struct CoveredFile {
    pub(super) source: Arc<Source>,
    /// By where they begin.
    pub(super) networks: BTreeMap<u32, CoveredNetwork>,
    pub(super) parts: BTreeMap<u32, CoveredPart>,
}

pub(super) struct CoveredNetwork {
    pub(super) place: FileRange,
    /// Its rungs, by line from 1.
    pub(super) lines: BTreeSet<u32>,
    pub(super) scans: u64,
}

pub(super) struct CoveredPart {
    pub(super) kind: CoverageItemKind,
    pub(super) place: FileRange,
    pub(super) on: bool,
    pub(super) off: bool,
    /// The network that it is in is reached.
    pub(super) reached: bool,
    /// Of a contact or comparison in a program that was changed: a scenario fails when it is bridged, and when it is inverted.
    pub(super) matters: Option<bool>,
}

impl Covered {
    /// Takes in what a file's scenarios exercised.
    pub(super) fn add(&mut self, report: &FileReport) {
        let (Some(coverage), Some(program)) = (&report.coverage, &report.program) else {
            return;
        };
        for (index, name) in coverage.files.iter().enumerate() {
            let source = match index {
                0 => Arc::clone(program),
                _ => match program.other(name) {
                    Some(other) => Arc::new(other),
                    None => continue,
                },
            };
            let name = source.file.clone();
            let file = self.files.entry(name).or_insert_with(|| CoveredFile {
                source,
                networks: BTreeMap::new(),
                parts: BTreeMap::new(),
            });
            file.add(index as u32, coverage);
        }
    }
}

impl Covered {
    /// Whether it is known which contacts are shown to matter.
    pub(super) fn was_mutated(&self) -> bool {
        let mut parts = self.files.values().flat_map(|file| file.parts.values());
        parts.any(|part| part.matters.is_some())
    }

    /// Notes which contacts and comparisons of a program are shown to matter, by where they begin.
    pub(super) fn note_what_matters(&mut self, file: &str, matters: &BTreeMap<u32, bool>) {
        let Some(file) = self.files.get_mut(file) else {
            return;
        };
        for (start, part) in &mut file.parts {
            part.matters = matters.get(start).copied();
        }
    }
}

impl CoveredFile {
    fn add(&mut self, file: u32, coverage: &Coverage) {
        for network in coverage
            .networks
            .iter()
            .filter(|network| network.location.file == file)
        {
            self.network(network);
        }
        for part in coverage.parts.iter().filter(|part| part.location.file == file) {
            self.part(part);
        }
        for network in self.networks.values().filter(|network| network.scans > 0) {
            for part in self.parts.values_mut() {
                part.reached |= network.lines.contains(&part.place.line);
            }
        }
    }

    fn network(&mut self, network: &NetworkScans) {
        let source = &self.source;
        let entry = self
            .networks
            .entry(network.location.range.start().into())
            .or_insert_with(|| CoveredNetwork {
                place: FileRange::of(source, source.range_in_file(network.location.range)),
                lines: network
                    .elements
                    .iter()
                    .map(|element| source.place(source.range_in_file(element.range).start()).line)
                    .collect(),
                scans: 0,
            });
        entry.scans += network.scans;
    }

    fn part(&mut self, part: &CoverageItem) {
        let source = &self.source;
        let entry = self
            .parts
            .entry(part.location.range.start().into())
            .or_insert_with(|| CoveredPart {
                kind: part.kind,
                place: FileRange::of(source, source.range_in_file(part.location.range)),
                on: false,
                off: false,
                reached: false,
                matters: None,
            });
        entry.on |= part.on;
        entry.off |= part.off;
    }
}

/// How many of a file's things were exercised, and how many there are.
#[derive(Debug, Clone, Copy, Default, Serialize)]
struct Count {
    exercised: usize,
    all: usize,
}

impl Count {
    fn add(&mut self, exercised: bool) {
        self.exercised += usize::from(exercised);
        self.all += 1;
    }

    fn shown(self) -> String {
        format!("{}/{}", self.exercised, self.all)
    }
}

/// Networks, contacts (comparisons are among them) and coils.
fn counts(file: &CoveredFile) -> [Count; 3] {
    let mut counts = [Count::default(); 3];
    for network in file.networks.values() {
        counts[0].add(network.scans > 0);
    }
    for part in file.parts.values() {
        let coil = part.kind == CoverageItemKind::Coil;
        counts[if coil { 2 } else { 1 }].add(part.on && part.off);
    }
    counts
}

/// A line for each file.
pub(super) fn table(covered: &Covered) -> String {
    let mut rows: Vec<[String; 4]> = vec![["networks", "contacts", "coils", ""].map(str::to_owned)];
    for (name, file) in &covered.files {
        let [networks, contacts, coils] = counts(file).map(Count::shown);
        rows.push([networks, contacts, coils, shown::line(name).into_owned()]);
    }
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let widths = [width(0), width(1), width(2)];
    let mut table = String::new();
    for [networks, contacts, coils, name] in &rows {
        let line = format!(
            "  {networks:>0$}  {contacts:>1$}  {coils:>2$}  {name}",
            widths[0], widths[1], widths[2]
        );
        table.push_str(line.trim_end());
        table.push('\n');
    }
    table
}

/// Something that was not exercised, with its rung.
pub(super) struct Missed {
    /// `motor.clad:20:22: contact was never open`
    pub(super) title: String,
    pub(super) rung: String,
    pub(super) marks: String,
}

/// What was not exercised, in the order of the files. Of a network that was never reached only that is reported.
pub(super) fn missed(covered: &Covered) -> Vec<Missed> {
    let mut missed = Vec::new();
    for file in covered.files.values() {
        let networks = file
            .networks
            .iter()
            .filter(|(_, network)| network.scans == 0)
            .map(|(&start, network)| (start, &network.place, "this network was never reached".to_owned()));
        let parts = file
            .parts
            .iter()
            .filter(|(_, part)| part.reached && (!(part.on && part.off) || part.matters == Some(false)))
            .map(|(&start, part)| (start, &part.place, what_is_missing(part)));
        let mut all: Vec<(u32, &FileRange, String)> = networks.chain(parts).collect();
        all.sort_by_key(|(start, ..)| *start);
        missed.extend(
            all.into_iter()
                .map(|(_, place, what)| excerpt(&file.source, place, &what)),
        );
    }
    missed
}

fn what_is_missing(part: &CoveredPart) -> String {
    let name = match part.kind {
        CoverageItemKind::Contact => "contact",
        CoverageItemKind::Comparison => "comparison",
        CoverageItemKind::Coil => "coil",
    };
    let missing = match (part.kind, part.on, part.off) {
        (CoverageItemKind::Coil, false, true) => "never had power",
        (CoverageItemKind::Coil, true, false) => "was never without power",
        (CoverageItemKind::Coil, ..) => "was never reached",
        (_, true, true) => "was seen open and closed, but no scenario shows that it matters",
        (_, true, _) => "was never open while power came to it",
        (_, false, true) => "was never closed while power came to it",
        (_, false, false) => "never had power coming to it",
    };
    format!("this {name} {missing}")
}

/// The rung with the marks under one of its things.
pub(super) fn excerpt(source: &Source, place: &FileRange, what: &str) -> Missed {
    let line = source
        .file_text()
        .lines()
        .nth(place.line as usize - 1)
        .unwrap_or_default();
    let rung = line.trim_end();
    let rung = rung.strip_prefix('\u{feff}').unwrap_or(rung);
    let before = place.column as usize - 1;
    // Of something that goes on in the next line the rest of this one.
    let end = if place.end_line == place.line {
        place.end_column as usize - 1
    } else {
        rung.chars().count()
    };
    let marks: String = rung
        .chars()
        .take(end.max(before))
        .enumerate()
        .map(|(at, c)| {
            // As long as it is shown.
            let length = if shown::is_obeyed(c) {
                shown::escape(c).len()
            } else {
                1
            };
            match (at < before, c) {
                (true, '\t') => "\t".to_owned(),
                (true, _) => " ".repeat(length),
                (false, _) => "^".repeat(length),
            }
        })
        .collect();
    Missed {
        title: format!(
            "{}:{}:{}: {what}",
            shown::line(&place.file),
            place.line,
            place.column
        ),
        rung: shown::text(rung).into_owned(),
        marks,
    }
}

/// A file, for machines.
#[derive(Serialize)]
struct FileObject<'a> {
    file: &'a str,
    networks: Count,
    contacts: Count,
    coils: Count,
    /// The lines of networks, with how many scans reached them.
    rungs: Vec<RungObject>,
    parts: Vec<PartObject>,
}

#[derive(Serialize)]
struct RungObject {
    line: u32,
    scans: u64,
}

#[derive(Serialize)]
struct PartObject {
    kind: &'static str,
    line: u32,
    column: u32,
    on: bool,
    off: bool,
    /// Whether a scenario shows that it matters, where that was tried.
    #[serde(skip_serializing_if = "Option::is_none")]
    matters: Option<bool>,
}

/// What was exercised, for machines.
pub(super) fn json(covered: &Covered) -> impl Serialize + '_ {
    let files = covered.files.iter().map(|(name, file)| {
        let [networks, contacts, coils] = counts(file);
        FileObject {
            file: name,
            networks,
            contacts,
            coils,
            rungs: file
                .networks
                .values()
                .flat_map(|network| {
                    network.lines.iter().map(|&line| RungObject {
                        line,
                        scans: network.scans,
                    })
                })
                .collect(),
            parts: file
                .parts
                .values()
                .map(|part| PartObject {
                    kind: match part.kind {
                        CoverageItemKind::Contact => "contact",
                        CoverageItemKind::Comparison => "comparison",
                        CoverageItemKind::Coil => "coil",
                    },
                    line: part.place.line,
                    column: part.place.column,
                    on: part.on,
                    off: part.off,
                    matters: part.matters,
                })
                .collect(),
        }
    });
    files.collect::<Vec<_>>()
}
