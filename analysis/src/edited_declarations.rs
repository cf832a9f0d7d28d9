//! The tags of a text behind an edit of lines that declare some, where it adds and takes away no line and no name.
//!
//! What a line declares takes the place of what it declared before, and every line below it is so many bytes further down.
//! A name that is declared no more is one that is only used, and the other way round.

use crate::context::Context;
use crate::declarations::Declarations;
use crate::declare::{self, Around};
use crate::edited::{EditedTags, Lines, sort_found, spelled_at, typed};
use crate::scope::{Origin, Scope, SectionKind, TagFacts, Uses};
use crate::uses;
use ladder_syntax::{Line, LineKind, Mode, Name, TextSize, Trees};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use std::sync::Arc;

/// An edit of more lines is not followed one by one.
const MOST_LINES: usize = 16;

/// Whether an edit has exchanged some lines for as many others, few enough to be followed one by one.
pub(crate) fn is_short(lines: &Lines) -> bool {
    lines.old.len() == lines.new.len() && (1..=MOST_LINES).contains(&lines.old.len())
}

/// Whether lines of declarations took the place of others, all of them without mistakes.
pub(crate) fn are_lines_of<'l, I: Iterator<Item = &'l Line>>(
    old: impl Fn() -> I,
    new: impl Fn() -> I,
) -> bool {
    // Nothing else is on the line behind it.
    let is_whole = |line: &Line| {
        line.kind == LineKind::Declaration
            && line.mode_after == Mode::Section
            && line.errors.is_empty()
            && line.line_ends > 0
    };
    let pairs = || old().zip(new());
    pairs().all(|(old, new)| (is_whole(old) && is_whole(new)) || is_same_decoration(old, new))
        && pairs().any(|(old, _)| is_whole(old))
}

/// Whether both are the same line without a declaration, that was only read again.
fn is_same_decoration(old: &Line, new: &Line) -> bool {
    matches!(old.kind, LineKind::Blank | LineKind::Comment)
        && old.kind == new.kind
        && old.mode_after == new.mode_after
        && old.green() == new.green()
}

/// A line that declares something else than before.
struct Declared {
    /// Which of the file's tags are meant.
    tags: Range<usize>,
    /// What it declares now.
    new: Vec<TagFacts>,
}

/// Enters what the lines of an edit declare now. Gives the tags that this concerns; none if it takes more than that.
pub(crate) fn enter(context: &mut Context, before: &Context, lines: &Lines) -> Option<EditedTags> {
    let start = before.parse.line_start(lines.old.start);
    let mut blocks = before.user_blocks[..before.own_blocks].iter();
    if !before.declared_cleanly || !blocks.all(|block| block.at.end() <= start) {
        return None;
    }
    let mut declarations = Declarations::clone(&before.declarations);
    declarations.shift(before.parse.line_start(lines.old.end), lines.added_bytes);
    let mut declared = Vec::new();
    for (old, new) in lines.old.clone().zip(lines.new.clone()) {
        if before.parse.lines()[old].kind == LineKind::Declaration {
            let number = before.declarations.starting_at(before.parse.line_start(old))?;
            let start = context.parse.line_start(new);
            declarations.set(number, start);
            let place = (number, start);
            declared.push(line(
                &before.scopes[0],
                place,
                &context.parse.lines()[new],
                &declarations,
            )?);
        }
    }
    context.declarations = Arc::new(declarations);
    exchange(context, declared)
}

/// What a line of the file's own declarations declares now.
fn line(scope: &Scope, place: (u32, TextSize), line: &Line, declarations: &Declarations) -> Option<Declared> {
    let first_from = |number: u32| {
        let (mut low, mut high) = (0, scope.declared);
        while low < high {
            let middle = low.midpoint(high);
            if scope.tags[middle].declared_at.line < Some(number) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    };
    let tags = first_from(place.0)..first_from(place.0 + 1);
    let first = scope.tags.get(tags.start).filter(|_| !tags.is_empty())?;
    let Origin::Declared(kind @ (SectionKind::Var | SectionKind::Input | SectionKind::Output)) = first.origin
    else {
        return None;
    };
    let around = Around {
        kind,
        retain: first.retain,
        constant: first.constant,
        in_block: false,
    };
    let mut now = Scope::default();
    let mut found = Vec::new();
    declare::line(
        (line, &mut Trees::default()),
        place,
        around,
        (declarations, &mut now),
        &mut found,
    );
    let plain = |tag: &TagFacts| tag.address.is_none() && tag.ty.is_some() && !tag.mistyped && !tag.constant;
    let is_plain = found.is_empty()
        && now.tags.len() == tags.len()
        && tags.clone().all(|tag| plain(&scope.tags[tag]))
        && now.tags.iter().all(plain);
    is_plain.then(|| Declared {
        tags,
        new: now.tags.iter().cloned().collect(),
    })
}

/// Puts the new tags in the place of the old ones.
fn exchange(context: &mut Context, declared: Vec<Declared>) -> Option<EditedTags> {
    let law = context.profile.law();
    let scope = &context.scopes[0];
    let mut edited = EditedTags::default();
    // What the old ones are used for, as long as no new one has it.
    let mut uses: FxHashMap<Name, Uses> = FxHashMap::default();
    let mut is_other = false;
    for line in &declared {
        for (tag, new) in line.tags.clone().zip(&line.new) {
            let old = &scope.tags[tag];
            let name = Name::new(&old.name);
            edited.used.push((0, name.clone()));
            if (&old.name, old.ty, &old.initial) != (&new.name, new.ty, &new.initial) {
                edited.retyped.push((0, name.clone()));
                is_other |= old.ty != new.ty || name != Name::new(&new.name);
            }
            uses.insert(name, old.uses.clone());
        }
    }
    // What a tag is compared with, or gets its value from, may have no type but from it.
    if is_other && !context.typed_by_places {
        return None;
    }
    let mut names: FxHashSet<Name> = FxHashSet::default();
    let mut comes: Vec<(usize, Name, TagFacts)> = Vec::new();
    let mut no_more_found: FxHashSet<Name> = FxHashSet::default();
    let gone: Vec<Name> = uses.keys().cloned().collect();
    for line in declared {
        for (tag, mut new) in line.tags.zip(line.new) {
            let name = Name::new(&new.name);
            if !names.insert(name.clone()) {
                return None;
            }
            if let Some(uses) = uses.remove(&name) {
                new.uses = uses;
            } else if let Some(found) = scope.find(&name) {
                if found < scope.declared {
                    return None;
                }
                new.uses = scope.tags[found].uses.clone();
                no_more_found.insert(name.clone());
                edited.touched(&name);
            } else {
                edited.touched(&name);
            }
            comes.push((tag, name, new));
        }
    }
    let found = uses.into_iter().filter(|(_, uses)| !uses.is_empty());
    let found: Vec<Arc<TagFacts>> = found
        .map(|(_, uses)| {
            let name = spelled_at(context, uses.0[0]);
            let tag = TagFacts {
                uses,
                ..uses::undeclared(name, law)
            };
            typed(context, &tag).map(Arc::new)
        })
        .collect::<Option<_>>()?;
    let networks = &context.networks;
    let scope = &mut context.scopes[0];
    if !found.is_empty() || !no_more_found.is_empty() {
        scope.replace_found(|mut tags| {
            tags.retain(|tag| !no_more_found.contains(&Name::new(&tag.name)));
            tags.extend(found);
            sort_found(&mut tags, networks);
            tags
        });
    }
    for name in gone.into_iter().filter(|name| !names.contains(name)) {
        scope.rename(name, None);
    }
    for (index, name, tag) in comes {
        scope.rename(name, Some(index));
        scope.tags[index] = tag;
    }
    Some(edited)
}
