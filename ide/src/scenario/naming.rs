//! The names in a scenario file: those of its rows, the sides of its connections, and the operands of its properties and assumptions.

use super::row::within;
use crate::symbol::Usage;
use ladder_simulator::expression;
use ladder_simulator::scenario::{Direction, Form, Row, Suite, Written};
use ladder_syntax::TextRange;

/// A name, and where it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Naming<'s> {
    pub(crate) text: &'s str,
    pub(crate) range: TextRange,
    /// The row whose name it is; none of an operand or a connection.
    pub(crate) row: Option<&'s Row>,
}

impl Naming<'_> {
    /// What is done with what it names.
    pub(crate) fn usage(&self) -> Usage {
        match self.row.map(|row| row.direction) {
            Some(Direction::Given) => Usage::Write,
            Some(Direction::Expected) | None => Usage::Read,
        }
    }
}

/// All of them, in the order of the text.
pub(super) fn namings(suite: &Suite) -> Vec<Naming<'_>> {
    let rows = suite.scenarios.iter().flat_map(|scenario| &scenario.rows);
    let rows = rows.map(|row| Naming {
        text: &row.name,
        range: row.range,
        row: Some(row),
    });
    let sides = suite.connects.iter().flat_map(|connect| &connect.sides);
    let mut all: Vec<Naming<'_>> = rows
        .chain(sides.map(side))
        .chain(expressions(suite).into_iter().flat_map(operands))
        .collect();
    all.sort_by_key(|naming| naming.range.start());
    all
}

/// A side of a connection.
pub(super) fn side(side: &Written) -> Naming<'_> {
    Naming {
        text: &side.text,
        range: side.range,
        row: None,
    }
}

/// The expressions of assumptions and properties.
pub(super) fn expressions(suite: &Suite) -> Vec<&Written> {
    let mut found: Vec<&Written> = suite.assumptions.iter().collect();
    for property in &suite.properties {
        of_form(&property.form, &mut found);
    }
    found
}

fn of_form<'s>(form: &'s Form<Written>, found: &mut Vec<&'s Written>) {
    match form {
        Form::Always(e) | Form::Never(e) | Form::Possible { what: e, .. } => found.push(e),
        Form::When {
            condition,
            then,
            until,
        } => {
            found.extend([condition, then]);
            found.extend(until);
        }
        Form::After { condition, then } | Form::Within { condition, then, .. } => {
            found.extend([condition, then]);
        }
        Form::NoFaults => {}
    }
}

/// What an expression names.
pub(super) fn operands(written: &Written) -> Vec<Naming<'_>> {
    let names = expression::names(&written.text).into_iter();
    let naming = |name: std::ops::Range<usize>| {
        Some(Naming {
            text: written.text.get(name.clone())?,
            range: within(written.range, &name),
            row: None,
        })
    };
    names.filter_map(naming).collect()
}
