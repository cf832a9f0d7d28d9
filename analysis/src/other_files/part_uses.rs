//! Which files use members of structures, and copy whole ones: for the rules about members that nobody uses. Found when it is first
//! asked for, for all files together.

use super::exports::Exports;
use super::outward::TagUse;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// How files use the parts of structures, each file by its number.
#[derive(Debug, Default)]
pub(super) struct PartUses {
    /// The members of declared structures, of whichever structure.
    pub(super) members: FxHashMap<Name, Vec<(u32, TagUse)>>,
    /// The files that may copy a whole structure of a type, also in another one.
    pub(super) copied: FxHashMap<Name, Vec<u32>>,
}

impl PartUses {
    pub(super) fn of(files: &[Arc<Exports>]) -> PartUses {
        let mut uses = PartUses::default();
        // The types that are in a type, and the types of tags.
        let mut inner: FxHashMap<&Name, Vec<Name>> = FxHashMap::default();
        let mut globals: FxHashMap<&Name, Vec<Name>> = FxHashMap::default();
        for file in files {
            for ty in &file.types {
                ty.declared.spec.each_member(&mut |member| {
                    uses.members.entry(Name::new(&member.name)).or_default();
                });
                let inside = inner.entry(&ty.key).or_default();
                ty.declared
                    .spec
                    .each_name(&mut |name, _| inside.push(Name::new(name)));
            }
            for global in &file.globals {
                if let Some(declared) = &global.declared {
                    let types = globals.entry(&global.key).or_default();
                    declared
                        .spec
                        .each_name(&mut |name, _| types.push(Name::new(name)));
                }
            }
        }
        for (number, file) in (0..).zip(files) {
            for (name, used) in &file.outward.members {
                if let Some(entry) = uses.members.get_mut(name) {
                    entry.push((number, *used));
                }
            }
            if file.outward.wholes.is_empty() {
                continue;
            }
            let of_globals = file
                .outward
                .wholes
                .iter()
                .filter_map(|name| globals.get(name))
                .flatten();
            let mut open: Vec<&Name> = file.mentioned_types.iter().chain(of_globals).collect();
            let mut seen = FxHashSet::default();
            while let Some(ty) = open.pop() {
                if let Some(inside) = inner.get(ty).filter(|_| seen.insert(ty)) {
                    open.extend(inside);
                    uses.copied.entry(ty.clone()).or_default().push(number);
                }
            }
        }
        uses
    }
}
