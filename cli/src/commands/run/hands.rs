//! What happens between the scans of a run: inputs, clients, devices, the retentive file, the service manager.

use crate::outcome::Failure;
use crate::run::Retention;
use crate::terminal;
use ladder_devices::lateness::Report;
use ladder_devices::modbus::{Devices, Image, Listening, ToServe, Wired, serve};
use ladder_devices::real::Between;
use ladder_devices::system::notify;
use ladder_simulator::{Fault, Inputs, Simulation};
use std::time::{Duration, Instant};

/// So many faults are kept for the end: those that happened first.
const MOST_FAULTS: usize = 100;

pub(super) struct Hands {
    retention: Option<Retention>,
    inputs: Inputs,
    /// The server that is to be, until it listens.
    to_serve: Option<ToServe>,
    image: Option<(Image, Listening)>,
    devices: Option<Devices>,
    faults: Vec<Fault>,
    is_ready: bool,
    /// How often the service manager wants to hear that the program runs, and when it did.
    watchdog: Option<(Duration, Instant)>,
}

impl Hands {
    pub(super) fn new(retention: Option<Retention>, inputs: Inputs, to_serve: Option<ToServe>) -> Hands {
        let asked = std::env::var("WATCHDOG_USEC")
            .ok()
            .and_then(|time| time.parse().ok());
        Hands {
            retention,
            inputs,
            to_serve,
            image: None,
            devices: None,
            faults: Vec::new(),
            is_ready: false,
            // Twice as often as it must.
            watchdog: asked.map(|time: u64| (Duration::from_micros(time / 2), Instant::now())),
        }
    }

    /// Opens the server, if there is to be one, and reports where it is.
    ///
    /// # Errors
    /// The address cannot be used.
    pub(super) fn listen(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let Some(served) = self.to_serve.take() else {
            return Ok(());
        };
        let (all, written) = (
            served.map.tags().count(),
            served.map.tags().filter(|tag| tag.2).count(),
        );
        let is_read_only = written == 0;
        let image = Image::new(served.map, served.hold, simulation);
        let tell = |line: &str| terminal::note(&line);
        let listening = serve(served.address, &image, served.rules, tell).map_err(|error| {
            Failure::new(format!("Modbus cannot be served on {}: {error}", served.address))
        })?;
        let address = listening.address;
        let who_writes = if is_read_only {
            "none can be written".to_owned()
        } else {
            format!("{written} can be written")
        };
        terminal::note(&format_args!(
            "Modbus is served on {address}: {all} tags, {who_writes}"
        ));
        if !address.ip().is_loopback() {
            terminal::warning(&format_args!(
                "Modbus has no passwords: everybody who reaches {address} sees these tags{}",
                if is_read_only { "" } else { " and writes those" }
            ));
        }
        self.image = Some((image, listening));
        Ok(())
    }

    /// Connects the devices, if there are any, and reports where they are.
    ///
    /// # Errors
    /// The system has no thread for it.
    pub(super) fn connect(&mut self, wired: Vec<Wired>) -> Result<(), Failure> {
        if wired.is_empty() {
            return Ok(());
        }
        for device in &wired {
            terminal::note(device);
        }
        let tell = |line: &str| terminal::note(&line);
        let devices = Devices::connect(wired, tell)
            .map_err(|error| Failure::new(format!("devices cannot be connected: {error}")))?;
        self.devices = Some(devices);
        Ok(())
    }

    /// The clients and devices that are there see another program.
    pub(super) fn replace(&mut self, served: Option<ToServe>, wired: Vec<Wired>, simulation: &Simulation) {
        if let (Some((image, _)), Some(served)) = (&self.image, served) {
            image.replace(&Image::new(served.map, served.hold, simulation));
        }
        if let Some(devices) = &mut self.devices {
            devices.replace(wired);
        }
    }

    /// The faults since they were last taken.
    pub(super) fn take_faults(&mut self) -> Vec<Fault> {
        std::mem::take(&mut self.faults)
    }

    /// What is left to do after the last scan: outputs go back to what they are before the first.
    ///
    /// # Errors
    /// The retentive file cannot be written.
    pub(super) fn finish(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let _ = notify("STOPPING=1");
        if let Some(devices) = self.devices.take() {
            devices.finish(simulation);
        }
        match &mut self.retention {
            Some(retention) => retention.finish(simulation),
            None => Ok(()),
        }
    }
}

impl Between for Hands {
    fn before(&mut self, simulation: &mut Simulation) {
        self.inputs.give(simulation.scans(), simulation);
        if let Some((image, _)) = &self.image {
            image.give(simulation, Instant::now());
        }
        if let Some(devices) = &self.devices {
            devices.give(simulation, Instant::now());
        }
    }

    fn after(&mut self, simulation: &mut Simulation) {
        if let Some((image, _)) = &self.image {
            image.take(simulation);
        }
        if let Some(devices) = &self.devices {
            devices.take(simulation);
        }
        if let Some(retention) = &mut self.retention {
            retention.keep(simulation);
        }
        let room = MOST_FAULTS - self.faults.len();
        self.faults
            .extend(simulation.take_faults().into_iter().take(room));
        if !self.is_ready {
            self.is_ready = true;
            let _ = notify("READY=1");
        }
        if let Some((every, last)) = &mut self.watchdog
            && last.elapsed() >= *every
        {
            *last = Instant::now();
            let _ = notify("WATCHDOG=1");
        }
    }

    fn report(&mut self, report: &Report) {
        terminal::note(report);
    }
}
