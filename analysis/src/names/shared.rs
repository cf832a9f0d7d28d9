//! Tags that several scopes share: VAR_GLOBAL tags, of the file or of another one, and direct addresses.
//!
//! A scope knows a shared tag under an entry of its own, which leads to the tag itself; types, constants and uses
//! are those of the tag. A tag of another file has one entry in this file's own scope, to which all others lead.

use super::named_types::NamedTypes;
use super::problem::{Differs, InFile, NameProblem};
use super::scope::{Entry, Origin, SectionKind, TagFacts};
use crate::names::cold::{Cold, ColdFacts};
use crate::names::context::Context;
use crate::networks::use_place::Uses;
use crate::other_files::exports::{Exports, Global, is_one_address};
use crate::values::types::Type;
use crate::values::value::Value;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Leads what is shared to where it is declared. To be done when all uses are known, before types are inferred. What does not
/// agree goes to the problems of the context.
pub(crate) fn share(context: &mut Context) {
    let mut types = std::mem::take(&mut context.types);
    let mut globals: FxHashMap<Name, Entry> = FxHashMap::default();
    let mut problems = Vec::new();
    let mut external = false;
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (tag, facts) in facts.unusual() {
            match facts.origin {
                Origin::Declared(SectionKind::Global) => {
                    let key = Name::new(&facts.name);
                    declared_otherwise(
                        context,
                        (scope, tag),
                        globals.get(&key),
                        &mut types,
                        &mut problems,
                    );
                    globals.entry(key).or_insert((scope, tag));
                }
                Origin::Declared(SectionKind::External) => external = true,
                _ => {}
            }
        }
    }
    let others = context.others.clone();
    if context.scopes.len() > 1 || external || others.have_globals() {
        let mut imported: FxHashMap<Name, Entry> = FxHashMap::default();
        for scope in 0..context.scopes.len() {
            let unusual: Vec<usize> = context.scopes[scope].unusual().map(|(tag, _)| tag).collect();
            for tag in unusual {
                share_tag(
                    context,
                    (scope, tag),
                    &globals,
                    &mut imported,
                    &mut types,
                    &mut problems,
                );
            }
        }
    }
    context.problems.extend(problems);
    context.types = types;
}

/// The type and the initial values of a global of another file, as this file sees its types.
fn meaning(file: &Exports, global: &Global, types: &mut NamedTypes) -> (Option<Type>, Vec<Value>) {
    let Some(declared) = &global.declared else {
        return (global.ty, global.initial.clone());
    };
    match types.meaning_in(declared, &file.file) {
        Some((ty, initial)) => (Some(ty), initial.map_or_else(Vec::new, |values| values.to_vec())),
        None => (None, Vec::new()),
    }
}

/// Leads a tag to where it is declared, if that is elsewhere.
fn share_tag(
    context: &mut Context,
    entry: Entry,
    globals: &FxHashMap<Name, Entry>,
    imported: &mut FxHashMap<Name, Entry>,
    types: &mut NamedTypes,
    problems: &mut Vec<NameProblem>,
) {
    let (scope, tag) = entry;
    let facts = &context.scopes[scope].tags[tag];
    let key = Name::new(&facts.name);
    let is_external = facts.origin == Origin::Declared(SectionKind::External);
    let external = is_external.then(|| facts.clone());
    let target = match facts.origin {
        // An address is one tag for the whole file.
        Origin::Form if facts.cold.address.is_some() => (scope > 0).then(|| of_file(context, scope, tag)),
        // A block may introduce a tag that the file declares as well.
        Origin::Declared(SectionKind::Global) => globals.get(&key).copied(),
        Origin::Undeclared | Origin::Form | Origin::Declared(SectionKind::External) => {
            globals.get(&key).copied().or_else(|| {
                let others = context.others.clone();
                let (file, global) = others.globals(&key).next()?;
                let differing = others.globals(&key).find(|(_, other)| !global.agrees(other));
                if let Some((second, other)) = differing {
                    problems.push(NameProblem::FilesDiffer {
                        tag: entry,
                        first: in_file(file, global),
                        second: in_file(second, other),
                    });
                }
                let entry = import(context, imported, entry, (file, global), types);
                context.scopes[entry.0].tags[entry.1].mistyped |= differing.is_some();
                Some(entry)
            })
        }
        _ => None,
    };
    let agrees = external.is_none_or(|external| {
        let problem = match target {
            None => Some(NameProblem::NoGlobal { tag: entry }),
            Some(global) => external_otherwise(context, &external, global),
        };
        let agrees = problem.is_none();
        problems.extend(problem);
        agrees
    });
    if let Some(target) = target.filter(|target| *target != entry) {
        make_alias(context, entry, target);
    }
    context.scopes[scope].tags[tag].mistyped |= !agrees;
}

/// Notes where a VAR_GLOBAL declaration of the file does not agree with the one before it, and with that of another file.
fn declared_otherwise(
    context: &Context,
    entry: Entry,
    first: Option<&Entry>,
    types: &mut NamedTypes,
    problems: &mut Vec<NameProblem>,
) {
    let tag = &context.scopes[entry.0].tags[entry.1];
    if let Some(&first) = first {
        let other = &context.scopes[first.0].tags[first.1];
        let differs = difference(tag, other.ty, &other.cold.initial, other.cold.address.as_deref());
        if let Some(differs) = differs.filter(|_| !other.mistyped) {
            problems.push(NameProblem::GlobalOtherwise {
                tag: entry,
                first,
                differs,
            });
        }
    }
    let key = Name::new(&tag.name);
    let otherwise = context.others.globals(&key).find_map(|(file, global)| {
        let (ty, initial) = meaning(file, global, types);
        let differs = difference(tag, ty, &initial, global.address.as_deref());
        Some((in_file(file, global), differs.filter(|_| ty.is_some())?))
    });
    if let Some((other, differs)) = otherwise {
        problems.push(NameProblem::OtherwiseInFile {
            tag: entry,
            other,
            differs,
        });
    }
}

fn in_file(file: &Exports, global: &Global) -> InFile {
    InFile {
        file: Arc::clone(&file.file),
        global: global.clone(),
    }
}

/// What another declaration of a tag says otherwise.
fn difference(tag: &TagFacts, ty: Option<Type>, initial: &[Value], address: Option<&str>) -> Option<Differs> {
    if tag.mistyped {
        return None;
    }
    if tag.ty != ty {
        return Some(Differs::Type);
    }
    if *tag.cold.initial != *initial {
        return Some(Differs::Value);
    }
    (!is_one_address(tag.cold.address.as_deref(), address)).then_some(Differs::Address)
}

/// A VAR_EXTERNAL declaration that does not agree in type with its global.
fn external_otherwise(context: &Context, external: &TagFacts, global: Entry) -> Option<NameProblem> {
    let facts = &context.scopes[global.0].tags[global.1];
    let agrees = external.mistyped || facts.mistyped || external.ty == facts.ty;
    (!agrees).then(|| NameProblem::ExternalOtherwise {
        name: external.name.clone(),
        at: external.declared_at,
        ty: external.ty,
        global,
    })
}

/// The file's entry for a global of another file.
fn import(
    context: &mut Context,
    imported: &mut FxHashMap<Name, Entry>,
    (scope, tag): Entry,
    (file, global): (&Exports, &Global),
    types: &mut NamedTypes,
) -> Entry {
    if let Some(&entry) = imported.get(&global.key) {
        return entry;
    }
    let used = &context.scopes[scope].tags[tag];
    let facts = imported_tag(file, global, types);
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
fn imported_tag(file: &Exports, global: &Global, types: &mut NamedTypes) -> TagFacts {
    let (ty, initial) = meaning(file, global, types);
    TagFacts {
        name: global.name.as_str().into(),
        ty,
        role: global.role,
        origin: Origin::Shared,
        mistyped: ty.is_none(),
        retain: global.retain,
        constant: global.constant,
        cold: Cold::from(ColdFacts {
            initial,
            declared: global.declared.clone(),
            address: global.address.clone(),
            foreign: Some(Arc::clone(&file.file)),
            ..ColdFacts::NONE
        }),
        declared_at: TextRange::default(),
        uses: Uses::default(),
    }
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

fn make_alias(context: &mut Context, from: Entry, to: Entry) {
    let target = &context.scopes[to.0].tags[to.1];
    let (ty, role, constant, retain, mistyped) = (
        target.ty,
        target.role,
        target.constant,
        target.retain,
        target.mistyped,
    );
    let foreign = target.cold.foreign.clone();
    let entry = &mut context.scopes[from.0].tags[from.1];
    entry.cold.alias_of = Some(to);
    if !entry.is_declared() {
        entry.origin = Origin::Shared;
    }
    (
        entry.ty,
        entry.role,
        entry.constant,
        entry.retain,
        entry.mistyped,
        entry.cold.foreign,
    ) = (ty, role, constant, retain, mistyped, foreign);
    let uses = entry.uses.clone();
    context.scopes[to.0].tags[to.1].uses.0.extend(uses.0);
}
