//! Tags that several scopes share: VAR_GLOBAL tags, of the file or of another one, and direct addresses.
//!
//! A scope knows a shared tag under an entry of its own, which leads to the tag itself; types, constants and uses
//! are those of the tag. A tag of another file has one entry in this file's own scope, to which all others lead.

use crate::context::Context;
use crate::declarations::DeclaredAt;
use crate::diagnostic::Diagnostic;
use crate::exports::{Exports, Global};
use crate::mistakes::shared_globals;
use crate::rare::{Lead, Rare, RareFacts};
use crate::scope::{Origin, SectionKind, TagFacts, Uses};
use crate::uses;
use crate::wrong_globals::WrongGlobals;
use ladder_syntax::{Name, TextRange};
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// A scope and a tag in it.
type Entry = (usize, usize);

/// Leads what is shared to where it is declared. To be done when all uses are known, before types are inferred.
/// Gives what does not agree.
pub(crate) fn share(context: &mut Context) -> WrongGlobals {
    let mut found = Vec::new();
    let mut names = FxHashSet::default();
    check_and_lead(context, &mut found, &mut names);
    WrongGlobals::new(found, names, context)
}

/// The same. What does not agree goes to `out`, and the names of the tags that this is about to `names`.
fn check_and_lead(context: &mut Context, out: &mut Vec<Diagnostic>, names: &mut FxHashSet<Name>) {
    let mut globals: FxHashMap<Name, Entry> = FxHashMap::default();
    let mut external = false;
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (tag, facts) in facts.unusual() {
            match facts.origin {
                Origin::Declared(SectionKind::Global) => {
                    let key = Name::new(&facts.name);
                    let before = out.len();
                    shared_globals::check_declared(context, facts, globals.get(&key), out);
                    if out.len() > before {
                        names.insert(key.clone());
                    }
                    globals.entry(key).or_insert((scope, tag));
                }
                Origin::Declared(SectionKind::External) => external = true,
                _ => {}
            }
        }
    }
    let others = context.others.clone();
    if context.scopes.len() == 1 && !external && !others.have_globals() {
        return;
    }
    let mut imported: FxHashMap<Name, Entry> = FxHashMap::default();
    for scope in 0..context.scopes.len() {
        let unusual: Vec<usize> = context.scopes[scope].unusual().map(|(tag, _)| tag).collect();
        for tag in unusual {
            let facts = &context.scopes[scope].tags[tag];
            let key = Name::new(&facts.name);
            let before = out.len();
            let is_external = facts.origin == Origin::Declared(SectionKind::External);
            let external = is_external.then(|| facts.clone());
            let target = match facts.origin {
                // An address is one tag for the whole file.
                Origin::Form if facts.rare.address.is_some() => {
                    (scope > 0).then(|| of_file(context, scope, tag))
                }
                // A block may introduce a tag that the file declares as well.
                Origin::Declared(SectionKind::Global) => globals.get(&key).copied(),
                Origin::Undeclared | Origin::Form | Origin::Declared(SectionKind::External) => {
                    match (globals.get(&key), others.globals(&key).next()) {
                        (Some(&own), _) => Some(own),
                        (None, Some((file, global))) => {
                            let agree =
                                shared_globals::check_others(context, facts, &others, file, global, out);
                            let entry = import(context, &mut imported, (scope, tag), file, global);
                            context.scopes[entry.0].tags[entry.1].mistyped |= !agree;
                            Some(entry)
                        }
                        (None, None) => None,
                    }
                }
                _ => None,
            };
            let mut agrees = true;
            if let Some(external) = external {
                let global = target.map(|(scope, tag)| &context.scopes[scope].tags[tag]);
                agrees = shared_globals::check_external(context, &external, global, out);
            }
            if out.len() > before {
                names.insert(key);
            }
            if let Some(target) = target.filter(|target| *target != (scope, tag)) {
                lead(context, (scope, tag), target);
            }
            context.scopes[scope].tags[tag].mistyped |= !agrees;
        }
    }
}

/// The file's entry for a global of another file.
fn import(
    context: &mut Context,
    imported: &mut FxHashMap<Name, Entry>,
    (scope, tag): Entry,
    file: &Exports,
    global: &Global,
) -> Entry {
    if let Some(&entry) = imported.get(&global.key) {
        return entry;
    }
    let used = &context.scopes[scope].tags[tag];
    let facts = imported_tag(file, global);
    let entry = if scope == 0 && used.is_declared() {
        // What it is declares the other file; where this one does it in VAR_EXTERNAL.
        context.scopes[0].tags[tag] = TagFacts {
            origin: used.origin,
            declared_at: used.declared_at,
            uses: used.uses.clone(),
            ..facts
        };
        (0, tag)
    } else if scope == 0 {
        let uses = used.uses.clone();
        context.scopes[0].tags[tag] = TagFacts { uses, ..facts };
        (0, tag)
    } else {
        // Without a declaration it is where it is first used.
        let facts = TagFacts {
            declared_at: if used.is_declared() {
                used.declared_at
            } else {
                facts.declared_at
            },
            ..facts
        };
        // A tag of the file's own may have the name: it is still found by it.
        (0, context.scopes[0].add(facts))
    };
    imported.insert(global.key.clone(), entry);
    entry
}

/// A global of another file, before any use of it. It is where the file first uses it.
fn imported_tag(file: &Exports, global: &Global) -> TagFacts {
    TagFacts {
        name: global.name.as_str().into(),
        ty: global.ty,
        role: global.role,
        origin: Origin::Shared,
        mistyped: global.ty.is_none(),
        by_company: false,
        retain: global.retain,
        constant: global.constant,
        rare: Rare::from(RareFacts {
            initial: global.initial.clone(),
            address: global.address.clone(),
            foreign: Some(Arc::clone(&file.file)),
            ..RareFacts::NONE
        }),
        declared_at: DeclaredAt::in_file(TextRange::default()),
        uses: Uses::default(),
    }
}

/// A tag of the file that a name brings in which no declaration names: one of the file's own, or a global of another file.
/// None if files do not agree on it.
pub(crate) fn brought_in(context: &Context, name: &str) -> Option<TagFacts> {
    let tag = uses::undeclared(name, context.profile.law());
    if tag.rare.address.is_some() {
        return Some(tag);
    }
    let key = Name::new(name);
    let mut globals = context.others.globals(&key);
    let Some((file, global)) = globals.next() else {
        return Some(tag);
    };
    let agree = global.ty.is_some() && globals.all(|(_, other)| global.agrees(other));
    agree.then(|| imported_tag(file, global))
}

/// A tag that a name brings in in a body. None if it is one of several bodies or files.
pub(crate) fn brought_into_body(context: &Context, name: &str) -> Option<TagFacts> {
    let key = Name::new(name);
    let is_global = |tag: &TagFacts| tag.origin == Origin::Declared(SectionKind::Global);
    let is_of_all = context.find_tag(&(0, key.clone())).is_some_and(is_global)
        || context.others.globals(&key).next().is_some();
    let tag = uses::undeclared(name, context.profile.law());
    (!is_of_all && tag.rare.address.is_none()).then_some(tag)
}

/// The file's entry for an address that a body uses.
fn of_file(context: &mut Context, scope: usize, tag: usize) -> Entry {
    let facts = &context.scopes[scope].tags[tag];
    if let Some(found) = context.scopes[0].find(&Name::new(&facts.name)) {
        return (0, found);
    }
    let facts = TagFacts {
        uses: Uses::default(),
        ..facts.clone()
    };
    (0, context.scopes[0].add(facts))
}

fn lead(context: &mut Context, from: Entry, to: Entry) {
    let name = Name::new(&context.scopes[from.0].tags[from.1].name);
    let lead = match to {
        (0, tag) if context.scopes[0].find(&name) == Some(tag) => Lead::Named(name),
        (scope, tag) => Lead::Entry(scope, tag),
    };
    let target = &context.scopes[to.0].tags[to.1];
    let (ty, role, constant, retain, mistyped) = (
        target.ty,
        target.role,
        target.constant,
        target.retain,
        target.mistyped,
    );
    let foreign = target.rare.foreign.clone();
    let entry = &mut context.scopes[from.0].tags[from.1];
    entry.rare.lead = Some(lead);
    if !entry.is_declared() {
        entry.origin = Origin::Shared;
    }
    (
        entry.ty,
        entry.role,
        entry.constant,
        entry.retain,
        entry.mistyped,
        entry.rare.foreign,
    ) = (ty, role, constant, retain, mistyped, foreign);
    let uses = entry.uses.clone();
    context.scopes[to.0].tags[to.1].uses.0.extend(uses.0);
}
