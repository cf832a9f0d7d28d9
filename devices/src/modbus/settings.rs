//! What `[serve.modbus]` asks to be served.

use super::bind::{Layout, Map, Named, Places};
use super::image::{Hold, TIMEOUT};
use super::registers::Words;
use super::server::{ADDRESS, Rules, Subnet};
use crate::wrong::Wrong;
use ladder_simulator::Simulation;
use ladder_workspace::ServeModbus;
use std::net::SocketAddr;
use std::time::Duration;

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
        let nanoseconds = |time: i64| Duration::from_nanos(time.unsigned_abs());
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
                Some("initial") => Hold::Initial(asked.timeout.map_or(TIMEOUT, nanoseconds)),
                _ => Hold::Last,
            },
            rules: Rules {
                units: asked.units.clone().unwrap_or(usual.units),
                allow,
                connections: asked.connections.unwrap_or(usual.connections),
                idle: asked.idle.map_or(usual.idle, nanoseconds),
            },
        })
    }
}

/// From where connections are taken.
///
/// # Errors
/// A network is not one.
pub fn allowed(asked: &ServeModbus) -> Result<Vec<Subnet>, Wrong> {
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
