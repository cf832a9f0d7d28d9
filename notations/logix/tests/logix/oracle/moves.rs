//! Arithmetic, moves, copies.

use super::formula;
use super::interpreter::Controller;

impl Controller {
    pub(super) fn compute(&mut self, name: &str, o: &[String]) {
        match name {
            "MOV" => self.set(&o[1], self.operand(&o[0]).value),
            "CLR" => self.set(&o[0], 0.0),
            "NOT" => self.set(&o[1], !self.whole(&o[0]) as f64),
            "NEG" => self.set(&o[1], (self.whole(&o[0]) as i32).wrapping_neg().into()),
            "CPT" => {
                let value = formula::value(self, &o[1]).value;
                self.set(&o[0], value);
            }
            "MVM" => {
                let (source, mask, before) = (self.whole(&o[0]), self.whole(&o[1]), self.whole(&o[2]));
                self.set(&o[2], ((before & !mask) | (source & mask)) as f64);
            }
            "BTD" => {
                let width = match self.type_of(&o[2]) {
                    "SINT" => 8,
                    "INT" => 16,
                    _ => 32,
                };
                let (mut after, source) = (self.whole(&o[2]), self.whole(&o[0]));
                let (from, to, length) = (self.whole(&o[1]), self.whole(&o[3]), self.whole(&o[4]));
                for bit in 0..length {
                    if to + bit < width {
                        let high = source >> (from + bit) & 1;
                        after = after & !(1 << (to + bit)) | high << (to + bit);
                    }
                }
                self.set(&o[2], after as f64);
            }
            "COP" | "FLL" => {
                let (to, first) = o[1].split_once('[').expect("an element");
                let first: usize = first.trim_end_matches(']').parse().expect("an index");
                let most = self.sizes[to] - first;
                let length = o[2].parse::<usize>().expect("a length").min(most);
                let values: Vec<f64> = (0..length)
                    .map(|at| match name {
                        "FLL" => self.operand(&o[0]).value,
                        _ => self.get(&format!("{to}[{at}]")),
                    })
                    .collect();
                for (at, value) in values.into_iter().enumerate() {
                    self.set(&format!("{to}[{}]", first + at), value);
                }
            }
            name => {
                let value = formula::apply(name, self.operand(&o[0]), self.operand(&o[1]));
                self.set(&o[2], value.value);
            }
        }
    }
}
