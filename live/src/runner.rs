//! What a simulation does in its turns: scans, and the commands between them.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll};
use std::time::Duration;

use futures::StreamExt;
use futures::channel::mpsc::UnboundedReceiver;
use ladder_analysis::Cancel;
use ladder_documents::Revision;
use ladder_host::newest::Sender;
use ladder_host::{Clock, Moment, Turns, Wait, Work};

use crate::action::{Action, Answer, Pace};
use crate::debugging::Effect;
use crate::messages::{State, Status};
use crate::queue::Queue;
use crate::request::Failure;
use crate::running_program::{Detail, Simulation};
use crate::session::Command;

/// How often a run reports: twenty times a second.
pub const REPORT: Duration = Duration::from_millis(50);

/// How often a run is shown to a client that says what it shows, if it keeps up: thirty times a second.
const SHOW: Duration = Duration::from_millis(33);

/// The longest time between two scans: a day.
const NEVER: Duration = Duration::from_secs(86_400);

/// A run that goes on between commands.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Going {
    left: Option<u64>,
    /// When the next scan is due, and the time from one to the next, for a run that keeps to a clock.
    due: Option<(Moment, Duration)>,
    reported: Moment,
}

/// The session's own side.
pub(crate) struct Runner {
    pub(crate) simulation: Simulation,
    pub(crate) run: Option<Going>,
    pub(crate) inbox: UnboundedReceiver<Command>,
    pub(crate) queue: Arc<Queue>,
    /// Whether the client has shown what it was sent last.
    pub(crate) has_shown: Arc<AtomicBool>,
    /// There is something that it has not been sent yet.
    pub(crate) owes: bool,
    /// When it was last sent something.
    pub(crate) shown: Moment,
    pub(crate) clock: Clock,
    pub(crate) states: Sender<State>,
    /// The last field: it counts until all others are dropped.
    pub(crate) _running: Work,
}

impl Turns for Runner {
    /// Serves a command if there is one, else does a scan if one is due, until nobody can send any more or one says that it
    /// is over.
    fn turn(&mut self, context: &mut Context<'_>) -> Wait {
        match self.inbox.poll_next_unpin(context) {
            Poll::Ready(Some(command)) => return self.serve(command),
            Poll::Ready(None) => {
                self.tell_debugger(Effect::End);
                self.simulation.engine.let_go_of_file();
                return Wait::Over;
            }
            Poll::Pending => {}
        }
        let Some(run) = self.run else {
            return Wait::Arrival;
        };
        let now = self.clock.now();
        let waits = self.simulation.debugger().and_then(|debugger| debugger.waits());
        match run.due.map(|(due, _)| due).max(waits) {
            Some(due) if now < due => self.wait_until(now, due),
            _ => {
                self.go_on();
                Wait::No
            }
        }
    }
}

impl Runner {
    /// The next scan is due later. What the client waits for meanwhile is sent in time.
    fn wait_until(&mut self, now: Moment, due: Moment) -> Wait {
        let may_show = self.shown + SHOW;
        if !self.may_show() || !self.owes || may_show >= due {
            return Wait::Until(due);
        }
        if now < may_show {
            return Wait::Until(may_show);
        }
        self.publish();
        Wait::No
    }

    /// Whether the client takes what it shows, and has shown what it was sent before.
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
    ) -> Wait {
        self.queue.leave(&action);
        let next = if matches!(action, Action::Stop) {
            Wait::Over
        } else {
            Wait::No
        };
        if let Err(refused) = self.simulation.engine.check_may(&action) {
            let _ = reply.send(Err(refused));
            return Wait::No;
        }
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
            Action::Trace(asked) => {
                let traced = self.simulation.engine.trace(&asked);
                traced.map(|traced| Answer::Trace(Box::new(traced)))
            }
            Action::DiagramText(asked) => {
                let drawn = self.simulation.engine.diagram_text(&asked);
                drawn.map(Answer::DiagramText)
            }
            Action::Scene(uri, scene) => {
                let shown = self.simulation.engine.show_scene(uri, *scene);
                Ok(Answer::Scene(Box::new(shown)))
            }
            Action::Record(name, outputs) => {
                let engine = &mut self.simulation.engine;
                engine.obey(self.queue.cancel_of_command(&cancel));
                let recorded = engine.record(&name, outputs.as_deref());
                engine.obey(self.queue.cancel_of_run());
                recorded.map(Answer::Recorded)
            }
            Action::Tags(search) => Ok(Answer::Found(self.simulation.engine.search(&search))),
            Action::ValuesAt(offset) => Ok(Answer::Values(self.simulation.engine.values_at(offset))),
            // What it gives is shown like what any command has done, but is the answer to none.
            Action::Debug(beginning) => self.begin_debugging(beginning).map(|()| Answer::Debugged),
            Action::Message(message, _) => {
                self.debug(&message);
                return Wait::No;
            }
            Action::HasShown => {
                // A run publishes by itself.
                if self.owes && self.run.is_none() {
                    self.publish();
                }
                return Wait::No;
            }
            // What does not concern the program is not an update for who shows it.
            Action::FollowOthers(revision) if !self.concerned_by_others(&revision) => return Wait::No,
            action => self.change(action, &cancel),
        };
        let _ = reply.send(outcome);
        next
    }

    fn change(&mut self, action: Action, cancel: &Cancel) -> Result<Answer, Failure> {
        let (changes, effect) = (action.changes(), action.effect());
        self.act(action, cancel)?;
        self.tell_debugger(effect);
        self.simulation.answers += 1;
        let state = self.simulation.state(Detail::Answer);
        if self.simulation.engine.is_shown_in_part() {
            self.owes |= changes;
            if changes {
                self.publish();
            }
        } else if changes {
            self.states.send(state.clone());
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
                    if !self.simulation.step_debugged(by_block) {
                        self.simulation.engine.step_within_scan(by_block);
                    }
                    self.simulation.take_status();
                }
            }
            Action::Back(scans) => {
                self.pause();
                self.simulation.hit = None;
                self.simulation.engine.back(scans);
                self.simulation.take_status();
            }
            Action::GoTo(scan) => {
                self.pause();
                self.simulation.engine.go_to(scan)?;
                self.simulation.hit = None;
                self.simulation.take_status();
            }
            Action::Breakpoints(..) if self.simulation.debugger().is_some() => {
                return Err(Failure::Failed(
                    "the simulation is debugged: its breakpoints are those of the debugger".into(),
                ));
            }
            Action::Breakpoints(lines, tags) => {
                self.simulation.engine.set_breakpoints(&lines, &tags)?;
            }
            // They change nothing and are answered where they arrive.
            Action::Why(_)
            | Action::Record(..)
            | Action::History(..)
            | Action::Trace(_)
            | Action::DiagramText(_)
            | Action::Scene(..)
            | Action::Tags(_)
            | Action::ValuesAt(_)
            | Action::Debug(_)
            | Action::Message(..)
            | Action::HasShown => {}
            Action::WarmRestart => {
                self.run = None;
                self.simulation.hit = None;
                self.simulation.engine.warm_restart()?;
                self.simulation.status = Status::Paused;
            }
            Action::Run { scans, pace } => self.start_run(scans, pace),
            Action::Pace(pace) => {
                self.simulation.pace = pace;
                let due = self.first_due();
                if let Some(run) = &mut self.run {
                    run.due = due;
                }
            }
            Action::Show(shown) => self.simulation.engine.show(&shown),
            Action::Pause => self.pause(),
            Action::Set(tag, value) => self.simulation.engine.set(&tag, &value)?,
            Action::Pulse(tag) => self.simulation.engine.pulse(&tag)?,
            Action::Force(tag, value) => self.simulation.engine.force(&tag, &value)?,
            Action::Unforce(tag) => self.simulation.engine.unforce(tag.as_deref())?,
            Action::State => {}
            Action::Serve(on) => self.simulation.engine.serve(on)?,
            Action::Reset => {
                self.run = None;
                self.simulation.hit = None;
                self.simulation.engine.reset()?;
                self.simulation.status = Status::Paused;
            }
            Action::Follow(revision) => {
                // Of several that wait the last one counts.
                if !self.queue.has_text() {
                    self.follow(revision);
                }
            }
            Action::FollowOthers(revision) => self.follow(revision),
            Action::Stop => {
                self.run = None;
                // Before the answer: who has it may start again, with the same file.
                self.simulation.engine.let_go_of_file();
                self.simulation.status = Status::Ended;
            }
        }
        Ok(())
    }

    /// Whether the program is to be checked again because other files are not as they were.
    fn concerned_by_others(&self, revision: &Revision) -> bool {
        // A text that waits goes with the other files as they are.
        let is_newest = revision.version >= self.simulation.engine.revision().version;
        is_newest && !self.queue.has_text() && self.simulation.engine.uses_others()
    }

    fn follow(&mut self, revision: Arc<Revision>) {
        let is_another = self.simulation.engine.follow(revision);
        self.simulation.engine.is_new = true;
        if is_another {
            self.simulation.hit = None;
            // What was hung may go on.
            self.simulation.take_status();
        }
    }

    pub(crate) fn pause(&mut self) {
        self.run = None;
        if self.simulation.status == Status::Running {
            self.simulation.status = Status::Paused;
        }
    }

    /// Scans until done, until nobody waits for it, until a command that waits wants to be heard, or until it has taken too
    /// long. A command that waits is not served meanwhile: a `set` that was sent after a `step` takes effect after it.
    fn step(&mut self, scans: u64, cancel: &Cancel) {
        if self.simulation.status != Status::Paused {
            return;
        }
        self.simulation.status = Status::Running;
        let cancel = self.queue.cancel_of_command(cancel);
        self.simulation.engine.obey(cancel.clone());
        if let Some(debugger) = self.simulation.debugger() {
            debugger.resumed();
        }
        let mut reported = self.clock.now();
        for _ in 0..scans {
            if cancel.is_cancelled() || self.simulation.status != Status::Running {
                break;
            }
            self.simulation.scan();
            self.owes = true;
            if self.clock.now().saturating_sub(reported) >= self.report() && self.publish() {
                reported = self.clock.now();
            }
        }
        self.simulation.engine.obey(self.queue.cancel_of_run());
        self.pause();
    }

    pub(crate) fn start_run(&mut self, scans: Option<u64>, pace: Option<Pace>) {
        self.simulation.pace = pace.unwrap_or(self.simulation.pace);
        let can_run = matches!(self.simulation.status, Status::Paused | Status::Running);
        if can_run && scans != Some(0) {
            self.simulation.status = Status::Running;
            self.run = Some(Going {
                left: scans,
                due: self.first_due(),
                reported: self.clock.now(),
            });
        } else {
            self.pause();
        }
    }

    /// The run that has begun goes as fast as it can.
    pub(crate) fn run_without_clock(&mut self) {
        if let Some(run) = &mut self.run {
            run.due = None;
        }
    }

    /// When a run that begins now is due, and the time from one scan to the next, if it keeps to a clock.
    fn first_due(&self) -> Option<(Moment, Duration)> {
        let Pace::Times(speed) = self.simulation.pace else {
            return None;
        };
        let interval = self.simulation.engine.interval().as_secs_f64();
        // An interval that is too long to be counted never ends.
        let pace = Duration::try_from_secs_f64(interval / speed).unwrap_or(NEVER);
        Some((self.clock.now(), pace.min(NEVER)))
    }

    /// One scan of a run.
    fn go_on(&mut self) {
        let Some(mut run) = self.run else { return };
        self.queue.begin();
        let before = self.simulation.engine.scans();
        self.simulation.scan();
        let now = self.clock.now();
        // A scan that was stopped by a command that waits is begun again.
        let done = self.simulation.engine.scans().saturating_sub(before);
        run.left = run.left.map(|left| left.saturating_sub(done));
        // A scan that takes longer than its interval makes the simulation slow; it does not make it catch up.
        run.due = run.due.map(|(due, pace)| ((due + pace).max(now), pace));
        self.owes = true;
        if self.simulation.status != Status::Running || run.left == Some(0) {
            self.pause();
            self.tell_debugger(Effect::Steps);
            self.publish();
            return;
        }
        // To a client that is late the next state goes with the first scan after its word that it has shown the last one.
        if now.saturating_sub(run.reported) >= self.report() && self.publish() {
            run.reported = now;
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

    /// Sends the client the state; to one that says what it shows only when it has shown what it was sent before.
    /// Whether that was done.
    pub(crate) fn publish(&mut self) -> bool {
        if self.simulation.engine.is_shown_in_part() && !self.has_shown.swap(false, Ordering::SeqCst) {
            return false;
        }
        self.owes = false;
        self.shown = self.clock.now();
        self.states.send(self.simulation.state(Detail::Picture));
        true
    }
}
