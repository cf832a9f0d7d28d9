//! Pieces of an expression on their way into the text.

use std::collections::BTreeSet;

/// How tightly an expression holds together, loosest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Binding {
    Or,
    Xor,
    And,
    Equality,
    Order,
    Sum,
    Product,
    Unary,
    Whole,
}

/// The text of an expression, and what must be known of it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Term {
    pub(crate) text: String,
    pub(crate) binding: Binding,
    /// The variables of the unit that it reads.
    pub(crate) reads: BTreeSet<String>,
    /// Whether its value may be outside of its type until it is assigned: more than the width of an integer, or no finite real.
    pub(crate) is_raw: bool,
    /// Whether it may be evaluated only after what is checked before it.
    pub(crate) is_risky: bool,
}

impl Term {
    /// One that holds together and reads nothing.
    pub(crate) fn whole(text: impl Into<String>) -> Term {
        Term {
            text: text.into(),
            binding: Binding::Whole,
            reads: BTreeSet::new(),
            is_raw: false,
            is_risky: false,
        }
    }

    /// A variable of the unit.
    pub(crate) fn variable(name: &str) -> Term {
        let mut term = Term::whole(name);
        term.reads.insert(name.to_owned());
        term
    }

    /// As an operand of an operator that binds so.
    fn within(&self, binding: Binding) -> String {
        if self.binding < binding || (binding >= Binding::Product && self.text.starts_with('-')) {
            format!("({})", self.text)
        } else {
            self.text.clone()
        }
    }

    /// Takes over what is known of the parts.
    fn made_of(text: String, binding: Binding, parts: &[&Term]) -> Term {
        Term {
            text,
            binding,
            reads: parts.iter().flat_map(|part| part.reads.iter().cloned()).collect(),
            is_raw: parts.iter().any(|part| part.is_raw),
            is_risky: parts.iter().any(|part| part.is_risky),
        }
    }

    /// `a op b`. What is on the right of the same operator has parentheses unless the operator is associative.
    pub(crate) fn binary(a: &Term, operator: &str, b: &Term, binding: Binding) -> Term {
        let tighter = match binding {
            Binding::Or => Binding::Or,
            Binding::Xor => Binding::Xor,
            Binding::And => Binding::And,
            Binding::Equality => Binding::Order,
            Binding::Order => Binding::Sum,
            Binding::Sum => Binding::Product,
            _ => Binding::Unary,
        };
        // Comparisons in a row are not what anybody expects.
        let left = if matches!(binding, Binding::Equality | Binding::Order) {
            tighter
        } else {
            binding
        };
        let text = format!("{} {operator} {}", a.within(left), b.within(tighter));
        Term::made_of(text, binding, &[a, b])
    }

    /// `AND` of all; none is TRUE.
    pub(crate) fn all(terms: &[Term]) -> Option<Term> {
        let mut terms = terms.iter();
        let first = terms.next()?.clone();
        Some(terms.fold(first, |all, next| Term::binary(&all, "AND", next, Binding::And)))
    }

    /// `NOT a`; of what is already negated the inside.
    pub(crate) fn not(&self) -> Term {
        if self.binding == Binding::Unary
            && let Some(inner) = self.text.strip_prefix("NOT ")
        {
            return Term {
                text: inner.to_owned(),
                binding: Binding::Whole,
                ..self.clone()
            };
        }
        Term::made_of(
            format!("NOT {}", self.within(Binding::Unary)),
            Binding::Unary,
            &[self],
        )
    }

    /// `-a`
    pub(crate) fn negative(&self) -> Term {
        Term::made_of(
            format!("-{}", self.within(Binding::Whole)),
            Binding::Unary,
            &[self],
        )
    }

    /// `f(a, b)`
    pub(crate) fn call(function: &str, arguments: &[&Term]) -> Term {
        let texts: Vec<&str> = arguments.iter().map(|argument| argument.text.as_str()).collect();
        Term::made_of(
            format!("{function}({})", texts.join(", ")),
            Binding::Whole,
            arguments,
        )
    }

    /// The same, whose value may be outside of its type.
    pub(crate) fn raw(mut self) -> Term {
        self.is_raw = true;
        self
    }
}
