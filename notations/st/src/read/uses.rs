//! What a body does with its tags, known before the first network of it is made.

use super::scope::{ParameterRole, Scope, Type};
use super::tree::{
    Argument, Call, Direction, Expression, ExpressionKind, Place, Statement, StatementKind, Step,
};
use std::collections::{HashMap, HashSet};

/// What is done with tags; names in small letters.
pub(super) struct Uses<'s> {
    scope: &'s Scope,
    /// How often a tag or a part of it is assigned, also by the output of a call.
    assigned: HashMap<String, u32>,
    /// How often what is called is called; in a loop twice.
    called: HashMap<String, u32>,
    /// How often a tag is named at all, and how often in loops that count with it.
    named: HashMap<String, u32>,
    in_own_loops: HashMap<String, u32>,
    /// The inputs that calls of an instance have a value for, by its name here: `t1.pt`.
    given: HashSet<String>,
    /// The members that are assigned, by the tag's name here: `t1.pt`.
    members: HashSet<String>,
    /// What calls of an instance hand over to its in-outs: `r.val`. None: not the same in all calls.
    handed: HashMap<String, Option<Place>>,
    depth: u32,
    loops: u32,
}

impl Uses<'_> {
    pub(super) fn of<'s>(statements: &[Statement], scope: &'s Scope) -> Uses<'s> {
        let mut uses = Uses::none(scope);
        uses.statements(statements);
        uses
    }

    /// Of no statement yet.
    pub(super) fn none(scope: &Scope) -> Uses<'_> {
        Uses {
            scope,
            assigned: HashMap::new(),
            called: HashMap::new(),
            named: HashMap::new(),
            in_own_loops: HashMap::new(),
            given: HashSet::new(),
            members: HashSet::new(),
            handed: HashMap::new(),
            depth: 0,
            loops: 0,
        }
    }

    /// Of statements that run in some scans only, too.
    pub(super) fn at_times(&mut self, statements: &[Statement]) {
        self.inner(statements);
    }

    /// The names of tags in small letters, with how often each is there.
    pub(super) fn names(&self) -> impl Iterator<Item = (&String, u32)> {
        self.named.iter().map(|(name, count)| (name, *count))
    }

    /// Whether a tag is assigned in one place only, which is always reached.
    pub(super) fn is_assigned_once(&self, name: &str) -> bool {
        self.assigned.get(&name.to_lowercase()) == Some(&1)
    }

    /// Whether a tag or a part of it is assigned at all, or handed to what may do so.
    pub(super) fn is_assigned(&self, name: &str) -> bool {
        self.assigned.contains_key(&name.to_lowercase())
    }

    /// The tags that are assigned, or whose state calls change; and those that are called. As they are called here, in small letters.
    pub(super) fn written(&self) -> (HashSet<String>, HashSet<String>) {
        let here = |name: &String| {
            let known = self.scope.known(name);
            known.map_or(name.clone(), |known| known.path.root.to_lowercase())
        };
        let called: HashSet<String> = self.called.keys().map(here).collect();
        let assigned = self.assigned.keys().map(here);
        (assigned.chain(called.iter().cloned()).collect(), called)
    }

    pub(super) fn calls(&self, name: &str) -> u32 {
        self.called.get(&name.to_lowercase()).copied().unwrap_or(0)
    }

    /// Whether any call of an instance has a value for an input.
    pub(super) fn is_given(&self, name: &str, input: &str) -> bool {
        self.given.contains(&format!("{name}.{input}").to_lowercase())
    }

    /// Whether a member of an instance is assigned.
    pub(super) fn writes_member(&self, name: &str, member: &str) -> bool {
        self.members.contains(&format!("{name}.{member}").to_lowercase())
    }

    /// The tag that all calls of an instance of the unit's own hand over to an in-out.
    pub(super) fn handed_over(&self, name: &str, in_out: &str) -> Option<&Place> {
        let handed = self.handed.get(&format!("{name}.{in_out}").to_lowercase())?;
        handed.as_ref().filter(|_| self.scope.is_of_unit(name))
    }

    /// Takes in what a call of an instance hands over.
    fn hand_over(&mut self, call: &Call) {
        let Some(Type::Block(shape)) = self.scope.known(&call.callee.root).map(|known| &known.ty) else {
            return;
        };
        let mut in_order = shape.parameters.iter();
        for argument in &call.arguments {
            let parameter = match &argument.name {
                Some(name) => shape
                    .parameters
                    .iter()
                    .find(|own| own.name.eq_ignore_ascii_case(name)),
                None => in_order.next(),
            };
            let Some(parameter) = parameter.filter(|it| it.role == ParameterRole::InOut) else {
                continue;
            };
            let place = match argument.value.as_ref().map(|value| &value.kind) {
                Some(ExpressionKind::Place(place)) if call.callee.steps.is_empty() => Some(place),
                _ => None,
            };
            let is_member = |step: &Step| matches!(step, Step::Member(_));
            let is_instance = |place: &Place| {
                let known = self.scope.known(&place.root);
                known.is_none_or(|known| matches!(known.ty, Type::Block(_)))
            };
            let place = place.filter(|place| place.steps.iter().all(is_member) && !is_instance(place));
            let is_same = |other: &Place| {
                place.is_some_and(|place| {
                    place.root.eq_ignore_ascii_case(&other.root) && place.steps == other.steps
                })
            };
            let key = format!("{}.{}", call.callee.root, parameter.name).to_lowercase();
            self.handed
                .entry(key)
                .and_modify(|handed| *handed = handed.take().filter(is_same))
                .or_insert_with(|| place.cloned());
        }
    }

    /// Whether a tag that counts a loop is named outside of such loops, too.
    pub(super) fn outlives_loops(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        self.named.get(&name) != self.in_own_loops.get(&name)
    }

    /// The member of a tag as it is called here, which is how it is asked for.
    fn member(&self, root: &str, member: &str) -> String {
        let here = self.scope.known(root).map_or(root, |known| &known.path.root);
        format!("{here}.{member}").to_lowercase()
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    fn inner(&mut self, statements: &[Statement]) {
        self.depth += 1;
        self.statements(statements);
        self.depth -= 1;
    }

    fn turns(&mut self, statements: &[Statement]) {
        self.loops += 1;
        self.inner(statements);
        self.loops -= 1;
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Assign(targets, _, value) => {
                self.expression(value);
                for target in targets {
                    self.target(target);
                }
            }
            StatementKind::Call(call) => self.call(call),
            StatementKind::If(branches, otherwise) => {
                for (condition, body) in branches {
                    self.expression(condition);
                    self.inner(body);
                }
                self.inner(otherwise);
            }
            StatementKind::Case(selector, arms, otherwise) => {
                self.expression(selector);
                for arm in arms {
                    self.inner(&arm.body);
                }
                self.inner(otherwise);
            }
            StatementKind::For(counting) => {
                let name = counting.variable.root.to_lowercase();
                let before = self.named.get(&name).copied().unwrap_or(0);
                let own = self.in_own_loops.get(&name).copied().unwrap_or(0);
                self.target(&counting.variable);
                self.expression(&counting.from);
                self.expression(&counting.to);
                counting.by.iter().for_each(|by| self.expression(by));
                self.turns(&counting.body);
                let named = self.named.get(&name).copied().unwrap_or(0) - before;
                self.in_own_loops.insert(name, own + named);
            }
            StatementKind::While(condition, body) | StatementKind::Repeat(body, condition) => {
                self.expression(condition);
                self.turns(body);
            }
            // What is after a label may be reached from anywhere.
            StatementKind::Label(_) => self.depth += 1,
            // Twice, for it may be assigned as well.
            StatementKind::Pragma(_, words) => {
                for word in words {
                    *self.named.entry(word.clone()).or_default() += 2;
                }
            }
            StatementKind::Return
            | StatementKind::Exit
            | StatementKind::Continue
            | StatementKind::Goto(_) => {}
        }
    }

    /// What is assigned.
    fn target(&mut self, place: &Place) {
        let times = if self.depth == 0 { 1 } else { 2 };
        *self.assigned.entry(place.root.to_lowercase()).or_default() += times;
        if let [.., Step::Member(member)] = &place.steps[..] {
            self.members.insert(self.member(&place.root, member));
        }
        self.place(place);
    }

    fn place(&mut self, place: &Place) {
        *self.named.entry(place.root.to_lowercase()).or_default() += 1;
        for step in &place.steps {
            match step {
                Step::Index(indices) => indices.iter().for_each(|index| self.expression(index)),
                Step::ComputedBit(bit) => self.expression(bit),
                Step::Member(_) | Step::Bit(_) | Step::Part(..) | Step::Other(_) => {}
            }
        }
    }

    fn call(&mut self, call: &Call) {
        self.place(&call.callee);
        self.hand_over(call);
        let times = if self.loops > 0 { 2 } else { 1 };
        *self.called.entry(call.callee.root.to_lowercase()).or_default() += times;
        let has_in_outs = match self.scope.known(&call.callee.root).map(|known| &known.ty) {
            Some(Type::Block(shape)) => shape
                .parameters
                .iter()
                .any(|one| one.role == ParameterRole::InOut),
            Some(Type::Standard(_) | Type::Trigger(_)) => false,
            _ => true,
        };
        for Argument {
            name,
            direction,
            value,
        } in &call.arguments
        {
            if let (Some(name), Some(_)) = (name, value) {
                self.given.insert(self.member(&call.callee.root, name));
            }
            let Some(value) = value else { continue };
            match &value.kind {
                ExpressionKind::Place(place) if *direction != Direction::In => self.target(place),
                // An in-out may be written, too.
                ExpressionKind::Place(place) if has_in_outs => {
                    *self.assigned.entry(place.root.to_lowercase()).or_default() += 2;
                    self.place(place);
                }
                _ => self.expression(value),
            }
        }
    }

    /// Of a value, too.
    pub(super) fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Literal(..) => {}
            ExpressionKind::Place(place) => self.place(place),
            ExpressionKind::Unary(_, inner) | ExpressionKind::Group(inner) => self.expression(inner),
            ExpressionKind::Binary(_, left, right) | ExpressionKind::Lazy(_, left, right) => {
                self.expression(left);
                self.expression(right);
            }
            ExpressionKind::Call(call) => {
                self.place(&call.callee);
                for argument in &call.arguments {
                    match &argument.value {
                        Some(Expression {
                            kind: ExpressionKind::Place(place),
                            ..
                        }) if argument.direction != Direction::In => self.target(place),
                        Some(value) => self.expression(value),
                        None => {}
                    }
                }
            }
        }
    }
}
