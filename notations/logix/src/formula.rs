//! Formulas as `[CALC]` has them.

use crate::mnemonic::Role;
use crate::operand::Expr;
use crate::scope::Tags;
use crate::types::Elem;
use crate::values::real;
use ladder_format::program::Expression;

impl Tags {
    /// A formula with the tags that are here.
    ///
    /// # Errors
    ///
    /// If a part of it has no counterpart: a sentence.
    pub(crate) fn formula(&mut self, scope: usize, expr: &Expr) -> Result<Expression, String> {
        Ok(match expr {
            Expr::Int(int) => Elem::Dint.wrap(*int).into(),
            Expr::Real(value) => Expression::literal(real(*value))?,
            Expr::Text(text) => Expression::literal(format!("'{text}'"))?,
            Expr::Unset => return Err("a value is missing".to_owned()),
            Expr::Path(path) => self.place(scope, path, Role::Value)?.path.into(),
            Expr::Unary(sign, inner) => Expression::Unary(*sign, Box::new(self.formula(scope, inner)?)),
            Expr::Binary(operator, left, right) => self
                .formula(scope, left)?
                .with(*operator, self.formula(scope, right)?),
            Expr::Call(name, all) => {
                if let ("ATAN2", [y, x]) = (name.as_str(), &all[..]) {
                    let (y, x) = (self.formula(scope, y)?, self.formula(scope, x)?);
                    return Ok(crate::words::angle(&y, &x));
                }
                let [inner] = &all[..] else {
                    return Err(format!("the function {name} has other operands"));
                };
                let name = match name.as_str() {
                    "SQR" => "SQRT",
                    "ASN" => "ASIN",
                    "ACS" => "ACOS",
                    "ATN" => "ATAN",
                    "TRN" => "TRUNC",
                    name @ ("ABS" | "SQRT" | "LN" | "LOG" | "SIN" | "COS" | "TAN" | "ASIN" | "ACOS"
                    | "ATAN" | "DEG" | "RAD" | "TRUNC") => name,
                    other => return Err(format!("the function {other} has no counterpart")),
                };
                Expression::call(name, [self.formula(scope, inner)?])
            }
        })
    }
}
