//! What the fork checks beyond LDmicro 2.2: names that belong to one element, jumps and their labels, indices.

use super::super::model::{File, Leaf, leaves};
use super::error;
use crate::field;
use ladder_analysis::Severity;
use ladder_notation::Finding;
use std::collections::{HashMap, HashSet};

/// What a name is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Use {
    Timer,
    Counter,
    Pulses,
    Table,
    Reset,
    Other,
}

/// All of it.
pub(super) fn findings(file: &File, out: &mut Vec<Finding>) {
    let mut uses: HashMap<&str, Vec<(&Leaf, Use)>> = HashMap::new();
    let all: Vec<&Leaf> = file.rungs.iter().flat_map(|rung| leaves(&rung.parts)).collect();
    for leaf in &all {
        for (name, what) in names(&leaf.text) {
            uses.entry(name).or_default().push((leaf, what));
        }
        numbers(leaf, out);
    }
    for (name, uses) in &uses {
        let others = uses.iter().filter(|(_, what)| *what != Use::Reset).count();
        let kinds: HashSet<Use> = uses.iter().map(|(_, what)| *what).collect();
        let is_state = [Use::Timer, Use::Counter, Use::Pulses]
            .iter()
            .any(|kind| kinds.contains(kind));
        for (leaf, what) in uses {
            let word = leaf.text.split(' ').next().unwrap_or_default();
            let what_is_wrong = match what {
                Use::Timer | Use::Pulses if others > 1 => {
                    format!("{word}: variable can only be used for RES elsewhere.")
                }
                Use::Table if kinds.len() > 1 => {
                    "TABLE: the name of a table can only be used for tables elsewhere.".to_owned()
                }
                Use::Reset if !is_state => {
                    "RES: Variable is not assigned to COUNTER or TIMER or PWM.".to_owned()
                }
                _ => continue,
            };
            let message = format!("Variable for '{name}' incorrectly assigned: {what_is_wrong}");
            let mut found = error(leaf.line, "ldmicro-name", message);
            found.severity = Severity::Warning;
            out.push(found);
        }
    }
    jumps(file, &all, out);
}

/// The variables that an element names, and for what. Bits are names of their own.
fn names(text: &str) -> Vec<(&str, Use)> {
    let word = text.split(' ').next().unwrap_or_default();
    let fields = field::fields(text);
    let first = match word {
        "CONTACTS" | "COIL" | "COMMENT" | "GOTO" | "GOSUB" | "LABEL" | "SUBPROG" | "ENDSUB" => {
            return Vec::new();
        }
        "TON" | "TOF" | "RTO" | "RTL" | "TCY" | "THI" | "TLO" => Use::Timer,
        "CTU" | "CTD" | "CTC" | "CTR" => Use::Counter,
        "RES" => Use::Reset,
        "STRING" | "FORMATTED_STRING" => {
            return fields
                .first()
                .filter(|name| **name != "(none)")
                .map(|name| (*name, Use::Other))
                .into_iter()
                .collect();
        }
        _ => Use::Other,
    };
    let table = matches!(word, "LOOK_UP_TABLE" | "PIECEWISE_LINEAR");
    fields
        .iter()
        .enumerate()
        .filter(|(_, field)| field.starts_with(|c: char| c.is_alphabetic() || c == '_'))
        .map(|(index, field)| {
            let what = match index {
                0 => first,
                2 if word == "SET_PWM" => Use::Pulses,
                2.. if table => Use::Table,
                _ => Use::Other,
            };
            (*field, what)
        })
        .collect()
}

/// Literals that the element cannot do anything with.
fn numbers(leaf: &Leaf, out: &mut Vec<Finding>) {
    let fields = field::fields(&leaf.text);
    let field = |index: usize| fields.get(index).copied().unwrap_or_default();
    let message = match leaf.text.split(' ').next().unwrap_or_default() {
        "LOOK_UP_TABLE" => {
            let (index, count) = (field::literal(field(1)), field::literal(field(2)));
            match (index, count) {
                (Some(index), Some(count)) if !(0..count).contains(&index) => {
                    format!("index {index} is outside the table, which has {count} values, from 0 on")
                }
                _ => return,
            }
        }
        "BCD2BIN" => match field::literal(field(1)) {
            Some(number)
                if number
                    .unsigned_abs()
                    .to_le_bytes()
                    .iter()
                    .any(|digit| digit & 0xF > 9) =>
            {
                format!(
                    "{} is not a number in BCD: each of its bytes is a digit from 0 to 9",
                    field(1)
                )
            }
            _ => return,
        },
        _ => return,
    };
    out.push(error(leaf.line, "ldmicro-index", message));
}

/// Labels and subprograms: each there once, each jump with somewhere to go.
fn jumps(file: &File, all: &[&Leaf], out: &mut Vec<Finding>) {
    let mut there: HashMap<(&str, &str), u32> = HashMap::new();
    let mut complain = |line: u32, message: String| out.push(error(line, "ldmicro-jump", message));
    for leaf in all {
        let Some((word @ ("LABEL" | "SUBPROG" | "ENDSUB"), name)) = leaf.text.split_once(' ') else {
            continue;
        };
        if let Some(line) = there.insert((word, name), leaf.line) {
            complain(
                leaf.line,
                format!("{word} '{name}' is there already, on line {line}"),
            );
        }
    }
    let has = |word: &str, name: &str| there.contains_key(&(word, name));
    for leaf in all {
        let Some((word, name)) = leaf.text.split_once(' ') else {
            continue;
        };
        // A number after the last rung leads to the end.
        let rung = name.parse::<usize>().is_ok_and(|rung| rung > 0);
        let missing = match word {
            "GOTO" if !has("LABEL", name) && !rung => "LABEL",
            "GOSUB" if !has("SUBPROG", name) && !has("LABEL", name) && !rung => "SUBPROG",
            "SUBPROG" if !has("ENDSUB", name) => "ENDSUB",
            "ENDSUB" if !has("SUBPROG", name) => "SUBPROG",
            _ => continue,
        };
        complain(
            leaf.line,
            format!("{word} '{name}': there is no {missing} '{name}'"),
        );
    }
    for rung in &file.rungs {
        let inside = leaves(&rung.parts);
        let is_border = |leaf: &&&Leaf| leaf.text.starts_with("SUBPROG ") || leaf.text.starts_with("ENDSUB ");
        if let Some(leaf) = inside.iter().find(is_border).filter(|_| inside.len() > 1) {
            let word = leaf.text.split(' ').next().unwrap_or_default();
            complain(leaf.line, format!("{word} must be alone in its rung"));
        }
    }
}
