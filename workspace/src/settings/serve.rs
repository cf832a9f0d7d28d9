//! `[run]` and `[serve.modbus]`: programs in real time, and who may see and write their tags.
//!
//! What is here is as it was written; `ladder run` knows what places and networks are.

use super::device::{Placed, places};
use super::given::Value;
use super::reader::{Reader, Table};
use super::table::{
    ALLOW, HOLD, IDLE, LAYOUT, LISTEN, LONGEST_SCAN, MAP, MOST_CONNECTIONS, TIMEOUT, UNIT, WORDS, WRITE,
};
use std::net::SocketAddr;
use std::ops::Range;

/// `[run]`: how programs run in real time.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Run {
    /// How long a scan may take, in nanoseconds.
    pub watchdog: Option<i64>,
}

/// `[serve.modbus]`: what a Modbus server shows. What is absent is left to the caller.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ServeModbus {
    /// Where it listens.
    pub listen: Option<SocketAddr>,
    /// The units that answer.
    pub units: Option<Vec<u8>>,
    /// `"openplc"` or `"factory-io"`.
    pub layout: Option<&'static str>,
    /// `"big"` or `"little"`.
    pub words: Option<&'static str>,
    /// The tags that may be written, and where they are named.
    pub write: Vec<(String, Range<usize>)>,
    /// `"last"` or `"initial"`.
    pub hold: Option<&'static str>,
    /// After how long without a request inputs are no longer held, in nanoseconds.
    pub timeout: Option<i64>,
    /// The networks from which connections are taken.
    pub allow: Vec<(String, Range<usize>)>,
    /// How many connections there are at most.
    pub connections: Option<usize>,
    /// After how long without a request a connection is closed, in nanoseconds.
    pub idle: Option<i64>,
    /// Places and their tags: `holding 100` and `level`.
    pub map: Vec<Placed>,
    /// The whole.
    pub range: Range<usize>,
}

pub(super) fn read_run(mut table: Table, reader: &mut Reader) -> Run {
    let run = Run {
        watchdog: reader.duration(&mut table, &LONGEST_SCAN),
    };
    table.finish(reader);
    run
}

pub(super) fn read_modbus(mut table: Table, reader: &mut Reader) -> ServeModbus {
    let mut texts = |table: &mut Table, setting| {
        let given = reader.take(table, setting);
        let texts = given.map(|given| reader.text_or_texts(&given, setting.example));
        let texts = texts.unwrap_or_default().into_iter();
        texts.map(|(range, text)| (text, range)).collect()
    };
    let (write, allow) = (texts(&mut table, &WRITE), texts(&mut table, &ALLOW));
    let serve = ServeModbus {
        range: table.range(),
        listen: listen(&mut table, reader),
        units: units(&mut table, reader),
        layout: reader.choice(&mut table, &LAYOUT),
        words: reader.choice(&mut table, &WORDS),
        write,
        hold: reader.choice(&mut table, &HOLD),
        timeout: reader.duration(&mut table, &TIMEOUT),
        allow,
        connections: reader
            .whole(&mut table, &MOST_CONNECTIONS)
            .and_then(|most| usize::try_from(most).ok()),
        idle: reader.duration(&mut table, &IDLE),
        map: places(&mut table, &MAP, reader),
    };
    table.finish(reader);
    serve
}

fn listen(table: &mut Table, reader: &mut Reader) -> Option<SocketAddr> {
    let given = reader.take(table, &LISTEN)?;
    let text = reader.text(&given, LISTEN.example)?;
    let parsed = text.parse().ok();
    if parsed.is_none() {
        let message = format!(
            "`{text}` is not an address with a port, for example {}",
            LISTEN.example
        );
        reader.wrong(given.range, message);
    }
    parsed
}

/// One unit, or a list of them.
fn units(table: &mut Table, reader: &mut Reader) -> Option<Vec<u8>> {
    let given = reader.take(table, &UNIT)?;
    let range = given.range.clone();
    let items = match given.value {
        Value::List(items) => items,
        _ => vec![given],
    };
    let units: Option<Vec<u8>> = items
        .iter()
        .map(|item| match item.value {
            Value::Whole(number) => u8::try_from(number).ok(),
            _ => None,
        })
        .collect();
    if units.is_none() {
        let message = format!("units are numbers from 0 to 255, for example {}", UNIT.example);
        reader.wrong(range, message);
    }
    units
}
