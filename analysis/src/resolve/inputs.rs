//! Which tags are the inputs of a program: [`Tag::is_input`](crate::program::Tag::is_input), for all who ask (LANGUAGE §4).
//!
//! VAR_INPUT, the addresses of inputs, tags without a declaration that nothing writes, and VAR_GLOBAL tags that something writes
//! which the program does not run: another program of the workspace may run between two of its scans.

use super::numbers::Unit;
use super::tags::{Ids, NOWHERE, is_global};
use crate::names::context::Body;
use crate::names::scope::{Origin, TagFacts};
use crate::program::Access;
use crate::program::{Program, Role, TagId, Unread, root_of};
use crate::resolve::targets::{Target, targets};
use crate::values::types::Type;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};

/// What the files say of a tag of the program.
#[derive(Debug, Clone, Copy, Default)]
struct Known {
    is_declared: bool,
    is_written: bool,
    is_written_elsewhere: bool,
}

/// Marks the inputs among the program's tags.
pub(super) fn mark(units: &[Unit<'_>], ids: &[Vec<Ids>], program: &mut Program) {
    // What no file names is a part of a tag.
    let mut known: Vec<Option<Known>> = vec![None; program.tags.len()];
    let elsewhere = written_elsewhere(units);
    for (unit, ids) in units.iter().zip(ids) {
        for (scope, ids) in unit.context.scopes.iter().zip(ids) {
            for (number, (tag, id)) in scope.tags.iter().zip(&ids.of_tags).enumerate() {
                let told = of_tag(unit, tag, &elsewhere);
                let columns = ids.columns.get(&number);
                for &TagId(id) in columns.map_or(std::slice::from_ref(id), |columns| &**columns) {
                    if TagId(id) == NOWHERE {
                        continue;
                    }
                    let known = known[id as usize].get_or_insert_default();
                    known.is_declared |= told.is_declared;
                    known.is_written |= told.is_written;
                    known.is_written_elsewhere |= told.is_written_elsewhere;
                }
            }
        }
    }
    let by_parts = written_by_parts(program);
    for (tag, known) in program.tags.iter_mut().zip(&known) {
        let is_written = |known: &Known| known.is_written || by_parts.contains(&Name::new(&tag.name));
        let is_free = known.is_some_and(|known| {
            known.is_written_elsewhere || (!known.is_declared && !is_written(&known) && is_elementary(tag.ty))
        });
        tag.is_input = !tag.constant && tag.block.is_none() && (tag.role == Role::Input || is_free);
    }
    mark_insides(program);
}

/// The state of a block that something else runs, too, may be any.
fn mark_insides(program: &mut Program) {
    // An instance is before those that are in it.
    for instance in &program.instances {
        if program.tags[instance.tag.0 as usize].is_input {
            for (_, inside) in &instance.tags {
                let tag = &mut program.tags[inside.0 as usize];
                tag.is_input = !tag.constant;
            }
        }
    }
}

/// The tags that the lists of unread parts name, but for those of their own.
fn written_by_parts(program: &Program) -> FxHashSet<Name> {
    let mut written = FxHashSet::default();
    for (number, _, part) in program.unread_parts() {
        let own = program.tags.iter().filter(|tag| tag.block == Some(number));
        let own: FxHashSet<Name> = own.map(|tag| Name::new(root_of(&tag.name))).collect();
        let names = listed(part).into_iter().flatten();
        written.extend(names.filter(|name| !own.contains(name)));
    }
    written
}

/// The tags of the list of an unread part. None: it has no list.
fn listed(part: &Unread) -> Option<impl Iterator<Item = Name>> {
    let paths = part.directive.writes.as_ref()?.iter();
    Some(paths.map(|path| Name::new(root_of(path))))
}

const fn is_elementary(ty: Type) -> bool {
    matches!(ty, Type::Scalar(_))
}

fn of_tag(unit: &Unit<'_>, tag: &TagFacts, elsewhere: &Elsewhere) -> Known {
    let is_own = |origin| !matches!(origin, Origin::Form | Origin::Undeclared | Origin::Shared);
    let mut uses = unit.context.uses(tag);
    Known {
        is_declared: is_own(tag.origin) || tag.cold.foreign.is_some(),
        is_written: uses
            .any(|place| place.access.writes() && unit.reaches(unit.context.bodies[place.network])),
        is_written_elsewhere: is_global(tag)
            && (elsewhere.all
                || (!elsewhere.names.is_empty() && elsewhere.names.contains(&Name::new(&tag.name)))),
    }
}

/// VAR_GLOBAL tags.
#[derive(Debug, Default)]
struct Elsewhere {
    names: FxHashSet<Name>,
    /// An unread part without a list is there.
    all: bool,
}

/// What something writes that a program of these units does not run, or that other programs run, too.
fn written_elsewhere(units: &[Unit<'_>]) -> Elsewhere {
    let mut written = Elsewhere::default();
    let Some(others) = units.first().map(|unit| &unit.context.others) else {
        return written;
    };
    if !others.have_globals() {
        return written;
    }
    let by_name: FxHashMap<&str, usize> = units.iter().enumerate().map(|(n, unit)| (unit.name, n)).collect();
    let mut open: Vec<(usize, Body)> = Vec::new();
    for file in others.files().filter(|file| !by_name.contains_key(&*file.file)) {
        let tags = file.outward.tags.iter().filter(|(_, used)| used.written);
        written.names.extend(tags.map(|(name, _)| name.clone()));
        written.all |= file.outward.all_tags.written;
        for (number, unit) in units.iter().enumerate() {
            let functions = unit.context.functions.iter().enumerate();
            let called = functions.filter(|(_, function)| file.outward.calls.contains(&function.key));
            open.extend(called.map(|(item, _)| (number, Body::Function(item))));
            let blocks = unit.context.user_blocks[..unit.context.own_blocks]
                .iter()
                .enumerate();
            let used = blocks.filter(|(_, block)| file.outward.blocks.contains_key(&block.key));
            open.extend(used.map(|(item, _)| (number, Body::Block(item))));
        }
    }
    for (number, unit) in units.iter().enumerate() {
        let bodies: FxHashSet<Body> = unit.context.bodies.iter().copied().collect();
        let unreached = bodies.into_iter().filter(|body| !unit.reaches(*body));
        open.extend(unreached.map(|body| (number, body)));
    }
    if open.is_empty() {
        return written;
    }
    let uses: Vec<_> = units.iter().map(|unit| targets(unit.context)).collect();
    let mut run: FxHashSet<(usize, Body)> = FxHashSet::default();
    while let Some((number, body)) = open.pop() {
        if !run.insert((number, body)) {
            continue;
        }
        for target in uses[number].get(&body).into_iter().flatten() {
            let there = |file: &str| by_name.get(file).copied();
            open.extend(match target {
                Target::Own(body) => Some((number, *body)),
                Target::Function(import) => {
                    there(&import.file).map(|file| (file, Body::Function(import.item)))
                }
                Target::Block(import) => there(&import.file).map(|file| (file, Body::Block(import.item))),
            });
        }
    }
    let blocks = run.iter().filter_map(|(number, body)| match body {
        Body::Block(item) => units[*number].context.user_blocks[*item].unread.as_deref(),
        _ => None,
    });
    for part in blocks {
        match listed(part) {
            Some(names) => written.names.extend(names),
            None => written.all = true,
        }
    }
    for (number, unit) in units.iter().enumerate() {
        let context = unit.context;
        let globals = context.scopes.iter().flat_map(|scope| &scope.tags);
        for tag in globals.filter(|tag| is_global(tag)) {
            let mut uses = context.uses(tag);
            let writes = |network: usize, access: Access| {
                access.writes() && run.contains(&(number, context.bodies[network]))
            };
            if uses.any(|place| writes(place.network, place.access)) {
                written.names.insert(Name::new(&tag.name));
            }
        }
    }
    written
}
