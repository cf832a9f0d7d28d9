//! Assignments, IF and CASE.

use super::super::scope::{ParameterRole, Scope, Type};
use super::super::tree::{
    Assignment, Expression as Tree, ExpressionKind, LiteralKind, Place, Pragma, Span, Statement,
    StatementKind, Step,
};
use super::super::uses::Uses;
use super::condition::Power;
use super::expression::may_fault;
use super::place::has_computed_index;
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Operator, Path};
use ladder_instructions::Op;
use ladder_notation::Outcome;

/// An IF is one network if it does no more than this.
const MOST_IN_ONE: usize = 3;

impl Lowering<'_, '_> {
    pub(super) fn statements(&mut self, statements: &[Statement]) {
        let mut rest = statements;
        while let [statement, after @ ..] = rest
            && self.body.unread.is_none()
        {
            rest = after;
            if let Some(whole) = self.with_output(statement, after.first())
                && self.translated(&whole).is_ok()
            {
                rest = &after[1..];
            } else {
                self.statement(statement);
            }
        }
    }

    /// Statements that run only in some cases.
    pub(super) fn inner(&mut self, statements: &[Statement]) {
        self.depth += 1;
        self.statements(statements);
        self.depth -= 1;
    }

    fn statement(&mut self, statement: &Statement) {
        if let Err(why) = self.translated(statement) {
            self.unread(statement, &why);
        }
    }

    /// The networks of a statement; none where it is not read.
    fn translated(&mut self, statement: &Statement) -> Lowered<()> {
        self.take_comments(statement.span.start);
        self.body.origins.push(statement.span.start);
        self.origin = Some(self.first_origin + self.body.origins.len() as u32 - 1);
        let state = self.state();
        let used = state.used;
        let done = self.lowered(statement);
        if done.is_ok() {
            self.body
                .entries
                .push((statement.span.clone(), Outcome::Translated));
        } else {
            self.restore(state);
        }
        self.release(used);
        done
    }

    fn lowered(&mut self, statement: &Statement) -> Lowered<()> {
        match &statement.kind {
            StatementKind::Assign(targets, how, value) => {
                self.comments_on_line(statement.span.end);
                self.assignment(statement, targets, *how, value)
            }
            StatementKind::Call(call) => {
                self.comments_on_line(statement.span.end);
                self.call(call)
            }
            StatementKind::Return
            | StatementKind::Exit
            | StatementKind::Continue
            | StatementKind::Goto(_) => {
                self.comments_on_line(statement.span.end);
                let leave = self.leave(statement)?;
                self.network(vec![leave]);
                Ok(())
            }
            StatementKind::Label(name) => {
                self.label(&user_label(name));
                Ok(())
            }
            StatementKind::If(branches, otherwise) => self.branches(statement, branches, otherwise),
            StatementKind::Case(selector, arms, otherwise) => self.case(selector, arms, otherwise),
            StatementKind::For(counting) => self.counting(statement, counting),
            StatementKind::While(condition, body) => self.while_loop(condition, body),
            StatementKind::Repeat(body, condition) => self.repeat(body, condition),
            StatementKind::Pragma(Pragma::Choice, _) => Err("what is compiled is chosen here".to_owned()),
            StatementKind::Pragma(Pragma::Code | Pragma::Leaving, _) => {
                Err("it is text in C, or for the compiler".to_owned())
            }
        }
    }

    /// The block that leaves a loop or the body.
    fn leave(&mut self, statement: &Statement) -> Lowered<Circuit<Element>> {
        let outside = || "it is outside of a loop".to_owned();
        match &statement.kind {
            StatementKind::Return => Ok(self.element(Block::ret())),
            StatementKind::Exit => {
                let own = self.loops.last_mut().ok_or_else(outside)?;
                own.uses_end = true;
                let label = own.end.clone();
                Ok(self.jump(&label))
            }
            StatementKind::Continue => {
                let own = self.loops.last_mut().ok_or_else(outside)?;
                own.uses_next = true;
                let label = own.next.clone();
                Ok(self.jump(&label))
            }
            StatementKind::Goto(name) => Ok(self.jump(&user_label(name))),
            _ => Err("it does not leave anything".to_owned()),
        }
    }

    /// Where an assignment goes. Inputs of an instance may be written as members; what is else inside of one is not.
    pub(super) fn target(&mut self, place: &Place) -> Lowered<(Path, Type)> {
        if let [Step::Member(member)] = &place.steps[..]
            && self.around.scope.of_step(&place.root, member).is_some()
        {
            return Err(format!("`{}` is a step, which only its chart writes", place.root));
        }
        if let Some(handed) = self.handed_over(place) {
            return self.target(&handed);
        }
        if let Some(known) = self.around.scope.known(&place.root)
            && known.is_constant
        {
            return Err(format!("`{}` is a constant", place.root));
        }
        if let [before @ .., Step::Member(member)] = &place.steps[..] {
            let owner = Place {
                steps: before.to_vec(),
                ..place.clone()
            };
            let owner = self.path(&owner).map_or(Type::Unknown, |(_, ty)| ty);
            let written = match owner {
                Type::Block(shape) => shape
                    .parameters
                    .iter()
                    .any(|own| own.name.eq_ignore_ascii_case(member) && own.role == ParameterRole::Input),
                Type::Standard(_) => {
                    before.is_empty()
                        && ["IN", "PT", "CU", "CD", "R", "LD", "PV", "RESET", "LOAD"]
                            .iter()
                            .any(|own| own.eq_ignore_ascii_case(member))
                }
                Type::Trigger(_) => false,
                _ => true,
            };
            if !written {
                return Err(format!(
                    "`{member}` of an instance is not written from outside here"
                ));
            }
        }
        self.path(place)
    }

    fn assignment(
        &mut self,
        statement: &Statement,
        targets: &[Place],
        how: Assignment,
        value: &Tree,
    ) -> Lowered<()> {
        let Some((last, others)) = targets.split_last() else {
            return Ok(());
        };
        if let ([], Assignment::Value, Some((word, index))) = (others, how, self.computed_bit(last)?) {
            return self.assign_bit(&word, index, value);
        }
        if let ([], Assignment::Value, Some(part)) = (others, how, self.part(last)?) {
            return self.assign_part(&part, last, value);
        }
        let (path, ty) = self.target(last)?;
        match how {
            Assignment::Value => {}
            Assignment::Reference => {
                return Err("references have no counterpart: they work on memory by address".to_owned());
            }
            Assignment::Set | Assignment::Reset => {
                let op = if how == Assignment::Set {
                    Op::SetCoil
                } else {
                    Op::ResetCoil
                };
                let power = self.condition(value)?;
                let coil = Block::of(op, [path])?;
                let parts = vec![self.circuit(&power), self.element(coil)];
                self.network(parts);
                return Ok(());
            }
        }
        let is_coil = others.is_empty()
            && self.depth == 0
            && ty.scalar() == Some(Scalar::Bool)
            && path.whole().is_some()
            && self.uses.is_assigned_once(&last.root);
        if is_coil && let Some(power) = self.drawn_alone(value)? {
            if !matches!(power, Power::Contact(_)) {
                let shown = self.shown(&statement.span);
                self.comments.extend(shown);
            }
            let parts = vec![self.circuit(&power), self.element(Block::coil(&path))];
            self.network(parts);
            return Ok(());
        }
        if let ([], ExpressionKind::Call(call), Some(scalar)) = (others, &value.kind, ty.scalar())
            && path.whole().is_some()
            && is_named_once(statement, &last.root)
            && let Some(enabled) = self.enabled(call)?
        {
            let shown = self.shown(&statement.span);
            self.comments.extend(shown);
            let value = self.enabled_function(&enabled, Some((&path, scalar)))?;
            if value.expression.path() != Some(&path) {
                self.assign(&path, &ty, value)?;
                self.flush();
            }
            return Ok(());
        }
        let value = self.value(value)?;
        self.assign(&path, &ty, value)?;
        let mut from = (path, ty);
        for other in others.iter().rev() {
            let (path, ty) = self.target(other)?;
            self.assign(&path, &ty, Value::of(from.0, from.1))?;
            from = (path, ty);
        }
        if self.chain.len() > 1 {
            let shown = self.shown(&statement.span);
            self.comments.extend(shown);
        }
        self.flush();
        Ok(())
    }

    /// `word.[index] := value`
    fn assign_bit(&mut self, word: &Path, index: Expression, value: &Tree) -> Lowered<()> {
        let value = self.value(value)?;
        let bit = self.temporary(Scalar::Bool);
        self.assign(&bit, &Type::BOOL, value)?;
        self.flush();
        let mask = || Expression::from(1).with(Operator::Shl, index.clone());
        let whole = || Expression::from(word);
        let set = whole().with(Operator::Or, mask());
        let reset = whole().with(Operator::And, mask().negated());
        for (contact, changed) in [
            (Block::contact(bit.clone()), set),
            (Block::negated_contact(bit.clone()), reset),
        ] {
            let changes = Block::of(Op::Calc, [whole(), changed])?;
            let parts = vec![self.element(contact), self.element(changes)];
            self.network(parts);
        }
        Ok(())
    }

    /// A condition that is contacts alone.
    fn drawn_alone(&mut self, tree: &Tree) -> Lowered<Option<Power>> {
        let used = self.used.len();
        let power = self.power(tree)?;
        let is_alone = self.chain.is_empty() && !matches!(power, Some(Power::Always(_)));
        if is_alone {
            return Ok(power);
        }
        self.chain.clear();
        self.release(used);
        Ok(None)
    }

    fn branches(
        &mut self,
        statement: &Statement,
        branches: &[(Tree, Vec<Statement>)],
        otherwise: &[Statement],
    ) -> Lowered<()> {
        if let ([(condition, body)], []) = (branches, otherwise)
            && self.in_one(statement, condition, body)
        {
            return Ok(());
        }
        let end = self.new_label("endif");
        let mut jumps = false;
        let last = branches.len() - 1;
        for (number, (condition, body)) in branches.iter().enumerate() {
            let power = self.condition(condition)?;
            let word = if number == 0 { "IF" } else { "ELSIF" };
            self.header(word, &condition.span, "THEN");
            let is_last = number == last && otherwise.is_empty();
            jumps |= self.branch(power, body, is_last, "else", &end);
        }
        self.otherwise(otherwise);
        if jumps {
            self.label(&end);
        }
        Ok(())
    }

    pub(super) fn otherwise(&mut self, otherwise: &[Statement]) {
        if !otherwise.is_empty() {
            self.comments.push("ELSE".to_owned());
            self.inner(otherwise);
        }
    }

    /// What happens if a condition holds; then the end of the whole. Returns whether anything jumps there.
    pub(super) fn branch(
        &mut self,
        power: Power,
        body: &[Statement],
        is_last: bool,
        word: &'static str,
        end: &str,
    ) -> bool {
        if body.len() <= MOST_IN_ONE && body.iter().all(|inner| is_plain(inner, false)) {
            let state = self.state();
            if let Ok(()) = self.short_branch(&power, body, (!is_last).then_some(end)) {
                return !is_last;
            }
            self.restore(state);
        }
        let next = if is_last {
            end.to_owned()
        } else {
            self.new_label(word)
        };
        let mut parts = self.opposite(power);
        parts.push(self.jump(&next));
        self.network(parts);
        self.inner(body);
        if is_last {
            return true;
        }
        let goes_on = !ends_elsewhere(body);
        if goes_on {
            let jump = self.jump(end);
            self.network(vec![jump]);
        }
        self.label(&next);
        goes_on
    }

    /// A branch that is one network: nothing in it is a fault, so that the power comes through to the jump.
    fn short_branch(&mut self, power: &Power, body: &[Statement], end: Option<&str>) -> Lowered<()> {
        let mut parts: Vec<_> = std::mem::take(&mut self.chain)
            .into_iter()
            .map(Circuit::Element)
            .collect();
        parts.push(self.circuit(power));
        for inner in body {
            self.take_comments(inner.span.start);
            self.comments_on_line(inner.span.end);
            self.plain(inner)?;
        }
        parts.extend(std::mem::take(&mut self.chain).into_iter().map(Circuit::Element));
        parts.extend(end.map(|end| self.jump(end)));
        self.network(parts);
        Ok(())
    }

    /// An assignment after what the network holds so far.
    fn plain(&mut self, statement: &Statement) -> Lowered<()> {
        let StatementKind::Assign(targets, _, value) = &statement.kind else {
            return Err("it is not an assignment".to_owned());
        };
        let [target] = &targets[..] else {
            return Err("several are assigned at once".to_owned());
        };
        let (path, ty) = self.target(target)?;
        let value = self.value(value)?;
        self.assign(&path, &ty, value)?;
        self.body
            .entries
            .push((statement.span.clone(), Outcome::Translated));
        Ok(())
    }

    /// `IF condition THEN` above the network, if it is short; with what else is on its line.
    pub(super) fn header(&mut self, word: &str, span: &Span, then: &str) {
        if let Some(shown) = self.shown(span) {
            self.comments.push(format!("{word} {shown} {then}"));
        }
        self.comments_after(span.end, then);
    }

    /// Takes the comments after a word that ends the head of a statement.
    pub(super) fn comments_after(&mut self, end: usize, word: &str) {
        let rest = self.around.text[end..].trim_start_matches([' ', '\t']);
        let start = self.around.text.len() - rest.len();
        if rest
            .get(..word.len())
            .is_some_and(|own| own.eq_ignore_ascii_case(word))
        {
            self.comments_on_line(start + word.len());
        }
    }

    /// A short IF in one network: contacts, and what they let happen.
    fn in_one(&mut self, statement: &Statement, condition: &Tree, body: &[Statement]) -> bool {
        let leaves = matches!(
            body,
            [Statement {
                kind: StatementKind::Return
                    | StatementKind::Exit
                    | StatementKind::Continue
                    | StatementKind::Goto(_),
                ..
            }]
        );
        let is_short = !body.is_empty()
            && body.len() <= MOST_IN_ONE
            && body.iter().all(|inner| is_plain(inner, body.len() == 1));
        if !leaves && !is_short {
            return false;
        }
        let state = self.state();
        let is_read = self.all_in_one(statement, condition, body).is_ok();
        if !is_read {
            self.restore(state);
        }
        is_read
    }

    fn all_in_one(&mut self, statement: &Statement, condition: &Tree, body: &[Statement]) -> Lowered<()> {
        let power = self.condition(condition)?;
        let mut parts: Vec<_> = std::mem::take(&mut self.chain)
            .into_iter()
            .map(Circuit::Element)
            .collect();
        parts.push(self.circuit(&power));
        for inner in body {
            self.take_comments(inner.span.start);
            self.comments_on_line(inner.span.end);
            match (&inner.kind, body.len()) {
                (StatementKind::Assign(targets, _, value), 1) if truth_of(value).is_some() => {
                    let Some(target) = targets.last() else { continue };
                    let (path, ty) = self.target(target)?;
                    if ty.scalar() != Some(Scalar::Bool) {
                        self.plain(inner)?;
                        continue;
                    }
                    let op = if truth_of(value) == Some(true) {
                        Op::SetCoil
                    } else {
                        Op::ResetCoil
                    };
                    self.act(Block::of(op, [path])?);
                    self.body.entries.push((inner.span.clone(), Outcome::Translated));
                }
                (StatementKind::Assign(..), _) => self.plain(inner)?,
                _ => {
                    let leave = self.leave(inner)?;
                    parts.push(leave);
                }
            }
        }
        parts.extend(std::mem::take(&mut self.chain).into_iter().map(Circuit::Element));
        self.comments_on_line(statement.span.end);
        let shown = self.shown(&statement.span);
        self.comments.extend(shown);
        self.network(parts);
        Ok(())
    }
}

/// What a user calls a label. Those that the reader makes end in a number.
fn user_label(name: &str) -> String {
    if name.ends_with(|c: char| c.is_ascii_digit()) {
        format!("{name}_")
    } else {
        name.to_owned()
    }
}

/// Whether a value is TRUE or FALSE as it is written; 1 and 0 are that, too.
fn truth_of(tree: &Tree) -> Option<bool> {
    let text = match &tree.kind {
        ExpressionKind::Literal(LiteralKind::Integer, text) => text,
        ExpressionKind::Place(place) if place.steps.is_empty() => &place.root,
        _ => return None,
    };
    match text.to_ascii_uppercase().as_str() {
        "TRUE" | "1" => Some(true),
        "FALSE" | "0" => Some(false),
        _ => None,
    }
}

/// Whether a statement can be a block on a rung with others: nothing in it can be a fault, unless it is alone.
fn is_plain(statement: &Statement, is_alone: bool) -> bool {
    let StatementKind::Assign(targets, Assignment::Value, value) = &statement.kind else {
        return false;
    };
    let [target] = &targets[..] else { return false };
    let is_value = matches!(
        &value.kind,
        ExpressionKind::Literal(
            LiteralKind::Integer | LiteralKind::Typed | LiteralKind::Text | LiteralKind::Real,
            _
        ) | ExpressionKind::Place(_)
    );
    if is_alone {
        return !matches!(value.kind, ExpressionKind::Call(_) | ExpressionKind::Lazy(..)) && !has_call(value);
    }
    is_value && !may_fault(value) && !has_computed_index(target)
}

fn has_call(tree: &Tree) -> bool {
    match &tree.kind {
        ExpressionKind::Call(_) | ExpressionKind::Lazy(..) => true,
        ExpressionKind::Unary(_, inner) | ExpressionKind::Group(inner) => has_call(inner),
        // In plain files AND and OR may stop early, which takes networks of their own.
        ExpressionKind::Binary(_, left, right) => may_fault(right) || has_call(left) || has_call(right),
        _ => false,
    }
}

/// Whether a statement names a tag in one place only.
fn is_named_once(statement: &Statement, root: &str) -> bool {
    let scope = Scope::default();
    let uses = Uses::of(std::slice::from_ref(statement), &scope);
    let root = root.to_lowercase();
    uses.names().any(|(name, count)| *name == root && count == 1)
}

/// Whether what follows some statements is not reached from them.
fn ends_elsewhere(statements: &[Statement]) -> bool {
    matches!(
        statements.last().map(|last| &last.kind),
        Some(StatementKind::Return | StatementKind::Exit | StatementKind::Continue | StatementKind::Goto(_))
    )
}
