//! Which controller is watched, and what of the program is asked for there.

use super::watch::Watch;
use crate::source::Source;
use crate::wrong::Wrong;
use ladder_simulator::online::{Online, Wanted};
use ladder_simulator::{Point, real_time};
use ladder_workspace::Online as Asked;
use std::fmt;
use std::time::Duration;

/// From one reading to the next, unless something else is asked for.
pub const EVERY: Duration = Duration::from_millis(200);

/// An answer that has not come for so long does not come.
pub const PATIENCE: Duration = Duration::from_secs(2);

/// A controller that can be watched.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Controller {
    place: Place,
    asked: Asked,
}

/// Where a controller is, and how it is asked.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Place {
    Logix(String),
    Modbus(String),
}

/// A controller, and what it is asked for.
type Asks = (Box<dyn Source>, Vec<Wanted>);

impl fmt::Display for Controller {
    /// `logix:192.168.1.10/0`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::Logix(address) => write!(f, "logix:{address}"),
            Place::Modbus(address) => write!(f, "modbus:{address}"),
        }
    }
}

impl Controller {
    /// The controller of `[online]`, or none if that names none.
    pub fn of(asked: &Asked) -> Option<Controller> {
        let logix = asked.logix.clone().map(Place::Logix);
        let place = logix.or_else(|| asked.modbus.clone().map(Place::Modbus))?;
        let asked = asked.clone();
        Some(Controller { place, asked })
    }

    /// A controller by what a person writes: `logix:192.168.1.10/0`, `modbus:HOST:PORT`. All else is as `[online]` has it.
    ///
    /// # Errors
    /// It is neither: what to write.
    pub fn parse(text: &str, asked: Option<&Asked>) -> Result<Controller, String> {
        let place = match text.split_once(':') {
            Some(("logix", address)) if !address.is_empty() => Place::Logix(address.to_owned()),
            Some(("modbus", address)) if is_with_port(address) => Place::Modbus(address.to_owned()),
            _ => {
                return Err(format!(
                    "{text} is not a controller: write logix:ADDRESS/SLOT as in logix:192.168.1.10/0, or modbus:HOST:PORT as in modbus:192.168.1.10:502"
                ));
            }
        };
        let asked = asked.cloned().unwrap_or_default();
        Ok(Controller { place, asked })
    }

    /// From one reading to the next.
    pub fn every(&self) -> Duration {
        self.asked.every.map_or(EVERY, real_time)
    }

    /// Watches the controller for a program. `stem` is what the program's file is called without its extension. After anything new
    /// `wake` is called on another thread.
    ///
    /// # Errors
    /// What is asked for does not fit the program, or there is nothing to ask for.
    pub fn watch(
        &self,
        stem: &str,
        program: &Online,
        wake: impl Fn() + Send + 'static,
    ) -> Result<Watch, Vec<Wrong>> {
        let (source, wanted) = match &self.place {
            Place::Logix(address) => self.logix(address, stem, program.points())?,
            Place::Modbus(address) => self.modbus(address, program)?,
        };
        if wanted.is_empty() {
            return Err(self.wrong(match self.place {
                Place::Logix(_) => "the program has no tags",
                Place::Modbus(_) => {
                    "nothing is known to be at any place of the controller: no tag has a direct address such as %QX0.0, and [online.map] in ladder.toml names none"
                }
            }));
        }
        let watch = Watch::start(source, wanted, self.every(), wake);
        watch.map_err(|error| self.wrong(&format!("there is no thread for the controller: {error}")))
    }

    #[cfg(any(feature = "logix", feature = "modbus"))]
    fn patience(&self) -> Duration {
        self.asked.timeout.map_or(PATIENCE, real_time)
    }

    fn wrong(&self, message: &str) -> Vec<Wrong> {
        vec![Wrong {
            at: self.asked.range.clone(),
            message: message.to_owned(),
        }]
    }

    #[cfg(feature = "modbus")]
    fn modbus(&self, address: &str, program: &Online) -> Result<Asks, Vec<Wrong>> {
        use crate::modbus::{Layout, Map, Modbus, Named, Places, Words};
        let asked = &self.asked;
        let places = Places {
            layout: Layout::of_setting(asked.layout),
            words: Words::of_setting(asked.words),
            named: Named::of_settings(&asked.map),
            write: Vec::new(),
            at: asked.range.clone(),
        };
        let map = Map::new(&places, program.simulation())?;
        let source = Modbus::new(address, asked.unit.unwrap_or(1), map, self.patience());
        let wanted = source.wanted();
        Ok((Box::new(source), wanted))
    }

    #[cfg(not(feature = "modbus"))]
    fn modbus(&self, _: &str, _: &Online) -> Result<Asks, Vec<Wrong>> {
        Err(self.wrong("this `ladder` was built without Modbus"))
    }

    #[cfg(feature = "logix")]
    fn logix(&self, address: &str, stem: &str, points: Vec<Point>) -> Result<Asks, Vec<Wrong>> {
        let wanted = points.into_iter().map(|point| Wanted {
            name: self.name_there(&point.name),
            point,
        });
        let wanted: Vec<Wanted> = wanted.collect();
        let program = self.asked.program.as_deref().unwrap_or(stem);
        let source =
            super::logix::Logix::new(address, Some(program.to_owned()), wanted.clone(), self.patience());
        let source = source.map_err(|message| self.wrong(&message))?;
        Ok((Box::new(source), wanted))
    }

    #[cfg(not(feature = "logix"))]
    fn logix(&self, _: &str, _: &str, _: Vec<Point>) -> Result<Asks, Vec<Wrong>> {
        Err(self.wrong("this `ladder` was built without Logix controllers"))
    }

    /// What the controller calls a value: what is said of it, or of the longest part of its path of which anything is said.
    #[cfg_attr(not(feature = "logix"), allow(dead_code))]
    fn name_there(&self, name: &str) -> String {
        let is_of = |tag: &str| {
            let rest = name
                .split_at_checked(tag.len())
                .filter(|(start, _)| start.eq_ignore_ascii_case(tag));
            rest.is_some_and(|(_, rest)| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        let named = self.asked.names.iter().filter(|(tag, _)| is_of(tag));
        match named.max_by_key(|(tag, _)| tag.len()) {
            Some((tag, there)) => format!("{there}{}", &name[tag.len()..]),
            None => name.to_owned(),
        }
    }
}

fn is_with_port(address: &str) -> bool {
    let (host, port) = address.rsplit_once(':').unwrap_or_default();
    !host.is_empty() && port.parse::<u16>().is_ok_and(|port| port > 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;

    #[test]
    fn a_controller_is_written_with_its_kind() {
        let shown = [
            "logix:10.0.0.5",
            "logix:10.0.0.5/2",
            "modbus:plc:502",
            "modbus:plc",
            "logix:",
            "10.0.0.5",
        ]
        .map(|text| match Controller::parse(text, None) {
            Ok(controller) => controller.to_string(),
            Err(message) => message,
        });
        expect![[r#"
            logix:10.0.0.5
            logix:10.0.0.5/2
            modbus:plc:502
            modbus:plc is not a controller: write logix:ADDRESS/SLOT as in logix:192.168.1.10/0, or modbus:HOST:PORT as in modbus:192.168.1.10:502
            logix: is not a controller: write logix:ADDRESS/SLOT as in logix:192.168.1.10/0, or modbus:HOST:PORT as in modbus:192.168.1.10:502
            10.0.0.5 is not a controller: write logix:ADDRESS/SLOT as in logix:192.168.1.10/0, or modbus:HOST:PORT as in modbus:192.168.1.10:502
        "#]].assert_eq(&(shown.join("\n") + "\n"));
    }

    #[test]
    fn names_there_are_those_of_the_longest_part() {
        let pair = |tag: &str, there: &str| (tag.to_owned(), there.to_owned());
        let asked = Asked {
            names: vec![
                pair("pump", "Program:Main.P1"),
                pair("pump.speed", "Speed"),
                pair("a", "Rows"),
            ],
            ..Asked::default()
        };
        let controller = Controller::parse("logix:h", Some(&asked)).unwrap();
        let shown =
            ["Pump.on", "pump.speed", "pumps", "a[3].b", "run"].map(|name| controller.name_there(name));
        assert_eq!(
            shown,
            ["Program:Main.P1.on", "Speed", "pumps", "Rows[3].b", "run"]
        );
    }
}
