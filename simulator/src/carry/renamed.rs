//! A tag that has another name at all of its places, and is the same one.
//!
//! It is one where nothing else was changed: by name alone it would be one tag removed and one added.

use super::does_the_same;
use super::signature::Signatures;
use crate::simulation::Simulation;
use ladder_analysis::program::{Program, Tag};
use ladder_syntax::Name;
use std::borrow::Cow;

/// The tag that has another name now, if there is one.
#[derive(Debug, Default)]
pub(super) struct Renamed {
    pub(super) names: Option<Names>,
}

/// Two names of a tag.
#[derive(Debug, Clone)]
pub(crate) struct Names {
    was: String,
    is: String,
}

impl Names {
    /// What is called so now, or was: the tag or a part of it, by its other name.
    pub(crate) fn other(&self, name: &str) -> Option<String> {
        let now = with_tag(name, &self.was, &self.is);
        now.or_else(|| with_tag(name, &self.is, &self.was))
    }
}

/// The name of a tag or a part of it with another tag in the place of this one.
fn with_tag(name: &str, tag: &str, other: &str) -> Option<String> {
    let (start, rest) = name.get(..tag.len()).zip(name.get(tag.len()..))?;
    let is_tag = Name::new(start) == Name::new(tag) && (rest.is_empty() || rest.starts_with(['.', '[']));
    is_tag.then(|| format!("{other}{rest}"))
}

impl Renamed {
    pub(super) fn of(old: &Simulation, new: &Simulation) -> Renamed {
        let names = if does_the_same(old, new) {
            renamed(&old.program, &new.program)
        } else {
            None
        };
        Renamed { names }
    }

    /// The name that a tag of the new program had in the old one.
    pub(super) fn former_name<'t>(&'t self, tag: &'t Tag) -> &'t str {
        match &self.names {
            Some(names) if Name::new(&tag.name) == Name::new(&names.is) => &names.was,
            _ => &tag.name,
        }
    }

    /// The name that a tag of the old program, or a part of it, has in the new one.
    pub(super) fn name_now<'n>(&self, was: &'n str) -> Cow<'n, str> {
        let names = self.names.as_ref();
        let now = names.and_then(|names| with_tag(was, &names.was, &names.is));
        now.map_or(Cow::Borrowed(was), Cow::Owned)
    }
}

fn renamed(old: &Program, new: &Program) -> Option<Names> {
    let tags = || old.tags.iter().zip(&new.tags);
    let mut others = tags().filter(|(was, is)| Name::new(&was.name) != Name::new(&is.name));
    let (was, is) = others.next()?;
    let has = |program: &Program, name: &str| {
        let mut tags = program.tags.iter();
        tags.any(|tag| Name::new(&tag.name) == Name::new(name))
    };
    let is_one =
        others.next().is_none() && was.block.is_none() && !has(old, &is.name) && !has(new, &was.name);
    // A user who writes another name at one place may mean another tag.
    let is_everywhere = || places_changed(old, new) + usize::from(is_declared(new, is)) > 1;
    (is_one && is_everywhere()).then(|| Names {
        was: was.name.clone(),
        is: is.name.clone(),
    })
}

fn is_declared(program: &Program, tag: &Tag) -> bool {
    let mut networks = program.networks.iter().map(|network| network.location);
    !networks.any(|it| it.file == tag.location.file && it.range.contains_range(tag.location.range))
}

/// In how many blocks there is something else now.
fn places_changed(old: &Program, new: &Program) -> usize {
    let (old_ones, new_ones) = (
        Signatures::of(old, &Renamed::default()),
        Signatures::of(new, &Renamed::default()),
    );
    let networks = old.networks.iter().zip(&new.networks);
    let blocks = networks.flat_map(|(old, new)| old.blocks.iter().zip(&new.blocks));
    blocks
        .filter(|(was, is)| old_ones.block(was) != new_ones.block(is))
        .count()
}
