//! A controller that is watched by Modbus: what its places hold is what the tags at them hold.

use super::Map;
use super::blocks::{Block, GAP, Limits, blocks};
use super::client::{Client, Failed, open};
use super::guard::Guard;
use super::registers::value;
use crate::source::Source;
use ladder_analysis::values::value::Value;
use ladder_simulator::online::{Found, Wanted};
use std::time::Duration;
use tokio::runtime::{Builder, Runtime};

/// A controller, by its address, and which of its places hold what.
pub struct Modbus {
    address: String,
    unit: u8,
    patience: Duration,
    map: Map,
    blocks: Vec<Block>,
    runtime: Option<Runtime>,
    client: Option<Client>,
}

impl Modbus {
    /// A controller at an address with its port. An answer that has not come after `patience` does not come.
    pub fn new(address: impl Into<String>, unit: u8, map: Map, patience: Duration) -> Modbus {
        Modbus {
            address: address.into(),
            unit,
            patience,
            blocks: blocks(&map.entries, Limits::of_reading(GAP)),
            map,
            runtime: None,
            client: None,
        }
    }

    /// What is asked for: the tags of the map, by their places.
    pub fn wanted(&self) -> Vec<Wanted> {
        let tags = self.map.tags();
        tags.map(|(place, point, _)| Wanted {
            point: point.clone(),
            name: place.to_string(),
        })
        .collect()
    }
}

impl Source for Modbus {
    /// Modbus does not tell what is where: all counts as there.
    fn connect(&mut self) -> Result<Vec<Found>, String> {
        let runtime = match self.runtime.take() {
            Some(runtime) => runtime,
            None => Builder::new_current_thread()
                .enable_all()
                .build()
                .map_err(|error| error.to_string())?,
        };
        let runtime = self.runtime.insert(runtime);
        self.client = None;
        let stream = runtime.block_on(open(&self.address, self.patience))?;
        // The guard is the only way to the socket.
        self.client = Some(Client::over(Guard::new(stream), self.unit, self.patience));
        Ok(vec![Found::Here; self.map.entries.len()])
    }

    fn read(&mut self) -> Result<Vec<Option<Value>>, String> {
        let (Some(runtime), Some(client)) = (&self.runtime, &mut self.client) else {
            return Err("is not connected".to_owned());
        };
        let mut values = Vec::with_capacity(self.map.entries.len());
        let mut refused = None;
        for block in &self.blocks {
            let entries = &self.map.entries[block.entries.clone()];
            match runtime.block_on(client.read(block)) {
                Ok(words) => values.extend(entries.iter().map(|entry| {
                    let from = usize::from(entry.place.number - block.first.number);
                    let own = words.get(from..from + entry.width)?;
                    if entry.place.table.is_of_bits() {
                        return Some(Value::Bool(own[0] != 0));
                    }
                    value(own, entry.point.ty, self.map.words)
                })),
                Err(Failed::Refused(why)) => {
                    values.extend(entries.iter().map(|_| None));
                    refused = Some(why);
                }
                Err(Failed::Lost(why)) => return Err(why),
            }
        }
        match refused {
            Some(why) if values.iter().all(Option::is_none) => Err(why),
            _ => Ok(values),
        }
    }
}
