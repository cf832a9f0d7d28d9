//! The tags of a program: those of its own file, and of other files what the reached bodies name. A VAR_GLOBAL tag and
//! a direct address are one tag, whichever file names them, and so are all that are declared at one address.

use super::numbers::{Numbers, Unit};
use super::parts;
use crate::names::scope::{Origin, SectionKind, TagFacts, type_by_form};
use crate::program::{Disagreement, Location, OtherName, Program, Role, Tag, TagId};
use crate::rules::one_address::{self, Said};
use crate::values::types::{Scalar, Type};
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};

/// The id of a tag that no reached body names: it is never asked for.
pub(super) const NOWHERE: TagId = TagId(u32::MAX);

/// What the tags of a scope are in the program.
pub(super) struct Ids {
    /// The id of each; what is shared has the id of the tag that it leads to.
    pub(super) of_tags: Vec<TagId>,
    /// Of each tag with parts the tags of the program that hold its columns: of what keeps a state the first of them.
    pub(super) columns: FxHashMap<usize, Box<[TagId]>>,
    /// The types of those tags at direct addresses that the program has in another type than the scope.
    pub(super) stored: FxHashMap<usize, Scalar>,
}

/// Adds the units' tags to the program. Returns the ids of each scope of each unit.
pub(super) fn tags(units: &[Unit<'_>], numbers: &Numbers, program: &mut Program) -> Vec<Vec<Ids>> {
    let mut of_program = Common::default();
    let prefixes = prefixes(units);
    let mut all = Vec::with_capacity(units.len());
    for (index, unit) in units.iter().enumerate() {
        let context = unit.context;
        let mut of_plant = Common::default();
        let common = if unit.plant.is_some() {
            &mut of_plant
        } else {
            &mut of_program
        };
        let mut ids: Vec<Ids> = Vec::with_capacity(context.scopes.len());
        for (scope, facts) in context.scopes.iter().enumerate() {
            let block = numbers.block_of_scope(index, scope);
            let mut columns = FxHashMap::default();
            let of_scope = facts.tags.iter().enumerate().map(|(number, tag)| {
                let reached = unit.bodies.is_none()
                    || block.is_some()
                    || context
                        .uses(tag)
                        .any(|place| unit.reaches(context.bodies[place.network]));
                if tag.is_alias() || !reached {
                    return NOWHERE;
                }
                let named = Named {
                    tag,
                    block: block.filter(|_| !is_global(tag)),
                    prefix: prefixes[index].as_deref(),
                    is_of_plant: unit.plant.is_some(),
                    location: place(unit, index, tag, program),
                };
                if let Type::Compound(_) = type_of(tag) {
                    let parts = common.enter_parts(&named, program);
                    let first = parts.first().copied().unwrap_or(NOWHERE);
                    columns.insert(number, parts);
                    return first;
                }
                common.enter(&named, program)
            });
            ids.push(Ids {
                of_tags: of_scope.collect(),
                columns,
                stored: FxHashMap::default(),
            });
        }
        for (scope, facts) in context.scopes.iter().enumerate() {
            for (tag, facts) in facts.tags.iter().enumerate() {
                if let Some((shared_scope, shared_tag)) = context.alias_of(facts) {
                    ids[scope].of_tags[tag] = ids[shared_scope].of_tags[shared_tag];
                    if let Some(columns) = ids[shared_scope].columns.get(&shared_tag).cloned() {
                        ids[scope].columns.insert(tag, columns);
                    }
                }
            }
        }
        of_program.has_two_types |= of_plant.has_two_types;
        all.push(ids);
    }
    if of_program.has_two_types {
        for (unit, ids) in units.iter().zip(&mut all) {
            for (scope, ids) in unit.context.scopes.iter().zip(ids) {
                ids.stored = stored(scope.tags.iter(), &ids.of_tags, program);
            }
        }
    }
    all
}

/// What is before the names of a file's own tags in a program of several files, as in `library.count`: the stem
/// of the file, or where two files have one stem its path. The program's own file needs none, a plant has its name.
fn prefixes(units: &[Unit<'_>]) -> Vec<Option<String>> {
    let stem = |unit: &Unit<'_>| {
        let file = unit.name.rsplit(['/', '\\']).next().unwrap_or(unit.name);
        file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned()
    };
    let stems: Vec<String> = units.iter().map(stem).collect();
    let prefix = |index: usize| match index {
        0 => None,
        _ if units[index].plant.is_some() => units[index].plant.map(str::to_owned),
        _ if stems[..index].contains(&stems[index]) => Some(units[index].name.to_owned()),
        _ => Some(stems[index].clone()),
    };
    (0..units.len()).map(prefix).collect()
}

/// A tag as one file knows it.
pub(super) struct Named<'t> {
    pub(super) tag: &'t TagFacts,
    /// The block whose body declares it for itself.
    pub(super) block: Option<usize>,
    /// What is before the names of the file's own tags.
    prefix: Option<&'t str>,
    /// Its direct addresses are its own.
    is_of_plant: bool,
    pub(super) location: Location,
}

impl Named<'_> {
    /// Its name in the program. One of a body has no file before it: it has the block's place there.
    pub(super) fn name(&self) -> String {
        match self.prefix {
            Some(prefix) if !is_global(self.tag) && self.block.is_none() => {
                format!("{prefix}.{}", self.tag.name)
            }
            _ => self.tag.name.to_string(),
        }
    }

    fn address(&self) -> Option<&str> {
        let address = self.tag.cold.address.as_deref();
        address.filter(|address| type_by_form(address).is_some())
    }

    /// Whether it is known outside its file, or of a block's body outside that.
    pub(super) fn is_shared(&self) -> bool {
        let is_own = match self.tag.origin {
            Origin::Declared(SectionKind::Global | SectionKind::External) => false,
            Origin::Declared(_) => self.address().is_none(),
            Origin::Form | Origin::Undeclared | Origin::Shared => false,
            Origin::Implicit => true,
        };
        self.block.is_none() && !is_own
    }

    /// Whether it is an address itself, without a declaration.
    fn is_bare(&self) -> bool {
        self.tag.name.starts_with('%')
    }
}

/// The tags that several files, or names, mean.
#[derive(Default)]
struct Common {
    globals: FxHashMap<Name, TagId>,
    /// Those that have parts: the first tag of each column.
    globals_with_parts: FxHashMap<Name, (Type, Box<[TagId]>)>,
    addresses: FxHashMap<Name, AtAddress>,
    /// The names of addresses that are entered.
    other_names: FxHashSet<OtherName>,
    /// An address is known in two types.
    has_two_types: bool,
}

/// The tag at an address.
struct AtAddress {
    id: TagId,
    /// So far the address itself is all that is known of it.
    is_bare: bool,
    /// It was written by its address.
    is_written: bool,
}

impl Common {
    /// The id of a tag, which is new or there already.
    fn enter(&mut self, named: &Named<'_>, program: &mut Program) -> TagId {
        let global = is_global(named.tag).then(|| Name::new(&named.tag.name));
        if let Some(&id) = global.as_ref().and_then(|global| self.globals.get(global))
            && program.tags[id.0 as usize].ty == type_of(named.tag)
        {
            return id;
        }
        let id = match named.address() {
            Some(address) => self.enter_address(named, address, program),
            None => add(program, named, named.name(), named.block),
        };
        if let Some(global) = global {
            self.globals.insert(global, id);
        }
        id
    }

    /// The tags that hold the columns of a tag with parts, of what keeps a state the first of each.
    fn enter_parts(&mut self, named: &Named<'_>, program: &mut Program) -> Box<[TagId]> {
        let ty = type_of(named.tag);
        let global = is_global(named.tag).then(|| Name::new(&named.tag.name));
        if let Some((known, columns)) = global
            .as_ref()
            .and_then(|global| self.globals_with_parts.get(global))
            && *known == ty
        {
            return columns.clone();
        }
        let columns: Box<[TagId]> = parts::add(program, named, ty).into();
        if let Some(global) = global {
            self.globals_with_parts.insert(global, (ty, columns.clone()));
        }
        columns
    }

    fn enter_address(&mut self, named: &Named<'_>, address: &str, program: &mut Program) -> TagId {
        let key = Name::new(address);
        let is_written = named.tag.uses.writers().next().is_some();
        let Some(known) = self.addresses.get_mut(&key) else {
            // A body is there several times, its address once.
            let name = match named.block {
                Some(_) => address.to_owned(),
                None if named.is_bare() && !named.is_of_plant => named.tag.name.to_string(),
                None => named.name(),
            };
            let id = add(program, named, name, None);
            if named.block.is_some() {
                other_name(named, id, &mut self.other_names, program);
            }
            self.addresses.insert(
                key,
                AtAddress {
                    id,
                    is_bare: named.is_bare(),
                    is_written,
                },
            );
            return id;
        };
        let id = known.id;
        if !named.is_bare() {
            other_name(named, id, &mut self.other_names, program);
        }
        let tag = &mut program.tags[id.0 as usize];
        self.has_two_types |= tag.ty != type_of(named.tag);
        if let Some(message) = disagreement(known, tag, named, address) {
            program.disagreement.get_or_insert(Disagreement {
                message: format!("{message}: {}", one_address::HELP),
                location: named.location,
            });
            return id;
        }
        if known.is_bare && !named.is_bare() {
            tag.ty = type_of(named.tag);
        }
        if tag.initial.is_empty() {
            tag.initial = one_address::with_same_bits(&named.tag.cold.initial, tag.ty);
        }
        if tag.role == Role::Internal {
            tag.role = named.tag.role;
        }
        tag.retain |= named.tag.retain;
        tag.constant |= named.tag.constant;
        known.is_written |= named.is_bare() && is_written;
        known.is_bare &= named.is_bare();
        id
    }
}

/// What a name says otherwise of its address than the names before it. An address by itself says nothing of CONSTANT.
fn disagreement(known: &AtAddress, tag: &Tag, named: &Named<'_>, address: &str) -> Option<String> {
    let mut first = Said::from(tag);
    let mut second = Said::from(named.tag);
    let name = named.name();
    if !named.is_bare() {
        second.name = &name;
    }
    if second.ty.is_none() {
        second.ty = Some(type_of(named.tag));
    }
    if known.is_bare && !known.is_written {
        first.constant = second.constant;
    }
    if named.is_bare() && named.tag.uses.writers().next().is_none() {
        second.constant = first.constant;
    }
    one_address::disagreement(first, second, address)
}

/// Enters that a name leads to a tag.
fn other_name(named: &Named<'_>, tag: TagId, entered: &mut FxHashSet<OtherName>, program: &mut Program) {
    let other = OtherName {
        name: named.name(),
        tag,
        block: named.block,
    };
    let is_known = program.tags[tag.0 as usize].name == other.name && other.block.is_none();
    if !is_known && entered.insert(other.clone()) {
        program.other_names.push(other);
    }
}

/// The types of the tags of a scope that the program has in another type.
fn stored<'t>(
    tags: impl Iterator<Item = &'t TagFacts>,
    ids: &[TagId],
    program: &Program,
) -> FxHashMap<usize, Scalar> {
    let known = tags.zip(ids).enumerate().filter(|(_, (_, id))| **id != NOWHERE);
    let other = known.filter_map(|(index, (tag, id))| {
        let ty = program.tags[id.0 as usize].ty;
        let is_other = ty != type_of(tag) && program.tags[id.0 as usize].address.is_some();
        Some((index, ty.scalar().filter(|_| is_other)?))
    });
    other.collect()
}

/// Whether it is a VAR_GLOBAL tag, of its file or another one.
pub(super) fn is_global(tag: &TagFacts) -> bool {
    tag.cold.foreign.is_some() || tag.origin == Origin::Declared(SectionKind::Global)
}

/// Where a tag is declared or first used; a global of another file there.
fn place(unit: &Unit<'_>, index: usize, tag: &TagFacts, program: &mut Program) -> Location {
    let own = Location {
        file: index as u32,
        range: unit.context.place_of(tag),
    };
    if tag.cold.foreign.is_none() {
        return own;
    }
    let Some((exports, global)) = unit.context.others.globals(&Name::new(&tag.name)).next() else {
        return own;
    };
    let known = program.files.iter().position(|name| **name == *exports.file);
    let file = known.unwrap_or_else(|| {
        program.files.push(exports.file.to_string());
        program.files.len() - 1
    });
    Location {
        file: file as u32,
        range: global.at,
    }
}

fn type_of(tag: &TagFacts) -> Type {
    tag.ty.unwrap_or(Type::Scalar(Scalar::Dint))
}

fn add(program: &mut Program, named: &Named<'_>, name: String, block: Option<usize>) -> TagId {
    let tag = named.tag;
    let id = TagId(program.tags.len() as u32);
    let ty = type_of(tag);
    let initial = match tag.cold.initial.as_slice() {
        [] => parts::own_values(ty),
        values => values.to_vec(),
    };
    program.tags.push(Tag {
        name,
        ty,
        role: tag.role,
        is_input: false,
        retain: tag.retain,
        constant: tag.constant,
        shared: named.is_shared(),
        initial,
        column: None,
        address: tag
            .cold
            .address
            .as_deref()
            .filter(|_| !named.is_of_plant)
            .map(str::to_owned),
        block,
        location: named.location,
    });
    id
}
