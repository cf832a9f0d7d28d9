//! What lets power through, as the elements of a sketch.

use super::super::act::Refusal;
use super::super::address::Tag;
use super::super::bank::{Bank, Kind};
use super::super::dsl::spell;
use super::super::model::{Bits, Comparison, Condition, Constant, Contact, ContactKind, Operand};
use super::super::operand::{Chain, kind};
use super::super::ranges::range;
use super::Sketcher;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Path};
use ladder_instructions::Op;
use ladder_notation::LineColumn;

impl Sketcher<'_> {
    /// A condition, or the tag that holds what it was before the rung acts.
    pub(super) fn seen(&mut self, condition: &Condition, place: LineColumn) -> Circuit<Element> {
        match self.tags.seen(condition) {
            Some(helper) => self.series(place, vec![Block::contact(helper)]),
            None => self.condition(condition),
        }
    }

    pub(super) fn condition(&mut self, condition: &Condition) -> Circuit<Element> {
        match condition {
            Condition::All(parts) => Circuit::Series(parts.iter().map(|part| self.condition(part)).collect()),
            Condition::Any(parts) if parts.len() == 1 => self.condition(&parts[0]),
            // Where one branch is a bare wire the others decide nothing, but stay.
            Condition::Any(parts) => {
                let mut branches = Vec::with_capacity(parts.len());
                for part in parts {
                    match self.condition(part) {
                        Circuit::Parallel(inside) => branches.extend(inside),
                        other => branches.push(other),
                    }
                }
                Circuit::Parallel(branches)
            }
            Condition::Contact(contact) => {
                let blocks = self.contact(contact);
                self.checked(condition, contact.place, blocks)
            }
            Condition::Compare(comparison) => {
                let blocks = self.comparison(comparison);
                self.checked(condition, comparison.place, blocks)
            }
        }
    }

    /// A contact or comparison, or a comment in its place: then no power passes.
    fn checked(
        &mut self,
        condition: &Condition,
        place: LineColumn,
        blocks: Result<Vec<Block>, Refusal>,
    ) -> Circuit<Element> {
        let shown = spell::condition(condition);
        match blocks {
            Ok(blocks) => {
                self.reading.report.translated(place, shown);
                self.series(place, blocks)
            }
            Err(why) => {
                let told = Circuit::Element(self.refused(place, shown, why));
                let off = Block::negated_contact(Path::system("ON"));
                Circuit::Series(vec![told, self.series(place, vec![off])])
            }
        }
    }

    fn comparison(&mut self, comparison: &Comparison) -> Result<Vec<Block>, Refusal> {
        let mut chain = Chain::default();
        let mut side = |value: &Operand, other: &Operand| {
            let asked = kind(other);
            // An integer is compared with a real as one.
            let ty = match (value, asked) {
                (Operand::Constant(Constant::Float(_)), Some(Kind::Int)) => "REAL",
                (Operand::Constant(Constant::Float(_)), Some(Kind::Int2)) => "LREAL",
                _ => return chain.value(&mut self.tags, value, asked),
            };
            let number = chain.value(&mut self.tags, value, None)?;
            Ok(Expression::literal(format!("{ty}#{number}"))?)
        };
        let left = side(&comparison.left, &comparison.right)?;
        let right = side(&comparison.right, &comparison.left)?;
        chain.push(comparison.relation.op(), [left, right])?;
        Ok(chain.blocks)
    }

    pub(super) fn series(&mut self, place: LineColumn, blocks: Vec<Block>) -> Circuit<Element> {
        let origin = Some(self.reading.origin(place));
        let elements = blocks.into_iter().map(|block| Element::of(block, origin));
        Circuit::Series(elements.map(Circuit::Element).collect())
    }

    fn contact(&self, contact: &Contact) -> Result<Vec<Block>, Refusal> {
        let op = match contact.kind {
            ContactKind::Open => Op::Contact,
            ContactKind::Closed => Op::NegatedContact,
            ContactKind::Rising => Op::RisingContact,
            ContactKind::Falling => Op::FallingContact,
        };
        let bits = match &contact.bits {
            Bits::One(tag) => vec![self.tags.place(tag)],
            // Each timer is a tag of its own, and no part of an array.
            Bits::Many(span) if matches!(span.bank, Bank::T | Bank::Ct) => {
                let (first, last) = span.bounds();
                let numbers = (first..=last).filter(|number| span.bank.has(*number));
                let tags = numbers.map(|number| Tag::number(span.bank, number));
                tags.map(|tag| self.tags.place(&tag)).collect()
            }
            Bits::Many(span) => vec![range(span)],
        };
        let blocks = bits.into_iter().map(|bit| Ok(Block::of(op, [bit])?));
        blocks.collect()
    }
}
