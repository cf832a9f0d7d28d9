//! The blocks of the standard, as it says.

use super::memory::{CellId, Memory};
use super::value::Value;

const TIMER: &[(&str, &str)] = &[
    ("IN", "BOOL"),
    ("PT", "TIME"),
    ("Q", "BOOL"),
    ("ET", "TIME"),
    ("#STATE", "INT"),
    ("#BEFORE", "BOOL"),
    ("#START", "TIME"),
];

/// The variables of a block; none: there is no such block.
pub(super) fn members(name: &str) -> Option<&'static [(&'static str, &'static str)]> {
    Some(match name {
        "TON" | "TOF" | "TP" => TIMER,
        "R_TRIG" | "F_TRIG" => &[("CLK", "BOOL"), ("Q", "BOOL"), ("#M", "BOOL")],
        "SR" => &[("S1", "BOOL"), ("R", "BOOL"), ("Q1", "BOOL")],
        "RS" => &[("S", "BOOL"), ("R1", "BOOL"), ("Q1", "BOOL")],
        _ => return None,
    })
}

/// Evaluates a block at an instant.
pub(super) fn evaluate(memory: &mut Memory, cell: CellId, name: &str, now: i64) -> Result<(), String> {
    let bit = |memory: &Memory, name: &str| match memory.get(memory.member(cell, name)?)? {
        Value::Bool(high) => Ok(high),
        other => Err(format!("{other:?} is no BOOL")),
    };
    let set = |memory: &mut Memory, name: &str, value: Value| memory.set(memory.member(cell, name)?, value);
    match name {
        "R_TRIG" | "F_TRIG" => {
            let (clock, before) = (bit(memory, "CLK")?, bit(memory, "#M")?);
            // IEC 61131-3: Q := CLK AND NOT M; M := CLK, and for falling edges Q := NOT CLK AND NOT M; M := NOT CLK.
            let clock = if name == "R_TRIG" { clock } else { !clock };
            set(memory, "Q", Value::Bool(clock && !before))?;
            set(memory, "#M", Value::Bool(clock))
        }
        "SR" => {
            let q = bit(memory, "S1")? || (!bit(memory, "R")? && bit(memory, "Q1")?);
            set(memory, "Q1", Value::Bool(q))
        }
        "RS" => {
            let q = !bit(memory, "R1")? && (bit(memory, "S")? || bit(memory, "Q1")?);
            set(memory, "Q1", Value::Bool(q))
        }
        _ => {
            let time = |memory: &Memory, name: &str| match memory.get(memory.member(cell, name)?)? {
                Value::Time(time) => Ok::<i64, String>(time),
                other => Err(format!("{other:?} is no TIME")),
            };
            let Value::Int(mut state, _) = memory.get(memory.member(cell, "#STATE")?)? else {
                return Err("a timer without a state".into());
            };
            let (input, before) = (bit(memory, "IN")?, bit(memory, "#BEFORE")?);
            let (pt, mut start, mut et) = (time(memory, "PT")?, time(memory, "#START")?, time(memory, "ET")?);
            let mut q = bit(memory, "Q")?;
            let starts = if name == "TOF" {
                before && !input
            } else {
                !before && input
            };
            let rests = match name {
                "TON" => !input,
                "TOF" => input,
                _ => false,
            };
            if state == 0 && starts {
                (state, start) = (1, now);
                q = name != "TON";
            } else if rests {
                (state, et) = (0, 0);
                q = name == "TOF";
            } else if state == 1 {
                if now - start >= pt {
                    (state, et) = (2, pt);
                    q = name == "TON";
                } else {
                    et = now - start;
                }
            }
            if name == "TP" && state == 2 && !input {
                (state, et) = (0, 0);
            }
            set(memory, "Q", Value::Bool(q))?;
            set(memory, "ET", Value::Time(et))?;
            set(memory, "#STATE", Value::Int(state, None))?;
            set(memory, "#START", Value::Time(start))?;
            set(memory, "#BEFORE", Value::Bool(input))
        }
    }
}
