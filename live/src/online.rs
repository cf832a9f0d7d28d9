//! A running controller in the place of a simulation: its values and their power are shown, and nothing else can be done.

use std::sync::Arc;
use std::time::Duration;

use ladder_analysis::program::Program;
use ladder_host::{Wires, World};
use ladder_simulator::online::{Connection, Online, Watching};
use ladder_simulator::{Judged, Point};
use ladder_workspace::Online as Asked;

use crate::action::Action;
use crate::engine::Engine;
use crate::messages;
use crate::request::Failure;

/// How often is checked whether anything is new.
pub(crate) const CHECK: Duration = Duration::from_millis(100);

/// So many tags that differ are named.
const MOST_TOLD: usize = 50;

/// A controller that is watched, and all that is needed to watch it for another program.
#[derive(Debug)]
pub(crate) struct Controller {
    wires: Arc<dyn Wires>,
    asked: Asked,
    stem: String,
    name: String,
    watching: Watching,
}

impl Controller {
    /// Watches the controller that settings name.
    pub(crate) fn watch(
        world: &World,
        asked: Option<Asked>,
        file: &str,
        program: Arc<Program>,
    ) -> Result<Controller, Failure> {
        let wires = world.wires.clone();
        let wires =
            wires.ok_or_else(|| Failure::Failed("there is no way to a controller from here".into()))?;
        let asked = asked.ok_or_else(|| {
            Failure::Failed(
                "which controller? Put [online] into ladder.toml, for example with logix = \"192.168.1.10/0\"".into(),
            )
        })?;
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
        let (name, watching) = connect(wires.as_ref(), &asked, &stem, program).map_err(Failure::Failed)?;
        Ok(Controller {
            wires,
            asked,
            stem,
            name,
            watching,
        })
    }

    /// From one reading to the next, in nanoseconds.
    pub(crate) fn every(&self) -> Option<i64> {
        self.asked.every
    }

    /// Why a tag holds what it holds.
    pub(crate) fn why(&mut self, point: &Point) -> Judged {
        self.watching.why(point)
    }

    /// Whether the power of an element is not known, by the engine's number.
    pub(crate) fn is_unknown(&self, element: usize) -> bool {
        self.watching.online().is_unknown(element)
    }

    /// How it is, for the client.
    pub(crate) fn message(&self) -> messages::Controller {
        let newest = self.watching.newest();
        messages::Controller {
            name: self.name.clone(),
            answers: newest.connection == Connection::Open,
            age_ms: newest.age.map(|age| age.as_secs_f64() * 1e3),
            text: self.watching.status(),
            differences: self.watching.differences(MOST_TOLD),
        }
    }
}

fn connect(
    wires: &dyn Wires,
    asked: &Asked,
    stem: &str,
    program: Arc<Program>,
) -> Result<(String, Watching), String> {
    let online = Online::new(program)?;
    let (name, watched) = wires.watch(asked, stem, &online)?;
    Ok((name, Watching::new(online, watched)))
}

impl Engine {
    /// Shows what is new at the controller, if one is watched. Whether one is.
    pub(crate) fn look_at_controller(&mut self) -> bool {
        let Some(controller) = &mut self.controller else {
            return false;
        };
        if controller.watching.look() {
            let seen = controller.watching.online().simulation();
            let every = self.session.simulation().options().interval;
            let moments = i64::try_from(seen.scans()).unwrap_or(i64::MAX);
            self.session.mirror(seen, every.saturating_mul(moments));
            self.recorder.look(&self.session);
        }
        true
    }

    /// The program is another one now: that is asked for.
    pub(crate) fn watch_again(&mut self) {
        let Some(controller) = &mut self.controller else {
            return;
        };
        let program = self.session.simulation().program().clone();
        let again = connect(
            controller.wires.as_ref(),
            &controller.asked,
            &controller.stem,
            program,
        );
        match again {
            Ok((name, watching)) => (controller.name, controller.watching) = (name, watching),
            Err(_) => self.texts.stale = true,
        }
    }

    /// What contradicts the program, as something that went wrong in its network.
    pub(crate) fn contradictions(&self) -> Vec<messages::Fault> {
        let Some(controller) = &self.controller else {
            return Vec::new();
        };
        let online = controller.watching.online();
        let reported = online.doubts().iter().filter(|doubt| doubt.is_reported());
        let faults = reported.map(|doubt| {
            let (uri, range) = self.place(online.simulation().program().networks[doubt.network].location);
            messages::Fault {
                message: doubt.to_string(),
                uri,
                range,
                scan: self.scans(),
            }
        });
        faults.collect()
    }

    /// Refuses what only a simulation can do.
    pub(crate) fn check_may(&self, action: &Action) -> Result<(), Failure> {
        if self.controller.is_none() || !action.is_for_a_simulation() {
            return Ok(());
        }
        Err(Failure::Failed(
            "this is a running controller that is only watched: nothing is written to it, and it is not stopped".into(),
        ))
    }
}
