//! Which networks may change places: what each reads and writes of the program's tags.
//!
//! Tags are taken whole: a write of one element or bit is a write of all of them, so a computed index needs no thought. Of a
//! direct address the program has one tag, whatever its names, and no address is a part of another.

use ladder_analysis::program::{
    Argument, Block, BlockKind, Bound, Chosen, Expr, ExprKind, Network, Place, Program, RangeRef, TagId,
};
use ladder_instructions::{Controller, Direction, Edges, Group, Op};
use std::collections::BTreeSet;

/// What a network does to tags.
#[derive(Debug, Default)]
pub(crate) struct Touched {
    reads: BTreeSet<TagId>,
    writes: BTreeSet<TagId>,
    /// It does more than that: it decides where execution goes on, runs the body of a block, or has to do with a port.
    pub(crate) does_more: bool,
}

impl Touched {
    /// What a network of a program touches by its own operands.
    pub(crate) fn by(program: &Program, network: &Network) -> Touched {
        let mut touched = Touched::default();
        for block in &network.blocks {
            touched.block(program, block);
        }
        // Any network may make an error, which the controller shows there.
        if program.semantics(network.location).controller == Controller::Banks {
            let tags = (0..).map(TagId).zip(&program.tags);
            let banks = tags.filter(|(_, tag)| ["SC", "SD"].contains(&&*tag.name.to_ascii_uppercase()));
            touched.writes.extend(banks.map(|(tag, _)| tag));
        }
        touched
    }

    /// Whether this network and another do the same in either order.
    pub(crate) fn may_swap(&self, other: &Touched) -> bool {
        !self.does_more && !other.does_more && !self.disturbs(other) && !other.disturbs(self)
    }

    /// The tags.
    pub(crate) fn tags(&self) -> impl Iterator<Item = TagId> {
        self.reads.iter().chain(&self.writes).copied()
    }

    fn disturbs(&self, other: &Touched) -> bool {
        let mut writes = self.writes.iter();
        writes.any(|tag| other.reads.contains(tag) || other.writes.contains(tag))
    }

    fn block(&mut self, program: &Program, block: &Block) {
        let mut remembers_in_tag = false;
        match block.kind {
            BlockKind::Instruction(row) => {
                self.does_more |= matches!(row.group, Group::Flow | Group::Port);
                let shares_edges = program.semantics(block.location).edges == Edges::OfTag;
                remembers_in_tag = shares_edges && matches!(row.op, Op::RisingContact | Op::FallingContact);
            }
            BlockKind::User(_) => self.does_more = true,
        }
        for bound in &block.arguments {
            self.argument(&bound.argument, is_read_only(bound) && !remembers_in_tag);
        }
    }

    fn argument(&mut self, argument: &Argument, is_read_only: bool) {
        match argument {
            Argument::Value(value) => {
                self.value(value);
                if let (false, ExprKind::Read(place)) = (is_read_only, &value.kind) {
                    self.writes.extend(place.root());
                }
            }
            Argument::Place(place, _) => {
                self.place(place);
                self.writes.extend(place.root());
                if let Place::Chosen(chosen) | Place::ChosenMember(chosen, _) = place {
                    self.chosen(chosen, true);
                }
            }
            Argument::Parts(parts) => {
                for part in parts {
                    self.argument(part, is_read_only);
                }
            }
            Argument::State(tag) => self.tag(*tag, true),
            Argument::ChosenState(chosen) => self.chosen(chosen, true),
            Argument::Range(range) => {
                self.range(range);
                self.tag(range.tag, !is_read_only);
            }
            Argument::Label(_) | Argument::OuterLabel(_) | Argument::Function(_) | Argument::Operator(_) => {}
        }
    }

    fn tag(&mut self, tag: TagId, is_written: bool) {
        self.reads.insert(tag);
        if is_written {
            self.writes.insert(tag);
        }
    }

    fn chosen(&mut self, chosen: &Chosen, is_written: bool) {
        for number in 0..chosen.count {
            self.tag(TagId(chosen.first.0 + number * chosen.step), is_written);
        }
        self.value(&chosen.number);
    }

    fn range(&mut self, range: &RangeRef) {
        self.tag(range.tag, false);
        self.value(&range.first);
        if let Some(last) = &range.last {
            self.value(last);
        }
    }

    /// The depth of expressions is bounded by the parser.
    fn value(&mut self, value: &Expr) {
        match &value.kind {
            ExprKind::Constant(_) => {}
            ExprKind::Read(place) => self.place(place),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => self.value(inner),
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                self.value(left);
                self.value(right);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| self.value(argument)),
            ExprKind::Sum(range) => self.range(range),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    self.value(&subscript.index);
                }
            }
        }
    }

    fn place(&mut self, place: &Place) {
        match place {
            Place::Tag(tag) | Place::Member(tag, _) => self.tag(*tag, false),
            Place::Element(tag, index) => {
                self.tag(*tag, false);
                self.value(index);
            }
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => self.chosen(chosen, false),
            Place::Bit(inner, ..) | Place::As(inner, ..) => self.place(inner),
            // It is the same all through a scan.
            Place::System(_) => {}
        }
    }
}

fn is_read_only(bound: &Bound) -> bool {
    bound
        .operand
        .is_some_and(|operand| operand.direction == Direction::In)
}
