//! One simulation, on a thread of its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError, channel};
use std::time::{Duration, Instant};

use ladder_simulator::Brake;
use ladder_syntax::TextSize;
use serde::Serialize;
use serde_json::Value;
use tokio::sync::{oneshot, watch};

use super::engine::Engine;
use super::messages::{Found, History, Hit, Options, Recorded, Search, Shown, State, Status, Why};
use super::request::Failure;
use crate::cancel::Cancel;
use crate::document::Revision;

/// How often a run reports: twenty times a second.
pub(crate) const REPORT: Duration = Duration::from_millis(50);

/// How often a run is shown to a client that says what it shows, if it keeps up: thirty times a second.
const SHOW: Duration = Duration::from_millis(33);

/// The longest time between two scans: a day.
const NEVER: Duration = Duration::from_secs(86_400);

/// What a session is asked to do.
#[derive(Debug)]
pub(crate) enum Action {
    /// Do so many scans, then pause.
    Step(u64),
    /// Go on to the next block.
    StepBlock,
    /// Go on to the next rung.
    StepRung,
    /// Go back so many scans.
    Back(u64),
    /// These lines of rungs and these tags stop a run.
    Breakpoints(Vec<u32>, Vec<String>),
    /// Say why a tag holds what it holds.
    Why(String),
    /// Make a scenario of this name of what was done so far.
    Record(String),
    /// Say what tags held in the last scans.
    History(Vec<String>, u64),
    /// Scan until told otherwise.
    Run {
        /// Pause after so many scans.
        scans: Option<u64>,
        /// So many times as fast as real time; as fast as it goes if there is no number.
        speed: Option<f64>,
    },
    /// Stop scanning.
    Pause,
    /// Give a tag a value.
    Set(String, Value),
    /// Hold a tag at a value.
    Force(String, Value),
    /// Let a tag go, or all.
    Unforce(Option<String>),
    /// Nothing: only answer.
    State,
    /// Tell only of this from now on.
    Show(Shown),
    /// The client has shown what it was told.
    HasShown,
    /// List tags.
    Tags(Search),
    /// Say what the operand at a place holds.
    ValuesAt(TextSize),
    /// Start again from cold.
    Reset,
    /// Start again with what is retentive.
    WarmRestart,
    /// The text in the editor is another one.
    Follow(Arc<Revision>),
    /// End.
    Stop,
}

impl Action {
    /// Whether a step that is under way gives way to it.
    fn is_urgent(&self) -> bool {
        matches!(
            self,
            Action::Pause | Action::Reset | Action::WarmRestart | Action::Back(_) | Action::Stop
        )
    }

    /// Whether the simulation stands differently behind it.
    fn changes(&self) -> bool {
        !matches!(
            self,
            Action::State
                | Action::Why(_)
                | Action::Record(_)
                | Action::History(..)
                | Action::Tags(_)
                | Action::ValuesAt(_)
        )
    }
}

/// What a session answers.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum Answer {
    /// How it stands.
    State(Box<State>),
    /// Reasons.
    Why(Box<Why>),
    /// A scenario.
    Recorded(Recorded),
    /// Values of the past.
    History(History),
    /// Tags that were searched for.
    Found(Found),
    /// Values, in words.
    Values(Vec<String>),
}

struct Command {
    action: Action,
    cancel: Cancel,
    reply: oneshot::Sender<Result<Answer, Failure>>,
}

/// The handle of a session's thread. The thread ends when it is told to stop, or when the handle is dropped.
#[derive(Debug)]
pub(crate) struct Session {
    /// Its name.
    pub id: String,
    /// The document it runs.
    pub uri: Arc<str>,
    commands: Sender<Command>,
    /// How many urgent commands wait.
    urgent: Arc<AtomicUsize>,
    /// How many texts wait to be followed.
    texts: Arc<AtomicUsize>,
    /// Whether the client has shown what it was told last.
    has_shown: Arc<AtomicBool>,
}

impl Session {
    /// Starts the thread of a program. Compiles it first: for a blocking thread. The receiver shows the newest
    /// state, from before the first scan on.
    pub(crate) fn start(
        id: String,
        revision: Arc<Revision>,
        options: &Options,
    ) -> Result<(Self, watch::Receiver<State>, Vec<String>), Failure> {
        let (commands, inbox) = channel();
        let urgent = Arc::<AtomicUsize>::default();
        let uri = revision.uri.clone();
        let (mut engine, notes) = Engine::start(revision, options)?;
        engine.obey(brake(&urgent, &Cancel::default()));
        let mut simulation = Simulation {
            id: id.clone(),
            engine,
            status: Status::Paused,
            hit: None,
            answers: 0,
            whole: false,
        };
        let (states, receiver) = watch::channel(simulation.state(Telling::Picture));
        let has_shown = Arc::new(AtomicBool::new(true));
        let texts = Arc::<AtomicUsize>::default();
        let runner = Runner {
            simulation,
            run: None,
            inbox,
            urgent: urgent.clone(),
            texts: texts.clone(),
            has_shown: has_shown.clone(),
            owes: false,
            shown: Instant::now(),
            states,
        };
        std::thread::Builder::new()
            .name(format!("simulation {id}"))
            .spawn(move || runner.work())
            .map_err(|error| Failure::Failed(format!("no thread for the simulation: {error}")))?;
        let session = Session {
            id,
            uri,
            commands,
            urgent,
            texts,
            has_shown,
        };
        Ok((session, receiver, notes))
    }

    /// Hands over an action and returns where its answer will arrive. An answer that nobody waits for is no
    /// mistake; `cancel` stops a step before its end.
    pub(crate) fn ask(&self, action: Action, cancel: Cancel) -> oneshot::Receiver<Result<Answer, Failure>> {
        let (reply, answer) = oneshot::channel();
        if action.is_urgent() {
            self.urgent.fetch_add(1, Ordering::SeqCst);
        }
        if matches!(action, Action::Follow(_)) {
            self.texts.fetch_add(1, Ordering::SeqCst);
        }
        if matches!(action, Action::HasShown) {
            // A long step does not look at what waits.
            self.has_shown.store(true, Ordering::SeqCst);
        }
        // When the thread is gone, so is the other end of `reply`: the caller sees that.
        let _ = self.commands.send(Command {
            action,
            cancel,
            reply,
        });
        answer
    }
}

/// Stops a scan that takes long, so that the session can serve an urgent command.
fn brake(urgent: &Arc<AtomicUsize>, cancel: &Cancel) -> Brake {
    let (urgent, cancel) = (urgent.clone(), cancel.clone());
    Brake::new(move || urgent.load(Ordering::SeqCst) > 0 || cancel.is_cancelled())
}

/// A run that goes on between commands.
#[derive(Debug, Clone, Copy)]
struct Going {
    left: Option<u64>,
    /// When the next scan is due, and the time from one to the next, for a run that keeps to a clock.
    due: Option<(Instant, Duration)>,
    reported: Instant,
}

/// How much a state tells of the drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Telling {
    /// Tags and power; to a client that says what it shows what has changed there.
    Picture,
    /// Nothing to a client that says what it shows: what has changed comes with the next notification.
    Answer,
}

/// The program and how it stands.
struct Simulation {
    id: String,
    engine: Engine,
    status: Status,
    /// What the client is told next is all of what it shows.
    whole: bool,
    /// The breakpoint that stopped the last run.
    hit: Option<Hit>,
    /// How many answers were given.
    answers: u64,
}

impl Simulation {
    /// One scan, up to a breakpoint.
    fn scan(&mut self) {
        self.hit = self.engine.scan();
        self.take_status();
        if self.hit.is_some() && self.status == Status::Running {
            self.status = Status::Paused;
        }
    }

    /// What the program itself says about going on.
    fn take_status(&mut self) {
        match (self.engine.status(), self.status) {
            (ladder_simulator::Status::Ready, Status::Running) => {}
            (ladder_simulator::Status::Ready, _) => self.status = Status::Paused,
            (ladder_simulator::Status::Ended, _) => self.status = Status::Ended,
            (ladder_simulator::Status::Faulted, _) => self.status = Status::Faulted,
        }
    }

    fn state(&mut self, telling: Telling) -> State {
        let engine = &mut self.engine;
        let in_part = engine.is_shown_in_part();
        let whole = telling == Telling::Picture && std::mem::take(&mut self.whole);
        let (tags, power, operands) = if in_part && telling == Telling::Answer {
            Default::default()
        } else {
            engine.news()
        };
        State {
            session: self.id.clone(),
            uri: engine.revision().uri.to_string(),
            version: engine.revision().version,
            stale: engine.texts.stale,
            change: engine.texts.change.clone(),
            status: self.status,
            scan: engine.scans(),
            time_ms: engine.time_ms(),
            behind: engine.behind(),
            ahead: engine.ahead(),
            next: engine.next(),
            hit: self.hit.clone(),
            breakpoints: engine.breakpoints(),
            forced: engine.forced(),
            delta: in_part && !whole,
            answers: self.answers,
            commands: in_part.then_some(self.answers),
            operands,
            tags,
            power,
            faults: engine.faults(),
        }
    }
}

/// The thread's own side.
struct Runner {
    simulation: Simulation,
    run: Option<Going>,
    inbox: Receiver<Command>,
    urgent: Arc<AtomicUsize>,
    /// How many texts wait to be followed.
    texts: Arc<AtomicUsize>,
    /// Whether the client has shown what it was told last.
    has_shown: Arc<AtomicBool>,
    /// There is something that it has not been told yet.
    owes: bool,
    /// When it was told last.
    shown: Instant,
    states: watch::Sender<State>,
}

impl Runner {
    fn work(mut self) {
        loop {
            let command = match self.run {
                None => self.inbox.recv().map_err(|_| RecvTimeoutError::Disconnected),
                Some(Going { due: None, .. }) => self.inbox.try_recv().map_err(|error| match error {
                    TryRecvError::Empty => RecvTimeoutError::Timeout,
                    TryRecvError::Disconnected => RecvTimeoutError::Disconnected,
                }),
                Some(Going {
                    due: Some((due, _)), ..
                }) => self.wait_until(due),
            };
            match command {
                Ok(command) => {
                    if self.serve(command) == Next::Leave {
                        return;
                    }
                }
                Err(RecvTimeoutError::Timeout) => self.go_on(),
                Err(RecvTimeoutError::Disconnected) => {
                    self.simulation.engine.save();
                    return;
                }
            }
        }
    }

    /// Waits for a command, until the next scan is due. What the client waits for meanwhile it is told in time.
    fn wait_until(&mut self, due: Instant) -> Result<Command, RecvTimeoutError> {
        let telling = self.shown + SHOW;
        if self.may_show() && self.owes && telling < due {
            let waited = self
                .inbox
                .recv_timeout(telling.saturating_duration_since(Instant::now()));
            if !matches!(waited, Err(RecvTimeoutError::Timeout)) {
                return waited;
            }
            self.publish();
        }
        self.inbox
            .recv_timeout(due.saturating_duration_since(Instant::now()))
    }

    /// Whether the client takes what it shows, and has shown what it was told before.
    fn may_show(&self) -> bool {
        self.simulation.engine.is_shown_in_part() && self.has_shown.load(Ordering::SeqCst)
    }

    fn serve(
        &mut self,
        Command {
            action,
            cancel,
            reply,
        }: Command,
    ) -> Next {
        if action.is_urgent() {
            self.urgent.fetch_sub(1, Ordering::SeqCst);
        }
        let next = if matches!(action, Action::Stop) {
            Next::Leave
        } else {
            Next::Stay
        };
        let outcome = match action {
            Action::Why(tag) => self
                .simulation
                .engine
                .why(&tag)
                .map(|why| Answer::Why(Box::new(why))),
            Action::History(tags, scans) => {
                let past = self.simulation.engine.past(&tags, scans);
                past.map(Answer::History)
            }
            Action::Record(name) => self.simulation.engine.record(&name).map(Answer::Recorded),
            Action::Tags(search) => Ok(Answer::Found(self.simulation.engine.search(&search))),
            Action::ValuesAt(offset) => Ok(Answer::Values(self.simulation.engine.values_at(offset))),
            Action::HasShown => {
                // A run tells by itself.
                if self.owes && self.run.is_none() {
                    self.publish();
                }
                return Next::Stay;
            }
            action => self.change(action, &cancel),
        };
        let _ = reply.send(outcome);
        next
    }

    fn change(&mut self, action: Action, cancel: &Cancel) -> Result<Answer, Failure> {
        let changes = action.changes();
        self.act(action, cancel)?;
        self.simulation.answers += 1;
        let state = self.simulation.state(Telling::Answer);
        if self.simulation.engine.is_shown_in_part() {
            self.owes |= changes;
            if changes {
                self.publish();
            }
        } else if changes {
            self.states.send_replace(state.clone());
        }
        Ok(Answer::State(Box::new(state)))
    }

    fn act(&mut self, action: Action, cancel: &Cancel) -> Result<(), Failure> {
        match action {
            Action::Step(scans) => {
                self.pause();
                self.step(scans, cancel);
            }
            Action::StepBlock | Action::StepRung => {
                self.pause();
                self.simulation.hit = None;
                if self.simulation.status == Status::Paused {
                    let by_block = matches!(action, Action::StepBlock);
                    self.simulation.engine.step_within_scan(by_block);
                    self.simulation.take_status();
                }
            }
            Action::Back(scans) => {
                self.pause();
                self.simulation.hit = None;
                self.simulation.engine.back(scans);
                self.simulation.take_status();
            }
            Action::Breakpoints(lines, tags) => {
                self.simulation.engine.set_breakpoints(&lines, &tags)?;
            }
            // They change nothing and are answered where they arrive.
            Action::Why(_)
            | Action::Record(_)
            | Action::History(..)
            | Action::Tags(_)
            | Action::ValuesAt(_)
            | Action::HasShown => {}
            Action::WarmRestart => {
                self.run = None;
                self.simulation.hit = None;
                self.simulation.engine.warm_restart()?;
                self.simulation.status = Status::Paused;
            }
            Action::Run { scans, speed } => self.start_run(scans, speed),
            Action::Show(shown) => self.simulation.engine.show(&shown),
            Action::Pause => self.pause(),
            Action::Set(tag, value) => self.simulation.engine.set(&tag, &value)?,
            Action::Force(tag, value) => self.simulation.engine.force(&tag, &value)?,
            Action::Unforce(tag) => self.simulation.engine.unforce(tag.as_deref())?,
            Action::State => {}
            Action::Reset => {
                self.run = None;
                self.simulation.hit = None;
                self.simulation.engine.reset()?;
                self.simulation.status = Status::Paused;
            }
            Action::Follow(revision) => {
                // Of several that wait the last one counts.
                if self.texts.fetch_sub(1, Ordering::SeqCst) == 1 {
                    self.follow(revision);
                }
            }
            Action::Stop => {
                self.run = None;
                self.simulation.engine.save();
                self.simulation.status = Status::Ended;
            }
        }
        Ok(())
    }

    fn follow(&mut self, revision: Arc<Revision>) {
        let is_another = self.simulation.engine.follow(revision);
        self.simulation.whole = true;
        if is_another {
            self.simulation.hit = None;
            // What was hung may go on.
            self.simulation.take_status();
        }
    }

    fn pause(&mut self) {
        self.run = None;
        if self.simulation.status == Status::Running {
            self.simulation.status = Status::Paused;
        }
    }

    /// Scans until done, until nobody waits for it, or until an urgent command wants to be heard. Other commands
    /// wait: a `set` that was sent behind a `step` takes effect behind it.
    fn step(&mut self, scans: u64, cancel: &Cancel) {
        if self.simulation.status != Status::Paused {
            return;
        }
        self.simulation.status = Status::Running;
        self.simulation.engine.obey(brake(&self.urgent, cancel));
        let mut reported = Instant::now();
        for _ in 0..scans {
            let interrupted = cancel.is_cancelled() || self.urgent.load(Ordering::SeqCst) > 0;
            if interrupted || self.simulation.status != Status::Running {
                break;
            }
            self.simulation.scan();
            self.owes = true;
            if reported.elapsed() >= self.report() {
                reported = Instant::now();
                self.publish();
            }
        }
        let nobody = Cancel::default();
        self.simulation.engine.obey(brake(&self.urgent, &nobody));
        self.pause();
    }

    fn start_run(&mut self, scans: Option<u64>, speed: Option<f64>) {
        let can_run = matches!(self.simulation.status, Status::Paused | Status::Running);
        if can_run && scans != Some(0) {
            let now = Instant::now();
            let interval = self.simulation.engine.interval();
            // An interval that is too long to be counted never ends.
            let pace =
                |speed: f64| Duration::try_from_secs_f64(interval.as_secs_f64() / speed).unwrap_or(NEVER);
            self.simulation.status = Status::Running;
            self.run = Some(Going {
                left: scans,
                due: speed.map(|speed| (now, pace(speed).min(NEVER))),
                reported: now,
            });
        } else {
            self.pause();
        }
    }

    /// One scan of a run.
    fn go_on(&mut self) {
        let Some(mut run) = self.run else { return };
        self.simulation.scan();
        let now = Instant::now();
        run.left = run.left.map(|left| left - 1);
        // A scan that takes longer than its interval makes the simulation slow; it does not make it catch up.
        run.due = run.due.map(|(due, pace)| ((due + pace).max(now), pace));
        self.owes = true;
        if self.simulation.status != Status::Running || run.left == Some(0) {
            self.pause();
            self.publish();
            return;
        }
        if now - run.reported >= self.report() {
            run.reported = now;
            self.publish();
        }
        self.run = Some(run);
    }

    /// How often a run reports.
    fn report(&self) -> Duration {
        if self.simulation.engine.is_shown_in_part() {
            SHOW
        } else {
            REPORT
        }
    }

    /// Tells the client how things stand; one that says what it shows only when it has shown what it was told before.
    fn publish(&mut self) {
        if self.simulation.engine.is_shown_in_part() && !self.has_shown.swap(false, Ordering::SeqCst) {
            return;
        }
        self.owes = false;
        self.shown = Instant::now();
        self.states.send_replace(self.simulation.state(Telling::Picture));
    }
}

#[derive(PartialEq, Eq)]
enum Next {
    Stay,
    Leave,
}
