//! Calls of function blocks.

use super::super::scope::{Edge, ParameterRole, Shape, Type};
use super::super::tree::{Argument, Call, Direction, Expression as Tree, ExpressionKind, Place, Step};
use super::value::Value;
use super::{Instructions, Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Block, Declaration, Expression, Operand, Operator, Path};
use ladder_instructions::{Op, Shape as Brackets};
use std::rc::Rc;

/// A standard block: the input that is its power, the one that is an operand, those that are named, and the order
/// of operands without names.
struct Row {
    power: &'static str,
    operand: Option<&'static str>,
    named: &'static [(&'static str, &'static str)],
    order: &'static [&'static str],
}

const fn row(mnemonic: &str) -> Row {
    let none: &[(&str, &str)] = &[];
    match mnemonic.as_bytes() {
        b"CTU" => Row {
            power: "CU",
            operand: Some("PV"),
            named: &[("R", "R")],
            order: &["CU", "R", "PV", "Q", "CV"],
        },
        b"CTD" => Row {
            power: "CD",
            operand: Some("PV"),
            named: &[("LD", "LD")],
            order: &["CD", "LD", "PV", "Q", "CV"],
        },
        b"CTUD" => Row {
            power: "CU",
            operand: Some("PV"),
            named: &[("CD", "CD"), ("R", "R"), ("LD", "LD")],
            order: &["CU", "CD", "R", "LD", "PV", "QU", "QD", "CV"],
        },
        b"RTO" => Row {
            power: "IN",
            operand: Some("PT"),
            named: &[("R", "R")],
            order: &["IN", "R", "PT", "Q", "ET"],
        },
        b"SR" => Row {
            power: "S1",
            operand: None,
            named: &[("R", "R")],
            order: &["S1", "R", "Q1"],
        },
        b"RS" => Row {
            power: "S",
            operand: None,
            named: &[("R1", "R")],
            order: &["S", "R1", "Q1"],
        },
        _ => Row {
            power: "IN",
            operand: Some("PT"),
            named: none,
            order: &["IN", "PT", "Q", "ET"],
        },
    }
}

/// Other names that systems have for inputs.
const ALSO: [(&str, &str); 6] = [
    ("RESET", "R"),
    ("RESET1", "R1"),
    ("LOAD", "LD"),
    ("SET1", "S1"),
    ("SET", "S"),
    ("S1", "S"),
];

impl Lowering<'_, '_> {
    pub(super) fn call(&mut self, call: &Call) -> Lowered<()> {
        if call.callee.steps.is_empty() {
            if let Some(shape) = self.around.scope.function_named(&call.callee.root) {
                let shape = Rc::clone(shape);
                return match self.enabled(call)? {
                    Some(enabled) => self.enabled_alone(&enabled, &shape),
                    None => self.function_alone(&shape, call),
                };
            }
            if self.around.scope.known(&call.callee.root).is_none() {
                if let Some(instructions) = self.around.instructions {
                    return self.instruction_of_system(instructions, call);
                }
                return Err(super::unread::no_counterpart(&call.callee.root));
            }
        }
        let (path, ty) = self.instance(&call.callee)?;
        match ty {
            Type::Standard(_) | Type::Trigger(_) if self.enabled(call)?.is_some() => {
                Err(format!("a call of `{path}` with EN or ENO is not read: use IF"))
            }
            Type::Standard(mnemonic) => self.standard_block(mnemonic, &path, call),
            Type::Trigger(edge) => self.trigger(edge, &path, call),
            Type::Block(shape) => match self.enabled(call)? {
                Some(enabled) => self.enabled_block(&enabled, &shape, &path),
                None => self.user_block(&shape, &path, call),
            },
            _ => Err(format!("`{path}` is not a block that can be called")),
        }
    }

    /// An instruction that the other system has on its rungs, too.
    fn instruction_of_system(&mut self, instructions: &Instructions<'_>, call: &Call) -> Lowered<()> {
        let text = self.around.text;
        let values = call
            .arguments
            .iter()
            .filter_map(|argument| argument.value.as_ref());
        let operands: Vec<&str> = values.map(|value| text[value.span.clone()].trim()).collect();
        let name = &call.callee.root;
        let whole = format!("{name}({})", operands.join(","));
        let made = instructions(name, &operands, &whole, self.origin)?;
        for circuit in made {
            self.network(vec![circuit]);
        }
        Ok(())
    }

    /// What is called. TIA may name the instruction after the instance: `#timer.TON(..)`.
    fn instance(&mut self, callee: &Place) -> Lowered<(Path, Type)> {
        if let [before @ .., Step::Member(name)] = &callee.steps[..] {
            let owner = Place {
                steps: before.to_vec(),
                ..callee.clone()
            };
            let found = self.path(&owner);
            if let Ok((path, ty)) = found {
                let is_itself = match &ty {
                    Type::Standard(mnemonic) => {
                        name.eq_ignore_ascii_case(mnemonic)
                            || self.around.scope.type_named(name) == Some(ty.clone())
                    }
                    Type::Trigger(_) => self.around.scope.type_named(name) == Some(ty.clone()),
                    Type::Block(_) => ty.member(name).is_none_or(|(_, ty)| !ty.keeps_state()),
                    _ => false,
                };
                if is_itself {
                    return match ty {
                        Type::Block(_) => {
                            Err(format!("`{name}` is a method of a block; only its body is read"))
                        }
                        ty => Ok((path, ty)),
                    };
                }
            }
        }
        self.path(callee)
    }

    /// A function whose result nobody takes.
    fn function_alone(&mut self, shape: &Rc<Shape>, call: &Call) -> Lowered<()> {
        let operands = self.operands(&shape.parameters, call)?;
        self.act(Block::user(shape.name.clone(), operands)?);
        self.flush();
        Ok(())
    }

    fn user_block(&mut self, shape: &Rc<Shape>, path: &Path, call: &Call) -> Lowered<()> {
        // Outputs of other types are taken after the call.
        let mut after = Vec::new();
        let mut own = call.clone();
        own.arguments.retain(|argument| {
            let parameter = shape.parameters.iter().find(|one| {
                one.role == ParameterRole::Output
                    && argument
                        .name
                        .as_deref()
                        .is_some_and(|name| name.eq_ignore_ascii_case(&one.name))
            });
            let (Some(parameter), Some(value)) = (parameter, &argument.value) else {
                return true;
            };
            // It is told of where it is handed over.
            if parameter.ty == Type::Unknown {
                return true;
            }
            after.push((
                path.clone().member(parameter.spelled.clone()),
                parameter.ty.clone(),
                value.clone(),
                argument.direction,
            ));
            false
        });
        let mut operands = vec![Operand::from(path)];
        operands.extend(self.operands(&shape.parameters, &own)?);
        let mut later = Vec::new();
        for (from, ty, target, direction) in after {
            let ExpressionKind::Place(place) = &target.kind else {
                return Err("an output goes into a tag".to_owned());
            };
            let (to, to_ty) = self.target(place)?;
            match from.steps.last() {
                Some(ladder_format::program::Step::Member(name))
                    if ty == to_ty && direction == Direction::Out =>
                {
                    operands.push(Operand::Taken(name.clone(), to.into()));
                }
                _ => later.push((from, ty, to, to_ty, direction)),
            }
        }
        self.once_more(path, "duplicate-instance");
        self.act(Block::user(shape.name.clone(), operands)?);
        self.flush();
        for (from, ty, to, to_ty, direction) in later {
            self.taken(Value::of(from, ty), &to, &to_ty, direction)?;
        }
        Ok(())
    }

    /// An output that goes into a tag, after the call.
    pub(super) fn taken(&mut self, value: Value, to: &Path, ty: &Type, direction: Direction) -> Lowered<()> {
        let value = if direction == Direction::OutNegated {
            Value::of(value.expression.negated(), Type::BOOL)
        } else {
            value
        };
        self.assign(to, ty, value)?;
        self.flush();
        Ok(())
    }

    /// A second block on one instance works on the one state, as a second call does there.
    pub(super) fn once_more(&mut self, path: &Path, rule: &str) {
        if !self.instances.insert(path.to_string().to_lowercase()) {
            self.directives
                .push(format!("allow({rule}): several calls of {path}"));
        }
    }

    fn standard_block(&mut self, mnemonic: &'static str, path: &Path, call: &Call) -> Lowered<()> {
        let row = row(mnemonic);
        for argument in &call.arguments {
            let is_known = argument.name.as_deref().is_none_or(|name| {
                row.order.contains(&pin(name, &row).as_str()) || name.eq_ignore_ascii_case("Q")
            });
            if !is_known {
                return Err(format!(
                    "`{mnemonic}` does not have `{}`",
                    argument.name.as_deref().unwrap_or_default()
                ));
            }
        }
        let root = &call.callee.root;
        let mut operands = vec![Operand::from(path)];
        if let Some(operand) = row.operand {
            let ty = if operand == "PT" {
                Scalar::Time
            } else {
                Scalar::Dint
            };
            let value = self.input(path, root, operand, ty, given(call, operand, &row))?;
            operands.push(
                value
                    .unwrap_or_else(|| path.clone().member(operand).into())
                    .into(),
            );
        }
        for (input, name) in row.named {
            let value = self.input(path, root, input, Scalar::Bool, given(call, input, &row))?;
            let is_ever_given = self.uses.is_given(root, input)
                || ALSO
                    .iter()
                    .any(|(also, own)| own == input && self.uses.is_given(root, also));
            match value {
                Some(value) => operands.push(Operand::Given((*name).to_owned(), value)),
                // What another call gave is kept.
                None if is_ever_given && mnemonic.starts_with('C') => {
                    operands.push(Operand::Given(
                        (*name).to_owned(),
                        path.clone().member(*name).into(),
                    ));
                }
                None if is_ever_given => {
                    return Err(format!("`{input}` is left out here, and not elsewhere"));
                }
                None => {}
            }
        }
        let mut parts = Vec::new();
        let power = given(call, row.power, &row);
        let written = self.uses.writes_member(root, row.power);
        match power {
            Some(tree) if !written => {
                let power = self.condition(tree)?;
                parts.push(self.circuit(&power));
            }
            _ => {
                let input = self.input(path, root, row.power, Scalar::Bool, power)?;
                let input = match input {
                    Some(Expression::Path(path)) => path,
                    _ if mnemonic.ends_with('S') || mnemonic == "SR" => {
                        return Err(format!("`{}` is left out", row.power));
                    }
                    _ => path.clone().member(row.power),
                };
                parts.push(self.element(Block::contact(input)));
            }
        }
        let rule = if mnemonic.starts_with('C') {
            "duplicate-counter"
        } else {
            "duplicate-timer"
        };
        self.once_more(path, rule);
        let block = Block::spelled(Brackets::Logical, mnemonic, operands)?;
        parts.push(self.element(block));
        let mut later = Vec::new();
        let outputs = call
            .arguments
            .iter()
            .enumerate()
            .filter_map(|(number, argument)| {
                let name = match &argument.name {
                    Some(name) => pin(name, &row),
                    None => (*row.order.get(number)?).to_owned(),
                };
                let is_output = ["Q", "QU", "QD", "Q1", "ET", "CV"].contains(&name.as_str());
                is_output.then_some((name, argument.direction, argument.value.as_ref()?))
            });
        for (name, direction, value) in outputs {
            let ExpressionKind::Place(place) = &value.kind else {
                return Err("an output goes into a tag".to_owned());
            };
            let (to, ty) = self.target(place)?;
            let is_power = name == "Q" && mnemonic != "CTUD" || name == "Q1" || name == "QU";
            let is_coil = is_power
                && direction != Direction::OutNegated
                && self.uses.is_assigned_once(&place.root)
                && to.whole().is_some();
            if is_coil {
                parts.push(self.element(Block::coil(&to)));
                continue;
            }
            let (member, of) = Type::Standard(mnemonic)
                .member(&name)
                .ok_or_else(|| format!("`{mnemonic}` does not have `{name}`"))?;
            later.push((Value::of(path.clone().member(member), of), to, ty, direction));
        }
        self.network(parts);
        for (value, to, ty, direction) in later {
            self.taken(value, &to, &ty, direction)?;
        }
        Ok(())
    }

    /// The value of an input: what the call has for it, or what the tag beside it holds. None: the call leaves it out.
    fn input(
        &mut self,
        path: &Path,
        root: &str,
        input: &str,
        ty: Scalar,
        given: Option<&Tree>,
    ) -> Lowered<Option<Expression>> {
        let value = match given {
            Some(tree) => Some(self.argument(tree, &Type::Scalar(ty))?),
            None => None,
        };
        if !self.uses.writes_member(root, input) {
            return Ok(value.map(|value| value.expression));
        }
        let beside = self.beside(path, input, ty)?;
        if let Some(value) = value {
            self.assign(&beside, &Type::Scalar(ty), value)?;
        }
        Ok(Some(beside.into()))
    }

    /// The tag in the place of an input that is written as a member, which timers and counters do not allow.
    pub(super) fn beside(&mut self, path: &Path, member: &str, ty: Scalar) -> Lowered<Path> {
        let whole = path
            .whole()
            .ok_or("a member of such an instance is not written here")?
            .to_owned();
        let key = format!("{whole}.{member}").to_lowercase();
        if let Some(name) = self.beside.get(&key) {
            return Ok(Path::tag(name.clone()));
        }
        let name = self.names.fresh(&format!("{whole}_{member}"));
        self.body
            .tags
            .push(Declaration::new(name.clone(), ty.to_string()));
        self.beside.insert(key, name.clone());
        Ok(Path::tag(name))
    }

    /// An edge detector: a BOOL that holds its output. What it remembers belongs to its only block, or is a tag beside it.
    fn trigger(&mut self, edge: Edge, path: &Path, call: &Call) -> Lowered<()> {
        let tree = call.arguments.iter().find_map(|argument| {
            let is_clock = argument
                .name
                .as_deref()
                .is_none_or(|name| name.eq_ignore_ascii_case("CLK"));
            argument
                .value
                .as_ref()
                .filter(|_| is_clock && argument.direction == Direction::In)
        });
        let tree = tree.ok_or("`CLK` is left out")?;
        let falls_at_first = self.around.dialect.falls_at_first();
        let is_alone = path.whole().is_some() && self.uses.calls(&call.callee.root) == 1;
        if is_alone {
            let power = self.condition(tree)?;
            let (mut parts, detector) = match edge {
                Edge::Rising => (vec![self.circuit(&power)], Op::OneShotRising),
                Edge::Falling if falls_at_first => (self.opposite(power), Op::OneShotRising),
                Edge::Falling => (vec![self.circuit(&power)], Op::OneShotFalling),
            };
            parts.push(self.element(Block::of(detector, Operand::NONE)?));
            parts.push(self.element(Block::coil(path)));
            self.network(parts);
        } else {
            let value = self.argument(tree, &Type::BOOL)?;
            let ty = self
                .around
                .scope
                .known(&call.callee.root)
                .map(|known| known.ty.clone());
            let memory = self.memory(path, ty)?;
            let clock = match edge {
                Edge::Falling if falls_at_first => value.expression.negated(),
                _ => value.expression,
            };
            let (now, before) = (clock.clone(), Expression::from(&memory));
            let fresh = match edge {
                Edge::Falling if !falls_at_first => before.with(Operator::And, now.negated()),
                _ => now.with(Operator::And, before.negated()),
            };
            self.instruction("CALC", vec![path.into(), fresh.into()])?;
            self.assign(&memory, &Type::BOOL, Value::of(clock, Type::BOOL))?;
            self.flush();
        }
        for argument in &call.arguments {
            let Argument {
                name: Some(name),
                value: Some(value),
                direction,
            } = argument
            else {
                continue;
            };
            if let (true, ExpressionKind::Place(place)) = (name.eq_ignore_ascii_case("Q"), &value.kind) {
                let (to, ty) = self.target(place)?;
                self.taken(Value::of(path, Type::BOOL), &to, &ty, *direction)?;
            }
        }
        Ok(())
    }

    /// Where an edge detector that is called in several places remembers its input.
    fn memory(&mut self, path: &Path, ty: Option<Type>) -> Lowered<Path> {
        let ty = ty.filter(|ty| match ty {
            Type::Array(_, of) => matches!(**of, Type::Trigger(_)),
            ty => matches!(ty, Type::Trigger(_)),
        });
        let text = ty
            .and_then(|ty| ty.text())
            .ok_or("an edge detector in a structure has no counterpart here")?;
        let key = format!("{}.M", path.root).to_lowercase();
        let name = match self.beside.get(&key) {
            Some(name) => name.clone(),
            None => {
                let name = self.names.fresh(&format!("{}_M", path.root));
                self.body.tags.push(Declaration::new(name.clone(), text));
                self.beside.insert(key, name.clone());
                name
            }
        };
        Ok(Path {
            root: name,
            ..path.clone()
        })
    }
}

/// The input that a name means.
fn pin(name: &str, row: &Row) -> String {
    let upper = name.to_ascii_uppercase();
    if row.order.contains(&upper.as_str()) {
        return upper;
    }
    let also = ALSO
        .iter()
        .find(|(also, own)| *also == upper && row.order.contains(own));
    also.map_or(upper, |(_, own)| (*own).to_owned())
}

/// What a call has for an input.
fn given<'c>(call: &'c Call, input: &str, row: &Row) -> Option<&'c Tree> {
    let is_named = |argument: &&Argument| {
        argument
            .name
            .as_deref()
            .is_some_and(|name| pin(name, row) == input)
    };
    if let Some(argument) = call.arguments.iter().find(is_named) {
        return argument.value.as_ref();
    }
    let at = row.order.iter().position(|own| *own == input)?;
    let argument = call
        .arguments
        .get(at)
        .filter(|argument| argument.name.is_none())?;
    argument.value.as_ref()
}
