//! What `[serve.modbus]` and the command line ask to be served.

use super::Arguments;
use crate::outcome::Failure;
use ladder_devices::modbus::{
    ADDRESS, Hold, Layout, Map, Named, Places, Rules, Subnet, TIMEOUT, Words, Wrong,
};
use ladder_simulator::Simulation;
use ladder_workspace::{ServeModbus, Settings};
use std::net::SocketAddr;
use std::path::Path;
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
    let map = map(asked, &arguments.file, simulation)?;
    let map = if arguments.read_only { map.read_only() } else { map };
    if map.is_empty() {
        return Err(Failure::new(
            "there is nothing to serve on Modbus: no tag has a direct address such as %QX0.0, and [serve.modbus.map] in ladder.toml names none",
        ));
    }
    let usual = Rules::default();
    Ok(Some(Served {
        address,
        map,
        hold: match asked.hold {
            Some("initial") => Hold::Initial(asked.timeout.map_or(TIMEOUT, nanoseconds)),
            _ => Hold::Last,
        },
        rules: Rules {
            units: asked.units.clone().unwrap_or(usual.units),
            allow: allowed(asked).map_err(|wrong| failure(&arguments.file, vec![wrong]))?,
            connections: asked.connections.unwrap_or(usual.connections),
            idle: asked.idle.map_or(usual.idle, nanoseconds),
        },
    }))
}

pub(super) fn nanoseconds(time: i64) -> Duration {
    Duration::from_nanos(time.unsigned_abs())
}

/// From where connections are taken.
pub(super) fn allowed(asked: &ServeModbus) -> Result<Vec<Subnet>, Wrong> {
    let allowed = asked.allow.iter().map(|(text, at)| {
        Subnet::parse(text).map_err(|message| Wrong {
            at: at.clone(),
            message,
        })
    });
    allowed.collect()
}

/// What is asked to be where.
pub(super) fn places(asked: &ServeModbus) -> Places {
    Places {
        layout: Layout::of_setting(asked.layout),
        words: Words::of_setting(asked.words),
        named: Named::of_settings(&asked.map),
        write: asked.write.clone(),
        at: asked.range.clone(),
    }
}

/// Which tags are where.
///
/// # Errors
/// The settings do not fit the program.
pub(crate) fn map(asked: &ServeModbus, file: &Path, simulation: &Simulation) -> Result<Map, Failure> {
    Map::new(&places(asked), simulation).map_err(|wrong| failure(file, wrong))
}

/// What is wrong with settings next to the program of a file.
pub(crate) fn failure(file: &Path, mut wrong: Vec<Wrong>) -> Failure {
    wrong.sort_by_key(|wrong| wrong.at.start);
    let found = wrong
        .iter()
        .map(|wrong| (wrong.at.clone(), wrong.message.clone()));
    match Settings::found_wrong(file, found.collect()) {
        Some(error) => error.into(),
        None => Failure::of_lines(wrong.into_iter().map(|wrong| wrong.message)),
    }
}
