//! `[SEARCH]`, and tables outside of which there is nothing.

use super::Scan;
use super::ranges::{is_whole, width};
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Routine, Test, Word, type_of};

impl Scan<'_, '_> {
    /// The first element that compares with another as asked, after index y if NEXT is high. None: it is not followed.
    pub(super) fn search(&mut self, pool: &[u32]) -> Option<()> {
        let [
            y,
            y_type,
            first,
            test,
            a,
            a_type,
            start,
            count,
            element,
            base,
            next,
            found,
            ..,
        ] = *pool
        else {
            return None;
        };
        let (first, test) = (self.word(Word(first)), Test::of_operand(test));
        let is_text = type_of(element).is_string();
        // A whole number next to a real would have to become one.
        if is_text || type_of(element).is_real() != type_of(a_type).is_real() {
            return None;
        }
        let span = self.span([start, count])?;
        let width = width(y_type);
        let nothing = Number::constant(width.wrap(-1));
        let (before, next) = (self.word(Word(y)), self.bit(Bit(next)));
        let graph = &mut self.world.graph;
        let had_nothing = graph.equal(&before, &nothing);
        let is_over = graph.and(next, had_nothing);
        let before = before.seen_as(width);
        let (mut value, mut hit) = (nothing, Lit::FALSE);
        for slot in span.slots.clone().rev() {
            let mut is_it = self.compare_element(test, (slot, element), (a, a_type));
            let is_in = self.is_in(&span, slot);
            let graph = &mut self.world.graph;
            let place = Number::constant(i64::from(slot) - i64::from(base));
            let index = graph.add(&first, &place).as_word();
            let is_after = graph.less(&before, &index);
            let is_asked = graph.or(!next, is_after);
            is_it = graph.all([is_it, is_in, is_asked, !is_over]);
            value = graph.choose_number(is_it, &index.wrapped(width), &value);
            hit = graph.or(hit, is_it);
        }
        self.write_word(Word(y), value);
        self.write_bit(Bit(found), hit);
        Some(())
    }

    fn compare_element(&mut self, test: Test, (slot, ty): (u32, u32), (a, a_type): (u32, u32)) -> Lit {
        if type_of(ty) == Scalar::Bool {
            let (left, right) = (self.bit(Bit(slot)), self.bit(Bit(a)));
            let graph = &mut self.world.graph;
            let (less, equal) = (graph.and(!left, right), graph.same(left, right));
            return self.holds(test, less, equal);
        }
        let (left, right) = (self.word(Word(slot)), self.word(Word(a)));
        if !is_whole(ty) {
            return self.compare_real(test, &left, &right);
        }
        self.compare(test, &left.seen_as(width(ty)), &right.seen_as(width(a_type)))
    }

    /// An entry of a table, or a point on a curve, where there is one.
    pub(super) fn open_table(&mut self, routine: Routine, pool: &[u32]) -> Option<()> {
        let [to, hit, ty, x, count, list @ ..] = pool else {
            return None;
        };
        let width = width(*ty);
        let x = self.word(Word(*x));
        let entries: Vec<Number> = list
            .get(..*count as usize)?
            .iter()
            .map(|&at| self.word(Word(at)))
            .collect();
        let graph = &mut self.world.graph;
        let (mut value, mut found) = (Number::constant(0), Lit::FALSE);
        if routine == Routine::OpenTable {
            for (n, entry) in entries.iter().enumerate() {
                let is_it = graph.equal(&x, &Number::constant(n as i64));
                value = graph.choose_number(is_it, entry, &value);
                found = graph.or(found, is_it);
            }
        } else {
            let points: Vec<&[Number]> = entries.chunks_exact(2).collect();
            for line in points.windows(2).rev() {
                let ([x0, y0], [x1, y1]) = (line[0], line[1]) else {
                    return None;
                };
                let is_it = !graph.less(x1, &x);
                let run = graph.sub(&x, x0).wrapped(width);
                let rise = graph.sub(y1, y0).wrapped(width);
                let way = graph.mul(&run, &rise, 64).wrapped(width);
                let dx = graph.sub(x1, x0).wrapped(width);
                let is_none = graph.equal(&dx, &Number::constant(0));
                let rise = graph.div(&way, &dx).0.as_word();
                let rise = graph.choose_number(is_none, &Number::constant(0), &rise);
                let y = graph.add(&rise, y0).wrapped(width);
                value = graph.choose_number(is_it, &y, &value);
                found = graph.or(found, is_it);
            }
        }
        self.write_bit(Bit(*hit), found);
        // Nothing else reads it where there is none.
        self.write_word(Word(*to), value);
        Some(())
    }
}
