//! The tags of a text behind an edit of lines that declare some.
//!
//! What these lines declare takes the place of what they declared before, and every line below is some bytes further
//! down. A name that is declared no more is one that is only used, and the other way round.

use super::lines::Lines;
use super::names::{place_found, spelled_at, typed};
use super::tags::EditedTags;
use crate::context::Context;
use crate::declarations::Declarations;
use crate::declare::{self, Around};
use crate::infer;
use crate::misdeclared::Misdeclared;
use crate::scope::{Origin, Scope, SectionKind, TagFacts};
use crate::shared;
use crate::tags::Tags;
use ladder_syntax::{Line, LineKind, Mode, Name, Parse, TextRange, TextSize, Trees};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// An edit of more lines is not followed one by one.
const MOST_LINES: usize = 64;

/// Whether an edit has exchanged lines of declarations, and the blank and comment lines among them, few enough to be
/// followed one by one.
pub(crate) fn are_lines_of(before: &Context, lines: &Lines, new: &ladder_syntax::FileLines) -> bool {
    let old = before.parse.lines();
    let is_in_section = |line: &Line| {
        line.mode_after == Mode::Section
            && match line.kind {
                LineKind::Blank | LineKind::Comment => true,
                // Nothing else is on the line behind it.
                LineKind::Declaration => line.line_ends > 0,
                _ => false,
            }
    };
    let above = lines.old.start.checked_sub(1).map(|above| &old[above]);
    above.is_some_and(|above| above.mode_after == Mode::Section && above.line_ends > 0)
        && lines.old.len().max(lines.new.len()) <= MOST_LINES
        && old.range(lines.old.clone()).all(is_in_section)
        && new.range(lines.new.clone()).all(is_in_section)
}

/// Some lines of declarations, one below the other, that are read again.
struct Lot {
    /// Which they are among the lines of declarations before the edit, and behind it.
    old: Range<usize>,
    new: Range<usize>,
    /// The tags that they declared.
    tags: Range<usize>,
    /// How many they declare now.
    declares: usize,
}

/// Enters what the lines of an edit declare now. Gives the tags that this concerns; none if it takes more than that.
pub(crate) fn enter(context: &mut Context, before: &Context, lines: &Lines) -> Option<EditedTags> {
    let parse = Arc::clone(&context.parse);
    let start = before.parse.line_start(lines.old.start);
    let end = before.parse.line_start(lines.old.end);
    let mut declarations = Declarations::clone(&before.declarations);
    let numbers = lines.new.clone();
    let declares = |line: &usize| parse.lines()[*line].kind == LineKind::Declaration;
    let starts = numbers.filter(declares).map(|line| parse.line_start(line).into());
    let starts: Vec<u32> = starts.collect();
    let old = declarations.count_before(start)..declarations.count_before(end);
    let new = old.start..old.start + starts.len();
    declarations.exchange(old.clone(), starts, lines.added_bytes);
    let mut trees = Trees::default();
    let (mut lots, names) = lots(before, (&parse, &declarations), (old, new), &mut trees)?;
    let mut is_global = around(&parse, lines.new.start)?.kind == SectionKind::Global;
    let mut wrong = Misdeclared::default();
    let mut now = Scope::default();
    for lot in &mut lots {
        let first = now.tags.len();
        for index in lot.new.clone() {
            let number = parse.line_at(declarations.start(index))?;
            let around = around(&parse, number)?;
            is_global |= around.kind == SectionKind::Global;
            let line = (&parse.lines()[number], &mut trees);
            declare::line(line, declarations.number(index), around, &mut now, &mut wrong);
        }
        lot.declares = now.tags.len() - first;
    }
    let old: Vec<usize> = lots.iter().flat_map(|lot| lot.tags.clone()).collect();
    let in_bodies = |name: &Name| before.named_in_bodies.contains(name);
    if !have_addresses_of_their_own(before, &old, &now.tags) || names.iter().any(in_bodies) {
        return None;
    }
    if is_global {
        // All files that declare such a tag must agree.
        let elsewhere = |name: &Name| context.others.globals(name).next().is_some();
        if names.iter().any(elsewhere) {
            return None;
        }
        context.globals = OnceLock::new();
    }
    let gone = lots.iter().flat_map(|lot| lot.old.clone());
    let gone: Vec<u32> = gone.map(|line| before.declarations.number(line)).collect();
    context.misdeclared.exchange(&gone, &names, wrong);
    context.declarations = Arc::new(declarations);
    context.declared_to = context.declared_to.wrapping_add_signed(lines.added);
    move_blocks(context, before, lines);
    exchange(context, lots, now.tags.iter().cloned())
}

/// Whether an address that one of these tags has, by its place among the declared tags or as it is declared now, has no other name
/// and is named by no rung: then it comes and goes with its tag.
fn have_addresses_of_their_own(before: &Context, old: &[usize], new: &Tags) -> bool {
    let file = &before.scopes[0];
    let old_tags = || old.iter().map(|tag| &file.tags[*tag]);
    let mut addresses = old_tags().chain(new).filter_map(TagFacts::address).peekable();
    if addresses.peek().is_none() {
        return true;
    }
    let is_shared =
        |address: Name| before.at_address.has_several(&address) || before.named_in_bodies.contains(&address);
    if addresses.any(is_shared) {
        return false;
    }
    let is_named = |tag: &TagFacts| {
        let mut places = tag.uses.0.iter();
        tag.rare.address.is_some() && places.any(|place| spelled_at(before, *place).starts_with('%'))
    };
    if old_tags().any(is_named) {
        return false;
    }
    let mut declared = FxHashSet::default();
    new.iter().filter_map(TagFacts::address).all(|address| {
        let is_free = file.find(&address).is_none_or(|tag| old.contains(&tag));
        is_free && declared.insert(address)
    })
}

/// What is around a line of declarations, if an edit of it is followed.
fn around(parse: &Parse, line: usize) -> Option<Around> {
    let mut sections = parse.frame().sections.iter().rev();
    let section = sections.find(|section| section.lines.start < line)?;
    let around = declare::around(parse, section)?;
    let is_followed = matches!(
        around.kind,
        SectionKind::Var | SectionKind::Input | SectionKind::Output | SectionKind::Global
    );
    (is_followed && !around.in_block).then_some(around)
}

/// The lines to read again, from top to bottom: those of an edit, and all others that declare one of their names, for it is the
/// first of them that counts. And all names on these lines. None if these are too many.
fn lots(
    before: &Context,
    (parse, declarations): (&Parse, &Declarations),
    (old, new): (Range<usize>, Range<usize>),
    trees: &mut Trees,
) -> Option<(Vec<Lot>, FxHashSet<Name>)> {
    let scope = &before.scopes[0];
    let was = &before.declarations;
    let mut next: Vec<Name> = Vec::new();
    let mut names_on = |next: &mut Vec<Name>, parse: &Parse, start: TextSize| {
        let line = parse.line_at(start)?;
        next.extend(declare::names(&parse.lines()[line], trees));
        Some(())
    };
    for index in old.clone() {
        names_on(&mut next, &before.parse, was.start(index))?;
    }
    for index in new.clone() {
        names_on(&mut next, parse, declarations.start(index))?;
    }
    let mut lots: Vec<(Range<usize>, Range<usize>)> = vec![(old.clone(), new.clone())];
    let mut names: FxHashSet<Name> = FxHashSet::default();
    while let Some(name) = next.pop() {
        if !names.insert(name.clone()) {
            continue;
        }
        let first = scope.find(&name).filter(|tag| *tag < scope.declared);
        let first = first.and_then(|tag| scope.tags[tag].declared_at.line);
        for line in first.iter().chain(before.misdeclared.lines_repeating(&name)) {
            let index = was.index(*line)?;
            if lots.iter().any(|(lot, _)| lot.contains(&index)) {
                continue;
            }
            let now = if index < old.end {
                index
            } else {
                index - old.end + new.end
            };
            lots.push((index..index + 1, now..now + 1));
            names_on(&mut next, parse, declarations.start(now))?;
        }
        if lots.len() > MOST_LINES {
            return None;
        }
    }
    lots.sort_unstable_by_key(|(_, new)| (new.start, new.end));
    let lot = |(old, new): (Range<usize>, Range<usize>)| Lot {
        tags: tags_on(scope, was, old.clone()),
        old,
        new,
        declares: 0,
    };
    Some((lots.into_iter().map(lot).collect(), names))
}

/// Moves what is declared below an edit of networks. None if other lines of declarations than before are above all networks.
pub(crate) fn move_declared(context: &mut Context, before: &Context, lines: &Lines) -> Option<()> {
    if lines.old.end >= before.declared_to {
        return Some(());
    }
    let mut declarations = Declarations::clone(&before.declarations);
    let below = declarations.count_before(before.parse.line_start(lines.old.end));
    declarations.exchange(below..below, Vec::new(), lines.added_bytes);
    context.declarations = Arc::new(declarations);
    context.declared_to = context.declared_to.wrapping_add_signed(lines.added);
    move_blocks(context, before, lines);
    let above_all = |context: &Context| {
        let first = context.networks.first()?;
        Some(context.declarations.count_before(first.range.start()))
    };
    (above_all(context) == above_all(before)).then_some(())
}

/// Moves the first lines of block definitions below an edit, and with them the tags that each block has unasked.
fn move_blocks(context: &mut Context, before: &Context, lines: &Lines) {
    let end = before.parse.line_start(lines.old.end);
    let shift = |range: &mut TextRange| {
        let to = |at: TextSize| TextSize::new(u32::from(at).wrapping_add_signed(lines.added_bytes as i32));
        if range.start() >= end {
            *range = TextRange::new(to(range.start()), to(range.end()));
        }
    };
    for block in &mut context.user_blocks[..before.own_blocks] {
        shift(&mut block.at);
    }
    for scope in &mut context.scopes[1..] {
        let is_unasked = |tag: &TagFacts| tag.origin == Origin::Implicit;
        for tag in 0..scope.tags.iter().take_while(|tag| is_unasked(tag)).count() {
            if scope.tags[tag].declared_at.range.start() >= end {
                shift(&mut scope.tags[tag].declared_at.range);
            }
        }
    }
}

/// The tags that some lines of the file's own declarations declare.
fn tags_on(scope: &Scope, declarations: &Declarations, lines: Range<usize>) -> Range<usize> {
    let first_from = |first: usize| {
        let is_above = |tag: usize| {
            let line = scope.tags[tag].declared_at.line;
            line.and_then(|line| declarations.index(line)) < Some(first)
        };
        let (mut low, mut high) = (0, scope.declared);
        while low < high {
            let middle = low.midpoint(high);
            if is_above(middle) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    };
    first_from(lines.start)..first_from(lines.end)
}

/// Puts the new tags in the place of the old ones.
fn exchange(
    context: &mut Context,
    lots: Vec<Lot>,
    mut declared: impl Iterator<Item = TagFacts>,
) -> Option<EditedTags> {
    let scope = &context.scopes[0];
    let mut edited = EditedTags::default();
    let old = lots.iter().flat_map(|lot| lot.tags.clone());
    let old_addresses: Vec<Name> = old.filter_map(|tag| scope.tags[tag].address()).collect();
    // The old ones, as long as no new one has their names.
    let mut gone: FxHashMap<Name, TagFacts> = FxHashMap::default();
    for tag in lots.iter().flat_map(|lot| lot.tags.clone()) {
        let old = &scope.tags[tag];
        let name = Name::new(&old.name);
        edited.used.push((0, name.clone()));
        gone.insert(name, old.clone());
    }
    let old_names: FxHashSet<Name> = gone.keys().cloned().collect();
    let mut comes: Vec<(Range<usize>, Vec<Arc<TagFacts>>)> = Vec::with_capacity(lots.len());
    let mut mistyped: Vec<(usize, Name)> = Vec::new();
    let mut no_more_found: FxHashSet<Name> = FxHashSet::default();
    // What is compared with a tag, or gets its value from it, may have no type but from it.
    let mut fresh: Vec<(usize, Name)> = Vec::new();
    for lot in lots {
        let mut declares = Vec::with_capacity(lot.declares);
        for mut new in declared.by_ref().take(lot.declares) {
            let name = Name::new(&new.name);
            let old = gone.remove(&name);
            if let Some(old) = &old {
                new.uses = old.uses.clone();
            } else if let Some(found) = scope.find(&name) {
                if found < scope.declared {
                    return None;
                }
                new.uses = scope.tags[found].uses.clone();
                no_more_found.insert(name.clone());
            }
            if new.ty.is_none() {
                new.ty = infer::answer(context, &new);
            }
            if !old.is_some_and(|old| says_the_same(&old, &new)) {
                edited.touched(&name);
                fresh.push((0, name.clone()));
            }
            if new.mistyped {
                mistyped.push((0, name));
            }
            declares.push(Arc::new(new));
        }
        comes.push((lot.tags, declares));
    }
    let mut found: Vec<Arc<TagFacts>> = Vec::new();
    for (name, old) in &gone {
        edited.touched(name);
        if let Some(first) = old.uses.0.first() {
            fresh.push((0, name.clone()));
            let tag = shared::brought_in(context, spelled_at(context, *first))?;
            let tag = TagFacts {
                uses: old.uses.clone(),
                ..tag
            };
            found.push(Arc::new(typed(context, 0, &tag)));
        }
    }
    let is_other = |name: &Name| old_names.contains(name) || no_more_found.contains(name);
    context
        .mistyped
        .retain(|(scope, name)| *scope > 0 || !is_other(name));
    context.mistyped.extend(mistyped);
    let networks = &context.networks;
    let scope = &mut context.scopes[0];
    if !found.is_empty() || !no_more_found.is_empty() {
        let gone: Vec<usize> = no_more_found.iter().filter_map(|name| scope.find(name)).collect();
        for tag in &gone {
            scope.tags[*tag].uses.0.clear();
        }
        place_found(scope, gone, found, networks);
    }
    for name in gone.into_keys().chain(old_addresses) {
        scope.rename(name, None);
    }
    // From below, so that the tags of the others stay where they are.
    let mut added = 0;
    for (tags, new) in comes.iter().rev() {
        added += new.len() as isize - tags.len() as isize;
        scope.exchange_declared(tags.clone(), new.clone());
    }
    for (tags, new) in comes.iter().rev() {
        added -= new.len() as isize - tags.len() as isize;
        for (tag, new) in (tags.start.wrapping_add_signed(added)..).zip(new) {
            scope.rename(Name::new(&new.name), Some(tag));
            if let Some(address) = new.address() {
                scope.rename(address, Some(tag));
            }
        }
    }
    edited.infer_again(context, &[], fresh)?;
    Some(edited)
}

/// Whether all that places of a tag depend on is as it was.
fn says_the_same(old: &TagFacts, new: &TagFacts) -> bool {
    let says = |tag: &TagFacts| {
        let declared = (tag.origin, tag.role, tag.retain, tag.constant);
        (tag.ty, tag.mistyped, declared)
    };
    old.name == new.name
        && says(old) == says(new)
        && old.rare.initial == new.rare.initial
        && old.rare.address == new.rare.address
}
