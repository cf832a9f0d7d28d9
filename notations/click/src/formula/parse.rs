//! From the text of a formula to what it computes.

use super::super::address::{Address, Span, Tag};
use super::super::bank::Bank;
use super::super::model::{Constant, Formula, Operand, Operator, Pointer};
use super::{FUNCTIONS, OPERATORS};

/// Deeper parentheses are not read. Click itself allows eight.
const DEEPEST: usize = 32;

/// A longer formula is not read.
const LONGEST: usize = 4_096;

/// What is wrong in a formula, and how many bytes are before it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in super::super) struct FormulaError {
    pub(in super::super) at: usize,
    pub(in super::super) message: String,
}

/// Reads a formula. Addresses may be written in Click's way (`DS1`, `DS[DS1+99]`, `SUM(DS1..DS4)`) and in the DSL's
/// (`ds[1]`, `ds.Level`, `ds[ds.Step]`, `SUM(ds[1:5])`), numbers as `42`, `1.5`, `0x1F` and `1Fh`.
pub(in super::super) fn parse(text: &str) -> Result<Formula, FormulaError> {
    if text.len() > LONGEST {
        return Err(FormulaError {
            at: 0,
            message: format!("a formula of more than {LONGEST} characters is not read"),
        });
    }
    let mut parser = Parser {
        text,
        at: 0,
        depth: 0,
    };
    let formula = parser.binary(0)?;
    parser.blanks();
    if parser.at == text.len() {
        Ok(formula)
    } else {
        Err(parser.error("an operator is expected here"))
    }
}

struct Parser<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
}

impl<'t> Parser<'t> {
    fn error(&self, message: impl Into<String>) -> FormulaError {
        FormulaError {
            at: self.at,
            message: message.into(),
        }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    fn eat(&mut self, expected: &str) -> bool {
        self.blanks();
        let there = self.rest().starts_with(expected);
        if there {
            self.at += expected.len();
        }
        there
    }

    fn expect(&mut self, expected: &str) -> Result<(), FormulaError> {
        if self.eat(expected) {
            Ok(())
        } else {
            Err(self.error(format!("`{expected}` is expected here")))
        }
    }

    /// The word that begins here: a letter or `_`, then letters, digits and `_`.
    fn word(&self) -> &'t str {
        let rest = self.rest();
        let end = rest
            .find(|c: char| !c.is_alphanumeric() && c != '_')
            .unwrap_or(rest.len());
        if rest.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            &rest[..end]
        } else {
            ""
        }
    }

    fn deeper<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, FormulaError>,
    ) -> Result<T, FormulaError> {
        if self.depth == DEEPEST {
            return Err(self.error(format!("more than {DEEPEST} levels are not read")));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    fn operator(&mut self) -> Option<(Operator, u8, usize)> {
        self.blanks();
        let word = self.word();
        let row = OPERATORS.iter().find(|(_, sign, _)| match word {
            "" => self.rest().starts_with(sign),
            word => sign.eq_ignore_ascii_case(word),
        })?;
        Some((row.0, row.2, row.1.len()))
    }

    fn binary(&mut self, loosest: u8) -> Result<Formula, FormulaError> {
        let mut left = self.prefix()?;
        let mut length = 0;
        while let Some((operator, precedence, width)) = self.operator() {
            if precedence < loosest {
                break;
            }
            // What is written one after the other nests to the left, and is walked by recursion later.
            length += 1;
            if length > 8 * DEEPEST {
                return Err(self.error("the formula has too many parts in a row"));
            }
            self.at += width;
            let right = match operator {
                Operator::Power => self.deeper(|parser| parser.binary(precedence))?,
                _ => self.deeper(|parser| parser.binary(precedence + 1))?,
            };
            left = Formula::Binary(Box::new(left), operator, Box::new(right));
        }
        Ok(left)
    }

    fn prefix(&mut self) -> Result<Formula, FormulaError> {
        self.blanks();
        if self.rest().starts_with('-') {
            self.at += 1;
            let inside = self.deeper(Self::prefix)?;
            // `-5` is a number; `-(5)` and `-a` are not.
            return Ok(match inside {
                Formula::Value(Operand::Constant(Constant::Int(number))) if number >= 0 => {
                    constant(Constant::Int(-number))
                }
                Formula::Value(Operand::Constant(Constant::Float(number))) if number >= 0.0 => {
                    constant(Constant::Float(-number))
                }
                inside => Formula::Negated(Box::new(inside)),
            });
        }
        if self.word().eq_ignore_ascii_case("NOT") {
            self.at += 3;
            let inside = self.deeper(Self::prefix)?;
            return Ok(Formula::Not(Box::new(inside)));
        }
        self.atom()
    }

    fn atom(&mut self) -> Result<Formula, FormulaError> {
        if self.eat("(") {
            let inside = self.deeper(|parser| parser.binary(0))?;
            self.expect(")")?;
            return Ok(inside);
        }
        if self.rest().starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.number();
        }
        let word = self.word();
        if word.is_empty() {
            return Err(self.error("a number, an address or a function is expected here"));
        }
        if word.eq_ignore_ascii_case("PI") {
            self.at += word.len();
            return Ok(Formula::Pi);
        }
        if word.eq_ignore_ascii_case("SUM") {
            return self.sum(word);
        }
        // `LSH(v, n)` and `RSH(v, n)` are Click's words for the operators.
        let shift = [("LSH", Operator::ShiftLeft), ("RSH", Operator::ShiftRight)];
        if let Some((_, operator)) = shift.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)) {
            self.at += word.len();
            let mut arguments = self.arguments(2)?.into_iter();
            if let (Some(value), Some(by)) = (arguments.next(), arguments.next()) {
                return Ok(Formula::Binary(Box::new(value), *operator, Box::new(by)));
            }
        }
        if let Some((function, _, count)) = FUNCTIONS
            .iter()
            .find(|(_, name, _)| name.eq_ignore_ascii_case(word))
        {
            self.at += word.len();
            return Ok(Formula::Call(*function, self.arguments(*count)?));
        }
        self.address(word).map(Formula::Value)
    }

    fn arguments(&mut self, count: usize) -> Result<Vec<Formula>, FormulaError> {
        self.expect("(")?;
        let mut out = Vec::with_capacity(count);
        for number in 0..count {
            if number > 0 {
                self.expect(",")?;
            }
            out.push(self.deeper(|parser| parser.binary(0))?);
        }
        self.expect(")")?;
        Ok(out)
    }

    fn sum(&mut self, word: &str) -> Result<Formula, FormulaError> {
        self.at += word.len();
        self.expect("(")?;
        self.blanks();
        let rest = self.rest();
        let inside = &rest[..rest.find(')').unwrap_or(rest.len())];
        let span = slice(inside)
            .or_else(|| Span::parse(&inside.replace(':', "..")))
            .ok_or_else(|| self.error("a range such as `ds[1:5]` is expected here"))?;
        self.at += inside.len();
        self.expect(")")?;
        Ok(Formula::Sum(span))
    }

    fn number(&mut self) -> Result<Formula, FormulaError> {
        let rest = self.rest();
        let wrong = self.error("this is not a number");
        let end = rest
            .find(|c: char| !c.is_ascii_alphanumeric() && c != '.')
            .unwrap_or(rest.len());
        let mut text = &rest[..end];
        // `1e-3` goes on after its sign.
        let exponent =
            text.ends_with(['e', 'E']) && !text.starts_with("0x") && rest[end..].starts_with(['-', '+']);
        if exponent {
            let digits = rest[end + 1..].find(|c: char| !c.is_ascii_digit());
            text = &rest[..digits.map_or(rest.len(), |digits| end + 1 + digits)];
        }
        self.at += text.len();
        let hex = |digits: &str| u32::from_str_radix(digits, 16).ok().map(Constant::Hex);
        let found = if let Some(digits) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
            hex(digits)
        } else if let Some(digits) = text.strip_suffix(['h', 'H']) {
            hex(digits)
        } else if text.bytes().all(|byte| byte.is_ascii_digit()) {
            text.parse().ok().map(Constant::Int)
        } else {
            text.parse()
                .ok()
                .filter(|number: &f64| number.is_finite())
                .map(Constant::Float)
        };
        found.map(constant).ok_or(wrong)
    }

    fn address(&mut self, word: &str) -> Result<Operand, FormulaError> {
        if let Some(address) = Address::parse(word) {
            self.at += word.len();
            return Ok(Operand::Tag(address.into()));
        }
        let bank = Bank::of_dsl(word).or_else(|| Bank::named(word));
        if let Some(digits) = word.strip_suffix(['h', 'H']).filter(|_| bank.is_none())
            && let Ok(number) = u32::from_str_radix(digits, 16)
        {
            self.at += word.len();
            return Ok(Operand::Constant(Constant::Hex(number)));
        }
        let unknown = self.error(format!("there is no bank or function `{word}`"));
        let bank = bank.ok_or(unknown)?;
        self.at += word.len();
        if self.rest().starts_with('.') {
            self.at += 1;
            let name = self.word();
            if name.is_empty() {
                return Err(self.error("a nickname is expected after the point"));
            }
            self.at += name.len();
            return Ok(Operand::Tag(Tag::nickname(bank, name)));
        }
        self.expect("[")?;
        self.blanks();
        let digits = self.digits();
        if !digits.is_empty() {
            let number = digits
                .parse()
                .map_err(|_| self.error("there is no such address"))?;
            self.at += digits.len();
            self.expect("]")?;
            return Ok(Operand::Tag(Tag::number(bank, number)));
        }
        let word = self.word();
        let Operand::Tag(by) = self.deeper(|parser| parser.address(word))? else {
            return Err(self.error("a pointer is one address"));
        };
        let sign = match () {
            () if self.eat("+") => 1,
            () if self.eat("-") => -1,
            () => 0,
        };
        let mut offset = 0;
        if sign != 0 {
            self.blanks();
            let digits = self.digits();
            let number: i32 = digits
                .parse()
                .map_err(|_| self.error("a number is expected here"))?;
            offset = sign * number;
            self.at += digits.len();
        }
        self.expect("]")?;
        Ok(Operand::Pointer(Pointer { bank, by, offset }))
    }

    fn digits(&self) -> &'t str {
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        &rest[..end]
    }
}

const fn constant(constant: Constant) -> Formula {
    Formula::Value(Operand::Constant(constant))
}

/// A slice as the DSL writes it: `ds[1:5]`.
fn slice(text: &str) -> Option<Span> {
    let (bank, inside) = text.trim().strip_suffix(']')?.split_once('[')?;
    let (first, end) = inside.split_once(':')?;
    let (first, end): (u16, u16) = (first.trim().parse().ok()?, end.trim().parse().ok()?);
    (first < end).then_some(Span {
        bank: Bank::of_dsl(bank.trim())?,
        first,
        last: end - 1,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dsl::spell;
    use expect_test::{Expect, expect};

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let shown = match parse(text) {
            Ok(formula) => spell::formula(&formula),
            Err(error) => format!("{}: {}", error.at, error.message),
        };
        expected.assert_eq(&shown);
    }

    #[test]
    fn both_spellings_are_read() {
        check(
            "((DS2 * 2) + (DS1 * 2)) - 3",
            expect!["ds[2] * 2 + ds[1] * 2 - 3"],
        );
        check("ds.Raw * 100 / 4095", expect!["ds.Raw * 100 / 4095"]);
        check("ds.Raw * (100 / 4095)", expect!["ds.Raw * (100 / 4095)"]);
        check("DS[DS1+99] - ds[ds.Step]", expect!["ds[ds[1]+99] - ds[ds.Step]"]);
        check(
            "SUM(ds[1:5]) + SUM(DS10..DS14)",
            expect!["SUM(ds[1:5]) + SUM(ds[10:15])"],
        );
        check(
            "LSH(45B1h, 1h) OR dh.A AND 0x00FF",
            expect!["0x45B1 SHL 0x1 OR dh.A AND 0xFF"],
        );
        check("2 ^ 3 ^ df.A", expect!["2 ^ 3 ^ df.A"]);
        check("(2 ^ 3) ^ -df.A", expect!["(2 ^ 3) ^ -df.A"]);
        check("-(5) - -5", expect!["-5 - -5"]);
        check(
            "sin(rad(df[1])) * PI + 1.5e-3",
            expect!["SIN(RAD(df[1])) * PI + 0.0015"],
        );
    }

    #[test]
    fn errors_have_their_place() {
        check(
            "ds.A +",
            expect!["6: a number, an address or a function is expected here"],
        );
        check("ds.A ds.B", expect!["5: an operator is expected here"]);
        check(
            "__import__('os')",
            expect!["0: there is no bank or function `__import__`"],
        );
        check("foo(1)", expect!["0: there is no bank or function `foo`"]);
        check("SIN(1", expect!["5: `)` is expected here"]);
        check(
            "SUM(ds.A)",
            expect!["4: a range such as `ds[1:5]` is expected here"],
        );
        check(
            &"(".repeat(1_000),
            expect!["33: more than 32 levels are not read"],
        );
    }
}
