//! `[PWL]`: a curve through points that are known.

use super::Scan;
use super::ranges::{is_whole, width};
use crate::number::Number;
use ladder_simulator::compiled::Word;

impl Scan<'_, '_> {
    /// The height of a curve of whole numbers, held flat outside and cut off toward zero. None: one of its points is a tag, or too
    /// far from the next to be computed.
    pub(super) fn curve(&mut self, pool: &[u32]) -> Option<()> {
        let [to, ty, x, count, list @ ..] = pool else {
            return None;
        };
        if !is_whole(*ty) {
            return None;
        }
        let width = width(*ty);
        let x = self.word(Word(*x)).seen_as(width);
        let known = list.get(..*count as usize)?.iter();
        let known: Option<Vec<i64>> = known.map(|&at| self.word(Word(at)).known()).collect();
        let known = known?;
        let points: Vec<(i64, i64)> = known.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        // All that is computed has room in 64 bits.
        let is_small = |number: &i64| number.unsigned_abs() <= 1 << 30;
        if x.len() > 33 || !known.iter().all(is_small) {
            return None;
        }
        let mut value = Number::constant(points.last()?.1);
        // The first point that is right of x decides: the last to be put in.
        for (n, &(x1, y1)) in points.iter().enumerate().rev() {
            let graph = &mut self.world.graph;
            let height = match n.checked_sub(1).map(|before| points[before]) {
                None => Number::constant(y1),
                // A place where x cannot be: points that are not in order.
                Some((x0, _)) if x0 >= x1 => Number::constant(y1),
                Some((x0, y0)) => {
                    let (span, rise) = (x1 - x0, y1 - y0);
                    let way = graph.sub(&x, &Number::constant(x0));
                    let way = graph.mul(&way, &Number::constant(rise), 128);
                    let scaled = graph.add(&way, &Number::constant(y0 * span));
                    graph.div(&scaled, &Number::constant(span)).0
                }
            };
            let is_left = graph.less(&x, &Number::constant(x1));
            value = graph.choose_number(is_left, &height, &value);
        }
        self.write_word(Word(*to), value.wrapped(width));
        Some(())
    }
}
