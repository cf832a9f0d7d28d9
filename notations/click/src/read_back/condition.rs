//! What lets power through: contacts, comparisons, and what they are in.

use super::Back;
use super::act::{is_condition, op};
use super::value::Refusal;
use crate::model::{Comparison, Condition, Contact, ContactKind, Relation};
use ladder_analysis::program::{Block, Network};
use ladder_format::Circuit;
use ladder_instructions::Op;

impl Back<'_> {
    /// Whether a part of a network is a condition.
    pub(super) fn lets_through(network: &Network, part: &Circuit<usize>) -> bool {
        match part {
            Circuit::Element(block) => is_condition(&network.blocks[*block]),
            // A bare wire decides nothing, and is not what something begins with.
            Circuit::Series(parts) => {
                !parts.is_empty() && parts.iter().all(|part| Self::lets_through(network, part))
            }
            Circuit::Parallel(parts) => parts
                .iter()
                .all(|part| is_bare(part) || Self::lets_through(network, part)),
        }
    }

    pub(super) fn condition(&self, network: &Network, part: &Circuit<usize>) -> Result<Condition, Refusal> {
        match part {
            Circuit::Element(block) => self.contact(&network.blocks[*block]),
            Circuit::Series(parts) => {
                let mut out = Vec::new();
                for part in parts {
                    out.push(self.condition(network, part)?);
                }
                Ok(all(out))
            }
            Circuit::Parallel(parts) => {
                let mut out = Vec::new();
                for part in parts {
                    out.push(self.condition(network, part)?);
                }
                Ok(Condition::Any(out))
            }
        }
    }

    pub(super) fn contact(&self, block: &Block) -> Result<Condition, Refusal> {
        let place = self.place_of(block.location);
        // What a branch sees before its rung acts.
        if let Some((tag, _)) = self.helper(block.arguments.first()) {
            let found = self.computed.conditions.get(&tag).cloned();
            return found.ok_or_else(|| "the rung that computes the contact is missing".to_owned());
        }
        let kind = match op(block) {
            Some(Op::Contact) => ContactKind::Open,
            Some(Op::NegatedContact) => ContactKind::Closed,
            Some(Op::RisingContact) => ContactKind::Rising,
            Some(Op::FallingContact) => ContactKind::Falling,
            other => {
                let relation = other.and_then(Relation::of).ok_or("it is not a contact")?;
                let [left, right] = &block.arguments[..] else {
                    return Err("Click compares two values".to_owned());
                };
                return Ok(Condition::Compare(Comparison {
                    place,
                    left: self.operand(left)?,
                    relation,
                    right: self.operand(right)?,
                }));
            }
        };
        let bound = block.arguments.first().ok_or("the contact has no operand")?;
        let bits = self.bits(bound)?;
        Ok(Condition::Contact(Contact { place, kind, bits }))
    }
}

/// Conditions in series.
pub(super) fn all(mut conditions: Vec<Condition>) -> Condition {
    match conditions.len() {
        1 => conditions.remove(0),
        _ => Condition::All(conditions),
    }
}

pub(super) fn is_bare(part: &Circuit<usize>) -> bool {
    matches!(part, Circuit::Series(parts) if parts.is_empty())
}
