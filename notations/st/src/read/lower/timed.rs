//! `t(IN := run, PT := T#3s); lamp := t.Q;` is one rung in ladder text: a call takes its output itself where the next line does.

use super::super::scope::Type;
use super::super::tree::{
    Argument, Assignment, Direction, Expression, ExpressionKind, Statement, StatementKind, Step,
};
use super::Lowering;

impl Lowering<'_, '_> {
    /// A call of a timer or counter that takes its output, in the place of a call and of the next line, which takes it. None: they are
    /// something else, or a comment is between them.
    pub(super) fn with_output(&self, call: &Statement, next: Option<&Statement>) -> Option<Statement> {
        let (StatementKind::Call(called), Some(next)) = (&call.kind, next) else {
            return None;
        };
        let StatementKind::Assign(targets, Assignment::Value, value) = &next.kind else {
            return None;
        };
        let ([target], ExpressionKind::Place(output)) = (&targets[..], &value.kind) else {
            return None;
        };
        let [Step::Member(member)] = &output.steps[..] else {
            return None;
        };
        let instance = &called.callee;
        let is_own = instance.steps.is_empty() && output.root.eq_ignore_ascii_case(&instance.root);
        let is_standard = matches!(self.around.scope.known(&instance.root)?.ty, Type::Standard(_));
        let is_power = ["Q", "QU", "Q1"]
            .iter()
            .any(|name| member.eq_ignore_ascii_case(name));
        let is_free = called
            .arguments
            .iter()
            .all(|argument| argument.name.is_some() && argument.direction == Direction::In);
        let between = self.around.text.get(call.span.end..next.span.start)?;
        let is_next_line =
            between.chars().all(|c| c.is_whitespace() || c == ';') && between.matches('\n').count() < 2;
        if !(is_own && is_standard && is_power && is_free && is_next_line) {
            return None;
        }
        let mut called = called.clone();
        called.arguments.push(Argument {
            name: Some(member.clone()),
            direction: Direction::Out,
            value: Some(Expression {
                span: target.span.clone(),
                kind: ExpressionKind::Place(target.clone()),
            }),
        });
        Some(Statement {
            span: call.span.start..next.span.end,
            kind: StatementKind::Call(called),
        })
    }
}
