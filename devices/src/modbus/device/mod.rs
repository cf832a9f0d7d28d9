//! Devices: inputs and outputs of the program that are at the other end of a network.
//!
//! ```text
//! [[device]] --bind--> Wired (which tag is where) --connect--> Devices --give, take--> scan thread
//!                                                                 `-- one task for each: blocks by requests
//! ```

mod client;
mod exchange;

use super::bind::{Entry, Map, Named, at, in_order, may_be_given};
use super::blocks::{GAP, Limits, blocks};
use super::registers::Words;
use crate::wrong::Wrong;
pub use exchange::Devices;
use exchange::Plan;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::{Point, Simulation};
use std::collections::HashMap;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

/// A device, as it was written.
#[derive(Debug, Clone)]
pub struct Device {
    /// What people call it.
    pub name: String,
    /// Where it is: a name or an address, and a port.
    pub address: String,
    /// Which unit answers there.
    pub unit: u8,
    /// The order of the words of a value.
    pub words: Words,
    /// From one exchange to the next.
    pub poll: Duration,
    /// After so long outputs are written again though they have not changed.
    pub repeat: Duration,
    /// An answer that has not come for so long does not come.
    pub timeout: Duration,
    /// So many places that nobody asked for are read along with their neighbours.
    pub gap: usize,
    /// The BOOL that is high while it answers, and where it is named.
    pub ok: Option<(String, Range<usize>)>,
    /// The TIME since its last answer.
    pub age: Option<(String, Range<usize>)>,
    /// What is read, and where it goes.
    pub read: Vec<Named>,
    /// What is written, and from where.
    pub write: Vec<Named>,
}

impl Device {
    /// One with nothing wired to it, and for all else what holds if nothing is set.
    pub fn new(name: impl Into<String>, address: impl Into<String>) -> Device {
        Device {
            name: name.into(),
            address: address.into(),
            unit: 1,
            words: Words::default(),
            poll: Duration::from_millis(100),
            repeat: Duration::from_millis(500),
            timeout: Duration::from_secs(1),
            gap: GAP,
            ok: None,
            age: None,
            read: Vec::new(),
            write: Vec::new(),
        }
    }
}

/// A device whose tags are found.
#[derive(Debug, Clone)]
pub struct Wired {
    device: Device,
    plan: Arc<Plan>,
}

impl fmt::Display for Wired {
    /// `device rio at 192.168.1.20:502: values read 9, written 2`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Device { name, address, .. } = &self.device;
        let (read, written) = (self.plan.reads.len(), self.plan.writes.len());
        write!(
            f,
            "device {name} at {address}: values read {read}, written {written}"
        )
    }
}

/// Finds the tags of a program that devices are wired to. `served` is what clients may write at the same time.
///
/// # Errors
/// A tag is not there or has no form on the wire, two are at one place, two sources write one tag, or something is to be written
/// that cannot be.
pub fn bind(
    devices: &[Device],
    served: Option<&Map>,
    simulation: &Simulation,
) -> Result<Vec<Wired>, Vec<Wrong>> {
    let mut wrong = Vec::new();
    let mut sources = Sources::default();
    for (_, point, _) in served.into_iter().flat_map(Map::tags).filter(|tag| tag.2) {
        sources
            .0
            .insert(point.name.clone(), "clients of [serve.modbus]".to_owned());
    }
    let mut wired = Vec::new();
    for device in devices {
        let reads = entries(&device.read, simulation, &mut wrong);
        for entry in &reads {
            wrong.extend(sources.add(&entry.point, device, &entry.at));
        }
        let writes = entries(&device.write, simulation, &mut wrong);
        let refused = writes.iter().filter(|entry| !entry.place.table.is_written());
        wrong.extend(refused.map(|entry| Wrong {
            at: entry.at.clone(),
            message: format!(
                "{} cannot be written: only coils and holding registers can",
                entry.place
            ),
        }));
        let mut told = |named: &Option<(String, Range<usize>)>, ty| {
            let (tag, range) = named.as_ref()?;
            let point = status(tag, ty, simulation).map_err(|message| Wrong {
                at: range.clone(),
                message,
            });
            let point = point.and_then(|point| match sources.add(&point, device, range) {
                Some(wrong) => Err(wrong),
                None => Ok(point),
            });
            point.map_err(|own| wrong.push(own)).ok()
        };
        let (ok, age) = (told(&device.ok, Scalar::Bool), told(&device.age, Scalar::Time));
        wired.push(Wired {
            device: device.clone(),
            plan: Arc::new(Plan {
                read_blocks: blocks(&reads, Limits::of_reading(device.gap)),
                write_blocks: blocks(&writes, Limits::OF_WRITING),
                reads,
                writes,
                words: device.words,
                ok,
                age,
            }),
        });
    }
    if wrong.is_empty() { Ok(wired) } else { Err(wrong) }
}

/// Who writes a tag, by its name: nobody else may.
#[derive(Default)]
struct Sources(HashMap<String, String>);

impl Sources {
    /// A device writes a tag, too. What is wrong with that, if anything is.
    fn add(&mut self, point: &Point, device: &Device, at: &Range<usize>) -> Option<Wrong> {
        let refused = may_be_given(point).err();
        let message = refused.or_else(|| {
            let other = self
                .0
                .insert(point.name.clone(), format!("the device {}", device.name))?;
            Some(format!("{} is written by {other} already", point.name))
        });
        message.map(|message| Wrong {
            at: at.clone(),
            message,
        })
    }
}

/// The values of a list, in the order of their places.
fn entries(named: &[Named], simulation: &Simulation, wrong: &mut Vec<Wrong>) -> Vec<Entry> {
    let mut entries = Vec::new();
    for named in named {
        match at(named, simulation) {
            Ok(found) => entries.extend(found),
            Err(message) => wrong.push(Wrong {
                at: named.at.clone(),
                message,
            }),
        }
    }
    wrong.extend(in_order(&mut entries));
    entries
}

/// The tag that says how a device is.
fn status(tag: &str, ty: Scalar, simulation: &Simulation) -> Result<Point, String> {
    let point = simulation.resolve(tag).map_err(|unknown| unknown.to_string())?;
    if point.ty != ty {
        return Err(format!("{} is {}, and {ty} is needed here", point.name, point.ty));
    }
    Ok(point)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::simulation;
    use expect_test::{Expect, expect};

    const VALVE: &str = "VAR_INPUT\n    rio_ok : BOOL;\n    rio_age : TIME;\n    level : INT;\n    heat : ARRAY[1..3] OF REAL;\nEND_VAR\n\
        VAR_OUTPUT\n    speed : DINT;\n    open AT %QX0.0 : BOOL;\nEND_VAR\nVAR CONSTANT\n    k : INT := 5;\nEND_VAR\n\
        +--[ ]( %IX10.7 )--[ ]( %IX11.1 )--( )( open )--( )( %QX10.1 )--+\n+--[MOV]( speed, k )--[GT]( heat[1], level )--( )( %QX10.0 )--+\n";

    fn check(device: &Device, expected: Expect) {
        let shown: Vec<String> =
            match bind(std::slice::from_ref(device), None, &simulation(VALVE, 10_000_000)) {
                Ok(wired) => {
                    let plan = &wired[0].plan;
                    let entries = plan.reads.iter().chain(&plan.writes);
                    let blocks = plan.read_blocks.iter().chain(&plan.write_blocks);
                    entries
                        .map(|entry| format!("{} {}", entry.place, entry.point.name))
                        .chain(blocks.map(|block| format!("= {block}")))
                        .collect()
                }
                Err(wrong) => Wrong::lines(&wrong),
            };
        expected.assert_eq(&(shown.join("\n") + "\n"));
    }

    #[test]
    fn runs_of_places_are_addresses_one_after_the_other() {
        check(
            &Device {
                ok: Some(("rio_ok".to_owned(), 0..0)),
                age: Some(("rio_age".to_owned(), 0..0)),
                read: Named::list(&[
                    ("discrete 0..15", "%IX10.0"),
                    ("input 0", "level"),
                    ("input 4..9", "heat"),
                ]),
                write: Named::list(&[
                    ("coil 0..7", "%QX10.0"),
                    ("coil 2", "open"),
                    ("holding 4", "speed"),
                ]),
                ..Device::new("rio", "10.0.0.5:502")
            },
            expect![[r#"
                discrete 7 %IX10.7
                discrete 9 %IX11.1
                input 0 level
                input 4 heat[1]
                input 6 heat[2]
                input 8 heat[3]
                coil 0 %QX10.0
                coil 1 %QX10.1
                coil 2 open
                holding 4 speed
                = discrete 7..9
                = input 0..9
                = coil 0..2
                = holding 4..5
            "#]],
        );
    }

    #[test]
    fn what_cannot_be_is_told() {
        check(
            &Device {
                ok: Some(("level".to_owned(), 10..10)),
                age: Some(("nothing".to_owned(), 11..11)),
                read: Named::list(&[
                    ("input 0", "level"),
                    ("input 1", "level"),
                    ("input 10..12", "heat"),
                    ("input 20", "speed"),
                    ("discrete 0..3", "%IX50.0"),
                    ("input 30", "k"),
                    ("input 9..7", "heat"),
                    ("input 65533..65536", "heat"),
                    ("discrete 4", "rio_ok"),
                    ("discrete 4", "%IX10.7"),
                ]),
                write: Named::list(&[("input 0", "speed"), ("discrete 8", "open")]),
                ..Device::new("rio", "10.0.0.5:502")
            },
            expect![[r#"
                3: heat takes 6 places, and input 10..12 is another number of them
                5: the program has none of the addresses from %IX50.0 on
                7: input 9..7 has no places: write the smaller number first
                8: 65536 is not a number of a place: they are from 0 to 65535
                10: rio_ok and %IX10.7 are both at discrete 4
                2: level is written by the device rio already
                4: speed is an output: the program writes it
                6: k is never written
                2: discrete 8 cannot be written: only coils and holding registers can
                1: input 0 cannot be written: only coils and holding registers can
                10: level is INT, and BOOL is needed here
                11: there is no tag `nothing` in this program
            "#]],
        );
    }
}
