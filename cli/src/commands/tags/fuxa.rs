//! Tags for FUXA: the file that its list of devices imports.

use super::places::{Served, both};
use crate::terminal;
use ladder_analysis::values::types::Scalar;
use ladder_devices::modbus::{Table, Words};
use serde_json::{Map, Value, json};

/// How often FUXA asks, in milliseconds.
const POLLING: u32 = 500;

/// A list of one device. Its name and those of its tags make their identities, so that importing it again changes the device
/// that is there, and screens keep their tags.
pub(super) fn devices(served: &Served) -> Value {
    let mut tags = Map::new();
    let mut left_out = Vec::new();
    for (place, point, _) in served.map.tags() {
        let Some(ty) = type_of(point.ty, served.map.words()) else {
            left_out.push(point.name.as_str());
            continue;
        };
        let mut id = identity("t", &served.name, &point.name);
        while tags.contains_key(&id) {
            id.push('_');
        }
        let comment = served.comment(point);
        let gap = if comment.is_empty() { "" } else { ", " };
        tags.insert(
            id.clone(),
            json!({
                "id": id,
                "name": point.name,
                "type": ty,
                "memaddress": area(place.table),
                // FUXA counts from 1.
                "address": u32::from(place.number) + 1,
                "divisor": 1,
                "daq": { "enabled": false, "interval": 60, "changed": false, "restored": false },
                "description": format!("{}{gap}{comment}", both(place)),
            }),
        );
    }
    if !left_out.is_empty() {
        terminal::warning(&format_args!(
            "FUXA has no type for these tags: {}",
            left_out.join(", ")
        ));
    }
    json!([{
        "id": identity("d", &served.name, ""),
        "name": served.name,
        "enabled": true,
        "type": "ModbusTCP",
        "polling": POLLING,
        "property": {
            "address": served.address.to_string(),
            "slaveid": served.unit.to_string(),
            "connectionOption": "TcpPort",
            "delay": 10,
        },
        "tags": tags,
    }])
}

/// As FUXA's own look: `t_c2f080db-e81a4056`.
fn identity(kind: &str, program: &str, tag: &str) -> String {
    let [program, tag] = [program, tag].map(|name| crc32fast::hash(name.as_bytes()));
    format!("{kind}_{program:08x}-{tag:08x}")
}

fn area(table: Table) -> &'static str {
    match table {
        Table::Coil => "000000",
        Table::Discrete => "100000",
        Table::Input => "300000",
        Table::Holding => "400000",
    }
}

/// What FUXA calls a type; `MLE` has the low word first. None: it has none.
fn type_of(ty: Scalar, words: Words) -> Option<&'static str> {
    Some(match (ty, words) {
        (Scalar::Bool, _) => "Bool",
        (Scalar::Sint | Scalar::Int, _) => "Int16",
        (Scalar::Usint | Scalar::Byte | Scalar::Uint | Scalar::Word, _) => "UInt16",
        (Scalar::Dint | Scalar::Time, Words::Big) => "Int32",
        (Scalar::Dint | Scalar::Time, Words::Little) => "Int32MLE",
        (Scalar::Udint | Scalar::Dword, Words::Big) => "UInt32",
        (Scalar::Udint | Scalar::Dword, Words::Little) => "UInt32MLE",
        (Scalar::Real, Words::Big) => "Float32",
        (Scalar::Real, Words::Little) => "Float32MLE",
        (Scalar::Lreal, Words::Big) => "Float64",
        (Scalar::Lint, Words::Big) => "Int64",
        // It swaps the halves of 64 bits, and the words of each half stay as they are.
        _ => return None,
    })
}
