//! A simulation with a debugger: the commands of both come to the same thread.

use std::sync::Arc;

use ladder_documents::{Revision, address};
use ladder_workspace::Member;
use serde_json::Value;

use crate::debugger::{Beginning, Debugger, Ground, Halt, ProgramFile};
use crate::engine::Engine;
use crate::line_map::corresponding;
use crate::messages::Status;
use crate::request::Failure;
use crate::runner::Runner;
use crate::running_program::Simulation;

/// A debugger, and the text that it knows.
pub(crate) struct Debugging {
    debugger: Box<dyn Debugger>,
    text: Arc<Revision>,
}

impl Runner {
    /// A debugger comes to the simulation, running or not.
    pub(crate) fn begin_debugging(&mut self, beginning: Beginning) -> Result<(), Failure> {
        if self.simulation.debugger().is_some() {
            return Err(Failure::Failed("the simulation is debugged already".into()));
        }
        let engine = &mut self.simulation.engine;
        let text = engine.line_map.source().clone();
        let ground = Ground {
            is_running: self.run.is_some(),
            files: engine.files(),
            session: &mut engine.session,
            urgent: self.queue.urgent.clone(),
        };
        let debugger = (beginning.0)(ground).map_err(Failure::Failed)?;
        self.simulation.engine.has_gone_on();
        self.simulation.debugging = Some(Debugging { debugger, text });
        self.owes = true;
        self.publish();
        Ok(())
    }

    /// A message for the debugger. What follows from it is shown.
    pub(crate) fn debug(&mut self, message: &Value) {
        let Simulation {
            engine, debugging, ..
        } = &mut self.simulation;
        let Some(Debugging { debugger, .. }) = debugging else {
            return;
        };
        let changes = debugger.receive(&mut engine.session, message);
        if debugger.is_gone() {
            self.simulation.debugging = None;
        }
        if changes {
            self.simulation.hit = None;
            self.simulation.engine.has_gone_on();
            self.obey_debugger();
            self.simulation.tell_of_text();
            self.owes = true;
            self.publish();
        }
    }

    /// Runs, or does not, as the debugger wants it.
    fn obey_debugger(&mut self) {
        let wants = self.simulation.debugger().is_some_and(|it| it.is_running());
        match (wants, self.run.is_some()) {
            (true, false) => {
                self.start_run(None, None);
                let hurries = self.simulation.debugger().is_some_and(|it| !it.keeps_to_clock());
                if hurries {
                    self.run_without_clock();
                }
            }
            (false, true) => self.pause(),
            (true, true) | (false, false) => {}
        }
        if !wants {
            self.simulation.take_status();
        }
    }

    /// Tells the debugger what a command of the editor has done.
    pub(crate) fn tell_debugger(&mut self, effect: Effect) {
        let runs = self.run.is_some();
        self.simulation.tell_of_text();
        if effect == Effect::End
            && let Some(Debugging { debugger, .. }) = &mut self.simulation.debugging
        {
            debugger.ended();
        }
        let Some(debugger) = self.simulation.debugger() else {
            return;
        };
        match (effect, debugger.is_running()) {
            (_, false) if runs => debugger.resumed(),
            (_, true) if !runs => debugger.halted(if effect == Effect::Steps {
                Halt::Step
            } else {
                Halt::Pause
            }),
            (Effect::Leads, _) => debugger.halted(Halt::Elsewhere),
            (Effect::Gives, _) => debugger.given(),
            (Effect::Nothing | Effect::Steps | Effect::End, _) => {}
        }
    }
}

/// What a command of the editor does to the program that is debugged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effect {
    /// Nothing that the debugger sees.
    Nothing,
    /// It gives tags values.
    Gives,
    /// It runs it for a while.
    Steps,
    /// It leads it elsewhere.
    Leads,
    /// It is over.
    End,
}

impl Simulation {
    /// The debugger that decides what stops a run.
    pub(crate) fn debugger(&mut self) -> Option<&mut dyn Debugger> {
        live(&mut self.debugging)
    }

    /// A piece of a run as the debugger does it. False if there is none.
    pub(crate) fn scan_debugged(&mut self) -> bool {
        let Simulation {
            engine, debugging, ..
        } = self;
        let Some(debugger) = live(debugging) else {
            return false;
        };
        debugger.go_on(&mut engine.session);
        let stops = !debugger.is_running();
        engine.has_gone_on();
        self.hit = None;
        self.take_status();
        if stops && self.status == Status::Running {
            self.status = Status::Paused;
        }
        self.tell_of_text();
        true
    }

    /// A step as the debugger does it. False if there is none.
    pub(crate) fn step_debugged(&mut self, by_block: bool) -> bool {
        let Simulation {
            engine, debugging, ..
        } = self;
        let Some(debugger) = live(debugging) else {
            return false;
        };
        debugger.step(&mut engine.session, by_block);
        engine.has_gone_on();
        true
    }

    /// Tells the debugger if the text that runs is another one.
    fn tell_of_text(&mut self) {
        let Simulation {
            engine, debugging, ..
        } = self;
        let Some(Debugging { debugger, text }) = debugging else {
            return;
        };
        let now = engine.line_map.source();
        if now.is(text) {
            return;
        }
        let lines = corresponding(text, now);
        *text = now.clone();
        let files = engine.files();
        debugger.moved(&mut engine.session, files, &lines);
    }
}

/// The debugger that decides what stops a run.
fn live(debugging: &mut Option<Debugging>) -> Option<&mut dyn Debugger> {
    let Debugging { debugger, .. } = debugging.as_mut()?;
    debugger.is_live().then_some(&mut **debugger)
}

impl Engine {
    /// The files of the program that runs, in its order.
    fn files(&self) -> Vec<ProgramFile> {
        let revision = self.line_map.running();
        let file = |uri: &str, text: Member| ProgramFile {
            path: address::path_of(uri).unwrap_or_else(|| uri.into()),
            text,
        };
        let program = self.session.simulation().program();
        let others = program.files.iter().skip(1).map(|name| {
            let found = revision.text_next_to(name);
            let (uri, text) = found.unwrap_or_else(|| (name.clone(), Member::Ladder(String::new())));
            file(&uri, text)
        });
        let own = match self.line_map.source().opened() {
            Some(Ok(opened)) => Member::Foreign(opened.foreign().clone()),
            _ => Member::Ladder(revision.text()),
        };
        std::iter::once(file(&revision.uri, own)).chain(others).collect()
    }
}
