//! Structures, enumerations and arrays that are more than one dimension of elementary values: numbers in one table, which
//! knows each definition once. The table only grows, by the definitions that nobody had before.

mod columns;

use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
pub use columns::Column;
use columns::count;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHasher};
use smol_str::SmolStr;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::{Arc, LazyLock, PoisonError, RwLock};

/// More elementary parts than this in one tag are refused: what still shows and saves quickly.
pub(crate) const MOST_PARTS: u64 = 1_000_000;
/// More columns than this in one type are refused: each is a tag of the program.
pub(crate) const MOST_COLUMNS: u32 = 2_000;

/// First and last index of each dimension of an array.
pub type Dimensions = Box<[(i64, i64)]>;

/// A structure, an array or a user-defined block as the type of a tag: its number in the table.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TypeId(u32);

/// An enumeration: its number in the table.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct EnumId(u32);

/// A type with parts.
#[derive(Debug, Clone, PartialEq)]
pub enum Compound {
    /// `STRUCT`
    Structure(Structure),
    /// `ARRAY[1..3, 0..9] OF Motor`
    Array(ArrayType),
    /// `$Motor`: the state of a user-defined block, by its name with the `$`.
    Block(SmolStr),
}

/// A structure.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    /// As declared.
    pub name: SmolStr,
    /// In the order of their declaration.
    pub members: Box<[MemberType]>,
    /// Something is known of all members; of those of which nothing is, the section of types has a finding.
    pub is_whole: bool,
}

/// A member of a structure.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberType {
    /// As declared.
    pub name: SmolStr,
    /// As it is compared.
    pub key: Name,
    /// Its type.
    pub ty: Type,
    /// The values of its elementary parts at the start, where the structure says so.
    pub initial: Option<Arc<[Value]>>,
    /// The same of one element, if it is an array whose elements' type says so.
    pub element: Option<Arc<[Value]>>,
}

/// An array of anything.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrayType {
    /// First and last index of each dimension.
    pub dimensions: Dimensions,
    /// Type of each element.
    pub element: Type,
}

/// An enumeration.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Enumeration {
    /// As declared.
    pub name: SmolStr,
    /// Its values in the order of their declaration, with their numbers.
    pub values: Box<[(SmolStr, i32)]>,
}

/// A type with what is often asked of it.
#[derive(Debug)]
struct Known {
    ty: Compound,
    /// How many columns it has.
    columns: u32,
    /// How many elementary values it has.
    values: u64,
    /// How many parts it has, those that keep a state included.
    parts: u64,
    /// Whether a timer, counter or block keeps its state in it.
    keeps_state: bool,
}

#[derive(Default)]
struct Table {
    types: Vec<Arc<Known>>,
    enumerations: Vec<Arc<Enumeration>>,
    by_hash: FxHashMap<u64, Vec<u32>>,
    enumerations_by_content: FxHashMap<Arc<Enumeration>, EnumId>,
}

static TABLE: LazyLock<RwLock<Table>> = LazyLock::new(RwLock::default);

impl TypeId {
    /// The number of a type. None: it has more parts than a tag may have.
    pub(crate) fn of(ty: Compound) -> Option<TypeId> {
        let hash = hash(&ty);
        let find = |table: &Table| {
            let same = table.by_hash.get(&hash)?;
            let same = same.iter().find(|number| table.types[**number as usize].ty == ty);
            same.map(|number| TypeId(*number))
        };
        if let Some(found) = find(&TABLE.read().unwrap_or_else(PoisonError::into_inner)) {
            return Some(found);
        }
        let known = Known::of(ty)?;
        let mut table = TABLE.write().unwrap_or_else(PoisonError::into_inner);
        let number = u32::try_from(table.types.len()).ok()?;
        table.types.push(Arc::new(known));
        table.by_hash.entry(hash).or_default().push(number);
        Some(TypeId(number))
    }

    fn known(self) -> Arc<Known> {
        Arc::clone(&TABLE.read().unwrap_or_else(PoisonError::into_inner).types[self.0 as usize])
    }

    /// What it is.
    pub fn get(self) -> Compound {
        self.known().ty.clone()
    }

    /// Asks something of it without a copy.
    pub fn with<T>(self, ask: impl FnOnce(&Compound) -> T) -> T {
        ask(&self.known().ty)
    }

    /// Whether a timer, counter, bistable or block keeps its state in it.
    pub fn keeps_state(self) -> bool {
        self.known().keeps_state
    }

    /// How many elementary values it has.
    pub fn values(self) -> u64 {
        self.known().values
    }

    /// Calls something with the name of each user-defined block whose state is in it.
    pub(crate) fn each_block(self, found: &mut impl FnMut(&SmolStr)) {
        let inside: Vec<Type> = self.with(|ty| match ty {
            Compound::Block(name) => {
                found(name);
                Vec::new()
            }
            Compound::Array(array) => vec![array.element],
            Compound::Structure(structure) => structure.members.iter().map(|member| member.ty).collect(),
        });
        for ty in inside {
            if let Type::Compound(id) = ty {
                id.each_block(found);
            }
        }
    }

    /// The name of the user-defined block, if it is the state of one.
    pub fn block(self) -> Option<SmolStr> {
        self.with(|ty| match ty {
            Compound::Block(name) => Some(name.clone()),
            _ => None,
        })
    }
}

impl Known {
    fn of(ty: Compound) -> Option<Known> {
        let (columns, values, parts, keeps_state) = match &ty {
            Compound::Structure(structure) => structure.members.iter().fold(
                (0u32, 0u64, 0u64, false),
                |(columns, values, parts, keeps), member| {
                    (
                        columns.saturating_add(member.ty.columns()),
                        values.saturating_add(member.ty.value_count()),
                        parts.saturating_add(member.ty.part_count()),
                        keeps || member.ty.keeps_state(),
                    )
                },
            ),
            Compound::Array(array) => {
                let elements = count(&array.dimensions);
                (
                    array.element.columns(),
                    elements.saturating_mul(array.element.value_count()),
                    elements.saturating_mul(array.element.part_count()),
                    array.element.keeps_state(),
                )
            }
            Compound::Block(_) => (1, 0, 1, true),
        };
        (parts <= MOST_PARTS && columns <= MOST_COLUMNS).then_some(Known {
            ty,
            columns,
            values,
            parts,
            keeps_state,
        })
    }
}

/// A number for a type by its content, without its initial values.
fn hash(ty: &Compound) -> u64 {
    let mut hasher = FxHasher::default();
    match ty {
        Compound::Structure(structure) => {
            structure.name.hash(&mut hasher);
            for member in &structure.members {
                (&member.name, member.ty).hash(&mut hasher);
            }
        }
        Compound::Array(array) => (1, &array.dimensions, array.element).hash(&mut hasher),
        Compound::Block(name) => (2, name).hash(&mut hasher),
    }
    hasher.finish()
}

impl EnumId {
    /// The number of an enumeration.
    pub(crate) fn of(enumeration: Enumeration) -> EnumId {
        let table = TABLE.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = table.enumerations_by_content.get(&enumeration) {
            return *known;
        }
        drop(table);
        let mut table = TABLE.write().unwrap_or_else(PoisonError::into_inner);
        let number = EnumId(u32::try_from(table.enumerations.len()).unwrap_or(u32::MAX));
        let enumeration = Arc::new(enumeration);
        table.enumerations.push(Arc::clone(&enumeration));
        *table.enumerations_by_content.entry(enumeration).or_insert(number)
    }

    /// A number that stands for it while the process lives.
    pub const fn number(self) -> u32 {
        self.0
    }

    /// The one that a number stands for.
    pub fn from_number(number: u32) -> Option<EnumId> {
        let table = TABLE.read().unwrap_or_else(PoisonError::into_inner);
        ((number as usize) < table.enumerations.len()).then_some(EnumId(number))
    }

    /// What it is.
    pub fn get(self) -> Arc<Enumeration> {
        let table = TABLE.read().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(&table.enumerations[self.0 as usize])
    }
}

impl Enumeration {
    /// The number of a value by its name, in any case.
    pub fn number(&self, name: &str) -> Option<i32> {
        let key = Name::new(name);
        let found = self.values.iter().find(|(name, _)| Name::new(name) == key);
        found.map(|(_, number)| *number)
    }

    /// The name of a value by its number.
    pub fn name_of(&self, number: i64) -> Option<&SmolStr> {
        let found = self.values.iter().find(|(_, own)| i64::from(*own) == number);
        found.map(|(name, _)| name)
    }

    /// The number that a tag of the type starts with, unless it says otherwise.
    pub fn first(&self) -> i64 {
        self.values.first().map_or(0, |(_, number)| i64::from(*number))
    }
}

impl Structure {
    /// A member by its name.
    pub fn member(&self, name: &str) -> Option<(usize, &MemberType)> {
        let key = Name::new(name);
        self.members
            .iter()
            .enumerate()
            .find(|(_, member)| member.key == key)
    }
}

impl fmt::Display for TypeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.known().ty {
            Compound::Structure(structure) => f.write_str(&structure.name),
            Compound::Block(name) => f.write_str(name),
            Compound::Array(array) => {
                f.write_str("ARRAY[")?;
                for (n, (first, last)) in array.dimensions.iter().enumerate() {
                    let comma = if n > 0 { ", " } else { "" };
                    write!(f, "{comma}{first}..{last}")?;
                }
                write!(f, "] OF {}", array.element)
            }
        }
    }
}

impl fmt::Debug for TypeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "TypeId({self})")
    }
}

impl fmt::Debug for EnumId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "EnumId({})", Scalar::Enum(*self))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair() -> Type {
        let member = |name: &str, ty: Type| MemberType {
            name: name.into(),
            key: Name::new(name),
            ty,
            initial: None,
            element: None,
        };
        let structure = Structure {
            name: "Pair".into(),
            is_whole: true,
            members: Box::new([
                member("a", Type::Scalar(Scalar::Int)),
                member(
                    "b",
                    Type::Array {
                        first: 0,
                        last: 1,
                        element: Scalar::Bool,
                    },
                ),
            ]),
        };
        Type::Compound(TypeId::of(Compound::Structure(structure)).unwrap())
    }

    #[test]
    fn the_same_content_has_the_same_number() {
        assert_eq!(pair(), pair());
        assert!(size_of::<Type>() <= 24, "{}", size_of::<Type>());
    }

    #[test]
    fn columns_and_their_values() {
        let array = ArrayType {
            dimensions: Box::new([(1, 2)]),
            element: pair(),
        };
        let ty = Type::Compound(TypeId::of(Compound::Array(array)).unwrap());
        let paths: Vec<String> = ty.column_list().into_iter().map(|column| column.path).collect();
        assert_eq!(paths, ["[].a", "[].b[]"]);
        let grid = ArrayType {
            dimensions: Box::new([(1, 2), (0, 3)]),
            element: Type::BOOL,
        };
        let grid = Type::Compound(TypeId::of(Compound::Array(grid)).unwrap());
        assert_eq!(grid.column_list()[0].path, "[][]");
        assert_eq!(ty.value_count(), 6);
        let longest: Vec<u64> = ty.column_list().iter().map(Column::longest_array).collect();
        assert_eq!(longest, [2, 2]);
        let values = [1, 10, 11, 2, 20, 21].map(Value::Int);
        assert_eq!(ty.column_values(0, &values), [1, 2].map(Value::Int));
        assert_eq!(ty.column_values(1, &values), [10, 11, 20, 21].map(Value::Int));
    }

    #[test]
    fn what_is_too_large_has_none() {
        let array = |element| ArrayType {
            dimensions: Box::new([(1, 1000), (1, 1000), (1, 2)]),
            element,
        };
        assert_eq!(TypeId::of(Compound::Array(array(Type::BOOL))), None);
    }
}
