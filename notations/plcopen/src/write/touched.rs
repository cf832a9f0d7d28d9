//! Which tags an element reads and writes: what is read twice must not have been written between.

use ladder_analysis::program::{Argument, Block, Expr, ExprKind, Place, TagId};
use ladder_instructions::Direction;
use std::collections::HashSet;

/// The tags of one element.
#[derive(Debug, Clone, Default)]
pub(super) struct Touched {
    pub(super) reads: HashSet<TagId>,
    pub(super) writes: HashSet<TagId>,
    /// It may read or write anything: which element of an array is known only when it runs, or a block of one's own has
    /// globals.
    pub(super) reads_any: bool,
    pub(super) writes_any: bool,
}

impl Touched {
    /// Of a block with its operands.
    pub(super) fn of(block: &Block) -> Touched {
        let mut touched = Touched::default();
        for bound in &block.arguments {
            let direction = bound.operand.map(|operand| operand.direction);
            touched.argument(&bound.argument, direction);
        }
        touched
    }

    /// What a block of one's own does inside is not known.
    pub(super) fn anything(self) -> Touched {
        Touched {
            reads_any: true,
            writes_any: true,
            ..self
        }
    }

    /// Whether what this one writes is something that the other reads.
    pub(super) fn changes(&self, other: &Touched) -> bool {
        let reads = other.reads_any || !other.reads.is_empty();
        (self.writes_any && reads)
            || (other.reads_any && !self.writes.is_empty())
            || !self.writes.is_disjoint(&other.reads)
    }

    fn argument(&mut self, argument: &Argument, direction: Option<Direction>) {
        match argument {
            Argument::Value(value) => self.value(value),
            Argument::Place(place, _) => {
                let id = self.place(place);
                if direction != Some(Direction::In) {
                    self.writes.extend(id);
                }
            }
            Argument::Parts(parts) => parts.iter().for_each(|part| self.argument(part, direction)),
            Argument::State(tag) => {
                self.reads.insert(*tag);
                self.writes.insert(*tag);
            }
            Argument::ChosenState(chosen) => {
                self.value(&chosen.number);
                (self.reads_any, self.writes_any) = (true, true);
            }
            Argument::Range(range) => {
                self.reads.insert(range.tag);
                self.writes.insert(range.tag);
            }
            Argument::Label(_) | Argument::OuterLabel(_) | Argument::Function(_) | Argument::Operator(_) => {}
        }
    }

    /// A place, with all that says where it is; comes back the tag that it lies in.
    fn place(&mut self, place: &Place) -> Option<TagId> {
        match place {
            Place::Element(_, index) => self.value(index),
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => {
                self.value(&chosen.number);
                (self.reads_any, self.writes_any) = (true, true);
            }
            Place::Bit(inner, ..) | Place::As(inner, ..) => return self.place(inner),
            Place::Tag(_) | Place::Member(..) | Place::System(_) => {}
        }
        let root = place.root();
        self.reads.extend(root);
        root
    }

    fn value(&mut self, value: &Expr) {
        match &value.kind {
            ExprKind::Read(place) => drop(self.place(place)),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => self.value(inner),
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                self.value(left);
                self.value(right);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| self.value(argument)),
            ExprKind::Offset(subscripts) => subscripts.iter().for_each(|one| self.value(&one.index)),
            ExprKind::Sum(range) => drop(self.reads.insert(range.tag)),
            ExprKind::Constant(_) => {}
        }
    }
}
