//! What a person would draw where a rule finds something, for the findings that do not come with a fix: each of these decides
//! what was meant, so none is ever made unasked.

mod after_coil;
mod combine_coils;
mod dead_end;
mod join_above;
mod own_state;
mod remove;

use super::names::called;
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::item::ItemKind;
use ladder_analysis::context::Context;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};

/// What can be drawn for a finding, the best first.
pub(super) fn suggestions(analysis: &Analysis, found: &Diagnostic) -> Vec<Action> {
    match found.rule.name() {
        "double-coil" => combine_coils::offer(analysis, found).into_iter().collect(),
        "duplicate-timer" | "duplicate-counter" | "duplicate-instance" => {
            own_state::offer(analysis, found).into_iter().collect()
        }
        "contact-after-coil" => after_coil::offer(analysis, found).into_iter().collect(),
        "dead-end" => dead_end::offer(analysis, found),
        "open-wire" | "rung-not-powered" => join_above::offer_start(analysis, found).into_iter().collect(),
        "constant-power" => remove::of_constant(analysis, found),
        "redundant-element" => remove::of_redundant(analysis, found).into_iter().collect(),
        "shorted-branch" | "duplicate-branch" => remove::branch(analysis, found.range).into_iter().collect(),
        _ => Vec::new(),
    }
}

/// A thing on a rung that a finding is about.
struct Spot<'a> {
    context: &'a Context,
    on: OnNetwork<'a>,
    row: usize,
    index: usize,
}

impl<'a> Spot<'a> {
    /// The thing at a place, if its network's drawing can be read.
    fn find(analysis: &'a Analysis, place: TextRange) -> Option<Spot<'a>> {
        let on = Selected::find(analysis, TextRange::empty(place.start())).on?;
        let rows = on.drawing.rows.iter().enumerate();
        let items = rows.flat_map(|(row, it)| (0..it.items.len()).map(move |index| (row, index)));
        let (row, index) = items
            .filter(|&(row, index)| {
                let at = on.drawing.rows[row].items[index].at;
                !at.is_empty() && at.intersect(place).is_some_and(|common| !common.is_empty())
            })
            .min()?;
        Some(Spot {
            context: &analysis.context,
            on,
            row,
            index,
        })
    }

    /// How a title calls it; none if it is not a block.
    fn name(&self) -> Option<String> {
        let item = &self.on.drawing.rows[self.row].items[self.index];
        match item.kind {
            ItemKind::Block(Some(number)) => Some(called(self.on.facts.blocks.get(number)?, &item.text)),
            _ => None,
        }
    }

    /// The column of a place on a row of its network, in bytes: to find out what is near.
    fn column(&self, row: usize, at: TextSize) -> usize {
        let start = self.context.parse.line_start(self.on.facts.line(row));
        usize::from(at).saturating_sub(usize::from(start))
    }
}

fn action(title: String, edits: Vec<Edit>) -> Action {
    Action::new(ActionKind::QuickFix, title, edits)
}
