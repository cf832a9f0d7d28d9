//! Which element a place names now: `a[i]`, with what `i` holds.

use super::{Scope, Simulation};
use crate::tags::Point;
use ladder_analysis::program::{ExprKind, Place, TagId};

impl Simulation {
    /// The element, or the bit of one, that a place names now whose index is computed. In a loop that is what it was in the last
    /// turn, in a scan that is open in this one. None for places without such an index, and for those in the body of a
    /// user-defined block, of which every place where the block is has its own.
    pub fn indexed_point(&self, place: &Place) -> Option<Point> {
        let is_of_body = |tag: TagId| self.program.tags[tag.0 as usize].block.is_some();
        if !Self::has_index(place) || place.root().is_none_or(is_of_body) {
            return None;
        }
        let scope = Scope::default();
        let point = self.resolve(&scope.name(self, place)?).ok()?;
        let chosen = match place {
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => scope.chosen_tag(self, chosen),
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
