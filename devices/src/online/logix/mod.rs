//! Logix controllers, by EtherNet/IP.
//!
//! ```text
//! wanted --plan: whole tags--> driver (ciplink) --frames--> guard --allowed--> socket
//!        <--values: their parts-- answers <---------------- bounded in size and time
//! ```
//!
//! A controller is asked for few large things rather than for many small ones: that is how it answers fastest.

mod address;
mod allowed;
mod guard;
mod path;
mod plan;
mod values;

use crate::source::Source;
use ciplink::cip::CipOptions;
use ciplink::logix::driver::{LogixDriver, LogixOptions};
use ciplink::{Error, ErrorKind};
use guard::Terms;
use ladder_analysis::values::value::Value;
use ladder_simulator::online::{Found, Wanted};
use plan::{Ask, plan};
use std::fmt;
use std::time::Duration;

/// Connecting, with the list of all tags and types, takes no longer and brings no more.
const CONNECTING: (Duration, usize) = (Duration::from_secs(60), 16 << 20);
/// A snapshot, likewise.
const READING: (Duration, usize) = (Duration::from_secs(20), 32 << 20);
/// Saying good-bye.
const CLOSING: (Duration, usize) = (Duration::ZERO, 4 << 10);

/// A Logix controller.
pub struct Logix {
    // It is kept from connection to connection: it knows by then whether the controller takes large packets.
    driver: LogixDriver,
    terms: Terms,
    program: Option<String>,
    wanted: Vec<Wanted>,
    asks: Vec<Ask>,
    /// Of which state of the controller's tags that is.
    version: u64,
}

impl fmt::Debug for Logix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Logix")
            .field("wanted", &self.wanted.len())
            .finish_non_exhaustive()
    }
}

impl Logix {
    /// A controller at `HOST`, `HOST/SLOT` or through a route: `HOST/bp/1/enet/10.1.1.1/bp/0`. Wanted names without a program are
    /// those of `program` where it has them, else those of the controller. An answer may take `timeout`.
    ///
    /// # Errors
    /// The address is not one: what it should be.
    pub fn new(
        address: &str,
        program: Option<String>,
        wanted: Vec<Wanted>,
        timeout: Duration,
    ) -> Result<Logix, String> {
        address::check(address)?;
        let terms = Terms::new(timeout);
        let options = LogixOptions {
            cip: CipOptions {
                // Those are agreed with the guard.
                socket_timeout: None,
                ..CipOptions::default()
            },
            ..LogixOptions::default()
        };
        let driver = LogixDriver::with_connector(address, options, guard::connector(terms.clone()))
            .map_err(|error| address::wrong(address, &error.to_string()))?;
        Ok(Logix {
            driver,
            terms,
            program,
            wanted,
            asks: Vec::new(),
            version: 0,
        })
    }

    /// Why something failed, in the guard's words if it knows.
    fn why(&self, error: &Error) -> String {
        self.terms.failure().unwrap_or_else(|| told(error))
    }

    /// Reads values. Which of what was asked for is refused as a whole.
    fn ask(&self, asks: &[Ask], values: &mut [Option<Value>]) -> Result<Vec<usize>, String> {
        let requests: Vec<&str> = asks.iter().map(|ask| ask.request.as_str()).collect();
        let results = self.driver.read(&requests).map_err(|error| self.why(&error))?;
        if self.driver.definitions_version() != self.version {
            return Err("has other tags now; they are compared again".to_owned());
        }
        let mut refused = Vec::new();
        for (nth, (ask, result)) in asks.iter().zip(results).enumerate() {
            match (result.value, result.error) {
                (Some(answer), None) => {
                    for part in &ask.parts {
                        let ty = self.wanted[part.wanted].point.ty;
                        values[part.wanted] = values::value(&answer, &part.steps, ty);
                    }
                }
                (_, Some(error)) if error.status.is_some() && !ask.is_single => {
                    if matches!(error.kind, ErrorKind::Access | ErrorKind::NotFound) {
                        refused.push(nth);
                    }
                }
                _ => {}
            }
        }
        Ok(refused)
    }

    fn close(&self) {
        if self.driver.connected() {
            self.terms.begin(CLOSING.0, CLOSING.1);
            // It is gone either way.
            let _ = self.driver.close();
        }
    }
}

impl Source for Logix {
    fn connect(&mut self) -> Result<Vec<Found>, String> {
        self.close();
        self.terms.begin(CONNECTING.0, CONNECTING.1);
        let is_open = self.driver.open().map_err(|error| self.why(&error))?;
        if !is_open {
            return Err("opens no session: too many may be open already".to_owned());
        }
        let definitions = self.driver.definitions();
        self.version = definitions.version;
        let (found, asks) = plan(&definitions, self.program.as_deref(), &self.wanted);
        self.asks = asks;
        Ok(found)
    }

    fn read(&mut self) -> Result<Vec<Option<Value>>, String> {
        self.terms.begin(READING.0, READING.1);
        let mut values = vec![None; self.wanted.len()];
        let refused = self.ask(&self.asks, &mut values)?;
        // A structure with a member that is not shown is refused as a whole: its members are asked for from now on.
        let refused = refused.into_iter().rev().map(|nth| self.asks.swap_remove(nth));
        let singles: Vec<Ask> = refused.flat_map(Ask::singles).collect();
        self.ask(&singles, &mut values)?;
        self.asks.extend(singles);
        Ok(values)
    }
}

/// What the driver tells, in other words where its own say little.
fn told(error: &Error) -> String {
    let message = error.to_string();
    if message.contains("Failed to get PLC info") {
        return "answers, but not as a controller does: check the slot of the processor".to_owned();
    }
    if message.starts_with("Target did not connected") {
        return "takes no more connections: end other programs that are connected to it".to_owned();
    }
    format!("does not tell its tags: {message}")
}

impl Drop for Logix {
    fn drop(&mut self) {
        // A controller keeps what is not closed for minutes, and has room for few.
        self.close();
    }
}
