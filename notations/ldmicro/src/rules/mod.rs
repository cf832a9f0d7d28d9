//! LDmicro's own design-rule checks.

mod fork;
mod texts;

use super::element::{self, Form};
use super::field::{self, Slot};
use super::fork::table::row_of as forks_row;
use super::model::{File, Leaf, Node, Version, leaves};
use super::tags::MOST_STAGES;
use ladder_analysis::Severity;
use ladder_instructions::Op;
use ladder_notation::{Finding, LineColumn};
use std::collections::{HashMap, HashSet};

/// All that LDmicro would complain about, whatever is first.
pub(super) fn findings(file: &File) -> Vec<Finding> {
    let mut out = Vec::new();
    let mut uses: HashMap<&str, Vec<(&Leaf, Form)>> = HashMap::new();
    for rung in &file.rungs {
        let all = leaves(&rung.parts);
        for leaf in &all {
            let Some(row) = element::row_of(&leaf.text) else {
                continue;
            };
            one(file, leaf, row.form, all.len(), &mut out);
            for name in variables(&leaf.text, row.form) {
                uses.entry(name).or_default().push((leaf, row.form));
            }
        }
        if all.is_empty() {
            let message = "Empty row; delete it or add instructions before compiling.";
            out.push(error(rung.line, "ldmicro-empty-row", message));
        }
        rightmost(&rung.parts, true, &mut out);
    }
    match file.version {
        Version::V01 => timer_names(&uses, &mut out),
        Version::V02 => fork::findings(file, &mut out),
    }
    unassigned(file, &uses, &mut out);
    out
}

/// What LDmicro says of a variable when it is first read.
fn unassigned(file: &File, uses: &HashMap<&str, Vec<(&Leaf, Form)>>, out: &mut Vec<Finding>) {
    let mut stages: HashSet<String> = HashSet::new();
    for leaf in file.rungs.iter().flat_map(|rung| leaves(&rung.parts)) {
        let fields = field::fields(&leaf.text);
        if let Some(Form::Shift) = element::row_of(&leaf.text).map(|row| row.form) {
            let count: u32 = fields[1].parse().unwrap_or(0);
            stages.extend((0..count.min(MOST_STAGES)).map(|stage| format!("{}{stage}", fields[0])));
        }
    }
    let mut changed: HashSet<&str> = HashSet::new();
    for leaf in file.rungs.iter().flat_map(|rung| leaves(&rung.parts)) {
        // Of an element that is not read it is not known which of its fields the controller changes.
        let count = match forks_row(&leaf.text) {
            Some(row) if row.is_outside() => usize::MAX,
            Some(_) => 1,
            None => 0,
        };
        changed.extend(field::fields(&leaf.text).into_iter().take(count));
    }
    for (name, uses) in uses {
        let assigns = |(leaf, form): &(&Leaf, Form)| {
            let is_first = field::fields(&leaf.text).first() == Some(name);
            match form {
                Form::Values(Op::Persist, _) => true,
                Form::Values(_, slots) => is_first && slots.first() == Some(&Slot::Place),
                Form::Table | Form::Curve => is_first,
                Form::Timer(_) | Form::Counter(_) | Form::Reset | Form::Adc => true,
                _ => false,
            }
        };
        if *name == "(none)" || stages.contains(*name) || changed.contains(name) || uses.iter().any(assigns) {
            continue;
        }
        let message = format!(
            "Variable '{name}' not assigned to, e.g. with a MOV statement, an ADD statement, etc. This is probably a \
             programming error; now it will always be zero."
        );
        let first = uses.iter().map(|(leaf, _)| leaf.line).min().unwrap_or(1);
        let mut found = error(first, "ldmicro-unassigned", message);
        found.severity = Severity::Warning;
        out.push(found);
    }
}

fn error(line: u32, check: &'static str, message: impl Into<String>) -> Finding {
    Finding {
        place: LineColumn::line(line),
        severity: Severity::Error,
        check,
        message: message.into(),
    }
}

/// The variables that an element names.
fn variables(text: &str, form: Form) -> Vec<&str> {
    let fields = field::fields(text);
    let count = match form {
        Form::Values(_, slots) => slots.len(),
        Form::Table | Form::Curve => 2,
        Form::Timer(_) | Form::Counter(_) | Form::Reset | Form::Adc | Form::Text => 1,
        _ => 0,
    };
    let named = fields.into_iter().take(count);
    named.filter(|field| !field::is_literal(field)).collect()
}

/// What is wrong with an element by itself.
fn one(file: &File, leaf: &Leaf, form: Form, in_rung: usize, out: &mut Vec<Finding>) {
    let fields = field::fields(&leaf.text);
    let line = leaf.line;
    match form {
        Form::Timer(_) => {
            let Some(delay) = element::preset(&fields, file.dialect()) else {
                return;
            };
            let periods = delay / file.cycle();
            let message = match periods {
                0 | 1 => "Timer period too short (needs faster cycle time).",
                2..=32_768 => return,
                _ => "Timer period too long (max 32767 times cycle time); use a slower cycle time.",
            };
            out.push(error(line, "ldmicro-period", message));
        }
        Form::Values(_, slots) => {
            for (field, slot) in fields.iter().zip(slots) {
                match slot {
                    Slot::Place if field::is_literal(field) => {
                        let message = format!("'{field}' not a valid destination.");
                        out.push(error(line, "ldmicro-destination", message));
                    }
                    Slot::Value => constant(line, field, out),
                    _ => {}
                }
            }
        }
        Form::Table | Form::Curve => {
            let values = element::values(&fields, form);
            for field in values {
                constant(line, field, out);
            }
            if form == Form::Curve {
                curve(line, values, out);
            }
        }
        Form::Contact if !fields[0].starts_with(['X', 'Y', 'R']) => {
            let message = format!(
                "the contact '{}' is not an input (X), output (Y) or relay (R)",
                fields[0]
            );
            out.push(error(line, "ldmicro-contact-name", message));
        }
        Form::Comment if in_rung > 1 => {
            let message = "a comment must be alone in its rung";
            out.push(error(line, "ldmicro-comment", message));
        }
        Form::Text => texts::findings(leaf, out),
        Form::Placeholder => {
            let message = "Empty row; delete it or add instructions before compiling.";
            out.push(error(line, "ldmicro-empty-row", message));
        }
        _ => {}
    }
}

fn constant(line: u32, field: &str, out: &mut Vec<Finding>) {
    if !field::is_literal(field) {
        return;
    }
    if let Some(value) = field::literal(field).filter(|value| field::wrapped(*value) != *value) {
        let message = format!("Constant {value} out of range: -32768 to 32767 inclusive.");
        let mut found = error(line, "ldmicro-constant", message);
        found.severity = Severity::Warning;
        out.push(found);
    }
}

fn curve(line: u32, fields: &[&str], out: &mut Vec<Finding>) {
    let points = element::numbers(fields).unwrap_or_default();
    let points: Vec<(i64, i64)> = points.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
    let mut complain = |message: &str| out.push(error(line, "ldmicro-curve", message));
    if points.is_empty() {
        complain("Piecewise linear lookup table with zero elements!");
    }
    if points.windows(2).any(|pair| pair[1].0 <= pair[0].0) {
        complain("x values in piecewise linear table must be strictly increasing.");
    }
    let is_steep = |pair: &[(i64, i64)]| ((pair[1].0 - pair[0].0) * (pair[1].1 - pair[0].1)).abs() > 32_767;
    if points.windows(2).any(is_steep) {
        complain(
            "a segment of the piecewise linear table is too large for 16 bits; add points between its ends",
        );
    }
}

/// A timer's variable belongs to the timer alone, but for RES.
fn timer_names(uses: &HashMap<&str, Vec<(&Leaf, Form)>>, out: &mut Vec<Finding>) {
    for (name, uses) in uses {
        let resets = uses.iter().filter(|(_, form)| *form == Form::Reset).count();
        for (leaf, form) in uses {
            let Form::Timer(op) = *form else { continue };
            let allowed = if op == Op::Rto { resets } else { 0 };
            if uses.len() == 1 + allowed {
                continue;
            }
            let word = leaf.text.split(' ').next().unwrap_or_default();
            let rest = match op {
                Op::Rto => "variable can only be used for RES elsewhere",
                _ => "variable cannot be used elsewhere",
            };
            let message = format!("Variable for '{name}' incorrectly assigned: {word}: {rest}.");
            let mut found = error(leaf.line, "ldmicro-timer-name", message);
            found.severity = Severity::Warning;
            out.push(found);
        }
    }
}

/// Whether nothing is to the right of what ends a rung.
fn rightmost(parts: &[Node], at_rail: bool, out: &mut Vec<Finding>) {
    for (index, part) in parts.iter().enumerate() {
        let last = at_rail && index + 1 == parts.len();
        match part {
            Node::Leaf(leaf) => {
                let ends = element::row_of(&leaf.text).is_some_and(|row| row.ends_rung);
                if ends && !last {
                    let word = leaf.text.split(' ').next().unwrap_or_default();
                    let message = format!("{word} must be the rightmost element of its rung");
                    let mut found = error(leaf.line, "ldmicro-rightmost", message);
                    found.severity = Severity::Warning;
                    out.push(found);
                }
            }
            Node::Series(parts) => rightmost(parts, last, out),
            Node::Parallel(branches) => {
                for branch in branches {
                    rightmost(std::slice::from_ref(branch), last, out);
                }
            }
        }
    }
}
