//! What is asked of a controller: whole tags, each once, and where in them the wanted values are.

use super::path::{Path, Piece, is_of_program};
use super::values::{fits, width};
use ciplink::logix::{driver::Definitions, types};
use ciplink::types::Elementary;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::online::{Found, Wanted};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use types::{DataType, TagDef, TypeRef};

/// Whole tags with more values than this are not read. Of the others only the wanted values are, each by its name.
const MOST_VALUES: u64 = 200_000;
/// The driver reads no more elements of an array of several dimensions at once.
const MOST_ELEMENTS: u64 = 65_535;

/// One thing that is read.
#[derive(Debug)]
pub(super) struct Ask {
    /// As the driver takes it: `pump`, `line[2]{3}`.
    pub(super) request: String,
    pub(super) parts: Vec<Part>,
    /// It is one wanted value, and nothing around it.
    pub(super) is_single: bool,
}

/// A wanted value in an answer.
#[derive(Debug)]
pub(super) struct Part {
    /// Which one of the wanted values it is.
    pub(super) wanted: usize,
    /// From the answer to it.
    pub(super) steps: Vec<Step>,
    /// The same as a name.
    path: String,
}

/// From a value into it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// A member, by the name that the controller has for it.
    Member(String),
    /// An element, by its number; of several dimensions row by row.
    Element(usize),
    /// A bit of a number.
    Bit(u32),
}

impl Ask {
    /// The same, each value by its own name: for a controller that refuses the whole.
    pub(super) fn singles(self) -> impl Iterator<Item = Ask> {
        (self.parts.into_iter()).map(|part| Ask::single(part.path, part.wanted))
    }

    fn single(path: String, wanted: usize) -> Ask {
        Ask {
            request: path.clone(),
            parts: vec![Part {
                wanted,
                steps: Vec::new(),
                path,
            }],
            is_single: true,
        }
    }
}

/// What the controller has of each wanted value, and what is asked of it. A name without a program is one of the given program if
/// that has it, else one of the controller.
pub(super) fn plan(
    definitions: &Definitions,
    program: Option<&str>,
    wanted: &[Wanted],
) -> (Vec<Found>, Vec<Ask>) {
    let mut tags = HashMap::with_capacity(definitions.tags.len());
    for tag in definitions.tags.values() {
        tags.insert(tag.tag_name.to_lowercase(), tag);
    }
    let mut weights = HashMap::new();
    let mut asks = Vec::new();
    let mut whole: BTreeMap<&str, (&TagDef, Vec<Part>)> = BTreeMap::new();
    let mut found = Vec::with_capacity(wanted.len());
    for (index, Wanted { point, name }) in wanted.iter().enumerate() {
        let place = find(&tags, program, name);
        found.push(match place {
            Err(missing) => missing,
            Ok(place) if !place.is_of(point.ty) => Found::OtherType(place.type_name()),
            Ok(place) => {
                let mut part = Part {
                    wanted: index,
                    steps: place.steps,
                    path: place.path,
                };
                if place.is_hidden || part.steps.is_empty() {
                    asks.push(Ask::single(std::mem::take(&mut part.path), index));
                } else {
                    let (_, parts) = whole
                        .entry(place.tag.tag_name.as_str())
                        .or_insert((place.tag, Vec::new()));
                    parts.push(part);
                }
                Found::Here
            }
        });
    }
    let mut left = MOST_VALUES;
    for (name, (tag, mut parts)) in whole {
        let (request, elements) = stretch(name, tag, &mut parts);
        let weight = elements.saturating_mul(weight(&tag.data_type, &mut weights));
        let ask = Ask {
            request,
            parts,
            is_single: false,
        };
        let is_too_large = tag.dim > 1 && elements > MOST_ELEMENTS;
        match left.checked_sub(weight).filter(|_| !is_too_large) {
            Some(rest) => {
                left = rest;
                asks.push(ask);
            }
            None => asks.extend(ask.singles()),
        }
    }
    (found, asks)
}

/// What to read of a tag, and how many elements that is: of an array from the first wanted element to the last.
fn stretch(name: &str, tag: &TagDef, parts: &mut [Part]) -> (String, u64) {
    if tag.dim == 0 {
        return (name.to_owned(), 1);
    }
    let elements = |part: &Part| match part.steps.first() {
        Some(Step::Element(element)) => *element,
        _ => 0,
    };
    let (mut first, mut last) = (0, size(tag).saturating_sub(1));
    if tag.dim == 1 {
        last = parts.iter().map(elements).max().unwrap_or(0);
        first = parts.iter().map(elements).min().unwrap_or(0);
        if is_bools(&tag.data_type) {
            // They come as words.
            first -= first % 32;
        }
    }
    let count = last - first + 1;
    for part in parts {
        if count == 1 {
            // A single element comes without an array around it.
            part.steps.remove(0);
        } else if let Some(Step::Element(element)) = part.steps.first_mut() {
            *element -= first;
        }
    }
    let request = match tag.dim {
        1 => format!("{name}[{first}]{{{count}}}"),
        _ => format!("{name}{{{count}}}"),
    };
    (request, count as u64)
}

/// How many elements an array has.
fn size(tag: &TagDef) -> usize {
    let dimensions = &tag.dimensions[..usize::from(tag.dim).min(tag.dimensions.len())];
    dimensions
        .iter()
        .fold(1, |size: usize, length| size.saturating_mul(*length as usize))
}

/// Logix keeps an array of BOOL in words.
fn is_bools(ty: &TypeRef) -> bool {
    matches!(ty, TypeRef::Atomic(Some(Elementary::DWord)))
}

/// How many values a value of a type is in all, those of its structures included: few bytes can stand for many.
fn weight(ty: &TypeRef, known: &mut HashMap<*const DataType, u64>) -> u64 {
    let TypeRef::Struct(structure) = ty else {
        return 1;
    };
    if let Some(weight) = known.get(&Arc::as_ptr(structure)) {
        return *weight;
    }
    let mut sum = 1_u64.saturating_add(u64::from(structure.string.unwrap_or(0)));
    for member in structure.internal_tags.values() {
        let count = u64::from(member.array.unwrap_or(0).max(1));
        let bits = if is_bools(&member.data_type) { 32 } else { 1 };
        let one = weight(&member.data_type, known).saturating_mul(bits);
        sum = sum.saturating_add(count.saturating_mul(one));
    }
    known.insert(Arc::as_ptr(structure), sum);
    sum
}

/// Where a wanted value is.
struct Place<'t> {
    tag: &'t TagDef,
    steps: Vec<Step>,
    path: String,
    ty: &'t TypeRef,
    /// It is a number of that type, and the value is a bit of it; or it is a BOOL of an array.
    is_bit: bool,
    /// It is an array as a whole.
    is_array: bool,
    /// A whole structure comes without it.
    is_hidden: bool,
}

impl Place<'_> {
    fn is_of(&self, wanted: Scalar) -> bool {
        match self.ty {
            _ if self.is_array => false,
            _ if self.is_bit => wanted == Scalar::Bool,
            TypeRef::Atomic(Some(elementary)) => fits(wanted, *elementary),
            TypeRef::Atomic(None) => false,
            TypeRef::Struct(structure) => wanted.is_string() && structure.string.is_some(),
        }
    }

    fn type_name(&self) -> String {
        let name = match self.ty {
            _ if self.is_bit => "BOOL",
            ty if is_bools(ty) && self.is_array => "BOOL",
            ty => ty.name().unwrap_or("a type that is not known"),
        };
        if self.is_array {
            format!("array of {name}")
        } else {
            name.to_owned()
        }
    }
}

/// The place of a value by its name, or what there is instead.
fn find<'t>(
    tags: &HashMap<String, &'t TagDef>,
    program: Option<&str>,
    name: &str,
) -> Result<Place<'t>, Found> {
    let path = Path::parse(name).ok_or(Found::Missing)?;
    let own = tags.get(&path.tag.to_lowercase());
    let of_program = program.filter(|_| !is_of_program(name)).and_then(|program| {
        let scope = if is_of_program(program) {
            program.to_owned()
        } else {
            format!("Program:{program}")
        };
        tags.get(&format!("{scope}.{}", path.tag).to_lowercase())
    });
    let tag = of_program.or(own).copied().ok_or(Found::Missing)?;
    let mut place = Place {
        tag,
        steps: Vec::new(),
        path: tag.tag_name.clone(),
        ty: &tag.data_type,
        is_bit: false,
        is_array: tag.dim > 0,
        is_hidden: false,
    };
    let dimensions = &tag.dimensions[..usize::from(tag.dim).min(tag.dimensions.len())];
    let mut dimensions: Vec<u32> = dimensions.to_vec();
    for piece in path.pieces {
        match piece {
            Piece::Index(indices) => place.element(&indices, &dimensions)?,
            Piece::Name(name) => dimensions = place.member(&name)?,
        }
    }
    Ok(place)
}

impl Place<'_> {
    /// Goes to an element.
    fn element(&mut self, indices: &[u32], dimensions: &[u32]) -> Result<(), Found> {
        let is_inside =
            indices.len() == dimensions.len() && indices.iter().zip(dimensions).all(|(index, of)| index < of);
        if !self.is_array || !is_inside {
            return Err(Found::Missing);
        }
        let number = indices
            .iter()
            .zip(dimensions)
            .fold(0_usize, |number, (index, of)| {
                number
                    .saturating_mul(*of as usize)
                    .saturating_add(*index as usize)
            });
        self.steps.push(Step::Element(number));
        let indices: Vec<String> = indices.iter().map(u32::to_string).collect();
        self.path = format!("{}[{}]", self.path, indices.join(","));
        self.is_array = false;
        self.is_bit = is_bools(self.ty);
        Ok(())
    }

    /// Goes to a member or a bit. The dimensions of that.
    fn member(&mut self, name: &str) -> Result<Vec<u32>, Found> {
        if self.is_array || self.is_bit {
            return Err(Found::Missing);
        }
        let structure = match self.ty {
            TypeRef::Struct(structure) => structure,
            TypeRef::Atomic(elementary) => {
                let bit = name.parse().map_err(|_| Found::Missing)?;
                if elementary.and_then(width).is_none_or(|width| bit >= width) {
                    return Err(Found::Missing);
                }
                self.steps.push(Step::Bit(bit));
                self.path = format!("{}.{bit}", self.path);
                self.is_bit = true;
                return Ok(Vec::new());
            }
        };
        let key = member_name(structure, name).ok_or(Found::Missing)?;
        let member = &structure.internal_tags[key];
        // The driver leaves out the first, takes no more than eight bits from a byte, and makes a text of a STRING.
        self.is_hidden |= structure.private_members.contains(key)
            || member.bit.is_some_and(|bit| bit >= 8)
            || structure.string.is_some();
        self.steps.push(Step::Member(key.to_owned()));
        self.path = format!("{}.{key}", self.path);
        self.ty = &member.data_type;
        let length = u32::from(member.array.unwrap_or(0));
        self.is_array = length > 0;
        // A member's words are counted, a tag's BOOLs are.
        let length = if is_bools(self.ty) { length * 32 } else { length };
        Ok(if self.is_array { vec![length] } else { Vec::new() })
    }
}

/// Members of timers and counters by our names and by Logix's (LANGUAGE §4).
const MEMBERS: [(&str, &str, &str); 11] = [
    ("TIMER", "Q", "DN"),
    ("TIMER", "IN", "EN"),
    ("TIMER", "ET", "ACC"),
    ("TIMER", "AC", "ACC"),
    ("TIMER", "PT", "PRE"),
    ("COUNTER", "Q", "DN"),
    ("COUNTER", "QU", "DN"),
    ("COUNTER", "EN", "CU"),
    ("COUNTER", "CV", "ACC"),
    ("COUNTER", "AC", "ACC"),
    ("COUNTER", "PV", "PRE"),
];

/// The controller's name of a member, which is compared without case.
fn member_name<'t>(structure: &'t DataType, name: &str) -> Option<&'t str> {
    let known = |name: &str| {
        let exact = structure.internal_tags.get_key_value(name);
        let any_case = || {
            structure
                .internal_tags
                .iter()
                .find(|(key, _)| key.eq_ignore_ascii_case(name))
        };
        exact.or_else(any_case).map(|(key, _)| key.as_str())
    };
    let of_type = structure.name.as_deref().unwrap_or_default();
    let other = || {
        let names = MEMBERS
            .iter()
            .find(|(ty, ours, _)| of_type.eq_ignore_ascii_case(ty) && ours.eq_ignore_ascii_case(name));
        names.and_then(|(_, _, theirs)| known(theirs))
    };
    known(name).or_else(other)
}

#[cfg(test)]
mod tests;
