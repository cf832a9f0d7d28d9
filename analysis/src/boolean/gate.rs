//! What blocks make of power: gates that ask for the values of variables.

use super::value_space::Regions;

/// Something whose value decides about power.
#[derive(Debug, Clone)]
pub(crate) enum Variable {
    /// A BOOL tag, bit or element, as it is written.
    Bool(String),
    /// `SYS.ON` or `SYS.OFF`: its value.
    Fixed(bool),
    /// A number that is compared with numbers: the stretches that these cut its values into.
    Number(String, Regions),
    /// Two values that are compared: less, equal, greater.
    Pair(String, String),
    /// What nobody can name: the memory of an edge, the output of a timer, the rail after an `<MCR>`.
    Unknown,
}

/// A condition: the variable, and for which of its values (a bit each) it conducts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Ask {
    pub(crate) variable: usize,
    pub(crate) mask: u64,
}

/// What a block makes of the power that enters it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Gate {
    /// It passes it on.
    Pass,
    /// It passes it on if all conditions hold.
    If(Vec<Ask>),
    /// `[NOT]`
    Inverter,
    /// It gives power if none enters it and the condition holds.
    IfNot(Ask),
    /// It gives power by itself.
    Gives(Ask),
    /// A coil.
    Coil(CoilKind, Option<usize>),
}

/// What a coil writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CoilKind {
    Power,
    Negated,
    Set,
    Reset,
}

/// A network's blocks as gates.
#[derive(Debug)]
pub(crate) struct Gates {
    pub(crate) variables: Vec<Variable>,
    /// One for each block of the network.
    pub(crate) of_block: Vec<Gate>,
    /// A condition asks for a value that a block of the network has written, and that cannot be computed here.
    pub(crate) reads_unknown_write: bool,
    /// Not every combination of values can occur: something holds for all combinations is still true, that one
    /// combination shows something is not.
    pub(crate) some_impossible: bool,
}

impl Variable {
    /// How many values it has.
    pub(crate) fn size(&self) -> usize {
        match self {
            Variable::Bool(_) | Variable::Fixed(_) | Variable::Unknown => 2,
            Variable::Number(_, regions) => regions.count(),
            Variable::Pair(..) => 3,
        }
    }

    /// That it has one of its values, as a person says it; none if it has no name.
    pub(crate) fn says(&self, value: usize) -> Option<String> {
        Some(match self {
            Variable::Bool(name) => format!("{name} = {value}"),
            Variable::Number(name, regions) => regions.says(name, value),
            Variable::Pair(left, right) => format!("{left} {} {right}", ["<", "=", ">"][value]),
            Variable::Fixed(_) | Variable::Unknown => return None,
        })
    }
}
