//! What of a block's operands can be checked.

use super::sheet::{Block as SheetBlock, Indexed, IndexedOperand, Operand, Shown};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, Place, Program, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_instructions::{Direction, Instruction};
use ladder_simulator::Simulation;
use ladder_syntax::TextRange;
use std::borrow::Cow;

/// The row of the instruction table.
pub(super) fn instruction(block: &Block) -> Option<&'static Instruction> {
    match block.kind {
        BlockKind::Instruction(row) => Some(row),
        BlockKind::User(_) => None,
    }
}

/// The tags that are between a block's parentheses and have one value.
pub(super) fn named(text: &str, block: &Block, simulation: &Simulation) -> Vec<Operand> {
    let program = simulation.program();
    let mut operands = Vec::new();
    for bound in &block.arguments {
        if let Argument::State(tag) = bound.argument {
            operands.extend(state(program, tag, bound.range, simulation));
            continue;
        }
        for (place, range) in bound.places() {
            let written = matches!(bound.argument, Argument::Place(..)) && writes(bound);
            if let Some(point) = simulation.point_at(place, &text[range]) {
                operands.push(Operand {
                    start: range.start().into(),
                    end: range.end().into(),
                    point,
                    written,
                });
            }
        }
    }
    operands
}

/// The operands whose index is computed.
pub(super) fn indexed(block: &Block) -> Vec<IndexedOperand> {
    let mut operands = Vec::new();
    for bound in &block.arguments {
        for (place, range) in bound
            .places()
            .into_iter()
            .filter(|(place, _)| Simulation::has_index(place))
        {
            operands.push(IndexedOperand {
                start: range.start().into(),
                end: range.end().into(),
                place: place.clone(),
                written: matches!(bound.argument, Argument::Place(..)) && writes(bound),
            });
        }
    }
    operands
}

/// A block's tags as they are now, in the order of its operands.
pub(super) fn now<'b>(block: &'b SheetBlock, simulation: &Simulation) -> Cow<'b, [Operand]> {
    if block.indexed.is_empty() {
        return Cow::Borrowed(&block.operands);
    }
    let indexed = block.indexed.iter().filter_map(|operand| {
        Some(Operand {
            start: operand.start,
            end: operand.end,
            point: simulation.indexed_point(&operand.place)?,
            written: operand.written,
        })
    });
    let mut all: Vec<Operand> = block.operands.iter().cloned().chain(indexed).collect();
    all.sort_by_key(|operand| operand.start);
    Cow::Owned(all)
}

/// A timer or counter stands for its output.
fn state(program: &Program, tag: TagId, range: TextRange, simulation: &Simulation) -> Option<Operand> {
    let tag = &program.tags[tag.0 as usize];
    if tag.block.is_some() {
        return None;
    }
    let output = |member| simulation.resolve(&format!("{}.{member}", tag.name)).ok();
    Some(Operand {
        start: range.start().into(),
        end: range.end().into(),
        point: output("Q").or_else(|| output("QU")).or_else(|| output("Q1"))?,
        written: true,
    })
}

/// What the end of the line shows: timers and counters with their goals, and every value that is not a BOOL.
pub(super) fn shown(text: &str, block: &Block, simulation: &Simulation) -> Vec<Shown> {
    let program = simulation.program();
    let mut shown = Vec::new();
    for bound in &block.arguments {
        if let Argument::State(tag) = bound.argument {
            let preset = block.arguments.get(1).map(|preset| &text[preset.range]);
            shown.extend(progress(program, tag, preset, simulation));
            continue;
        }
        let of_state =
            matches!(block.arguments.first(), Some(first) if matches!(first.argument, Argument::State(_)));
        for (place, range) in bound.places() {
            // The preset of a timer is next to what it has reached.
            if of_state {
                continue;
            }
            if Simulation::has_index(place) {
                shown.extend(element(program, place, &text[range], simulation));
            } else if let Some(point) = simulation.point_at(place, &text[range])
                && point.ty != Scalar::Bool
            {
                shown.push(Shown::Value(point));
            }
        }
    }
    shown
}

/// An element with a computed index, also one of BOOL: the drawing shows what it holds, but not which one it is.
fn element(program: &Program, place: &Place, written: &str, simulation: &Simulation) -> Option<Shown> {
    let tag = &program.tags[place.root()?.0 as usize];
    if tag.block.is_some() {
        return None;
    }
    Some(Shown::Indexed(Indexed {
        written: written.to_owned(),
        place: place.clone(),
        // The last one has a long name.
        sample: simulation.resolve_all(&tag.name).ok()?.pop()?,
    }))
}

fn progress(program: &Program, tag: TagId, preset: Option<&str>, simulation: &Simulation) -> Option<Shown> {
    let tag = &program.tags[tag.0 as usize];
    let Type::State(state) = tag.ty else { return None };
    if tag.block.is_some() {
        return None;
    }
    let (reached, goal) = if state.is_timer() {
        ("ET", "PT")
    } else {
        ("CV", "PV")
    };
    let member = |member| simulation.resolve(&format!("{}.{member}", tag.name)).ok();
    Some(Shown::Progress {
        name: tag.name.clone(),
        reached: member(reached)?,
        goal: member(goal)?,
        goal_width: goal_width(preset),
    })
}

/// How wide a preset is shown: that of a literal is known.
fn goal_width(preset: Option<&str>) -> usize {
    let literal =
        preset.filter(|preset| preset.starts_with(|c: char| c.is_ascii_digit()) || preset.contains('#'));
    literal.map_or(3, |literal| {
        let digits = literal.rsplit_once('#').map_or(literal, |(_, digits)| digits);
        digits.chars().filter(|c| *c != '_').count()
    })
}

fn writes(bound: &Bound) -> bool {
    // In a user-defined block an argument that is a place is an output or in-out.
    bound
        .operand
        .is_none_or(|operand| operand.direction != Direction::In)
}
