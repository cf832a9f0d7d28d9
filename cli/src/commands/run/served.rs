//! What `[serve.modbus]` and the command line ask to be served.

use super::Arguments;
use crate::outcome::Failure;
use ladder_devices::modbus::{ADDRESS, Hold, Layout, Map, Places, Rules, Subnet, TIMEOUT, Words};
use ladder_simulator::Simulation;
use ladder_workspace::{ServeModbus, Settings};
use std::net::SocketAddr;
use std::time::Duration;

/// A server that is to be.
#[derive(Debug)]
pub(super) struct Served {
    pub(super) address: SocketAddr,
    pub(super) map: Map,
    pub(super) hold: Hold,
    pub(super) rules: Rules,
}

/// What is to be served of a program, if anything.
///
/// # Errors
/// The settings do not fit the program.
pub(super) fn served(
    arguments: &Arguments,
    settings: &Settings,
    simulation: &Simulation,
) -> Result<Option<Served>, Failure> {
    let none = ServeModbus::default();
    let asked = match (&settings.modbus, &arguments.modbus) {
        (Some(asked), _) => asked,
        (None, Some(_)) => &none,
        (None, None) => return Ok(None),
    };
    let address = match arguments.modbus.as_deref() {
        None | Some("") => asked.listen.unwrap_or(ADDRESS),
        Some(text) => text.parse().map_err(|_| {
            Failure::new(format!(
                "--modbus {text}: write an address and a port, as in 127.0.0.1:1502"
            ))
        })?,
    };
    let map = map(asked, simulation)?;
    if map.is_empty() {
        return Err(Failure::new(
            "there is nothing to serve on Modbus: no tag has a direct address such as %QX0.0, and [serve.modbus.map] in ladder.toml names none",
        ));
    }
    let usual = Rules::default();
    let allow = asked
        .allow
        .iter()
        .map(|text| Subnet::parse(text))
        .collect::<Result<_, _>>();
    Ok(Some(Served {
        address,
        map,
        hold: match asked.hold {
            Some("initial") => Hold::Initial(asked.timeout.map_or(TIMEOUT, nanoseconds)),
            _ => Hold::Last,
        },
        rules: Rules {
            units: asked.units.clone().unwrap_or(usual.units),
            allow: allow.map_err(|wrong| Failure::new(format!("`allow` in [serve.modbus]: {wrong}")))?,
            read_only: arguments.read_only,
            connections: asked.connections.unwrap_or(usual.connections),
            idle: asked.idle.map_or(usual.idle, nanoseconds),
        },
    }))
}

fn nanoseconds(time: i64) -> Duration {
    Duration::from_nanos(time.unsigned_abs())
}

/// Which tags are where.
///
/// # Errors
/// The settings do not fit the program.
pub(crate) fn map(asked: &ServeModbus, simulation: &Simulation) -> Result<Map, Failure> {
    let places = Places {
        layout: match asked.layout {
            Some("factory-io") => Layout::FactoryIo,
            _ => Layout::OpenPlc,
        },
        words: match asked.words {
            Some("little") => Words::Little,
            _ => Words::Big,
        },
        named: asked.map.clone(),
        write: asked.write.clone(),
    };
    let map = Map::new(&places, simulation).map_err(|wrong| {
        let lines = wrong
            .iter()
            .map(|wrong| format!("  \"{}\": {}", wrong.about, wrong.message));
        let head = "[serve.modbus] does not fit the program:".to_owned();
        Failure::of_lines(std::iter::once(head).chain(lines))
    })?;
    Ok(map)
}
