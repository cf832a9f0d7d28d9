//! The power of a network's steps: products of conditions, written out only where a statement needs them.

use crate::term::{Binding, Term};

/// A condition that power has passed. Those with one number are one.
#[derive(Debug, Clone)]
pub(crate) struct Factor {
    pub(crate) number: usize,
    pub(crate) term: Term,
}

/// Power at a point.
#[derive(Debug, Clone)]
pub(crate) enum Power {
    /// There never is any.
    Dead,
    /// Where all these hold; none: always.
    Live(Vec<Factor>),
}

impl Power {
    /// The rail's.
    pub(crate) fn rail() -> Power {
        Power::Live(Vec::new())
    }

    /// The power of something that is TRUE or FALSE by itself.
    pub(crate) fn of(number: usize, term: Term) -> Power {
        Power::Live(vec![Factor { number, term }])
    }

    /// After one more condition.
    pub(crate) fn and(&self, number: usize, term: Term) -> Power {
        match self {
            Power::Dead => Power::Dead,
            Power::Live(factors) => {
                let mut factors = factors.clone();
                factors.push(Factor { number, term });
                Power::Live(factors)
            }
        }
    }

    /// As an expression; none where it is always there.
    pub(crate) fn term(&self) -> Option<Term> {
        match self {
            Power::Dead => Some(Term::whole("FALSE")),
            Power::Live(factors) => {
                let terms: Vec<Term> = factors.iter().map(|factor| factor.term.clone()).collect();
                Term::all(&terms)
            }
        }
    }

    /// As an expression, `TRUE` where it is always there.
    pub(crate) fn or_true(&self) -> Term {
        self.term().unwrap_or_else(|| Term::whole("TRUE"))
    }

    /// Where two wires meet. What both have passed is reported once.
    pub(crate) fn or(&self, other: &Power, number: usize) -> Power {
        let (Power::Live(upper), Power::Live(lower)) = (self, other) else {
            return if matches!(self, Power::Dead) {
                other.clone()
            } else {
                self.clone()
            };
        };
        let same = upper
            .iter()
            .zip(lower)
            .take_while(|(a, b)| a.number == b.number)
            .count();
        let mut factors = upper[..same].to_vec();
        let rest = |factors: &[Factor]| {
            let terms: Vec<Term> = factors[same..].iter().map(|factor| factor.term.clone()).collect();
            Term::all(&terms)
        };
        if let (Some(upper), Some(lower)) = (rest(upper), rest(lower)) {
            let term = Term::binary(&upper, "OR", &lower, Binding::Or);
            factors.push(Factor { number, term });
        }
        Power::Live(factors)
    }

    /// Whether it is a name, or less: to be written as often as it is asked for.
    pub(crate) fn is_short(&self) -> bool {
        match self {
            Power::Dead => true,
            Power::Live(factors) => match factors.as_slice() {
                [] => true,
                [one] => one
                    .term
                    .text
                    .chars()
                    .all(|c| c.is_ascii_alphanumeric() || c == '_'),
                _ => false,
            },
        }
    }

    /// The numbers of its conditions.
    pub(crate) fn numbers(&self) -> Vec<usize> {
        match self {
            Power::Dead => Vec::new(),
            Power::Live(factors) => factors.iter().map(|factor| factor.number).collect(),
        }
    }
}
