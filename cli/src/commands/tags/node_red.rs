//! Tags for Node-RED: a flow for node-red-contrib-modbus that reads them, and names the values.

use super::places::{Served, both};
use ladder_analysis::values::types::Scalar;
use ladder_devices::modbus::{Place, Reading, Table, Words};
use serde_json::{Value, json};
use std::fmt::Write;

/// A tab with a server, and for each request a node that reads, one that names what was read, and one that shows it.
pub(super) fn flow(served: &Served) -> Value {
    let id = |of: &str| identity(&served.name, of);
    let (tab, server) = (id("tab"), id("server"));
    let mut nodes = vec![
        json!({ "id": tab, "type": "tab", "label": served.name, "disabled": false, "info": "" }),
        json!({
            "id": server,
            "type": "modbus-client",
            "name": served.name,
            "clienttype": "tcp",
            "bufferCommands": true,
            "tcpHost": served.address.ip().to_string(),
            "tcpPort": served.address.port().to_string(),
            "tcpType": "DEFAULT",
            "unit_id": served.unit,
            "commandDelay": 1,
            "clientTimeout": 1000,
            "reconnectOnTimeout": true,
            "reconnectTimeout": 2000,
            "parallelUnitIdsAllowed": true,
        }),
    ];
    for (row, reading) in (1..).zip(served.map.readings()) {
        let first = reading.first;
        let [read, name, show] = ["read", "name", "show"].map(|what| id(&format!("{what} {first}")));
        let y = row * 80;
        nodes.push(json!({
            "id": read,
            "type": "modbus-read",
            "z": tab,
            "name": span(&reading),
            "topic": "",
            "unitid": served.unit.to_string(),
            "dataType": kind(first.table),
            "adr": first.number.to_string(),
            "quantity": reading.count.to_string(),
            "rate": "1",
            "rateUnit": "s",
            "server": server,
            "x": 160,
            "y": y,
            "wires": [[name], []],
        }));
        nodes.push(json!({
            "id": name,
            "type": "function",
            "z": tab,
            "name": "names",
            "func": script(&reading, served.map.words()),
            "outputs": 1,
            "x": 400,
            "y": y,
            "wires": [[show]],
        }));
        nodes.push(json!({
            "id": show,
            "type": "debug",
            "z": tab,
            "name": "",
            "active": true,
            "tosidebar": true,
            "complete": "payload",
            "targetType": "msg",
            "x": 600,
            "y": y,
            "wires": [],
        }));
    }
    Value::Array(nodes)
}

/// The same each time, so that a flow that is imported again is known.
fn identity(program: &str, of: &str) -> String {
    let [program, of] = [program, of].map(|name| crc32fast::hash(name.as_bytes()));
    format!("{program:08x}{of:08x}")
}

/// `holding 100..105 (40101..40106)`
fn span(reading: &Reading) -> String {
    let first = reading.first;
    let Some(last) = u16::try_from(reading.count - 1)
        .ok()
        .filter(|more| *more > 0)
        .and_then(|more| first.number.checked_add(more))
    else {
        return both(first);
    };
    let last = Place {
        number: last,
        ..first
    };
    let (from, to) = (first.counted_from_one(), last.counted_from_one());
    format!("{first}..{} ({from}..{to})", last.number)
}

/// What node-red-contrib-modbus calls a table.
fn kind(table: Table) -> &'static str {
    match table {
        Table::Coil => "Coil",
        Table::Discrete => "Input",
        Table::Input => "InputRegister",
        Table::Holding => "HoldingRegister",
    }
}

/// The script of the node that names what was read.
fn script(reading: &Reading, words: Words) -> String {
    let mut script = format!("// {}\nconst read = msg.payload;\n", span(reading));
    if !reading.first.table.is_of_bits() {
        let at = match words {
            Words::Big => "first + nth",
            Words::Little => "first + count - 1 - nth",
        };
        let _ = write!(
            script,
            "const bytes = (first, count) => {{\n    const all = Buffer.alloc(2 * count);\n    for (let nth = 0; nth < count; nth++) all.writeUInt16BE(read[{at}] & 0xffff, 2 * nth);\n    return all;\n}};\n"
        );
    }
    script += "msg.payload = {\n";
    for (place, point) in &reading.tags {
        let at = place.number - reading.first.number;
        let name = Value::from(point.name.as_str());
        let _ = writeln!(
            script,
            "    {name}: {},  // {}",
            value(point.ty, at),
            both(*place)
        );
    }
    script += "};\nreturn msg;\n";
    script
}

/// How a value is taken out of what was read.
fn value(ty: Scalar, at: u16) -> String {
    let (count, reads) = match ty {
        Scalar::Bool => return format!("Boolean(read[{at}])"),
        Scalar::Sint | Scalar::Int => (1, "readInt16BE"),
        Scalar::Dint | Scalar::Time => (2, "readInt32BE"),
        Scalar::Udint | Scalar::Dword => (2, "readUInt32BE"),
        Scalar::Real => (2, "readFloatBE"),
        Scalar::Lreal => (4, "readDoubleBE"),
        Scalar::Lint => return format!("Number(bytes({at}, 4).readBigInt64BE())"),
        Scalar::Ulint | Scalar::Lword => return format!("Number(bytes({at}, 4).readBigUInt64BE())"),
        _ => (1, "readUInt16BE"),
    };
    format!("bytes({at}, {count}).{reads}()")
}
