//! What names mean where a body is: tags with their types, types, blocks and functions.

use ladder_analysis::values::types::{DEFAULT_STRING, Scalar};
use ladder_format::program::Path;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// The type of a tag.
#[derive(Debug, Clone, PartialEq)]
pub enum Type {
    /// One value.
    Scalar(Scalar),
    /// A timer, counter or bistable, by its mnemonic here.
    Standard(&'static str),
    /// An edge detector: R_TRIG, or F_TRIG. Here it is a BOOL that holds its output.
    Trigger(Edge),
    /// The instance of a block.
    Block(Rc<Shape>),
    /// One of some names.
    Enumeration(Rc<Enumeration>),
    /// Members.
    Structure(Rc<Structure>),
    /// Elements; the bounds of each dimension as they are written.
    Array(Vec<(String, String)>, Box<Type>),
    /// What is not known here.
    Unknown,
}

/// Which edge is detected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// R_TRIG
    Rising,
    /// F_TRIG
    Falling,
}

/// An enumeration.
#[derive(Debug, PartialEq)]
pub struct Enumeration {
    /// Its name here.
    pub name: String,
    /// Its values.
    pub values: Vec<String>,
}

/// A structure.
#[derive(Debug, PartialEq)]
pub struct Structure {
    /// Its name here.
    pub name: String,
    /// Its members: as they are called there, as they are called here, and what they are.
    pub members: Vec<(String, String, Type)>,
}

/// What a block or function is called with.
#[derive(Debug, PartialEq)]
pub struct Shape {
    /// Its name here, without `$`.
    pub name: String,
    /// In the order of their declaration.
    pub parameters: Vec<Parameter>,
    /// What a function returns, and the output that holds it.
    pub returns: Option<(String, Type)>,
}

/// An input, output or in-out.
#[derive(Debug, PartialEq)]
pub struct Parameter {
    /// As the other system calls it.
    pub name: String,
    /// As it is called here.
    pub spelled: String,
    /// Which way it goes.
    pub role: ParameterRole,
    /// What it takes.
    pub ty: Type,
    /// A call may leave it out.
    pub has_default: bool,
}

/// Which way a parameter goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParameterRole {
    /// Into the block.
    Input,
    /// Out of the block.
    Output,
    /// Both ways.
    InOut,
}

/// A tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// What it is called here.
    pub path: Path,
    /// Its type.
    pub ty: Type,
    /// Whether it is never written.
    pub is_constant: bool,
}

/// What names mean. Names are compared without case.
#[derive(Debug, Default, Clone)]
pub struct Scope {
    tags: HashMap<String, Known>,
    types: HashMap<String, Type>,
    functions: HashMap<String, Rc<Shape>>,
    /// The steps of a chart: what says whether each is active, and for how long.
    steps: HashMap<String, (Path, Path)>,
    /// The tags that other units see, too.
    of_all: HashSet<String>,
}

impl Scope {
    /// What is declared from here on is a unit's own.
    pub fn begin_unit(&mut self) {
        self.of_all = self.tags.keys().cloned().collect();
    }

    /// Whether a tag is a unit's own.
    pub(super) fn is_of_unit(&self, name: &str) -> bool {
        !self.of_all.contains(&name.to_lowercase())
    }

    /// A tag, by the name that the other system has for it.
    pub fn tag(&mut self, name: &str, path: Path, ty: Type, is_constant: bool) {
        let known = Known {
            path,
            ty,
            is_constant,
        };
        let key = name.to_lowercase();
        self.of_all.remove(&key);
        self.tags.insert(key, known);
    }

    /// A type, a block or an enumeration, by the name that the other system has for it.
    pub fn data_type(&mut self, name: &str, ty: Type) {
        let key = name.to_lowercase();
        self.functions.remove(&key);
        self.types.insert(key, ty);
    }

    /// A function.
    pub fn function(&mut self, name: &str, shape: Rc<Shape>) {
        let key = name.to_lowercase();
        self.types.remove(&key);
        self.functions.insert(key, shape);
    }

    /// A step of a chart: the tags that `name.X` and `name.T` are.
    pub fn step(&mut self, name: &str, active: Path, elapsed: Path) {
        self.steps.insert(name.to_lowercase(), (active, elapsed));
    }

    /// A member of a step.
    pub(super) fn of_step(&self, name: &str, member: &str) -> Option<(Path, Type)> {
        let (active, elapsed) = self.steps.get(&name.to_lowercase())?;
        match member {
            "X" | "x" => Some((active.clone(), Type::BOOL)),
            "T" | "t" => Some((elapsed.clone(), Type::Scalar(Scalar::Time))),
            _ => None,
        }
    }

    pub(super) fn known(&self, name: &str) -> Option<&Known> {
        self.tags.get(&name.to_lowercase())
    }

    pub(super) fn function_named(&self, name: &str) -> Option<&Rc<Shape>> {
        self.functions.get(&name.to_lowercase())
    }

    /// The type of a name: elementary, standard, or declared.
    pub(super) fn type_named(&self, name: &str) -> Option<Type> {
        if let Some(declared) = self.types.get(&name.to_lowercase()) {
            return Some(declared.clone());
        }
        if let Some(scalar) = elementary(name) {
            return Some(Type::Scalar(scalar));
        }
        standard(name)
    }

    /// Whether a block or function has a name here, without `$`.
    pub(super) fn has_block(&self, name: &str) -> bool {
        let is_it = |shape: &Shape| shape.name.eq_ignore_ascii_case(name);
        let is_type = |ty: &Type| matches!(ty, Type::Block(shape) if is_it(shape));
        self.functions.values().any(|shape| is_it(shape)) || self.types.values().any(is_type)
    }

    /// The value of an enumeration that is named without it.
    pub(super) fn value(&self, name: &str) -> Option<(Path, Type)> {
        let mut found = self.types.values().filter_map(|ty| {
            let Type::Enumeration(all) = ty else { return None };
            let value = all.values.iter().find(|value| value.eq_ignore_ascii_case(name))?;
            Some((Path::tag(all.name.clone()).member(value.clone()), ty.clone()))
        });
        let one = found.next()?;
        // Two enumerations that both have it leave open which is meant.
        found.next().is_none().then_some(one)
    }
}

impl Type {
    pub(super) const BOOL: Type = Type::Scalar(Scalar::Bool);

    pub(super) fn scalar(&self) -> Option<Scalar> {
        match self {
            Type::Scalar(scalar) => Some(*scalar),
            Type::Trigger(_) => Some(Scalar::Bool),
            _ => None,
        }
    }

    /// As it is written in a declaration. None: it is not known.
    pub fn text(&self) -> Option<String> {
        Some(match self {
            Type::Scalar(scalar) => scalar.to_string(),
            Type::Standard(mnemonic) => (*mnemonic).to_owned(),
            Type::Trigger(_) => "BOOL".to_owned(),
            Type::Block(shape) => format!("${}", shape.name),
            Type::Enumeration(all) => all.name.clone(),
            Type::Structure(all) => all.name.clone(),
            Type::Array(bounds, of) => {
                let bounds = bounds.iter().map(|(first, last)| format!("{first}..{last}"));
                format!(
                    "ARRAY[{}] OF {}",
                    bounds.collect::<Vec<_>>().join(", "),
                    of.text()?
                )
            }
            Type::Unknown => return None,
        })
    }

    /// Whether it holds the state of a block.
    pub(super) fn keeps_state(&self) -> bool {
        match self {
            Type::Standard(_) | Type::Block(_) => true,
            Type::Array(_, of) => of.keeps_state(),
            Type::Structure(all) => all.members.iter().any(|(.., ty)| ty.keeps_state()),
            _ => false,
        }
    }

    /// The member of a name, as it is called here, and its type.
    pub(super) fn member(&self, name: &str) -> Option<(String, Type)> {
        let is = |own: &str| own.eq_ignore_ascii_case(name);
        match self {
            Type::Structure(all) => {
                let found = all.members.iter().find(|(own, ..)| is(own));
                found.map(|(_, spelled, ty)| (spelled.clone(), ty.clone()))
            }
            Type::Block(shape) => {
                let found = shape
                    .parameters
                    .iter()
                    .find(|own| is(&own.name) && own.role != ParameterRole::InOut);
                found.map(|own| (own.spelled.clone(), own.ty.clone()))
            }
            Type::Standard(mnemonic) => standard_member(mnemonic, name),
            _ => None,
        }
    }
}

/// The elementary type of a name.
pub(super) fn elementary(name: &str) -> Option<Scalar> {
    let upper = name.to_ascii_uppercase();
    Some(match upper.as_str() {
        "LTIME" => Scalar::Time,
        "LTOD" | "LTIME_OF_DAY" => Scalar::Tod,
        "LDT" | "LDATE_AND_TIME" => Scalar::Dt,
        "LDATE" => Scalar::Date,
        "BIT" => Scalar::Bool,
        "STRING" => Scalar::String(DEFAULT_STRING),
        other => Scalar::from_name(other)?,
    })
}

/// The standard block of a name: `CTU_DINT` is a CTU, and TIA's `TON_TIME` a TON.
fn standard(name: &str) -> Option<Type> {
    let upper = name.to_ascii_uppercase();
    let upper = upper.strip_prefix("IEC_").unwrap_or(&upper);
    let base = match upper.split_once('_') {
        Some((base, "INT" | "DINT" | "LINT" | "UINT" | "UDINT" | "ULINT" | "TIME" | "LTIME")) => base,
        _ => upper,
    };
    let known = ["TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS"];
    if let Some(mnemonic) = known.iter().find(|own| **own == base) {
        return Some(Type::Standard(mnemonic));
    }
    match base {
        "R_TRIG" => Some(Type::Trigger(Edge::Rising)),
        "F_TRIG" => Some(Type::Trigger(Edge::Falling)),
        _ => None,
    }
}

/// The member of a timer, counter or bistable, as it is called here.
fn standard_member(mnemonic: &str, name: &str) -> Option<(String, Type)> {
    let upper = name.to_ascii_uppercase();
    let (member, ty) = match (mnemonic, upper.as_str()) {
        ("TON" | "TOF" | "TP" | "RTO", "IN" | "Q") | ("RTO", "R") => (upper.as_str(), Scalar::Bool),
        ("TON" | "TOF" | "TP" | "RTO", "PT" | "ET") => (upper.as_str(), Scalar::Time),
        ("CTU" | "CTD", "Q") | ("CTUD", "QU" | "QD") => (upper.as_str(), Scalar::Bool),
        ("CTU" | "CTUD", "CU" | "R") | ("CTD" | "CTUD", "CD" | "LD") => (upper.as_str(), Scalar::Bool),
        ("CTUD" | "CTD", "LOAD") => ("LD", Scalar::Bool),
        ("CTU" | "CTUD", "RESET") => ("R", Scalar::Bool),
        ("CTU" | "CTD" | "CTUD", "CV" | "PV") => (upper.as_str(), Scalar::Dint),
        ("SR" | "RS", "Q1") => ("Q1", Scalar::Bool),
        _ => return None,
    };
    Some((member.to_owned(), Type::Scalar(ty)))
}
