//! `[BMOV]`, `[PACK]`, `[UNPACK]` and `[SEARCH]`: what is wrong with their ranges however the program runs (LANGUAGE §5.2).

use super::Resolver;
use crate::findings::article::with_article;
use crate::names::operand_value::{Number, number};
use crate::networks::BlockAt;
use crate::program::{Argument, Bound};
use crate::rules::{bad_operand, type_mismatch};
use crate::values::types::{Scalar, Type};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Op;
use ladder_syntax::TextRange;

/// A range of an array, or the elements from an index on, as far as the text says it.
struct Extent {
    /// The first and last index of the array.
    array: (i64, i64),
    first: Option<i64>,
    last: Option<i64>,
    /// Only an index is given: it is as long as it needs to be.
    open: bool,
}

impl Extent {
    /// How many elements it has.
    fn count(&self) -> Option<i64> {
        let (first, last) = self.first.zip(self.last)?;
        (!self.open && first <= last).then(|| last - first + 1)
    }
}

impl Resolver<'_, '_> {
    /// The number that an index is, if it is written as one or is a CONSTANT.
    pub(super) fn known_index(&self, index: &Node) -> Option<i64> {
        let scope = self.context.networks.at(self.network).scope;
        match number(self.context, scope, index)? {
            Number::Int(n) => i64::try_from(n).ok(),
            Number::Real(_) => None,
        }
    }

    /// Looks at the ranges of a block all of whose operands are what they should be, each by itself.
    pub(super) fn check_ranges(&mut self, op: Op, bound: BlockAt<'_>, arguments: &[Bound]) {
        let operand = |index: usize| bound.facts.operands.get(index).map(|written| &written.value);
        let [first, second, ..] = arguments else { return };
        let (Some(one), Some(other)) = (operand(0), operand(1)) else {
            return;
        };
        match (op, &first.argument, &second.argument) {
            (Op::Bmov, ..) => self.check_move(one, other),
            (Op::Pack, Argument::Place(_, to), Argument::Range(from)) => {
                self.check_pack(*to, from.element, other);
            }
            (Op::Pack, _, Argument::Value(value)) if !value.ty.is_string() => {
                let message = format!(
                    "a range or a STRING is packed, this is {}",
                    with_article(value.ty)
                );
                self.report(type_mismatch::wrong(second.range, message));
            }
            (Op::Unpack, Argument::Range(to), Argument::Value(value))
                if !has_parts(value.ty) || !is_part(to.element) =>
            {
                let message = format!("{} cannot be unpacked into {}", value.ty, to.element);
                self.report(type_mismatch::wrong(second.range, message));
            }
            (Op::Unpack, Argument::Place(_, to), _) if !to.is_string() => {
                let message = format!(
                    "a value is unpacked into a range or a STRING, this is {}",
                    with_article(*to)
                );
                self.report(type_mismatch::wrong(first.range, message));
            }
            (Op::Search, Argument::Place(_, y), _) => {
                if let Some(range) = operand(3).filter(|_| arguments.len() > 3) {
                    self.check_found(*y, first.range, range);
                }
            }
            _ => {}
        }
    }

    fn extent(&self, node: &Node) -> Option<Extent> {
        let (base, first, last) = match &node.kind {
            NodeKind::Range(base, first, last) => (base, first, Some(last)),
            NodeKind::Index(base, first) => (base, first, None),
            _ => return None,
        };
        let Type::Array {
            first: low,
            last: high,
            ..
        } = self.tag_type(self.named_tag(base)?)
        else {
            return None;
        };
        Some(Extent {
            array: (low, high),
            first: self.known_index(first),
            last: last.map_or(Some(high), |last| self.known_index(last)),
            open: last.is_none(),
        })
    }

    /// `[BMOV]`: two ranges of one length; an index alone begins one that is as long as the other.
    fn check_move(&mut self, to: &Node, from: &Node) {
        let (Some(to_extent), Some(from_extent)) = (self.extent(to), self.extent(from)) else {
            return;
        };
        if let Some((into, count)) = to_extent.count().zip(from_extent.count()) {
            if into != count {
                let message =
                    format!("this range has {count} elements, and the one it is copied to has {into}");
                let found = bad_operand::wrong(self.at(from.range), message);
                self.report(found.help(
                    "give both one length; or write one of them as an index alone, where it starts: it is as long as the other",
                ));
            }
            return;
        }
        for (open, node, other) in [(&to_extent, to, &from_extent), (&from_extent, from, &to_extent)] {
            let Some((start, count)) = open.first.filter(|_| open.open).zip(other.count()) else {
                continue;
            };
            let (first, last) = open.array;
            // A start outside the array is found where indices are.
            if (first..=last).contains(&start) && start + (count - 1) > last {
                let message =
                    format!("the array ends at {last}: there are no {count} elements from {start} on");
                let found = bad_operand::wrong(self.at(node.range), message);
                self.report(
                    found.help("the range is as long as the other one: begin further up, or copy fewer"),
                );
            }
        }
    }

    /// `[PACK]`: the elements are parts of the value.
    fn check_pack(&mut self, to: Scalar, element: Scalar, from: &Node) {
        let range = self.at(from.range);
        if !has_parts(to) || !is_part(element) {
            let message = format!("{element} cannot be packed into {to}");
            self.report(type_mismatch::wrong(range, message));
            return;
        }
        let room = i64::from(to.width() / element.width());
        if room == 0 {
            let message = format!("{} does not fit into {}", with_article(element), with_article(to));
            self.report(type_mismatch::wrong(range, message));
            return;
        }
        let count = self.extent(from).and_then(|extent| extent.count());
        if let Some(count) = count.filter(|count| *count > room) {
            let message = format!(
                "{count} elements of {element} do not fit into {}: it takes {room}",
                with_article(to)
            );
            self.report(bad_operand::wrong(range, message));
        }
    }

    /// `[SEARCH]`: every index that may be found, and -1, is a value of the result.
    fn check_found(&mut self, y: Scalar, at: TextRange, range: &Node) {
        let (Some(extent), Some((low, high))) = (self.extent(range), y.bounds()) else {
            return;
        };
        // There the largest number stands for -1.
        let high = if y.is_signed() { high } else { high - 1 };
        let holds = |index: i64| (low..=high).contains(&i128::from(index));
        let ends = [extent.first, extent.last].into_iter().flatten();
        if let Some(index) = ends.into_iter().find(|index| !holds(*index)) {
            let message = format!("the result is {y}, which cannot hold the index {index} that may be found");
            let found = bad_operand::wrong(at, message);
            self.report(found.help("declare the result as DINT"));
        }
    }
}

/// Values that are made of parts. As in the simulator, times and dates are words too.
const fn has_parts(ty: Scalar) -> bool {
    !(matches!(ty, Scalar::Bool) || ty.is_string())
}

/// Elements that are parts of a value: BOOL, bit strings, integers.
fn is_part(element: Scalar) -> bool {
    element == Scalar::Bool || element.is_bits() || element.is_integer()
}
