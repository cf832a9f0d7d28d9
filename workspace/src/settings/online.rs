//! `[online]`: the running controller that a program is watched on.
//!
//! What is here is as it was written; who goes online finds the tags.

use super::device::{Placed, address, places};
use super::reader::{Reader, Table};
use super::table::{AT_MODBUS, DEVICE_UNIT, DEVICE_WORDS, Kind, LAYOUT, MAP, Section, SetBy, Setting};
use std::ops::Range;

/// A controller. What is absent is left to the caller; times are in nanoseconds.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Online {
    /// A Logix controller: a host, and the slot of the controller after `/`.
    pub logix: Option<String>,
    /// One that speaks Modbus TCP: a host and a port.
    pub modbus: Option<String>,
    /// Which unit answers there.
    pub unit: Option<u8>,
    /// `"openplc"` or `"factory-io"`.
    pub layout: Option<&'static str>,
    /// `"big"` or `"little"`.
    pub words: Option<&'static str>,
    /// From one reading to the next.
    pub every: Option<i64>,
    /// How long an answer may take.
    pub timeout: Option<i64>,
    /// The program of a Logix controller whose tags are meant first.
    pub program: Option<String>,
    /// Places and their tags.
    pub map: Vec<Placed>,
    /// Tags that the controller calls otherwise: the tag, and its name there.
    pub names: Vec<(String, String)>,
    /// The whole.
    pub range: Range<usize>,
}

const LOGIX: Setting = Setting {
    key: "logix",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"192.168.1.10/0\"",
    about: "A Logix controller: the address of its network card, and the slot of the controller.",
};

const MODBUS: Setting = Setting {
    about: "Or a controller that answers on Modbus TCP: a name or an address, and the port, which is 502 for most.",
    ..AT_MODBUS
};

const EVERY: Setting = Setting {
    key: "every",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"200ms\""),
    example: "\"500ms\"",
    about: "The time from one reading to the next.",
};

const TIMEOUT: Setting = Setting {
    key: "timeout",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"2s\""),
    example: "\"5s\"",
    about: "How long an answer may take. After that the connection is made again.",
};

const PROGRAM: Setting = Setting {
    key: "program",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"MainProgram\"",
    about: "The program of a Logix controller whose tags are meant first, then those of the controller. Without it the one that is called as the file.",
};

const PLACES: Setting = Setting {
    about: "Places of tags by name, one a line below `[online.map]`, as in `[serve.modbus.map]`. Without it only tags with direct addresses have places.",
    ..MAP
};

const NAMES: Setting = Setting {
    key: "names",
    kind: Kind::Names,
    place: SetBy::File,
    default: None,
    example: "{ run = \"Program:MainProgram.Run\" }",
    about: "What a Logix controller calls tags that have another name here, one a line below `[online.names]`.",
};

/// The controller that a program is watched on.
pub(super) const ONLINE: Section = Section {
    name: "online",
    list: None,
    about: "The running controller whose values `ladder online` and *Go Online* show. It is read, and never written.",
    settings: &[
        LOGIX,
        MODBUS,
        DEVICE_UNIT,
        LAYOUT,
        DEVICE_WORDS,
        EVERY,
        TIMEOUT,
        PROGRAM,
        PLACES,
        NAMES,
    ],
};

pub(super) fn read(mut table: Table, reader: &mut Reader) -> Online {
    let range = table.range();
    let (logix, modbus) = (text(&mut table, &LOGIX, reader), address(&mut table, reader));
    if logix.is_some() && modbus.is_some() {
        reader.wrong(
            range.clone(),
            "a program is watched on one controller: write `logix` or `modbus`",
        );
    }
    let unit = reader.whole(&mut table, &DEVICE_UNIT);
    let names = places(&mut table, &NAMES, reader).into_iter();
    let online = Online {
        logix,
        modbus,
        unit: unit.and_then(|unit| u8::try_from(unit).ok()),
        layout: reader.choice(&mut table, &LAYOUT),
        words: reader.choice(&mut table, &DEVICE_WORDS),
        every: reader.duration(&mut table, &EVERY),
        timeout: reader.duration(&mut table, &TIMEOUT),
        program: text(&mut table, &PROGRAM, reader),
        map: places(&mut table, &PLACES, reader),
        names: names.map(|named| (named.place, named.tag)).collect(),
        range,
    };
    table.finish(reader);
    online
}

fn text(table: &mut Table, setting: &Setting, reader: &mut Reader) -> Option<String> {
    let given = reader.take(table, setting)?;
    reader.text(&given, setting.example)
}
