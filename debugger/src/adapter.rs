//! A session: what it holds, and its requests, one function each.

use std::collections::HashSet;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;

use ladder_analysis::Cancel;
use ladder_analysis::program::Location;
use ladder_host::{Clock, World};
use ladder_syntax::TextRange;
use ladder_workspace::shown;
use serde::Deserialize as _;
use serde_json::{Value as Json, json};

use crate::asked::Asked;
use crate::attached::Lent;
use crate::breakpoint_requests;
use crate::breakpoints::Table;
use crate::capabilities::capabilities;
use crate::configuration::{BackBy, Configuration};
use crate::flood::Flood;
use crate::launch;
use crate::messages::{
    Completions, Evaluate, Force, Initialize, Request, Scopes, SetExpression, SetVariable, StackTrace,
    StepArguments, TextOfSource, Variables,
};
use crate::outlet::{Outlet, Output};
use crate::running::{Going, Stopped};
use crate::sources::{Counting, GIVEN, Source};
use crate::stack;
use crate::stepping::Stepping;
use crate::target::Target;
use crate::variables::{self, Handles};

/// A program has one thread.
pub(crate) const THREAD: i64 = 1;

/// How far a session has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Before `initialize`.
    New,
    /// Before `launch`.
    Ready,
    /// Before `configurationDone`.
    Launched,
    /// The program runs or is.
    Live,
    /// The program is over.
    Over,
}

/// A session of the debug adapter.
pub struct Adapter {
    pub(crate) world: World,
    out: Outlet,
    /// What goes out after the answer.
    events: Vec<(&'static str, Json)>,
    pub(crate) client: Initialize,
    pub(crate) counting: Counting,
    pub(crate) phase: Phase,
    pub(crate) configuration: Configuration,
    pub(crate) target: Option<Target>,
    pub(crate) table: Table,
    pub(crate) handles: Handles,
    pub(crate) going: Option<Going>,
    /// Why it is.
    pub(crate) stopped: Option<Stopped>,
    pub(crate) stops_at_faults: bool,
    pub(crate) stops_at_expectations: bool,
    pub(crate) stops_at_violations: bool,
    /// A scan, and how many of its faults were checked.
    pub(crate) faults_seen: (u64, usize),
    /// The faults that were written.
    pub(crate) faults_reported: HashSet<(Location, String)>,
    /// After how many scans the last one was judged that was gone back into since.
    pub(crate) judged: Option<u64>,
    /// That the program has ended was shown.
    pub(crate) end_is_shown: bool,
    /// How many requests wait that a long scan is given up for.
    pub(crate) urgent: Arc<AtomicUsize>,
    /// What log points write.
    pub(crate) flood: Flood,
    /// The session belongs to a simulation of the language server.
    pub(crate) lent: Option<Lent>,
    /// The client is gone, or wants to be.
    is_left: bool,
}

impl Adapter {
    /// A session of which nothing is known yet. `urgent` counts the requests that a long scan is given up for.
    pub fn new(world: World, output: Output, urgent: Arc<AtomicUsize>) -> Adapter {
        let client = Initialize::default();
        Adapter {
            world,
            out: Outlet::new(output),
            events: Vec::new(),
            counting: Counting::of(&client),
            client,
            phase: Phase::New,
            configuration: Configuration::default(),
            target: None,
            table: Table::default(),
            handles: Handles::default(),
            going: None,
            stopped: None,
            stops_at_faults: true,
            stops_at_expectations: true,
            stops_at_violations: true,
            faults_seen: (0, 0),
            faults_reported: HashSet::new(),
            judged: None,
            end_is_shown: false,
            urgent,
            flood: Flood::default(),
            lent: None,
            is_left: false,
        }
    }

    /// Its clock.
    pub fn clock(&self) -> &Clock {
        &self.world.clock
    }

    /// Whether there is nothing more to be done.
    pub fn is_over(&self) -> bool {
        self.is_left || self.out.is_broken()
    }

    /// Whether the program runs.
    pub fn is_running(&self) -> bool {
        self.going.is_some()
    }

    /// Answers a request, and sends what follows from it.
    pub(crate) fn answered(&mut self, request: &Request, outcome: Result<Json, String>) {
        self.out.answer(request.seq, &request.command, outcome);
        self.send_events();
    }

    /// Answers something that is not a request.
    pub fn refuse(&mut self, seq: i64, problem: String) {
        self.out.answer(seq, "", Err(problem));
    }

    /// Sends the events that have come up.
    pub(crate) fn send_events(&mut self) {
        for (event, body) in std::mem::take(&mut self.events) {
            self.out.event(event, body);
        }
    }

    pub(crate) fn event(&mut self, event: &'static str, body: Json) {
        self.events.push((event, body));
    }

    /// Writes into the client's console, with the place in the program that it is about.
    pub(crate) fn write(&mut self, category: &str, text: &str, place: Option<Location>) {
        let target = self.target.as_ref();
        let place = place.and_then(|place| Some((target?.source(place.file), place.range)));
        let body = written(self.counting, category, text, place);
        self.event("output", body);
    }

    /// The same, of something that is wrong at a place in one of the files that are not the program.
    pub(crate) fn write_in(
        &mut self,
        text: &str,
        place: TextRange,
        file: impl FnOnce(&Target) -> Option<&Source>,
    ) {
        let file = self.target.as_ref().and_then(file);
        let body = written(self.counting, "stderr", text, file.map(|file| (file, place)));
        self.event("output", body);
    }

    /// Writes a remark into the client's console.
    pub(crate) fn note(&mut self, note: Option<&str>) {
        if let Some(note) = note {
            self.write("console", &format!("{note}\n"), None);
        }
    }

    /// `source`: the text of a scenario that is in no file.
    fn given_text(&self, asked: &TextOfSource) -> Result<Json, String> {
        let play = self.target.as_ref().and_then(|target| target.play.as_ref());
        let text = play.and_then(|play| play.file.given_text());
        match text.filter(|_| asked.source_reference == GIVEN) {
            Some(text) => Ok(json!({"content": text})),
            None => Err("the client reads the files by itself".into()),
        }
    }

    pub(crate) fn target(&mut self) -> Result<&mut Target, String> {
        self.target.as_mut().ok_or_else(no_program)
    }

    /// The client's session is over: what is kept is saved.
    pub fn leave(&mut self) {
        self.is_left = true;
        self.going = None;
        if self.lent.is_some()
            && let Some(target) = &mut self.target
        {
            target.session.clear_breakpoints();
        }
        if self.phase != Phase::Over
            && let Some(target) = &mut self.target
        {
            let _ = target.save();
        }
    }

    /// The program has met an error of the engine: it cannot be trusted any more.
    pub(crate) fn give_up(&mut self) {
        self.going = None;
        // One that is lent goes back.
        if self.lent.is_none() {
            self.target = None;
        }
        self.write(
            "stderr",
            "the simulator has met an error of its own and stops; please report it\n",
            None,
        );
        self.end(2);
        self.send_events();
    }

    /// What a request asks for.
    pub(crate) fn answer(&mut self, request: &Request) -> Result<Json, String> {
        match (request.command.as_str(), self.phase) {
            ("initialize", Phase::New) => return self.initialize(request),
            ("initialize", _) => return Err("the session is initialized already".into()),
            ("disconnect", _) => {
                self.leave();
                return Ok(Json::Null);
            }
            (_, Phase::New) => return Err("the first request is `initialize`".into()),
            _ => {}
        }
        match request.command.as_str() {
            "launch" => self.launch(request),
            "attach" => Err("there is nothing to attach to: a program is launched".into()),
            "configurationDone" => self.configuration_done(),
            "restart" => self.restart(request),
            "terminate" => {
                self.end_early();
                Ok(Json::Null)
            }
            "threads" => Ok(json!({"threads": [{"id": THREAD, "name": "Scan"}]})),
            "setBreakpoints" => self.set_breakpoints(&request.arguments()?),
            "setFunctionBreakpoints" | "setInstructionBreakpoints" => {
                Ok(breakpoint_requests::not_by_name(&request.arguments))
            }
            "breakpointLocations" => self.breakpoint_locations(&request.arguments()?),
            "dataBreakpointInfo" => self.data_breakpoint_info(&request.arguments()?),
            "setDataBreakpoints" => self.set_data_breakpoints(&request.arguments()?),
            "setExceptionBreakpoints" => self.set_exception_breakpoints(&request.arguments()?),
            "exceptionInfo" => self.exception_info(),
            "source" => self.given_text(&request.arguments()?),
            "stackTrace" => self.stack_trace(&request.arguments()?),
            "scopes" => {
                let Scopes { frame_id } = request.arguments()?;
                let target = self.target.as_ref().ok_or_else(no_program)?;
                Ok(json!({"scopes": variables::scopes(target, frame_id, &mut self.handles)}))
            }
            "variables" => self.variables(&request.arguments()?),
            "setVariable" => self.set_variable(&request.arguments::<SetVariable>()?),
            "setExpression" => self.set_expression(&request.arguments::<SetExpression>()?),
            "evaluate" => self.evaluate(&request.arguments::<Evaluate>()?),
            "completions" => self.completions(&request.arguments::<Completions>()?),
            "pause" => {
                self.must_be_live()?;
                if self.is_running() {
                    self.stop(Stopped::because("pause", ""));
                }
                Ok(Json::Null)
            }
            "continue" => {
                self.must_stand()?;
                self.start_run()?;
                Ok(json!({"allThreadsContinued": true}))
            }
            "reverseContinue" => {
                self.must_stand()?;
                self.run_back()?;
                Ok(Json::Null)
            }
            "next" | "stepIn" | "stepOut" | "stepBack" => {
                let StepArguments { granularity } = request.arguments()?;
                self.must_stand()?;
                match request.command.as_str() {
                    "next" => self.step(Stepping::next(granularity))?,
                    "stepIn" => self.step(Stepping::Into)?,
                    "stepOut" => self.step(Stepping::Out)?,
                    _ => self.step_back(granularity)?,
                }
                Ok(Json::Null)
            }
            "ladder/stepBackScan" => {
                self.must_stand()?;
                self.step_back_by(BackBy::Scan)?;
                Ok(Json::Null)
            }
            "ladder/force" => {
                let arguments: Force = request.arguments()?;
                let point = self.point_of_force(&arguments)?;
                let point = point.ok_or("ladder/force: `name` is missing")?;
                self.force(&point, arguments.value.as_deref(), arguments.frame_id)?;
                Ok(variables::point_json(self.target()?.simulation(), &point))
            }
            "ladder/unforce" => {
                let point = self.point_of_force(&request.arguments()?)?;
                self.unforce(point.as_ref())?;
                Ok(Json::Null)
            }
            other => Err(format!("there is no request `{other}`")),
        }
    }

    fn must_be_live(&mut self) -> Result<(), String> {
        match self.phase {
            Phase::Live => Ok(()),
            Phase::Over => Err("the program is over".into()),
            Phase::New | Phase::Ready => Err(no_program()),
            Phase::Launched => Err("the program has not begun: `configurationDone` is missing".into()),
        }
    }

    fn must_stand(&mut self) -> Result<(), String> {
        self.must_be_live()?;
        if self.is_running() {
            return Err("the program runs; pause it first".into());
        }
        Ok(())
    }

    fn initialize(&mut self, request: &Request) -> Result<Json, String> {
        self.client = request.arguments()?;
        if self
            .client
            .path_format
            .as_deref()
            .is_some_and(|format| format != "path")
        {
            return Err("files are named by their paths: pathFormat must be `path`".into());
        }
        self.counting = Counting::of(&self.client);
        self.phase = Phase::Ready;
        Ok(capabilities())
    }

    fn launch(&mut self, request: &Request) -> Result<Json, String> {
        if self.phase != Phase::Ready {
            return Err("the program is launched already".into());
        }
        if self.lent.is_some() {
            self.configuration = request.arguments()?;
            self.configuration.speed()?;
        } else {
            self.load(request.arguments()?)?;
        }
        self.phase = Phase::Launched;
        // Breakpoints can be placed only now.
        self.event("initialized", Json::Null);
        Ok(Json::Null)
    }

    fn load(&mut self, configuration: Configuration) -> Result<(), String> {
        configuration.speed()?;
        // The file of retentive tags is in use by the program that ran before.
        if let Some(mut before) = self.target.take() {
            let _ = before.save();
        }
        let (mut target, notes) = launch::load(&configuration, &self.world)?;
        let urgent = self.urgent.clone();
        target.session.set_cancel(Some(Cancel::when(move || {
            urgent.load(std::sync::atomic::Ordering::SeqCst) > 0
        })));
        self.target = Some(target);
        self.configuration = configuration;
        self.faults_seen = (0, 0);
        self.faults_reported.clear();
        self.judged = None;
        self.end_is_shown = false;
        for note in &notes {
            self.note(Some(note));
        }
        Ok(())
    }

    fn configuration_done(&mut self) -> Result<Json, String> {
        match self.phase {
            Phase::Launched => self.begin()?,
            Phase::Ready => return Err(no_program()),
            _ => {}
        }
        Ok(Json::Null)
    }

    /// The program begins.
    fn begin(&mut self) -> Result<(), String> {
        self.phase = Phase::Live;
        self.arm();
        if let Some(Lent::Joined { runs }) = self.lent {
            return self.begin_where_it_is(runs);
        }
        if self.configuration.stop_on_entry && !self.configuration.no_debug {
            self.stop(Stopped::because("entry", "Before the first scan"));
            return Ok(());
        }
        self.start_run()
    }

    /// What ran goes on, and what did not is shown where it is.
    fn begin_where_it_is(&mut self, runs: bool) -> Result<(), String> {
        if runs {
            return self.start_run();
        }
        self.stop(Stopped::because("pause", ""));
        Ok(())
    }

    /// The program of a simulation begins again from cold, with what a configuration gives it.
    fn load_again(&mut self, configuration: Configuration) -> Result<(), String> {
        configuration.speed()?;
        let asked = Asked::of(&configuration, &self.world)?;
        let target = self.target()?;
        if target.file_of(asked.program()) != Some(0) {
            return Err(format!(
                "{} is another program: start it instead of this one",
                shown::path(asked.program())
            ));
        }
        target.session.unforce_all();
        target.session.reset();
        let mut given = asked.give(&mut target.session)?;
        let problem = given.problem.take();
        target.gives(given);
        self.note(problem.as_deref());
        self.configuration = configuration;
        self.lent = Some(Lent::New);
        self.faults_reported.clear();
        self.led_elsewhere();
        Ok(())
    }

    /// The simulation was led to another scan: what was given and found there before is of another past.
    pub(crate) fn led_elsewhere(&mut self) {
        self.faults_seen = (0, 0);
        self.judged = None;
        self.end_is_shown = false;
        if let Some(target) = &mut self.target {
            target.give_again();
        }
    }

    /// The program has another text. Breakpoints stay in the lines where they were.
    pub(crate) fn sources_are(&mut self, sources: Vec<Source>, lines: &[Option<u32>]) {
        let counting = self.counting;
        let Some(target) = &mut self.target else {
            return;
        };
        target.sources = sources;
        if let Some(own) = target.sources.first() {
            self.table
                .move_lines(|path| target.is(own, path), lines, counting);
        }
        let reported = self.table.place_again(target, counting);
        let (problems, fits) = target.bind_again();
        for problem in &problems {
            self.note(Some(problem));
        }
        self.arm();
        self.handles.clear();
        for breakpoint in reported {
            self.event(
                "breakpoint",
                json!({"reason": "changed", "breakpoint": breakpoint}),
            );
        }
        if !fits {
            self.end(1);
        }
    }

    fn restart(&mut self, request: &Request) -> Result<Json, String> {
        if matches!(self.phase, Phase::Ready) {
            return Err(no_program());
        }
        let configuration = match request.new_configuration() {
            Some(new) => Configuration::deserialize(new).map_err(|error| format!("restart: {error}"))?,
            None => self.configuration.clone(),
        };
        self.going = None;
        self.forget_stop();
        if self.lent.is_some() {
            self.load_again(configuration)?;
        } else if let Err(problem) = self.load(configuration) {
            self.phase = Phase::Live;
            self.end(1);
            return Err(problem);
        }
        let target = self.target.as_ref().ok_or_else(no_program)?;
        for reported in self.table.place_again(target, self.counting) {
            self.event("breakpoint", json!({"reason": "changed", "breakpoint": reported}));
        }
        self.begin()?;
        Ok(Json::Null)
    }

    fn stack_trace(&mut self, arguments: &StackTrace) -> Result<Json, String> {
        let place = self.stopped.as_ref().and_then(|stopped| stopped.place);
        let counting = self.counting;
        let frames = stack::frames(self.target()?, place, counting);
        let total = frames.len();
        let start = arguments.start_frame.unwrap_or(0);
        let levels = arguments
            .levels
            .filter(|&levels| levels > 0)
            .unwrap_or(usize::MAX);
        let frames: Vec<Json> = frames.into_iter().skip(start).take(levels).collect();
        Ok(json!({"stackFrames": frames, "totalFrames": total}))
    }

    fn variables(&mut self, arguments: &Variables) -> Result<Json, String> {
        let target = self.target.as_ref().ok_or_else(no_program)?;
        // A client may ask just as the program goes on. That is not an error of a person, and asked again it is answered.
        let Ok(container) = self.handles.get(arguments.reference) else {
            return Ok(json!({"variables": []}));
        };
        let window = (arguments.start.unwrap_or(0), arguments.count);
        let filter = arguments.filter.as_deref();
        let listed = variables::list(target, &container, filter, window, &mut self.handles);
        Ok(json!({"variables": listed}))
    }
}

/// What is written, with the place that it is about.
fn written(counting: Counting, category: &str, text: &str, place: Option<(&Source, TextRange)>) -> Json {
    let mut body = json!({"category": category, "output": text});
    if let Some((source, place)) = place {
        let range = counting.range(source, place);
        body["source"] = source.json();
        body["line"] = range["line"].clone();
        body["column"] = range["column"].clone();
    }
    body
}

/// Nothing is launched.
pub(crate) fn no_program() -> String {
    "no program is launched".into()
}
