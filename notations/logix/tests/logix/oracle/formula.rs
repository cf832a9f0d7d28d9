//! Formulas of whole numbers and reals: their value.

use super::interpreter::Controller;

/// A number, and whether it is a real.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number {
    pub(super) value: f64,
    pub(super) is_real: bool,
}

/// What a formula is. `real`: its result is one.
pub(super) fn value(controller: &Controller, text: &str) -> Number {
    let mut parser = Parser {
        controller,
        rest: text,
    };
    let value = parser.sum();
    assert!(parser.rest.trim().is_empty(), "{text}");
    value
}

struct Parser<'c, 't> {
    controller: &'c Controller,
    rest: &'t str,
}

impl Parser<'_, '_> {
    fn eat(&mut self, what: &str) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(what) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> Number {
        let mut left = self.product();
        loop {
            if self.eat("+") {
                left = apply("ADD", left, self.product());
            } else if self.eat("-") {
                left = apply("SUB", left, self.product());
            } else {
                return left;
            }
        }
    }

    fn product(&mut self) -> Number {
        let mut left = self.single();
        loop {
            if self.eat("*") {
                left = apply("MUL", left, self.single());
            } else if self.eat("/") {
                left = apply("DIV", left, self.single());
            } else {
                return left;
            }
        }
    }

    fn single(&mut self) -> Number {
        if self.eat("(") {
            let inner = self.sum();
            assert!(self.eat(")"));
            return inner;
        }
        self.rest = self.rest.trim_start();
        let sign = usize::from(self.rest.starts_with('-'));
        let end = self.rest[sign..].find(|c: char| !(c.is_alphanumeric() || "._[]".contains(c)));
        let (word, rest) = self.rest.split_at(end.map_or(self.rest.len(), |end| end + sign));
        self.rest = rest;
        self.controller.operand(word)
    }
}

/// Two numbers: whole ones have 32 bits, a division by zero leaves the dividend.
pub(super) fn apply(name: &str, left: Number, right: Number) -> Number {
    let is_real = left.is_real || right.is_real;
    if is_real {
        let (a, b) = (left.value as f32, right.value as f32);
        let value = match name {
            "ADD" => a + b,
            "SUB" => a - b,
            "MUL" => a * b,
            _ => a / b,
        };
        return Number {
            value: f64::from(value),
            is_real,
        };
    }
    let (a, b) = (left.value as i64 as i32, right.value as i64 as i32);
    let value = match name {
        "ADD" => a.wrapping_add(b),
        "SUB" => a.wrapping_sub(b),
        "MUL" => a.wrapping_mul(b),
        "DIV" if b == 0 => a,
        "DIV" => a.wrapping_div(b),
        "MOD" => a.wrapping_rem(b),
        "AND" => a & b,
        "OR" => a | b,
        "XOR" => a ^ b,
        other => panic!("{other}"),
    };
    Number {
        value: f64::from(value),
        is_real,
    }
}
