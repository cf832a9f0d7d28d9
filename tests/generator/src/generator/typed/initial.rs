//! Initial values, nested as their types are.

use super::{Dice, Initial, Ty, Typed};

impl Typed {
    /// Adds initial values to some of what is declared.
    pub(super) fn give_initial_values(&mut self, dice: &mut Dice) {
        if dice.one_in(2) {
            let values = &self.phase.values;
            self.phase.initial = Some(values[dice.below(values.len())].0.clone());
        }
        for at in 0..self.aliases.len() {
            self.aliases[at].initial = self.some_initial(dice, &self.aliases[at].ty, 2);
        }
        for structure in 0..self.structures.len() {
            for at in 0..self.structures[structure].members.len() {
                let ty = &self.structures[structure].members[at].ty;
                let initial = self.some_initial(dice, ty, 3);
                self.structures[structure].members[at].initial = initial;
            }
        }
        for at in 0..self.tags.len() {
            self.tags[at].initial = self.some_initial(dice, &self.tags[at].ty, 3);
        }
    }

    /// An initial value of a type, once in `n` times.
    pub(super) fn some_initial(&self, dice: &mut Dice, ty: &Ty, n: usize) -> Option<Initial> {
        dice.one_in(n).then(|| self.initial(dice, ty)).flatten()
    }

    fn initial(&self, dice: &mut Dice, ty: &Ty) -> Option<Initial> {
        Some(match ty {
            Ty::Bool => Initial::Number(dice.between(0, 1)),
            Ty::Int => Initial::Number(dice.between(-9, 9)),
            Ty::Range(low, high) => Initial::Number(dice.between(*low, *high)),
            Ty::Phase => {
                let values = &self.phase.values;
                Initial::Value(values[dice.below(values.len())].0.clone())
            }
            Ty::Structure(number) => {
                let mut members = Vec::new();
                for member in &self.structures[*number].members {
                    if let Some(value) = self.some_initial(dice, &member.ty, 2) {
                        members.push((member.name.clone(), value));
                    }
                }
                dice.shuffle(&mut members);
                return (!members.is_empty()).then_some(Initial::Members(members));
            }
            Ty::Alias(number) => return self.initial(dice, &self.aliases[*number].ty),
            Ty::Array(_, element) if self.is_state(element) => return None,
            Ty::Array(dimensions, element) => {
                let mut rest: i64 = dimensions.iter().map(|(first, last)| last - first + 1).product();
                let mut elements = Vec::new();
                while rest > 0 && (elements.is_empty() || !dice.one_in(4)) {
                    let count = dice.between(1, rest.min(3));
                    elements.push((count, self.some_initial(dice, element, 2)));
                    rest -= count;
                }
                Initial::Elements(elements)
            }
            Ty::Ton | Ty::Ctu | Ty::Acc => return None,
        })
    }

    /// Whether an initial value is still one of its type.
    pub(super) fn is_initial(&self, ty: &Ty, initial: &Initial) -> bool {
        match (self.real(ty), initial) {
            (Ty::Bool, Initial::Number(number)) => matches!(number, 0 | 1),
            (Ty::Int, Initial::Number(_)) => true,
            (Ty::Range(low, high), Initial::Number(number)) => (low..=high).contains(number),
            (Ty::Phase, Initial::Value(name)) => self.phase.values.iter().any(|(value, _)| value == name),
            (Ty::Structure(number), Initial::Members(members)) => members.iter().all(|(name, initial)| {
                let member = self.member(number, name);
                member.is_some_and(|(_, member)| self.is_initial(&member.ty, initial))
            }),
            (Ty::Array(dimensions, element), Initial::Elements(elements)) => {
                let count: i64 = elements.iter().map(|(count, _)| count).sum();
                let size: i64 = dimensions.iter().map(|(first, last)| last - first + 1).product();
                count <= size
                    && !self.is_state(&element)
                    && (elements.iter().filter_map(|(_, initial)| initial.as_ref()))
                        .all(|initial| self.is_initial(&element, initial))
            }
            _ => false,
        }
    }

    fn is_state(&self, ty: &Ty) -> bool {
        matches!(self.real(ty), Ty::Ton | Ty::Ctu | Ty::Acc)
    }
}
