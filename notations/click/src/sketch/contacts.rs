//! What lets power through, as the elements of a sketch.

use super::super::address::Tag;
use super::super::bank::Bank;
use super::super::bank::Kind;
use super::super::dsl::spell;
use super::super::model::{Bits, Condition, Constant, Contact, ContactKind, Operand};
use super::super::operand::{Chain, kind, literal};
use super::super::ranges;
use super::Sketcher;
use ladder_format::Circuit;
use ladder_format::program::Element;
use ladder_notation::LineColumn;

impl Sketcher<'_> {
    /// A condition, or the tag that holds what it was before the rung acts.
    pub(super) fn seen(&mut self, condition: &Condition, place: LineColumn) -> Circuit<Element> {
        match self.tags.seen(condition) {
            Some(helper) => {
                let block = format!("[ ]( {helper} )");
                self.series(place, vec![block])
            }
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
            Condition::Contact(contact) => self.contact(contact),
            Condition::Compare(comparison) => {
                let mut chain = Chain::default();
                let sides = [&comparison.left, &comparison.right];
                let [left, right] = [(0, 1), (1, 0)].map(|(side, other)| {
                    let other = kind(sides[other]);
                    match (sides[side], other) {
                        // An integer is compared with a real as one.
                        (Operand::Constant(number @ Constant::Float(_)), Some(Kind::Int)) => {
                            format!("REAL#{}", literal(number, None))
                        }
                        (Operand::Constant(number @ Constant::Float(_)), Some(Kind::Int2)) => {
                            format!("LREAL#{}", literal(number, None))
                        }
                        (value, other) => chain.value(&mut self.tags, value, other),
                    }
                });
                chain.push(format!("[{}]( {left}, {right} )", comparison.relation.mnemonic()));
                let text = spell::condition(condition);
                self.reading.report.translated(comparison.place, text);
                self.series(comparison.place, chain.blocks)
            }
        }
    }

    pub(super) fn series(&mut self, place: LineColumn, blocks: Vec<String>) -> Circuit<Element> {
        let origin = Some(self.reading.origin(place));
        let elements = blocks
            .into_iter()
            .map(|block| Circuit::Element(Element::block(block, origin)));
        Circuit::Series(elements.collect())
    }

    pub(super) fn contact(&mut self, contact: &Contact) -> Circuit<Element> {
        let head = match contact.kind {
            ContactKind::Open => "[ ]",
            ContactKind::Closed => "[/]",
            ContactKind::Rising => "[P]",
            ContactKind::Falling => "[N]",
        };
        let shown = spell::condition(&Condition::Contact(contact.clone()));
        self.reading.report.translated(contact.place, shown);
        let blocks = match &contact.bits {
            Bits::One(tag) => vec![format!("{head}( {} )", self.tags.text(tag))],
            // Each timer is a tag of its own, and no part of an array.
            Bits::Many(span) if matches!(span.bank, Bank::T | Bank::Ct) => {
                let (first, last) = span.bounds();
                let numbers = (first..=last).filter(|number| span.bank.has(*number));
                let tags = numbers.map(|number| Tag::number(span.bank, number));
                tags.map(|tag| format!("{head}( {} )", self.tags.text(&tag)))
                    .collect()
            }
            Bits::Many(span) => vec![format!("{head}( {} )", ranges::range(span))],
        };
        self.series(contact.place, blocks)
    }
}
