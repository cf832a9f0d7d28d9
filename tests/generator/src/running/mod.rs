//! Programs with types of their own, evaluated a second time: a tag is a tree of values here, not a row of columns, and a path is
//! walked from its root.

mod changed;
mod initial;

use crate::generator::typed::{Act, CELL, Index, POKED, Path, Span, Step, Ty, Typed};
use initial::initial;
use std::collections::BTreeMap;

/// A value with its parts.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// BOOL, INT, and the number of an enumeration's value.
    One(i64),
    /// The members of a structure, or the elements of an array row by row.
    Many(Vec<Value>),
    /// When it was started, ET in milliseconds, Q.
    Ton(Option<i64>, i64, bool),
    /// CV, Q, and whether EN was high.
    Ctu(i64, bool, bool),
    /// The output `total`, the inputs `x` and `by`, and what its edge remembers.
    Acc(i64, bool, i64, bool),
}

/// A block of which an operand is no place, or which cannot be done.
struct Fault;

/// Where a part is: the numbers of members and elements on the way from the tag.
type Place = Vec<usize>;

/// A running program.
#[derive(Debug)]
pub struct Running {
    pub(super) program: Typed,
    pub(super) tags: Vec<Value>,
    /// The inputs `e0` ..
    pub switches: Vec<bool>,
    /// The inputs `i0` ..
    pub numbers: Vec<i64>,
    /// The coils `ok0` .. by their numbers.
    pub done: BTreeMap<usize, bool>,
    /// How many faults the last scan had.
    pub faults: usize,
    pub(super) now: i64,
}

/// The time from one scan to the next, in milliseconds.
const INTERVAL: i64 = 10;

impl Running {
    /// A program before its first scan.
    pub fn new(program: &Typed) -> Running {
        let tags = program.tags.iter().map(|tag| initial(program, tag));
        Running {
            tags: tags.collect(),
            switches: vec![false; 3],
            numbers: vec![0; 3],
            done: program.rungs.iter().map(|rung| (rung.number, false)).collect(),
            faults: 0,
            now: 0,
            program: program.clone(),
        }
    }

    /// Runs one scan.
    pub fn scan(&mut self) {
        self.faults = 0;
        for rung in self.program.rungs.clone() {
            let en = rung.input.is_none_or(|input| self.switches[input]);
            let power = self.act(&rung.act, en);
            self.faults += usize::from(power.is_err());
            self.done.insert(rung.number, power.unwrap_or(false));
        }
        self.now += INTERVAL;
    }

    /// Its elementary parts by their names, with what they hold as a trace writes it.
    pub fn values(&self) -> Vec<(String, String)> {
        let mut values = Vec::new();
        for (tag, value) in self.program.tags.iter().zip(&self.tags) {
            self.add_values(tag.name.clone(), &tag.ty, value, &mut values);
        }
        for (number, done) in &self.done {
            values.push((format!("ok{number}"), i64::from(*done).to_string()));
        }
        values
    }

    fn add_values(&self, name: String, ty: &Ty, value: &Value, values: &mut Vec<(String, String)>) {
        let mut add = |part: &str, held: i64| values.push((format!("{name}{part}"), held.to_string()));
        match (&self.program.real(ty), value) {
            (Ty::Phase, Value::One(number)) => {
                let phase = self.program.phase.values.iter().find(|(_, own)| own == number);
                values.push((name, phase.map_or_else(String::new, |(phase, _)| phase.clone())));
            }
            (_, Value::One(number)) => add("", *number),
            (Ty::Structure(structure), Value::Many(parts)) => {
                let members = &self.program.structures[*structure].members;
                for (member, value) in members.iter().zip(parts) {
                    self.add_values(format!("{name}.{}", member.name), &member.ty, value, values);
                }
            }
            (Ty::Array(dimensions, element), Value::Many(parts)) => {
                for (number, value) in parts.iter().enumerate() {
                    let mut rest = number as i64;
                    let mut indices = Vec::new();
                    for (first, last) in dimensions.iter().rev() {
                        let count = last - first + 1;
                        indices.push((first + rest % count).to_string());
                        rest /= count;
                    }
                    indices.reverse();
                    self.add_values(format!("{name}[{}]", indices.join(", ")), element, value, values);
                }
            }
            (_, Value::Ton(_, et, q)) => {
                add(".ET", *et);
                add(".Q", i64::from(*q));
            }
            (_, Value::Ctu(cv, q, _)) => {
                add(".CV", *cv);
                add(".Q", i64::from(*q));
            }
            (_, Value::Acc(total, ..)) => add(".total", *total),
            (_, Value::Many(_)) => {}
        }
    }

    /// The power after a block.
    fn act(&mut self, act: &Act, en: bool) -> Result<bool, Fault> {
        // These always act.
        match act {
            Act::Coil(path) => {
                let place = self.place(path)?;
                *self.part(&place) = Value::One(i64::from(en));
                return Ok(en);
            }
            Act::Ton(path) => {
                let place = self.place(path)?;
                return Ok(self.ton(&place, en));
            }
            Act::Ctu(path) => {
                let place = self.place(path)?;
                let Value::Ctu(cv, q, before) = self.part(&place) else {
                    return Err(Fault);
                };
                *cv += i64::from(en && !*before);
                *before = en;
                *q = *cv >= 2;
                return Ok(*q);
            }
            Act::Acc(state, [x, by, total]) => {
                let (state, x, by) = (self.place(state)?, self.number(x)? != 0, self.number(by)?);
                let total = self.place(total)?;
                self.acc(&state, x, by, &total);
                return Ok(en);
            }
            Act::Poke(cell, by) => {
                let (cell, by) = (self.place(cell)?, self.number(by)?);
                self.poke(&cell, by);
                return Ok(en);
            }
            _ if !en => return Ok(false),
            _ => {}
        }
        match act {
            Act::Move(y, a) => self.store(y, a, Ok)?,
            Act::Select(y, g, values) => {
                let y = self.place(y)?;
                let values = [self.value(&values[0])?, self.value(&values[1])?];
                let chosen = usize::from(self.number(g)? != 0);
                *self.part(&y) = values[chosen].clone();
            }
            Act::Choose(y, k, values) => {
                let y = self.place(y)?;
                let values = [
                    self.value(&values[0])?,
                    self.value(&values[1])?,
                    self.value(&values[2])?,
                ];
                let chosen = usize::try_from(self.index(*k)).ok().and_then(|k| values.get(k));
                *self.part(&y) = chosen.ok_or(Fault)?.clone();
            }
            Act::Add(y, a, b) => self.store(y, a, |value| Ok(wrapped(value, *b)))?,
            Act::ToPhase(y, a) => {
                let phases = self.program.phase.values.clone();
                let is_one = |value: &Value| phases.iter().any(|(_, number)| *value == Value::One(*number));
                self.store(y, a, |value| if is_one(&value) { Ok(value) } else { Err(Fault) })?;
            }
            Act::ToNumber(y, a) => self.store(y, a, Ok)?,
            Act::Equal(a, b) => return Ok(self.value(a)? == self.value(b)?),
            Act::Contact(a) => return Ok(self.number(a)? != 0),
            Act::Fill(span, a) => {
                let (places, value) = (self.span(span)?, self.value(a)?);
                for place in places {
                    *self.part(&place) = value.clone();
                }
            }
            Act::Copy(to, from) => {
                let (to, from) = (self.span(to)?, self.span(from)?);
                let values: Vec<Value> = from.iter().map(|place| self.part(place).clone()).collect();
                for (place, value) in to.iter().zip(values) {
                    *self.part(place) = value;
                }
            }
            _ => {}
        }
        Ok(true)
    }

    fn store(
        &mut self,
        y: &Path,
        a: &Path,
        with: impl FnOnce(Value) -> Result<Value, Fault>,
    ) -> Result<(), Fault> {
        let (y, value) = (self.place(y)?, self.value(a)?);
        *self.part(&y) = with(value)?;
        Ok(())
    }

    fn ton(&mut self, place: &[usize], en: bool) -> bool {
        let now = self.now;
        let Value::Ton(since, et, q) = self.part(place) else {
            return false;
        };
        if !en {
            (*since, *et, *q) = (None, 0, false);
            return false;
        }
        *et = (now - *since.get_or_insert(now)).min(20);
        *q = *et >= 20;
        *q
    }

    fn acc(&mut self, state: &[usize], x: bool, by: i64, to: &[usize]) {
        let Value::Acc(total, own_x, own_by, before) = self.part(state) else {
            return;
        };
        (*own_x, *own_by) = (x, by);
        if x && !*before {
            *total = i64::from((*total + by) as i16);
        }
        *before = x;
        let total = *total;
        *self.part(to) = Value::One(total);
    }

    /// What the body of `$Poke` does.
    fn poke(&mut self, cell: &[usize], by: i64) {
        let members = &self.program.structures[CELL].members;
        let place = |name| members.iter().position(|member| member.name == name);
        let places = POKED.map(|name| [cell, &[place(name).expect("it is not taken away")]].concat());
        let [n, on, row, t, done, acc, total] = places;
        let bounds = match &members[*row.last().expect("a member")].ty {
            Ty::Array(dimensions, _) => dimensions[0],
            _ => (0, 0),
        };
        *self.part(&n) = wrapped(self.part(&n).clone(), by);
        let value = self.part(&n).clone();
        if (bounds.0..=bounds.1).contains(&by) {
            *self.part(&[row, vec![(by - bounds.0) as usize]].concat()) = value;
        } else {
            self.faults += 1;
        }
        let is_on = *self.part(&on) == Value::One(1);
        let q = self.ton(&t, is_on);
        *self.part(&done) = Value::One(i64::from(q));
        self.acc(&acc, is_on, by, &total);
    }

    fn index(&self, index: Index) -> i64 {
        match index {
            Index::Number(number) => number,
            Index::Input(input, more) => self.numbers[input] + more,
        }
    }

    /// Where an element is in its array, row by row.
    fn element(&self, dimensions: &[(i64, i64)], indices: &[Index]) -> Result<usize, Fault> {
        let mut at = 0;
        for ((first, last), index) in dimensions.iter().zip(indices) {
            let index = self.index(*index);
            if !(first..=last).contains(&&index) {
                return Err(Fault);
            }
            at = at * (last - first + 1) + (index - first);
        }
        Ok(at as usize)
    }

    fn place_and_type(&self, path: &Path) -> Result<(Place, Ty), Fault> {
        let (number, tag) = self.program.tag(&path.tag).ok_or(Fault)?;
        let mut place = vec![number];
        let mut ty = self.program.real(&tag.ty);
        for step in &path.steps {
            ty = match (step, ty) {
                (Step::Member(name), Ty::Structure(number)) => {
                    let (at, member) = self.program.member(number, name).ok_or(Fault)?;
                    place.push(at);
                    self.program.real(&member.ty)
                }
                (Step::Element(indices), Ty::Array(dimensions, element)) => {
                    place.push(self.element(&dimensions, indices)?);
                    *element
                }
                _ => return Err(Fault),
            };
        }
        Ok((place, ty))
    }

    fn place(&self, path: &Path) -> Result<Place, Fault> {
        self.place_and_type(path).map(|(place, _)| place)
    }

    fn part(&mut self, place: &[usize]) -> &mut Value {
        let (tag, rest) = place.split_first().expect("a place begins with a tag");
        rest.iter().fold(&mut self.tags[*tag], |value, at| match value {
            Value::Many(parts) => &mut parts[*at],
            whole => whole,
        })
    }

    fn value(&mut self, path: &Path) -> Result<Value, Fault> {
        let place = self.place(path)?;
        Ok(self.part(&place).clone())
    }

    fn number(&mut self, path: &Path) -> Result<i64, Fault> {
        match self.value(path)? {
            Value::One(number) => Ok(number),
            _ => Err(Fault),
        }
    }

    fn span(&self, span: &Span) -> Result<Vec<Place>, Fault> {
        let (place, ty) = self.place_and_type(&span.array)?;
        let Ty::Array(dimensions, _) = ty else {
            return Err(Fault);
        };
        let (others, first, last) = &span.indices;
        let at = |end: &Index| self.element(&dimensions, &[others.as_slice(), &[*end]].concat());
        let (first, last) = (at(first)?, at(last)?);
        Ok((first..=last)
            .map(|at| [place.as_slice(), &[at]].concat())
            .collect())
    }
}

fn wrapped(value: Value, more: i64) -> Value {
    match value {
        Value::One(number) => Value::One(i64::from((number + more) as i16)),
        other => other,
    }
}
