//! Expressions as formulas. What a formula cannot hold is computed before it.

use super::super::dialect::Dialect;
use super::super::scope::Type;
use super::super::tree::{Expression as Tree, ExpressionKind, LiteralKind};
use super::function::of_unknown_type;
use super::literal::literal;
use super::place::has_computed_index;
use super::value::{Value, difference, join, product, quotient, remainder, sum};
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Block, Expression, Literal, Operator, Sign};

impl Lowering<'_, '_> {
    /// The value of an expression.
    pub(super) fn value(&mut self, tree: &Tree) -> Lowered<Value> {
        match &tree.kind {
            ExpressionKind::Literal(kind, text) => literal(*kind, text, self.around.scope),
            ExpressionKind::Place(place) => {
                if place.steps.is_empty() && self.around.scope.known(&place.root).is_none() {
                    for truth in [true, false] {
                        let literal = Literal::from(truth);
                        if literal.as_str().eq_ignore_ascii_case(&place.root) {
                            return Ok(Value::of(literal, Type::BOOL));
                        }
                    }
                }
                if let Some((word, index)) = self.computed_bit(place)? {
                    let shifted = Expression::from(word).with(Operator::Shr, index);
                    let is_on = shifted.with(Operator::And, 1).with(Operator::NotEqual, 0);
                    return Ok(Value::of(is_on, Type::BOOL));
                }
                if let Some(part) = self.part(place)? {
                    return self.value_of_part(&part);
                }
                let (path, ty) = self.path(place)?;
                if ty == Type::Unknown {
                    return Err(of_unknown_type(&path.to_string()));
                }
                let is_in_instance = ty.scalar().is_none() && self.is_in_instance(place);
                Ok(Value {
                    is_in_instance,
                    ..Value::of(path, ty)
                })
            }
            ExpressionKind::Group(inner) => {
                let value = self.value(inner)?;
                if value.is_atom() {
                    return Ok(value);
                }
                let expression = Expression::Group(Box::new(value.bare().clone()));
                Ok(Value { expression, ..value })
            }
            ExpressionKind::Unary(sign, inner) => {
                let value = self.value(inner)?;
                self.unary(*sign, value)
            }
            ExpressionKind::Binary(operator, left, right) => {
                let stops_early = self.around.dialect == Dialect::Iec && may_fault(right);
                let value = self.value(left)?;
                // Of bits both sides are computed.
                let is_truth = value.is_bool() && matches!(operator, Operator::And | Operator::Or);
                if stops_early && is_truth {
                    return self.lazy(*operator, value, right);
                }
                let left = self.kept_before(value, right)?;
                let right = self.value(right)?;
                self.binary(*operator, left, right)
            }
            ExpressionKind::Lazy(operator, left, right) if may_fault(right) => {
                let left = self.value(left)?;
                self.lazy(*operator, left, right)
            }
            ExpressionKind::Lazy(operator, left, right) => {
                let left = self.value(left)?;
                let right = self.value(right)?;
                self.binary(*operator, left, right)
            }
            ExpressionKind::Call(call) => self.function(call),
        }
    }

    /// The left operand: what a function of the user may change is read before the function runs.
    fn kept_before(&mut self, value: Value, right: &Tree) -> Lowered<Value> {
        if !self.calls_user(right) || matches!(value.bare(), Expression::Literal(_)) {
            return Ok(value);
        }
        if value.bare().path().is_some_and(|path| self.is_temporary(path)) {
            return Ok(value);
        }
        let ty = value.scalar().ok_or("such a value cannot be kept here")?;
        if !value.is_atom() {
            return self.atom(value);
        }
        self.made_by("MOV", ty, vec![value.bare().clone()])
    }

    fn unary(&mut self, sign: Sign, value: Value) -> Lowered<Value> {
        let expression = Expression::Unary(sign, Box::new(value.expression.clone()));
        let ty = value.scalar().ok_or("a value of such a type has no sign")?;
        match sign {
            Sign::Minus if ty.is_bits() => {
                let value = self.number_of_bits(value)?;
                self.unary(sign, value)
            }
            Sign::Minus if value.is_integer() => {
                let range = difference((0, 0), value.range);
                // An unsigned number has no negative.
                if !ty.is_signed() {
                    let value = self.atom(value)?;
                    let value = self.made_by("MOV", super::value::wide(range), vec![value.expression])?;
                    return self.unary(sign, value);
                }
                let hull = join(value.hull, (0, 0));
                let expression = Expression::Unary(sign, Box::new(value.expression.clone()));
                Ok(Value {
                    expression,
                    ty: Type::Scalar(ty),
                    range,
                    hull,
                    ..value
                })
            }
            Sign::Minus if value.is_real() || ty == Scalar::Time => Ok(Value { expression, ..value }),
            Sign::Not if value.is_bool() || ty.is_bits() || ty.is_integer() => {
                let fixed = Value::of(expression, value.ty.clone());
                let is_fixed = !value.is_bool();
                Ok(Value {
                    is_fixed,
                    is_free: value.is_free,
                    ..fixed
                })
            }
            _ => Err(format!("{ty} has no sign")),
        }
    }

    /// The number that bits are, without a sign: arithmetic takes no bit strings here.
    pub(super) fn number_of_bits(&mut self, value: Value) -> Lowered<Value> {
        let to = match value.scalar() {
            Some(Scalar::Byte) => Scalar::Usint,
            Some(Scalar::Word) => Scalar::Uint,
            Some(Scalar::Dword) => Scalar::Udint,
            Some(Scalar::Lword) => Scalar::Ulint,
            _ => return Ok(value),
        };
        let value = self.atom(value)?;
        self.made_by("MOV", to, vec![value.expression])
    }

    /// `left operator right`
    pub(super) fn binary(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Value> {
        let (left, right) = (self.as_it_is(left), self.as_it_is(right));
        match operator {
            Operator::And | Operator::Or | Operator::Xor => self.logic(operator, left, right),
            _ if operator.compares() => self.comparison(operator, left, right),
            _ => self.arithmetic(operator, left, right),
        }
    }

    /// What an instruction has made of literals has a type once something else is made of it.
    pub(super) fn as_it_is(&self, value: Value) -> Value {
        let is_made = value.bare().path().is_some_and(|path| self.is_temporary(path));
        Value {
            is_free: value.is_free && !is_made,
            ..value
        }
    }

    fn logic(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Value> {
        let (left, right, ty) = self.alike(left, right)?;
        if ty != Scalar::Bool && !ty.is_bits() && !ty.is_integer() {
            return Err(format!("{ty} has no bits"));
        }
        let is_free = left.is_free && right.is_free;
        let value = Value::of(left.expression.with(operator, right.expression), Type::Scalar(ty));
        Ok(Value {
            is_fixed: ty != Scalar::Bool,
            is_free,
            ..value
        })
    }

    fn comparison(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Value> {
        let (left, right) = self.comparable(left, right)?;
        Ok(Value::of(
            left.expression.with(operator, right.expression),
            Type::BOOL,
        ))
    }

    /// Two values that can be compared.
    pub(super) fn comparable(&mut self, left: Value, right: Value) -> Lowered<(Value, Value)> {
        if let (Type::Enumeration(one), Type::Enumeration(other)) = (&left.ty, &right.ty) {
            let is_same = one == other;
            return is_same
                .then_some((left, right))
                .ok_or_else(|| "two enumerations are compared".to_owned());
        }
        if left.is_integer() && right.is_integer() {
            let (left, right) = (self.exact(left)?, self.exact(right)?);
            // A number that the other side's type does not hold is compared with a wider one.
            let left = self.roomy(left, &right)?;
            let right = self.roomy(right, &left)?;
            if left.is_free || right.is_free || left.ty == right.ty {
                return Ok((left, right));
            }
            let (left, right) = (self.atom(left)?, self.atom(right)?);
            return Ok((left, right));
        }
        let left = self.measured(left, &right)?;
        let right = self.measured(right, &left)?;
        let (left, right, _) = self.alike(left, right)?;
        Ok((left, right))
    }

    /// What is compared with a real number is one: a literal takes the type of the other side.
    fn measured(&mut self, value: Value, other: &Value) -> Lowered<Value> {
        if value.is_free && !value.is_atom() {
            return self.atom(value).map(|value| Value {
                is_free: false,
                ..value
            });
        }
        match value.scalar() {
            Some(ty) if ty.is_integer() && !value.is_free && other.is_real() => {
                let value = self.atom(value)?;
                let mnemonic = if ty.width() < 64 { "MOV" } else { "TYP" };
                self.made_by(mnemonic, Scalar::Lreal, vec![value.expression])
            }
            _ => Ok(value),
        }
    }

    fn roomy(&mut self, value: Value, other: &Value) -> Lowered<Value> {
        let ty = value.scalar().unwrap_or(Scalar::Lint);
        if other.is_free && !value.is_free && !super::value::is_within(other.range, ty) {
            let value = self.atom(value)?;
            return self.made_by("MOV", Scalar::Lint, vec![value.expression]);
        }
        Ok(value)
    }

    /// An integer of which nothing is cut in its own type.
    fn exact(&mut self, value: Value) -> Lowered<Value> {
        let ty = value.scalar().unwrap_or(Scalar::Lint);
        if value.is_atom()
            || value.is_free
            || !self.around.dialect.is_exact()
            || self.holds(value.extent(), ty)
        {
            return Ok(value);
        }
        self.atom(value)
    }

    fn arithmetic(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Value> {
        let is_clock = |value: &Value| {
            value
                .scalar()
                .is_some_and(|ty| ty == Scalar::Time || ty.is_date())
        };
        if is_clock(&left) || is_clock(&right) {
            return self.clock(operator, left, right);
        }
        let (left, right) = (self.number_of_bits(left)?, self.number_of_bits(right)?);
        if operator == Operator::Power {
            return self.raised(left, right);
        }
        let (left, right, ty) = self.alike(left, right)?;
        if !ty.is_number() {
            return Err(format!("{ty} is not a number"));
        }
        let is_free = left.is_free && right.is_free;
        let inner = match operator {
            Operator::Divide | Operator::Mod => join(left.extent(), right.extent()),
            _ => join(left.hull, right.hull),
        };
        let range = match operator {
            Operator::Plus => sum(left.range, right.range),
            Operator::Minus => difference(left.range, right.range),
            Operator::Times => product(left.range, right.range),
            Operator::Divide => quotient(left.range, right.range),
            _ => remainder(left.range, right.range),
        };
        let is_cut = matches!(operator, Operator::Divide | Operator::Mod);
        // Operands of a division are whole: they are computed on their own where the type is too small.
        let (left, right) = if is_cut && ty.is_integer() && !is_free {
            (self.exact(left)?, self.exact(right)?)
        } else {
            (left, right)
        };
        let (left, right, ty) = self.alike(left, right)?;
        let hull = if is_cut {
            join(left.extent(), right.extent())
        } else {
            inner
        };
        let value = Value::of(left.expression.with(operator, right.expression), Type::Scalar(ty));
        if ty.is_integer() {
            return Ok(Value {
                is_free,
                range,
                hull,
                ..value
            });
        }
        Ok(Value { is_free, ..value })
    }

    /// A power is one of real numbers, unless the exponent is a small number.
    fn raised(&mut self, left: Value, right: Value) -> Lowered<Value> {
        let ty = match (left.scalar(), right.scalar()) {
            (Some(Scalar::Real), _) => Scalar::Real,
            _ => Scalar::Lreal,
        };
        let left = self.fit(left, ty)?;
        let right = self.fit(right, ty)?;
        let left = Expression::Group(Box::new(left.expression));
        let left = match left {
            Expression::Group(inner)
                if matches!(
                    *inner,
                    Expression::Path(_) | Expression::Literal(_) | Expression::Group(_)
                ) =>
            {
                *inner
            }
            group => group,
        };
        Ok(Value::of(
            left.with(Operator::Power, right.expression),
            Type::Scalar(ty),
        ))
    }

    /// Durations and points in time.
    fn clock(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Value> {
        use Scalar::{Dt, Time, Tod};
        let types = (left.scalar().unwrap_or(Time), right.scalar().unwrap_or(Time));
        let ty = match (types, operator) {
            ((Time, Time), Operator::Plus | Operator::Minus) => Time,
            ((Dt, Dt) | (Tod, Tod), Operator::Minus) => Time,
            ((Dt, Time), Operator::Plus | Operator::Minus) => Dt,
            ((Time, number), Operator::Times | Operator::Divide) if number.is_number() => Time,
            ((number, Time), Operator::Times) if number.is_number() => {
                return self.clock(operator, right, left);
            }
            ((one, other), _) => {
                return Err(format!("{one} and {other} are not computed with each other here"));
            }
        };
        let right = if types.1 == types.0 {
            right
        } else {
            self.atom(right)?
        };
        Ok(Value::of(
            left.expression.with(operator, right.expression),
            Type::Scalar(ty),
        ))
    }

    /// `left AND_THEN right`: the right side is reached only if the left one leaves it open.
    fn lazy(&mut self, operator: Operator, left: Value, right: &Tree) -> Lowered<Value> {
        let left = self.fit(left, Scalar::Bool)?;
        let path = self.temporary(Scalar::Bool);
        self.instruction("CALC", vec![(&path).into(), left.bare().clone().into()])?;
        let label = self.new_label("enough");
        let contact = match operator {
            Operator::Or => Block::contact(&path),
            _ => Block::negated_contact(&path),
        };
        let parts = vec![self.element(contact), self.jump(&label)];
        self.network(parts);
        let right = self.value(right)?;
        let right = self.fit(right, Scalar::Bool)?;
        self.instruction("CALC", vec![(&path).into(), right.bare().clone().into()])?;
        self.flush();
        self.label(&label);
        Ok(Value::path(path, Scalar::Bool))
    }

    /// Whether a function of the user runs within.
    fn calls_user(&self, tree: &Tree) -> bool {
        match &tree.kind {
            ExpressionKind::Call(call) => {
                let is_user = self.around.scope.function_named(&call.callee.root).is_some();
                let mut values = call
                    .arguments
                    .iter()
                    .filter_map(|argument| argument.value.as_ref());
                is_user || values.any(|value| self.calls_user(value))
            }
            ExpressionKind::Unary(_, inner) | ExpressionKind::Group(inner) => self.calls_user(inner),
            ExpressionKind::Binary(_, left, right) | ExpressionKind::Lazy(_, left, right) => {
                self.calls_user(left) || self.calls_user(right)
            }
            _ => false,
        }
    }
}

/// Whether computing it may be a fault, or acts.
pub(super) fn may_fault(tree: &Tree) -> bool {
    match &tree.kind {
        ExpressionKind::Literal(..) => false,
        ExpressionKind::Place(place) => has_computed_index(place),
        ExpressionKind::Unary(_, inner) | ExpressionKind::Group(inner) => may_fault(inner),
        ExpressionKind::Lazy(_, left, right) => may_fault(left) || may_fault(right),
        ExpressionKind::Binary(operator, left, right) => {
            let is_number =
                matches!(&right.kind, ExpressionKind::Literal(LiteralKind::Integer, text) if text != "0");
            let divides = matches!(operator, Operator::Divide | Operator::Mod) && !is_number;
            divides || *operator == Operator::Power || may_fault(left) || may_fault(right)
        }
        ExpressionKind::Call(_) => true,
    }
}
