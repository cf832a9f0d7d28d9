//! What must be known of all rungs before the first is translated: tags that no declaration has, and what the controller does to its tags before the first scan.
//!
//! Before the first scan a controller runs every rung once with dead rails (the prescan): coils go off, the memories of
//! edges are set such that what is on already is not an edge, timers and counters are made ready. What it leaves is the
//! initial value of tags, so it is written there.

use crate::calls::{called, paths_in};
use crate::mnemonic::{Op, Role, instruction, role};
use crate::model::{Family, Language};
use crate::opened::Use;
use crate::operand::{Expr, Path, Step};
use crate::scope::Tags;
use crate::translate::tagged;
use crate::types::Ty;
use crate::unit::{Unit, operand};
use crate::values::Value;
use ladder_drawings::neutral::{Instruction, instructions};
use ladder_instructions::Op as Own;

/// Goes through all units.
pub(crate) fn survey(units: &[Unit<'_>], family: Family, tags: &mut Tags) {
    let each = |tags: &mut Tags, visit: &mut dyn FnMut(&mut Tags, usize, &Instruction<'_>)| {
        for unit in units {
            for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
                instructions(parts, &mut |it| visit(tags, unit.scope, it));
            }
        }
    };
    let has_open = tags.types.has_open();
    each(tags, &mut |tags, scope, it| {
        let is_real = has_open && is_beside_real(tags, family, scope, it);
        for (index, text) in it.operands.iter().enumerate() {
            let role = role(it.name, it.operands.len(), index).unwrap_or(Role::Word);
            let Ok(expr) = operand(family, text) else { continue };
            if let (Role::Timer | Role::Counter | Role::Control, Expr::Path(path)) = (role, &expr) {
                tags.declare_by_use(scope, path, role);
            }
            note_undeclared(tags, scope, &expr);
            if has_open {
                tags.use_paths(scope, &expr, Use { role, is_real });
            }
        }
    });
    if has_open {
        for unit in units {
            for (name, operands) in called(unit) {
                use_tagged(tags, family, unit.scope, &name, &operands);
            }
        }
        let texts = units
            .iter()
            .filter_map(|unit| Some((unit.scope, unit.routine.foreign.as_ref()?)));
        for (scope, foreign) in texts.filter(|(_, foreign)| foreign.language == Language::StructuredText) {
            for path in paths_in(&foreign.text) {
                // What the manuals do not tell is not guessed from a text.
                let role = Role::Word;
                tags.use_path(scope, &path, Use { role, is_real: false });
            }
        }
    }
    each(tags, &mut |tags, scope, it| {
        let mut surveyor = Surveyor { tags, family, scope };
        surveyor.prescan(it);
    });
}

/// Adds the members that an instruction works on whose inputs are members of its tag.
fn use_tagged(tags: &mut Tags, family: Family, scope: usize, name: &str, operands: &[String]) {
    let members = match instruction(name, operands.len()) {
        Some(Op::Tagged(own)) => tagged(own).1,
        Some(Op::Scl) if operands.len() == 1 => tagged("SCL").1,
        Some(Op::Pid) => &["SP", "KP", "KI", "KD"],
        _ => return,
    };
    let Some(Ok(Expr::Path(path))) = operands.first().map(|text| operand(family, text)) else {
        return;
    };
    for member in members {
        let mut path = path.clone();
        path.steps.push(Step::Member((*member).to_owned()));
        let by = Use {
            role: Role::Value,
            is_real: true,
        };
        tags.use_path(scope, &path, by);
    }
}

/// Whether a real is among the operands of an instruction.
fn is_beside_real(tags: &mut Tags, family: Family, scope: usize, it: &Instruction<'_>) -> bool {
    fn is_real(tags: &mut Tags, scope: usize, expr: &Expr) -> bool {
        match expr {
            Expr::Real(_) => true,
            Expr::Path(path) => tags.is_real(scope, path),
            _ => expr.parts().any(|part| is_real(tags, scope, part)),
        }
    }
    let exprs = it.operands.iter().filter_map(|text| operand(family, text).ok());
    exprs.into_iter().any(|expr| is_real(tags, scope, &expr))
}

/// Notes what may become tags of their own in an operand.
fn note_undeclared(tags: &mut Tags, scope: usize, expr: &Expr) {
    match expr {
        Expr::Path(path) => {
            tags.note_undeclared(scope, path);
            for step in &path.steps {
                match step {
                    Step::Index(all) => all.iter().for_each(|index| note_undeclared(tags, scope, index)),
                    Step::ComputedBit(index) => note_undeclared(tags, scope, index),
                    Step::Member(_) | Step::Bit(_) => {}
                }
            }
        }
        _ => expr.parts().for_each(|part| note_undeclared(tags, scope, part)),
    }
}

struct Surveyor<'a> {
    tags: &'a mut Tags,
    family: Family,
    scope: usize,
}

impl Surveyor<'_> {
    /// What the prescan does for an instruction.
    fn prescan(&mut self, it: &Instruction<'_>) {
        let Some(op) = instruction(it.name, it.operands.len()) else {
            return;
        };
        let first = it.operands.first().copied().unwrap_or_default();
        let control = |at: usize| it.operands.get(at).copied().unwrap_or_default();
        match op {
            Op::Coil(Own::Coil) => self.put(first, &[], 0),
            Op::Ons => self.put(first, &[], 1),
            Op::Osr if it.operands.len() == 1 => self.put(first, &[], 1),
            Op::Osr => {
                self.put(first, &[], 1);
                self.put(control(1), &[], 0);
            }
            Op::Osf => {
                self.put(first, &[], 0);
                self.put(control(1), &[], 0);
            }
            Op::Timer(kind) => {
                self.presets(first, "PRE", "ACC", &it.operands[it.operands.len() - 2..]);
                for member in ["EN", "TT", "DN"] {
                    // Whether an RTO that is done stays so, its manuals do not agree upon: it does here.
                    if !(kind == "RTO" && member == "DN") {
                        self.put(first, &[member], 0);
                    }
                }
                match kind {
                    "TON" => self.put(first, &["ACC"], 0),
                    "TOF" => {
                        let preset = self.get(first, "PRE");
                        self.put(first, &["ACC"], preset);
                    }
                    _ => {}
                }
            }
            Op::Counter(kind) => {
                self.presets(first, "PRE", "ACC", &it.operands[1..]);
                self.put(first, &[if kind == "CTU" { "CU" } else { "CD" }], 1);
            }
            Op::Load(_) => {
                self.presets(control(2), "LEN", "POS", &it.operands[3..]);
                self.put(control(2), &["EN"], 1);
            }
            Op::Unload(_) => {
                self.presets(control(2), "LEN", "POS", &it.operands[3..]);
                self.put(control(2), &["EU"], 1);
            }
            Op::Shift(_) => {
                self.presets(control(1), "LEN", "POS", &it.operands[3..]);
                self.put(control(1), &["EN"], 0);
            }
            Op::Sqo => {
                self.presets(control(3), "LEN", "POS", &it.operands[4..]);
                self.put(control(3), &["EN"], 1);
            }
            Op::Fal => {
                self.presets(first, "LEN", "POS", &it.operands[1..3]);
                self.put(first, &["EN"], 0);
            }
            // What they have of the rung is made ready: it counts as not seen yet.
            Op::Fsc => {
                self.presets(first, "LEN", "POS", &it.operands[1..3]);
                self.put(first, &["EN"], 0);
            }
            Op::Statistic(_) => {
                self.presets(control(3), "LEN", "POS", &it.operands[4..]);
                self.put(control(3), &["EN"], 0);
            }
            Op::Srt => {
                self.presets(control(2), "LEN", "POS", &it.operands[3..]);
                self.put(control(2), &["EN"], 0);
            }
            Op::Sqi => self.presets(control(3), "LEN", "POS", &it.operands[4..]),
            Op::Sql => {
                self.presets(control(2), "LEN", "POS", &it.operands[3..]);
                self.put(control(2), &["EN"], 1);
            }
            _ => {}
        }
    }

    /// Numbers that are written where `?` may be: they are put into the tag when the program is loaded.
    fn presets(&mut self, tag: &str, first: &str, second: &str, operands: &[&str]) {
        for (member, text) in [first, second].iter().zip(operands) {
            if let Ok(Expr::Int(number)) = operand(self.family, text) {
                self.put(tag, &[member], number);
            }
        }
    }

    fn path(&self, text: &str, members: &[&str]) -> Option<Path> {
        let Ok(Expr::Path(mut path)) = operand(self.family, text) else {
            return None;
        };
        let members = members.iter().map(|member| Step::Member((*member).to_owned()));
        path.steps.extend(members);
        Some(path)
    }

    fn put(&mut self, text: &str, members: &[&str], number: i64) {
        let Some(mut path) = self.path(text, members) else {
            return;
        };
        self.settle(&mut path);
        let Ok(place) = self.tags.place(self.scope, &path, Role::Bit) else {
            return;
        };
        let Some((symbol, part, bit)) = place.part.filter(|_| matches!(place.ty, Ty::Elem(_))) else {
            return;
        };
        let value = &mut self.tags.symbols[symbol].value;
        if number == 0 && value.is_none() {
            return;
        }
        value.get_or_insert(Value::Int(0)).set(&part, bit, number);
    }

    /// Puts what tags hold at the start in the place of computed indices and numbers of bits.
    fn settle(&mut self, path: &mut Path) {
        for step in &mut path.steps {
            match step {
                Step::Index(all) => {
                    for index in all {
                        if let Some(number) = self.at_start(index) {
                            *index = Expr::Int(number);
                        }
                    }
                }
                Step::ComputedBit(index) => {
                    let number = self.at_start(index).and_then(|number| u32::try_from(number).ok());
                    if let Some(number) = number {
                        *step = Step::Bit(number);
                    }
                }
                Step::Member(_) | Step::Bit(_) => {}
            }
        }
    }

    /// The number that is in a tag at the start.
    fn at_start(&mut self, expr: &Expr) -> Option<i64> {
        let Expr::Path(path) = expr else { return None };
        let place = self.tags.place(self.scope, path, Role::Value).ok()?;
        let (symbol, part, bit) = place.part?;
        let value = &self.tags.symbols[symbol].value;
        (bit.is_none()).then(|| value.as_ref().map_or(0, |value| value.get(&part)))
    }

    fn get(&mut self, text: &str, member: &str) -> i64 {
        let place = self
            .path(text, &[member])
            .and_then(|path| self.tags.place(self.scope, &path, Role::Value).ok());
        let Some((symbol, part, _)) = place.and_then(|place| place.part) else {
            return 0;
        };
        let value = &self.tags.symbols[symbol].value;
        value.as_ref().map_or(0, |value| value.get(&part))
    }
}
