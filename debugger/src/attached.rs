//! The adapter of a simulation that the language server runs: the session is lent to it for each piece of its work.

use std::path::Path;
use std::sync::Arc;

use ladder_analysis::analyze;
use ladder_host::{Moment, World};
use ladder_live::{Beginning, Debugger, Ground, Halt, Keeping, ProgramFile};
use ladder_simulator::{HistoryLimits, Options, Session};
use ladder_syntax::parse;
use serde::Deserialize as _;
use serde_json::{Value as Json, json};

use crate::adapter::{Adapter, Phase, THREAD};
use crate::asked::Asked;
use crate::configuration::Configuration;
use crate::launch::must_be_program;
use crate::messages::Request;
use crate::outlet::Output;
use crate::running::{Going, Stopped};
use crate::sources::Source;
use crate::stepping::Stepping;
use crate::target::Target;

/// What is to be debugged, as the configuration of a launch says it. Reads the scenario that it names.
pub struct Launch(Asked);

impl Launch {
    /// Reads a configuration.
    ///
    /// # Errors
    /// What it says cannot be debugged: a sentence for the person.
    pub fn read(configuration: &Json, world: World) -> Result<Launch, String> {
        let configuration = Configuration::deserialize(configuration).map_err(|error| error.to_string())?;
        configuration.speed()?;
        let asked = Asked::of(&configuration, &world)?;
        must_be_program(asked.program())?;
        Ok(Launch(asked))
    }

    /// The file of the program.
    pub fn program(&self) -> &Path {
        self.0.program()
    }

    /// Whether it begins from cold, whatever runs already.
    pub fn is_scenario(&self) -> bool {
        self.0.is_scenario()
    }

    /// The time from one scan to the next, in nanoseconds, if it is given.
    ///
    /// # Errors
    /// It is not a time that a scan can take.
    pub fn interval(&self) -> Result<Option<i64>, String> {
        self.0.interval()
    }

    /// How many scans can be stepped back, if it is given.
    pub fn history(&self) -> Option<u64> {
        self.0.configuration().history
    }

    /// How many times as fast as real time it runs; none for as fast as it goes.
    ///
    /// # Errors
    /// It is not a speed.
    pub fn speed(&self) -> Result<Option<f64>, String> {
        self.0.configuration().speed()
    }

    /// Where retentive tags are kept.
    ///
    /// # Errors
    /// The file may not be used for that.
    pub fn keeping(&self) -> Result<Keeping, String> {
        self.0.keeping()
    }

    /// The debugger, for the turns of the simulation, in which its messages go out.
    pub fn begin(self, output: Output, is_joined: bool) -> Beginning {
        let world = self.0.world().clone();
        Beginning(Box::new(move |ground: Ground<'_>| {
            let given = self.0.give(ground.session)?;
            let mut adapter = Adapter::new(world.clone(), output, ground.urgent);
            adapter.note(given.problem.as_deref());
            adapter.target = Some(Target::new(world, spare()?, sources(ground.files), given, None));
            adapter.lent = Some(if is_joined {
                Lent::Joined {
                    runs: ground.is_running,
                }
            } else {
                Lent::New
            });
            Ok(Box::new(Attached { adapter }))
        }))
    }
}

/// Whether a long scan is given up for a message.
pub fn is_urgent(message: &Json) -> bool {
    Request::of(message.clone()).is_ok_and(|request| request.is_urgent())
}

/// The answer to a request for a debugger whose simulation is over.
pub fn answer_of_none(message: &Json) -> Option<Json> {
    let request = Request::of(message.clone()).ok()?;
    let is_goodbye = matches!(request.command.as_str(), "disconnect" | "terminate");
    Some(json!({
        "seq": 0,
        "type": "response",
        "request_seq": request.seq,
        "command": request.command,
        "success": is_goodbye,
        "message": "the simulation is over",
    }))
}

/// What a session that is lent did before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lent {
    /// It was started to be debugged.
    New,
    /// It was there, and ran or not.
    Joined { runs: bool },
}

/// Takes the place of a session that is not lent.
fn spare() -> Result<Session, String> {
    let analysis = analyze(&Arc::new(parse("")), "");
    let program = analysis.program().cloned().ok_or("an empty program is one")?;
    Session::new(program, Options::default(), HistoryLimits::of_scans(0)).map_err(|error| error.to_string())
}

fn sources(files: Vec<ProgramFile>) -> Vec<Source> {
    let files = files.into_iter();
    files
        .map(|file| Source::of_member(file.path, &file.text))
        .collect()
}

struct Attached {
    adapter: Adapter,
}

impl Attached {
    /// Does something with the session.
    fn with<R>(&mut self, session: &mut Session, work: impl FnOnce(&mut Adapter) -> R) -> R {
        self.swap(session);
        let result = work(&mut self.adapter);
        self.swap(session);
        result
    }

    fn swap(&mut self, session: &mut Session) {
        if let Some(target) = &mut self.adapter.target {
            std::mem::swap(&mut target.session, session);
        }
    }
}

impl Debugger for Attached {
    fn receive(&mut self, session: &mut Session, message: &Json) -> bool {
        let seq = message.get("seq").and_then(Json::as_i64).unwrap_or(0);
        match Request::of(message.clone()) {
            Ok(request) => {
                self.with(session, |adapter| adapter.handle(&request));
                request.changes()
            }
            Err(problem) => {
                self.adapter.refuse(seq, problem.message);
                false
            }
        }
    }

    fn go_on(&mut self, session: &mut Session) {
        self.with(session, Adapter::run_on);
    }

    fn step(&mut self, session: &mut Session, by_block: bool) {
        let step = if by_block {
            Stepping::Into
        } else {
            Stepping::next(None)
        };
        self.with(session, |adapter| {
            // What cannot be stepped any more has said so.
            let _ = adapter.step(step);
            adapter.send_events();
        });
    }

    fn is_running(&self) -> bool {
        self.adapter.is_running()
    }

    fn keeps_to_clock(&self) -> bool {
        !matches!(self.adapter.going, Some(Going::Back))
    }

    fn waits(&self) -> Option<Moment> {
        self.adapter.flood.until()
    }

    fn is_live(&self) -> bool {
        self.adapter.phase == Phase::Live
    }

    fn is_gone(&self) -> bool {
        self.adapter.is_over()
    }

    fn resumed(&mut self) {
        self.adapter.forget_stop();
        self.adapter.going = Some(Going::Forward(None));
        self.adapter.event(
            "continued",
            json!({"threadId": THREAD, "allThreadsContinued": true}),
        );
        self.adapter.send_events();
    }

    fn halted(&mut self, why: Halt) {
        let reason = match why {
            Halt::Pause => "pause",
            Halt::Step => "step",
            Halt::Elsewhere => "goto",
        };
        if why == Halt::Elsewhere {
            self.adapter.led_elsewhere();
        }
        self.adapter.stop(Stopped::because(reason, ""));
        self.adapter.send_events();
    }

    fn given(&mut self) {
        self.adapter.has_changed();
        self.adapter.send_events();
    }

    fn moved(&mut self, session: &mut Session, files: Vec<ProgramFile>, lines: &[Option<u32>]) {
        self.with(session, |adapter| {
            adapter.sources_are(sources(files), lines);
            adapter.send_events();
        });
    }

    fn ended(&mut self) {
        self.adapter.end_early();
        self.adapter.send_events();
    }
}
