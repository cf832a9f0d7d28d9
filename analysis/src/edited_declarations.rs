//! The tags of a text behind an edit of lines that declare some.
//!
//! What these lines declare takes the place of what they declared before, and every line below is so many bytes further
//! down. A name that is declared no more is one that is only used, and the other way round.

use crate::context::Context;
use crate::declarations::Declarations;
use crate::declare;
use crate::edited::{EditedTags, place_found, spelled_at, typed};
use crate::edited_lines::Lines;
use crate::infer;
use crate::scope::{Origin, Scope, SectionKind, TagFacts};
use crate::shared;
use ladder_syntax::{Line, LineKind, Mode, Name, TextRange, TextSize, Trees};
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

/// Enters what the lines of an edit declare now. Gives the tags that this concerns; none if it takes more than that.
pub(crate) fn enter(context: &mut Context, before: &Context, lines: &Lines) -> Option<EditedTags> {
    let parse = &*context.parse;
    let start = before.parse.line_start(lines.old.start);
    if !before.declared_cleanly {
        return None;
    }
    let mut sections = parse.frame().sections.iter().rev();
    let section = sections.find(|section| section.lines.start < lines.new.start)?;
    let around = declare::around(parse, section)?;
    let is_plain_section = matches!(
        around.kind,
        SectionKind::Var | SectionKind::Input | SectionKind::Output | SectionKind::Global
    );
    if !is_plain_section || around.constant || section.block.is_some() {
        return None;
    }
    let numbers = lines.new.clone();
    let declares = |line: &usize| parse.lines()[*line].kind == LineKind::Declaration;
    let numbers: Vec<usize> = numbers.filter(declares).collect();
    let mut declarations = Declarations::clone(&before.declarations);
    let end = before.parse.line_start(lines.old.end);
    let old = declarations.count_before(start)..declarations.count_before(end);
    let tags = tags_on(&before.scopes[0], &declarations, old.clone());
    let starts = numbers.iter().map(|&line| parse.line_start(line).into());
    declarations.exchange(old.clone(), starts.collect(), lines.added_bytes);
    let mut now = Scope::default();
    let mut found = Vec::new();
    let mut trees = Trees::default();
    for (index, &line) in (old.start..).zip(&numbers) {
        let place = (declarations.number(index), parse.line_start(line));
        let line = (&parse.lines()[line], &mut trees);
        if !declare::line(line, place, around, (&declarations, &mut now), &mut found) {
            return None;
        }
    }
    let plain = |tag: &TagFacts| tag.rare.address.is_none() && tag.rare.shared.is_none();
    let is_plain = found.is_empty()
        && tags.clone().all(|tag| plain(&before.scopes[0].tags[tag]))
        && now.tags.iter().all(plain);
    if !is_plain {
        return None;
    }
    if around.kind == SectionKind::Global {
        // All files that declare such a tag must agree.
        let elsewhere = |tag: &TagFacts| context.others.globals(&Name::new(&tag.name)).next().is_some();
        let old = tags.clone().map(|tag| &before.scopes[0].tags[tag]);
        if old.chain(now.tags.iter()).any(elsewhere) {
            return None;
        }
        context.globals = OnceLock::new();
    }
    context.declarations = Arc::new(declarations);
    context.declared_to = context.declared_to.wrapping_add_signed(lines.added);
    move_blocks(context, before, lines);
    exchange(context, tags, now.tags.iter().cloned().collect())
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
fn exchange(context: &mut Context, tags: Range<usize>, new: Vec<TagFacts>) -> Option<EditedTags> {
    let scope = &context.scopes[0];
    let mut edited = EditedTags::default();
    // The old ones, as long as no new one has their names.
    let mut gone: FxHashMap<Name, TagFacts> = FxHashMap::default();
    for tag in tags.clone() {
        let old = &scope.tags[tag];
        let name = Name::new(&old.name);
        edited.used.push((0, name.clone()));
        gone.insert(name, old.clone());
    }
    let old_names: Vec<Name> = gone.keys().cloned().collect();
    let mut names: FxHashSet<Name> = FxHashSet::default();
    let mut comes: Vec<(Name, Arc<TagFacts>)> = Vec::new();
    let mut no_more_found: FxHashSet<Name> = FxHashSet::default();
    // What is compared with a tag, or gets its value from it, may have no type but from it.
    let mut fresh: Vec<(usize, Name)> = Vec::new();
    for mut new in new {
        let name = Name::new(&new.name);
        if !names.insert(name.clone()) {
            return None;
        }
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
        let says = |tag: &TagFacts| (tag.name.clone(), tag.ty, tag.mistyped, tag.rare.initial.clone());
        if old.as_ref().map(says) != Some(says(&new)) {
            edited.touched(&name);
            fresh.push((0, name.clone()));
        }
        comes.push((name, Arc::new(new)));
    }
    let mut found: Vec<Arc<TagFacts>> = Vec::new();
    for (name, old) in gone {
        edited.touched(&name);
        if let Some(first) = old.uses.0.first() {
            fresh.push((0, name));
            let tag = shared::brought_in(context, spelled_at(context, *first))?;
            let tag = TagFacts {
                uses: old.uses.clone(),
                ..tag
            };
            found.push(Arc::new(typed(context, &tag)));
        }
    }
    context
        .mistyped
        .retain(|(scope, name)| *scope > 0 || !old_names.contains(name));
    let mistyped = comes.iter().filter(|(_, tag)| tag.mistyped);
    let mistyped = mistyped.map(|(name, _)| (0, name.clone()));
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
    let (comes, new): (Vec<Name>, Vec<Arc<TagFacts>>) = comes.into_iter().unzip();
    scope.exchange_declared(tags.clone(), new);
    for name in old_names.into_iter().filter(|name| !names.contains(name)) {
        scope.rename(name, None);
    }
    for (tag, name) in (tags.start..).zip(comes) {
        scope.rename(name, Some(tag));
    }
    edited.infer_again(context, &[], fresh)?;
    Some(edited)
}
