//! The program of a session and its state.

use crate::action::Pace;
use crate::debugging::Debugging;
use crate::engine::Engine;
use crate::messages::{Hit, State, Status};
use crate::online::Controller;
use crate::status_text::status_text;
use crate::view::Update;

/// How much of the drawing a state holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Detail {
    /// Tags and power; to a client that says what it shows what has changed there.
    Picture,
    /// Nothing to a client that says what it shows: what has changed comes with the next notification.
    Answer,
}

/// The program and its state.
pub(crate) struct Simulation {
    pub(crate) id: String,
    pub(crate) engine: Engine,
    pub(crate) status: Status,
    /// The breakpoint that stopped the last run.
    pub(crate) hit: Option<Hit>,
    /// The debugger that it is lent to.
    pub(crate) debugging: Option<Debugging>,
    /// How fast runs go.
    pub(crate) pace: Pace,
    /// How many answers were given.
    pub(crate) answers: u64,
}

impl Simulation {
    /// One scan, up to a breakpoint.
    pub(crate) fn scan(&mut self) {
        if self.scan_debugged() {
            return;
        }
        self.hit = self.engine.scan();
        self.take_status();
        if self.hit.is_some() && self.status == Status::Running {
            self.status = Status::Paused;
        }
    }

    /// What the program itself says about going on.
    pub(crate) fn take_status(&mut self) {
        match (self.engine.status(), self.status) {
            (ladder_simulator::Status::Ready, Status::Running) => {}
            (ladder_simulator::Status::Ready, _) => self.status = Status::Paused,
            (ladder_simulator::Status::Ended, _) => self.status = Status::Ended,
            (ladder_simulator::Status::Faulted, _) => self.status = Status::Faulted,
        }
    }

    pub(crate) fn state(&mut self, detail: Detail) -> State {
        let engine = &mut self.engine;
        let in_part = engine.is_shown_in_part();
        let whole = detail == Detail::Picture && std::mem::take(&mut engine.is_new);
        let (tags, update) = if in_part && detail == Detail::Answer {
            (Vec::new(), Update::default())
        } else {
            engine.update()
        };
        let scenes = if in_part && detail == Detail::Answer {
            Vec::new()
        } else {
            engine.scene_values()
        };
        let mut state = State {
            session: self.id.clone(),
            uri: engine.revision().uri.to_string(),
            version: engine.revision().version,
            stale: engine.texts.stale,
            change: engine.texts.change.clone(),
            program: engine.session.generation(),
            status: self.status,
            text: String::new(),
            controller: engine.controller.as_ref().map(Controller::message),
            served: engine.served.as_ref().map(|served| served.about()),
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
            operands: update.operands,
            labels: update.labels,
            scenes,
            tags,
            power: update.power,
            faults: engine.faults(),
        };
        state.text = status_text(&state, self.pace);
        state
    }
}
