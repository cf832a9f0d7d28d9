//! Edits of a program: of a type, a tag or a rung, one at a time. What does not fit any more is left out.

use super::{CELL, Declared, Dice, POKED, Rung, Ty, Typed, array, bounds};

/// New types have members of these: other structures hold only earlier ones.
const ITEM: usize = 0;

impl Typed {
    /// The program after one edit.
    #[must_use]
    pub fn edited(&self, dice: &mut Dice) -> Typed {
        let mut new = self.clone();
        let structure = dice.below(self.structures.len());
        match dice.below(12) {
            0 => {
                let name = new.fresh_name("member");
                let members = self.structures[structure].members.len();
                let added = new.declared(dice, &name, structure);
                let at = dice.below(members + 1);
                new.structures[structure].members.insert(at, added);
            }
            1 => {
                let members = &mut new.structures[structure].members;
                let at = dice.below(members.len());
                if members.len() > 1 && !is_poked(structure, &members[at]) {
                    members.remove(at);
                }
            }
            2 => dice.shuffle(&mut new.structures[structure].members),
            3 => {
                let names = [
                    &mut new.phase.name,
                    &mut new.structures[structure].name,
                    &mut new.aliases[structure].name,
                ];
                let name = names.into_iter().nth(dice.below(3)).expect("one of three");
                *name = format!(
                    "{}_{}",
                    name.split('_').next().unwrap_or_default(),
                    dice.below(90)
                );
            }
            4 | 5 => {
                let at = dice.below(new.structures[structure].members.len());
                let member = &new.structures[structure].members[at];
                let other = match (&member.ty, is_poked(structure, member)) {
                    (Ty::Array(_, element), true) => Declared {
                        ty: Ty::Array(vec![bounds(dice)], element.clone()),
                        ..member.clone()
                    },
                    (_, true) => member.clone(),
                    (ty, false) => new.retyped(dice, &member.name, ty, structure),
                };
                new.structures[structure].members[at] = other;
            }
            6 => {
                let name = new.fresh_name("tag");
                let added = new.declared(dice, &name, CELL + 1);
                new.tags.push(added);
            }
            7 => {
                let at = dice.below(new.tags.len());
                new.tags.remove(at);
            }
            8 => {
                let at = dice.below(new.tags.len());
                let tag = new.retyped(dice, &new.tags[at].name, &new.tags[at].ty, CELL + 1);
                new.tags[at] = tag;
            }
            9 => new.edit_values(dice),
            10 => new.give_initial_values(dice),
            _ => new.edit_rungs(dice),
        }
        new.without_misfits()
    }

    fn edit_values(&mut self, dice: &mut Dice) {
        let name = self.fresh_name("VALUE");
        let values = &mut self.phase.values;
        let at = dice.below(values.len());
        let number = values.iter().map(|(_, number)| number + 1).max().unwrap_or(0);
        match dice.below(3) {
            0 => values.insert(at, (name, number)),
            1 if values.len() > 1 => drop(values.remove(at)),
            _ => values[at].1 = number + dice.between(0, 3),
        }
    }

    fn edit_rungs(&mut self, dice: &mut Dice) {
        match dice.below(3) {
            0 if !self.rungs.is_empty() => drop(self.rungs.remove(dice.below(self.rungs.len()))),
            1 => dice.shuffle(&mut self.rungs),
            _ => self.add_rung(dice),
        }
    }

    /// A name that nothing has.
    fn fresh_name(&self, word: &str) -> String {
        let text = self.to_string();
        let names = (0..).map(|number| format!("{word}{number}"));
        let mut free = names.filter(|name| !text.contains(name.as_str()));
        free.next().expect("there are numbers enough")
    }

    /// A tag or member of any type. One of a structure holds earlier structures.
    fn declared(&self, dice: &mut Dice, name: &str, structure: usize) -> Declared {
        let element = match dice.below(7) {
            0 => Ty::Bool,
            1 => Ty::Int,
            2 => Ty::Range(-1, 4),
            3 => Ty::Phase,
            4 if structure > ITEM => Ty::Structure(dice.below(structure)),
            5 => Ty::Ton,
            6 => Ty::Acc,
            _ => Ty::Alias(0),
        };
        let ty = if dice.one_in(2) {
            array(dice, element)
        } else {
            element
        };
        Declared {
            name: name.to_owned(),
            initial: self.some_initial(dice, &ty, 2),
            ty,
        }
    }

    /// It with another type: other bounds, or any.
    fn retyped(&self, dice: &mut Dice, name: &str, ty: &Ty, structure: usize) -> Declared {
        match ty {
            Ty::Array(dimensions, element) if dice.one_in(2) => {
                let dimensions = dimensions.iter().map(|_| bounds(dice)).collect();
                Declared::new(name, Ty::Array(dimensions, element.clone()))
            }
            _ => self.declared(dice, name, structure),
        }
    }

    /// Without initial values and rungs that do not fit.
    fn without_misfits(mut self) -> Typed {
        let copy = self.clone();
        let clean = |declared: &mut Declared| {
            let fits = |initial: &_| copy.is_initial(&declared.ty, initial);
            declared.initial = declared.initial.take().filter(fits);
        };
        let values = self.phase.values.clone();
        let is_value = |name: &String| values.iter().any(|(value, _)| value == name);
        self.phase.initial = self.phase.initial.take().filter(is_value);
        self.aliases.iter_mut().for_each(clean);
        let members = self.structures.iter_mut();
        members
            .flat_map(|structure| structure.members.iter_mut())
            .for_each(clean);
        self.tags.iter_mut().for_each(clean);
        let fits = |rung: &Rung| copy.fits(&rung.act);
        self.rungs.retain(fits);
        self
    }
}

/// Whether `$Poke` uses a member.
fn is_poked(structure: usize, member: &Declared) -> bool {
    structure == CELL && POKED.contains(&member.name.as_str())
}
