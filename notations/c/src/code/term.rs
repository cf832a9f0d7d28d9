//! Conditions as expressions of C: a power that is read once is not stored, but part of the expression that reads it.

use super::Emitter;
use ladder_simulator::compiled::Bit;

/// How tight an expression holds its parts together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Atom,
    Comparison,
    And,
    Or,
}

/// An expression that is 0 or 1.
#[derive(Debug, Clone)]
pub(super) struct Term {
    pub(super) text: String,
    rank: Rank,
}

impl Term {
    pub(super) fn atom(text: impl Into<String>) -> Term {
        let (text, rank) = (text.into(), Rank::Atom);
        Term { text, rank }
    }

    pub(super) fn comparison(text: impl Into<String>) -> Term {
        let (text, rank) = (text.into(), Rank::Comparison);
        Term { text, rank }
    }

    /// In parentheses unless it holds as tight as this.
    pub(super) fn within(self, rank: Rank) -> String {
        if self.rank > rank {
            format!("({})", self.text)
        } else {
            self.text
        }
    }

    pub(super) fn and(self, other: Term) -> Term {
        match (&*self.text, &*other.text) {
            ("1", _) => other,
            (_, "1") => self,
            _ => Term {
                text: format!("{} && {}", self.within(Rank::And), other.within(Rank::And)),
                rank: Rank::And,
            },
        }
    }

    pub(super) fn or(self, other: Term) -> Term {
        // Compilers ask for parentheses around `&&` in `||`.
        let part = |term: Term| match term.rank {
            Rank::Or => term.text,
            _ => term.within(Rank::Comparison),
        };
        Term {
            text: format!("{} || {}", part(self), part(other)),
            rank: Rank::Or,
        }
    }
}

impl std::ops::Not for Term {
    type Output = Term;

    fn not(self) -> Term {
        match &*self.text {
            "0" => Term::atom("1"),
            "1" => Term::atom("0"),
            _ => Term::atom(format!("!{}", self.within(Rank::Atom))),
        }
    }
}

/// A value that was not stored yet, as one statement after it reads it.
pub(super) struct Pending {
    bit: Bit,
    term: Term,
    /// What computes it remembers something: it is evaluated once, whatever else is known.
    remembers: bool,
}

impl Emitter<'_> {
    /// A bit where it is in the memory.
    pub(super) fn slot(&self, bit: Bit) -> String {
        format!("b[{}]", self.constants.bit(bit))
    }

    /// A bit as part of an expression.
    pub(super) fn term(&self, bit: Bit) -> Term {
        if bit == Bit::LOW {
            return Term::atom("0");
        }
        if bit == Bit::HIGH || self.always.contains(&bit) {
            return Term::atom("1");
        }
        let mut pending = self.pending.borrow_mut();
        let is_it = |pending: &Pending| pending.bit == bit && !pending.remembers;
        match pending.iter().position(is_it) {
            Some(at) => pending.remove(at).term,
            None => Term::atom(self.slot(bit)),
        }
    }

    /// A bit as an operand of what holds tight.
    pub(super) fn b(&self, bit: Bit) -> String {
        self.term(bit).within(Rank::Atom)
    }

    /// A bit as all that is evaluated: also what remembers something.
    pub(super) fn whole(&self, bit: Bit) -> String {
        let mut pending = self.pending.borrow_mut();
        if matches!(&pending[..], [only] if only.bit == bit) {
            return pending.remove(0).term.text;
        }
        drop(pending);
        self.term(bit).text
    }

    /// A bit that follows from others, and from what is in the memory now.
    pub(super) fn power(&mut self, to: Bit, term: Term) {
        self.settle();
        self.defer(to, term, false);
    }

    /// A bit that is computed by what remembers something.
    pub(super) fn remembered(&mut self, to: Bit, call: String) {
        self.flush();
        self.defer(to, Term::atom(call), true);
    }

    fn defer(&mut self, bit: Bit, term: Term, remembers: bool) {
        if self.once.contains(&bit) {
            self.pending.borrow_mut().push(Pending { bit, term, remembers });
        } else {
            self.bit(bit, term.text);
        }
    }

    /// Stores what was computed by what remembers something: nothing is evaluated before it.
    fn settle(&mut self) {
        if self.pending.borrow().iter().any(|pending| pending.remembers) {
            self.flush();
        }
    }

    /// Stores what no statement has read.
    pub(super) fn flush(&mut self) {
        for pending in self.pending.take() {
            let text = format!("{} = {};", self.slot(pending.bit), pending.term.text);
            self.write_line(&text);
        }
    }
}
