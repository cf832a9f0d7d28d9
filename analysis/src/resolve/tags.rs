//! The tags of a program: those of its own file, and of other files what the reached bodies name. A VAR_GLOBAL tag and
//! a direct address are one tag, whichever file names them.

use super::numbers::{Numbers, Unit};
use crate::program::{Location, Program, Tag, TagId};
use crate::scope::{Origin, SectionKind, TagFacts};
use crate::types::{Scalar, Type};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// The id of a tag that no reached body names: it is never asked for.
const NOWHERE: TagId = TagId(u32::MAX);

/// Adds the units' tags to the program. Gives the id of each tag of each scope of each unit; what is shared has the
/// id of the tag that it leads to.
pub(super) fn tags(units: &[Unit<'_>], numbers: &Numbers, program: &mut Program) -> Vec<Vec<Vec<TagId>>> {
    // One file alone has its globals under one entry each.
    let mut common: FxHashMap<Name, TagId> = FxHashMap::default();
    let prefixes = prefixes(units);
    let mut all = Vec::with_capacity(units.len());
    for (index, unit) in units.iter().enumerate() {
        let context = unit.context;
        let mut ids: Vec<Vec<TagId>> = Vec::with_capacity(context.scopes.len());
        for (scope, facts) in context.scopes.iter().enumerate() {
            let block = numbers.block_of_scope(index, scope);
            let of_scope = facts.tags.iter().map(|tag| {
                let reached = unit.bodies.is_none()
                    || block.is_some()
                    || context
                        .uses(tag)
                        .any(|place| unit.reaches(context.bodies[place.network]));
                if tag.leads_elsewhere() || !reached {
                    return NOWHERE;
                }
                if !is_common(tag) {
                    let location = place(unit, index, tag, program);
                    let id = add(program, tag, block, location);
                    if let Some(prefix) = prefixes[index].as_ref().filter(|_| block.is_none()) {
                        program.tags[id.0 as usize].name = format!("{prefix}.{}", tag.name);
                    }
                    // Files that use the address itself mean this tag.
                    if let Some(address) = tag.rare.address.as_deref().filter(|_| block.is_none()) {
                        common.entry(Name::new(address)).or_insert(id);
                    }
                    return id;
                }
                let key = Name::new(&tag.name);
                if let Some(&id) = common.get(&key)
                    && program.tags[id.0 as usize].ty == type_of(tag)
                {
                    return id;
                }
                let location = place(unit, index, tag, program);
                let id = add(program, tag, None, location);
                common.insert(key, id);
                id
            });
            ids.push(of_scope.collect());
        }
        for (scope, facts) in context.scopes.iter().enumerate() {
            for (tag, facts) in facts.tags.iter().enumerate() {
                if let Some((shared_scope, shared_tag)) = context.leads_to(facts) {
                    ids[scope][tag] = ids[shared_scope][shared_tag];
                }
            }
        }
        all.push(ids);
    }
    all
}

/// What is before the names of a file's own tags in a program of several files, as in `library.count`: the stem
/// of the file, or where two files have one stem its path. The program's own file needs none.
fn prefixes(units: &[Unit<'_>]) -> Vec<Option<String>> {
    let stem = |unit: &Unit<'_>| {
        let file = unit.name.rsplit(['/', '\\']).next().unwrap_or(unit.name);
        file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned()
    };
    let stems: Vec<String> = units.iter().map(stem).collect();
    let prefix = |index: usize| match index {
        0 => None,
        _ if stems[..index].contains(&stems[index]) => Some(units[index].name.to_owned()),
        _ => Some(stems[index].clone()),
    };
    (0..units.len()).map(prefix).collect()
}

/// Whether a tag is the same in all files.
fn is_common(tag: &TagFacts) -> bool {
    tag.rare.foreign.is_some()
        || tag.origin == Origin::Declared(SectionKind::Global)
        || (tag.origin == Origin::Form && tag.rare.address.is_some())
}

/// Where a tag is declared or first used; a global of another file there.
fn place(unit: &Unit<'_>, index: usize, tag: &TagFacts, program: &mut Program) -> Location {
    let own = Location {
        file: index as u32,
        range: unit.context.place_of(tag),
    };
    if tag.rare.foreign.is_none() {
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
        range: exports.place_of(global),
    }
}

fn type_of(tag: &TagFacts) -> Type {
    tag.ty.unwrap_or(Type::Scalar(Scalar::Dint))
}

fn add(program: &mut Program, tag: &TagFacts, block: Option<usize>, location: Location) -> TagId {
    let id = TagId(program.tags.len() as u32);
    program.tags.push(Tag {
        name: tag.name.to_string(),
        ty: type_of(tag),
        role: tag.role,
        retain: tag.retain,
        constant: tag.constant,
        initial: tag.rare.initial.clone(),
        address: tag.rare.address.as_deref().map(str::to_owned),
        block,
        location,
    });
    id
}
