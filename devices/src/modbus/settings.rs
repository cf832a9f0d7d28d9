//! What `[serve.modbus]` asks to be served, and `[[device]]` to be connected.

use super::bind::{Layout, Map, Named, Places};
use super::device::{Device, bind};
use super::image::{Hold, TIMEOUT};
use super::registers::Words;
use super::server::{ADDRESS, Rules, Subnet};
use crate::wrong::Wrong;
use ladder_simulator::{Simulation, real_time};
use ladder_workspace::{Misfit, ServeModbus, Settings};
use std::net::SocketAddr;

/// Why a map without a tag is not served.
pub const NOTHING: &str = "there is nothing to serve on Modbus: no tag has a direct address such as %QX0.0, and [serve.modbus.map] in ladder.toml names none";

/// A server that is to be.
#[derive(Debug)]
pub struct ToServe {
    /// Where it is to listen.
    pub address: SocketAddr,
    /// Which tag is where.
    pub map: Map,
    /// What written inputs do when nobody asks any more.
    pub hold: Hold,
    /// Who may ask what.
    pub rules: Rules,
}

impl ToServe {
    /// What settings ask to be served of a program.
    ///
    /// # Errors
    /// They do not fit the program.
    pub fn of(asked: &ServeModbus, simulation: &Simulation) -> Result<ToServe, Vec<Wrong>> {
        let usual = Rules::default();
        let (map, allow) = match (map(asked, simulation), allowed(asked)) {
            (Ok(map), Ok(allow)) => (map, allow),
            (map, allow) => {
                return Err(map.err().into_iter().flatten().chain(allow.err()).collect());
            }
        };
        Ok(ToServe {
            address: asked.listen.unwrap_or(ADDRESS),
            map,
            hold: match asked.hold {
                Some("initial") => Hold::Initial(asked.timeout.map_or(TIMEOUT, real_time)),
                _ => Hold::Last,
            },
            rules: Rules {
                units: asked.units.clone().unwrap_or(usual.units),
                allow,
                connections: asked.connections.unwrap_or(usual.connections),
                idle: asked.idle.map_or(usual.idle, real_time),
            },
        })
    }
}

/// From where connections are taken.
///
/// # Errors
/// A network is not one.
fn allowed(asked: &ServeModbus) -> Result<Vec<Subnet>, Wrong> {
    let allowed = asked.allow.iter().map(|(text, at)| {
        Subnet::parse(text).map_err(|message| Wrong {
            at: at.clone(),
            message,
        })
    });
    allowed.collect()
}

/// Which tags are where.
///
/// # Errors
/// The settings do not fit the program.
pub fn map(asked: &ServeModbus, simulation: &Simulation) -> Result<Map, Vec<Wrong>> {
    Map::new(&places(asked), simulation)
}

/// What is asked to be where.
fn places(asked: &ServeModbus) -> Places {
    Places {
        layout: Layout::of_setting(asked.layout),
        words: Words::of_setting(asked.words),
        named: Named::of_settings(&asked.map),
        write: asked.write.clone(),
        at: asked.range.clone(),
    }
}

/// The devices of `[[device]]`.
pub fn devices(settings: &Settings) -> Vec<Device> {
    settings.devices.iter().map(device).collect()
}

fn device(set: &ladder_workspace::Device) -> Device {
    let usual = Device::new(&set.name, &set.modbus);
    Device {
        unit: set.unit.unwrap_or(usual.unit),
        words: Words::of_setting(set.words),
        poll: set.poll.map_or(usual.poll, real_time),
        repeat: set.repeat.map_or(usual.repeat, real_time),
        timeout: set.timeout.map_or(usual.timeout, real_time),
        gap: set.gap.unwrap_or(usual.gap),
        ok: set.ok.clone(),
        age: set.age.clone(),
        read: Named::of_settings(&set.read),
        write: Named::of_settings(&set.write),
        ..usual
    }
}

/// What `[serve.modbus]` and `[[device]]` ask for and a program has not.
pub fn misfits(settings: &Settings, simulation: &Simulation) -> Vec<Misfit> {
    let mut wrong = Vec::new();
    let mut served = None;
    if let Some(asked) = &settings.modbus {
        wrong.extend(allowed(asked).err());
        match map(asked, simulation) {
            Ok(own) => served = Some(own),
            Err(own) => wrong.extend(own),
        }
    }
    if let Err(own) = bind(&devices(settings), served.as_ref(), simulation) {
        wrong.extend(own);
    }
    wrong.into_iter().map(Misfit::from).collect()
}
