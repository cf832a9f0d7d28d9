//! Variables: cells that hold values, elements, members or the state of a block.

use super::syntax::{Declared, Initial, Spec, Text};
use super::value::{Type, Value};
use std::collections::HashMap;

/// The number of a cell.
pub(super) type CellId = usize;

/// A variable or part of one.
#[derive(Debug, Clone)]
pub(super) enum Cell {
    /// An elementary value.
    Scalar(Type, Value),
    /// Elements in their order.
    Array(Vec<(i64, i64)>, Vec<CellId>),
    /// Members of a structure, or the variables of a block with the block's name.
    Members(Option<String>, HashMap<String, CellId>),
}

/// All cells.
#[derive(Debug, Default)]
pub(super) struct Memory {
    /// See [`Cell`].
    pub cells: Vec<Cell>,
}

impl Memory {
    fn add(&mut self, cell: Cell) -> CellId {
        self.cells.push(cell);
        self.cells.len() - 1
    }

    /// A new variable of a type.
    pub(super) fn make(&mut self, text: &Text, spec: &Spec) -> Result<CellId, String> {
        match spec {
            Spec::Text(length) => Ok(self.add(Cell::Scalar(Type::Text(*length), Value::Text(Vec::new())))),
            Spec::Array(bounds, element) => {
                let count: i64 = bounds.iter().map(|(first, last)| last - first + 1).product();
                let elements = (0..count)
                    .map(|_| self.make(text, element))
                    .collect::<Result<_, _>>()?;
                Ok(self.add(Cell::Array(bounds.clone(), elements)))
            }
            Spec::Named(name) => {
                if let Some(ty) = Type::named(name) {
                    let zero = ty.zero();
                    return Ok(self.add(Cell::Scalar(ty, zero)));
                }
                match text.types.get(name) {
                    Some(Declared::Values(values)) => {
                        let first = Value::Named(values[0].clone());
                        return Ok(self.add(Cell::Scalar(Type::Named(name.clone()), first)));
                    }
                    Some(Declared::Members(members)) => {
                        let mut all = HashMap::new();
                        for (name, spec, initial) in members {
                            let cell = self.make(text, spec)?;
                            if let Some(initial) = initial {
                                self.start(cell, initial)?;
                            }
                            all.insert(name.clone(), cell);
                        }
                        return Ok(self.add(Cell::Members(None, all)));
                    }
                    Some(Declared::Array(array)) => return self.make(text, array),
                    None => {}
                }
                let mut all = HashMap::new();
                if let Some(unit) = text.units.get(name) {
                    for variable in &unit.variables {
                        if !matches!(variable.section.as_str(), "VAR_EXTERNAL" | "VAR_IN_OUT") {
                            let cell = self.make(text, &variable.ty)?;
                            if let Some(initial) = &variable.initial {
                                self.start(cell, initial)?;
                            }
                            all.insert(variable.name.clone(), cell);
                        }
                    }
                } else {
                    for (name, ty) in
                        super::standard::members(name).ok_or_else(|| format!("no type {name}"))?
                    {
                        let spec = Spec::Named((*ty).to_owned());
                        all.insert((*name).to_owned(), self.make(text, &spec)?);
                    }
                }
                Ok(self.add(Cell::Members(Some(name.clone()), all)))
            }
        }
    }

    /// Sets a variable to what it starts with.
    pub(super) fn start(&mut self, cell: CellId, initial: &Initial) -> Result<(), String> {
        match (self.cells[cell].clone(), initial) {
            (Cell::Scalar(..), Initial::One(expr)) => {
                let value = match expr {
                    super::syntax::Expr::Literal(value) => value.clone(),
                    super::syntax::Expr::Unary(_, inner) => match &**inner {
                        super::syntax::Expr::Literal(Value::Int(n, ty)) => {
                            Value::Int(n.wrapping_neg(), ty.clone())
                        }
                        super::syntax::Expr::Literal(Value::Real(n, ty)) => Value::Real(-n, *ty),
                        other => return Err(format!("{other:?} is no constant")),
                    },
                    super::syntax::Expr::Read(path) => Value::Named(path.name.clone()),
                    other => return Err(format!("{other:?} is no constant")),
                };
                self.set(cell, value)
            }
            (Cell::Array(_, elements), Initial::Elements(values)) => {
                let mut elements = elements.into_iter();
                for (count, value) in values {
                    for _ in 0..*count {
                        let element = elements.next().ok_or("too many values")?;
                        self.start(element, value)?;
                    }
                }
                Ok(())
            }
            (Cell::Members(_, members), Initial::Members(values)) => {
                for (name, value) in values {
                    let member = members.get(name).ok_or_else(|| format!("no member {name}"))?;
                    self.start(*member, value)?;
                }
                Ok(())
            }
            (_, initial) => Err(format!("{initial:?} fits nothing")),
        }
    }

    /// The value of a cell.
    pub(super) fn get(&self, cell: CellId) -> Result<Value, String> {
        match &self.cells[cell] {
            Cell::Scalar(_, value) => Ok(value.clone()),
            _ => Err("a whole structure as a value".into()),
        }
    }

    /// Writes a value.
    pub(super) fn set(&mut self, cell: CellId, value: Value) -> Result<(), String> {
        match &mut self.cells[cell] {
            Cell::Scalar(ty, held) => {
                *held = ty.hold(value)?;
                Ok(())
            }
            _ => Err("a value for a whole structure".into()),
        }
    }

    /// Copies a structure or array.
    pub(super) fn copy(&mut self, to: CellId, from: CellId) -> Result<(), String> {
        match (self.cells[to].clone(), self.cells[from].clone()) {
            (Cell::Scalar(..), Cell::Scalar(_, value)) => self.set(to, value),
            (Cell::Array(a, to), Cell::Array(b, from)) if a == b => to
                .into_iter()
                .zip(from)
                .try_for_each(|(to, from)| self.copy(to, from)),
            (Cell::Members(_, to), Cell::Members(_, from)) => {
                for (name, to) in to {
                    self.copy(to, *from.get(&name).ok_or("other members")?)?;
                }
                Ok(())
            }
            _ => Err("values of different types".into()),
        }
    }

    /// A member of a cell.
    pub(super) fn member(&self, cell: CellId, name: &str) -> Result<CellId, String> {
        match &self.cells[cell] {
            Cell::Members(_, members) => members
                .get(name)
                .copied()
                .ok_or_else(|| format!("no member {name}")),
            _ => Err(format!("no member {name}")),
        }
    }

    /// An element of a cell.
    pub(super) fn element(&self, cell: CellId, indices: &[i64]) -> Result<CellId, String> {
        let Cell::Array(bounds, elements) = &self.cells[cell] else {
            return Err("no array".into());
        };
        if bounds.len() != indices.len() {
            return Err("another number of indices".into());
        }
        let mut at = 0;
        for ((first, last), index) in bounds.iter().zip(indices) {
            if !(first..=last).contains(&index) {
                return Err(format!("the index {index} is outside of {first}..{last}"));
            }
            at = at * (last - first + 1) + (index - first);
        }
        Ok(elements[at as usize])
    }

    /// An element of a cell, or of an element of it, with the indices of both.
    pub(super) fn inner_element(&self, mut cell: CellId, mut indices: &[i64]) -> Result<CellId, String> {
        while !indices.is_empty() {
            let Cell::Array(bounds, _) = &self.cells[cell] else {
                return Err("no array".into());
            };
            let (own, more) = indices.split_at(bounds.len().min(indices.len()));
            cell = self.element(cell, own)?;
            indices = more;
        }
        Ok(cell)
    }
}
