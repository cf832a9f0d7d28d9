//! Copies, fillings and packed texts.

use super::Back;
use super::act::{helper_tag, op};
use super::value::Refusal;
use crate::address::{Address, Span, Tag};
use crate::bank::{Bank, Kind};
use crate::conversion::Convert;
use crate::convert;
use crate::grid;
use crate::model::{Action, Constant, CopyOptions, Instruction, Operand};
use crate::operand::kind;
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
    let Some((from, to, options)) = between_kinds(next) else {
        return false;
    };
    let follows = |first: u16, last: u16| last.checked_sub(first).map(u32::from);
    if let (
        Instruction::BlockCopy {
            source,
            target,
            options: given,
        },
        options,
    ) = (&mut *before, options)
    {
        let Some(first) = target.address() else {
            return false;
        };
        let is_next = given == options
            && source.bank == from.bank
            && first.bank == to.bank
            && source.last.checked_add(1) == Some(from.number)
            && follows(source.first, from.number) == follows(first.number, to.number);
        if is_next {
            source.last = from.number;
        }
        return is_next;
    }
    let Some((first, target, given)) = between_kinds(before) else {
        return false;
    };
    let is_next = given == options
        && (first.bank, target.bank) == (from.bank, to.bank)
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
            options: options.clone(),
        };
    }
    is_next
}

/// Where a copy of one address to one of another kind comes from and goes, and how. A number becomes several characters,
/// and is in no block.
fn between_kinds(what: &Instruction) -> Option<(Address, Address, &CopyOptions)> {
    let Instruction::Copy {
        source: Operand::Tag(source),
        target: Operand::Tag(target),
        options,
    } = what
    else {
        return None;
    };
    let (from, to) = (source.address()?, target.address()?);
    let is_block = options
        .convert
        .is_none_or(|convert| matches!(convert, Convert::Value | Convert::Ascii));
    (is_block && from.bank.kind() != to.bank.kind()).then_some((from, to, options))
}

impl Back<'_> {
    /// A copy; a text goes into several addresses by as many blocks.
    pub(super) fn copy(&self, source: Operand, target: Operand, after: &[&Block]) -> (Instruction, usize) {
        let is_text = |operand| kind(operand) == Some(Kind::Text);
        let options = CopyOptions {
            // A digit becomes its number.
            convert: (is_text(&source) && !is_text(&target)).then_some(Convert::Value),
            ..CopyOptions::default()
        };
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
        // Whether each address had a character is checked in between.
        let between = match after {
            [length, whole, ..] if op(length) == Some(Op::Len) && op(whole) == Some(Op::Eq) => 2,
            _ => 0,
        };
        let next = after.get(between)?;
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
            head @ (Op::Pack | Op::Typ) => self.characters(&arguments[1..]).and_then(|source| {
                let target = self.tag(target)?;
                let options = CopyOptions {
                    allow_whitespace: head == Op::Typ,
                    ..options
                };
                Ok((
                    Instruction::Pack {
                        source,
                        target,
                        options,
                    },
                    between + 1,
                ))
            }),
            _ => return None,
        })
    }

    /// A copy that turns a number into characters, or a character into its code or the reverse, by a tag of the importer's
    /// own. None: it is none.
    pub(super) fn converted(
        &self,
        block: &Block,
        after: &[&Block],
    ) -> Option<Result<(Instruction, usize), Refusal>> {
        let (_, what) = self.helper(block.arguments.first())?;
        let is_own = |block: &&&Block| {
            let mut all = block
                .arguments
                .iter()
                .filter_map(|bound| self.helper(Some(bound)));
            all.any(|(_, what)| convert::is_of_number(what))
        };
        let (convert, source, used) = match op(block)? {
            Op::Typ if what.starts_with(convert::NUMBER) => {
                let (_, told) = what.split_once(", ")?;
                let own = after.iter().take_while(|block| op(block) != Some(Op::Typ));
                (grid::convert(told).ok()?, 1, own.take_while(is_own).count())
            }
            Op::Find if what == convert::CODE => (Convert::Ascii, 2, 3),
            Op::Mov if what == convert::TO_CODE => (Convert::Binary, 1, 4),
            _ => return None,
        };
        let is_first = |block: &&&Block| {
            op(block) == Some(Op::Mid) || convert == Convert::Ascii && op(block) == Some(Op::Mov)
        };
        let target = after.get(..used)?.iter().find(is_first)?.arguments.first()?;
        let source = block.arguments.get(source)?;
        Some(self.operand(source).and_then(|source| {
            let copy = Instruction::Copy {
                source,
                target: self.operand(target)?,
                options: CopyOptions {
                    convert: Some(convert),
                    ..CopyOptions::default()
                },
            };
            Ok((copy, used))
        }))
    }

    /// Characters one after the other.
    fn characters(&self, arguments: &[Bound]) -> Result<Span, Refusal> {
        // What is hexadecimal begins with its base.
        let arguments = match arguments {
            [base, rest @ ..] if !rest.is_empty() && self.tag(base).is_err() => rest,
            all => all,
        };
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
