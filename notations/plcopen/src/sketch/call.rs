//! Blocks as they are written: `[TON]( T1, T#5s )`, `[ADD]( y, a, b )`, `[$Motor]( m1, start := a )`.

use super::blocks::{Class, is_enable, named_in_unit, operand_pins, result_output};
use super::body::Body;
use crate::expression::{Form, Operand};
use crate::graph::{End, Kind};
use crate::model::{Role, Type, UnitKind};
use crate::scope::local;
use crate::standard::{self, Function, Gate, StandardBlock};

impl Body<'_> {
    /// A block, and what is in the wire with it.
    pub(super) fn block_texts(&mut self, node: usize) -> Result<Vec<String>, String> {
        let Some(class) = self.class(node) else {
            return Ok(Vec::new());
        };
        let one = |text: String| Ok(vec![text]);
        match class {
            Class::Standard(StandardBlock::Rising) => one("[OSR]".to_owned()),
            Class::Standard(StandardBlock::Falling) => Ok(vec!["[NOT]".to_owned(), "[OSR]".to_owned()]),
            Class::Standard(StandardBlock::Stateful(mnemonic, _, pins)) => {
                one(self.state_text(node, mnemonic, pins)?)
            }
            Class::Unit(kind) => one(self.unit_text(node, kind)?),
            Class::Value(mnemonic) => {
                let result = self.result(node)?;
                let operands = self.values(node)?;
                if operands.is_empty() {
                    return Err("nothing is wired to its inputs".to_owned());
                }
                let has = |form: Form| {
                    let mut given = operand_pins(self, node).into_iter();
                    given.any(|pin| {
                        self.operands
                            .get(&(node, pin))
                            .is_some_and(|operand| operand.form == form)
                    })
                };
                let mnemonic = match mnemonic {
                    _ if has(Form::Expression) => "CALC",
                    _ if has(Form::Milliseconds) => "TYP",
                    mnemonic => mnemonic,
                };
                one(format!("[{}]( {result}, {} )", mnemonic, operands.join(", ")))
            }
            Class::Convert => {
                let result = self.result(node)?;
                one(format!("[TYP]( {result}, {} )", self.values(node)?.join(", ")))
            }
            Class::Logic(function) => {
                let result = self.result(node)?;
                let operands = self.values(node)?;
                one(format!("[CALC]( {result}, {} )", formula(function, &operands)?))
            }
            Class::Unknown => one(self.unread_text(node)),
            Class::Gate(_) | Class::Compare(_) => Err("it has no counterpart".to_owned()),
        }
    }

    /// A comparison in a wire.
    pub(super) fn condition_text(&self, node: usize, class: Class) -> Result<String, String> {
        let Class::Compare(mnemonic) = class else {
            return Err("it has no counterpart".to_owned());
        };
        let values = self.values(node)?;
        if values.len() < 2 {
            return Err("a comparison has two inputs".to_owned());
        }
        Ok(format!("[{mnemonic}]( {} )", values.join(", ")))
    }

    /// The operands at the pins that something is wired to.
    fn values(&self, node: usize) -> Result<Vec<String>, String> {
        let pins = operand_pins(self, node).into_iter();
        let pins = pins.filter(|pin| !self.graph.nodes[node].inputs[*pin].from.is_empty());
        pins.map(|pin| {
            let operand = self.operands.get(&(node, pin));
            let operand = operand.ok_or_else(|| "one of its inputs is not known".to_owned())?;
            Ok(operand.text.clone())
        })
        .collect()
    }

    fn result(&self, node: usize) -> Result<String, String> {
        let output = result_output(&self.graph.nodes[node]).ok_or("it has no output")?;
        let tag = self.results.get(&End { node, output });
        tag.cloned().ok_or_else(|| "nothing takes its result".to_owned())
    }

    fn instance(&self, node: usize) -> Result<String, String> {
        let instance = self.instances.get(&node);
        Ok(instance.ok_or("it has no name")?.text.clone())
    }

    /// A timer, a counter or a bistable.
    fn state_text(
        &mut self,
        node: usize,
        mnemonic: &str,
        pins: &[(&str, Option<&str>)],
    ) -> Result<String, String> {
        let mut operands = vec![self.instance(node)?];
        for (pin, name) in pins {
            let inputs = self.graph.nodes[node].inputs.iter();
            let index = inputs
                .clone()
                .position(|input| standard::is_pin(&input.name, pin));
            let operand = index.and_then(|index| self.operands.get(&(node, index)));
            match (operand, name) {
                (Some(operand), Some(name)) => operands.push(format!("{name} := {}", operand.text)),
                (Some(operand), None) => operands.push(operand.text.clone()),
                (None, Some(_)) => {}
                (None, None) => {
                    self.note(node, "nothing is wired to its limit: it is nothing here");
                    operands.push(if *pin == "PT" { "T#0s" } else { "0" }.to_owned());
                }
            }
        }
        Ok(format!("[{mnemonic}]( {} )", operands.join(", ")))
    }

    /// A unit of the project.
    fn unit_text(&mut self, node: usize, kind: UnitKind) -> Result<String, String> {
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
            operands.push(self.instance(node)?);
        }
        for (index, pin) in self.graph.nodes[node].inputs.iter().enumerate() {
            if is_enable(&pin.name) || named_in_unit(self, node, &pin.name) == Some("EN") {
                continue;
            }
            let Some(operand) = self.operands.get(&(node, index)) else {
                continue;
            };
            let known = block
                .scope
                .get(&pin.name)
                .ok_or_else(|| format!("`{name}` has no input `{}`", pin.name))?;
            operands.push(format!("{} := {}", known.spelled, operand.text));
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
                let Some(tag) = self.results.get(&End { node, output }) else {
                    continue;
                };
                // The result is called OUT, or as the function, or not at all.
                let known = block.scope.get(&pin.name).filter(|_| !pin.name.is_empty());
                let known = known.or_else(|| block.scope.get(name).filter(|_| first == Some(output)));
                let known = known.ok_or_else(|| format!("`{name}` has no output `{}`", pin.name))?;
                operands.push(format!("{} => {tag}", known.spelled));
            }
        }
        if operands.is_empty() {
            return Ok(format!("[{}]( )", block.name));
        }
        Ok(format!("[{}]( {} )", block.name, operands.join(", ")))
    }

    /// A value that a variable takes.
    pub(super) fn moved(&mut self, node: usize, tag: &Operand, value: &Operand) -> String {
        // The count of a counter is a DINT here, and an INT there.
        let is_count = value
            .text
            .rsplit_once('.')
            .is_some_and(|(_, member)| member == "CV");
        let fits = matches!(&tag.ty, Some(Type::Named(name)) if matches!(standard::elementary(name), Some("DINT" | "LINT")));
        let mnemonic = if is_count && !fits { "TYP" } else { "MOV" };
        if let Kind::Variable(_, true) = self.graph.nodes[node].kind {
            return format!("[NOT]( {}, {} )", tag.text, value.text);
        }
        format!("[{mnemonic}]( {}, {} )", tag.text, value.text)
    }

    /// The tag that holds the power after a block.
    pub(super) fn holder(&mut self, end: End) -> String {
        if let Some(tag) = self.holders.get(&end) {
            return tag.clone();
        }
        let tag = match (self.class(end.node), self.instances.get(&end.node)) {
            // The tag of the edge detector itself, which is declared where it is read.
            (Some(Class::Standard(_)), Some(instance)) => {
                self.made.needed.insert(instance.text.to_lowercase());
                instance.text.clone()
            }
            _ => self.helper("power", "BOOL", "the power after a block"),
        };
        self.holders.insert(end, tag.clone());
        tag
    }

    /// Whether an edge detector is read by its name.
    pub(super) fn is_read_by_name(&self, node: usize) -> bool {
        let is_trigger = matches!(
            self.class(node),
            Some(Class::Standard(StandardBlock::Rising | StandardBlock::Falling))
        );
        let instance = self.instances.get(&node).filter(|_| is_trigger);
        instance.is_some_and(|instance| self.made.needed.contains(&instance.text.to_lowercase()))
    }
}

/// A comparison or a gate as a formula.
fn formula(function: Function, operands: &[String]) -> Result<String, String> {
    let enough = |count: usize| {
        let why = || format!("it has {count} inputs or more");
        (operands.len() >= count).then_some(()).ok_or_else(why)
    };
    Ok(match function {
        Function::Gate(Gate::Not) => {
            enough(1)?;
            format!("NOT {}", operands[0])
        }
        Function::Gate(gate) => {
            enough(1)?;
            let word = [" AND ", " OR ", " XOR "][(gate as usize).min(2)];
            operands.join(word)
        }
        Function::Compare(_, sign) => {
            enough(2)?;
            let pairs: Vec<String> = operands
                .windows(2)
                .map(|pair| format!("({} {sign} {})", pair[0], pair[1]))
                .collect();
            match &pairs[..] {
                [one] => one.trim_matches(['(', ')']).to_owned(),
                pairs => pairs.join(" AND "),
            }
        }
        _ => return Err("it has no counterpart".to_owned()),
    })
}
