//! `[MUX]` and `[LUT]`: one of several values.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Bit, Memory, TextSlot, Word};

/// The member of a list that a selector names, from 0.
fn chosen(memory: &Memory, with: &mut Operands) -> Result<u32, Trouble> {
    let value = with.value(memory);
    let list = with.list();
    let member = usize::try_from(value).ok().and_then(|n| list.get(n));
    member.copied().ok_or(Trouble::Selector {
        value,
        count: list.len() as i64,
    })
}

pub(super) fn bit(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let to = with.bit();
    let value = memory.bit(Bit(chosen(memory, with)?));
    memory.set_bit(to, value);
    Ok(())
}

pub(super) fn word(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let to = with.word();
    memory.words[to.0 as usize] = memory.word(Word(chosen(memory, with)?));
    Ok(())
}

pub(super) fn text(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let to = with.text();
    let from = TextSlot(chosen(memory, with)?);
    with.count(memory.text(from).len());
    memory.copy_text::<false>(to, from);
    Ok(())
}
