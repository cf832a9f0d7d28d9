//! The program that the screen shows: the session, with what the screen remembers of it.

use super::operands;
use super::sheet::{Block, Operand, Sheet};
use crate::findings::Source;
use crate::outcome::Failure;
use crate::run::{Retention, with_wording};
use ladder_analysis::Cancel;
use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use ladder_simulator::chart::{Recorder, Track};
use ladder_simulator::online::Watching;
use ladder_simulator::scenario::{self, Recordable, Recorded, Wanted};
use ladder_simulator::{
    Breakpoint, Changeover, CompileError, Fault, Hit, Inputs, Point, Session, Simulation, Status, Stepped,
    Stop,
};
use ladder_workspace::Member;
use std::borrow::Cow;
use std::sync::Arc;

/// A running program.
pub(super) struct Plant {
    pub(super) sheet: Sheet,
    /// The program's files.
    members: Vec<Member>,
    /// The number of this program, and the drawings of others that can be stepped back to.
    generation: u64,
    drawings: Vec<(u64, Drawing)>,
    session: Session,
    /// What tags are given before each scan.
    inputs: Inputs,
    /// The file that keeps retentive tags.
    retention: Option<Retention>,
    /// The values of the watched tags, scan by scan.
    recorder: Recorder,
    /// The controller that it is shown of, in the place of a simulation.
    watching: Option<(String, Watching)>,
}

/// A program on paper, with its files.
type Drawing = (Sheet, Vec<Member>);

/// What a scan of a run came to.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Ran {
    /// The next can follow.
    On,
    /// The program has ended, or a fault has stopped it.
    Out,
    /// A breakpoint has stopped it.
    Break(Hit),
}

/// A part of a scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StepUnit {
    Block,
    Rung,
}

impl Plant {
    /// A program before its next scan.
    pub(super) fn new(
        source: &Source,
        session: Session,
        inputs: Inputs,
        retention: Option<Retention>,
    ) -> Plant {
        let (sheet, members) = drawing(source, session.simulation());
        Plant {
            members,
            sheet,
            generation: session.generation(),
            drawings: Vec::new(),
            session,
            inputs,
            retention,
            recorder: Recorder::default(),
            watching: None,
        }
    }

    /// The program of a controller that is watched, and what that is called.
    #[cfg(feature = "run")]
    pub(super) fn of_controller(
        source: &Source,
        session: Session,
        controller: String,
        watching: Watching,
    ) -> Plant {
        Plant {
            watching: Some((controller, watching)),
            ..Plant::new(source, session, Inputs::default(), None)
        }
    }

    /// The controller that is watched, if it is not a simulation, and how it is.
    pub(super) fn watching(&self) -> Option<(&str, &Watching)> {
        let (controller, watching) = self.watching.as_ref()?;
        Some((controller, watching))
    }

    pub(super) fn simulation(&self) -> &Simulation {
        self.session.simulation()
    }

    pub(super) fn status(&self) -> Status {
        self.simulation().status()
    }

    pub(super) fn scans(&self) -> u64 {
        self.simulation().scans()
    }

    pub(super) fn value(&self, point: &Point) -> Value {
        self.simulation().value(point)
    }

    /// The tags of a block that can be checked, in the order of its operands.
    pub(super) fn operands<'b>(&self, block: &'b Block) -> Cow<'b, [Operand]> {
        operands::now(block, self.simulation())
    }

    /// Whether a BOOL is high.
    pub(super) fn is_high(&self, point: &Point) -> bool {
        self.value(point) == Value::Bool(true)
    }

    pub(super) fn is_forced(&self, point: &Point) -> bool {
        self.simulation().is_forced(point)
    }

    /// How many tags are forced.
    pub(super) fn forces(&self) -> usize {
        self.simulation().forced().count()
    }

    /// How many scans can be stepped back, and forward again.
    pub(super) fn history(&self) -> (usize, usize) {
        (self.session.scans_behind(), self.session.scans_ahead())
    }

    /// Whether a scan was begun and is not finished.
    pub(super) fn is_open(&self) -> bool {
        self.session.is_open()
    }

    /// Abandons a scan that takes long when it is cancelled: it is as if it had not been begun.
    pub(super) fn obey(&mut self, cancel: &Cancel) {
        self.session.set_cancel(Some(cancel.clone()));
    }

    /// Runs one scan, or the rest of the one that is open; breakpoints stop it.
    pub(super) fn run_scan(&mut self) -> Ran {
        if let Some((_, watching)) = &mut self.watching {
            if watching.look() {
                let seen = watching.online().simulation();
                let time = self.session.simulation().options().interval * seen.scans() as i64;
                self.session.mirror(seen, time);
                self.recorder.look(&self.session);
            }
            return Ran::On;
        }
        if self.status() != Status::Ready {
            return Ran::Out;
        }
        match self.recorded(Session::run_scan) {
            Some(Stop::Breakpoint(hit)) => Ran::Break(hit),
            _ if self.status() == Status::Ready => Ran::On,
            _ => Ran::Out,
        }
    }

    /// Runs one scan, or the rest of the one that is open, past all breakpoints.
    pub(super) fn scan(&mut self) {
        self.recorded(Session::scan);
    }

    /// Runs a part of a scan. Returns what runs next in it.
    pub(super) fn step(&mut self, part: StepUnit) -> Stepped {
        self.recorded(match part {
            StepUnit::Block => Session::step_block,
            StepUnit::Rung => Session::step_network,
        })
    }

    /// Runs something with what is given before a scan, and records the scan if it comes to its end.
    fn recorded<T>(&mut self, run: impl FnOnce(&mut Session) -> T) -> T {
        let scan = self.scans();
        // What was given once is part of the history.
        if !self.is_open() && self.session.scans_ahead() == 0 {
            self.inputs.give_to_session(scan, &mut self.session);
        }
        let ran = run(&mut self.session);
        self.look_at_what_runs();
        self.recorder.look(&self.session);
        ran
    }

    /// Goes back one scan, or to the start of the one that is open. False if no earlier one is kept.
    pub(super) fn step_back(&mut self) -> bool {
        let gone = self.session.step_back(1);
        self.look_at_what_runs();
        self.recorder.look(&self.session);
        gone > 0
    }

    /// Sets a breakpoint, or takes it away. Whether it is set now.
    pub(super) fn toggle_breakpoint(&mut self, breakpoint: Breakpoint) -> bool {
        let was_set = self.session.remove_breakpoint(&breakpoint);
        if !was_set {
            self.session.add_breakpoint(breakpoint);
        }
        !was_set
    }

    pub(super) fn breakpoints(&self) -> &[Breakpoint] {
        self.session.breakpoints()
    }

    /// Why a tag holds what it holds.
    pub(super) fn why(&mut self, point: &Point) -> String {
        let files = &self.session.simulation().program().files;
        if let Some((_, watching)) = &mut self.watching {
            let judged = watching.why(point);
            return with_wording(&self.members, files, |wording| wording.judged_text(&judged));
        }
        let why = self.session.why(point);
        let files = &self.session.simulation().program().files;
        with_wording(&self.members, files, |wording| wording.text(&why))
    }

    /// What was done so far, as a scenario of the program's file that expects something of these tags.
    ///
    /// # Errors
    /// There is nothing that could be recorded: why.
    pub(super) fn record_as_test(
        &self,
        program: &str,
        outputs: Option<&[String]>,
    ) -> Result<Recorded, String> {
        let wanted = Wanted {
            program,
            name: "recorded",
            outputs,
        };
        scenario::record(&self.session, wanted)
    }

    /// The tags of which a recording can expect something.
    pub(super) fn recordable(&self) -> Vec<Recordable> {
        scenario::recordable(&self.session)
    }

    /// Whether what was recorded passes when it is run as a test.
    pub(super) fn passes(&self, recorded: &Recorded) -> bool {
        scenario::passes(&self.session, recorded)
    }

    /// The last thing that went wrong, and how often it did in its place.
    pub(super) fn last_fault(&self) -> Option<(Fault, usize)> {
        self.session.last_fault()
    }

    pub(super) fn set(&mut self, point: &Point, value: Value) -> Result<(), String> {
        let set = self.session.set(point, value);
        self.look_at_what_runs();
        set.map_err(|refused| refused.message)
    }

    pub(super) fn force(&mut self, point: &Point, value: Value) -> Result<(), String> {
        let forced = self.session.force(point, value);
        self.look_at_what_runs();
        forced.map_err(|refused| refused.message)
    }

    pub(super) fn unforce(&mut self, point: &Point) {
        self.session.unforce(point);
        self.look_at_what_runs();
    }

    pub(super) fn unforce_all(&mut self) {
        self.session.unforce_all();
        self.look_at_what_runs();
    }

    /// Begins again. The switches outside stay as they are, and so do forces.
    pub(super) fn restart(&mut self, restart: Restart) {
        let inputs = self.switches();
        match restart {
            Restart::Cold => self.session.reset(),
            Restart::Warm => self.session.warm_restart(),
        }
        self.look_at_what_runs();
        for (point, value) in inputs {
            // It held this value before, or is no more.
            let point = self.session.simulation().resolve(&point.name);
            let _ = point.map(|point| self.session.set(&point, value));
        }
        self.recorder.look(&self.session);
    }

    /// What the inputs hold.
    fn switches(&self) -> Vec<(Point, Value)> {
        let inputs = self.sheet.inputs.iter();
        inputs
            .filter(|point| !self.is_forced(point))
            .map(|point| (point.clone(), self.value(point)))
            .collect()
    }

    /// Saves what is retentive, if that is due.
    pub(super) fn keep(&mut self) {
        if let Some(retention) = &mut self.retention {
            retention.keep(self.session.simulation());
        }
    }

    /// Saves what is retentive at the end.
    pub(super) fn finish(&mut self) -> Result<(), Failure> {
        match &mut self.retention {
            Some(retention) => retention.finish(self.session.simulation()),
            None => Ok(()),
        }
    }

    /// Goes on with another form of the program, which a file holds now.
    ///
    /// # Errors
    /// It needs more memory than there is.
    pub(super) fn change(
        &mut self,
        source: &Source,
        program: Arc<Program>,
    ) -> Result<Changeover, CompileError> {
        let change = self.session.change(program)?;
        let drawing = drawing(source, self.session.simulation());
        let newest = self.session.newest_generation();
        if change == Changeover::None && newest != self.generation {
            // The session is before an earlier change.
            self.drawings.retain(|(number, _)| *number != newest);
            self.drawings.push((newest, drawing));
            return Ok(change);
        }
        let before = (
            std::mem::replace(&mut self.sheet, drawing.0),
            std::mem::replace(&mut self.members, drawing.1),
        );
        if newest != self.generation {
            self.drawings.push((self.generation, before));
            let oldest = self.session.oldest_generation();
            self.drawings.retain(|(number, _)| *number >= oldest);
            self.generation = newest;
            self.rebind();
        }
        Ok(change)
    }

    /// The number of the program that runs: another one, another drawing.
    pub(super) fn generation(&self) -> u64 {
        self.generation
    }

    /// Stepping over a change leads to another program.
    fn look_at_what_runs(&mut self) {
        let now = self.session.generation();
        if now == self.generation {
            return;
        }
        let Some(at) = self.drawings.iter().rposition(|(number, _)| *number == now) else {
            return;
        };
        let (_, (sheet, members)) = self.drawings.swap_remove(at);
        let before = (
            std::mem::replace(&mut self.sheet, sheet),
            std::mem::replace(&mut self.members, members),
        );
        self.drawings.push((self.generation, before));
        self.generation = now;
        self.rebind();
    }

    /// The tags of the program that runs now live elsewhere.
    fn rebind(&mut self) {
        let simulation = self.session.simulation();
        self.inputs.rebind(simulation);
        self.recorder.look(&self.session);
    }

    /// The tags that are watched, with their past.
    pub(super) fn watched(&self) -> &[Track] {
        self.recorder.tracks()
    }

    /// Whether a tag is watched.
    pub(super) fn watches(&self, point: &Point) -> bool {
        self.watched().iter().any(|track| track.point.name == point.name)
    }

    /// Watches a tag.
    pub(super) fn watch(&mut self, point: &Point) {
        if !self.watches(point) {
            let watched = self.watched().iter().map(|track| track.point.clone());
            let all = watched.chain([point.clone()]).collect();
            self.recorder.watch(all, &self.session);
        }
    }

    /// Watches a tag no more.
    pub(super) fn unwatch(&mut self, point: &Point) {
        let watched = self.watched().iter().map(|track| track.point.clone());
        let others = watched.filter(|other| other.name != point.name).collect();
        self.recorder.watch(others, &self.session);
    }

    /// Whether a point is fed from outside.
    pub(super) fn is_input(point: &Point) -> bool {
        point.is_input
    }
}

/// How a program begins again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Restart {
    /// All tags as before the first scan.
    Cold,
    /// Retentive tags keep their values.
    Warm,
}

fn drawing(source: &Source, simulation: &Simulation) -> Drawing {
    let members = source.members(&simulation.program().files);
    (Sheet::new(source, simulation), members)
}
