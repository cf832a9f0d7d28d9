//! Which names that one program alone has are names of one thing: those that have the same place in what is otherwise the same.

use super::Rename;
use super::words::{Identity, Word, block_of, flat, names, words};
use crate::outline::{Entry, Kind, Outline};
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Role;
use ladder_syntax::{Name, TextRange};
use rustc_hash::{FxHashMap, FxHashSet};
use similar::{Algorithm, DiffTag, capture_diff_slices};
use std::cell::OnceCell;
use std::sync::Arc;

/// Any body.
const ANYWHERE: &str = "\u{1}";

/// A word for each name that only one program has.
const ONLY_HERE: &str = "\u{1}";

/// How often a name is where another one is now.
#[derive(Default)]
struct Votes {
    with: FxHashMap<Identity, usize>,
    /// In how many entries it is.
    entries: usize,
    places: usize,
    kind: Option<&'static str>,
    written: String,
}

/// The names that became others, in the order of the old text.
pub(crate) fn found(old: &Outline, new: &Outline) -> Vec<Rename> {
    let (mut was, mut is) = (flat(&old.entries), flat(&new.entries));
    let same = take_same(&mut was, &mut is);
    let read = |outline: &Outline, entries: &[&Entry]| -> Vec<Vec<Word>> {
        entries.iter().map(|entry| words(outline, entry)).collect()
    };
    let (old_words, new_words) = (read(old, &was), read(new, &is));
    let (old_names, new_names) = (names(&old_words), names(&new_words));
    let (gone, added) = (
        same.without(&old_names, &new_names),
        same.without(&new_names, &old_names),
    );
    if gone.is_empty() || added.is_empty() {
        return Vec::new();
    }
    let (before, after) = (masked(&was, &old_words, &gone), masked(&is, &new_words, &added));
    let mut votes: FxHashMap<&Identity, Votes> = FxHashMap::default();
    let mut order: Vec<&Identity> = Vec::new();
    for entry in &before {
        let mut here: FxHashSet<&Identity> = FxHashSet::default();
        for (identity, at) in &entry.names {
            let vote = votes.entry(*identity).or_default();
            vote.places += 1;
            if here.insert(*identity) {
                vote.entries += 1;
            }
            vote.kind = vote.kind.or_else(|| kind(old, entry.entry, identity));
            if vote.places == 1 {
                order.push(*identity);
                vote.written = old.text(*at).into_owned();
            }
        }
    }
    let mut back: FxHashMap<&Identity, FxHashSet<&Identity>> = FxHashMap::default();
    let mut written: FxHashMap<&Identity, TextRange> = FxHashMap::default();
    let keys =
        |entries: &[Masked<'_>]| -> Vec<String> { entries.iter().map(|entry| entry.key.clone()).collect() };
    for op in capture_diff_slices(Algorithm::Myers, &keys(&before), &keys(&after)) {
        if op.tag() != DiffTag::Equal {
            continue;
        }
        for (one, other) in before[op.old_range()].iter().zip(&after[op.new_range()]) {
            let mut here: FxHashSet<(&Identity, &Identity)> = FxHashSet::default();
            for ((was, _), (is, at)) in one.names.iter().zip(&other.names) {
                back.entry(*is).or_default().insert(*was);
                written.entry(*is).or_insert(*at);
                if here.insert((*was, *is))
                    && let Some(votes) = votes.get_mut(was)
                {
                    *votes.with.entry((*is).clone()).or_default() += 1;
                }
            }
        }
    }
    let mut found: Vec<Rename> = Vec::new();
    for identity in order {
        let Some(votes) = votes.get(identity) else {
            continue;
        };
        let mut with = votes.with.iter();
        let (Some((is, count)), None) = (with.next(), with.next()) else {
            continue;
        };
        let is_one = back.get(is).is_some_and(|others| others.len() == 1);
        // Who writes another name at one place may mean another thing.
        let is_everywhere = votes.places > 1 && count * 2 >= votes.entries;
        if !is_one || !is_everywhere || identity.1 != is.1 || identity.2 == is.2 {
            continue;
        }
        let facts = [(old, identity), (new, is)].map(|(outline, of)| tag(outline, of));
        if !is_alike(facts) {
            continue;
        }
        let Some(at) = written.get(is) else { continue };
        // A block has its new name before what is in it.
        let scope = Arc::clone(&is.0);
        if identity.0 != scope && !found.iter().any(|rename| rename.is_from(&identity.0, &scope)) {
            continue;
        }
        let (was, is) = (votes.written.clone(), new.text(*at).into_owned());
        // A parameter is named in the body of its block and where that stands.
        let named = |rename: &&mut Rename| rename.was == was && rename.is == is;
        if let Some(known) = found.iter_mut().find(named) {
            known.places += votes.places;
            continue;
        }
        found.push(Rename {
            kind: votes.kind.unwrap_or("tag"),
            was,
            is,
            places: votes.places,
            shown_as: facts[0].and_then(shown_as),
            scope,
        });
    }
    found
}

/// What a thing is, by an entry that names it. None: that says nothing of it.
fn kind(outline: &Outline, entry: &Entry, identity: &Identity) -> Option<&'static str> {
    let is_marked = |mark: &str| {
        let name = format!("{mark}{}", identity.2.as_str());
        entry.names.contains(&Name::new(&name))
    };
    let is_named = entry.names.contains(&identity.2);
    match entry.kind {
        _ if identity.1 => Some("member"),
        Kind::Block if is_named => Some("block"),
        Kind::Structure if is_named => Some("type"),
        Kind::Declaration if is_named && identity.0.is_empty() && tag(outline, identity).is_none() => {
            Some("type")
        }
        Kind::Network if is_marked("function ") => Some("function"),
        Kind::Network if is_marked("label ") => Some("label"),
        _ => None,
    }
}

/// The tag of the program itself that a name is of.
fn tag<'o>(outline: &'o Outline, identity: &Identity) -> Option<&'o TagFacts> {
    if identity.1 || !identity.0.is_empty() {
        return None;
    }
    let scope = outline.context.scopes.first()?;
    scope.tags.get(scope.find(&identity.2)?)
}

/// Whether two tags may be one: of a name that says what a tag is another one is another tag.
fn is_alike(tags: [Option<&TagFacts>; 2]) -> bool {
    match tags {
        [None, None] => true,
        [Some(was), Some(is)] => {
            let has_form = [was, is].iter().any(|tag| tag.origin == Origin::Form);
            !has_form
                && was.ty == is.ty
                && was.role == is.role
                && was.origin == is.origin
                && (was.retain, was.constant) == (is.retain, is.constant)
                && was.cold.address == is.cold.address
        }
        _ => false,
    }
}

fn shown_as(tag: &TagFacts) -> Option<&'static str> {
    if tag.cold.address.is_some() {
        return None;
    }
    match tag.role {
        Role::Input => Some("input"),
        Role::Output => Some("output"),
        Role::Internal if tag.retain => Some("retentive tag"),
        Role::Internal if tag.origin == Origin::Declared(SectionKind::Global) => Some("global tag"),
        Role::Internal => None,
    }
}

/// An entry that has names which only its program has.
struct Masked<'e> {
    entry: &'e Entry,
    /// What it says without these.
    key: String,
    names: Vec<(&'e Identity, TextRange)>,
}

fn masked<'e>(entries: &[&'e Entry], words: &'e [Vec<Word>], only: &FxHashSet<Identity>) -> Vec<Masked<'e>> {
    let mut masked = Vec::new();
    for (entry, words) in entries.iter().zip(words) {
        let mut names = Vec::new();
        let mut key = String::from(entry.kind.text());
        for word in words {
            key.push(' ');
            match &word.named {
                Some((identity, at)) if only.contains(identity) => {
                    names.push((identity, *at));
                    key.push_str(ONLY_HERE);
                }
                _ => key.push_str(word.text.as_str()),
            }
        }
        if !names.is_empty() {
            masked.push(Masked { entry, key, names });
        }
    }
    masked
}

/// What both programs say.
struct Same<'e>(Vec<&'e Entry>, OnceCell<FxHashSet<(&'e str, &'e str)>>);

/// Takes out of two lists what both say: no name in it is of one program alone.
fn take_same<'e>(old: &mut Vec<&'e Entry>, new: &mut Vec<&'e Entry>) -> Same<'e> {
    let keys = |entries: &[&'e Entry]| -> FxHashSet<(Kind, &'e str)> {
        entries
            .iter()
            .map(|entry| (entry.kind, entry.told.key.as_str()))
            .collect()
    };
    let (was, is) = (keys(old), keys(new));
    let mut same = Vec::new();
    old.retain(|entry| {
        let is_only = !is.contains(&(entry.kind, entry.told.key.as_str()));
        if !is_only {
            same.push(*entry);
        }
        is_only
    });
    new.retain(|entry| !was.contains(&(entry.kind, entry.told.key.as_str())));
    Same(same, OnceCell::new())
}

impl Same<'_> {
    /// The names of one program that the other has nowhere.
    fn without<'w>(
        &self,
        names: &FxHashSet<&'w Identity>,
        others: &FxHashSet<&'w Identity>,
    ) -> FxHashSet<Identity> {
        let only = names.difference(others).copied();
        only.filter(|identity| !self.name(identity)).cloned().collect()
    }

    /// Whether a name is in it.
    fn name(&self, (scope, is_member, name): &Identity) -> bool {
        let names = self.1.get_or_init(|| {
            let is_between = |c: char| c != '_' && c != '$' && !c.is_alphanumeric();
            let mut names = FxHashSet::default();
            for entry in &self.0 {
                for word in entry.told.key.split(is_between) {
                    names.extend([(block_of(entry), word), (ANYWHERE, word)]);
                }
            }
            names
        });
        let is_of_all = *is_member || name.as_str().starts_with('$');
        let scope = if is_of_all { ANYWHERE } else { &**scope };
        names.contains(&(scope, name.as_str()))
    }
}
