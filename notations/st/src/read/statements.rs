//! From tokens to statements.

use super::cursor::{Cursor, Parsed};
use super::token::TokenKind;
use super::tree::{
    Arm, Assignment, Expression, ExpressionKind, For, Place, Pragma, Statement, StatementKind,
};
use ladder_format::program::Operator;

/// What assigns the result of an operator.
const COMPOUND: [(&str, Operator); 4] = [
    ("+=", Operator::Plus),
    ("-=", Operator::Minus),
    ("*=", Operator::Times),
    ("/=", Operator::Divide),
];

/// The labels of an arm have no more tokens.
const MOST_LABELS: usize = 500;

/// Words that begin statements which ladder text does not have, and what they are.
const UNKNOWN: [(&str, &str); 5] = [
    ("__TRY", "exceptions are not read"),
    ("JMPC", "Instruction List is not read"),
    ("LD", "Instruction List is not read"),
    ("PRAGMA", "conditional compilation is not read"),
    ("WITH", "`WITH` has no counterpart here"),
];

impl Cursor<'_> {
    /// Statements up to one of some words, or the end. What is wrong is reported, and passed over.
    pub(super) fn statements(&mut self, ends: &[&str]) -> Vec<Statement> {
        self.statements_until(|cursor| cursor.is_any(ends))
    }

    fn statements_until(&mut self, ends: impl Fn(&Self) -> bool) -> Vec<Statement> {
        let mut all = Vec::new();
        while !self.is_at_end() && !ends(self) {
            if self.take_sign(";") {
                continue;
            }
            let before = self.at;
            match self.nested(Cursor::statement) {
                Ok(statement) => all.push(statement),
                Err(_) => self.recover(),
            }
            // A word that ends another statement ends nothing here.
            if self.at == before {
                let _ = self.expected::<()>("a statement");
                self.bump();
            }
        }
        all
    }

    fn statement(&mut self) -> Parsed<Statement> {
        let start = self.span().start;
        let kind = self.statement_kind()?;
        let span = start..self.end();
        let is_block = matches!(
            kind,
            StatementKind::If(..)
                | StatementKind::Case(..)
                | StatementKind::For(..)
                | StatementKind::While(..)
                | StatementKind::Repeat(..)
                | StatementKind::Label(_)
                | StatementKind::Pragma(..)
        );
        // CODESYS takes END_IF without `;`, TIA anything before END_.
        let ends = self.is_at_end()
            || self.is_any(&[
                "END_IF",
                "END_CASE",
                "END_FOR",
                "END_WHILE",
                "END_REPEAT",
                "ELSE",
                "ELSIF",
                "UNTIL",
            ]);
        if !self.take_sign(";") && !is_block && !ends {
            return self.expected("`;`");
        }
        Ok(Statement { span, kind })
    }

    fn statement_kind(&mut self) -> Parsed<StatementKind> {
        if self.kind() == TokenKind::Pragma {
            return Ok(self.pragma());
        }
        if self.kind() == TokenKind::Word {
            let word = self.word().to_ascii_uppercase();
            match word.as_str() {
                "IF" => return self.branches(),
                "CASE" => return self.case(),
                "FOR" => return self.counting_loop(),
                "WHILE" => {
                    self.bump();
                    let condition = self.expression()?;
                    self.expect_word("DO")?;
                    let body = self.statements(&["END_WHILE"]);
                    self.expect_word("END_WHILE")?;
                    return Ok(StatementKind::While(condition, body));
                }
                "REPEAT" => {
                    self.bump();
                    let body = self.statements(&["UNTIL"]);
                    self.expect_word("UNTIL")?;
                    let condition = self.expression()?;
                    self.take_sign(";");
                    self.expect_word("END_REPEAT")?;
                    return Ok(StatementKind::Repeat(body, condition));
                }
                "RETURN" | "EXIT" | "CONTINUE" => {
                    self.bump();
                    return Ok(match word.as_str() {
                        "RETURN" => StatementKind::Return,
                        "EXIT" => StatementKind::Exit,
                        _ => StatementKind::Continue,
                    });
                }
                "GOTO" | "JMP" => {
                    self.bump();
                    return Ok(StatementKind::Goto(self.name()?));
                }
                _ => {}
            }
            let unknown = UNKNOWN.iter().find(|(own, _)| *own == word);
            if let Some((_, why)) =
                unknown.filter(|_| self.ahead(1).0 == TokenKind::Word || word.starts_with('_'))
            {
                let span = self.span();
                return self.problem(span, *why);
            }
            if self.ahead(1).0 == TokenKind::Sign(":") {
                let name = self.name()?;
                self.bump();
                return Ok(StatementKind::Label(name));
            }
        }
        if !matches!(
            self.kind(),
            TokenKind::Word | TokenKind::Name | TokenKind::Address
        ) {
            return self.expected("a statement");
        }
        let place = self.place()?;
        if self.is_sign("(") {
            let call = self.call(place)?;
            if self.is_sign(".") {
                let span = self.span();
                return self.problem(span, "a call of what another call returns has no counterpart");
            }
            return Ok(StatementKind::Call(call));
        }
        self.assignment(place)
    }

    fn pragma(&mut self) -> StatementKind {
        let words = self.word().split(|c: char| !c.is_alphanumeric() && c != '_');
        let words: Vec<String> = words
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect();
        // Statements in C have one.
        let is_choice = !self.word()[1..].trim_start().contains(';');
        self.bump();
        let kind = match words.first().map(String::as_str) {
            Some("if" | "elsif" | "else" | "end_if" | "define" | "undefine") if is_choice => Pragma::Choice,
            _ if words
                .iter()
                .any(|word| matches!(word.as_str(), "return" | "goto" | "longjmp")) =>
            {
                Pragma::Leaving
            }
            _ => Pragma::Code,
        };
        StatementKind::Pragma(kind, words)
    }

    fn assignment(&mut self, place: Place) -> Parsed<StatementKind> {
        let is_equal = self.ahead(1).0 == TokenKind::Sign("=");
        let how = match self.word().to_ascii_uppercase().as_str() {
            "S" if is_equal => Some(Assignment::Set),
            "R" if is_equal => Some(Assignment::Reset),
            "REF" if is_equal => Some(Assignment::Reference),
            _ => None,
        };
        if let Some(how) = how {
            self.at += 2;
            return Ok(StatementKind::Assign(vec![place], how, self.expression()?));
        }
        if let Some((_, operator)) = COMPOUND.iter().find(|(sign, _)| self.is_sign(sign)) {
            self.bump();
            let right = self.expression()?;
            let span = place.span.start..right.span.end;
            let left = Expression {
                span: place.span.clone(),
                kind: ExpressionKind::Place(place.clone()),
            };
            let kind = ExpressionKind::Binary(*operator, Box::new(left), Box::new(right));
            let value = Expression { span, kind };
            return Ok(StatementKind::Assign(vec![place], Assignment::Value, value));
        }
        let mut targets = vec![place];
        loop {
            if !self.take_sign(":=") && !self.take_sign("[:=]") {
                return self.expected("`:=`");
            }
            let value = self.expression()?;
            match value.kind {
                ExpressionKind::Place(place) if self.is_sign(":=") => targets.push(place),
                _ => return Ok(StatementKind::Assign(targets, Assignment::Value, value)),
            }
        }
    }

    fn branches(&mut self) -> Parsed<StatementKind> {
        let mut branches = Vec::new();
        let mut otherwise = Vec::new();
        self.bump();
        loop {
            let condition = self.expression()?;
            self.expect_word("THEN")?;
            let body = self.statements(&["ELSIF", "ELSE", "END_IF"]);
            branches.push((condition, body));
            if self.take_word("ELSIF") {
                continue;
            }
            if self.take_word("ELSE") {
                otherwise = self.statements(&["END_IF"]);
            }
            self.expect_word("END_IF")?;
            return Ok(StatementKind::If(branches, otherwise));
        }
    }

    fn counting_loop(&mut self) -> Parsed<StatementKind> {
        self.bump();
        let variable = self.place()?;
        self.expect_sign(":=")?;
        let from = self.expression()?;
        self.expect_word("TO")?;
        let to = self.expression()?;
        let by = if self.take_word("BY") {
            Some(self.expression()?)
        } else {
            None
        };
        self.expect_word("DO")?;
        let body = self.statements(&["END_FOR"]);
        self.expect_word("END_FOR")?;
        Ok(StatementKind::For(Box::new(For {
            variable,
            from,
            to,
            by,
            body,
        })))
    }

    fn case(&mut self) -> Parsed<StatementKind> {
        self.bump();
        let selector = self.expression()?;
        self.expect_word("OF")?;
        let mut arms = Vec::new();
        let mut otherwise = Vec::new();
        while !self.is_at_end() && !self.take_word("END_CASE") {
            if self.take_word("ELSE") {
                self.take_sign(":");
                otherwise = self.statements(&["END_CASE"]);
                continue;
            }
            let start = self.span().start;
            let mut labels = Vec::new();
            loop {
                let first = self.expression()?;
                let last = if self.take_sign("..") {
                    Some(self.expression()?)
                } else {
                    None
                };
                labels.push((first, last));
                if !self.take_sign(",") {
                    break;
                }
            }
            self.expect_sign(":")?;
            let span = start..self.end();
            let body =
                self.statements_until(|cursor| cursor.is_any(&["ELSE", "END_CASE"]) || cursor.begins_arm());
            arms.push(Arm { span, labels, body });
        }
        Ok(StatementKind::Case(selector, arms, otherwise))
    }

    /// Whether labels come next: there is a `:` before anything that a statement has.
    fn begins_arm(&self) -> bool {
        let mut follows_sign = true;
        for by in 0..MOST_LABELS {
            match self.ahead(by).0 {
                TokenKind::Sign(":") => return true,
                TokenKind::Sign("," | ".." | "." | "-" | "+") => follows_sign = true,
                // Of `IF a THEN CASE n OF 1:` no two words are one label.
                TokenKind::Word
                | TokenKind::Name
                | TokenKind::Integer
                | TokenKind::Typed
                | TokenKind::Text
                    if follows_sign =>
                {
                    follows_sign = false;
                }
                _ => return false,
            }
        }
        false
    }
}
