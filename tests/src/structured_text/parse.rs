//! From tokens to what they say.

use super::syntax::{Declared, Expr, Initial, Path, Spec, Statement, Step, Text, Unit, Variable};
use super::tokens::{Token, tokens};
use super::value::Value;

type Result<T> = std::result::Result<T, String>;

struct Parser {
    tokens: Vec<Token>,
    at: usize,
}

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Text> {
    let mut parser = Parser {
        tokens: tokens(text)?,
        at: 0,
    };
    let mut found = Text::default();
    while parser.at < parser.tokens.len() {
        match parser.word()?.as_str() {
            "TYPE" => {
                let name = parser.word()?;
                parser.sign(":")?;
                let declared = if parser.take_word("STRUCT") {
                    let mut members = Vec::new();
                    while !parser.take_word("END_STRUCT") {
                        let name = parser.word()?;
                        parser.sign(":")?;
                        let spec = parser.spec()?;
                        let initial = if parser.take(":=") {
                            Some(parser.initial()?)
                        } else {
                            None
                        };
                        members.push((name, spec, initial));
                        parser.sign(";")?;
                    }
                    Declared::Members(members)
                } else if parser.at_word("ARRAY") {
                    Declared::Array(parser.spec()?)
                } else {
                    parser.sign("(")?;
                    let mut values = vec![parser.word()?];
                    while parser.take(",") {
                        values.push(parser.word()?);
                    }
                    parser.sign(")")?;
                    Declared::Values(values)
                };
                parser.sign(";")?;
                parser.expect("END_TYPE")?;
                found.types.insert(name, declared);
            }
            "CONFIGURATION" => {
                parser.word()?;
                found.globals = parser.sections()?;
                parser.at = parser.tokens.len();
            }
            kind @ ("FUNCTION" | "FUNCTION_BLOCK" | "PROGRAM") => {
                let unit = parser.unit(kind)?;
                if kind == "PROGRAM" {
                    found.program.clone_from(&unit.name);
                }
                if found.units.insert(unit.name.clone(), unit).is_some() {
                    return Err("two units of one name".into());
                }
            }
            other => return Err(format!("{other} begins nothing")),
        }
    }
    Ok(found)
}

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn error<T>(&self, wanted: &str) -> Result<T> {
        let near: Vec<String> = self.tokens[self.at.saturating_sub(6)..]
            .iter()
            .take(10)
            .map(|token| format!("{token:?}"))
            .collect();
        Err(format!("{wanted} is expected near {}", near.join(" ")))
    }

    fn word(&mut self) -> Result<String> {
        match self.peek() {
            Some(Token::Word(word)) => {
                let word = word.clone();
                self.at += 1;
                Ok(word)
            }
            _ => self.error("a word"),
        }
    }

    fn at_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(Token::Word(own)) if own == word)
    }

    fn take_word(&mut self, word: &str) -> bool {
        let is = self.at_word(word);
        self.at += usize::from(is);
        is
    }

    fn expect(&mut self, word: &str) -> Result<()> {
        if self.take_word(word) {
            Ok(())
        } else {
            self.error(word)
        }
    }

    fn at_sign(&self, sign: &str) -> bool {
        matches!(self.peek(), Some(Token::Sign(own)) if *own == sign)
    }

    fn take(&mut self, sign: &str) -> bool {
        let is = self.at_sign(sign);
        self.at += usize::from(is);
        is
    }

    fn sign(&mut self, sign: &str) -> Result<()> {
        if self.take(sign) { Ok(()) } else { self.error(sign) }
    }

    fn number(&mut self) -> Result<i64> {
        let negative = self.take("-");
        match self.peek() {
            Some(Token::Literal(Value::Int(number, _))) => {
                let number = *number;
                self.at += 1;
                Ok(if negative { -number } else { number })
            }
            _ => self.error("a number"),
        }
    }

    fn spec(&mut self) -> Result<Spec> {
        if self.take_word("ARRAY") {
            self.sign("[")?;
            let mut bounds = Vec::new();
            loop {
                let first = self.number()?;
                self.sign("..")?;
                bounds.push((first, self.number()?));
                if !self.take(",") {
                    break;
                }
            }
            self.sign("]")?;
            self.expect("OF")?;
            if self.at_word("ARRAY") {
                return self.error("the name of a type");
            }
            return Ok(Spec::Array(bounds, Box::new(self.spec()?)));
        }
        let name = self.word()?;
        if name == "STRING" && self.take("[") {
            let length = self.number()?;
            self.sign("]")?;
            return Ok(Spec::Text(length as usize));
        }
        Ok(Spec::Named(name))
    }

    fn sections(&mut self) -> Result<Vec<Variable>> {
        let mut all = Vec::new();
        while let Some(Token::Word(section)) = self.peek().cloned() {
            if !section.starts_with("VAR") {
                break;
            }
            self.at += 1;
            let _ = self.take_word("RETAIN") || self.take_word("CONSTANT");
            while !self.take_word("END_VAR") {
                let name = self.word()?;
                if self.take_word("AT") {
                    self.at += 1;
                }
                self.sign(":")?;
                let ty = self.spec()?;
                if section == "VAR_IN_OUT" && self.at_sign(":=") {
                    return self.error("an in-out without a value");
                }
                let initial = if self.take(":=") {
                    Some(self.initial()?)
                } else {
                    None
                };
                self.sign(";")?;
                all.push(Variable {
                    section: section.clone(),
                    name,
                    ty,
                    initial,
                });
            }
        }
        Ok(all)
    }

    fn initial(&mut self) -> Result<Initial> {
        if self.take("[") {
            let mut all = Vec::new();
            loop {
                let is_count = matches!(self.peek(), Some(Token::Literal(Value::Int(..))))
                    && matches!(self.tokens.get(self.at + 1), Some(Token::Sign("(")));
                if is_count {
                    let count = self.number()?;
                    self.sign("(")?;
                    all.push((count as usize, self.initial()?));
                    self.sign(")")?;
                } else {
                    all.push((1, self.initial()?));
                }
                if !self.take(",") {
                    break;
                }
            }
            self.sign("]")?;
            return Ok(Initial::Elements(all));
        }
        let is_members = matches!(self.peek(), Some(Token::Sign("(")))
            && matches!(self.tokens.get(self.at + 2), Some(Token::Sign(":=")));
        if is_members {
            self.sign("(")?;
            let mut all = Vec::new();
            loop {
                let name = self.word()?;
                self.sign(":=")?;
                all.push((name, self.initial()?));
                if !self.take(",") {
                    break;
                }
            }
            self.sign(")")?;
            return Ok(Initial::Members(all));
        }
        self.expression(0).map(Initial::One)
    }

    fn unit(&mut self, kind: &str) -> Result<Unit> {
        let name = self.word()?;
        let result = if self.take(":") { Some(self.spec()?) } else { None };
        let variables = self.sections()?;
        let body = self.statements()?;
        self.expect(&format!("END_{kind}"))?;
        Ok(Unit {
            name,
            result,
            variables,
            body,
        })
    }

    fn statements(&mut self) -> Result<Vec<Statement>> {
        let mut all = Vec::new();
        while let Some(Token::Word(word)) = self.peek() {
            if word.starts_with("END_") || word == "ELSE" || word == "ELSIF" {
                break;
            }
            all.push(self.statement()?);
        }
        Ok(all)
    }

    fn statement(&mut self) -> Result<Statement> {
        if self.take_word("IF") {
            let mut branches = Vec::new();
            let mut other = Vec::new();
            loop {
                let condition = self.expression(0)?;
                self.expect("THEN")?;
                branches.push((condition, self.statements()?));
                if self.take_word("ELSIF") {
                    continue;
                }
                if self.take_word("ELSE") {
                    other = self.statements()?;
                }
                break;
            }
            self.expect("END_IF")?;
            self.sign(";")?;
            return Ok(Statement::If(branches, other));
        }
        if self.take_word("FOR") {
            let path = self.path()?;
            self.sign(":=")?;
            let from = self.expression(0)?;
            self.expect("TO")?;
            let to = self.expression(0)?;
            self.expect("DO")?;
            let body = self.statements()?;
            self.expect("END_FOR")?;
            self.sign(";")?;
            return Ok(Statement::For(path, from, to, body));
        }
        if self.take_word("WHILE") {
            let condition = self.expression(0)?;
            self.expect("DO")?;
            let body = self.statements()?;
            self.expect("END_WHILE")?;
            self.sign(";")?;
            return Ok(Statement::While(condition, body));
        }
        for (word, statement) in [("RETURN", Statement::Return), ("EXIT", Statement::Exit)] {
            if self.take_word(word) {
                self.sign(";")?;
                return Ok(statement);
            }
        }
        let path = self.path()?;
        let statement = if self.take(":=") {
            Statement::Assign(path, self.expression(0)?)
        } else {
            self.sign("(")?;
            let mut arguments = Vec::new();
            while !self.take(")") {
                let name = self.word()?;
                self.sign(":=")?;
                arguments.push((name, self.expression(0)?));
                self.take(",");
            }
            Statement::Call(path, arguments)
        };
        self.sign(";")?;
        Ok(statement)
    }

    fn path(&mut self) -> Result<Path> {
        let name = self.word()?;
        let mut steps = Vec::new();
        loop {
            if self.take(".") {
                steps.push(Step::Member(self.word()?));
            } else if self.take("[") {
                let mut indices = vec![self.expression(0)?];
                while self.take(",") {
                    indices.push(self.expression(0)?);
                }
                self.sign("]")?;
                steps.push(Step::Index(indices));
            } else {
                return Ok(Path { name, steps });
            }
        }
    }

    /// Operators from this level on, loosest first.
    fn expression(&mut self, level: usize) -> Result<Expr> {
        const LEVELS: [&[&str]; 7] = [
            &["OR"],
            &["XOR"],
            &["AND"],
            &["=", "<>"],
            &["<", ">", "<=", ">="],
            &["+", "-"],
            &["*", "/", "MOD"],
        ];
        let Some(operators) = LEVELS.get(level) else {
            return self.unary();
        };
        let mut left = self.expression(level + 1)?;
        while let Some(operator) = operators
            .iter()
            .find(|operator| self.take(operator) || self.take_word(operator))
        {
            let right = self.expression(level + 1)?;
            left = Expr::Binary((*operator).to_owned(), Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    fn unary(&mut self) -> Result<Expr> {
        if self.take_word("NOT") {
            return Ok(Expr::Unary("NOT".into(), Box::new(self.unary()?)));
        }
        if self.take("-") {
            return Ok(Expr::Unary("-".into(), Box::new(self.unary()?)));
        }
        if self.take("(") {
            let inner = self.expression(0)?;
            self.sign(")")?;
            return Ok(inner);
        }
        if let Some(Token::Literal(value)) = self.peek().cloned() {
            self.at += 1;
            return Ok(Expr::Literal(value));
        }
        let path = self.path()?;
        if path.steps.is_empty() && self.take("(") {
            let mut arguments = Vec::new();
            while !self.take(")") {
                arguments.push(self.expression(0)?);
                self.take(",");
            }
            return Ok(Expr::Call(path.name, arguments));
        }
        Ok(Expr::Read(path))
    }
}
