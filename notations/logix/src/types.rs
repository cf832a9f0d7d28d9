//! The types of a project.

use crate::model::{DataType, Project, Raw, Tag};
use ladder_notation::names::Names;
use std::collections::{HashMap, HashSet};

/// An elementary type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Elem {
    Bool,
    Sint,
    Int,
    Dint,
    Lint,
    Usint,
    Uint,
    Udint,
    Ulint,
    Real,
    Lreal,
    /// With its length.
    String(u32),
}

/// How long a STRING of Logix is.
const STRING: u32 = 82;

impl Elem {
    pub(crate) fn named(name: &str) -> Option<Elem> {
        Some(match name {
            "BOOL" | "BIT" => Elem::Bool,
            "SINT" => Elem::Sint,
            "INT" => Elem::Int,
            "DINT" => Elem::Dint,
            "LINT" => Elem::Lint,
            "USINT" => Elem::Usint,
            "UINT" => Elem::Uint,
            "UDINT" => Elem::Udint,
            "ULINT" => Elem::Ulint,
            "REAL" => Elem::Real,
            "LREAL" => Elem::Lreal,
            "STRING" => Elem::String(STRING),
            // Numbers of microseconds and nanoseconds.
            "TIME32" => Elem::Dint,
            "TIME" | "LTIME" | "DT" | "LDT" => Elem::Lint,
            _ => return None,
        })
    }

    /// As ladder text writes it.
    pub(crate) fn text(self) -> String {
        let name = match self {
            Elem::Bool => "BOOL",
            Elem::Sint => "SINT",
            Elem::Int => "INT",
            Elem::Dint => "DINT",
            Elem::Lint => "LINT",
            Elem::Usint => "USINT",
            Elem::Uint => "UINT",
            Elem::Udint => "UDINT",
            Elem::Ulint => "ULINT",
            Elem::Real => "REAL",
            Elem::Lreal => "LREAL",
            Elem::String(length) => return format!("STRING[{length}]"),
        };
        name.to_owned()
    }

    pub(crate) const fn is_real(self) -> bool {
        matches!(self, Elem::Real | Elem::Lreal)
    }

    pub(crate) const fn is_integer(self) -> bool {
        !self.is_real() && !matches!(self, Elem::Bool | Elem::String(_))
    }

    /// How many bits an integer has.
    pub(crate) const fn bits(self) -> u32 {
        match self {
            Elem::Bool => 1,
            Elem::Sint | Elem::Usint => 8,
            Elem::Int | Elem::Uint => 16,
            Elem::Lint | Elem::Ulint | Elem::Lreal => 64,
            _ => 32,
        }
    }

    /// Whether each value of it is one of another type: such a number passes without being converted.
    pub(crate) const fn widens_to(self, to: Elem) -> bool {
        match to {
            Elem::Real => self.is_integer() && self.bits() <= 16,
            Elem::Lreal => (self.is_integer() && self.bits() <= 32) || matches!(self, Elem::Real),
            _ if !self.is_integer() || !to.is_integer() => false,
            // A number without a sign has one in a wider type alone.
            _ if self.is_signed() == to.is_signed() || to.is_signed() => self.bits() < to.bits(),
            _ => false,
        }
    }

    const fn is_signed(self) -> bool {
        matches!(self, Elem::Sint | Elem::Int | Elem::Dint | Elem::Lint)
    }

    /// A number cut to this type.
    pub(crate) const fn wrap(self, number: i64) -> i64 {
        match self {
            Elem::Sint => number as i8 as i64,
            Elem::Int => number as i16 as i64,
            Elem::Dint => number as i32 as i64,
            Elem::Usint => number as u8 as i64,
            Elem::Uint => number as u16 as i64,
            Elem::Udint => number as u32 as i64,
            _ => number,
        }
    }
}

/// A type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Ty {
    Elem(Elem),
    /// A place in [`Types::all`].
    Structure(usize),
    /// A place in [`Project::aois`].
    Aoi(usize),
    Array(Box<Ty>, Vec<u32>),
}

/// A structure.
#[derive(Debug, Clone, Default)]
pub(crate) struct Structure {
    /// As ladder text spells it, and as the file does.
    pub(crate) name: String,
    pub(crate) original: String,
    pub(crate) members: Vec<Field>,
    /// What the values of a list in L5K are, in their order.
    pub(crate) slots: Vec<Slot>,
    pub(crate) comment: Option<String>,
    /// A declared tag has it.
    pub(crate) used: bool,
    /// The file does not declare it: its members are those that are used.
    pub(crate) is_open: bool,
    /// The type of a member is only known by its use.
    pub(crate) is_guessed: bool,
}

/// A member.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) original: String,
    pub(crate) ty: Ty,
    pub(crate) comment: Option<String>,
}

/// A value of a list in L5K.
#[derive(Debug, Clone)]
pub(crate) enum Slot {
    /// That of a member.
    Member(usize),
    /// The bits of these members, each with its number.
    Bits(Vec<(usize, u32)>),
    /// That of nothing known.
    Unknown,
}

/// All types of a project.
#[derive(Debug, Default)]
pub(crate) struct Types {
    pub(crate) all: Vec<Structure>,
    names: Names,
    by_name: HashMap<String, Ty>,
}

/// Members by name, each with the number of its bit.
type Members = &'static [(&'static str, Option<u32>)];

/// The structures that every controller has: a member is a BOOL if it has a bit number in the first value of an L5K list, else
/// a DINT. `LAST` is this project's own: when the time was last counted.
const STANDARD: &[(&str, Members)] = &[
    (
        "TIMER",
        &[
            ("PRE", None),
            ("ACC", None),
            ("EN", Some(31)),
            ("TT", Some(30)),
            ("DN", Some(29)),
        ],
    ),
    (
        "COUNTER",
        &[
            ("PRE", None),
            ("ACC", None),
            ("CU", Some(31)),
            ("CD", Some(30)),
            ("DN", Some(29)),
            ("OV", Some(28)),
            ("UN", Some(27)),
        ],
    ),
    (
        "CONTROL",
        &[
            ("LEN", None),
            ("POS", None),
            ("EN", Some(31)),
            ("EU", Some(30)),
            ("DN", Some(29)),
            ("EM", Some(28)),
            ("ER", Some(27)),
            ("UL", Some(26)),
            ("IN", Some(25)),
            ("FD", Some(24)),
        ],
    ),
];

impl Types {
    pub(crate) fn of(project: &Project) -> Types {
        let mut types = Types::default();
        for (name, members) in STANDARD {
            types.standard(name, members);
        }
        for (index, aoi) in project.aois.iter().enumerate() {
            types
                .by_name
                .insert(aoi.name.to_ascii_uppercase(), Ty::Aoi(index));
        }
        let empty = empty(project);
        let mut structures = Vec::new();
        for declared in &project.types {
            if empty.contains(&declared.name.to_ascii_uppercase()) {
                continue;
            }
            let key = declared.name.to_ascii_uppercase();
            if types.by_name.contains_key(&key) || Elem::named(&key).is_some() {
                continue;
            }
            if declared.is_string {
                let length = declared
                    .members
                    .iter()
                    .find_map(|member| member.dimensions.first());
                let ty = Ty::Elem(Elem::String(*length.unwrap_or(&STRING)));
                types.by_name.insert(key, ty);
                continue;
            }
            let index = types.add(&declared.name);
            structures.push((index, declared));
        }
        for (index, declared) in structures {
            types.members(index, declared);
        }
        types
    }

    pub(crate) fn add(&mut self, name: &str) -> usize {
        let index = self.all.len();
        self.all.push(Structure {
            name: self.names.fresh(name),
            original: name.to_owned(),
            ..Structure::default()
        });
        self.by_name
            .insert(name.to_ascii_uppercase(), Ty::Structure(index));
        index
    }

    fn standard(&mut self, name: &str, members: Members) {
        let index = self.add(name);
        let structure = &mut self.all[index];
        let mut bits = Vec::new();
        for (number, (member, bit)) in members.iter().enumerate() {
            let elem = if bit.is_some() { Elem::Bool } else { Elem::Dint };
            structure.members.push(Field {
                name: (*member).to_owned(),
                original: (*member).to_owned(),
                ty: Ty::Elem(elem),
                comment: None,
            });
            bits.extend(bit.map(|bit| (number, bit)));
        }
        structure.slots = vec![Slot::Bits(bits), Slot::Member(0), Slot::Member(1)];
    }

    fn members(&mut self, index: usize, declared: &DataType) {
        let mut names = Names::default();
        let mut members: Vec<Field> = Vec::new();
        let mut slots = Vec::new();
        let mut hosts: HashMap<String, usize> = HashMap::new();
        for member in &declared.members {
            if member.hidden {
                hosts.insert(member.name.to_ascii_uppercase(), slots.len());
                slots.push(Slot::Bits(Vec::new()));
                continue;
            }
            let number = members.len();
            let ty = self.named(&member.ty, &member.dimensions);
            let ty = ty.or_else(|| self.open(&member.ty, &member.dimensions));
            match (&member.bit, &ty) {
                (Some((host, bit)), Some(_)) => {
                    let slot = hosts
                        .get(&host.to_ascii_uppercase())
                        .and_then(|slot| slots.get_mut(*slot));
                    if let Some(Slot::Bits(bits)) = slot {
                        bits.push((number, *bit));
                    }
                }
                (_, Some(_)) => slots.push(Slot::Member(number)),
                (_, None) => slots.push(Slot::Unknown),
            }
            if let Some(ty) = ty {
                members.push(Field {
                    name: names.spell(&member.name).to_owned(),
                    original: member.name.clone(),
                    ty,
                    comment: member.comment.clone(),
                });
            }
        }
        let structure = &mut self.all[index];
        structure.members = members;
        structure.slots = slots;
        structure.comment.clone_from(&declared.comment);
    }

    /// A type by its name.
    pub(crate) fn named(&self, name: &str, dimensions: &[u32]) -> Option<Ty> {
        let key = name.to_ascii_uppercase();
        let (key, sizes) = match key.split_once('[') {
            // As L5K writes the type of a member.
            Some((key, sizes)) => {
                let sizes = sizes.trim_end_matches(']').split(',');
                let sizes: Option<Vec<u32>> = sizes.map(|size| size.trim().parse().ok()).collect();
                (key.to_owned(), sizes?)
            }
            None => (key, dimensions.to_vec()),
        };
        let ty = Elem::named(&key)
            .map(Ty::Elem)
            .or_else(|| self.by_name.get(&key).cloned())?;
        Some(array(ty, sizes))
    }

    /// The type of a tag. One that the file does not declare follows from the tag's value.
    pub(crate) fn of_tag(&mut self, tag: &Tag) -> Option<Ty> {
        self.named(&tag.ty, &tag.dimensions)
            .or_else(|| self.shown_by(tag.value.as_ref()?, 0))
            .or_else(|| self.open(&tag.ty, &tag.dimensions))
    }

    fn shown_by(&mut self, value: &Raw, depth: usize) -> Option<Ty> {
        match value {
            Raw::Scalar(ty, _) => self.named(ty, &[]),
            Raw::Array(ty, sizes, elements) => {
                let ty = match self.named(ty, &[]) {
                    Some(ty) => ty,
                    None => self.shown_by(elements.first()?, depth + 1)?,
                };
                Some(array(ty, sizes.clone()))
            }
            Raw::Structure(ty, _) if self.named(ty, &[]).is_some() => self.named(ty, &[]),
            Raw::Structure(ty, members) if depth < 40 => {
                let mut names = Names::default();
                let mut fields = Vec::new();
                for (member, value) in members {
                    let Some(ty) = self.shown_by(value, depth + 1) else {
                        continue;
                    };
                    fields.push(Field {
                        name: names.spell(member).to_owned(),
                        original: member.clone(),
                        ty,
                        comment: None,
                    });
                }
                if fields.is_empty() {
                    return None;
                }
                let index = self.add(ty);
                self.all[index].members = fields;
                Some(Ty::Structure(index))
            }
            Raw::Structure(..) | Raw::List(_) => None,
        }
    }

    /// The member of a structure.
    pub(crate) fn member(&self, structure: usize, name: &str) -> Option<(usize, &Field)> {
        let members = self.all[structure].members.iter().enumerate();
        let mut found = members.filter(|(_, field)| field.original.eq_ignore_ascii_case(name));
        found.next()
    }

    /// The structure that a type is, as the file spells it; nothing for others.
    pub(crate) fn original(&self, ty: &Ty) -> &str {
        match ty {
            Ty::Structure(index) => &self.all[*index].original,
            _ => "",
        }
    }

    /// The same of the elements of an array.
    pub(crate) fn original_of_elements(&self, ty: &Ty) -> &str {
        match ty {
            Ty::Array(of, _) => self.original_of_elements(of),
            ty => self.original(ty),
        }
    }

    /// Whether an instance of an Add-On Instruction is in a value: such a value is not moved.
    pub(crate) fn holds_instance(&self, ty: &Ty, depth: usize) -> bool {
        match ty {
            Ty::Elem(_) => false,
            Ty::Aoi(_) => true,
            Ty::Array(of, _) => self.holds_instance(of, depth),
            Ty::Structure(index) => {
                let mut fields = self.all[*index].members.iter();
                depth > 40 || fields.any(|field| self.holds_instance(&field.ty, depth + 1))
            }
        }
    }

    /// Notes that a declared tag has a type.
    pub(crate) fn keep(&mut self, ty: &Ty) {
        match ty {
            Ty::Elem(_) | Ty::Aoi(_) => {}
            Ty::Array(ty, _) => self.keep(ty),
            Ty::Structure(index) => {
                if std::mem::replace(&mut self.all[*index].used, true) {
                    return;
                }
                let members: Vec<Ty> = self.all[*index]
                    .members
                    .iter()
                    .map(|field| field.ty.clone())
                    .collect();
                for ty in &members {
                    self.keep(ty);
                }
            }
        }
    }
}

/// The types without a member, in capitals: a structure has at least one here.
fn empty(project: &Project) -> HashSet<String> {
    let mut empty = HashSet::new();
    loop {
        let before = empty.len();
        for ty in project.types.iter().filter(|ty| !ty.is_string) {
            let can_be = |name: &str| {
                let key = name.split('[').next().unwrap_or_default().to_ascii_uppercase();
                !key.is_empty() && !empty.contains(&key)
            };
            if !ty
                .members
                .iter()
                .any(|member| !member.hidden && can_be(&member.ty))
            {
                empty.insert(ty.name.to_ascii_uppercase());
            }
        }
        if empty.len() == before {
            return empty;
        }
    }
}

fn array(ty: Ty, sizes: Vec<u32>) -> Ty {
    if sizes.is_empty() || sizes.contains(&0) {
        ty
    } else {
        Ty::Array(Box::new(ty), sizes)
    }
}
