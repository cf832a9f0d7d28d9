//! Copies, fillings and packed texts.

use super::Back;
use super::act::{helper_tag, op};
use super::value::Refusal;
use crate::address::{Span, Tag};
use crate::bank::Bank;
use crate::model::{Constant, CopyOptions, Instruction, Operand};
use ladder_analysis::program::{Block, Bound};
use ladder_instructions::Op;

impl Back<'_> {
    /// A copy; a text goes into several addresses by as many blocks.
    pub(super) fn copy(&self, source: Operand, target: Operand, after: &[&Block]) -> (Instruction, usize) {
        let options = CopyOptions::default();
        let copy = |source, target, used| {
            let options = options.clone();
            (
                Instruction::Copy {
                    source,
                    target,
                    options,
                },
                used,
            )
        };
        let (Operand::Constant(Constant::Text(text)), Operand::Tag(first)) = (&source, &target) else {
            return copy(source, target, 0);
        };
        let Some(start) = first.address().filter(|address| address.bank == Bank::Txt) else {
            return copy(source, target, 0);
        };
        let mut all = text.clone();
        let mut used = 0;
        for block in after {
            let expected = Tag::number(Bank::Txt, start.number.saturating_add(used as u16 + 1));
            let (Some(Op::Mov), [target, source]) = (op(block), &block.arguments[..]) else {
                break;
            };
            match (self.operand(target), self.operand(source)) {
                (Ok(Operand::Tag(tag)), Ok(Operand::Constant(Constant::Text(more)))) if tag == expected => {
                    all.push_str(&more);
                    used += 1;
                }
                _ => break,
            }
        }
        copy(Operand::Constant(Constant::Text(all)), target, used)
    }

    /// What goes into a tag of the importer's own, and from there where it belongs: a filling, a packed text.
    pub(super) fn through_helper(
        &self,
        arguments: &[Bound],
        after: &[&Block],
    ) -> Option<Result<(Instruction, usize), Refusal>> {
        let (tag, _) = self.helper(arguments.first())?;
        let next = after.first()?;
        let [target, source] = &next.arguments[..] else {
            return None;
        };
        if helper_tag(Some(source)) != Some(tag) {
            return None;
        }
        let options = CopyOptions::default();
        Some(match op(next)? {
            Op::Fill => self.operand(&arguments[1]).and_then(|source| {
                let target = self.span_of(target)?;
                Ok((
                    Instruction::Fill {
                        source,
                        target,
                        options,
                    },
                    1,
                ))
            }),
            Op::Pack => self.characters(&arguments[1..]).and_then(|source| {
                let target = self.tag(target)?;
                Ok((
                    Instruction::Pack {
                        source,
                        target,
                        options,
                    },
                    1,
                ))
            }),
            _ => return None,
        })
    }

    /// Characters one after the other.
    fn characters(&self, arguments: &[Bound]) -> Result<Span, Refusal> {
        let numbers = arguments.iter().map(|bound| {
            let address = self
                .tag(bound)?
                .address()
                .filter(|address| address.bank == Bank::Txt);
            address
                .map(|address| address.number)
                .ok_or_else(|| "Click packs consecutive characters".to_owned())
        });
        let numbers: Vec<u16> = numbers.collect::<Result<_, Refusal>>()?;
        match (numbers.first(), numbers.last()) {
            (Some(first), Some(last)) if usize::from(last.saturating_sub(*first)) + 1 == numbers.len() => {
                Ok(Span {
                    bank: Bank::Txt,
                    first: *first,
                    last: *last,
                })
            }
            _ => Err("Click packs consecutive characters".to_owned()),
        }
    }
}
