//! Work on arrays: copies, shift registers, stacks, sequencers; and the controller `PID`.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::operand::{Expr, Step};
use crate::scope::Place;
use crate::types::{Elem, Ty};
use crate::unit::operand;
use ladder_format::Circuit;
use ladder_format::program::{Element, Expression, Literal, Operand, Path};
use ladder_instructions::Op;
use std::fmt::Display;

/// A part of an array: the array, the index of its first element, how many elements the array has from
/// there on, and what they are.
struct Stretch {
    array: Path,
    first: i64,
    left: u32,
    ty: Ty,
}

impl Translator<'_> {
    /// An array, or an element of one with a constant index, in one dimension. None: it is not an array.
    fn stretch(&mut self, text: &str) -> Result<Option<Stretch>> {
        let Expr::Path(mut path) = operand(self.project.family, text)? else {
            return Err(format!("`{text}` is no array"));
        };
        let first = match path.steps.last() {
            Some(Step::Index(index)) => match index[..] {
                [Expr::Int(first)] => {
                    path.steps.pop();
                    first
                }
                _ => return Ok(None),
            },
            _ => 0,
        };
        let place = self.tags.place(self.scope, &path, Role::Array)?;
        Ok(match place.ty {
            Ty::Array(ty, sizes) if sizes.len() == 1 => {
                let left = u32::try_from(first)
                    .ok()
                    .and_then(|first| sizes[0].checked_sub(first));
                let Some(left) = left.filter(|left| *left > 0) else {
                    return Err(format!("the index is outside `{}`", place.path));
                };
                Some(Stretch {
                    array: place.path,
                    first,
                    left,
                    ty: *ty,
                })
            }
            _ => None,
        })
    }

    /// A number of elements.
    fn length(&self, text: &str) -> Result<u32> {
        match operand(self.project.family, text)? {
            Expr::Int(length) if length > 0 => Ok(u32::try_from(length).unwrap_or(u32::MAX)),
            _ => Err(format!("the length `{text}` is no constant")),
        }
    }

    /// `COP`: elements of one type are copied, as many as fit. Bytes of one type into another are not.
    pub(super) fn copy(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let length = self.length(operands[2])?;
        let (from, to) = (self.stretch(operands[0])?, self.stretch(operands[1])?);
        if let (Some(from), Some(to)) = (from, to) {
            if from.ty != to.ty {
                return self.copy_bytes(&from, &to, length);
            }
            let length = length.min(to.left).min(from.left);
            let range = |it: Stretch| match length {
                1 => it.array.index([it.first]),
                _ => it.array.range(it.first, it.first + i64::from(length) - 1),
            };
            let op = if length == 1 { Op::Mov } else { Op::Bmov };
            return self.op(op, [range(to), range(from)]);
        }
        let (from, to) = (
            self.place(operands[0], Role::Array)?,
            self.target(operands[1], Role::Array)?,
        );
        if from.ty != to.ty || length != 1 {
            return Err(different(&from.path, &to.path));
        }
        self.op(Op::Mov, [to.path, from.path])
    }

    /// `COP` between arrays of words of other widths: bytes stay in their order.
    fn copy_bytes(&mut self, from: &Stretch, to: &Stretch, length: u32) -> Result<Circuit<Element>> {
        /// A rung has no more elements for one copy.
        const MOST: u32 = 64;
        let width = |ty: &Ty| match ty {
            Ty::Elem(elem) if elem.is_integer() && elem.bits() <= 32 => Some(elem.bits()),
            _ => None,
        };
        let (Some(own), Some(width)) = (width(&from.ty), width(&to.ty)) else {
            return Err(different(&from.array, &to.array));
        };
        let length = length.min(to.left).min((from.left * own) / width);
        if length == 0 || length > MOST {
            return Err(different(&from.array, &to.array));
        }
        let element = |number: u32| {
            let formula = crate::words::element(number, width, (&from.array, from.first), own);
            let index = to.first + i64::from(number);
            self.put(Op::Calc, &to.array.clone().index([index]), formula)
        };
        let elements: Result<Vec<_>> = (0..length).map(element).collect();
        Ok(Circuit::Series(elements?))
    }

    /// `SIZE`: how many elements a dimension has.
    pub(super) fn size(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let place = self.place(operands[0].trim_end_matches("[0]"), Role::Array)?;
        let Ty::Array(_, sizes) = &place.ty else {
            return Err(format!("`{}` is no array", place.path));
        };
        let size = match self.expr(operands[1])? {
            Expr::Int(dimension) => usize::try_from(dimension)
                .ok()
                .and_then(|at| sizes.get(at).copied()),
            _ => None,
        };
        let size = size.ok_or_else(|| format!("`{}` has no such dimension", place.path))?;
        self.move_value(&size.to_string(), operands[2])
    }

    /// `FLL`
    pub(super) fn fill(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let length = self.length(operands[2])?;
        let from = self.expr(operands[0])?;
        let is_zero = matches!(from, Expr::Int(0)) || matches!(from, Expr::Real(real) if real == 0.0);
        let empty = Expr::Text(String::new());
        let Some(to) = self.stretch(operands[1])? else {
            let to = self.target(operands[1], Role::Array)?;
            return match to.elem() {
                // The usual way to clear one.
                Some(Elem::String(_)) if length == 1 && is_zero => self.moved(&empty, &to),
                Some(elem) if length == 1 && (elem.is_integer() || elem.is_real()) => self.moved(&from, &to),
                None if length == 1 && is_zero => {
                    let cleared = self.cleared(&to.ty)?;
                    self.put(Op::Mov, &to.path, cleared)
                }
                _ => Err(format!(
                    "`{}` is no array of one dimension with a constant index",
                    operands[1]
                )),
            };
        };
        let last = to.first + i64::from(length.min(to.left)) - 1;
        let Ty::Elem(elem) = to.ty else {
            if !is_zero {
                return Err(format!("`{}` has no elementary elements", to.array));
            }
            let cleared = self.cleared(&to.ty)?;
            return self.put(Op::Fill, &to.array.range(to.first, last), cleared);
        };
        let (value, own) = match elem {
            Elem::String(_) if is_zero => self.value(&empty, elem)?,
            Elem::String(_) => return Err(format!("`{}` takes no number", to.array)),
            _ => self.value(&from, elem)?,
        };
        if own.is_some_and(|own| own != elem) {
            return Err(different(&value, &to.array));
        }
        self.put(Op::Fill, &to.array.range(to.first, last), value)
    }

    /// A constant of a type whose parts are all 0.
    fn cleared(&mut self, ty: &Ty) -> Result<Path> {
        let cleared = self.tags.cleared(self.scope, ty);
        cleared.ok_or_else(|| "an instance of an Add-On Instruction is not cleared here".to_owned())
    }

    /// A block on a whole array. `kinds` says of each further operand what it is: a place (`P`), a value of the elements' type
    /// (`V`), a CONTROL (`I`), a bit (`B`).
    pub(super) fn on_file(
        &mut self,
        name: &str,
        array: &str,
        others: &[&str],
        kinds: &str,
    ) -> Result<Circuit<Element>> {
        let (array, size, elem) = self.whole_array(name, array)?;
        let mut own = vec![array.into()];
        for (text, kind) in others.iter().zip(kinds.bytes()) {
            own.push(self.file_operand(text, kind, elem)?);
        }
        let block = self.blocks.on_array(name, size, elem);
        self.user(&block, own)
    }

    pub(super) fn load(&mut self, name: &str, operands: &[&str]) -> Result<Circuit<Element>> {
        let (array, size, elem) = self.whole_array(name, operands[1])?;
        let value = self.file_operand(operands[0], b'V', elem)?;
        let control = self.control(operands[2])?;
        let block = self.blocks.on_array(name, size, elem);
        self.user(&block, [value, array.into(), control.into()])
    }

    fn whole_array(&mut self, name: &str, text: &str) -> Result<(Path, u32, Elem)> {
        let stretch = self.stretch(text)?.filter(|it| it.first == 0);
        let Some(Stretch { array, left, ty, .. }) = stretch else {
            return Err(format!(
                "`{text}` is not the beginning of an array of one dimension"
            ));
        };
        let is_bits = !matches!(name, "FFL" | "FFU" | "LFL" | "LFU" | "AVE" | "STD" | "SRT");
        match ty {
            Ty::Elem(elem) if elem.is_integer() || (!is_bits && elem != Elem::Bool) => {
                Ok((array, left, elem))
            }
            _ => Err(format!("`{array}` has other elements than {name} works on")),
        }
    }

    fn file_operand(&mut self, text: &str, kind: u8, elem: Elem) -> Result<Expression> {
        Ok(match kind {
            b'V' => {
                let expr = self.expr(text)?;
                let (value, own) = self.value(&expr, elem)?;
                if own.is_some_and(|own| own != elem) {
                    return Err(format!("`{text}` has another type than the array"));
                }
                value
            }
            b'B' => match self.expr(text)? {
                Expr::Int(bit) => Literal::from(bit != 0).into(),
                _ => self.bit(text)?.path.into(),
            },
            b'I' => self.control(text)?.into(),
            _ => {
                let place: Place = self.target(text, Role::Value)?;
                if place.ty != Ty::Elem(elem) {
                    return Err(format!("`{text}` has another type than the array"));
                }
                place.path.into()
            }
        })
    }

    pub(super) fn control(&mut self, text: &str) -> Result<Path> {
        let place = self.target(text, Role::Control)?;
        if self.tags.types.original(&place.ty) != "CONTROL" {
            return Err(format!("`{text}` is no CONTROL"));
        }
        Ok(place.path)
    }

    /// `PID`: the library's controller takes its place.
    pub(super) fn pid(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let [own, measured, _, output, ..] = operands else {
            return Err("PID has six operands or more".to_owned());
        };
        let own = self.place(own, Role::Word)?;
        let Ty::Structure(index) = own.ty else {
            return Err("the members of its tag are not in the file".to_owned());
        };
        let mut inputs = Vec::new();
        for (input, member) in [("sp", "SP"), ("kp", "KP"), ("ki", "KI"), ("kd", "KD")] {
            let Some((_, field)) = self.tags.types.member(index, member) else {
                return Err(format!("its tag has no member {member}"));
            };
            let member = own.path.clone().member(&field.name);
            inputs.push(Operand::Given(input.to_owned(), member.into()));
        }
        let measured = self.expr(measured)?;
        let (measured, _) = self.value(&measured, Elem::Lreal)?;
        let output = self.target(output, Role::Value)?;
        let helper = self.helper("pid", Elem::Lreal, "the output of the controller, in percent");
        self.note("it is the controller of the library: in parallel form, with an output from 0 to 100, without tieback, hold and cascade");
        inputs.push(Operand::Given("pv".to_owned(), measured));
        inputs.push(Operand::Taken("y".to_owned(), (&helper).into()));
        let call = self.user("PID", inputs)?;
        Ok(Circuit::Series(vec![
            call,
            self.put(Op::Typ, &output.path, helper)?,
        ]))
    }
}

fn different(from: impl Display, to: &Path) -> String {
    format!(
        "`{from}` and `{to}` are of different types: the bytes of one in the other have no counterpart here"
    )
}
