//! `[LUT]` and `[PWL]` as LDmicro's simulator has them: outside the table there is no value.

use super::Operands;
use crate::memory::{Memory, Word};
use crate::operation::Width;

/// The entry that an index names, from 0.
pub(super) fn entry(memory: &mut Memory, with: &mut Operands) {
    let (to, hit, _) = (with.word(), with.bit(), with.ty());
    let index = with.value(memory);
    let list = with.list();
    let entry = usize::try_from(index).ok().and_then(|index| list.get(index));
    memory.set_bit(hit, entry.is_some());
    if let Some(&entry) = entry {
        memory.words[to.0 as usize] = memory.word(Word(entry));
    }
}

/// The point on the first line that ends at x or after it, computed in the width of the result.
pub(super) fn point(memory: &mut Memory, with: &mut Operands) {
    let (to, hit, width) = (with.word(), with.bit(), Width::of(with.ty()));
    let x = with.value(memory);
    let list = with.list();
    with.count(list.len());
    let value = |slot: u32| memory.word(Word(slot));
    let points = list.chunks_exact(2).map(|pair| (value(pair[0]), value(pair[1])));
    let lines = points.clone().zip(points.skip(1));
    let y = lines
        .into_iter()
        .find(|(_, (x1, _))| x <= *x1)
        .map(|((x0, y0), (x1, y1))| {
            let way = width.wrap(width.wrap(x - x0).wrapping_mul(width.wrap(y1 - y0)));
            let dx = width.wrap(x1 - x0);
            let rise = if dx == 0 { 0 } else { way.wrapping_div(dx) };
            width.wrap(rise.wrapping_add(y0))
        });
    memory.set_bit(hit, y.is_some());
    if let Some(y) = y {
        memory.words[to.0 as usize] = y;
    }
}
