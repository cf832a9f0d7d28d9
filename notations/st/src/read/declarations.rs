//! From tokens to variables and types.

use super::cursor::{Cursor, Parsed};
use super::declared::{Initial, Role, TypeDeclaration, TypeText, Variable};
use super::token::TokenKind;
use super::tree::{Expression, ExpressionKind, LiteralKind};
use ladder_format::program::Qualifier;

/// The words that sections of variables begin with.
const SECTIONS: [(&str, Role); 11] = [
    ("VAR", Role::Local),
    ("VAR_INPUT", Role::Input),
    ("VAR_OUTPUT", Role::Output),
    ("VAR_IN_OUT", Role::InOut),
    ("VAR_TEMP", Role::Temp),
    ("VAR_EXTERNAL", Role::External),
    ("VAR_GLOBAL", Role::Global),
    ("VAR_STAT", Role::Local),
    ("VAR_INST", Role::Local),
    ("VAR_CONFIG", Role::External),
    ("VAR_ACCESS", Role::External),
];

impl Cursor<'_> {
    /// Whether a section of variables begins here.
    pub(super) fn section(&self) -> Option<Role> {
        let found = SECTIONS.iter().find(|(word, _)| self.is_word(word));
        found.map(|(_, role)| *role)
    }

    /// The variables of a section, from its first word to `END_VAR`.
    pub(super) fn variables(&mut self, role: Role) -> Vec<Variable> {
        self.bump();
        let mut qualifier = None;
        while self.is_any(&[
            "CONSTANT",
            "RETAIN",
            "NON_RETAIN",
            "PERSISTENT",
            "PUBLIC",
            "PRIVATE",
            "PROTECTED",
            "INTERNAL",
            "DB_SPECIFIC",
        ]) {
            match self.word().to_ascii_uppercase().as_str() {
                "CONSTANT" => qualifier = Some(Qualifier::Constant),
                "RETAIN" | "PERSISTENT" if qualifier.is_none() => qualifier = Some(Qualifier::Retain),
                _ => {}
            }
            self.bump();
        }
        let mut all = self.members(role, &["END_VAR"]);
        for variable in &mut all {
            variable.qualifier = qualifier;
        }
        if self.expect_word("END_VAR").is_ok() {
            self.take_sign(";");
        }
        all
    }

    /// Declarations up to one of some words.
    fn members(&mut self, role: Role, ends: &[&str]) -> Vec<Variable> {
        let mut all = Vec::new();
        while !self.is_at_end() && !self.is_any(ends) {
            let before = self.at;
            match self.nested(|cursor| cursor.declaration(role)) {
                Ok(variables) => all.extend(variables),
                Err(_) => self.recover(),
            }
            if self.at == before {
                break;
            }
        }
        all
    }

    /// `a, b AT %IX0.0 : BOOL := TRUE;`
    fn declaration(&mut self, role: Role) -> Parsed<Vec<Variable>> {
        let mut names = Vec::new();
        loop {
            let span = self.span();
            names.push((self.name()?, span));
            if !self.take_sign(",") {
                break;
            }
        }
        let mut address = None;
        if self.take_word("AT") {
            if self.kind() == TokenKind::Address {
                address = Some(self.word().to_owned());
                self.bump();
            } else {
                self.place()?;
                address = Some(String::new());
            }
        }
        self.expect_sign(":")?;
        let ty = self.type_text()?;
        if self.is_any(&["R_EDGE", "F_EDGE"]) {
            let span = self.span();
            return self.problem(
                span,
                "an input that is an edge is not read: use R_TRIG or F_TRIG in the body",
            );
        }
        let initial = if self.take_sign(":=") {
            Some(self.initial()?)
        } else {
            None
        };
        if !self.is_any(&["END_VAR", "END_STRUCT"]) {
            self.expect_sign(";")?;
        }
        let comment = self.comment_behind(self.end());
        let variables = names.into_iter().map(|(name, span)| Variable {
            span,
            name,
            role,
            qualifier: None,
            address: address.clone(),
            ty: ty.clone(),
            initial: initial.clone(),
            comment: comment.clone(),
        });
        Ok(variables.collect())
    }

    /// What a comment on the rest of a line says.
    fn comment_behind(&self, end: usize) -> Option<String> {
        let first = self
            .found
            .comments
            .partition_point(|comment| comment.span.start < end);
        let comment = self.found.comments.get(first)?;
        let is_there = self.text[end..comment.span.start]
            .chars()
            .all(|c| matches!(c, ' ' | '\t'));
        is_there.then(|| comment.text.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    pub(super) fn type_text(&mut self) -> Parsed<TypeText> {
        if self.take_sign("(") {
            return self.enumeration();
        }
        if self.take_word("ARRAY") {
            return self.array();
        }
        if self.take_word("STRUCT") {
            let members = self.members(Role::Local, &["END_STRUCT"]);
            self.expect_word("END_STRUCT")?;
            return Ok(TypeText::Structure(members));
        }
        for (word, what) in [
            ("POINTER", "a pointer"),
            ("REFERENCE", "a reference"),
            ("REF_TO", "a reference"),
            ("UNION", "a union"),
        ] {
            if self.is_word(word) {
                // What it points to tells nothing more.
                while !self.is_at_end()
                    && !self.is_sign(";")
                    && !self.is_sign(":=")
                    && !self.is_any(&["END_VAR", "END_STRUCT", "END_TYPE"])
                {
                    self.bump();
                }
                return Ok(TypeText::Other(what));
            }
        }
        let mut name = self.name()?;
        while self.take_sign(".") {
            name = self.name()?;
        }
        if name.eq_ignore_ascii_case("STRING") || name.eq_ignore_ascii_case("WSTRING") {
            let close = match self.kind() {
                TokenKind::Sign("[") => "]",
                TokenKind::Sign("(") => ")",
                _ => return Ok(TypeText::Text(None)),
            };
            self.bump();
            let length = self.expression()?;
            self.expect_sign(close)?;
            return Ok(TypeText::Text(Some(length)));
        }
        if self.take_sign("(") {
            let first = self.expression()?;
            self.expect_sign("..")?;
            let last = self.expression()?;
            self.expect_sign(")")?;
            return Ok(TypeText::Range(name, Box::new((first, last))));
        }
        Ok(TypeText::Named(name))
    }

    fn enumeration(&mut self) -> Parsed<TypeText> {
        let mut values = Vec::new();
        while !self.take_sign(")") {
            let name = self.name()?;
            let number = if self.take_sign(":=") {
                Some(self.expression()?)
            } else {
                None
            };
            values.push((name, number));
            if !self.is_sign(")") {
                self.expect_sign(",")?;
            }
        }
        // The type of its numbers.
        if matches!(self.kind(), TokenKind::Word) && !self.is_word("END_TYPE") {
            self.bump();
        }
        Ok(TypeText::Enumeration(values))
    }

    fn array(&mut self) -> Parsed<TypeText> {
        self.expect_sign("[")?;
        if self.take_sign("*") {
            self.expect_sign("]")?;
            self.expect_word("OF")?;
            self.nested(Cursor::type_text)?;
            return Ok(TypeText::Other("an array of any length"));
        }
        let mut bounds = Vec::new();
        loop {
            let first = self.expression()?;
            self.expect_sign("..")?;
            bounds.push((first, self.expression()?));
            if !self.take_sign(",") {
                break;
            }
        }
        self.expect_sign("]")?;
        self.expect_word("OF")?;
        let of = self.nested(Cursor::type_text)?;
        Ok(TypeText::Array(bounds, Box::new(of)))
    }

    fn initial(&mut self) -> Parsed<Initial> {
        self.nested(|cursor| {
            if cursor.take_sign("[") {
                return cursor.initial_list("]");
            }
            let is_members = cursor.is_sign("(") && cursor.ahead(2).0 == TokenKind::Sign(":=");
            if is_members {
                cursor.bump();
                let mut members = Vec::new();
                while !cursor.take_sign(")") {
                    let name = cursor.name()?;
                    cursor.expect_sign(":=")?;
                    members.push((name, cursor.initial()?));
                    if !cursor.is_sign(")") {
                        cursor.expect_sign(",")?;
                    }
                }
                return Ok(Initial::Members(members));
            }
            let value = cursor.expression()?;
            // The list of CODESYS 2 has no brackets: 1, 2, 3(0)
            if cursor.is_sign(",") || cursor.is_sign("(") {
                let repeated = cursor.repeated(value)?;
                let mut all = vec![repeated];
                while cursor.take_sign(",") {
                    let value = cursor.expression()?;
                    all.push(cursor.repeated(value)?);
                }
                return Ok(Initial::List(all));
            }
            Ok(Initial::Value(value))
        })
    }

    fn initial_list(&mut self, close: &str) -> Parsed<Initial> {
        let mut all = Vec::new();
        while !self.take_sign(close) {
            let one = match self.initial()? {
                Initial::Value(value) => self.repeated(value)?,
                // `1, 2` inside of brackets are values of the list.
                Initial::List(values) if !self.is_sign(",") || values.len() > 1 => {
                    all.extend(values);
                    self.take_sign(",");
                    continue;
                }
                other => (1, Some(other)),
            };
            all.push(one);
            if !self.is_sign(close) {
                self.expect_sign(",")?;
            }
        }
        Ok(Initial::List(all))
    }

    /// `3(0)`: a number before parentheses repeats what is in them.
    fn repeated(&mut self, value: Expression) -> Parsed<(u32, Option<Initial>)> {
        let count = match &value.kind {
            ExpressionKind::Literal(LiteralKind::Integer, digits) if self.is_sign("(") => {
                digits.parse::<u32>().ok()
            }
            _ => None,
        };
        let Some(count) = count else {
            return Ok((1, Some(Initial::Value(value))));
        };
        self.bump();
        if self.take_sign(")") {
            return Ok((count, None));
        }
        let inner = self.initial()?;
        self.expect_sign(")")?;
        Ok((count, Some(inner)))
    }

    /// The types of a section, from `TYPE` to `END_TYPE`.
    pub(super) fn types(&mut self) -> Vec<TypeDeclaration> {
        self.bump();
        let mut all = Vec::new();
        while !self.is_at_end() && !self.take_word("END_TYPE") {
            let before = self.at;
            match self.data_type() {
                Ok(declared) => all.push(declared),
                Err(_) => self.recover(),
            }
            if self.at == before {
                self.bump();
            }
        }
        self.take_sign(";");
        all
    }

    fn data_type(&mut self) -> Parsed<TypeDeclaration> {
        let span = self.span();
        let name = self.name()?;
        // SCL has a version here, and no colon.
        if self.take_word("VERSION") {
            self.expect_sign(":")?;
            self.bump();
        }
        if !self.is_word("STRUCT") {
            self.expect_sign(":")?;
        }
        let ty = self.type_text()?;
        let initial = if self.take_sign(":=") {
            Some(self.initial()?)
        } else {
            None
        };
        if !self.is_word("END_TYPE") && !matches!(ty, TypeText::Structure(_)) {
            self.expect_sign(";")?;
        }
        self.take_sign(";");
        let comment = self.comment_behind(self.end());
        Ok(TypeDeclaration {
            span,
            name,
            ty,
            initial,
            comment,
        })
    }
}
