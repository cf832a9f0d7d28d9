//! A value that is being typed.

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, value_text};

/// A question for a value.
#[derive(Debug)]
pub(super) struct Prompt {
    pub(super) point: Point,
    pub(super) purpose: Purpose,
    pub(super) text: String,
    /// What is wrong with what was typed.
    pub(super) problem: Option<String>,
}

/// What is done with the value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Set,
    Force,
}

impl Prompt {
    pub(super) fn new(point: Point, purpose: Purpose) -> Prompt {
        Prompt {
            point,
            purpose,
            text: String::new(),
            problem: None,
        }
    }

    pub(super) fn put(&mut self, letter: char) {
        self.text.push(letter);
        self.problem = None;
    }

    pub(super) fn delete(&mut self) {
        self.text.pop();
        self.problem = None;
    }

    pub(super) fn clear(&mut self) {
        self.text.clear();
        self.problem = None;
    }

    /// The value, if it is one. Else the prompt says what is wrong.
    pub(super) fn value(&mut self) -> Option<Value> {
        match value_text::parse(self.text.trim(), self.point.ty) {
            Ok(value) => Some(value),
            Err(problem) => {
                self.problem = Some(problem);
                None
            }
        }
    }

    /// What can be typed, by an example.
    pub(super) fn example(&self) -> &'static str {
        match self.point.ty {
            Scalar::Bool => "1 or 0",
            Scalar::Time => "as in 1.5s or 250ms",
            Scalar::Date => "as in D#2026-11-21",
            Scalar::Tod => "as in TOD#13:45:00",
            Scalar::Dt => "as in DT#2026-11-21-13:45:00",
            ty if ty.is_string() => "as in 'text'",
            ty if ty.is_real() => "as in 2.5",
            ty if ty.is_bits() => "as in 255 or 16#FF",
            _ => "as in 42",
        }
    }
}
