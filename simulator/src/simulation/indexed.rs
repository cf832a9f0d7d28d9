//! Which element a place names now: `a[i]`, with what `i` holds.

use super::Simulation;
use crate::tags::Point;
use ladder_analysis::program::{BinaryOperator, Chosen, Expr, ExprKind, Place, TagId};
use ladder_analysis::values::value::Value;

impl Simulation {
    /// The element, or the bit of one, that a place names now whose index is computed. In a loop that is what it was in the last
    /// turn, in a scan that is open in this one. None for places without such an index, and for those in the body of a
    /// user-defined block, of which every place where the block is has its own.
    pub fn indexed_point(&self, place: &Place) -> Option<Point> {
        let is_of_body = |tag: TagId| self.program.tags[tag.0 as usize].block.is_some();
        if !Self::has_index(place) || place.root().is_none_or(is_of_body) {
            return None;
        }
        let point = self.resolve(&name(self, place)?).ok()?;
        let chosen = match place {
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => chosen_tag(self, chosen),
            _ => place.root(),
        };
        let is_it = |tag: TagId| self.compiled.homes[tag.0 as usize].holds(point.slot);
        chosen.is_some_and(is_it).then_some(point)
    }

    /// Whether a place has an index that is computed.
    pub fn has_index(place: &Place) -> bool {
        match place {
            Place::Element(_, index) => !matches!(index.kind, ExprKind::Constant(_)),
            Place::Bit(inner, ..) | Place::As(inner, ..) => Self::has_index(inner),
            Place::Chosen(_) | Place::ChosenMember(..) => true,
            _ => false,
        }
    }
}

/// The name of a place as a person writes it.
pub(crate) fn name(simulation: &Simulation, place: &Place) -> Option<String> {
    let tag = |tag: &TagId| simulation.program().tags[tag.0 as usize].name.clone();
    Some(match place {
        Place::Tag(it) => tag(it),
        Place::Member(it, member) => format!("{}.{}", tag(it), member.name()),
        Place::Element(it, index) => {
            let index = number(simulation, index)?;
            simulation.program().tags[it.0 as usize].element_name(index)
        }
        Place::Chosen(chosen) => tag(&chosen_tag(simulation, chosen)?),
        Place::ChosenMember(chosen, member) => {
            format!("{}.{}", tag(&chosen_tag(simulation, chosen)?), member.name())
        }
        Place::Bit(word, _, bit) => format!("{}.{bit}", name(simulation, word)?),
        Place::As(inner, ..) => name(simulation, inner)?,
        Place::System(system) => format!("SYS.{}", system.name()),
    })
}

/// The tag that an index chooses now.
pub(crate) fn chosen_tag(simulation: &Simulation, chosen: &Chosen) -> Option<TagId> {
    let number = u32::try_from(number(simulation, &chosen.number)?).ok()?;
    Some(TagId(chosen.first.0 + chosen.step * number))
}

/// What an index is now.
pub(crate) fn number(simulation: &Simulation, index: &Expr) -> Option<i64> {
    let value = match &index.kind {
        ExprKind::Constant(value) => value.clone(),
        ExprKind::Read(place) => {
            let point = simulation.resolve(&name(simulation, place)?).ok()?;
            simulation.value(&point)
        }
        ExprKind::Pass(inner) => return number(simulation, inner),
        ExprKind::Offset(subscripts) => {
            let mut offset = 0i64;
            for subscript in subscripts {
                let index = number(simulation, &subscript.index)?;
                if !(subscript.first..=subscript.last).contains(&index) {
                    return None;
                }
                offset += (index - subscript.first) * subscript.stride;
            }
            return Some(offset);
        }
        ExprKind::Binary(operator, left, right) => {
            let (left, right) = (number(simulation, left)?, number(simulation, right)?);
            return match operator {
                BinaryOperator::Add => left.checked_add(right),
                BinaryOperator::Sub => left.checked_sub(right),
                BinaryOperator::Mul => left.checked_mul(right),
                _ => None,
            };
        }
        _ => return None,
    };
    match value {
        Value::Int(number) => Some(number),
        _ => None,
    }
}
