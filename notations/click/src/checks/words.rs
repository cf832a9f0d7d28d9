//! The words of the notation that a program is in: who draws a grid has never heard of `reset=lambda:`.

use super::super::address::{Span, Tag};
use super::super::bank::Bank;
use super::super::dsl::spell;
use super::super::grid;
use super::super::model::{Bits, Comparison, MathKind, Operand};

/// The notation that a program is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Words {
    /// The Python DSL.
    Dsl,
    /// The grid.
    Grid,
}

/// A pin of a timer, a counter or a shift register.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pin {
    Reset,
    Down,
    Clock,
}

impl Words {
    const fn choose<'w>(self, dsl: &'w str, grid: &'w str) -> &'w str {
        match self {
            Words::Dsl => dsl,
            Words::Grid => grid,
        }
    }

    /// What ends a subroutine.
    pub(super) const fn back(self) -> &'static str {
        self.choose("return", "return()")
    }

    /// What ends a loop.
    pub(super) const fn next(self) -> &'static str {
        self.choose("next_loop()", "next()")
    }

    /// Where an instruction is that no contact stops.
    pub(super) const fn alone(self) -> &'static str {
        self.choose("under `if True:`", "on a rung without contacts")
    }

    /// Where an instruction is that nothing else is next to it.
    pub(super) const fn alone_on_rung(self) -> &'static str {
        self.choose(
            "alone on its rung, without contacts: under `if True:`",
            "alone on its rung, without contacts",
        )
    }

    /// How a subroutine is made.
    pub(super) const fn subroutine(self) -> &'static str {
        self.choose("write it with @sub above it", "its file lies next to this one")
    }

    /// How a pin is given.
    pub(super) const fn pin(self, pin: Pin) -> &'static str {
        match pin {
            Pin::Reset => self.choose("reset=lambda: ..", "a row below it with .reset()"),
            Pin::Down => self.choose("count_down=lambda: ..", "a row below it with .down()"),
            Pin::Clock => self.choose("clock=lambda: ..", "a row below it with .clock()"),
        }
    }

    /// The contact of a rise.
    pub(super) const fn rise(self) -> &'static str {
        self.choose("re(..)", "rise(..)")
    }

    /// The contact that always conducts.
    pub(super) const fn always_on(self) -> &'static str {
        self.choose("sc[1]", "SC1")
    }

    /// The relations that texts have.
    pub(super) const fn equalities(self) -> &'static str {
        self.choose("eq and ne", "== and !=")
    }

    /// An instruction that computes.
    pub(super) const fn math(self, kind: MathKind) -> &'static str {
        match kind {
            MathKind::Decimal => self.choose("calc()", "calc(mode=decimal)"),
            MathKind::Hex => self.choose("math_hex()", "calc(mode=hex)"),
        }
    }

    pub(super) fn bank(self, bank: Bank) -> &'static str {
        self.choose(bank.row().dsl, bank.row().name)
    }

    pub(super) fn tag(self, tag: &Tag) -> String {
        match (self, tag.address()) {
            (Words::Grid, Some(address)) => address.to_string(),
            _ => tag.dsl(),
        }
    }

    pub(super) fn span(self, span: &Span) -> String {
        match self {
            Words::Dsl => span.dsl(),
            Words::Grid => span.to_string(),
        }
    }

    pub(super) fn bits(self, bits: &Bits) -> String {
        match bits {
            Bits::One(tag) => self.tag(tag),
            Bits::Many(span) => self.span(span),
        }
    }

    pub(super) fn operand(self, operand: &Operand) -> String {
        let of_grid = || (self == Words::Grid).then(|| grid::operand(operand)).flatten();
        of_grid().unwrap_or_else(|| spell::operand(operand))
    }

    pub(super) fn comparison(self, comparison: &Comparison) -> String {
        format!(
            "{} {} {}",
            self.operand(&comparison.left),
            comparison.relation.sign(),
            self.operand(&comparison.right)
        )
    }
}
