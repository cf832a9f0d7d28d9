//! A value in another type.

use super::super::dialect::Dialect;
use super::super::scope::Type;
use super::literal::number_of;
use super::value::{Range, Value, is_within, wide};
use super::{Lowered, Lowering};
use ladder_analysis::values::types::{Scalar, common, passes};
use ladder_format::program::{Block, Expression, Literal, Operand, Path};
use ladder_instructions::Shape;

/// So many values are copied at once.
const MOST_COPIED: usize = 64;

impl Lowering<'_, '_> {
    /// An instruction in `[ ]` as the next block.
    pub(super) fn instruction(&mut self, mnemonic: &str, operands: Vec<Operand>) -> Lowered<()> {
        let block = Block::spelled(Shape::Logical, mnemonic, operands)?;
        self.act(block);
        Ok(())
    }

    /// The value of an instruction, in a tag.
    pub(super) fn made_by(
        &mut self,
        mnemonic: &str,
        ty: Scalar,
        operands: Vec<Expression>,
    ) -> Lowered<Value> {
        let path = self.temporary(ty);
        let operands = std::iter::once(Operand::from(&path)).chain(operands.into_iter().map(Operand::from));
        let operands = operands.collect();
        self.instruction(mnemonic, operands)?;
        Ok(Value::path(path, ty))
    }

    /// The value in one tag or literal.
    pub(super) fn atom(&mut self, value: Value) -> Lowered<Value> {
        if value.is_atom() {
            let expression = value.bare().clone();
            return Ok(Value { expression, ..value });
        }
        if let Some(number) = only_number(&value) {
            return Ok(number);
        }
        let ty = value.scalar().ok_or("such a value cannot be computed here")?;
        let ty = match ty {
            _ if value.is_free || !ty.is_integer() || !self.around.dialect.is_exact() => ty,
            _ if self.holds(value.extent(), ty) => ty,
            _ if self.around.dialect == Dialect::Logix => Scalar::Dint,
            _ => wide(value.extent()),
        };
        let path = self.temporary(ty);
        self.instruction("CALC", vec![(&path).into(), value.bare().clone().into()])?;
        let mut kept = Value::path(path, ty);
        if ty.is_integer() && is_within(value.range, ty) {
            kept.range = value.range;
        }
        Ok(kept)
    }

    /// Whether nothing is cut that the other system does not cut: Logix computes in DINT.
    pub(super) fn holds(&self, range: Range, ty: Scalar) -> bool {
        is_within(range, ty) || self.around.dialect == Dialect::Logix && ty.width() >= 32
    }

    /// The value in one tag or literal of a type.
    pub(super) fn settled(&mut self, value: Value, to: Scalar) -> Lowered<Value> {
        let value = self.fit(value, to)?;
        if value.is_atom() {
            return self.atom(value);
        }
        self.made_by("CALC", to, vec![value.bare().clone()])
    }

    /// Puts a value into a place.
    pub(super) fn assign(&mut self, to: &Path, ty: &Type, value: Value) -> Lowered<()> {
        let Some(scalar) = ty.scalar() else {
            if ty.keeps_state() || *ty == Type::Unknown {
                return Err(format!(
                    "`{to}` holds the state of a block, or is of an unknown type"
                ));
            }
            if *ty != value.ty {
                return Err(format!("what is assigned to `{to}` is of another type"));
            }
            if let (true, Some(from)) = (value.is_in_instance, value.bare().path()) {
                return self.copied(to, from, ty);
            }
            return self.instruction("MOV", vec![to.into(), value.bare().clone().into()]);
        };
        let value = self.fit(value, scalar)?;
        if self.retarget(&value, to) {
            return Ok(());
        }
        let mnemonic = if value.is_atom() { "MOV" } else { "CALC" };
        self.instruction(mnemonic, vec![to.into(), value.bare().clone().into()])
    }

    /// Puts all that a part of an instance holds into a place, one value after the other.
    pub(super) fn copied(&mut self, to: &Path, from: &Path, ty: &Type) -> Lowered<()> {
        let too_much = || format!("`{from}` holds more than what is copied out of an instance here");
        if self.chain.len() > MOST_COPIED {
            return Err(too_much());
        }
        match ty {
            Type::Structure(all) => {
                for (_, member, ty) in &all.members {
                    self.copied(&to.clone().member(member), &from.clone().member(member), ty)?;
                }
                Ok(())
            }
            Type::Array(bounds, inner) => {
                let [(first, last)] = &bounds[..] else {
                    return Err(too_much());
                };
                let all = number_of(first).zip(number_of(last)).ok_or_else(too_much)?;
                for number in all.0..=all.1 {
                    let index = vec![Expression::literal(number.to_string())?];
                    self.copied(
                        &to.clone().index(index.clone()),
                        &from.clone().index(index),
                        inner,
                    )?;
                }
                Ok(())
            }
            Type::Scalar(_) | Type::Enumeration(_) => {
                self.instruction("MOV", vec![to.into(), Expression::from(from).into()])
            }
            _ => Err(too_much()),
        }
    }

    /// The value as one of a type: what stands for it in a formula that is computed in that type.
    pub(super) fn fit(&mut self, value: Value, to: Scalar) -> Lowered<Value> {
        let Some(from) = value.scalar() else {
            return Err(format!("a value of another type than {to} is used as one"));
        };
        if value.is_free {
            return self.fit_free(value, to);
        }
        let is_exact = self.around.dialect.is_exact();
        if from.is_integer() && to.is_integer() {
            let is_whole = value.is_atom() || !value.is_fixed && (is_exact || from == to);
            let holds = value.is_atom() || !is_exact || self.holds(value.hull, to);
            if passes(from, to) && is_whole && holds {
                return Ok(Value {
                    ty: Type::Scalar(to),
                    ..value
                });
            }
            let value = self.atom(value)?;
            let from = value.scalar().unwrap_or(from);
            if passes(from, to) {
                return Ok(Value {
                    ty: Type::Scalar(to),
                    ..value
                });
            }
            return self.made_by("WRAP", to, vec![value.expression]);
        }
        if from == to || (from.is_string() && to.is_string()) {
            return Ok(value);
        }
        if (from.is_bits() && to.is_bits())
            || (from.is_bits() && to.is_integer())
            || (from.is_integer() && to.is_bits())
        {
            let value = self.atom(value)?;
            let from = value.scalar().unwrap_or(from);
            return if passes(from, to) && from.is_bits() == to.is_bits() {
                Ok(Value {
                    ty: Type::Scalar(to),
                    ..value
                })
            } else {
                self.made_by("WRAP", to, vec![value.expression])
            };
        }
        if to.is_real() && (from.is_integer() || from.is_real()) {
            let value = if value.is_real() && from == to {
                value
            } else {
                self.atom(value)?
            };
            let from = value.scalar().unwrap_or(from);
            if passes(from, to) {
                return Ok(Value {
                    ty: Type::Scalar(to),
                    ..value
                });
            }
            return self.made_by("TYP", to, vec![value.expression]);
        }
        if from.is_real() && to.is_integer() {
            return self.whole("TYP", value, to);
        }
        Err(format!("{from} is used as {to}"))
    }

    /// A real number as an integer, by an instruction: rounded or cut. The low bits are kept.
    pub(super) fn whole(&mut self, mnemonic: &str, value: Value, to: Scalar) -> Lowered<Value> {
        let value = self.atom(value)?;
        if to.width() == 64 {
            return self.made_by(mnemonic, to, vec![value.expression]);
        }
        let whole = self.made_by(mnemonic, Scalar::Lint, vec![value.expression])?;
        self.made_by("WRAP", to, vec![whole.expression])
    }

    /// A value of literals alone.
    fn fit_free(&mut self, value: Value, to: Scalar) -> Lowered<Value> {
        // What an instruction has made of literals is made in the type that is asked for.
        if !value.is_bool()
            && value.bare().path().is_some_and(|path| self.is_temporary(path))
            && is_within(value.range, to)
        {
            let path = self.temporary(to);
            if self.retarget(&value, &path) {
                return Ok(Value {
                    range: value.range,
                    ..Value::path(path, to)
                });
            }
            if to.is_integer() || to.is_bits() {
                return self.made_by("WRAP", to, vec![value.expression]);
            }
        }
        let Value {
            range: (number, last),
            ..
        } = value;
        let is_real = value.is_real();
        if to == Scalar::Bool && !is_real && number == last && matches!(number, 0 | 1) {
            return Ok(Value::of(Literal::from(number == 1), Type::BOOL));
        }
        if to.is_real() {
            return Ok(Value {
                ty: Type::Scalar(to),
                ..value
            });
        }
        if is_real && to.is_integer() {
            return self.whole("TYP", value, to);
        }
        if !to.is_integer() && !to.is_bits() {
            return Err(format!("a number is used as {to}"));
        }
        if is_within(value.extent(), to) {
            // There is no arithmetic on bit strings.
            let computed = match only_number(&value) {
                Some(number) if to.is_bits() => Some(number),
                _ if to.is_bits() && !value.is_atom() => None,
                _ => Some(value.clone()),
            };
            if let Some(computed) = computed {
                return Ok(Value {
                    ty: Type::Scalar(to),
                    is_free: true,
                    ..computed
                });
            }
        }
        let value = self.atom(Value {
            ty: Type::Scalar(Scalar::Lint),
            ..value
        })?;
        self.made_by("WRAP", to, vec![value.expression])
    }

    /// An integer next to a real number without a type: both are computed in the type that is asked for.
    fn loose(&mut self, value: Value) -> Lowered<Value> {
        let value = self.atom(value)?;
        if value.scalar().is_some_and(|ty| passes(ty, Scalar::Real)) {
            return Ok(Value {
                ty: Type::Scalar(Scalar::Lreal),
                is_free: true,
                ..value
            });
        }
        self.fit(value, Scalar::Lreal)
    }

    /// Two values in one type, for an operator. Numbers without a type take that of the other.
    pub(super) fn alike(&mut self, left: Value, right: Value) -> Lowered<(Value, Value, Scalar)> {
        let (Some(one), Some(other)) = (left.scalar(), right.scalar()) else {
            return Err("values of such types are not computed here".to_owned());
        };
        let ty = match (left.is_free, right.is_free) {
            (true, true) => {
                let ty = if left.is_real() || right.is_real() {
                    Scalar::Lreal
                } else {
                    Scalar::Lint
                };
                return Ok((left, right, ty));
            }
            (true, false) if other.is_integer() && left.is_real() => {
                let right = self.loose(right)?;
                return Ok((left, right, Scalar::Lreal));
            }
            (false, true) if one.is_integer() && right.is_real() => {
                let left = self.loose(left)?;
                return Ok((left, right, Scalar::Lreal));
            }
            (true, false) => beside(other, &left),
            (false, true) => beside(one, &right),
            _ if one == other => one,
            _ if one.is_real() || other.is_real() => {
                if one == Scalar::Lreal || other == Scalar::Lreal {
                    Scalar::Lreal
                } else {
                    Scalar::Real
                }
            }
            _ => common(one, other)
                .ok_or_else(|| format!("{one} and {other} are not computed with each other here"))?,
        };
        let left = self.beside_number(left, &right, ty)?;
        let right = self.beside_number(right, &left, ty)?;
        Ok((left, right, ty))
    }

    /// One of two values in the type of both. A formula takes its type from the tags in it: if those are too narrow for a
    /// number next to them, a wider tag is.
    fn beside_number(&mut self, value: Value, other: &Value, ty: Scalar) -> Lowered<Value> {
        let is_narrow = other.is_free && !value.is_free && value.is_integer() && value.scalar() != Some(ty);
        if is_narrow && ty.is_integer() {
            let value = self.atom(value)?;
            return self.made_by("MOV", ty, vec![value.expression]);
        }
        self.fit(value, ty)
    }
}

/// The type of a number without one next to a value.
fn beside(ty: Scalar, free: &Value) -> Scalar {
    if ty.is_integer() && !is_within(free.range, ty) {
        return wide(free.range);
    }
    ty
}

/// The number that literals make, where no formula is to be kept.
fn only_number(value: &Value) -> Option<Value> {
    let (number, last) = value.range;
    let is_one = value.is_free && value.is_integer() && number == last && !value.is_atom();
    let number = i64::try_from(number).ok().filter(|_| is_one)?;
    Some(Value::number(i128::from(number), Literal::from(number)))
}
