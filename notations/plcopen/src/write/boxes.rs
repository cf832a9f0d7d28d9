//! Functions, function blocks and blocks of one's own as boxes with pins.

use super::compiler::Compiler;
use super::declare::{named, scalar, state_name};
use super::element::{FAULT, Power, Writer};
use super::rung::{Rung, modifier, pin};
use super::text::{OF_BITS, OF_REALS};
use super::touched::Touched;
use crate::along;
use crate::graph::{Edge, End, Pin};
use crate::own;
use crate::standard::Pins;
use ladder_analysis::program::ParameterKind::{InOut, Input, Output};
use ladder_analysis::program::{Argument, Bound, Expr, ExprKind};
use ladder_analysis::values::types::{Scalar, Type, common};
use ladder_instructions::{Instruction, Op};

/// A function of the standard, by its name, with its inputs.
type Function = (&'static str, Pins);

impl Writer<'_> {
    /// The inputs of a function, from this operand on.
    fn inputs_as(
        &self,
        rung: &mut Rung<'_>,
        (function, pins): Function,
        from: usize,
        ty: Option<Scalar>,
    ) -> Result<Vec<Pin>, String> {
        let given = &self.block.arguments[from.min(self.block.arguments.len())..];
        let names = pins.names(given.len());
        let names = names.ok_or_else(|| format!("{function} has another number of inputs there"))?;
        let mut inputs = Vec::new();
        for (bound, name) in given.iter().zip(names) {
            let text = self.text(rung, bound)?;
            let text = match (&bound.argument, ty) {
                (Argument::Value(value), Some(ty))
                    if value.ty.name() != ty.name() && !matches!(value.kind, ExprKind::Constant(_)) =>
                {
                    format!("{}_TO_{}({text})", value.ty.name(), ty.name())
                }
                _ => text,
            };
            inputs.push(pin(&name, rung.value(text)));
        }
        Ok(inputs)
    }

    /// The inputs of a comparison, all of one type: compilers convert none.
    pub(super) fn compared(&self, rung: &mut Rung<'_>, function: Function) -> Result<Vec<Pin>, String> {
        let value = |bound: &Bound| match &bound.argument {
            Argument::Value(value) => Some((value.ty, matches!(value.kind, ExprKind::Constant(_)))),
            _ => None,
        };
        let known: Vec<(Scalar, bool)> = self.block.arguments.iter().filter_map(value).collect();
        let mut others = known
            .iter()
            .filter(|(_, is_constant)| !is_constant)
            .map(|(ty, _)| *ty);
        let Some(first) = others.next() else {
            return self.inputs_as(rung, function, 0, None);
        };
        let meet = others.try_fold(first, common);
        let meet = meet.ok_or("numbers of such types are not compared there: convert one")?;
        if known
            .iter()
            .all(|(ty, is_constant)| *is_constant || ty.name() == meet.name())
        {
            return self.inputs_as(rung, function, 0, None);
        }
        self.inputs_as(rung, function, 0, Some(meet))
    }

    /// A function with EN and ENO, and the variable that takes its result.
    pub(super) fn function(&self, rung: &mut Rung<'_>, op: Op, function: Function, power: Vec<End>) -> Power {
        if matches!(
            op,
            Op::Div | Op::Mod | Op::Exp | Op::Mux | Op::Sqrt | Op::Ln | Op::Log | Op::Asin | Op::Acos
        ) {
            self.remark(rung, FAULT);
        }
        self.is_taken(op)?;
        // NOT is an operator for that compiler, and no function.
        if op == Op::Not
            && self.is_strict()
            && let Some(ty) = self.result_type()
        {
            let mask = match ty {
                Scalar::Bool => "TRUE".to_owned(),
                ty => (u64::MAX >> (64 - ty.width().clamp(8, 64))).to_string(),
            };
            let mut inputs = self.inputs_as(rung, function, 1, None)?;
            "IN1".clone_into(&mut inputs[0].name);
            inputs.push(pin("IN2", rung.value(mask)));
            return self.call(rung, "XOR", inputs, power);
        }
        let (of_time, is_time) = self.of_time(op);
        let name = match op {
            _ if !self.is_strict() => function.0,
            Op::Add if is_time => "ADD_TIME",
            Op::Sub if is_time => "SUB_TIME",
            Op::Mul if of_time => "MULTIME",
            Op::Div if of_time => "DIVTIME",
            _ => function.0,
        };
        if let Op::Sub | Op::Div = op
            && self.block.arguments.len() > 3
        {
            return self.formula(rung, op, power);
        }
        let inputs = self.inputs_as(rung, function, 1, None)?;
        match self.result_type() {
            Some(ty) if ty.is_enumeration() && self.is_strict() => {
                self.call(rung, &along::move_name(&type_name(ty)), inputs, power)
            }
            _ => self.call(rung, name, inputs, power),
        }
    }

    /// Whether the compiler has functions for some types alone, and converts nothing.
    fn is_strict(&self) -> bool {
        self.unit.compiler == Compiler::Matiec
    }

    fn result_type(&self) -> Option<Scalar> {
        match self.block.arguments.first()?.argument {
            Argument::Place(_, ty) => Some(ty),
            _ => None,
        }
    }

    /// Whether a function takes values of the type that its result has.
    ///
    /// # Errors
    ///
    /// Why not.
    fn is_taken(&self, op: Op) -> Result<(), String> {
        let Some(ty) = self.result_type() else {
            return Err("whole arrays and structures are not written there: copy what is in them".to_owned());
        };
        let is_of_bits = matches!(
            op,
            Op::And | Op::Or | Op::Xor | Op::Not | Op::Shl | Op::Shr | Op::Rol | Op::Ror
        );
        match ty {
            ty if is_of_bits && ty.is_integer() => Err(OF_BITS.to_owned()),
            ty if op == Op::Exp && ty.is_integer() => Err(OF_REALS.to_owned()),
            ty if ty.is_enumeration() && op != Op::Mov => {
                Err("compilers have no such function for values of an enumeration: use MOV".to_owned())
            }
            _ => Ok(()),
        }
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

    fn call(&self, rung: &mut Rung<'_>, name: &str, mut inputs: Vec<Pin>, power: Vec<End>) -> Power {
        let result = self.first_text(rung)?;
        inputs.insert(0, pin("EN", power));
        let end = rung.block((name, None), inputs, &["ENO", "OUT"], self.touched(), true);
        let mut out = End { output: 1, ..end };
        // What compilers have as INT whatever takes it.
        if let ("LEN" | "FIND", Some(ty)) = (name, self.result_type())
            && ty != Scalar::Int
        {
            match ty {
                _ if self.is_strict() => {}
                // It converts to what holds every INT.
                Scalar::Dint | Scalar::Lint | Scalar::Real | Scalar::Lreal => {
                    rung.variable(result, out, self.touched());
                    return Ok(vec![end]);
                }
                _ => {
                    return Err(format!(
                        "{name} makes an INT there: take it into an INT or a DINT"
                    ));
                }
            }
            let inputs = vec![pin("EN", vec![end]), pin("IN", vec![out])];
            let conversion = format!("INT_TO_{}", ty.name());
            let touched = Touched::default();
            out.node = rung
                .block((&conversion, None), inputs, &["ENO", "OUT"], touched, false)
                .node;
        }
        // Generators find the type of a result by a variable that takes it, and no type in elements of arrays.
        if self.is_strict()
            && result.contains('[')
            && let Some(ty) = self.result_type()
        {
            let unused = rung.made("unused", scalar(ty), own::SINK);
            rung.variable(unused, out, Touched::default());
        }
        rung.variable(result, out, self.touched());
        Ok(vec![end])
    }

    /// An expression that a variable takes.
    pub(super) fn formula(&self, rung: &mut Rung<'_>, op: Op, power: Vec<End>) -> Power {
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
                if from == Scalar::Time && (to.is_integer() || to.is_real()) {
                    let name = match to {
                        Scalar::Lreal => "MOVE".to_owned(),
                        to => format!("LREAL_TO_{}", to.name()),
                    };
                    let value = rung.value(own::milliseconds(text));
                    return self.call(rung, &name, vec![pin("IN", value)], power);
                }
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
    pub(super) fn state(&self, rung: &mut Rung<'_>, row: &Instruction, mut power: Vec<End>) -> Power {
        let state = row.state().ok_or("it has no state")?;
        let name = state_name(state);
        let instance = self.first_text(rung)?;
        if self.operand("B").is_some() {
            return Err("a timer there has no time base".to_owned());
        }
        let (first, pins, outputs): (&str, &[&str], &[&str]) = match row.op {
            Op::Ton | Op::Tof | Op::Tp => ("IN", &["PT"], &["Q", "ET"]),
            Op::Rto | Op::Rtof => ("IN", &["PT", "R"], &["Q", "ET"]),
            Op::Ctu | Op::Ctc => ("CU", &["R", "PV"], &["Q", "CV"]),
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
    pub(super) fn user(&self, rung: &mut Rung<'_>, user: usize, power: Vec<End>) -> Power {
        let known = &self.unit.program.blocks[user];
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
                named(&*face.name),
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
            if parameter.is_shared {
                if bound.is_none_or(|bound| self.text(rung, bound).as_ref() != Ok(&parameter.name)) {
                    return Err(format!(
                        "`{}` of a function has another name where it is called",
                        parameter.name
                    ));
                }
                continue;
            }
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
                // Compilers convert nothing on its way.
                let conversion = match (
                    self.unit.program.tags[known.parameters[number].0.0 as usize].ty,
                    &bound.argument,
                ) {
                    (Type::Scalar(from), Argument::Place(_, to)) if from.name() != to.name() => {
                        Some(format!("{}_TO_{}", from.name(), to.name()))
                    }
                    _ => None,
                };
                taken.push((outputs.len() - 1, self.text(rung, bound)?, conversion));
            }
        }
        let touched = self.touched().anything();
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        let end = rung.block(
            (&face.name, Some(instance.clone())),
            inputs,
            &outputs,
            touched,
            true,
        );
        for (output, text, conversion) in taken {
            let mut from = End { output, ..end };
            if let Some(name) = conversion {
                let output = outputs[output];
                let value = match self.unit.compiler {
                    Compiler::Matiec => vec![from],
                    // Of a box there one output goes on.
                    Compiler::TwinCat => rung.value(format!("{instance}.{output}")),
                };
                let inputs = vec![pin("IN", value)];
                from = rung.block((&name, None), inputs, &["OUT"], Touched::default(), false);
            }
            rung.variable(text, from, self.touched());
        }
        if rung.is_asked() {
            rung.ask(end);
        }
        Ok(vec![end])
    }
}

/// A type by its name.
fn type_name(ty: Scalar) -> String {
    match ty {
        Scalar::Enum(id) => super::names::identifier(&id.get().name),
        other => other.name().to_owned(),
    }
}

/// A function block, and what asks for it.
pub(super) fn function_block(
    rung: &mut Rung<'_>,
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
