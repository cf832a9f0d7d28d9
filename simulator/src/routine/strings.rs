//! The string functions (LANGUAGE §5.2): positions count from 1. A character is a byte, as in the STRING of IEC
//! 61131-3.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Memory, TextSlot};
use memchr::memmem;
use std::ops::Range;

/// Writes a text that is made of parts of others. None of them is the one that is written: results go to a slot of
/// their own first.
fn write(memory: &mut Memory, with: &mut Operands, to: TextSlot, parts: &[(TextSlot, Range<usize>)]) {
    let mut text = std::mem::take(&mut memory.texts[to.0 as usize]);
    text.set(&[]);
    for (from, range) in parts {
        text.push(&memory.text(*from)[range.clone()]);
    }
    with.count(text.bytes().len());
    memory.texts[to.0 as usize] = text;
}

/// The bytes that `count` characters from a position on are; a fault if the text does not have them.
fn part(memory: &Memory, text: TextSlot, count: i64, position: i64) -> Result<Range<usize>, Trouble> {
    let length = memory.text(text).len() as i64;
    if count < 0 || count > length {
        return Err(Trouble::Position {
            position: count,
            length,
        });
    }
    if position < 1 || position - 1 > length - count {
        return Err(Trouble::Position { position, length });
    }
    let start = position as usize - 1;
    Ok(start..start + count as usize)
}

pub(super) fn length(memory: &mut Memory, with: &mut Operands) {
    let to = with.word();
    memory.words[to.0 as usize] = memory.text(with.text()).len() as i64;
}

pub(super) fn left(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, count) = (with.text(), with.text(), with.value(memory));
    let range = part(memory, text, count, 1)?;
    write(memory, with, to, &[(text, range)]);
    Ok(())
}

pub(super) fn right(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, count) = (with.text(), with.text(), with.value(memory));
    let length = memory.text(text).len() as i64;
    let range = part(
        memory,
        text,
        count,
        length.saturating_sub(count).saturating_add(1),
    )?;
    write(memory, with, to, &[(text, range)]);
    Ok(())
}

pub(super) fn middle(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, count, position) = (with.text(), with.text(), with.value(memory), with.value(memory));
    let range = part(memory, text, count, position)?;
    write(memory, with, to, &[(text, range)]);
    Ok(())
}

pub(super) fn concat(memory: &mut Memory, with: &mut Operands) {
    let to = with.text();
    let mut text = std::mem::take(&mut memory.texts[to.0 as usize]);
    text.set(&[]);
    let list = with.list();
    with.count(list.len());
    for &from in list {
        text.push(memory.text(TextSlot(from)));
    }
    with.count(text.bytes().len());
    memory.texts[to.0 as usize] = text;
}

/// After a position; 0 is before the first character.
pub(super) fn insert(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, inserted, position) = (with.text(), with.text(), with.text(), with.value(memory));
    let length = memory.text(text).len();
    let at = usize::try_from(position).ok().filter(|&at| at <= length);
    let at = at.ok_or(Trouble::Position {
        position,
        length: length as i64,
    })?;
    let whole = 0..memory.text(inserted).len();
    write(
        memory,
        with,
        to,
        &[(text, 0..at), (inserted, whole), (text, at..length)],
    );
    Ok(())
}

pub(super) fn delete(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, count, position) = (with.text(), with.text(), with.value(memory), with.value(memory));
    let range = part(memory, text, count, position)?;
    let length = memory.text(text).len();
    write(
        memory,
        with,
        to,
        &[(text, 0..range.start), (text, range.end..length)],
    );
    Ok(())
}

pub(super) fn replace(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, text, new) = (with.text(), with.text(), with.text());
    let (count, position) = (with.value(memory), with.value(memory));
    let range = part(memory, text, count, position)?;
    let (length, whole) = (memory.text(text).len(), 0..memory.text(new).len());
    write(
        memory,
        with,
        to,
        &[(text, 0..range.start), (new, whole), (text, range.end..length)],
    );
    Ok(())
}

/// The position of the first occurrence, 0 if there is none. Nothing occurs nowhere.
pub(super) fn find(memory: &mut Memory, with: &mut Operands) {
    let (to, text, wanted) = (with.word(), with.text(), with.text());
    let (text, wanted) = (memory.text(text), memory.text(wanted));
    with.count(text.len() + wanted.len());
    let found = match wanted.len() {
        0 => None,
        _ => memmem::find(text, wanted),
    };
    memory.words[to.0 as usize] = found.map_or(0, |at| at as i64 + 1);
}
