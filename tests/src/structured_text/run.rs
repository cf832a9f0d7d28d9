//! Scans.

use super::functions;
use super::memory::{Cell, CellId, Memory};
use super::parse::parse;
use super::standard;
use super::syntax::{Declared, Expr, Path, Statement, Step, Text};
use super::value::{Type, Value};
use std::collections::HashMap;
use std::rc::Rc;

type Result<T> = std::result::Result<T, String>;
type Frame = HashMap<String, CellId>;

/// A text that runs.
pub struct Machine {
    text: Rc<Text>,
    memory: Memory,
    globals: Frame,
    program: Frame,
    /// Nanoseconds since the first scan.
    now: i64,
    steps: u64,
}

/// How statements end.
#[derive(PartialEq)]
enum End {
    Through,
    Exit,
    Return,
}

/// More statements than this in a scan do not end.
const MOST_STEPS: u64 = 20_000_000;

impl Machine {
    /// Reads a text and starts it cold.
    ///
    /// # Errors
    /// The text is not in the subset that is read.
    pub fn new(source: &str) -> Result<Machine> {
        let text = Rc::new(parse(source)?);
        let mut memory = Memory::default();
        let mut globals = Frame::new();
        for variable in &text.globals {
            let cell = memory.make(&text, &variable.ty)?;
            if let Some(initial) = &variable.initial {
                memory.start(cell, initial)?;
            }
            globals.insert(variable.name.clone(), cell);
        }
        let name = text.program.clone();
        let cell = memory.make(&text, &super::syntax::Spec::Named(name))?;
        let Cell::Members(_, program) = memory.cells[cell].clone() else {
            return Err("no program".into());
        };
        let mut machine = Machine {
            text,
            memory,
            globals,
            program,
            now: 0,
            steps: 0,
        };
        let text = Rc::clone(&machine.text);
        let mut frame = machine.program.clone();
        machine.externals(&text.program, &mut frame)?;
        machine.program = frame;
        Ok(machine)
    }

    /// Adds what a unit uses of others.
    fn externals(&self, unit: &str, frame: &mut Frame) -> Result<()> {
        let Some(unit) = self.text.units.get(unit) else {
            return Ok(());
        };
        for variable in unit
            .variables
            .iter()
            .filter(|variable| variable.section == "VAR_EXTERNAL")
        {
            let cell = self.globals.get(&variable.name);
            frame.insert(
                variable.name.clone(),
                *cell.ok_or_else(|| format!("no global {}", variable.name))?,
            );
        }
        Ok(())
    }

    /// One scan at an instant.
    ///
    /// # Errors
    /// A statement does what systems do differently.
    pub fn scan(&mut self, now: i64) -> Result<()> {
        self.now = now;
        self.steps = 0;
        let text = Rc::clone(&self.text);
        let unit = text.units.get(&text.program).ok_or("no program")?;
        let frame = self.program.clone();
        self.statements(&unit.body, &frame).map(|_| ())
    }

    /// The variable or part of one with this path, in which the indices of an array of arrays may be one list.
    ///
    /// # Errors
    /// There is no such variable.
    pub fn find(&mut self, path: &str) -> Result<CellId> {
        let source = format!("PROGRAM P {path} := 0; END_PROGRAM");
        let text = parse(&source)?;
        let Some(Statement::Assign(path, _)) = text.units.get("P").and_then(|unit| unit.body.first()) else {
            return Err("no path".into());
        };
        let mut frame = self.globals.clone();
        frame.extend(self.program.clone());
        let mut cell = self.cell(
            &Path {
                name: path.name.clone(),
                steps: Vec::new(),
            },
            &frame,
        )?;
        for step in &path.steps {
            cell = match step {
                Step::Member(name) => self.memory.member(cell, name)?,
                Step::Index(all) => {
                    let indices = self.indices(all, &frame)?;
                    self.memory.inner_element(cell, &indices)?
                }
            };
        }
        Ok(cell)
    }

    /// What it holds.
    ///
    /// # Errors
    /// It is not an elementary variable.
    pub fn value(&self, cell: CellId) -> Result<Value> {
        self.memory.get(cell)
    }

    /// Writes it.
    ///
    /// # Errors
    /// The value does not fit.
    pub fn set(&mut self, cell: CellId, value: Value) -> Result<()> {
        self.memory.set(cell, value)
    }

    /// The type of an elementary variable.
    pub fn type_of(&self, cell: CellId) -> Option<&Type> {
        match &self.memory.cells[cell] {
            Cell::Scalar(ty, _) => Some(ty),
            _ => None,
        }
    }

    fn cell(&mut self, path: &Path, frame: &Frame) -> Result<CellId> {
        let mut cell = *frame
            .get(&path.name)
            .ok_or_else(|| format!("no variable {}", path.name))?;
        for step in &path.steps {
            cell = match step {
                Step::Member(name) => self.memory.member(cell, name)?,
                Step::Index(all) => {
                    let indices = self.indices(all, frame)?;
                    self.memory.element(cell, &indices)?
                }
            };
        }
        Ok(cell)
    }

    fn indices(&mut self, all: &[Expr], frame: &Frame) -> Result<Vec<i64>> {
        let mut indices = Vec::new();
        for index in all {
            match self.value_of(index, frame)? {
                Value::Int(number, _) => indices.push(number),
                other => return Err(format!("{other:?} is no index")),
            }
        }
        Ok(indices)
    }

    fn value_of(&mut self, expr: &Expr, frame: &Frame) -> Result<Value> {
        match expr {
            Expr::Literal(value) => Ok(value.clone()),
            Expr::Read(path) => {
                if path.steps.is_empty() && !frame.contains_key(&path.name) {
                    let is_value = |declared: &Declared| matches!(declared, Declared::Values(all) if all.contains(&path.name));
                    if self.text.types.values().any(is_value) {
                        return Ok(Value::Named(path.name.clone()));
                    }
                }
                let cell = self.cell(path, frame)?;
                self.memory.get(cell)
            }
            Expr::Unary(operator, a) => functions::unary(operator, self.value_of(a, frame)?),
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.value_of(a, frame)?, self.value_of(b, frame)?);
                functions::binary(operator, a, b)
            }
            Expr::Call(name, arguments) => {
                let mut values = Vec::new();
                for argument in arguments {
                    values.push(self.value_of(argument, frame)?);
                }
                let text = Rc::clone(&self.text);
                match text.units.get(name) {
                    Some(unit) => self.function(unit, values),
                    None => functions::call(name, values),
                }
            }
        }
    }

    fn function(&mut self, unit: &super::syntax::Unit, values: Vec<Value>) -> Result<Value> {
        let text = Rc::clone(&self.text);
        let kept = self.memory.cells.len();
        let mut frame = Frame::new();
        for variable in &unit.variables {
            let cell = self.memory.make(&text, &variable.ty)?;
            frame.insert(variable.name.clone(), cell);
        }
        let result = unit.result.as_ref().ok_or("a function without a result")?;
        let result = self.memory.make(&text, result)?;
        frame.insert(unit.name.clone(), result);
        let inputs = unit
            .variables
            .iter()
            .filter(|variable| variable.section == "VAR_INPUT");
        for (variable, value) in inputs.zip(values) {
            self.memory.set(frame[&variable.name], value)?;
        }
        self.statements(&unit.body, &frame)?;
        let value = self.memory.get(result)?;
        self.memory.cells.truncate(kept);
        Ok(value)
    }

    fn statements(&mut self, all: &[Statement], frame: &Frame) -> Result<End> {
        for statement in all {
            self.steps += 1;
            if self.steps > MOST_STEPS {
                return Err("a scan without an end".into());
            }
            match statement {
                Statement::Assign(path, value) => {
                    let cell = self.cell(path, frame)?;
                    if let Expr::Read(from) = value
                        && !matches!(self.memory.cells[cell], Cell::Scalar(..))
                    {
                        let from = self.cell(from, frame)?;
                        self.memory.copy(cell, from)?;
                        continue;
                    }
                    let value = self.value_of(value, frame)?;
                    self.memory
                        .set(cell, value)
                        .map_err(|why| format!("{path:?}: {why}"))?;
                }
                Statement::If(branches, other) => {
                    let mut chosen = other;
                    for (condition, body) in branches {
                        match self.value_of(condition, frame)? {
                            Value::Bool(true) => {
                                chosen = body;
                                break;
                            }
                            Value::Bool(false) => {}
                            other => return Err(format!("{other:?} is no condition")),
                        }
                    }
                    let end = self.statements(chosen, frame)?;
                    if end != End::Through {
                        return Ok(end);
                    }
                }
                Statement::For(path, from, to, body) => {
                    let cell = self.cell(path, frame)?;
                    let number = |value: Value| match value {
                        Value::Int(number, _) => Ok(number),
                        other => Err(format!("{other:?} is no number")),
                    };
                    let from = number(self.value_of(from, frame)?)?;
                    let to = number(self.value_of(to, frame)?)?;
                    for turn in from..=to {
                        self.memory.set(cell, Value::Int(turn, None))?;
                        match self.statements(body, frame)? {
                            End::Through => {}
                            End::Exit => break,
                            End::Return => return Ok(End::Return),
                        }
                    }
                }
                Statement::While(condition, body) => {
                    while self.value_of(condition, frame)? == Value::Bool(true) {
                        match self.statements(body, frame)? {
                            End::Through => {}
                            End::Exit => break,
                            End::Return => return Ok(End::Return),
                        }
                    }
                }
                Statement::Call(path, arguments) => self.call(path, arguments, frame)?,
                Statement::Return => return Ok(End::Return),
                Statement::Exit => return Ok(End::Exit),
            }
        }
        Ok(End::Through)
    }

    fn call(&mut self, path: &Path, arguments: &[(String, Expr)], frame: &Frame) -> Result<()> {
        let cell = self.cell(path, frame)?;
        let Cell::Members(Some(name), members) = self.memory.cells[cell].clone() else {
            return Err(format!("{path:?} is no block"));
        };
        let text = Rc::clone(&self.text);
        let mut own = members;
        let mut values = Vec::new();
        for (input, value) in arguments {
            let variable = text
                .units
                .get(&name)
                .and_then(|unit| unit.variables.iter().find(|variable| variable.name == *input));
            match (variable.map(|variable| variable.section.as_str()), value) {
                (Some("VAR_IN_OUT"), Expr::Read(given)) => {
                    let given = self.cell(given, frame)?;
                    own.insert(input.clone(), given);
                }
                (Some("VAR_INPUT") | None, Expr::Read(given))
                    if {
                        let given = self.cell(given, frame);
                        given.is_ok_and(|given| !matches!(self.memory.cells[given], Cell::Scalar(..)))
                    } =>
                {
                    let from = self.cell(given, frame)?;
                    let to = *own.get(input).ok_or_else(|| format!("no input {input}"))?;
                    self.memory.copy(to, from)?;
                }
                (Some("VAR_INPUT") | None, value) => {
                    let to = *own
                        .get(input)
                        .ok_or_else(|| format!("{name} has no input {input}"))?;
                    values.push((to, self.value_of(value, frame)?));
                }
                (other, _) => return Err(format!("{input} is {other:?}")),
            }
        }
        for (to, value) in values {
            self.memory
                .set(to, value)
                .map_err(|why| format!("{path:?}: {why}"))?;
        }
        match text.units.get(&name) {
            Some(unit) => {
                self.externals(&name, &mut own)?;
                self.statements(&unit.body, &own).map(|_| ())
            }
            None => standard::evaluate(&mut self.memory, cell, &name, self.now),
        }
    }
}
