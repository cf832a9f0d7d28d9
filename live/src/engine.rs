//! One running program in the words of the messages: the place where the server meets the scan engine.

use std::cell::OnceCell;
use std::sync::Arc;
use std::time::Duration;

use ladder_analysis::Cancel;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_analysis::{Analysis, NotWhole, Severity};
use ladder_documents::position::Range;
use ladder_documents::{Kind, OtherPlaces, Revision};
use ladder_host::{Served, Wires, World};
use ladder_simulator::chart::Recorder;
use ladder_simulator::{Breakpoint, HistoryLimits, Point, Session, Simulation, Status, Stop, real_time};

use crate::action::Given;
use crate::drawing::Drawing;
use crate::follow::Texts;
use crate::line_map::LineMap;
use crate::messages;
use crate::online::{CHECK, Controller};
use crate::pulse::Pulse;
use crate::request::Failure;
use crate::retention::{Keeping, Retention};
use crate::scenes::LiveScene;
use crate::value::from_given;
use crate::view::View;

/// This many faults are reported: those that happened last.
const FAULTS: usize = 100;

/// The interval that may be asked for, in milliseconds: from a nanosecond to a day.
const INTERVAL: std::ops::RangeInclusive<f64> = 1e-6..=86_400_000.0;

/// A program that runs.
#[derive(Debug)]
pub(crate) struct Engine {
    /// What runs, and what the editor shows.
    pub(crate) line_map: LineMap,
    pub(crate) session: Session,
    pub(crate) texts: Texts,
    retention: Option<Retention>,
    /// Tags that go back when their scan is done.
    pub(crate) pulses: Vec<Pulse>,
    /// What inputs hold from the first scan on.
    inputs: Vec<(Point, Value)>,
    /// Where the elements of the drawing are, in the order in which the engine lists their power, for a client that
    /// takes them all. Computed once, for the text that runs does not change.
    pub(crate) places: OnceCell<Vec<Option<Range>>>,
    pub(crate) drawing: OnceCell<Drawing>,
    /// What the client shows, if it says so.
    pub(crate) view: Option<View>,
    /// What it said that it shows, last.
    pub(crate) shown: Option<messages::Shown>,
    /// What the client is sent next is all of what it shows: what it knows is of another text, or of another program.
    pub(crate) is_new: bool,
    /// The tags whose trace the client shows.
    pub(crate) recorder: Recorder,
    /// The scenes that the client shows.
    pub(crate) scenes: Vec<LiveScene>,
    /// How many breakpoints have stopped it.
    hits: u64,
    /// The controller that is watched, if it is not a simulation.
    pub(crate) controller: Option<Controller>,
    /// The way to what is outside, if there is one.
    pub(crate) wires: Option<Arc<dyn Wires>>,
    /// Its tags for clients, if any are served.
    pub(crate) served: Option<Box<dyn Served>>,
}

impl Engine {
    /// The program of a text, before its first scan. Analyses and compiles: for a blocking thread.
    pub(crate) fn start(
        revision: Arc<Revision>,
        options: &messages::Options,
        keeping: &Keeping,
        world: &World,
    ) -> Result<(Self, Vec<String>), Failure> {
        let ladder = revision.in_ladder();
        if let Some(why) = unreadable(&revision) {
            return Err(Failure::Failed(why));
        }
        let Some(analysis) = ladder.analysis() else {
            return Err(Failure::Failed("the file is too large to be simulated".into()));
        };
        let running = if options.online {
            ladder.program().map(|program| program.map(Ok))
        } else {
            ladder.running()
        };
        let program = match running {
            Some(Ok(Ok(program))) => program,
            Some(Ok(Err(of_plants))) => return Err(Failure::Failed(of_plants)),
            Some(Err(NotWhole::Errors(file))) if *file != *analysis.whole().context.name => {
                return Err(Failure::Failed(format!(
                    "there are errors in {file}, which the program uses"
                )));
            }
            Some(Err(NotWhole::Missing(file))) => {
                return Err(Failure::Failed(format!(
                    "{file}, which the program uses, cannot be read"
                )));
            }
            _ => return Err(has_errors(&ladder, &revision, analysis.whole())),
        };
        let settings = revision.simulate();
        let controller = options
            .online
            .then(|| Controller::watch(world, revision.online(), &revision.file_name(), program.clone()));
        let controller = controller.transpose()?;
        let limits = match options.history.or(settings.history) {
            _ if controller.is_some() => HistoryLimits::of_scans(0),
            Some(scans) => HistoryLimits::of_scans(usize::try_from(scans).unwrap_or(usize::MAX)),
            None => HistoryLimits::default(),
        };
        let mut engine = engine_options(options, settings.options(&program, revision.path()))?;
        if let Some(controller) = &controller {
            engine.interval = controller.every().unwrap_or(engine.interval);
        }
        let mut session =
            Session::new(program, engine, limits).map_err(|error| Failure::Failed(error.to_string()))?;
        let inputs = options.inputs.iter();
        let inputs = inputs
            .map(|(tag, value)| assignment(session.simulation(), tag, &Given::Json(value.clone())))
            .collect::<Result<_, _>>()?;
        let file = match keeping {
            _ if controller.is_some() => None,
            Keeping::AsSettingsSay => settings.retain.as_ref(),
            Keeping::In(file) => Some(file),
            Keeping::Nothing => None,
        };
        let (retention, mut notes) = Retention::begin(world, file, revision.name(), &mut session);
        notes.extend(session.simulation().program().unread_note());
        let mut engine = Engine {
            line_map: LineMap::of(ladder.clone(), revision.clone(), revision.clone()),
            session,
            texts: Texts::new(revision),
            retention,
            pulses: Vec::new(),
            inputs,
            places: OnceCell::new(),
            drawing: OnceCell::new(),
            view: None,
            shown: None,
            is_new: false,
            recorder: Recorder::default(),
            scenes: Vec::new(),
            hits: 0,
            controller,
            wires: world.wires.clone(),
            served: None,
        };
        engine.set_inputs()?;
        if let Some(shown) = &options.show {
            engine.show(shown);
        }
        Ok((engine, notes))
    }

    /// The text that places refer to: the editor's.
    pub(crate) fn revision(&self) -> &Revision {
        self.line_map.shown()
    }

    /// Looks at the program that runs now, or at another text of it.
    pub(crate) fn check_again(&mut self, source: Arc<Revision>, shown: Arc<Revision>) {
        self.line_map = LineMap::new(source, shown);
        self.is_new = true;
        self.places = OnceCell::new();
        self.drawing = OnceCell::new();
        self.scenes.iter_mut().for_each(LiveScene::let_go);
        if self.view.is_some() {
            self.view = Some(View::default());
            if let Some(shown) = self.shown.take() {
                self.show(&shown);
            }
        }
    }

    /// Abandons a scan that takes long when it is cancelled: it is as if it had not been begun.
    pub(crate) fn obey(&mut self, cancel: Cancel) {
        self.session.set_cancel(Some(cancel));
    }

    /// Runs one scan, unless the program has come to its end; gives the breakpoint that stops it.
    pub(crate) fn scan(&mut self) -> Option<messages::Hit> {
        if self.look_at_controller() {
            return None;
        }
        self.take_written();
        let stop = self.session.run_scan();
        self.has_gone_on();
        match stop {
            Some(Stop::Breakpoint(hit)) => {
                self.hits += 1;
                Some(self.hit(self.hits, &hit))
            }
            _ => None,
        }
    }

    /// The program has gone on: what follows from that.
    pub(crate) fn has_gone_on(&mut self) {
        self.end_pulses();
        self.look_at_what_runs();
        if let Some(retention) = &mut self.retention {
            retention.keep(&self.session);
        }
        self.show_clients();
    }

    /// Whether the program can go on.
    pub(crate) fn status(&self) -> Status {
        self.session.simulation().status()
    }

    /// Goes on to the next block, or rung.
    pub(crate) fn step_within_scan(&mut self, by_block: bool) {
        if by_block {
            self.session.step_block();
        } else {
            self.session.step_network();
        }
        self.end_pulses();
        self.look_at_what_runs();
    }

    /// Goes back up to this many scans.
    pub(crate) fn back(&mut self, scans: u64) {
        self.pulses.clear();
        self.session
            .step_back(usize::try_from(scans).unwrap_or(usize::MAX));
        self.look_at_what_runs();
    }

    /// Goes to the state after this many scans.
    pub(crate) fn go_to(&mut self, scan: u64) -> Result<(), Failure> {
        if !self.session.go_to(scan) {
            let reach = self.reach();
            return Err(Failure::Failed(format!(
                "scan {scan} is not kept; one can go to the scans from {} to {}",
                reach.first, reach.last
            )));
        }
        self.look_at_what_runs();
        Ok(())
    }

    /// How many scans can be stepped back.
    pub(crate) fn behind(&self) -> usize {
        self.session.scans_behind()
    }

    /// How many were stepped back from.
    pub(crate) fn ahead(&self) -> usize {
        self.session.scans_ahead()
    }

    /// Writes the retentive file for the last time, and leaves it to others.
    pub(crate) fn let_go_of_file(&mut self) {
        if let Some(mut retention) = self.retention.take() {
            retention.save(&self.session);
        }
    }

    /// These breakpoints, in the place of those before.
    pub(crate) fn set_breakpoints(&mut self, lines: &[u32], tags: &[String]) -> Result<(), Failure> {
        let mut breakpoints = Vec::new();
        for &line in lines {
            let network = self.network_from(line).ok_or_else(|| {
                let what = self.a_network();
                Failure::Failed(format!("there is no {what} in line {} or below it", line + 1))
            })?;
            breakpoints.push(Breakpoint::Network(network));
        }
        for tag in tags {
            breakpoints.push(Breakpoint::Change(point(self.session.simulation(), tag)?));
        }
        self.session.clear_breakpoints();
        for breakpoint in breakpoints {
            self.session.add_breakpoint(breakpoint);
        }
        Ok(())
    }

    /// The first network in a line of the editor, or below it.
    fn network_from(&self, line: u32) -> Option<usize> {
        let lines = line..=self.line_map.shown().last_line();
        let mut starts = lines.flat_map(|line| self.line_map.running_starts(line));
        if self.line_map.shows_drawing() {
            return self.session.network_at(0, starts.next()?);
        }
        // Of a text declarations are parts, too.
        starts.find_map(|start| {
            let network = self.session.network_at(0, start)?;
            let location = self.session.simulation().program().networks[network].location;
            location.range.contains(start).then_some(network)
        })
    }

    /// What the editor calls a network.
    pub(crate) fn a_network(&self) -> &'static str {
        if self.line_map.shows_drawing() {
            "rung"
        } else {
            "statement"
        }
    }

    /// Sets a tag's value.
    pub(crate) fn set(&mut self, tag: &str, value: &Given) -> Result<(), Failure> {
        let (point, value) = assignment(self.session.simulation(), tag, value)?;
        let set = self.session.set(&point, value);
        self.look_at_what_runs();
        set.map_err(|error| Failure::Failed(error.to_string()))
    }

    /// Holds a tag at a value.
    pub(crate) fn force(&mut self, tag: &str, value: &Given) -> Result<(), Failure> {
        let (point, value) = assignment(self.session.simulation(), tag, value)?;
        let forced = self.session.force(&point, value);
        self.look_at_what_runs();
        forced.map_err(|error| Failure::Failed(error.to_string()))
    }

    /// Lets a tag go, or all of them.
    pub(crate) fn unforce(&mut self, tag: Option<&str>) -> Result<(), Failure> {
        match tag {
            Some(tag) => {
                let point = point(self.session.simulation(), tag)?;
                self.session.unforce(&point);
            }
            None => self.session.unforce_all(),
        }
        self.look_at_what_runs();
        Ok(())
    }

    /// Begins again from cold: as it was started. Forces stay.
    pub(crate) fn reset(&mut self) -> Result<(), Failure> {
        self.pulses.clear();
        self.session.reset();
        self.look_at_what_runs();
        self.set_inputs()
    }

    /// Begins again with what is retentive. Forces stay.
    pub(crate) fn warm_restart(&mut self) -> Result<(), Failure> {
        self.pulses.clear();
        self.session.warm_restart();
        self.look_at_what_runs();
        self.set_inputs()
    }

    fn set_inputs(&mut self) -> Result<(), Failure> {
        for (point, value) in &self.inputs {
            // A change of the program may have taken it away.
            let Ok(point) = self.session.simulation().resolve(&point.name) else {
                continue;
            };
            let set = self.session.set(&point, value.clone());
            set.map_err(|error| Failure::Failed(error.to_string()))?;
        }
        Ok(())
    }

    /// The time from one scan to the next.
    pub(crate) fn interval(&self) -> Duration {
        if self.controller.is_some() {
            return CHECK;
        }
        real_time(self.session.simulation().options().interval)
    }

    /// How many scans are done.
    pub(crate) fn scans(&self) -> u64 {
        self.session.simulation().scans()
    }

    /// The simulation's clock, in milliseconds.
    pub(crate) fn time_ms(&self) -> f64 {
        self.session.simulation().time() as f64 / 1e6
    }

    /// What went wrong so far, the newest last. An error that repeats in one place is here once, with the scan it
    /// last happened in.
    pub(crate) fn faults(&self) -> Vec<messages::Fault> {
        let mut faults: Vec<messages::Fault> = Vec::new();
        let mut seen = std::collections::HashSet::new();
        for fault in self.session.faults().into_iter().rev() {
            if faults.len() == FAULTS {
                break;
            }
            if !seen.insert((fault.location, fault.message.clone())) {
                continue;
            }
            let (uri, range) = self.place(fault.location);
            faults.push(messages::Fault {
                message: fault.message,
                uri,
                range,
                scan: fault.scan,
            });
        }
        faults.reverse();
        faults.extend(self.contradictions());
        faults
    }

    /// A place in the program: the file, where that is not the document itself, and the range.
    pub(crate) fn place(&self, location: Location) -> (Option<String>, Range) {
        let elsewhere = match location.file {
            0 => None,
            file => {
                let name = &self.session.simulation().program().files[file as usize];
                OtherPlaces::new(self.line_map.running()).range(name, location.range)
            }
        };
        match elsewhere {
            Some((uri, range)) => (Some(uri), range),
            None => (None, self.line_map.range_or_near(location.range)),
        }
    }
}

pub(crate) fn point(simulation: &Simulation, tag: &str) -> Result<Point, Failure> {
    simulation
        .resolve(tag)
        .map_err(|error| Failure::Failed(error.to_string()))
}

fn assignment(simulation: &Simulation, tag: &str, value: &Given) -> Result<(Point, Value), Failure> {
    let point = point(simulation, tag)?;
    let value = from_given(value, point.ty)
        .map_err(|problem| Failure::Invalid(format!("{}: {problem}", point.name)))?;
    Ok((point, value))
}

fn engine_options(
    options: &messages::Options,
    mut engine: ladder_simulator::Options,
) -> Result<ladder_simulator::Options, Failure> {
    if let Some(milliseconds) = options.interval_ms {
        if !INTERVAL.contains(&milliseconds) {
            return Err(Failure::Invalid(format!(
                "intervalMs is {milliseconds}; it must be more than 0 and at most a day (86400000)"
            )));
        }
        engine.interval = (milliseconds * 1e6).round() as i64;
    }
    if let Some(blocks) = options.watchdog {
        if blocks == 0 {
            return Err(Failure::Invalid(
                "watchdog is 0; it must let at least one block be evaluated".into(),
            ));
        }
        engine.watchdog = blocks;
    }
    Ok(engine)
}

/// Why a program of another system, or a project, is not simulated: it cannot be read.
pub(crate) fn unreadable(revision: &Revision) -> Option<String> {
    match revision.opened() {
        Some(Err(error)) => Some(error.to_string()),
        Some(Ok(opened)) if opened.foreign().has_errors() => {
            let remarks = opened.foreign().remarks();
            let first = remarks.iter().find(|mark| mark.severity == Severity::Error)?;
            let line = revision.range(first.range).start.line + 1;
            Some(format!(
                "the program has an error in line {line}: {}",
                first.message
            ))
        }
        None if revision.kind() == Kind::Settings => {
            let place = revision.place()?;
            let text = place.neighbours.text_on_disk(&place.path);
            text.err().map(|error| error.to_string())
        }
        _ => None,
    }
}

/// Why a program with errors is not simulated: the first of them, and how many there are.
fn has_errors(ladder: &Arc<Revision>, revision: &Arc<Revision>, analysis: &Analysis) -> Failure {
    let errors: Vec<_> = analysis.errors().collect();
    let Some(first) = errors.first() else {
        return Failure::Failed("the program cannot be simulated".into());
    };
    let map = LineMap::of(ladder.clone(), revision.clone(), revision.clone());
    let line = map.range_or_near(first.range).start.line + 1;
    let count = match errors.len() {
        1 => "an error".into(),
        more => format!("{more} errors, the first"),
    };
    Failure::Failed(format!(
        "the program has {count} in line {line}: {}",
        first.message
    ))
}
