//! A program on its way: scan after scan, up to what stops it.

use std::time::Duration;

use ladder_analysis::program::Location;
use ladder_host::Moment;
use ladder_simulator::{Fault, Hit, Status, Stepped, Stop, real_time, value_text};
use serde_json::{Value as Json, json};

use crate::adapter::{Adapter, Phase};
use crate::marker::Verdict;
use crate::properties::Remark;

/// The filter of faults.
pub(crate) const FAULTS: &str = "faults";
/// The filter of expectations that are not met.
pub(crate) const EXPECTATIONS: &str = "expectations";
/// The filter of properties that are violated.
pub(crate) const PROPERTIES: &str = "properties";

/// Each fault is written once; after this many none any more.
const MOST_FAULTS: usize = 100;

/// The longest time between two scans: a day.
const NEVER: Duration = Duration::from_secs(86_400);

/// Which way a run goes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Going {
    /// Forward; where it keeps to a clock, with the time when the next scan is due and that from one to the next.
    Forward(Option<(Moment, Duration)>),
    /// Back, scan by scan.
    Back,
}

/// Why a program is.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stopped {
    /// In the protocol's words.
    pub reason: &'static str,
    /// In words for people.
    pub description: String,
    /// The numbers of the breakpoints.
    pub hits: Vec<i64>,
    /// What went wrong, if that is why.
    pub exception: Option<&'static str>,
    /// Where the innermost frame shows itself, if not where it goes on.
    pub place: Option<Location>,
}

impl Stopped {
    pub(crate) fn because(reason: &'static str, description: impl Into<String>) -> Stopped {
        Stopped {
            reason,
            description: description.into(),
            ..Stopped::default()
        }
    }
}

/// What follows from the end of a scan.
#[derive(Debug)]
pub(crate) enum After {
    /// It may go on.
    Go,
    Stop(Stopped),
    /// All is done: the exit status.
    End(i64),
}

impl Adapter {
    /// Begins to run.
    pub(crate) fn start_run(&mut self) -> Result<(), String> {
        let now = self.world.clock.now();
        let speed = self.configuration.speed()?;
        let target = self.target()?;
        let interval = real_time(target.simulation().options().interval);
        // An interval that is too long to be counted never ends.
        let pace = speed.map(|speed| {
            Duration::try_from_secs_f64(interval.as_secs_f64() / speed)
                .unwrap_or(NEVER)
                .min(NEVER)
        });
        self.forget_stop();
        self.going = Some(Going::Forward(pace.map(|pace| (now, pace))));
        Ok(())
    }

    /// When the program goes on; none while it is at once.
    pub fn due(&self) -> Option<Moment> {
        let next_scan = match self.going {
            Some(Going::Forward(Some((due, _)))) if self.is_between_scans() => Some(due),
            _ => None,
        };
        next_scan.max(self.flood.until())
    }

    /// Does a piece of the work of a run: a scan, or up to what stops it.
    pub(crate) fn go_on(&mut self) {
        match self.going {
            None => {}
            Some(Going::Forward(pace)) => {
                let after = self.run_scan();
                if let Some((due, pace)) = pace.filter(|_| self.is_between_scans()) {
                    // A scan that takes longer than its interval makes the program slow; it does not make it catch up.
                    self.going = Some(Going::Forward(Some((
                        (due + pace).max(self.world.clock.now()),
                        pace,
                    ))));
                }
                self.conclude(after);
            }
            Some(Going::Back) => {
                let after = self.back_a_scan();
                self.conclude(after);
            }
        }
    }

    fn is_between_scans(&self) -> bool {
        self.target
            .as_ref()
            .is_none_or(|target| !target.session.is_open())
    }

    /// Stops or ends, if that is what follows.
    pub(crate) fn conclude(&mut self, after: After) {
        match after {
            After::Go => {}
            After::Stop(stopped) => self.stop(stopped),
            After::End(status) => self.end(status),
        }
    }

    /// The program is, and the client learns why.
    pub(crate) fn stop(&mut self, stopped: Stopped) {
        self.going = None;
        self.handles.clear();
        let mut body = json!({
            "reason": stopped.reason,
            "description": stopped.description,
            "threadId": super::adapter::THREAD,
            "allThreadsStopped": true,
        });
        if !stopped.hits.is_empty() {
            body["hitBreakpointIds"] = stopped.hits.clone().into();
        }
        if !stopped.description.is_empty() {
            body["text"] = stopped.description.clone().into();
        }
        self.stopped = Some(stopped);
        self.event("stopped", body);
    }

    /// The program is over.
    pub(crate) fn end(&mut self, status: i64) {
        self.end_with(Some(status));
    }

    /// A user ends it. A scenario that did not come to its end has not passed: unless it has failed by then it has no
    /// status.
    pub(crate) fn end_early(&mut self) {
        let play = self.target.as_ref().and_then(|target| target.play.as_ref());
        let status = match play {
            Some(play) => play.has_failed.then_some(1),
            None => Some(0),
        };
        self.end_with(status);
    }

    fn end_with(&mut self, status: Option<i64>) {
        if self.phase == Phase::Over {
            return;
        }
        self.going = None;
        self.phase = Phase::Over;
        if let Some(problem) = self.target.as_mut().and_then(super::target::Target::save) {
            self.write("stderr", &format!("{problem}\n"), None);
        }
        if let Some(status) = status {
            self.event("exited", json!({"exitCode": status}));
        }
        self.event("terminated", Json::Null);
    }

    /// What was shown of the last stop counts no more.
    pub(crate) fn forget_stop(&mut self) {
        self.stopped = None;
        self.handles.clear();
    }

    /// One scan, or the rest of one, up to a breakpoint.
    fn run_scan(&mut self) -> After {
        let Ok(target) = self.target() else {
            return After::Go;
        };
        let stop = target.run_scan();
        self.after_stop(stop, true)
    }

    /// What follows from a piece of a scan.
    pub(crate) fn after_stop(&mut self, stop: Option<Stop>, ends: bool) -> After {
        match stop {
            None if ends => self.scan_ended(),
            None => After::Go,
            Some(Stop::Breakpoint(hit)) => match self.fault_stop() {
                Some(stopped) => After::Stop(stopped),
                None => self.met(&hit, true).map_or(After::Go, After::Stop),
            },
            Some(Stop::Faulted) => match self.fault_stop() {
                Some(stopped) => After::Stop(stopped),
                None => self.finish(),
            },
            Some(Stop::Ended) => self.finish(),
            // A request waits; it is served before the scan is begun again.
            Some(Stop::Cancelled | Stop::Done | Stop::At(_)) => After::Go,
        }
    }

    /// A breakpoint is met: whether it stops.
    pub(crate) fn met(&mut self, hit: &Hit, counts: bool) -> Option<Stopped> {
        let target = self.target.as_ref()?;
        let (verdict, hits) = self.table.judge(hit, target, counts);
        let description = self.description(hit);
        match verdict {
            Verdict::Pass => None,
            Verdict::Log(lines) => {
                self.flood.add(self.world.clock.now());
                let place = self
                    .target
                    .as_ref()
                    .and_then(|target| Some(target.activations().first()?.location));
                self.write("console", &lines, place);
                None
            }
            Verdict::Stop(remark) => {
                if let Some(remark) = &remark {
                    self.write("stderr", &format!("{remark}\n"), None);
                }
                let (reason, place) = match hit {
                    Hit::Change { block, .. } => ("data breakpoint", *block),
                    Hit::Network(_) | Hit::Block(_) => ("breakpoint", None),
                };
                Some(Stopped {
                    hits,
                    place,
                    ..Stopped::because(reason, remark.unwrap_or(description))
                })
            }
        }
    }

    fn description(&self, hit: &Hit) -> String {
        let Some(target) = &self.target else {
            return String::new();
        };
        match hit {
            Hit::Network(location) => format!("In front of the rung at {}", target.place_name(*location)),
            Hit::Block(location) => format!("In front of the block at {}", target.place_name(*location)),
            Hit::Change {
                point,
                before,
                after,
                block,
            } => {
                let value = |it| value_text::display(it, point.ty);
                let place = block.map_or(String::new(), |block| format!(" at {}", target.place_name(block)));
                format!(
                    "{} changed from {} to {}{place}",
                    point.name,
                    value(before),
                    value(after)
                )
            }
        }
    }

    /// A scan has come to its end.
    pub(crate) fn scan_ended(&mut self) -> After {
        let Ok(target) = self.target() else {
            return After::Go;
        };
        target.keep();
        let scans = target.simulation().scans();
        if let Some(stopped) = self.fault_stop() {
            return After::Stop(stopped);
        }
        if self.judged != Some(scans) {
            let violated = self.check_properties();
            if let Some(stopped) = self.check_expectations().or(violated) {
                return After::Stop(stopped);
            }
        }
        let is_over = self.target.as_ref().is_some_and(|target| {
            target
                .play
                .as_ref()
                .is_some_and(|play| play.is_over(&target.session))
        });
        if is_over { self.finish() } else { After::Go }
    }

    /// After a scan: which properties it violates that the one before did not.
    fn check_properties(&mut self) -> Option<Stopped> {
        let target = self.target.as_mut()?;
        let remarks = target.properties.as_mut()?.after_scan(&target.session);
        let mut first = None;
        for remark in remarks {
            match remark {
                Remark::Outside(sentence) => self.note(Some(&sentence)),
                Remark::Violated(sentence, range) => {
                    self.write_in(&format!("{sentence}\n"), range, |target| {
                        target.properties.as_ref().map(|properties| &properties.file)
                    });
                    first.get_or_insert(sentence);
                }
            }
        }
        let first = first?;
        if let Some(play) = self.target.as_mut().and_then(|target| target.play.as_mut()) {
            play.has_failed = true;
        }
        let stops = self.stops_at_violations && !self.configuration.no_debug;
        stops.then(|| Stopped {
            exception: Some(PROPERTIES),
            ..Stopped::because("exception", first)
        })
    }

    /// The program cannot go on, or its scenario is over.
    pub(crate) fn finish(&mut self) -> After {
        let Ok(target) = self.target() else {
            return After::Go;
        };
        let status = target.simulation().status();
        let has_ended = status != Status::Ready;
        // Once it is shown where the program is; who then goes on means the end.
        let is_shown = self.end_is_shown;
        if has_ended && !is_shown && !self.configuration.no_debug && status == Status::Ended {
            self.end_is_shown = true;
            return After::Stop(Stopped::because("end", "The program has ended with <END>"));
        }
        let exit = match &self.target.as_ref().and_then(|target| target.play.as_ref()) {
            Some(play) => {
                let failed = play.has_failed || status == Status::Faulted || !self.is_whole();
                let word = if failed { "failed" } else { "passed" };
                let line = format!("scenario \"{}\" {word}\n", play.case.name);
                self.write(if failed { "stderr" } else { "stdout" }, &line, None);
                i64::from(failed)
            }
            None => i64::from(status == Status::Faulted),
        };
        After::End(exit)
    }

    /// Whether the scenario came to its end.
    fn is_whole(&self) -> bool {
        self.target.as_ref().is_none_or(|target| {
            target
                .play
                .as_ref()
                .is_none_or(|play| play.is_over(&target.session))
        })
    }

    /// Faults that have happened since they were checked: writes them, and if the first of them is to stop the program,
    /// goes back to right after it.
    pub(crate) fn fault_stop(&mut self) -> Option<Stopped> {
        let target = self.target.as_mut()?;
        let status = target.simulation().status();
        let scans = target.simulation().scans();
        let is_within = target.session.is_open() || status == Status::Faulted;
        let scan = if is_within { scans } else { scans.checked_sub(1)? };
        let faults = target.session.faults_of(scan);
        let seen = if self.faults_seen.0 == scan {
            self.faults_seen.1
        } else {
            0
        };
        let fault = faults.get(seen)?.clone();
        self.tell_faults(&faults[seen..]);
        if !self.stops_at_faults || self.configuration.no_debug {
            self.faults_seen = (scan, faults.len());
            return None;
        }
        self.faults_seen = (scan, seen + 1);
        if !(fault.stops && status == Status::Faulted) {
            self.go_after_fault(scan, seen + 1);
        }
        let target = self.target.as_ref()?;
        let description = format!("{} ({})", fault.message, target.place_name(fault.location));
        Some(Stopped {
            exception: Some(FAULTS),
            place: Some(fault.location),
            ..Stopped::because("exception", description)
        })
    }

    /// Runs the scan again up to right after its n-th fault. Where the scan is not kept it stays at its end.
    fn go_after_fault(&mut self, scan: u64, number: usize) {
        let Some(target) = &mut self.target else {
            return;
        };
        if target.session.step_back(1) == 0 {
            return;
        }
        while target.session.faults_of(scan).len() < number {
            match target.session.step_block() {
                Stepped::At(_) => {}
                Stepped::Done | Stepped::Stopped => return,
            }
        }
    }

    fn tell_faults(&mut self, faults: &[Fault]) {
        for fault in faults {
            let is_new = self.faults_reported.len() < MOST_FAULTS
                && self
                    .faults_reported
                    .insert((fault.location, fault.message.clone()));
            if is_new {
                let line = format!("fault in scan {}: {}\n", fault.scan, fault.message);
                self.write("stderr", &line, Some(fault.location));
            }
        }
    }
}
