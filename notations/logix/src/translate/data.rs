//! Comparisons, arithmetic, moves.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::operand::{Expr, Path};
use crate::scope::Place;
use crate::types::{Elem, Ty};
use ladder_format::Circuit;
use ladder_format::program::Operator::{self, And, Divide, Equal, Minus, Or, Plus, Shl, Shr, Times};
use ladder_format::program::{Element, Expression, Sign};
use ladder_instructions::Op;

/// Whether a formula divides by something that may be 0.
fn divides(formula: &Expr) -> bool {
    match formula {
        Expr::Binary(operator, left, right) => {
            let may_be_zero = match **right {
                Expr::Int(number) => number == 0,
                Expr::Real(number) => number == 0.0,
                _ => true,
            };
            (*operator == Divide && may_be_zero) || divides(left) || divides(right)
        }
        _ => formula.parts().any(divides),
    }
}

fn binary(operator: Operator, left: Expr, right: Expr) -> Expr {
    Expr::Binary(operator, Box::new(left), Box::new(right))
}

fn not(inner: Expr) -> Expr {
    Expr::Unary(Sign::Not, Box::new(inner))
}

/// The block that compares as an operator does.
const fn comparison(operator: Operator) -> Option<Op> {
    Some(match operator {
        Equal => Op::Eq,
        Operator::NotEqual => Op::Ne,
        Operator::Less => Op::Lt,
        Operator::LessEqual => Op::Le,
        Operator::Greater => Op::Gt,
        Operator::GreaterEqual => Op::Ge,
        _ => return None,
    })
}

/// The block that computes as an operator does. A division by zero is not a fault: only a formula knows that.
const fn arithmetic(operator: Operator) -> Option<Op> {
    Some(match operator {
        Plus => Op::Add,
        Minus => Op::Sub,
        Times => Op::Mul,
        And => Op::And,
        Or => Op::Or,
        Operator::Xor => Op::Xor,
        _ => return None,
    })
}

impl Translator<'_> {
    /// `EQU` to `GEQ`
    pub(super) fn compare(&mut self, op: Op, operands: &[&str]) -> Result<Circuit<Element>> {
        let mut values: [Expr; 2] = self.exprs(operands)?;
        self.as_reals(&mut values)?;
        self.comparison(op, &values)
    }

    /// Values that are compared, each with its neighbour.
    fn comparison(&mut self, op: Op, values: &[Expr]) -> Result<Circuit<Element>> {
        let mut elem = None;
        for value in values {
            let own = match value {
                Expr::Path(path) => {
                    let place = self.tags.place(self.scope, path, Role::Value)?;
                    let Some(own) = place.elem() else {
                        return Err(format!("`{}` has no value to compare", place.path));
                    };
                    Some(own)
                }
                Expr::Real(_) if elem.is_none() => Some(Elem::Real),
                _ => None,
            };
            // Of several types the one that holds the others' numbers.
            if let Some(own) = own
                && elem
                    .is_none_or(|elem: Elem| own.is_real() || (!elem.is_real() && own.bits() > elem.bits()))
            {
                elem = Some(own);
            }
        }
        let elem = elem.unwrap_or(Elem::Dint);
        let mut own = Vec::new();
        for value in values {
            let is_formula = matches!(
                value,
                Expr::Binary(..) | Expr::Call(..) | Expr::Unary(Sign::Not, _)
            );
            if is_formula {
                return Err("a formula".to_owned());
            }
            own.push(self.value(value, elem)?.0);
        }
        self.op(op, own)
    }

    /// `LIM`: between two limits, or outside of them if the lower one is the higher.
    pub(super) fn limits(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let mut values: [Expr; 3] = self.exprs(operands)?;
        self.as_reals(&mut values)?;
        let [low, test, high] = values;
        let number = |expr: &Expr| match expr {
            Expr::Int(int) => Some(*int as f64),
            Expr::Real(real) => Some(*real),
            _ => None,
        };
        let is_turned = match (number(&low), number(&high)) {
            (Some(low), Some(high)) => Some(low > high),
            _ => None,
        };
        let mut inside = || self.comparison(Op::Le, &[low.clone(), test.clone(), high.clone()]);
        if is_turned == Some(false) {
            return inside();
        }
        let inside = inside()?;
        let outside = Circuit::Parallel(vec![
            self.comparison(Op::Le, &[test.clone(), high.clone()])?,
            self.comparison(Op::Ge, &[test, low.clone()])?,
        ]);
        if is_turned == Some(true) {
            return Ok(outside);
        }
        let turned = self.comparison(Op::Gt, &[low, high])?;
        // Inside of limits is never so with turned ones.
        Ok(Circuit::Parallel(vec![
            inside,
            Circuit::Series(vec![turned, outside]),
        ]))
    }

    pub(super) fn masked_equal(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let [source, mask, other] = self.exprs(operands)?;
        let masked = binary(Equal, binary(And, source, mask.clone()), binary(And, other, mask));
        self.condition(&masked, "MEQ")
    }

    pub(super) fn compare_formula(&mut self, text: &str) -> Result<Circuit<Element>> {
        let expr = self.expr(text)?;
        if let Expr::Binary(operator, left, right) = &expr
            && let Some(op) = comparison(*operator)
        {
            let mut circuit = Vec::new();
            let left = self.side(left, &mut circuit)?;
            let right = self.side(right, &mut circuit)?;
            let mut sides = [left, right];
            if circuit.is_empty() {
                self.as_reals(&mut sides)?;
            }
            circuit.push(self.comparison(op, &sides)?);
            return Ok(Circuit::Series(circuit));
        }
        self.condition(&expr, "CMP")
    }

    /// A side of a comparison: a formula is computed before.
    fn side(&mut self, expr: &Expr, before: &mut Vec<Circuit<Element>>) -> Result<Expr> {
        if matches!(expr, Expr::Path(_) | Expr::Int(_) | Expr::Real(_) | Expr::Text(_)) {
            return Ok(expr.clone());
        }
        let formula = self.tags.formula(self.scope, expr)?;
        let elem = if self.is_real(expr) {
            Elem::Lreal
        } else {
            Elem::Dint
        };
        let helper = self.helper("side", elem, "a side of a comparison");
        before.push(self.put(Op::Calc, &helper, formula)?);
        Ok(Expr::Path(Path::tag(helper.root)))
    }

    /// Whether a formula has a real in it.
    fn is_real(&mut self, expr: &Expr) -> bool {
        match expr {
            Expr::Real(_) => true,
            Expr::Path(path) => {
                let place = self.tags.place(self.scope, path, Role::Value);
                place.is_ok_and(|place| place.elem().is_some_and(Elem::is_real))
            }
            Expr::Call(name, _) if name != "ABS" => true,
            _ => expr.parts().any(|part| self.is_real(part)),
        }
    }

    /// Power that a formula decides about.
    fn condition(&mut self, formula: &Expr, like: &str) -> Result<Circuit<Element>> {
        let formula = self.tags.formula(self.scope, formula)?;
        self.computed(Op::Contact, formula, like, like)
    }

    pub(super) fn binary(&mut self, operator: Operator, operands: &[&str]) -> Result<Circuit<Element>> {
        let [left, right] = self.exprs(operands)?;
        let (to, elem) = self.number(operands[2])?;
        if self.is_slc() && elem.is_integer() && matches!(operator, Plus | Minus | Times | Divide) {
            self.note_first(
                "here words wrap, where a controller keeps the limit, and a quotient is cut off, where it is rounded",
            );
        }
        let ((a, own_a), (b, own_b)) = (self.value(&left, elem)?, self.value(&right, elem)?);
        let fits = |own: Option<Elem>, expr: &Expr| match own {
            Some(own) => own == elem,
            None => matches!(expr, Expr::Int(_)) || (elem.is_real() && matches!(expr, Expr::Real(_))),
        };
        if let Some(op) = arithmetic(operator).filter(|_| fits(own_a, &left) && fits(own_b, &right)) {
            return self.op(op, [to.path.into(), a, b]);
        }
        self.compute_at(&to, &binary(operator, left, right))
    }

    /// `ATAN2`: the angle of a point, first its `y`.
    pub(super) fn angle(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let point: [Expr; 2] = self.exprs(operands)?;
        self.compute(operands[2], &Expr::Call("ATAN2".to_owned(), point.to_vec()))
    }

    /// `DTOS` and `STOD`: between a number and its digits. The number is the first operand, or else the text.
    pub(super) fn spelled(&mut self, operands: &[&str], is_text: bool) -> Result<Circuit<Element>> {
        let (from, to) = (self.expr(operands[0])?, self.target(operands[1], Role::Value)?);
        let (value, own) = self.value(&from, Elem::Dint)?;
        let is_string = |elem: Option<Elem>| matches!(elem, Some(Elem::String(_)));
        let (text, number) = if is_text {
            (own, to.elem())
        } else {
            (to.elem(), own)
        };
        let is_number = number.is_some_and(|elem| elem.is_integer() || elem.is_real());
        if !is_string(text) || !(is_number || matches!(from, Expr::Int(_))) {
            return Err("it takes a number and a text".to_owned());
        }
        if is_text {
            self.note("a text that is no number is a fault here; there the first digits in it count");
        }
        self.put(Op::Typ, &to.path, value)
    }

    pub(super) fn truncate(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let (to, elem) = self.number(operands[1])?;
        let from = self.expr(operands[0])?;
        let (from, _) = self.value(&from, elem)?;
        self.put(Op::Trunc, &to.path, from)
    }

    /// A tag that is a number.
    fn number(&mut self, text: &str) -> Result<(Place, Elem)> {
        let place = self.target(text, Role::Value)?;
        match place.elem() {
            Some(elem) if elem.is_integer() || elem.is_real() => Ok((place, elem)),
            _ => Err(format!("`{text}` is no number")),
        }
    }

    pub(super) fn compute(&mut self, to: &str, formula: &Expr) -> Result<Circuit<Element>> {
        let (place, _) = self.number(to)?;
        self.compute_at(&place, formula)
    }

    fn compute_at(&mut self, to: &Place, formula: &Expr) -> Result<Circuit<Element>> {
        let is_real = to.elem().is_some_and(Elem::is_real) || self.is_real(formula);
        if is_real && divides(formula) {
            self.note_first("a REAL that is divided by 0, or too large, is a fault here, and infinite there");
        }
        let formula = self.tags.formula(self.scope, formula)?;
        self.put(Op::Calc, &to.path, formula)
    }

    pub(super) fn move_value(&mut self, from: &str, to: &str) -> Result<Circuit<Element>> {
        let from = self.expr(from)?;
        if let Some(shorter) = self.shorten(to, &from)? {
            return Ok(shorter);
        }
        let is_text = matches!(from, Expr::Text(_));
        let to = self.target(to, if is_text { Role::Text } else { Role::Value })?;
        self.moved(&from, &to)
    }

    /// A copy of a value, in the type of where it goes.
    pub(super) fn moved(&mut self, from: &Expr, to: &Place) -> Result<Circuit<Element>> {
        let Some(elem) = to.elem() else {
            let Expr::Path(path) = from else {
                return Err(format!("`{}` takes no single value", to.path));
            };
            let from = self.tags.place(self.scope, path, Role::Value)?;
            if from.ty != to.ty || matches!(to.ty, Ty::Aoi(_)) {
                return Err(format!(
                    "`{}` and `{}` are of different types",
                    from.path, to.path
                ));
            }
            return self.put(Op::Mov, &to.path, from.path);
        };
        let (value, own) = self.value(from, elem)?;
        let op = match own {
            Some(own) if own == elem => Op::Mov,
            Some(Elem::String(_)) if matches!(elem, Elem::String(_)) => Op::Mov,
            Some(Elem::Bool | Elem::String(_)) => return Err(format!("`{value}` is no number")),
            Some(_) if matches!(elem, Elem::Bool | Elem::String(_)) => {
                return Err(format!("`{}` takes no number", to.path));
            }
            Some(_) => Op::Typ,
            None if matches!(from, Expr::Binary(..) | Expr::Call(..)) => Op::Calc,
            None => Op::Mov,
        };
        self.put(op, &to.path, value)
    }

    pub(super) fn masked_move(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let [source, mask, to] = self.exprs(operands)?;
        let kept = binary(And, to, not(mask.clone()));
        let formula = binary(Or, kept, binary(And, source, mask));
        self.compute(operands[2], &formula)
    }

    /// `BTD`: some bits of a word into another.
    pub(super) fn distribute(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let (to, elem) = self.number(operands[2])?;
        let mut numbers = [0i64; 3];
        for (number, text) in numbers.iter_mut().zip([operands[1], operands[3], operands[4]]) {
            let Expr::Int(int) = self.expr(text)? else {
                return Err(format!("`{text}` is no constant"));
            };
            *number = int;
        }
        let [from_bit, to_bit, length] = numbers;
        let bits = i64::from(elem.bits());
        if !(0..64).contains(&from_bit)
            || !(0..bits).contains(&to_bit)
            || !(1..=64).contains(&length)
            || !elem.is_integer()
        {
            return Err("the bits are outside of the words".to_owned());
        }
        let length = length.min(bits - to_bit);
        let ones = if length >= 64 { -1 } else { (1i64 << length) - 1 };
        let mask = Expr::Int(elem.wrap(ones << to_bit));
        let source = self.expr(operands[0])?;
        let moved = match to_bit - from_bit {
            0 => source,
            up if up > 0 => binary(Shl, source, Expr::Int(up)),
            down => binary(Shr, source, Expr::Int(-down)),
        };
        let kept = binary(And, self.expr(operands[2])?, not(mask.clone()));
        let moved = binary(And, moved, mask);
        self.compute_at(&to, &binary(Or, kept, moved))
    }

    /// `SWPB`
    pub(super) fn swap(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let (to, elem) = self.number(operands[2])?;
        let from = self.expr(operands[0])?;
        let (from, own) = self.value(&from, elem)?;
        let bits = own.unwrap_or(elem).bits();
        let formula = crate::words::swapped(&from, bits, operands[1]).filter(|_| elem.is_integer());
        let formula =
            formula.ok_or_else(|| format!("`{}` is no way to swap bytes of {bits} bits", operands[1]))?;
        self.put(Op::Calc, &to.path, formula)
    }

    /// `TOD` and `FRD`: between a number and its decimal digits.
    pub(super) fn digits(
        &mut self,
        operands: &[&str],
        formula: fn(&Expression, u32) -> Expression,
    ) -> Result<Circuit<Element>> {
        let (to, elem) = self.number(operands[1])?;
        let from = self.expr(operands[0])?;
        let (from, own) = self.value(&from, elem)?;
        let bits = elem.bits().max(own.map_or(0, Elem::bits));
        if !elem.is_integer() || bits > 32 {
            return Err(format!("the digits of `{}` have no counterpart here", to.path));
        }
        self.put(Op::Calc, &to.path, formula(&from, bits))
    }

    /// The length of a text as what is written: the text is cut. None: the place is not such a length.
    fn shorten(&mut self, to: &str, length: &Expr) -> Result<Option<Circuit<Element>>> {
        let Some(text) = to.strip_suffix(".LEN") else {
            return Ok(None);
        };
        let Ok(place) = self.target(text, Role::Text) else {
            return Ok(None);
        };
        if !matches!(place.elem(), Some(Elem::String(_))) {
            return Ok(None);
        }
        if *length == Expr::Int(0) {
            return self.moved(&Expr::Text(String::new()), &place).map(Some);
        }
        self.note("a text is cut here, and does not grow: what follows its end is not kept");
        let (length, _) = self.value(length, Elem::Dint)?;
        let text = Expression::from(&place.path);
        self.op(Op::Left, [text.clone(), text, length]).map(Some)
    }

    pub(super) fn clear(&mut self, text: &str) -> Result<Circuit<Element>> {
        if let Some(shorter) = self.shorten(text, &Expr::Int(0))? {
            return Ok(shorter);
        }
        let to = self.target(text, Role::Value)?;
        if !matches!(to.ty, Ty::Elem(elem) if elem.is_integer() || elem.is_real()) {
            return Err(format!("`{text}` is no number"));
        }
        self.moved(&Expr::Int(0), &to)
    }

    /// `SCL`: `source * rate / 10000 + offset`
    pub(super) fn scale(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let [source, rate, offset] = self.exprs(operands)?;
        let product = binary(Times, source, rate);
        let slope = binary(Divide, product, Expr::Int(10_000));
        self.compute(operands[3], &binary(Plus, slope, offset))
    }

    /// `SCP`: along the line through two points.
    pub(super) fn scale_with_parameters(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let [x, x0, x1, y0, y1] = self.exprs(operands)?;
        let less = |from, by| binary(Minus, from, by);
        let rise = binary(Times, less(x, x0.clone()), less(y1, y0.clone()));
        let slope = binary(Divide, rise, less(x1, x0));
        self.compute(operands[5], &binary(Plus, slope, y0))
    }

    /// Functions of strings: the result is last there, first here.
    pub(super) fn strings(&mut self, op: Op, operands: &[&str]) -> Result<Circuit<Element>> {
        let (to, from) = operands.split_last().ok_or("operands are missing")?;
        let to = self.target(to, Role::Text)?;
        let mut own = vec![Expression::from(to.path)];
        for text in from {
            let expr = self.expr(text)?;
            own.push(self.value(&expr, Elem::Dint)?.0);
        }
        // It begins at a position there.
        if op == Op::Find && own.pop() != Some(1.into()) {
            return Err(
                "a search that does not begin at the first character has no counterpart here".to_owned(),
            );
        }
        if op == Op::Insert {
            // Before a position there, after it here.
            match self.expr(from[2])? {
                Expr::Int(position) => own[3] = position.saturating_sub(1).into(),
                _ => return Err("a position that is computed has no counterpart here".to_owned()),
            }
        }
        self.op(op, own)
    }
}
