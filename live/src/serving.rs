//! Tags of a simulation for clients on this computer: screens, SCADA systems, Factory I/O.

use crate::engine::Engine;
use crate::request::Failure;

impl Engine {
    /// Serves tags from now on, or no more.
    pub(crate) fn serve(&mut self, on: bool) -> Result<(), Failure> {
        self.served = None;
        if !on {
            return Ok(());
        }
        let wires = self.wires.as_ref();
        let wires = wires.ok_or_else(|| Failure::Failed("nothing can be served from here".into()))?;
        let asked = self.line_map.running().served().unwrap_or_default();
        let served = wires.serve(&asked, self.session.simulation());
        self.served = Some(served.map_err(Failure::Failed)?);
        Ok(())
    }

    /// Before a scan: what clients have written reaches the program.
    pub(crate) fn take_written(&mut self) {
        let Some(served) = &self.served else { return };
        for (point, value) in served.written(self.session.simulation()) {
            // A tag that is held at another value keeps what was written underneath.
            let _ = self.session.set(&point, value);
        }
    }

    /// Clients see the values of now.
    pub(crate) fn show_clients(&self) {
        if let Some(served) = &self.served {
            served.show(self.session.simulation());
        }
    }

    /// The program is another one now: clients see that. If the settings do not fit it they see nothing any more.
    pub(crate) fn serve_again(&mut self) {
        let simulation = self.session.simulation();
        let fits = self
            .served
            .as_ref()
            .is_some_and(|it| it.replace(simulation).is_ok());
        if !fits {
            self.served = None;
        }
    }
}
