//! Blocks as they are here: `[TON]( T1, T#5s )`, `[ADD]( y, a, b )`, `[$Motor]( m1, start := a )`.

use super::blocks::{Class, is_enable, named_in_unit, operand_pins, result_output, state};
use super::body::Body;
use crate::expression::{Form, Typed};
use crate::graph::{End, Kind};
use crate::model::{Role, Type, UnitKind};
use crate::scope::local;
use crate::standard::{self, Function, Gate, StandardBlock};
use ladder_format::program::{Block, Expression, Literal, Operand, Operator, Path, Step};
use ladder_instructions::{Op, Shape};

/// What a tag is for that holds power.
const POWER: &str = "the power after a block";

impl Body<'_> {
    /// Instances, and which tags are read by name.
    pub(super) fn names(&mut self) {
        for node in 0..self.graph.nodes.len() {
            let (read, written) = (self.reads(node), self.writes(node));
            self.made.needed.extend(read.into_iter().chain(written));
        }
        for node in 0..self.graph.nodes.len() {
            let Kind::Block { name, instance, .. } = &self.graph.nodes[node].kind else {
                continue;
            };
            if let Some(ty) = state(self.shared, name) {
                let is_word = |name: &str| name.chars().all(|c| c.is_alphanumeric() || c == '_');
                let instance = match instance.as_deref().filter(|name| *name != "???") {
                    Some(instance) if !is_word(instance) || self.knows(instance) => self.variable(instance),
                    like => {
                        let like = like.map_or_else(|| name.to_lowercase(), str::to_owned);
                        Ok(self.helper(&like, &ty, "a block that the project does not declare"))
                    }
                };
                match instance {
                    Ok(instance) => drop(self.tags.instances.insert(node, instance)),
                    Err(why) => self.refuse(node, why),
                }
            }
        }
    }

    fn knows(&self, name: &str) -> bool {
        self.made.scope.get(name).is_some() || self.shared.globals.get(name).is_some()
    }

    /// A block, and what is in the wire with it.
    pub(super) fn blocks(&mut self, node: usize) -> Result<Vec<Block>, String> {
        let Some(class) = self.class(node) else {
            return Ok(Vec::new());
        };
        let block = match class {
            Class::Standard(StandardBlock::Rising) => Block::one_shot(),
            Class::Standard(StandardBlock::Falling) => {
                return Ok(vec![Block::inverter(), Block::one_shot()]);
            }
            Class::Standard(StandardBlock::Stateful(mnemonic, _, pins)) => {
                self.with_state(node, mnemonic, pins)?
            }
            Class::Unit(kind) => self.unit(node, kind)?,
            Class::Value(mnemonic) => {
                let mut given = operand_pins(self, node).into_iter();
                let given = given.find_map(|pin| {
                    let form = self.tags.operands.get(&(node, pin))?.form();
                    matches!(form, Form::Formula | Form::Milliseconds).then_some(form)
                });
                let mnemonic = match given {
                    Some(Form::Formula) => "CALC",
                    Some(_) => "TYP",
                    None => mnemonic,
                };
                self.computing(node, mnemonic)?
            }
            Class::Convert => self.computing(node, "TYP")?,
            Class::Logic(function) => {
                let result = self.result(node)?.into();
                Block::of(Op::Calc, [result, formula(function, self.values(node)?)?])?
            }
            Class::Unknown => self.unread(node)?,
            Class::Text | Class::Gate(_) | Class::Compare(_) => {
                return Err("it has no counterpart".to_owned());
            }
        };
        Ok(vec![block])
    }

    /// A comparison in a wire.
    pub(super) fn comparison(&self, node: usize, class: Class) -> Result<Block, String> {
        let Class::Compare(mnemonic) = class else {
            return Err("it has no counterpart".to_owned());
        };
        let values = self.values(node)?;
        if values.len() < 2 {
            return Err("a comparison has two inputs".to_owned());
        }
        Ok(Block::spelled(Shape::Logical, mnemonic, values)?)
    }

    /// What makes a value of values: `[ADD]( y, a, b )`
    fn computing(&self, node: usize, mnemonic: &str) -> Result<Block, String> {
        let mut operands = vec![Expression::from(self.result(node)?)];
        operands.extend(self.values(node)?);
        if operands.len() < 2 {
            return Err("nothing is wired to its inputs".to_owned());
        }
        Ok(Block::spelled(Shape::Logical, mnemonic, operands)?)
    }

    /// The operands at the pins that something is wired to.
    fn values(&self, node: usize) -> Result<Vec<Expression>, String> {
        let pins = operand_pins(self, node).into_iter();
        let pins = pins.filter(|pin| !self.graph.nodes[node].inputs[*pin].from.is_empty());
        pins.map(|pin| {
            let operand = self.tags.operands.get(&(node, pin));
            let operand = operand.ok_or_else(|| "one of its inputs is not known".to_owned())?;
            Ok(operand.value.clone())
        })
        .collect()
    }

    fn result(&self, node: usize) -> Result<&Path, String> {
        let output = result_output(&self.graph.nodes[node]).ok_or("it has no output")?;
        let tag = self.tags.results.get(&End { node, output });
        tag.ok_or_else(|| "nothing takes its result".to_owned())
    }

    fn instance(&self, node: usize) -> Result<&Path, String> {
        let instance = self.tags.instances.get(&node);
        instance.ok_or_else(|| "it has no name".to_owned())
    }

    /// A timer, a counter or a bistable.
    fn with_state(
        &mut self,
        node: usize,
        mnemonic: &str,
        pins: &[(&str, Option<&str>)],
    ) -> Result<Block, String> {
        let mut operands = vec![Operand::from(self.instance(node)?)];
        for (pin, name) in pins {
            let mut inputs = self.graph.nodes[node].inputs.iter();
            let index = inputs.position(|input| standard::is_pin(&input.name, pin));
            let operand = index.and_then(|index| self.tags.operands.get(&(node, index)));
            let value = operand.map(|operand| operand.value.clone());
            match (value, name) {
                (Some(value), Some(name)) => operands.push(Operand::Given((*name).to_owned(), value)),
                (Some(value), None) => operands.push(value.into()),
                (None, Some(_)) => {}
                (None, None) => {
                    self.note(node, "nothing is wired to its limit: it is nothing here");
                    operands.push(Literal::read(if *pin == "PT" { "T#0s" } else { "0" })?.into());
                }
            }
        }
        Ok(Block::spelled(Shape::Logical, mnemonic, operands)?)
    }

    /// A unit of the project.
    fn unit(&self, node: usize, kind: UnitKind) -> Result<Block, String> {
        let Kind::Block { name, .. } = &self.graph.nodes[node].kind else {
            return Err("it is no block".to_owned());
        };
        let block = self
            .shared
            .blocks
            .get(&name.to_lowercase())
            .ok_or("it is not known")?;
        let mut operands = Vec::new();
        if kind == UnitKind::FunctionBlock {
            operands.push(Operand::from(self.instance(node)?));
        }
        for (index, pin) in self.graph.nodes[node].inputs.iter().enumerate() {
            if is_enable(&pin.name) || named_in_unit(self, node, &pin.name) == Some("EN") {
                continue;
            }
            let Some(operand) = self.tags.operands.get(&(node, index)) else {
                continue;
            };
            let known = block
                .scope
                .get(&pin.name)
                .ok_or_else(|| format!("`{name}` has no input `{}`", pin.name))?;
            operands.push(Operand::Given(known.path.root.clone(), operand.value.clone()));
        }
        let missing = local(block.unit).find(|variable| {
            let is_given = |pin: &str| pin.eq_ignore_ascii_case(&variable.name);
            let pins = &self.graph.nodes[node].inputs;
            let given = pins.iter().any(|pin| is_given(&pin.name) && !pin.from.is_empty());
            variable.role == Role::InOut && !given
        });
        if let Some(missing) = missing {
            return Err(format!(
                "nothing is wired to `{}`, which is read and written",
                missing.name
            ));
        }
        if kind == UnitKind::Function {
            let first = result_output(&self.graph.nodes[node]);
            for (output, pin) in self.graph.nodes[node].outputs.iter().enumerate() {
                let Some(tag) = self.tags.results.get(&End { node, output }) else {
                    continue;
                };
                // The result is called OUT, or as the function, or not at all.
                let known = block.scope.get(&pin.name).filter(|_| !pin.name.is_empty());
                let known = known.or_else(|| block.scope.get(name).filter(|_| first == Some(output)));
                let known = known.ok_or_else(|| format!("`{name}` has no output `{}`", pin.name))?;
                operands.push(Operand::Taken(known.path.root.clone(), tag.into()));
            }
        }
        Ok(Block::user(block.name.trim_start_matches('$'), operands)?)
    }

    /// A value that a variable takes.
    pub(super) fn moved(&self, variable: &str, is_negated: bool, value: Typed) -> Result<Block, String> {
        // The count of a counter is a DINT here, and an INT there.
        let last = value.value.path().and_then(|path| path.steps.last());
        let is_count = matches!(last, Some(Step::Member(member)) if member == "CV");
        let fits = matches!(self.operand(variable)?.ty, Some(Type::Named(name)) if matches!(standard::elementary(&name), Some("DINT" | "LINT")));
        let op = match is_count && !fits {
            _ if is_negated => Op::Not,
            true => Op::Typ,
            false => Op::Mov,
        };
        Ok(Block::of(op, [self.variable(variable)?.into(), value.value])?)
    }

    /// The tag that holds the power after a block.
    pub(super) fn holder(&mut self, end: End) -> Path {
        if let Some(tag) = self.tags.holders.get(&end).cloned() {
            // It may have been made for a network that could not be drawn.
            let is_declared = self.tags.instances.get(&end.node) == Some(&tag)
                || self.made.helpers.iter().any(|(name, ..)| *name == tag.root);
            if !is_declared {
                let helper = (tag.root.clone(), "BOOL".to_owned(), POWER.to_owned());
                self.made.helpers.push(helper);
            }
            return tag;
        }
        let tag = match (self.class(end.node), self.tags.instances.get(&end.node)) {
            // The tag of the edge detector itself, which is declared where it is read.
            (Some(Class::Standard(_)), Some(instance)) => {
                self.made.needed.insert(instance.root.to_lowercase());
                instance.clone()
            }
            _ => self.helper("power", "BOOL", POWER),
        };
        self.tags.holders.insert(end, tag.clone());
        tag
    }

    /// Whether an edge detector is read by its name.
    pub(super) fn is_read_by_name(&self, node: usize) -> bool {
        let is_trigger = matches!(
            self.class(node),
            Some(Class::Standard(StandardBlock::Rising | StandardBlock::Falling))
        );
        let instance = self.tags.instances.get(&node).filter(|_| is_trigger);
        instance.is_some_and(|instance| self.made.needed.contains(&instance.root.to_lowercase()))
    }
}

/// A comparison or a gate as a formula.
fn formula(function: Function, operands: Vec<Expression>) -> Result<Expression, String> {
    let (values, operator, least) = match function {
        Function::Gate(Gate::Not) => (
            operands.into_iter().map(Expression::negated).take(1).collect(),
            Operator::And,
            1,
        ),
        Function::Gate(Gate::And) => (operands, Operator::And, 1),
        Function::Gate(Gate::Or) => (operands, Operator::Or, 1),
        Function::Gate(Gate::Xor) => (operands, Operator::Xor, 1),
        Function::Compare(_, operator) => {
            let pairs = operands.windows(2);
            let pairs = pairs.map(|pair| pair[0].clone().with(operator, pair[1].clone()));
            (pairs.collect::<Vec<_>>(), Operator::And, 2)
        }
        _ => return Err("it has no counterpart".to_owned()),
    };
    let formula = values.into_iter().reduce(|all, next| all.with(operator, next));
    formula.ok_or_else(|| format!("it has {least} inputs or more"))
}
