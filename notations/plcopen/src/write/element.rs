//! Blocks on a rung as elements of a drawing.

use super::declare::state_name;
use super::functions::{self, Function};
use super::rung::{Rung, modifier, pin};
use super::text::Words;
use super::touched::Touched;
use super::unit::{Faces, Unit};
use crate::graph::{Edge, End, Kind, Modifier, Pin, Storage};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::facts::{Node, NodeKind};
use ladder_analysis::program::ParameterKind::{InOut, Input, Output};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, Expr, Program};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Instruction, Op};

/// What is a fault in ladder text.
const FAULT: &str = "what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it";

/// What the generators of Beremiz and OpenPLC leave out.
const JUMP: &str = "the generators of Beremiz and OpenPLC Editor up to 3 pass over jumps, labels and returns, and say nothing";

/// A block with what it is written from.
pub(super) struct Writer<'w> {
    pub(super) unit: &'w Unit<'w>,
    pub(super) program: &'w Program,
    pub(super) faces: &'w Faces,
    pub(super) block: &'w Block,
    pub(super) facts: BlockAt<'w>,
}

type Power = Result<Vec<End>, String>;

impl Writer<'_> {
    /// Puts the block onto a rung; comes back the power that leaves it.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn write(&self, rung: &mut Rung, power: Vec<End>) -> Power {
        match self.block.kind {
            BlockKind::Instruction(row) => self.instruction(rung, row, power),
            BlockKind::User(user) => self.user(rung, user, power),
        }
    }

    fn words<'r>(&'r self, rung: &'r Rung) -> Words<'r> {
        Words {
            text: self.unit.text,
            base: self.facts.base,
            names: &rung.names,
        }
    }

    fn touched(&self) -> Touched {
        Touched::of(self.block)
    }

    /// An operand as it is written.
    fn node(&self, bound: &Bound) -> Result<&Node, String> {
        let mut operands = self.facts.facts.operands.iter();
        let found = operands.find(|operand| self.facts.absolute(operand.range).contains_range(bound.range));
        found
            .map(|operand| &operand.value)
            .ok_or_else(|| "an operand of it has no counterpart".to_owned())
    }

    fn operand(&self, name: &str) -> Option<&Bound> {
        let mut all = self.block.arguments.iter();
        all.find(|bound| bound.operand.is_some_and(|operand| operand.name == name))
    }

    /// An operand in ST.
    fn text(&self, rung: &Rung, bound: &Bound) -> Result<String, String> {
        let node = self.node(bound)?;
        let words = self.words(rung);
        match &bound.argument {
            Argument::Value(value) => words.value(value, node),
            Argument::Place(place, _) => words.place(place, node),
            Argument::State(_) | Argument::ChosenState(_) | Argument::Parts(_) => words.node(node),
            // A whole array that a block is handed.
            Argument::Range(_) if !matches!(node.kind, NodeKind::Range(..)) && bound.parameter.is_some() => {
                words.node(node)
            }
            Argument::Range(_) => Err("ranges of arrays have no counterpart".to_owned()),
            _ => Err("an operand of it has no counterpart".to_owned()),
        }
    }

    fn first_text(&self, rung: &Rung) -> Result<String, String> {
        let bound = self.block.arguments.first();
        self.text(rung, bound.ok_or("it has no operand")?)
    }

    fn shown(&self) -> String {
        self.unit.text[self.facts.range()].to_owned()
    }

    fn remark(&self, rung: &mut Rung, why: &str) {
        rung.remarks.push((self.shown(), why.to_owned()));
    }

    fn instruction(&self, rung: &mut Rung, row: &Instruction, power: Vec<End>) -> Power {
        let none = Modifier::default();
        let unknown = || Err(format!("the standard has no {}", row.block()));
        let touched = self.touched();
        Ok(match row.op {
            Op::Contact | Op::NegatedContact | Op::RisingContact => {
                let tag = self.first_text(rung)?;
                let modifier = match row.op {
                    Op::NegatedContact => modifier(true, Edge::None),
                    Op::RisingContact => modifier(false, Edge::Rising),
                    _ => none,
                };
                vec![rung.contact(&tag, modifier, power, touched)]
            }
            Op::FallingContact => {
                let tag = self.first_text(rung)?;
                let rail = vec![rung.rail()];
                let low = |rung: &mut Rung, from| {
                    vec![rung.contact(&tag, modifier(true, Edge::None), from, touched.clone())]
                };
                let high = |rung: &mut Rung| vec![rung.contact(&tag, none, rail.clone(), touched.clone())];
                let fell = fell(rung, low, high);
                vec![rung.contact(&fell, none, power, Touched::default())]
            }
            Op::Inverter => vec![invert(rung, power)],
            Op::OneShotRising => {
                let instance = rung.made("trigger", "R_TRIG", "finds an edge");
                function_block(
                    rung,
                    ("R_TRIG", instance),
                    vec![pin("CLK", power)],
                    &["Q"],
                    touched,
                )
            }
            Op::OneShotFalling => {
                let rail = rung.rail();
                let fell = fell_power(rung, power);
                vec![rung.contact(&fell, none, vec![rail], Touched::default())]
            }
            Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le => {
                let function = functions::of(row.op).ok_or("it has no counterpart")?;
                let inputs = self.inputs(rung, &function, 0)?;
                let result = rung.block((function.name, None), inputs, &["OUT"], touched, false);
                if rung.is_rail(&power) {
                    vec![result]
                } else {
                    let inputs = vec![pin("IN1", power), pin("IN2", vec![result])];
                    vec![rung.block(("AND", None), inputs, &["OUT"], Touched::default(), false)]
                }
            }
            Op::Ton | Op::Tof | Op::Tp | Op::Ctu | Op::Ctd | Op::Ctud | Op::Sr | Op::Rs => {
                self.state(rung, row, power)?
            }
            Op::Coil | Op::RetentiveCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, none, Storage::None, power, touched)]
            }
            Op::NegatedCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, modifier(true, Edge::None), Storage::None, power, touched)]
            }
            Op::RisingCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, modifier(false, Edge::Rising), Storage::None, power, touched)]
            }
            Op::FallingCoil => {
                let tag = self.coil_tag(rung, row)?;
                let rail = rung.rail();
                let fell = fell_power(rung, power.clone());
                let from = vec![rung.contact(&fell, none, vec![rail], Touched::default())];
                rung.coil(&tag, none, Storage::None, from, touched);
                power
            }
            Op::SetCoil | Op::RetentiveSet => {
                let tag = self.coil_tag(rung, row)?;
                rung.coil(&tag, none, Storage::Set, power, touched.clone());
                if rung.is_needed() {
                    let rail = vec![rung.rail()];
                    vec![rung.contact(&tag, none, rail, touched)]
                } else {
                    Vec::new()
                }
            }
            Op::ResetCoil | Op::RetentiveReset => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, none, Storage::Reset, power, touched)]
            }
            Op::Lbl => {
                let label = self.label()?;
                rung.push(Kind::Label(label), Vec::new(), Touched::default(), false);
                self.remark(rung, JUMP);
                power
            }
            Op::Jmp => {
                let label = self.label()?;
                self.remark(rung, JUMP);
                rung.push(Kind::Jump(label, false), vec![pin("", power)], touched, true);
                Vec::new()
            }
            Op::Ret => {
                self.remark(rung, JUMP);
                rung.push(Kind::Return(false), vec![pin("", power)], touched, true);
                Vec::new()
            }
            _ => match functions::of(row.op) {
                Some(function) => self.function(rung, row.op, &function, power)?,
                None if matches!(row.op, Op::Calc | Op::Neg | Op::Typ) => {
                    self.formula(rung, row.op, power)?
                }
                None => return unknown(),
            },
        })
    }

    fn label(&self) -> Result<String, String> {
        let operand = self.facts.facts.operands.first().ok_or("it has no label")?;
        let text = &self.unit.text[self.facts.absolute(operand.value.range)];
        Ok(super::names::identifier(text))
    }

    /// The tag of a coil, which some make retentive.
    fn coil_tag(&self, rung: &mut Rung, row: &Instruction) -> Result<String, String> {
        if let Some(Bound {
            argument: Argument::State(_) | Argument::ChosenState(_),
            ..
        }) = self.block.arguments.first()
        {
            return Err("timers and counters have no reset coil there".to_owned());
        }
        let tag = self.first_text(rung)?;
        if matches!(row.op, Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset) {
            let root = tag.split(['.', '[']).next().unwrap_or_default();
            rung.retentive.push(root.to_owned());
        }
        Ok(tag)
    }

    /// The inputs of a function, from this operand on.
    fn inputs(&self, rung: &mut Rung, function: &Function, from: usize) -> Result<Vec<Pin>, String> {
        let given = &self.block.arguments[from.min(self.block.arguments.len())..];
        let names = function.pins.names(given.len());
        let names = names.ok_or_else(|| format!("{} has another number of inputs there", function.name))?;
        let mut inputs = Vec::new();
        for (bound, name) in given.iter().zip(names) {
            let text = self.text(rung, bound)?;
            inputs.push(pin(&name, rung.value(text)));
        }
        Ok(inputs)
    }

    /// A function with EN and ENO, and the variable that takes its result.
    fn function(&self, rung: &mut Rung, op: Op, function: &Function, power: Vec<End>) -> Power {
        if matches!(
            op,
            Op::Div | Op::Mod | Op::Exp | Op::Mux | Op::Sqrt | Op::Ln | Op::Log | Op::Asin | Op::Acos
        ) {
            self.remark(rung, FAULT);
        }
        let (of_time, is_time) = self.of_time(op);
        let name = match op {
            Op::Add if is_time => "ADD_TIME",
            Op::Sub if is_time => "SUB_TIME",
            Op::Mul if of_time => "MULTIME",
            Op::Div if of_time => "DIVTIME",
            _ => function.name,
        };
        if let Op::Sub | Op::Div = op
            && self.block.arguments.len() > 3
        {
            return self.formula(rung, op, power);
        }
        let inputs = self.inputs(rung, function, 1)?;
        self.call(rung, name, inputs, power)
    }

    /// Whether the first of two operands is a TIME, and whether both are.
    fn of_time(&self, op: Op) -> (bool, bool) {
        if !matches!(op, Op::Add | Op::Sub | Op::Mul | Op::Div) || self.block.arguments.len() != 3 {
            return (false, false);
        }
        let is_time =
            |bound: &Bound| matches!(&bound.argument, Argument::Value(Expr { ty: Scalar::Time, .. }));
        let first = is_time(&self.block.arguments[1]);
        (first, first && is_time(&self.block.arguments[2]))
    }

    fn call(&self, rung: &mut Rung, name: &str, mut inputs: Vec<Pin>, power: Vec<End>) -> Power {
        let result = self.first_text(rung)?;
        inputs.insert(0, pin("EN", power));
        let end = rung.block((name, None), inputs, &["ENO", "OUT"], self.touched(), true);
        rung.variable(result, End { output: 1, ..end }, self.touched());
        Ok(vec![end])
    }

    /// An expression that a variable takes.
    fn formula(&self, rung: &mut Rung, op: Op, power: Vec<End>) -> Power {
        let mut texts = Vec::new();
        for bound in &self.block.arguments[1..] {
            texts.push((self.text(rung, bound)?, bound));
        }
        let single = |text: &str| !text.contains(' ');
        let part = |text: &str| {
            if single(text) {
                text.to_owned()
            } else {
                format!("({text})")
            }
        };
        let joined = |sign: &str| {
            let parts: Vec<String> = texts.iter().map(|(text, _)| part(text)).collect();
            parts.join(sign)
        };
        let (text, name) = match (op, &texts[..]) {
            (Op::Neg, [(text, _)]) => (format!("-{}", part(text)), "MOVE".to_owned()),
            (Op::Sub, _) => (joined(" - "), "MOVE".to_owned()),
            (Op::Div, _) => (joined(" / "), "MOVE".to_owned()),
            (Op::Typ, [(text, bound)]) => {
                self.remark(rung, FAULT);
                let from = match &bound.argument {
                    Argument::Value(value) => value.ty,
                    _ => return Err("such a conversion has no counterpart".to_owned()),
                };
                let Some(Argument::Place(_, to)) = self.block.arguments.first().map(|bound| &bound.argument)
                else {
                    return Err("such a conversion has no counterpart".to_owned());
                };
                let is_plain = |ty: Scalar| {
                    !matches!(
                        ty,
                        Scalar::Enum(_) | Scalar::Time | Scalar::Date | Scalar::Tod | Scalar::Dt
                    )
                };
                if !is_plain(from) || !is_plain(*to) {
                    return Err("times, dates and names are converted otherwise there".to_owned());
                }
                if from.name() == to.name() {
                    (text.clone(), "MOVE".to_owned())
                } else {
                    (text.clone(), format!("{}_TO_{}", from.name(), to.name()))
                }
            }
            (_, [(text, _)]) => {
                if text.contains(" / ") || text.contains("MOD") || text.contains("**") {
                    self.remark(rung, FAULT);
                }
                (text.clone(), "MOVE".to_owned())
            }
            _ => return Err("such an expression has no counterpart".to_owned()),
        };
        let value = rung.value(text);
        self.call(rung, &name, vec![pin("IN", value)], power)
    }

    /// A timer, counter or bistable.
    fn state(&self, rung: &mut Rung, row: &Instruction, mut power: Vec<End>) -> Power {
        let state = row.state().ok_or("it has no state")?;
        let name = state_name(state)?;
        let instance = self.first_text(rung)?;
        if self.operand("B").is_some() {
            return Err("a timer there has no time base".to_owned());
        }
        let (first, pins, outputs): (&str, &[&str], &[&str]) = match row.op {
            Op::Ton | Op::Tof | Op::Tp => ("IN", &["PT"], &["Q", "ET"]),
            Op::Ctu => ("CU", &["R", "PV"], &["Q", "CV"]),
            Op::Ctd => ("CD", &["LD", "PV"], &["Q", "CV"]),
            Op::Ctud => ("CU", &["CD", "R", "LD", "PV"], &["QU", "QD", "CV"]),
            Op::Sr => ("S1", &["R"], &["Q1"]),
            _ => ("S", &["R1"], &["Q1"]),
        };
        let is_pin = |name: &str| pins.contains(&name) || (row.op == Op::Rs && name == "R");
        for bound in &self.block.arguments[1..] {
            let given = bound.operand.map_or("", |operand| operand.name);
            if row.op == Op::Ton && given == "R" {
                // What is reset is as without power.
                let touched = Touched::of(self.block);
                let reset = self.text(rung, bound)?;
                power = vec![rung.contact(&reset, modifier(true, Edge::None), power, touched)];
            } else if !is_pin(given) {
                return Err(format!("{name} has no `{given}` there"));
            }
        }
        let mut inputs = vec![pin(first, power)];
        for name in pins {
            let own = if *name == "R1" { "R" } else { name };
            let from = match self.operand(own) {
                Some(bound) => {
                    let text = self.text(rung, bound)?;
                    rung.value(text)
                }
                None => Vec::new(),
            };
            inputs.push(pin(name, from));
        }
        Ok(function_block(
            rung,
            (name, instance),
            inputs,
            outputs,
            self.touched(),
        ))
    }

    /// A block of one's own.
    fn user(&self, rung: &mut Rung, user: usize, power: Vec<End>) -> Power {
        let known = &self.program.blocks[user];
        let face = self.faces.get(&known.name).ok_or("its block is not written")?;
        if let Some(why) = &face.broken {
            return Err(why.clone());
        }
        let instance = match self.facts.formals.first() {
            Some(ladder_analysis::networks::network::Formal::Instance) => {
                let operand = self.facts.facts.operands.first().ok_or("it has no instance")?;
                self.words(rung).node(&operand.value)?
            }
            _ => rung.made(
                known.name.trim_start_matches('$'),
                &face.name,
                "the state of a block",
            ),
        };
        let mut inputs = vec![pin(&face.power_in, power)];
        let mut outputs = vec![face.power_out.clone()];
        let mut taken = Vec::new();
        for (number, parameter) in face.parameters.iter().enumerate() {
            let bound = self
                .block
                .arguments
                .iter()
                .find(|bound| bound.parameter == Some(number));
            if matches!(parameter.kind, Input | InOut) {
                let from = match bound {
                    Some(bound) => {
                        let text = self.text(rung, bound)?;
                        rung.value(text)
                    }
                    None => Vec::new(),
                };
                inputs.push(Pin {
                    in_out: parameter.kind == InOut,
                    ..pin(&parameter.name, from)
                });
            }
            if matches!(parameter.kind, Output | InOut) {
                outputs.push(parameter.name.clone());
            }
            if let (Output, Some(bound)) = (parameter.kind, bound) {
                taken.push((outputs.len() - 1, self.text(rung, bound)?));
            }
        }
        let touched = self.touched().anything();
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        let end = rung.block((&face.name, Some(instance)), inputs, &outputs, touched, true);
        for (output, text) in taken {
            rung.variable(text, End { output, ..end }, self.touched());
        }
        if rung.is_asked() {
            rung.ask(end);
        }
        Ok(vec![end])
    }
}

/// A function block, and what asks for it.
fn function_block(
    rung: &mut Rung,
    (name, instance): (&str, String),
    inputs: Vec<Pin>,
    outputs: &[&str],
    touched: Touched,
) -> Vec<End> {
    let end = rung.block((name, Some(instance)), inputs, outputs, touched, true);
    if rung.is_asked() {
        rung.ask(end);
    }
    vec![end]
}

/// The power that is not there.
fn invert(rung: &mut Rung, power: Vec<End>) -> End {
    rung.block(
        ("NOT", None),
        vec![pin("IN", power)],
        &["OUT"],
        Touched::default(),
        false,
    )
}

/// A tag that is high in the scan in which power fell. The function block of the standard reports a fall in the first scan,
/// the instruction does not.
fn fell_power(rung: &mut Rung, power: Vec<End>) -> String {
    let again = power.clone();
    fell(
        rung,
        move |rung, from| {
            let not = invert(rung, power.clone());
            let inputs = vec![pin("IN1", from), pin("IN2", vec![not])];
            vec![rung.block(("AND", None), inputs, &["OUT"], Touched::default(), false)]
        },
        move |_| again.clone(),
    )
}

/// A tag that is high in the scan in which something fell: `low` passes power on while it is low, `high` is it.
fn fell(
    rung: &mut Rung,
    low: impl FnOnce(&mut Rung, Vec<End>) -> Vec<End>,
    high: impl FnOnce(&mut Rung) -> Vec<End>,
) -> String {
    let none = Modifier::default();
    let was = rung.made("was", "BOOL", "what it was at the last evaluation");
    let fell = rung.made("fell", "BOOL", "it fell");
    let rail = vec![rung.rail()];
    let from = vec![rung.contact(&was, none, rail, Touched::default())];
    let from = low(rung, from);
    rung.coil(&fell, none, Storage::None, from, Touched::default());
    let from = high(rung);
    rung.coil(&was, none, Storage::None, from, Touched::default());
    fell
}
