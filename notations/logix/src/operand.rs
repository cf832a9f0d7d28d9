//! Operands and formulas of instructions: `cells[i + 1].level.3`, `(a + b) * 2.5`, `'text'`.

use ladder_format::program::{Operator, Sign};

/// An operand.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Expr {
    Int(i64),
    Real(f64),
    /// Without its quotes, with its escapes.
    Text(String),
    Path(Path),
    Unary(Sign, Box<Expr>),
    Binary(Operator, Box<Expr>, Box<Expr>),
    Call(String, Vec<Expr>),
    /// The value is in the tag.
    Unset,
}

impl Expr {
    /// What an operator or a function is applied to.
    pub(crate) fn parts(&self) -> impl Iterator<Item = &Expr> {
        let (one, more): (Option<&Expr>, &[Expr]) = match self {
            Expr::Unary(_, inner) => (Some(inner), &[]),
            Expr::Binary(_, left, right) => (Some(left), std::slice::from_ref(&**right)),
            Expr::Call(_, all) => (None, all),
            _ => (None, &[]),
        };
        one.into_iter().chain(more)
    }
}

/// A tag, a part of it, or a bit.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Path {
    /// With the colons of modules, and the `\` before the name of another program.
    pub(crate) root: String,
    pub(crate) steps: Vec<Step>,
}

impl Path {
    /// A tag as a whole.
    pub(crate) fn tag(name: impl Into<String>) -> Path {
        Path {
            root: name.into(),
            steps: Vec::new(),
        }
    }
}

/// What follows the name of a tag.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Step {
    Member(String),
    Bit(u32),
    /// `.[index]`
    ComputedBit(Box<Expr>),
    Index(Vec<Expr>),
}

/// Nothing nests deeper.
const DEEPEST: usize = 40;

/// Operators from the loosest to the tightest: Logix' own order. Powers are here so that they are no products; they are tighter
/// than a sign.
const LEVELS: &[&[(&str, Operator)]] = &[
    &[("||", Operator::Or), ("OR", Operator::Or)],
    &[("^^", Operator::Xor), ("XOR", Operator::Xor)],
    &[("&&", Operator::And), ("AND", Operator::And)],
    &[
        ("<>", Operator::NotEqual),
        ("<=", Operator::LessEqual),
        (">=", Operator::GreaterEqual),
        ("=", Operator::Equal),
        ("<", Operator::Less),
        (">", Operator::Greater),
    ],
    &[("+", Operator::Plus), ("-", Operator::Minus)],
    &[
        ("**", Operator::Power),
        ("*", Operator::Times),
        ("/", Operator::Divide),
        ("MOD", Operator::Mod),
    ],
];

/// Reads an operand or a formula.
///
/// # Errors
///
/// If it is neither: a sentence.
pub(crate) fn parse(text: &str) -> Result<Expr, String> {
    let mut reader = Reader {
        text,
        at: 0,
        depth: 0,
    };
    if text == "?" {
        return Ok(Expr::Unset);
    }
    // Most are a tag or a number alone.
    if let Ok(expr) = reader.primary()
        && reader.rest().is_empty()
    {
        return Ok(expr);
    }
    (reader.at, reader.depth) = (0, 0);
    let expr = reader.level(0)?;
    reader.blanks();
    match reader.rest() {
        "" => Ok(expr),
        rest => Err(format!("`{}` is not expected in an operand", shown(rest))),
    }
}

fn shown(text: &str) -> String {
    text.chars().take(20).collect()
}

/// A number as Logix writes it: `16#FF`, `2#0000_0001`, `1.0e+002`.
pub(crate) fn number(text: &str) -> Option<Expr> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text),
    };
    if let Some(span) = crate::times::duration(digits) {
        return Some(Expr::Int(if negative { -span } else { span }));
    }
    let digits: String = digits.chars().filter(|c| *c != '_').collect();
    let int = |digits: &str, radix| i64::from_str_radix(digits, radix).ok();
    let unsigned = match digits.split_once('#') {
        Some(("2", bits)) => Expr::Int(int(bits, 2)?),
        Some(("8", octal)) => Expr::Int(int(octal, 8)?),
        Some(("16", hex)) => Expr::Int(u64::from_str_radix(hex, 16).ok()? as i64),
        Some(_) => return None,
        None if digits.bytes().all(|b| b.is_ascii_digit()) && !digits.is_empty() => {
            Expr::Int(int(&digits, 10)?)
        }
        None if digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') => {
            Expr::Real(digits.parse().ok().filter(|real: &f64| real.is_finite())?)
        }
        None => return None,
    };
    Some(match unsigned {
        Expr::Int(int) if negative => Expr::Int(int.wrapping_neg()),
        Expr::Real(real) if negative => Expr::Real(-real),
        other => other,
    })
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn blanks(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    fn eat(&mut self, what: &str) -> bool {
        self.blanks();
        let eaten = self.rest().starts_with(what);
        if eaten {
            self.at += what.len();
        }
        eaten
    }

    fn name(&mut self) -> &'t str {
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        let name = &rest[..end.unwrap_or(rest.len())];
        self.at += name.len();
        name
    }

    /// The operator of a level that is here.
    fn operator(&mut self, level: usize) -> Option<Operator> {
        self.blanks();
        let rest = self.rest();
        let &(spelled, operator) = LEVELS[level].iter().find(|(spelled, _)| {
            let Some(start) = rest.get(..spelled.len()) else {
                return false;
            };
            let is_word = spelled.starts_with(|c: char| c.is_ascii_alphabetic());
            let goes_on = rest[spelled.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_');
            start.eq_ignore_ascii_case(spelled) && !(is_word && goes_on)
        })?;
        if operator == Operator::Power {
            return None;
        }
        self.at += spelled.len();
        Some(operator)
    }

    fn level(&mut self, level: usize) -> Result<Expr, String> {
        if level == LEVELS.len() {
            return self.unary();
        }
        let mut left = self.level(level + 1)?;
        let mut count = 0;
        while let Some(operator) = self.operator(level) {
            count += 1;
            if count > 200 {
                return Err("the formula is too long".to_owned());
            }
            let right = self.level(level + 1)?;
            left = Expr::Binary(operator, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expr, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("the operand is nested deeper than {DEEPEST}"));
        }
        self.blanks();
        let before = self.at;
        let result = if self.eat("-") {
            if self.rest().starts_with(|c: char| c.is_ascii_digit()) {
                // `-2 ** 2` is the negative of a power.
                self.at = before;
                match self.literal(true) {
                    Some(number) if !self.is_power() => Ok(number),
                    _ => {
                        self.at = before + 1;
                        Ok(Expr::Unary(Sign::Minus, Box::new(self.unary()?)))
                    }
                }
            } else {
                Ok(Expr::Unary(Sign::Minus, Box::new(self.unary()?)))
            }
        } else if self.eat("!") || self.eat_not() {
            Ok(Expr::Unary(Sign::Not, Box::new(self.unary()?)))
        } else {
            self.power()
        };
        self.depth -= 1;
        result
    }

    fn eat_not(&mut self) -> bool {
        let before = self.at;
        let is_not = self.name().eq_ignore_ascii_case("NOT");
        if !is_not {
            self.at = before;
        }
        is_not
    }

    fn is_power(&mut self) -> bool {
        self.blanks();
        self.rest().starts_with("**")
    }

    fn power(&mut self) -> Result<Expr, String> {
        let mut left = self.primary()?;
        let mut count = 0;
        while self.is_power() && count < 20 {
            count += 1;
            self.at += 2;
            let right = if self.eat("-") {
                Expr::Unary(Sign::Minus, Box::new(self.primary()?))
            } else {
                self.primary()?
            };
            left = Expr::Binary(Operator::Power, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    /// A number, if one is here.
    fn literal(&mut self, signed: bool) -> Option<Expr> {
        let rest = self.rest();
        let mut end = usize::from(signed);
        for (at, c) in rest.char_indices().skip(end) {
            let before = rest[..at].chars().next_back();
            let in_exponent =
                matches!(c, '+' | '-') && matches!(before, Some('e' | 'E')) && !rest[..at].contains('#');
            if !(c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '#' | '$') || in_exponent) {
                break;
            }
            end = at + c.len_utf8();
        }
        let number = number(&rest[..end])?;
        self.at += end;
        Some(number)
    }

    fn is_fraction(&self) -> bool {
        let digits = self.rest().strip_prefix('.');
        digits.is_some_and(|digits| digits.starts_with(|c: char| c.is_ascii_digit()))
    }

    fn primary(&mut self) -> Result<Expr, String> {
        self.blanks();
        let Some(first) = self.rest().chars().next() else {
            return Err("an operand is missing".to_owned());
        };
        match first {
            '(' => {
                self.depth += 1;
                if self.depth > DEEPEST {
                    return Err(format!("the operand is nested deeper than {DEEPEST}"));
                }
                self.at += 1;
                let inner = self.level(0)?;
                self.depth -= 1;
                if !self.eat(")") {
                    return Err("a parenthesis is not closed".to_owned());
                }
                Ok(inner)
            }
            '\'' => self.string(),
            // Logix writes `.5`, too.
            c if c.is_ascii_digit() || self.is_fraction() => {
                let rest = self.rest();
                self.literal(false)
                    .ok_or_else(|| format!("`{}` is no number", shown(rest)))
            }
            c if c.is_ascii_alphabetic() && crate::times::begins(self.rest()) => {
                let rest = self.rest();
                self.literal(false)
                    .ok_or_else(|| format!("`{}` is no time", shown(rest)))
            }
            c if c.is_alphabetic() || matches!(c, '_' | '\\' | '#' | '$') => self.path(),
            _ => Err(format!("`{}` is not expected in an operand", shown(self.rest()))),
        }
    }

    fn string(&mut self) -> Result<Expr, String> {
        let rest = &self.rest()[1..];
        let mut escaped = false;
        for (at, c) in rest.char_indices() {
            match c {
                _ if escaped => escaped = false,
                '$' => escaped = true,
                '\'' => {
                    self.at += at + 2;
                    return Ok(Expr::Text(rest[..at].to_owned()));
                }
                _ => {}
            }
        }
        Err("a text is not closed".to_owned())
    }

    fn path(&mut self) -> Result<Expr, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("the operand is nested deeper than {DEEPEST}"));
        }
        let begin = self.at;
        if self.rest().starts_with(['\\', '#', '$']) {
            self.at += 1;
        }
        let name = self.name();
        if name.is_empty() {
            return Err(format!("`{}` is no name", shown(&self.text[begin..])));
        }
        if self.rest().starts_with('(') {
            self.at += 1;
            let mut inner = vec![self.level(0)?];
            while self.eat(",") && inner.len() < 2 {
                inner.push(self.level(0)?);
            }
            self.depth -= 1;
            return if self.eat(")") {
                Ok(Expr::Call(name.to_ascii_uppercase(), inner))
            } else {
                Err("a parenthesis is not closed".to_owned())
            };
        }
        // The module of an input or output: its slot and letter belong to the name.
        while self.rest().starts_with(':') {
            let before = self.at;
            self.at += 1;
            if self.name().is_empty() {
                self.at = before;
                break;
            }
        }
        let root = self.text[begin..self.at].trim_start_matches('#').to_owned();
        let mut steps = Vec::new();
        loop {
            let rest = self.rest();
            if rest.starts_with('[') {
                self.at += 1;
                steps.push(Step::Index(self.indices()?));
            } else if rest.starts_with(".[") {
                self.at += 2;
                let mut index = self.indices()?;
                let one = if index.len() == 1 { index.pop() } else { None };
                let Some(index) = one else {
                    return Err("a bit has one number".to_owned());
                };
                steps.push(Step::ComputedBit(Box::new(index)));
            } else if rest.starts_with('.') {
                self.at += 1;
                let name = self.name();
                match name.parse::<u32>() {
                    _ if name.is_empty() => return Err("a member has no name".to_owned()),
                    Ok(bit) => steps.push(Step::Bit(bit)),
                    Err(_) => steps.push(Step::Member(name.to_owned())),
                }
            } else {
                break;
            }
        }
        self.depth -= 1;
        Ok(Expr::Path(Path { root, steps }))
    }

    /// Up to the closing bracket.
    fn indices(&mut self) -> Result<Vec<Expr>, String> {
        let mut indices = vec![self.level(0)?];
        while self.eat(",") && indices.len() < 4 {
            indices.push(self.level(0)?);
        }
        if self.eat("]") {
            Ok(indices)
        } else {
            Err("a bracket is not closed".to_owned())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn shown(expr: &Expr) -> String {
        match expr {
            Expr::Int(int) => int.to_string(),
            Expr::Real(real) => format!("{real:?}"),
            Expr::Text(text) => format!("'{text}'"),
            Expr::Unset => "?".to_owned(),
            Expr::Unary(Sign::Minus, a) => format!("(- {})", shown(a)),
            Expr::Unary(Sign::Not, a) => format!("(NOT {})", shown(a)),
            Expr::Binary(own, a, b) => {
                let mut all = LEVELS.iter().copied().flatten().rev();
                let (spelled, _) = all
                    .find(|(_, operator)| operator == own)
                    .expect("it is in the table");
                format!("({} {spelled} {})", shown(a), shown(b))
            }
            Expr::Call(name, all) => {
                format!("{name}({})", all.iter().map(shown).collect::<Vec<_>>().join(";"))
            }
            Expr::Path(path) => {
                let mut out = path.root.clone();
                for step in &path.steps {
                    out.push_str(&match step {
                        Step::Member(name) => format!(".{name}"),
                        Step::Bit(bit) => format!(".{bit}"),
                        Step::ComputedBit(index) => format!(".[{}]", shown(index)),
                        Step::Index(all) => {
                            format!("[{}]", all.iter().map(shown).collect::<Vec<_>>().join(";"))
                        }
                    });
                }
                out
            }
        }
    }

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        expected.assert_eq(&match parse(text) {
            Ok(expr) => shown(&expr),
            Err(message) => message,
        });
    }

    #[test]
    fn operands() {
        check("Local:1:I.Data.3", expect!["Local:1:I.Data.3"]);
        check(
            "SimpleDint.[Tag.IntMember]",
            expect!["SimpleDint.[Tag.IntMember]"],
        );
        check("a[1, i+2].b[0].31", expect!["a[1;(i + 2)].b[0].31"]);
        check("16#ffff_ffff", expect!["4294967295"]);
        check("2#0000_0101", expect!["5"]);
        check("-1.5e+002", expect!["-150.0"]);
        check("y * .5 + -.25", expect!["((y * 0.5) + (- 0.25))"]);
        check("'it$'s'", expect!["'it$'s'"]);
        check("\\Pump.Speed", expect!["\\Pump.Speed"]);
    }

    #[test]
    fn formulas() {
        check("a + b * -2 ** 2", expect!["(a + (b * (- (2 ** 2))))"]);
        check("ATAN(_Test) > 1.0", expect!["(ATAN(_Test) > 1.0)"]);
        check("ATAN2(y, -x)", expect!["ATAN2(y;(- x))"]);
        check("x MOD 100 > 1", expect!["((x MOD 100) > 1)"]);
        check("NOT a AND b OR c", expect!["(((NOT a) AND b) OR c)"]);
        check("(a && b) || !c", expect!["((a AND b) OR (NOT c))"]);
    }

    #[test]
    fn broken_ones() {
        check("", expect!["an operand is missing"]);
        check("a[1", expect!["a bracket is not closed"]);
        check("1.#QNAN", expect!["`1.#QNAN` is no number"]);
        check(&"(".repeat(1000), expect!["the operand is nested deeper than 40"]);
        check("High/Low x", expect!["`x` is not expected in an operand"]);
    }
}
