//! From tokens to units, and what runs them.

use super::cursor::{Cursor, Parsed};
use super::declared::{File, Role, Task, Unit, UnitKind};
use super::dialect::Dialect;
use super::token::{Comment, TokenKind};
use super::tree::{Problem, Statement};

/// The words that units begin and end with.
const UNITS: [(&str, &str, UnitKind); 5] = [
    ("PROGRAM", "END_PROGRAM", UnitKind::Program),
    ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK", UnitKind::FunctionBlock),
    ("FUNCTION", "END_FUNCTION", UnitKind::Function),
    ("ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK", UnitKind::Program),
    ("CLASS", "END_CLASS", UnitKind::FunctionBlock),
];

/// What is in a file, and its comments.
pub(crate) fn file(text: &str, dialect: Dialect) -> (File, Vec<Comment>) {
    let mut cursor = Cursor::new(text, dialect);
    let mut file = File::default();
    while !cursor.is_at_end() {
        if cursor.take_sign(";") {
            continue;
        }
        let unit = UNITS.iter().find(|(word, ..)| cursor.is_word(word));
        if let Some((_, end, kind)) = unit {
            match cursor.unit(*kind, end) {
                Ok(unit) => file.units.push(unit),
                Err(_) => cursor.recover(),
            }
        } else if cursor.is_word("TYPE") {
            file.types.extend(cursor.types());
        } else if let Some(role) = cursor.section() {
            let variables = cursor.variables(role);
            file.globals
                .extend(variables.into_iter().filter(|_| role == Role::Global));
        } else if cursor.is_word("CONFIGURATION") {
            cursor.configuration(&mut file);
        } else if cursor.is_any(&["NAMESPACE", "USING"]) {
            // What is in it is read as if it were outside: a name that two namespaces have is reported as any that is there twice.
            cursor.bump();
            while matches!(cursor.kind(), TokenKind::Word | TokenKind::Sign("." | ","))
                && !cursor.begins_unit()
            {
                cursor.bump();
            }
        } else if cursor.is_word("END_NAMESPACE") || cursor.kind() == TokenKind::Pragma {
            cursor.bump();
        } else {
            let _ = cursor.expected::<()>("`PROGRAM`, `FUNCTION_BLOCK`, `FUNCTION`, `TYPE` or `VAR_GLOBAL`");
            cursor.skip_to_unit();
        }
    }
    file.problems.append(&mut cursor.problems);
    (file, cursor.found.comments)
}

/// The statements of a body that is alone.
pub(crate) fn body(text: &str, dialect: Dialect) -> (Vec<Statement>, Vec<Comment>, Vec<Problem>) {
    let mut cursor = Cursor::new(text, dialect);
    let statements = cursor.statements(&[]);
    (statements, cursor.found.comments, cursor.problems)
}

impl Cursor<'_> {
    fn skip_to_unit(&mut self) {
        self.bump();
        while !self.is_at_end() && !self.begins_unit() {
            self.bump();
        }
    }

    fn begins_unit(&self) -> bool {
        let others = [
            "TYPE",
            "VAR_GLOBAL",
            "CONFIGURATION",
            "NAMESPACE",
            "USING",
            "END_NAMESPACE",
        ];
        UNITS.iter().any(|(word, ..)| self.is_word(word)) || self.is_any(&others)
    }

    fn unit(&mut self, kind: UnitKind, end: &str) -> Parsed<Unit> {
        let span = self.span();
        let comment = self.comment_above(span.start);
        self.bump();
        while self.is_any(&["PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL", "FINAL", "ABSTRACT"]) {
            self.bump();
        }
        let name_span = self.span();
        let name = self.name()?;
        let mut unit = Unit {
            span,
            kind,
            name,
            name_span,
            returns: None,
            variables: Vec::new(),
            comment,
            body: Vec::new(),
            chart: None,
            body_span: 0..0,
            text_span: 0..0,
            problems: Vec::new(),
            methods: Vec::new(),
        };
        if self.take_sign(":") {
            let returns = self.type_text()?;
            let is_void = matches!(&returns, super::declared::TypeText::Named(name) if name.eq_ignore_ascii_case("VOID"));
            unit.returns = Some(returns).filter(|_| !is_void);
        }
        if self.is_any(&["EXTENDS", "IMPLEMENTS"]) {
            let span = self.span();
            let _ = self.problem::<()>(
                span,
                "a block that extends another, or implements an interface, is not read",
            );
            while matches!(self.kind(), TokenKind::Word | TokenKind::Sign("," | "."))
                && self.section().is_none()
            {
                self.bump();
            }
        }
        self.head();
        while let Some(role) = self.section() {
            unit.variables.extend(self.variables(role));
            self.head();
        }
        self.take_word("BEGIN");
        let head_end = self.end();
        let before = std::mem::take(&mut self.problems);
        let start = self.span().start;
        if self.is_at_chart() {
            unit.chart = Some(self.chart());
        }
        unit.body = self.statements(&[
            end,
            "METHOD",
            "PROPERTY",
            "ACTION",
            "PROGRAM",
            "FUNCTION_BLOCK",
            "FUNCTION",
            "CONFIGURATION",
            "TYPE",
        ]);
        unit.body_span = start..self.end().max(start);
        unit.problems = before;
        unit.problems.append(&mut self.problems);
        while self.is_any(&["METHOD", "PROPERTY", "ACTION"]) {
            self.method(&mut unit);
        }
        unit.text_span = head_end..self.span().start.max(head_end);
        if !self.take_word(end) && !self.is_at_end() {
            let _ = self.expected::<()>(&format!("`{end}`"));
        }
        Ok(unit)
    }

    /// What TIA writes between the name and the variables.
    fn head(&mut self) {
        self.take_sign(";");
        while self.dialect == Dialect::Scl
            && self.is_any(&["TITLE", "VERSION", "AUTHOR", "FAMILY", "NAME", "KNOW_HOW_PROTECT"])
        {
            let line = self.text[self.span().start..]
                .find('\n')
                .map_or(self.text.len(), |at| at + self.span().start);
            while !self.is_at_end() && self.span().start < line {
                self.bump();
            }
        }
    }

    fn method(&mut self, unit: &mut Unit) {
        let start = self.span();
        let end = format!("END_{}", self.word().to_ascii_uppercase());
        self.bump();
        while self.is_any(&[
            "PUBLIC",
            "PRIVATE",
            "PROTECTED",
            "INTERNAL",
            "FINAL",
            "ABSTRACT",
            "OVERRIDE",
        ]) {
            self.bump();
        }
        unit.methods.push((start, self.word().to_owned()));
        while !self.is_at_end() && !self.take_word(&end) {
            self.bump();
        }
        self.take_sign(";");
    }

    /// The comments directly above a place.
    fn comment_above(&self, at: usize) -> Option<String> {
        let last = self
            .found
            .comments
            .partition_point(|comment| comment.span.end <= at);
        let comment = self.found.comments.get(last.checked_sub(1)?)?;
        let between = &self.text[comment.span.end..at];
        let is_near = between.trim().is_empty() && between.matches('\n').count() <= 1;
        is_near.then(|| comment.text.clone())
    }

    /// `CONFIGURATION` .. `END_CONFIGURATION`: globals, and which programs run.
    fn configuration(&mut self, file: &mut File) {
        while !self.is_at_end() && !self.take_word("END_CONFIGURATION") {
            if let Some(role) = self.section() {
                let variables = self.variables(role);
                file.globals
                    .extend(variables.into_iter().filter(|_| role == Role::Global));
            } else if self.take_word("TASK") {
                let name = self.word().to_owned();
                let mut priority = 0;
                while !self.is_at_end() && !self.is_sign(";") {
                    if self.take_word("PRIORITY") && self.take_sign(":=") {
                        priority = self.word().parse().unwrap_or(0);
                    }
                    self.bump();
                }
                file.tasks.push(Task { name, priority });
            } else if self.take_word("PROGRAM") {
                self.bump();
                let mut task = None;
                if self.take_word("WITH") {
                    task = Some(self.word().to_owned());
                    self.bump();
                }
                if self.take_sign(":") {
                    file.runs.push((self.word().to_owned(), task));
                }
            } else {
                self.bump();
            }
        }
        self.take_sign(";");
    }
}
