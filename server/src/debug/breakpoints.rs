//! Breakpoints: where they are, and what is said beside them.

use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;

use ladder_analysis::program::Location;
use ladder_simulator::{Breakpoint, Hit};
use ladder_syntax::{TextRange, TextSize};
use serde_json::{Value as Json, json};

use super::condition::{HitCondition, Piece, pieces};
use super::messages::{DataBreakpoint, SourceBreakpoint};
use super::sources::Counting;
use super::target::Target;
use super::watch::{Problem, Typed, Watch};

/// An expression beside a breakpoint. In a body it means the tags of the place that runs, so it is compiled for each.
#[derive(Debug)]
struct Beside {
    text: String,
    compiled: HashMap<Option<String>, Watch>,
}

impl Beside {
    /// Compiles it for the place where it will be asked, as far as that is known, to find its mistakes.
    fn new(text: &str, target: &Target, location: Option<Location>) -> Result<Beside, Problem> {
        let block = location.and_then(|location| body_of(target, location));
        let simulation = target.simulation();
        let instance = block.and_then(|block| simulation.instances().iter().find(|it| it.block == block));
        let watch = Watch::new(text, super::watch::Scope { simulation, instance })?;
        Ok(Beside {
            text: text.to_owned(),
            compiled: HashMap::from([(instance.map(|instance| instance.name.clone()), watch)]),
        })
    }

    /// The expression for the place that runs.
    fn watch(&mut self, target: &Target) -> Result<&mut Watch, Problem> {
        let scope = target.scope(None);
        let place = scope.instance.map(|instance| instance.name.clone());
        match self.compiled.entry(place) {
            std::collections::hash_map::Entry::Occupied(known) => Ok(known.into_mut()),
            std::collections::hash_map::Entry::Vacant(free) => {
                Ok(free.insert(Watch::new(&self.text, scope)?))
            }
        }
    }

    fn holds(&mut self, target: &Target) -> Result<bool, Problem> {
        self.watch(target)?.holds(target.simulation())
    }

    fn evaluate(&mut self, target: &Target) -> Result<Typed, Problem> {
        self.watch(target)?.evaluate(target.simulation())
    }
}

/// The user-defined block in whose body a place lies.
fn body_of(target: &Target, location: Location) -> Option<usize> {
    let program = target.simulation().program();
    let is_around = |network: usize| {
        let around = program.networks[network].location;
        around.file == location.file && around.range.contains_range(location.range)
    };
    let mut blocks = program.blocks.iter();
    blocks.position(|block| block.networks.clone().any(is_around))
}

#[derive(Debug)]
enum LogPiece {
    Text(String),
    Expression(Beside),
}

/// A breakpoint with its conditions.
#[derive(Debug)]
struct Marker {
    id: i64,
    breakpoint: Breakpoint,
    condition: Option<Beside>,
    hit_condition: Option<HitCondition>,
    log: Option<Vec<LogPiece>>,
    /// How often it was met.
    hits: u64,
}

/// What a breakpoint that is met asks for.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// To go on.
    Pass,
    /// To write this and go on.
    Log(String),
    /// To stop; with a remark if a condition cannot be evaluated.
    Stop(Option<String>),
}

/// All breakpoints of a target.
#[derive(Debug, Default)]
pub(super) struct Table {
    by_file: BTreeMap<u32, Vec<Marker>>,
    data: Vec<Marker>,
    /// What the client asked for, with the numbers that it was given, to be placed anew in another program.
    asked: BTreeMap<PathBuf, Vec<(i64, SourceBreakpoint)>>,
    asked_data: Vec<(i64, DataBreakpoint)>,
    ids: i64,
}

impl Table {
    /// These breakpoints in a file, in the place of those before. Gives what the protocol wants to know of each.
    pub(super) fn set_in_file(
        &mut self,
        target: &Target,
        file: u32,
        wanted: Vec<SourceBreakpoint>,
        counting: Counting,
    ) -> Vec<Json> {
        let asked: Vec<_> = wanted.into_iter().map(|wanted| (self.new_id(), wanted)).collect();
        let told = self.place_in_file(target, file, &asked, counting);
        self.asked.insert(target.source(file).path.clone(), asked);
        told
    }

    fn new_id(&mut self) -> i64 {
        self.ids += 1;
        self.ids
    }

    fn place_in_file(
        &mut self,
        target: &Target,
        file: u32,
        asked: &[(i64, SourceBreakpoint)],
        counting: Counting,
    ) -> Vec<Json> {
        let mut markers = Vec::new();
        let mut told = Vec::new();
        for (id, wanted) in asked {
            let line = counting.line(wanted.line);
            let column = wanted
                .column
                .map(|column| counting.offset(target.source(file), line, column));
            let Some((breakpoint, location)) = place(target, file, line, column) else {
                told.push(json!({
                    "id": id, "verified": false, "line": wanted.line,
                    "message": "there is no rung in this line or below it",
                }));
                continue;
            };
            let source = target.source(file);
            let mut shown = json!({"id": id, "verified": true, "source": source.json()});
            let range = counting.range(source, location.range);
            let is_block = matches!(breakpoint, Breakpoint::Block(_));
            for name in ["line", "column", "endLine", "endColumn"] {
                if is_block || name == "line" {
                    shown[name] = range[name].clone();
                }
            }
            match Marker::new(*id, breakpoint, target, Some(location), wanted) {
                Ok(marker) => markers.push(marker),
                Err(problem) => {
                    shown["verified"] = false.into();
                    shown["message"] = problem.into();
                }
            }
            told.push(shown);
        }
        self.by_file.insert(file, markers);
        told
    }

    /// These breakpoints on tags, in the place of those before.
    pub(super) fn set_data(&mut self, target: &Target, wanted: Vec<DataBreakpoint>) -> Vec<Json> {
        let asked: Vec<_> = wanted.into_iter().map(|wanted| (self.new_id(), wanted)).collect();
        let told = self.place_data(target, &asked);
        self.asked_data = asked;
        told
    }

    fn place_data(&mut self, target: &Target, asked: &[(i64, DataBreakpoint)]) -> Vec<Json> {
        let mut markers = Vec::new();
        let mut told = Vec::new();
        for (id, wanted) in asked {
            let beside = SourceBreakpoint {
                condition: wanted.condition.clone(),
                hit_condition: wanted.hit_condition.clone(),
                ..SourceBreakpoint::default()
            };
            let point = target
                .simulation()
                .resolve(&wanted.data_id)
                .map_err(|unknown| unknown.message);
            let marker =
                point.and_then(|point| Marker::new(*id, Breakpoint::Change(point), target, None, &beside));
            match marker {
                Ok(marker) => {
                    markers.push(marker);
                    told.push(json!({"id": id, "verified": true}));
                }
                Err(problem) => told.push(json!({"id": id, "verified": false, "message": problem})),
            }
        }
        self.data = markers;
        told
    }

    /// Places all of them in another program. Gives what has become of each.
    pub(super) fn place_anew(&mut self, target: &Target, counting: Counting) -> Vec<Json> {
        self.by_file.clear();
        let mut told = Vec::new();
        for (path, asked) in std::mem::take(&mut self.asked) {
            if let Some(file) = target.file_of(&path) {
                told.extend(self.place_in_file(target, file, &asked, counting));
            }
            self.asked.insert(path, asked);
        }
        let asked = std::mem::take(&mut self.asked_data);
        told.extend(self.place_data(target, &asked));
        self.asked_data = asked;
        told
    }

    fn all(&mut self) -> impl Iterator<Item = &mut Marker> {
        self.by_file.values_mut().flatten().chain(&mut self.data)
    }

    /// Tells the session where it is to stop.
    pub(super) fn arm(&mut self, target: &mut Target) {
        target.session.clear_breakpoints();
        for marker in self.all() {
            target.session.add_breakpoint(marker.breakpoint.clone());
        }
    }

    /// What the breakpoints ask for that are met, with their numbers. Going back counts no hits and writes nothing.
    pub(super) fn judge(&mut self, hit: &Hit, target: &Target, counts: bool) -> (Verdict, Vec<i64>) {
        let next = target.simulation().next_block();
        let is_met = |breakpoint: &Breakpoint| match (breakpoint, hit) {
            (Breakpoint::Network(network), Hit::Network(location)) => {
                target.simulation().program().networks[*network].location == *location
            }
            (Breakpoint::Block(block), Hit::Block(location)) => block == location,
            // Both stand in front of the same instruction.
            (Breakpoint::Block(block), Hit::Network(_)) => next == Some(*block),
            (Breakpoint::Change(tag), Hit::Change { point, .. }) => tag.name == point.name,
            _ => false,
        };
        let mut ids = Vec::new();
        let mut logged = String::new();
        let mut remark = None;
        for marker in self.all().filter(|marker| is_met(&marker.breakpoint)) {
            match marker.judge(target, counts) {
                Verdict::Pass => {}
                Verdict::Log(line) => logged.push_str(&line),
                Verdict::Stop(problem) => {
                    ids.push(marker.id);
                    remark = remark.or(problem);
                }
            }
        }
        let verdict = match (ids.is_empty(), logged.is_empty()) {
            (false, _) => Verdict::Stop(remark),
            (true, false) => Verdict::Log(logged),
            (true, true) => Verdict::Pass,
        };
        (verdict, ids)
    }
}

impl Marker {
    fn new(
        id: i64,
        breakpoint: Breakpoint,
        target: &Target,
        location: Option<Location>,
        wanted: &SourceBreakpoint,
    ) -> Result<Marker, Problem> {
        let given = |text: &Option<String>| {
            text.as_deref()
                .map(str::trim)
                .filter(|text| !text.is_empty())
                .map(str::to_owned)
        };
        let condition = given(&wanted.condition).map(|text| {
            let beside = Beside::new(&text, target, location);
            beside.and_then(|mut beside| {
                // A condition that is no BOOL is found now; a fault is for later.
                let watch = beside.watch_any();
                match watch.map(|watch| watch.evaluate(target.simulation())) {
                    Some(Ok(Typed { ty, .. })) if ty != ladder_analysis::types::Scalar::Bool => Err(format!(
                        "`{text}` is of type {ty}; a condition is TRUE or FALSE, as in {text} > 0"
                    )),
                    _ => Ok(beside),
                }
            })
        });
        let hit_condition = given(&wanted.hit_condition).map(|text| HitCondition::read(&text));
        let log = given(&wanted.log_message).map(|message| {
            let pieces = pieces(&message)?.into_iter().map(|piece| match piece {
                Piece::Text(text) => Ok(LogPiece::Text(text)),
                Piece::Expression(text) => Beside::new(&text, target, location).map(LogPiece::Expression),
            });
            pieces.collect::<Result<Vec<_>, Problem>>()
        });
        Ok(Marker {
            id,
            breakpoint,
            condition: condition.transpose()?,
            hit_condition: hit_condition.transpose()?,
            log: log.transpose()?,
            hits: 0,
        })
    }

    fn judge(&mut self, target: &Target, counts: bool) -> Verdict {
        match self.condition.as_mut().map(|condition| condition.holds(target)) {
            None | Some(Ok(true)) => {}
            Some(Ok(false)) => return Verdict::Pass,
            Some(Err(problem)) => {
                return Verdict::Stop(Some(format!("the condition cannot be evaluated: {problem}")));
            }
        }
        if counts {
            self.hits += 1;
            if self
                .hit_condition
                .is_some_and(|condition| !condition.holds(self.hits))
            {
                return Verdict::Pass;
            }
        }
        let Some(pieces) = &mut self.log else {
            return Verdict::Stop(None);
        };
        if !counts {
            return Verdict::Pass;
        }
        let mut line = String::new();
        for piece in pieces {
            match piece {
                LogPiece::Text(text) => line.push_str(text),
                LogPiece::Expression(beside) => match beside.evaluate(target) {
                    Ok(value) => line.push_str(&value.shown()),
                    Err(problem) => line.push_str(&format!("<{problem}>")),
                },
            }
        }
        line.push('\n');
        Verdict::Log(line)
    }
}

impl Beside {
    fn watch_any(&mut self) -> Option<&mut Watch> {
        self.compiled.values_mut().next()
    }
}

/// Where a breakpoint of a line is: at the rung that begins there, at the first block that runs of those in the line, or
/// what comes first below it. With a column at the block there, or the next one of the line.
fn place(
    target: &Target,
    file: u32,
    line: usize,
    column: Option<TextSize>,
) -> Option<(Breakpoint, Location)> {
    let source = target.source(file);
    if let Some(offset) = column {
        let behind =
            blocks(target, file).filter(|block| source.line(block.start()) == line && block.end() > offset);
        if let Some(range) = behind.min_by_key(|block| block.start()) {
            let location = Location { file, range };
            return Some((Breakpoint::Block(location), location));
        }
    }
    let program = target.simulation().program();
    let networks = program.networks.iter().enumerate();
    let starts = networks
        .filter(|(_, network)| network.location.file == file)
        .map(|(number, network)| {
            (
                source.line(network.location.range.start()),
                Breakpoint::Network(number),
                network.location,
            )
        });
    let blocks = blocks(target, file).map(|range| {
        let location = Location { file, range };
        (source.line(range.start()), Breakpoint::Block(location), location)
    });
    // Of a line the rung goes before its blocks; of the blocks the first in their order of evaluation.
    let (_, breakpoint, location) = starts
        .chain(blocks)
        .filter(|(at, ..)| *at >= line)
        .min_by_key(|(at, ..)| *at)?;
    Some((breakpoint, location))
}

/// The blocks of a file in their order of evaluation within each network.
fn blocks(target: &Target, file: u32) -> impl Iterator<Item = TextRange> {
    let networks = target.simulation().program().networks.iter();
    let networks = networks.filter(move |network| network.location.file == file);
    networks.flat_map(|network| network.blocks.iter().map(|block| block.location.range))
}

/// Every place in some lines where a breakpoint can be.
pub(super) fn locations(
    target: &Target,
    file: u32,
    lines: std::ops::RangeInclusive<usize>,
    counting: Counting,
) -> Vec<Json> {
    let source = target.source(file);
    let networks = target.simulation().program().networks.iter();
    let rungs = networks
        .filter(|network| network.location.file == file)
        .map(|network| TextRange::empty(network.location.range.start()));
    let mut ranges: Vec<TextRange> = rungs.chain(blocks(target, file)).collect();
    ranges.retain(|range| lines.contains(&source.line(range.start())));
    ranges.sort_by_key(|range| (range.start(), range.len()));
    ranges
        .into_iter()
        .map(|range| {
            let place = counting.range(source, range);
            if range.is_empty() {
                return json!({"line": place["line"]});
            }
            place
        })
        .collect()
}
