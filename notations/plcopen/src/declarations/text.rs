//! Declarations as texts, as systems of IEC 61131-3 have them.

use crate::model::{Initial, Role, Type, TypeDeclaration, Unit, UnitKind, Variable};
use ladder_format::program::Qualifier;
use std::fmt::Write as _;

/// The declaration of a unit.
pub fn unit(unit: &Unit) -> String {
    let mut out = String::new();
    said_above(&mut out, unit.comment.as_deref());
    let kind = match unit.kind {
        UnitKind::Program => "PROGRAM",
        UnitKind::Function => "FUNCTION",
        UnitKind::FunctionBlock => "FUNCTION_BLOCK",
    };
    out.push_str(&format!("{kind} {}", unit.name));
    if let Some(returns) = &unit.returns {
        out.push_str(&format!(" : {}", ty(returns)));
    }
    out.push('\n');
    sections(&mut out, &unit.variables);
    out
}

/// The declaration of globals.
pub fn globals(variables: &[Variable]) -> String {
    let mut out = String::new();
    sections(&mut out, variables);
    out
}

/// The declaration of a type.
pub fn data_type(declared: &TypeDeclaration) -> String {
    let mut out = String::new();
    said_above(&mut out, declared.comment.as_deref());
    out.push_str(&format!("TYPE {} :", declared.name));
    match &declared.ty {
        Type::Structure(members) => {
            out.push_str("\nSTRUCT\n");
            for member in members {
                variable(&mut out, member);
            }
            out.push_str("END_STRUCT");
        }
        Type::Enumeration(values) => {
            let values = values.iter().map(|(name, number)| match number {
                Some(number) => format!("{name} := {number}"),
                None => name.clone(),
            });
            let values: Vec<String> = values.collect();
            out.push_str(&format!(" ({})", values.join(", ")));
        }
        other => out.push_str(&format!(" {}", ty(other))),
    }
    let is_structure = matches!(declared.ty, Type::Structure(_));
    if let Some(value) = declared.initial.as_ref().filter(|_| !is_structure) {
        out.push_str(&format!(" := {}", initial(value)));
    }
    out.push_str(if is_structure {
        "\nEND_TYPE\n"
    } else {
        ";\nEND_TYPE\n"
    });
    out
}

/// Variables, those of one kind that stand next to each other in one section.
fn sections(out: &mut String, variables: &[Variable]) {
    for list in variables.chunk_by(|one, other| (one.role, one.qualifier) == (other.role, other.qualifier)) {
        out.push_str(match list[0].role {
            Role::Local => "VAR",
            Role::Temp => "VAR_TEMP",
            Role::Input => "VAR_INPUT",
            Role::Output => "VAR_OUTPUT",
            Role::InOut => "VAR_IN_OUT",
            Role::External => "VAR_EXTERNAL",
            Role::Global => "VAR_GLOBAL",
        });
        out.push_str(match list[0].qualifier {
            None => "\n",
            Some(Qualifier::Constant) => " CONSTANT\n",
            Some(Qualifier::Retain) => " RETAIN\n",
        });
        for it in list {
            variable(out, it);
        }
        out.push_str("END_VAR\n");
    }
}

fn variable(out: &mut String, variable: &Variable) {
    out.push_str(&format!("\t{}", variable.name));
    if let Some(address) = &variable.address {
        out.push_str(&format!(" AT {address}"));
    }
    out.push_str(&format!(" : {}", ty(&variable.ty)));
    if let Some(value) = &variable.initial {
        out.push_str(&format!(" := {}", initial(value)));
    }
    out.push(';');
    if let Some(told) = &variable.comment {
        let words: Vec<&str> = told.split_whitespace().collect();
        out.push_str(&format!(" // {}", words.join(" ")));
    }
    out.push('\n');
}

fn said_above(out: &mut String, told: Option<&str>) {
    for line in told.iter().flat_map(|told| told.lines()) {
        out.push_str(&format!("// {line}\n"));
    }
}

fn ty(of: &Type) -> String {
    match of {
        Type::Named(name) | Type::Other(name) => name.clone(),
        Type::Text(None) => "STRING".to_owned(),
        Type::Text(Some(length)) => format!("STRING({length})"),
        Type::Array(bounds, element) => {
            let bounds: Vec<String> = bounds
                .iter()
                .map(|(low, high)| format!("{low}..{high}"))
                .collect();
            format!("ARRAY[{}] OF {}", bounds.join(", "), ty(element))
        }
        Type::Range(base, low, high) => format!("{base}({low}..{high})"),
        // They are declared with a name.
        Type::Enumeration(_) | Type::Structure(_) => String::new(),
    }
}

fn initial(value: &Initial) -> String {
    match value {
        Initial::Simple(text) => text.clone(),
        Initial::Array(values) => {
            let mut out = String::from("[");
            for (number, (times, value)) in values.iter().enumerate() {
                out.push_str(if number == 0 { "" } else { ", " });
                let value = initial(value);
                let done = match times {
                    1 => write!(out, "{value}"),
                    times => write!(out, "{times}({value})"),
                };
                debug_assert!(done.is_ok());
            }
            out + "]"
        }
        Initial::Structure(values) => {
            let values: Vec<String> = values
                .iter()
                .map(|(name, value)| format!("{name} := {}", initial(value)))
                .collect();
            format!("({})", values.join(", "))
        }
    }
}
