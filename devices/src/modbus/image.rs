//! What clients see and write: the values of one scan, and what waits for the next.

use super::bind::{Entry, Map};
use super::place::Table;
use super::registers::{value, words};
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, Simulation};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Why a request is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refused {
    /// Nothing is there, or it must not be written: exception 2.
    Address,
    /// Too much at once, half of a value, or a value that the tag cannot have: exception 3.
    Value,
}

/// After so long without a request nobody is there, if nothing else is asked for.
pub const TIMEOUT: Duration = Duration::from_secs(2);

/// What the written inputs do when nobody asks for anything any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hold {
    /// They keep their values.
    #[default]
    Last,
    /// They are what they are before anything is written, after so long a time.
    Initial(Duration),
}

/// The image of a program: shared by the thread that scans and those that serve.
#[derive(Debug, Clone)]
pub struct Image(Arc<Mutex<Inner>>);

#[derive(Debug)]
struct Inner {
    map: Map,
    tables: [Area; 4],
    /// What is given to the program before the next scan, in the order in which it was written.
    waiting: Vec<(usize, Value)>,
    hold: Hold,
    /// When the last request came; none if that was so long ago that the written inputs are their initial values.
    heard: Option<Instant>,
}

/// The part of a table that has tags.
#[derive(Debug, Clone, Default)]
struct Area {
    first: usize,
    /// What is read: words, or bits as 0 and 1. Gaps are 0.
    values: Vec<u16>,
    /// For each the entry that is there.
    entries: Vec<Option<usize>>,
}

impl Image {
    /// The image of a program before its first scan.
    pub fn new(map: Map, hold: Hold, simulation: &Simulation) -> Image {
        let tables = Table::ALL.map(|table| Area::of(table, &map.entries));
        let mut inner = Inner {
            map,
            tables,
            waiting: Vec::new(),
            hold,
            heard: None,
        };
        inner.take(simulation);
        Image(Arc::new(Mutex::new(inner)))
    }

    /// The same clients see another program from now on, or this one with other tags.
    pub fn replace(&self, other: &Image) {
        let mut inner = self.lock();
        let other = other.lock();
        inner.map.clone_from(&other.map);
        inner.tables.clone_from(&other.tables);
        inner.waiting.clear();
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Before a scan: what was written is given to the program; of one request all or nothing.
    pub fn give(&self, simulation: &mut Simulation, now: Instant) {
        for (point, value) in self.written(simulation, now) {
            // A tag that is held at another value keeps what was written underneath.
            let _ = simulation.set(&point, value);
        }
    }

    /// What was written since this was asked last, in that order.
    pub fn written(&self, simulation: &Simulation, now: Instant) -> Vec<(Point, Value)> {
        let mut inner = self.lock();
        let inner = &mut *inner;
        if let (Hold::Initial(after), Some(heard)) = (inner.hold, inner.heard)
            && now.saturating_duration_since(heard) > after
        {
            inner.heard = None;
            let written = inner
                .map
                .entries
                .iter()
                .enumerate()
                .filter(|(_, entry)| entry.may_be_written);
            inner
                .waiting
                .extend(written.map(|(index, entry)| (index, simulation.initial(&entry.point))));
        }
        let entries = &inner.map.entries;
        let written = inner.waiting.drain(..);
        written
            .filter_map(|(index, value)| Some((entries.get(index)?.point.clone(), value)))
            .collect()
    }

    /// After a scan: clients see its values.
    pub fn take(&self, simulation: &Simulation) {
        self.lock().take(simulation);
    }

    /// What is there, from a number on.
    ///
    /// # Errors
    /// It is too much for one request, or no tag is there.
    pub fn read(&self, table: Table, first: u16, count: u16, now: Instant) -> Result<Vec<u16>, Refused> {
        let mut inner = self.lock();
        inner.heard = Some(now);
        let count = usize::from(count);
        if count == 0 || count > table.most_read() {
            return Err(Refused::Value);
        }
        let area = &inner.tables[table as usize];
        let at = usize::from(first)
            .checked_sub(area.first)
            .ok_or(Refused::Address)?;
        let values = area.values.get(at..at + count).ok_or(Refused::Address)?;
        Ok(values.to_vec())
    }

    /// Writes before the next scan.
    ///
    /// # Errors
    /// It is too much for one request, nothing is there that may be written, it is half of a value, or the tag cannot
    /// have it. Nothing of it is written then.
    pub fn write(&self, table: Table, first: u16, values: &[u16], now: Instant) -> Result<(), Refused> {
        let mut inner = self.lock();
        let inner = &mut *inner;
        inner.heard = Some(now);
        if values.is_empty() || values.len() > table.most_written() {
            return Err(Refused::Value);
        }
        let area = &inner.tables[table as usize];
        let mut at = usize::from(first)
            .checked_sub(area.first)
            .ok_or(Refused::Address)?;
        let mut left = values;
        let mut written = Vec::new();
        while !left.is_empty() {
            let index = area.entries.get(at).copied().flatten().ok_or(Refused::Address)?;
            let entry = &inner.map.entries[index];
            if !entry.may_be_written {
                return Err(Refused::Address);
            }
            let begins = usize::from(entry.place.number) - area.first;
            let own = left
                .get(..entry.width)
                .filter(|_| begins == at)
                .ok_or(Refused::Value)?;
            let value = if table.is_of_bits() {
                Value::Bool(own[0] != 0)
            } else {
                value(own, entry.point.ty, inner.map.words).ok_or(Refused::Value)?
            };
            written.push((index, value));
            at += entry.width;
            left = &left[entry.width..];
        }
        // Of what is written several times before a scan the last counts, so that nobody makes this grow.
        inner
            .waiting
            .retain(|(index, _)| written.iter().all(|(other, _)| other != index));
        inner.waiting.append(&mut written);
        Ok(())
    }
}

impl Inner {
    fn take(&mut self, simulation: &Simulation) {
        for entry in &self.map.entries {
            let area = &mut self.tables[entry.place.table as usize];
            let at = usize::from(entry.place.number) - area.first;
            let read = simulation.value(&entry.point);
            if let Value::Bool(high) = read {
                area.values[at] = u16::from(high);
            } else {
                let read = words(&read, entry.point.ty, self.map.words);
                area.values[at..at + entry.width].copy_from_slice(&read);
            }
        }
    }
}

impl Area {
    fn of(table: Table, entries: &[Entry]) -> Area {
        let own = entries
            .iter()
            .enumerate()
            .filter(|(_, entry)| entry.place.table == table);
        let own: Vec<(usize, &Entry)> = own.collect();
        let begins = |entry: &Entry| usize::from(entry.place.number);
        let (Some((_, first)), Some((_, last))) = (own.first(), own.last()) else {
            return Area::default();
        };
        let (first, end) = (begins(first), begins(last) + last.width);
        let mut area = Area {
            first,
            values: vec![0; end - first],
            entries: vec![None; end - first],
        };
        for (index, entry) in own {
            let at = begins(entry) - first;
            area.entries[at..at + entry.width].fill(Some(index));
        }
        area
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modbus::bind::{Layout, Named, Places};
    use crate::tests::simulation;

    const MIXER: &str = "VAR_INPUT\n    go : BOOL;\n    wanted : DINT := 70000;\n    percent : USINT;\nEND_VAR\nVAR_OUTPUT\n    on AT %QX0.0 : BOOL;\n    got : DINT;\nEND_VAR\n\
        +--[ ]( go )--( )( on )--+\n+--[MOV]( got, wanted )--+\n";

    fn mixer(hold: Hold) -> (Image, Simulation) {
        let simulation = simulation(MIXER, 10_000_000);
        let named = [
            ("coil 4", "go"),
            ("holding 10", "wanted"),
            ("holding 14", "percent"),
            ("holding 20", "got"),
        ];
        let places = Places {
            layout: Layout::OpenPlc,
            named: Named::list(&named),
            write: ["go", "wanted", "percent"]
                .map(|tag| (tag.to_owned(), 0..0))
                .to_vec(),
            ..Places::default()
        };
        let map = Map::new(&places, &simulation).unwrap();
        (Image::new(map, hold, &simulation), simulation)
    }

    fn scan(image: &Image, simulation: &mut Simulation, now: Instant) {
        image.give(simulation, now);
        simulation.scan();
        image.take(simulation);
    }

    #[test]
    fn what_is_written_comes_before_the_next_scan_and_is_read_after_it() {
        let (image, mut simulation) = mixer(Hold::Last);
        let now = Instant::now();
        assert_eq!(image.read(Table::Holding, 10, 2, now), Ok(vec![1, 4464]));
        assert_eq!(image.write(Table::Holding, 10, &[0, 7], now), Ok(()));
        assert_eq!(image.write(Table::Coil, 4, &[1], now), Ok(()));
        assert_eq!(image.read(Table::Holding, 20, 2, now), Ok(vec![0, 0]));
        scan(&image, &mut simulation, now);
        assert_eq!(image.read(Table::Holding, 20, 2, now), Ok(vec![0, 7]));
        assert_eq!(image.read(Table::Coil, 0, 5, now), Ok(vec![1, 0, 0, 0, 1]));
    }

    #[test]
    fn gaps_are_0_and_beyond_them_is_nothing() {
        let (image, _) = mixer(Hold::Last);
        let now = Instant::now();
        assert_eq!(image.read(Table::Holding, 11, 3, now), Ok(vec![4464, 0, 0]));
        for (first, count) in [(9, 2), (21, 2), (0, 1), (65535, 1)] {
            assert_eq!(
                image.read(Table::Holding, first, count, now),
                Err(Refused::Address)
            );
        }
        assert_eq!(image.read(Table::Input, 0, 1, now), Err(Refused::Address));
        assert_eq!(image.read(Table::Holding, 10, 126, now), Err(Refused::Value));
        assert_eq!(image.read(Table::Coil, 0, 0, now), Err(Refused::Value));
    }

    #[test]
    fn all_of_a_request_is_written_or_nothing() {
        let (image, mut simulation) = mixer(Hold::Last);
        let now = Instant::now();
        for (first, values, refused) in [
            // Half of a value.
            (10, &[1][..], Refused::Value),
            (11, &[1], Refused::Value),
            (10, &[0, 5, 0], Refused::Address),
            // A value that the tag cannot have.
            (14, &[300], Refused::Value),
            // An output.
            (20, &[0, 1], Refused::Address),
        ] {
            assert_eq!(
                image.write(Table::Holding, first, values, now),
                Err(refused),
                "{first}"
            );
        }
        assert_eq!(image.write(Table::Discrete, 0, &[1], now), Err(Refused::Address));
        scan(&image, &mut simulation, now);
        assert_eq!(image.read(Table::Holding, 20, 2, now), Ok(vec![1, 4464]));
    }

    #[test]
    fn inputs_go_back_when_nobody_is_there() {
        let (image, mut simulation) = mixer(Hold::Initial(Duration::from_secs(2)));
        let now = Instant::now();
        image.write(Table::Holding, 10, &[0, 7], now).unwrap();
        scan(&image, &mut simulation, now + Duration::from_secs(1));
        assert_eq!(image.read(Table::Holding, 20, 2, now), Ok(vec![0, 7]));
        scan(&image, &mut simulation, now + Duration::from_secs(3));
        assert_eq!(image.read(Table::Holding, 20, 2, now), Ok(vec![1, 4464]));
    }
}
