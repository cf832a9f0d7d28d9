//! What a refactoring makes of names also changes the scenarios that have them.

use crate::neighbour::Workspace;
use crate::rename::{Renamed, in_columns};
use crate::scenario::row::{Named, each_name};
use crate::symbol::Symbol;
use ladder_analysis::context::Context;
use ladder_format::Edit;
use ladder_syntax::{Name, TextRange, TextSize};
use std::ops::Range;
use std::sync::Arc;

/// What becomes of names in the rows of scenarios, and in properties.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum InScenarios {
    /// They stay.
    Nothing,
    /// Each tag becomes a path.
    Tags(Vec<(Symbol, String)>),
    /// Each member of a tag becomes a tag.
    Members(Symbol, Vec<(Name, String)>),
    /// The state of a place becomes a tag; places of the block after it go down by one.
    Instance { place: Place, tag: String },
}

/// A place of a block: `$Motor#2`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) block: Symbol,
    /// The block in whose body it is.
    pub(super) outer: Option<Symbol>,
    pub(super) number: usize,
}

impl InScenarios {
    /// The names without which a file of scenarios has nothing to change.
    fn names(&self) -> Vec<&Name> {
        let symbols: Vec<&Symbol> = match self {
            InScenarios::Nothing => Vec::new(),
            InScenarios::Tags(tags) => tags.iter().map(|(symbol, _)| symbol).collect(),
            InScenarios::Members(symbol, _) => vec![symbol],
            InScenarios::Instance { place, .. } => vec![&place.block],
        };
        symbols.into_iter().filter_map(Symbol::name).collect()
    }

    /// What a part of a row's name becomes.
    fn of(&self, text: &str, named: &Named<'_>) -> Option<(Range<usize>, String)> {
        let mut words = named.words.iter();
        match self {
            InScenarios::Nothing => None,
            InScenarios::Tags(tags) => words.find_map(|(word, symbol)| {
                let (_, path) = tags.iter().find(|(tag, _)| tag == symbol)?;
                Some((word.clone(), path.clone()))
            }),
            InScenarios::Members(tag, members) => {
                let (whole, _) = words.find(|(_, symbol)| symbol == tag)?;
                let (part, _) = words.next()?;
                let member = Name::new(&text[part.clone()]);
                let (_, new) = members.iter().find(|(name, _)| *name == member)?;
                Some((whole.start..part.end, new.clone()))
            }
            InScenarios::Instance { place, tag } => {
                let is_it = |index: &usize| {
                    let outer = index.checked_sub(1).map(|outer| &named.words[outer].1);
                    named.words[*index].1 == place.block && outer == place.outer.as_ref()
                };
                let (word, _) = &named.words[(0..named.words.len()).find(is_it)?];
                let end = word.end + text[word.end..].find('.')?;
                let number: usize = text[word.end..end].strip_prefix('#')?.parse().ok()?;
                match number.cmp(&place.number) {
                    std::cmp::Ordering::Less => None,
                    std::cmp::Ordering::Equal => Some((word.start..end, tag.clone())),
                    std::cmp::Ordering::Greater => Some((word.end..end, format!("#{}", number - 1))),
                }
            }
        }
    }

    /// The edits of all files of scenarios. `own` is the file that was changed.
    pub(super) fn edits(&self, own: &Context, workspace: &dyn Workspace) -> Vec<Renamed> {
        let names = self.names();
        if names.is_empty() {
            return Vec::new();
        }
        let mut changed = Vec::new();
        for file in workspace.scenarios() {
            // Where other files are part of the program, they may have such places too.
            let is_own = file
                .program
                .as_ref()
                .is_some_and(|program| own.is_called(program));
            if matches!(self, InScenarios::Instance { .. }) && !is_own {
                continue;
            }
            let mut edits = Vec::new();
            each_name(&file, &names, own, workspace, &mut |naming, named| {
                if let Some((part, text)) = self.of(naming.text, named) {
                    let at = |place: usize| naming.range.start() + TextSize::new(place as u32);
                    let range = TextRange::new(at(part.start), at(part.end));
                    edits.push(Edit { range, text });
                }
            });
            let edits = in_columns(&file.suite, &file.text, edits);
            if !edits.is_empty() {
                changed.push(Renamed {
                    file: Arc::clone(&file.name),
                    edits,
                });
            }
        }
        changed
    }
}
