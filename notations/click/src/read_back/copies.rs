//! Copies, fillings and packed texts.

use super::Back;
use super::act::{helper_tag, op};
use super::value::Refusal;
use crate::address::{Address, Span, Tag};
use crate::bank::Bank;
use crate::model::{Action, Constant, CopyOptions, Instruction, Operand};
use ladder_analysis::program::{Block, Bound};
use ladder_instructions::Op;

/// Actions one after the other, in which copies of consecutive addresses to ones of another kind are one copy of a block.
pub(super) fn blocks(actions: Vec<Action>) -> Vec<Action> {
    let mut out: Vec<Action> = Vec::with_capacity(actions.len());
    for action in actions {
        let goes_on = out.last_mut().is_some_and(|last| {
            last.comment.is_none() && last.oneshot == action.oneshot && grows(&mut last.what, &action.what)
        });
        match out.last_mut().filter(|_| goes_on) {
            Some(last) => last.comment = action.comment,
            None => out.push(action),
        }
    }
    out
}

/// Whether a copy goes on with the one before it, or with a block of them, which then holds it too.
fn grows(before: &mut Instruction, next: &Instruction) -> bool {
    let Some((from, to)) = between_kinds(next) else {
        return false;
    };
    let follows = |first: u16, last: u16| last.checked_sub(first).map(u32::from);
    if let Instruction::BlockCopy { source, target, .. } = before {
        let Some(first) = target.address() else {
            return false;
        };
        let is_next = source.bank == from.bank
            && first.bank == to.bank
            && source.last.checked_add(1) == Some(from.number)
            && follows(source.first, from.number) == follows(first.number, to.number);
        if is_next {
            source.last = from.number;
        }
        return is_next;
    }
    let Some((first, target)) = between_kinds(before) else {
        return false;
    };
    let is_next = (first.bank, target.bank) == (from.bank, to.bank)
        && first.number.checked_add(1) == Some(from.number)
        && target.number.checked_add(1) == Some(to.number);
    if is_next {
        *before = Instruction::BlockCopy {
            source: Span {
                bank: first.bank,
                first: first.number,
                last: from.number,
            },
            target: target.into(),
            options: CopyOptions::default(),
        };
    }
    is_next
}

/// Where a copy of one address to one of another kind comes from and goes.
fn between_kinds(what: &Instruction) -> Option<(Address, Address)> {
    let Instruction::Copy {
        source: Operand::Tag(source),
        target: Operand::Tag(target),
        ..
    } = what
    else {
        return None;
    };
    let (from, to) = (source.address()?, target.address()?);
    (from.bank.kind() != to.bank.kind()).then_some((from, to))
}

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
