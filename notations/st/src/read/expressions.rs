//! From tokens to expressions.

use super::cursor::{Cursor, Parsed};
use super::token::TokenKind;
use super::tree::{Argument, Call, Direction, Expression, ExpressionKind, LiteralKind, Place, Step};
use ladder_format::program::{Operator, Sign};

/// An expression has no more operators.
const MOST_OPERATORS: usize = 150;

/// The operators from the loosest to the tightest, as the standard ranks them.
const RANKS: [&[(&str, Operator)]; 7] = [
    &[("OR", Operator::Or), ("OR_ELSE", Operator::Or)],
    &[("XOR", Operator::Xor)],
    &[
        ("AND", Operator::And),
        ("&", Operator::And),
        ("AND_THEN", Operator::And),
    ],
    &[("=", Operator::Equal), ("<>", Operator::NotEqual)],
    &[
        ("<", Operator::Less),
        ("<=", Operator::LessEqual),
        (">", Operator::Greater),
        (">=", Operator::GreaterEqual),
    ],
    &[("+", Operator::Plus), ("-", Operator::Minus)],
    &[
        ("*", Operator::Times),
        ("/", Operator::Divide),
        ("MOD", Operator::Mod),
    ],
];
const POWER: u8 = RANKS.len() as u8;

impl Cursor<'_> {
    pub(super) fn expression(&mut self) -> Parsed<Expression> {
        let mut operators = 0;
        self.nested(|cursor| cursor.binary(0, &mut operators))
    }

    /// The operator that comes next, with its rank.
    fn operator(&self) -> Option<(u8, Operator)> {
        let word = match self.kind() {
            TokenKind::Sign("**") => return Some((POWER, Operator::Power)),
            TokenKind::Sign(sign) => sign,
            TokenKind::Word => self.word(),
            _ => return None,
        };
        (0..).zip(RANKS).find_map(|(rank, row)| {
            let found = row.iter().find(|(own, _)| own.eq_ignore_ascii_case(word));
            found.map(|(_, operator)| (rank, *operator))
        })
    }

    /// An expression whose operators have this rank at least. Equal ranks group to the left.
    fn binary(&mut self, least: u8, operators: &mut usize) -> Parsed<Expression> {
        let mut left = self.unary()?;
        while let Some((rank, operator)) = self.operator().filter(|(rank, _)| *rank >= least) {
            *operators += 1;
            if *operators > MOST_OPERATORS {
                let span = self.span();
                return self.problem(
                    span,
                    format!("an expression has more than {MOST_OPERATORS} operators"),
                );
            }
            let is_lazy = self.word().contains('_');
            self.bump();
            let right = self.nested(|cursor| cursor.binary(rank + 1, operators))?;
            let span = left.span.start..right.span.end;
            let (left_side, right) = (Box::new(left), Box::new(right));
            let kind = if is_lazy {
                ExpressionKind::Lazy(operator, left_side, right)
            } else {
                ExpressionKind::Binary(operator, left_side, right)
            };
            left = Expression { span, kind };
        }
        Ok(left)
    }

    fn unary(&mut self) -> Parsed<Expression> {
        let start = self.span().start;
        let sign = match self.kind() {
            TokenKind::Sign("-") => Some(Sign::Minus),
            TokenKind::Sign("+") => None,
            TokenKind::Word if self.is_word("NOT") => Some(Sign::Not),
            _ => return self.primary(),
        };
        self.bump();
        let inner = self.nested(Cursor::unary)?;
        let Some(sign) = sign else { return Ok(inner) };
        let span = start..inner.span.end;
        let kind = match inner.kind {
            ExpressionKind::Literal(kind @ (LiteralKind::Integer | LiteralKind::Real), text)
                if sign == Sign::Minus && !text.starts_with('-') =>
            {
                ExpressionKind::Literal(kind, format!("-{text}"))
            }
            _ => ExpressionKind::Unary(sign, Box::new(inner)),
        };
        Ok(Expression { span, kind })
    }

    fn primary(&mut self) -> Parsed<Expression> {
        let span = self.span();
        let literal = match self.kind() {
            TokenKind::Integer => LiteralKind::Integer,
            TokenKind::Real => LiteralKind::Real,
            TokenKind::Typed => LiteralKind::Typed,
            TokenKind::Text => LiteralKind::Text,
            TokenKind::Sign("(") => {
                self.bump();
                let inner = self.expression()?;
                self.expect_sign(")")?;
                let kind = ExpressionKind::Group(Box::new(inner));
                return Ok(Expression {
                    span: span.start..self.end(),
                    kind,
                });
            }
            TokenKind::Word | TokenKind::Name | TokenKind::Address => {
                let place = self.place()?;
                let kind = if self.is_sign("(") {
                    ExpressionKind::Call(self.call(place)?)
                } else {
                    ExpressionKind::Place(place)
                };
                return Ok(Expression {
                    span: span.start..self.end(),
                    kind,
                });
            }
            _ => return self.expected("a value"),
        };
        let kind = ExpressionKind::Literal(literal, self.word().to_owned());
        self.bump();
        Ok(Expression { span, kind })
    }

    /// A tag, or a part of one.
    pub(super) fn place(&mut self) -> Parsed<Place> {
        let start = self.span().start;
        // A name of the project keeps its quotes in SCL: `#run` and `"run"` are two tags. Elsewhere it is a text.
        let is_of_project = self.kind() == TokenKind::Name && self.word().starts_with('"');
        let root = if self.kind() == TokenKind::Address || is_of_project {
            let whole = self.word().to_owned();
            self.bump();
            whole
        } else {
            self.name()?
        };
        let mut steps = Vec::new();
        loop {
            if self.take_sign("[") {
                steps.push(Step::Index(self.list("]")?));
            } else if self.take_sign("^") {
                steps.push(Step::Other("a pointer"));
            } else if self.take_sign(".") {
                steps.push(self.member()?);
            } else {
                return Ok(Place {
                    span: start..self.end(),
                    root,
                    steps,
                });
            }
        }
    }

    /// What follows a point.
    fn member(&mut self) -> Parsed<Step> {
        let word = self.word();
        match self.kind() {
            TokenKind::Integer => {
                self.bump();
                Ok(word
                    .parse()
                    .map_or(Step::Other("a bit of such a number"), Step::Bit))
            }
            TokenKind::Address => {
                self.bump();
                Ok(part(word).unwrap_or(Step::Other("a part of a word of this kind")))
            }
            TokenKind::Sign("[") => {
                self.bump();
                let bit = self.expression()?;
                self.expect_sign("]")?;
                Ok(Step::ComputedBit(Box::new(bit)))
            }
            _ => Ok(Step::Member(self.name()?)),
        }
    }

    /// Expressions up to the sign that closes them.
    fn list(&mut self, close: &str) -> Parsed<Vec<Expression>> {
        let mut all = Vec::new();
        loop {
            all.push(self.expression()?);
            if self.take_sign(close) {
                return Ok(all);
            }
            self.expect_sign(",")?;
        }
    }

    /// The arguments of a call, from `(`.
    pub(super) fn call(&mut self, callee: Place) -> Parsed<Call> {
        self.expect_sign("(")?;
        let mut arguments = Vec::new();
        while !self.take_sign(")") {
            arguments.push(self.argument()?);
            if !self.is_sign(")") {
                self.expect_sign(",")?;
            }
        }
        Ok(Call { callee, arguments })
    }

    fn argument(&mut self) -> Parsed<Argument> {
        let negated = usize::from(self.is_word("NOT"));
        let is_name = matches!(self.ahead(negated).0, TokenKind::Word | TokenKind::Name);
        let direction = match self.ahead(negated + 1).0 {
            TokenKind::Sign(":=") if is_name && negated == 0 => Direction::In,
            TokenKind::Sign("=>") if is_name && negated == 0 => Direction::Out,
            TokenKind::Sign("=>") if is_name => Direction::OutNegated,
            _ => {
                let value = Some(self.expression()?);
                return Ok(Argument {
                    name: None,
                    direction: Direction::In,
                    value,
                });
            }
        };
        self.at += negated;
        let name = Some(self.name()?);
        self.bump();
        let is_empty = self.is_sign(",") || self.is_sign(")");
        let value = if is_empty { None } else { Some(self.expression()?) };
        Ok(Argument {
            name,
            direction,
            value,
        })
    }
}

/// `%X3`, `%B1`, `%W0`, `%D1`: a part of a word.
fn part(word: &str) -> Option<Step> {
    let mut letters = word.strip_prefix('%')?.chars();
    let size = letters.next()?.to_ascii_uppercase();
    let number: u32 = letters.as_str().parse().ok()?;
    Some(match size {
        'X' => Step::Bit(number),
        'B' => Step::Part(8, number),
        'W' => Step::Part(16, number),
        'D' => Step::Part(32, number),
        _ => return None,
    })
}
