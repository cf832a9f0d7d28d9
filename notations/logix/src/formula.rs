//! Formulas as `[CALC]` has them.

use crate::mnemonic::Role;
use crate::operand::Expr;
use crate::scope::Tags;
use crate::types::Elem;
use crate::values::real;

/// How tightly the parts of a formula hold together; more is tighter.
const TIGHTEST: u8 = 10;

impl Tags {
    /// A formula as ladder text.
    ///
    /// # Errors
    ///
    /// If a part of it has no counterpart: a sentence.
    pub(crate) fn formula(&mut self, scope: usize, expr: &Expr) -> Result<String, String> {
        Ok(self.part(scope, expr)?.0)
    }

    /// The same with how tightly it holds together.
    fn part(&mut self, scope: usize, expr: &Expr) -> Result<(String, u8), String> {
        Ok(match expr {
            Expr::Int(int) => {
                let int = if i32::try_from(*int).is_ok() {
                    *int
                } else {
                    Elem::Dint.wrap(*int)
                };
                (int.to_string(), if int < 0 { 9 } else { TIGHTEST })
            }
            Expr::Real(value) => (real(*value), if *value < 0.0 { 9 } else { TIGHTEST }),
            Expr::Text(text) => (format!("'{text}'"), TIGHTEST),
            Expr::Unset => return Err("a value is missing".to_owned()),
            Expr::Path(path) => (self.place(scope, path, Role::Value)?.text, TIGHTEST),
            Expr::Unary(operator, inner) => {
                let inner = self.within(scope, inner, TIGHTEST)?;
                let blank = if *operator == "NOT" { " " } else { "" };
                (format!("{operator}{blank}{inner}"), 9)
            }
            Expr::Binary(operator, left, right) => {
                let (spelled, tight) = match *operator {
                    "OR" => ("OR", 1),
                    "XOR" => ("XOR", 2),
                    "AND" => ("AND", 3),
                    "=" => ("=", 4),
                    "<>" => ("<>", 4),
                    "SHL" => ("SHL", 6),
                    "SHR" => ("SHR", 6),
                    "+" => ("+", 7),
                    "-" => ("-", 7),
                    "*" => ("*", 8),
                    "/" => ("/", 8),
                    "MOD" => ("MOD", 8),
                    // To the right here, to the left there.
                    "**" => {
                        let (left, right) = (self.within(scope, left, 10)?, self.within(scope, right, 10)?);
                        return Ok((format!("{left} ^ {right}"), 9));
                    }
                    relation => (relation, 5),
                };
                // What is of one sort is computed from left to right; relations are clearer with parentheses.
                let is_relation = matches!(tight, 4 | 5);
                let left = self.within(scope, left, if is_relation { 6 } else { tight })?;
                let right = self.within(scope, right, if is_relation { 6 } else { tight + 1 })?;
                (format!("{left} {spelled} {right}"), tight)
            }
            Expr::Call(name, all) => {
                if let ("ATAN2", [y, x]) = (name.as_str(), &all[..]) {
                    let (y, x) = (self.within(scope, y, TIGHTEST)?, self.within(scope, x, TIGHTEST)?);
                    return Ok((crate::words::angle(&y, &x), TIGHTEST));
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
                let inner = self.formula(scope, inner)?;
                (format!("{name}({inner})"), TIGHTEST)
            }
        })
    }

    /// A part, in parentheses if it is looser than its place.
    fn within(&mut self, scope: usize, expr: &Expr, tight: u8) -> Result<String, String> {
        let (text, own) = self.part(scope, expr)?;
        let is_negative_number = own == 9 && !matches!(expr, Expr::Unary(..) | Expr::Binary(..));
        Ok(if own < tight || is_negative_number {
            format!("({text})")
        } else {
            text
        })
    }
}
