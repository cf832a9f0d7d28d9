//! Statements that ladder text does not have: each is an unread part at its place.

use super::super::scope::Type;
use super::super::tree::{
    Call, Direction, Expression as Tree, ExpressionKind, Place, Pragma, Span, Statement, StatementKind, Step,
};
use super::Lowering;
use ladder_format::Circuit;
use ladder_format::program::Element;
use ladder_notation::{Outcome, Power, Turn, Unread};

/// The names that an unread part may write.
#[derive(Default)]
struct Writes {
    roots: Vec<String>,
    /// It may write anything.
    is_open: bool,
    /// It may leave the statement.
    leaves: bool,
    loops: u32,
}

/// Functions that nothing in ladder text does, and what they do.
const UNKNOWN: [(&str, &[&str]); 3] = [
    (
        "it works on memory by address, which ladder text does not have",
        &[
            "ADR", "SIZEOF", "MEMCPY", "MEMSET", "MEMMOVE", "BITADR", "PEEK", "POKE", "POKE_BLK", "MOVE_BLK",
            "COP", "CPS", "REF",
        ],
    ),
    (
        "it reads and writes the controller itself",
        &[
            "GSV", "SSV", "UID", "UIE", "EVENT", "RD_SYS_T", "WR_SYS_T", "TIME",
        ],
    ),
    (
        "it reads and writes other controllers",
        &["MSG", "TSEND_C", "TRCV_C", "GET", "PUT"],
    ),
];

/// Why a function or block has no counterpart.
pub(super) fn no_counterpart(name: &str) -> String {
    let found = UNKNOWN
        .iter()
        .find(|(_, all)| all.iter().any(|own| own.eq_ignore_ascii_case(name)));
    match found {
        Some((why, _)) => format!("`{name}`: {why}"),
        None => format!("`{name}` is not declared, and is not a function that is read"),
    }
}

/// Whether statements may leave the body that they are, or jump in it.
pub(in super::super) fn leaves(statements: &[Statement]) -> bool {
    let mut writes = Writes::default();
    writes.all(statements);
    writes.leaves
}

impl Lowering<'_, '_> {
    /// The whole body is unread.
    pub(super) fn unread_whole(&mut self, why: &str) {
        self.body.unread.get_or_insert_with(|| why.to_owned());
    }

    /// A statement without a counterpart.
    pub(super) fn unread(&mut self, statement: &Statement, why: &str) {
        let mut writes = Writes::default();
        writes.statement(statement);
        if writes.leaves {
            self.unread_whole(why);
            return;
        }
        let tags: Option<Vec<String>> = writes
            .roots
            .iter()
            .map(|root| {
                let known = self.around.scope.known(root)?;
                // What is of an unknown type is not declared, and may be another name of a tag that is.
                let is_open = known.is_constant || known.ty == Type::Unknown;
                (!is_open).then(|| known.path.root.clone())
            })
            .collect();
        let tags = tags.filter(|_| !writes.is_open).map(|mut tags| {
            tags.sort_unstable();
            tags.dedup();
            tags
        });
        let Span { start, end } = statement.span.clone();
        let line = self.around.lines.place(self.around.text, start).line;
        let name = format!("line {line} of {}", self.around.unit);
        let about = format!("{name}: {why}; it is not run here.");
        let part = Unread {
            name: &name,
            about: &about,
            text: &self.around.text[start..end],
            writes: tags.as_deref(),
            power: Power::Passes,
            turn: Turn::Here,
        };
        let scope = self.around.scope;
        let block = self
            .unread
            .body(part, |name| scope.has_block(name.trim_start_matches('$')));
        let element = Circuit::Element(Element::of(block, self.origin));
        self.network(vec![element]);
        self.body.entries.push((
            statement.span.clone(),
            Outcome::Approximated(format!("{why}: it is not run")),
        ));
    }
}

impl Writes {
    fn all(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    fn turns(&mut self, statements: &[Statement]) {
        self.loops += 1;
        self.all(statements);
        self.loops -= 1;
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Assign(targets, _, value) => {
                for target in targets {
                    self.target(target);
                }
                self.value(value);
            }
            StatementKind::Call(call) => self.call(call),
            StatementKind::Return | StatementKind::Goto(_) | StatementKind::Label(_) => self.leaves = true,
            StatementKind::Exit | StatementKind::Continue => self.leaves |= self.loops == 0,
            StatementKind::If(branches, otherwise) => {
                for (condition, body) in branches {
                    self.value(condition);
                    self.all(body);
                }
                self.all(otherwise);
            }
            StatementKind::Case(selector, arms, otherwise) => {
                self.value(selector);
                for arm in arms {
                    self.all(&arm.body);
                }
                self.all(otherwise);
            }
            StatementKind::For(counting) => {
                self.target(&counting.variable);
                for value in [Some(&counting.from), Some(&counting.to), counting.by.as_ref()]
                    .into_iter()
                    .flatten()
                {
                    self.value(value);
                }
                self.turns(&counting.body);
            }
            StatementKind::While(condition, body) | StatementKind::Repeat(body, condition) => {
                self.value(condition);
                self.turns(body);
            }
            StatementKind::Pragma(kind, _) => {
                self.is_open = true;
                self.leaves |= *kind != Pragma::Code;
            }
        }
    }

    fn target(&mut self, place: &Place) {
        self.is_open |= place.steps.iter().any(|step| matches!(step, Step::Other(_)));
        self.roots.push(place.root.clone());
    }

    /// A block may write what it sees.
    fn call(&mut self, call: &Call) {
        self.is_open = true;
        for argument in &call.arguments {
            if let (
                true,
                Some(Tree {
                    kind: ExpressionKind::Place(place),
                    ..
                }),
            ) = (argument.direction != Direction::In, &argument.value)
            {
                self.target(place);
            }
        }
    }

    fn value(&mut self, tree: &Tree) {
        match &tree.kind {
            // A function that is not known may write what it sees.
            ExpressionKind::Call(_) => self.is_open = true,
            ExpressionKind::Unary(_, inner) | ExpressionKind::Group(inner) => self.value(inner),
            ExpressionKind::Binary(_, left, right) | ExpressionKind::Lazy(_, left, right) => {
                self.value(left);
                self.value(right);
            }
            ExpressionKind::Literal(..) | ExpressionKind::Place(_) => {}
        }
    }
}
