//! What begins again at each call: locals of functions, temporary variables.

use super::super::scope::{Known, Scope, Type};
use super::super::tree::{Assignment, Statement, StatementKind};
use super::super::uses::Uses;
use super::Lowering;
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Block, Expression, Literal, Operand, Path};
use ladder_instructions::Op;
use ladder_notation::Outcome;
use std::collections::HashSet;

/// A variable that begins again at each call.
#[derive(Debug, Clone)]
pub struct Restarted {
    /// As the other system calls it.
    pub name: String,
    /// What it begins with, where that is not what its type begins with.
    pub initial: Option<Expression>,
    /// Whether it begins with what cannot be assigned at once.
    pub is_compound: bool,
}

impl Lowering<'_, '_> {
    /// Networks for the variables that the statements read before they write them.
    pub(super) fn restarted(&mut self, all: &[Restarted], statements: &[Statement]) {
        if all.is_empty() {
            return;
        }
        let written = written_first(statements);
        for Restarted {
            name,
            initial,
            is_compound,
        } in all
        {
            let Some(Known { path, ty, .. }) = self.around.scope.known(name) else {
                continue;
            };
            if ty.keeps_state() || written.contains(&name.to_lowercase()) {
                continue;
            }
            match begin(path, ty, initial.as_ref()).filter(|_| !is_compound) {
                Some(block) => {
                    self.act(block);
                    self.flush();
                }
                None => {
                    let why = format!("`{name}` keeps its value from one call to the next here");
                    let start = statements.first().map_or(0, |first| first.span.start);
                    self.body.entries.push((start..start, Outcome::Approximated(why)));
                }
            }
        }
    }
}

/// The tags that the first statement which names them assigns, whatever they held, and those that nothing names; in small letters.
fn written_first(statements: &[Statement]) -> HashSet<String> {
    let scope = Scope::default();
    let (mut seen, mut written) = (HashSet::new(), HashSet::new());
    for statement in statements {
        let uses = Uses::of(std::slice::from_ref(statement), &scope);
        for (name, count) in uses.names() {
            let is_new = seen.insert(name.clone());
            let StatementKind::Assign(targets, Assignment::Value, _) = &statement.kind else {
                continue;
            };
            let [target] = &targets[..] else { continue };
            if is_new && count == 1 && target.steps.is_empty() && target.root.to_lowercase() == *name {
                written.insert(name.clone());
            }
        }
    }
    written
}

/// The block that gives a tag what it begins with. None: there is none for such a type.
fn begin(path: &Path, ty: &Type, initial: Option<&Expression>) -> Option<Block> {
    let literal = match (ty, initial) {
        (Type::Scalar(_) | Type::Enumeration(_), Some(initial)) => initial.clone(),
        (Type::Scalar(scalar), None) => zero(*scalar).into(),
        (Type::Trigger(_), None) => Literal::from(false).into(),
        (Type::Enumeration(all), None) => Path::tag(all.name.clone())
            .member(all.values.first()?.clone())
            .into(),
        (Type::Array(bounds, inner), None) if bounds.len() == 1 => {
            let Type::Scalar(scalar) = **inner else {
                return None;
            };
            let (first, last) = &bounds[0];
            let range = path.clone().range(
                Expression::literal(first.clone()).ok()?,
                Expression::literal(last.clone()).ok()?,
            );
            return Block::of(Op::Fill, [Operand::from(range), zero(scalar).into()]).ok();
        }
        _ => return None,
    };
    Block::of(Op::Mov, [Operand::from(path), literal.into()]).ok()
}

/// What a type begins with.
pub(super) fn zero(ty: Scalar) -> Literal {
    let text = match ty {
        Scalar::Bool => "FALSE",
        Scalar::Real | Scalar::Lreal => "0.0",
        Scalar::Time => "T#0s",
        Scalar::Date => "D#1970-01-01",
        Scalar::Tod => "TOD#00:00:00",
        Scalar::Dt => "DT#1970-01-01-00:00:00",
        Scalar::String(_) => "''",
        _ => "0",
    };
    Literal::read(text).unwrap_or_else(|_| Literal::from(0))
}
