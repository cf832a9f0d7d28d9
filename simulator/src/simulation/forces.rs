//! Values from outside: assigned before a scan, or held by force.

use super::{Change, Force, Simulation};
use crate::tags::{Point, PointSlot, Within};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_analysis::with_article;
use std::collections::BTreeMap;

impl Simulation {
    /// Sets a tag to a value before the next scan, as the world outside does. A forced tag goes on showing its
    /// forced value. While a scan is open ([`Self::is_open`]) this waits for its end, and so do forces. What a plant drives is
    /// held at the value from there on, until it is given back ([`Self::unforce`]): the machine is not as the model of it.
    ///
    /// # Errors
    /// The point is read-only, or the value does not fit its type.
    pub fn set(&mut self, point: &Point, value: Value) -> Result<(), ValueRefused> {
        if self.is_driven(point) {
            return self.force(point, value);
        }
        check(point, &value)?;
        if self.open {
            self.pending.push(Change::Set(point.clone(), value));
            return Ok(());
        }
        self.assign(point, value);
        Ok(())
    }

    fn assign(&mut self, point: &Point, value: Value) {
        if let Some(force) = self.forces.get_mut(&point.name) {
            if point.is_input {
                force.underneath = Some(value);
            }
            return;
        }
        self.write(point, &value);
    }

    /// Does what was asked for while a scan was open.
    pub(crate) fn take_pending(&mut self) {
        for change in std::mem::take(&mut self.pending) {
            match change {
                Change::Set(point, value) => self.assign(&point, value),
                Change::Force(point, value) => self.hold(point, value),
                Change::Unforce(point) => self.unforce(&point),
                Change::UnforceAll => self.unforce_all(),
                Change::Serial(bytes) => self.feed_serial(&bytes),
            }
        }
    }

    /// Holds a tag at a value: it reads as this value everywhere, and writes to it have no effect.
    ///
    /// # Errors
    /// The point is read-only or no elementary part (a bit, a member of a timer or block), or the value does not fit its type.
    pub fn force(&mut self, point: &Point, value: Value) -> Result<(), ValueRefused> {
        check(point, &value)?;
        check_elementary(point)?;
        if self.open {
            self.pending.push(Change::Force(point.clone(), value));
        } else {
            self.hold(point.clone(), value);
        }
        Ok(())
    }

    pub(crate) fn hold(&mut self, point: Point, value: Value) {
        let before = match self.forces.get(&point.name) {
            Some(force) => force.underneath.clone(),
            None => (point.is_input).then(|| self.value(&point)),
        };
        self.machine.memory.make_room_for_forces();
        self.mark(&point, true);
        // The value goes in underneath the mark, which only keeps the program from writing.
        self.write(&point, &value);
        self.forces.insert(
            point.name.clone(),
            Force {
                point,
                underneath: before,
            },
        );
    }

    /// Lets a tag go. An input shows its own value again, any other tag keeps the forced one until it is written.
    /// Nothing happens if it is not forced.
    pub fn unforce(&mut self, point: &Point) {
        if self.open {
            self.pending.push(Change::Unforce(point.clone()));
            return;
        }
        let Some(force) = self.forces.remove(&point.name) else {
            return;
        };
        self.mark(&force.point, false);
        // A word and a bit of it may both be forced.
        let others: Vec<Point> = self.forces.values().map(|other| other.point.clone()).collect();
        for other in &others {
            self.mark(other, true);
        }
        if let Some(value) = force.underneath {
            self.write(&force.point, &value);
        }
    }

    /// Lets all tags go.
    pub fn unforce_all(&mut self) {
        if self.open {
            self.pending.push(Change::UnforceAll);
            return;
        }
        for force in std::mem::take(&mut self.forces).into_values() {
            self.mark(&force.point, false);
            if let Some(value) = force.underneath {
                self.write(&force.point, &value);
            }
        }
    }

    /// Makes these the forces. The banks already hold what forced points show.
    pub(crate) fn restore_forces(&mut self, forces: &BTreeMap<String, Force>) {
        if self.forces == *forces {
            return;
        }
        for force in std::mem::take(&mut self.forces).into_values() {
            self.mark(&force.point, false);
        }
        self.forces.clone_from(forces);
        self.machine.memory.make_room_for_forces();
        for force in forces.values() {
            self.mark(&force.point, true);
        }
    }

    /// What a point will be given or held at when the scan that is open has ended.
    pub fn waiting(&self, point: &Point) -> Option<&Value> {
        let waiting = self.pending.iter().rev().find_map(|change| match change {
            Change::Set(other, value) | Change::Force(other, value) if other.name == point.name => {
                Some(Some(value))
            }
            Change::Unforce(other) if other.name == point.name => Some(None),
            Change::UnforceAll => Some(None),
            _ => None,
        });
        waiting.flatten()
    }

    /// Whether a connection between the program and a plant writes this point before each scan.
    pub fn is_driven(&self, point: &Point) -> bool {
        let plants = self.program.plants.iter();
        let mut driven = plants.flat_map(|plant| plant.inputs.iter().chain(&plant.outputs));
        driven.any(|it| {
            let home = self.compiled.homes[it.to.0 as usize];
            match point.slot {
                PointSlot::BitOf { word, .. } => home.holds(PointSlot::Word(word)),
                slot => home.holds(slot),
            }
        })
    }

    /// Whether a point is forced.
    pub fn is_forced(&self, point: &Point) -> bool {
        !self.forces.is_empty() && self.forces.contains_key(&point.name)
    }

    /// The points that are forced, by name.
    pub fn forced(&self) -> impl Iterator<Item = &Point> {
        self.forces.values().map(|force| &force.point)
    }

    /// Writes past all forces.
    pub(crate) fn write(&mut self, point: &Point, value: &Value) {
        let memory = &mut self.machine.memory;
        match (point.slot, value) {
            (PointSlot::Bit(slot), Value::Bool(high)) => memory.set_bit(slot, *high),
            (PointSlot::Word(slot), Value::Int(number)) => memory.words[slot.0 as usize] = *number,
            (PointSlot::Word(slot), Value::Real(real)) => {
                let real = if point.ty == Scalar::Real {
                    f64::from(*real as f32)
                } else {
                    *real
                };
                memory.words[slot.0 as usize] = real.to_bits() as i64;
            }
            (PointSlot::Text(slot), Value::Text(bytes)) => memory.texts[slot.0 as usize].set(bytes),
            (PointSlot::BitOf { word, bit, ty }, Value::Bool(high)) => {
                let mask = 1i64 << bit;
                let value = memory.word(word) & !mask | if *high { mask } else { 0 };
                memory.words[word.0 as usize] = ladder_analysis::values::value::wrap(value, ty);
            }
            _ => {}
        }
    }

    /// Marks a slot as held, or not.
    fn mark(&mut self, point: &Point, held: bool) {
        let marks = &mut self.machine.memory.held;
        match point.slot {
            PointSlot::Bit(slot) => marks.bits[slot.0 as usize] = u8::from(held),
            PointSlot::Word(slot) => marks.words[slot.0 as usize] = if held { -1 } else { 0 },
            PointSlot::Text(slot) => marks.texts[slot.0 as usize] = held,
            PointSlot::BitOf { .. } | PointSlot::Timing { .. } => {}
        }
    }
}

/// Whether a point takes a value from outside.
fn check(point: &Point, value: &Value) -> Result<(), ValueRefused> {
    if point.read_only {
        return Err(ValueRefused {
            message: format!("{} is read-only: it cannot be given a value", point.name),
        });
    }
    let fits = match (value, point.ty) {
        (Value::Bool(_), Scalar::Bool) => true,
        (Value::Real(real), ty) => ty.is_real() && real.is_finite(),
        (Value::Text(_), ty) => ty.is_string(),
        (Value::Int(number), Scalar::Enum(id)) => id.get().name_of(*number).is_some(),
        (Value::Int(number), ty) => match ty.bounds() {
            Some(_) => ladder_analysis::values::value::wrap(*number, ty) == *number,
            None => ty == Scalar::Time || ty.is_date(),
        },
        (Value::Bool(_), _) => false,
    };
    if fits {
        return Ok(());
    }
    Err(ValueRefused {
        message: format!(
            "{} is {} and cannot hold this value",
            point.name,
            with_article(point.ty)
        ),
    })
}

/// Whether a force reaches a point (LANGUAGE §4).
fn check_elementary(point: &Point) -> Result<(), ValueRefused> {
    let name = &point.name;
    let whole = name.rsplit_once('.').map_or(name.as_str(), |(whole, _)| whole);
    let message = match point.within {
        Within::None => return Ok(()),
        Within::Number => format!("{name} is a bit, which cannot be forced: force {whole} as a whole"),
        Within::State(state) => format!(
            "{name} is a member of {}, which cannot be forced: force what the block of {whole} reads",
            with_article(state.name())
        ),
        Within::Block => format!(
            "{name} is inside of the state of a block, which cannot be forced: force what the block is given"
        ),
    };
    Err(ValueRefused { message })
}

/// Why a tag did not take a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueRefused {
    /// What is wrong and what to do.
    pub message: String,
}

impl std::fmt::Display for ValueRefused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for ValueRefused {}
