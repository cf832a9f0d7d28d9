//! A value: its expression, its type, and what it can be.

use super::super::scope::Type;
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Expression, Literal, Path};

/// From the smallest to the largest number.
pub(super) type Range = (i128, i128);

/// Numbers beyond are not told apart.
const FAR: i128 = 1 << 100;

/// A value of an expression.
#[derive(Debug, Clone)]
pub(super) struct Value {
    pub(super) expression: Expression,
    pub(super) ty: Type,
    /// It is made of literals alone, and takes the type of what is next to it.
    pub(super) is_free: bool,
    /// What an integer can be if nothing is cut.
    pub(super) range: Range,
    /// What a type must hold so that nothing is cut within.
    pub(super) hull: Range,
    /// It is another one in a wider type: the bits of NOT.
    pub(super) is_fixed: bool,
    /// It is more than one value in the state of a block, which is read member by member.
    pub(super) is_in_instance: bool,
}

impl Value {
    /// A tag, a literal with a type, or what is made of them.
    pub(super) fn of(expression: impl Into<Expression>, ty: Type) -> Value {
        let range = bounds(&ty);
        Value {
            expression: expression.into(),
            ty,
            is_free: false,
            range,
            hull: range,
            is_fixed: false,
            is_in_instance: false,
        }
    }

    pub(super) fn path(path: Path, ty: Scalar) -> Value {
        Value::of(path, Type::Scalar(ty))
    }

    /// A whole number without a type.
    pub(super) fn number(number: i128, literal: Literal) -> Value {
        Value {
            expression: literal.into(),
            ty: Type::Scalar(Scalar::Lint),
            is_free: true,
            range: (number, number),
            hull: (number, number),
            is_fixed: false,
            is_in_instance: false,
        }
    }

    /// A tag or a literal.
    pub(super) fn is_atom(&self) -> bool {
        matches!(self.bare(), Expression::Literal(_) | Expression::Path(_))
    }

    /// Without parentheses around it.
    pub(super) fn bare(&self) -> &Expression {
        let mut bare = &self.expression;
        while let Expression::Group(inner) = bare {
            bare = inner;
        }
        bare
    }

    pub(super) fn scalar(&self) -> Option<Scalar> {
        self.ty.scalar()
    }

    pub(super) fn is_real(&self) -> bool {
        self.scalar().is_some_and(Scalar::is_real)
    }

    pub(super) fn is_integer(&self) -> bool {
        self.scalar().is_some_and(Scalar::is_integer)
    }

    pub(super) fn is_bool(&self) -> bool {
        self.scalar() == Some(Scalar::Bool)
    }

    /// What a type must hold so that the value itself is not cut either.
    pub(super) fn extent(&self) -> Range {
        join(self.range, self.hull)
    }
}

/// The numbers that a type holds; of others all.
fn bounds(ty: &Type) -> Range {
    ty.scalar().and_then(Scalar::bounds).unwrap_or((-FAR, FAR))
}

pub(super) fn join(a: Range, b: Range) -> Range {
    (a.0.min(b.0), a.1.max(b.1))
}

pub(super) fn is_within(range: Range, ty: Scalar) -> bool {
    ty.bounds()
        .is_some_and(|(low, high)| low <= range.0 && range.1 <= high)
}

/// The smallest of the wide types that holds some numbers; beyond LINT nothing does.
pub(super) fn wide(range: Range) -> Scalar {
    if is_within(range, Scalar::Dint) {
        Scalar::Dint
    } else {
        Scalar::Lint
    }
}

fn far((low, high): Range) -> Range {
    (low.clamp(-FAR, FAR), high.clamp(-FAR, FAR))
}

pub(super) fn sum(a: Range, b: Range) -> Range {
    far((a.0 + b.0, a.1 + b.1))
}

pub(super) fn difference(a: Range, b: Range) -> Range {
    far((a.0 - b.1, a.1 - b.0))
}

pub(super) fn product(a: Range, b: Range) -> Range {
    let all = [
        a.0.saturating_mul(b.0),
        a.0.saturating_mul(b.1),
        a.1.saturating_mul(b.0),
        a.1.saturating_mul(b.1),
    ];
    let low = all.iter().min().copied().unwrap_or(-FAR);
    let high = all.iter().max().copied().unwrap_or(FAR);
    far((low, high))
}

/// What a quotient can be.
pub(super) fn quotient(a: Range, b: Range) -> Range {
    if b.0 == b.1 && b.0 > 0 {
        return (a.0 / b.0, a.1 / b.0);
    }
    let most = a.0.abs().max(a.1.abs());
    if b.0 >= 0 {
        return (a.0.min(0), a.1.max(0));
    }
    (-most, most)
}

pub(super) fn remainder(a: Range, b: Range) -> Range {
    let most = (b.0.abs().max(b.1.abs()) - 1).max(0);
    (
        if a.0 < 0 { -most.min(-a.0) } else { 0 },
        if a.1 > 0 { most.min(a.1) } else { 0 },
    )
}
