//! `[[device]]`: inputs and outputs that are at the other end of a network.
//!
//! What is here is as it was written; `ladder run` finds the tags.

use super::given::Value;
use super::reader::{Reader, Table};
use super::table::{
    AGE, AT_MODBUS, DEVICE, DEVICE_NAME, DEVICE_UNIT, DEVICE_WORDS, GAP, OK, PATIENCE, POLL, READ, REPEAT,
    Setting, WRITTEN,
};
use std::ops::Range;

/// A device. What is absent is left to the caller; times are in nanoseconds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Device {
    /// What it is called.
    pub name: String,
    /// Where it is: a name or an address, and a port.
    pub modbus: String,
    /// Which unit answers there.
    pub unit: Option<u8>,
    /// `"big"` or `"little"`.
    pub words: Option<&'static str>,
    /// From one exchange to the next.
    pub poll: Option<i64>,
    /// After how long outputs are written again.
    pub repeat: Option<i64>,
    /// How long an answer may take.
    pub timeout: Option<i64>,
    /// How many places that nobody asked for are read along.
    pub gap: Option<usize>,
    /// The tag that is high while it answers.
    pub ok: Option<(String, Range<usize>)>,
    /// The tag that has the time since its last answer.
    pub age: Option<(String, Range<usize>)>,
    /// What is read.
    pub read: Vec<Placed>,
    /// What is written.
    pub write: Vec<Placed>,
}

/// A place and the tag that is there: `holding 100` and `level`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Placed {
    /// The place, or the first and the last.
    pub place: String,
    /// The tag.
    pub tag: String,
    /// Where that is written.
    pub range: Range<usize>,
}

pub(super) fn read(tables: Vec<Table>, reader: &mut Reader) -> Vec<Device> {
    let mut devices: Vec<Device> = Vec::new();
    for table in tables {
        let range = table.range();
        let Some(device) = device(table, reader) else {
            continue;
        };
        let is_it = |other: &Device| other.name.eq_ignore_ascii_case(&device.name);
        if devices.iter().any(is_it) {
            reader.wrong(range, format!("there are two devices `{}`", device.name));
        } else {
            devices.push(device);
        }
    }
    devices
}

fn device(mut table: Table, reader: &mut Reader) -> Option<Device> {
    reader.needs(&table, &DEVICE);
    if !table.has(READ.key) && !table.has(WRITTEN.key) {
        let message = format!(
            "a device has `read`, `write` or both, for example read = {}",
            READ.example
        );
        reader.wrong(table.range(), message);
    }
    let name = reader.take(&mut table, &DEVICE_NAME);
    let name = name.and_then(|given| reader.text(&given, DEVICE_NAME.example));
    let modbus = address(&mut table, reader);
    let mut tag = |table: &mut Table, setting: &Setting| {
        let given = reader.take(table, setting)?;
        Some((reader.text(&given, setting.example)?, given.range))
    };
    let (ok, age) = (tag(&mut table, &OK), tag(&mut table, &AGE));
    let unit = reader.whole(&mut table, &DEVICE_UNIT);
    let gap = reader.whole(&mut table, &GAP);
    let (words, poll) = (
        reader.choice(&mut table, &DEVICE_WORDS),
        reader.duration(&mut table, &POLL),
    );
    let (repeat, timeout) = (
        reader.duration(&mut table, &REPEAT),
        reader.duration(&mut table, &PATIENCE),
    );
    let (read, write) = (
        places(&mut table, &READ, reader),
        places(&mut table, &WRITTEN, reader),
    );
    table.finish(reader);
    Some(Device {
        name: name?,
        modbus: modbus?,
        unit: unit.and_then(|unit| u8::try_from(unit).ok()),
        words,
        poll,
        repeat,
        timeout,
        gap: gap.and_then(|gap| usize::try_from(gap).ok()),
        ok,
        age,
        read,
        write,
    })
}

/// A host and a port.
pub(super) fn address(table: &mut Table, reader: &mut Reader) -> Option<String> {
    let given = reader.take(table, &AT_MODBUS)?;
    let text = reader.text(&given, AT_MODBUS.example)?;
    let (host, port) = text.rsplit_once(':').unwrap_or_default();
    if host.is_empty() || !port.parse::<u16>().is_ok_and(|port| port > 0) {
        let message = format!(
            "`{text}` is not an address with its port, for example {}",
            AT_MODBUS.example
        );
        reader.wrong(given.range, message);
        return None;
    }
    Some(text)
}

/// A table of places and their tags, or of other pairs.
pub(super) fn places(table: &mut Table, setting: &Setting, reader: &mut Reader) -> Vec<Placed> {
    let Some(given) = reader.take(table, setting) else {
        return Vec::new();
    };
    let Value::Table(entries) = given.value else {
        let (key, example) = (setting.key, setting.example);
        let message = format!(
            "`{key}` is a table of {}, for example {key} = {example}",
            setting.kind.entries()
        );
        reader.wrong(given.range, message);
        return Vec::new();
    };
    let placed = entries.into_iter().map(|entry| {
        let tag = reader.text(&entry.given, "\"level\"")?;
        Some(Placed {
            place: entry.key,
            tag,
            range: entry.range.start..entry.given.range.end,
        })
    });
    placed.flatten().collect()
}
