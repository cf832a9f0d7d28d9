//! The parts of tags, and what types they have.

use super::acts::index;
use super::{Declared, Dice, Index, Path, Span, Step, Ty, Typed};

/// An array: where it is, its dimensions, the type of an element.
type ArrayOf = (Path, Vec<(i64, i64)>, Ty);

impl Typed {
    /// A type without other names for it.
    pub fn real(&self, ty: &Ty) -> Ty {
        match ty {
            Ty::Alias(number) => self.real(&self.aliases[*number].ty),
            Ty::Array(dimensions, element) => Ty::Array(dimensions.clone(), Box::new(self.real(element))),
            other => other.clone(),
        }
    }

    /// A type that may hold other names for types, but is none.
    pub fn unnamed<'t>(&'t self, ty: &'t Ty) -> &'t Ty {
        match ty {
            Ty::Alias(number) => self.unnamed(&self.aliases[*number].ty),
            other => other,
        }
    }

    /// A tag by its name.
    pub fn tag(&self, name: &str) -> Option<(usize, &Declared)> {
        (self.tags.iter().enumerate()).find(|(_, tag)| tag.name == name)
    }

    /// A member of a structure by its name.
    pub fn member(&self, structure: usize, name: &str) -> Option<(usize, &Declared)> {
        let members = self.structures[structure].members.iter().enumerate();
        members.into_iter().find(|(_, member)| member.name == name)
    }

    /// All parts of tags: their types, with every index a place to fill.
    fn parts(&self) -> Vec<(Path, Ty)> {
        let mut parts = Vec::new();
        for tag in &self.tags {
            let path = Path {
                tag: tag.name.clone(),
                steps: Vec::new(),
            };
            self.add_parts(path, &self.real(&tag.ty), &mut parts);
        }
        parts
    }

    fn add_parts(&self, path: Path, ty: &Ty, parts: &mut Vec<(Path, Ty)>) {
        parts.push((path.clone(), ty.clone()));
        let with = |step: Step| {
            let mut path = path.clone();
            path.steps.push(step);
            path
        };
        match ty {
            Ty::Structure(number) => {
                for member in &self.structures[*number].members {
                    let path = with(Step::Member(member.name.clone()));
                    self.add_parts(path, &self.real(&member.ty), parts);
                }
            }
            Ty::Array(dimensions, element) => {
                let firsts = dimensions.iter().map(|(first, _)| Index::Number(*first));
                self.add_parts(with(Step::Element(firsts.collect())), element, parts);
            }
            _ => {}
        }
    }

    /// The type of a part; none if there is no such part.
    pub(super) fn type_of(&self, path: &Path) -> Option<Ty> {
        let (_, tag) = self.tag(&path.tag)?;
        let mut ty = self.real(&tag.ty);
        for step in &path.steps {
            ty = match (step, ty) {
                (Step::Member(name), Ty::Structure(number)) => self.real(&self.member(number, name)?.1.ty),
                (Step::Element(indices), Ty::Array(dimensions, element)) => (dimensions.len()
                    == indices.len()
                    && indices.iter().zip(&dimensions).all(|it| is_within(*it.0, *it.1)))
                .then_some(*element)?,
                _ => return None,
            };
        }
        Some(ty)
    }

    /// The type of the elements of a span; none if there is no such span.
    pub(super) fn element_of(&self, span: &Span) -> Option<Ty> {
        let (others, first, last) = &span.indices;
        let Ty::Array(dimensions, element) = self.type_of(&span.array)? else {
            return None;
        };
        let (end, outer) = dimensions.split_last()?;
        let is_there = outer.len() == others.len()
            && others.iter().zip(outer).all(|it| is_within(*it.0, *it.1))
            && is_within(*first, *end)
            && is_within(*last, *end)
            && !self.keeps_state(&element)
            && !matches!(*element, Ty::Array(..));
        is_there.then_some(*element)
    }

    /// A part with other indices.
    fn with_indices(&self, dice: &mut Dice, mut path: Path) -> Path {
        for at in 0..path.steps.len() {
            let whole = Path {
                tag: path.tag.clone(),
                steps: path.steps[..at].to_vec(),
            };
            if let (Step::Element(indices), Some(Ty::Array(dimensions, _))) =
                (&mut path.steps[at], self.type_of(&whole))
            {
                *indices = dimensions.iter().map(|bounds| index(dice, *bounds)).collect();
            }
        }
        path
    }

    /// A part of a type.
    pub(super) fn path(&self, dice: &mut Dice, ty: &Ty) -> Option<Path> {
        let fits = |found: &Ty| found == ty || (*ty == Ty::Int && matches!(found, Ty::Range(..)));
        let mut parts = self.parts();
        parts.retain(|(_, found)| fits(found));
        let (path, _) = parts.get(dice.below(parts.len().max(1)))?;
        Some(self.with_indices(dice, path.clone()))
    }

    /// A type that is copied.
    pub(super) fn copied(&self, dice: &mut Dice) -> Option<Ty> {
        let mut types: Vec<Ty> = self.parts().into_iter().map(|(_, ty)| ty).collect();
        types.retain(|ty| !self.keeps_state(ty));
        types.get(dice.below(types.len().max(1))).cloned()
    }

    /// Whether a type holds the state of a timer, counter or block.
    pub(super) fn keeps_state(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Bool | Ty::Int | Ty::Range(..) | Ty::Phase => false,
            Ty::Ton | Ty::Ctu | Ty::Acc => true,
            Ty::Structure(number) => {
                let mut members = self.structures[*number].members.iter();
                members.any(|member| self.keeps_state(&member.ty))
            }
            Ty::Alias(number) => self.keeps_state(&self.aliases[*number].ty),
            Ty::Array(_, element) => self.keeps_state(element),
        }
    }

    /// An array of values or structures, perhaps of these. A range has no arrays for its elements.
    pub(super) fn array(&self, dice: &mut Dice, of: Option<&Ty>) -> Option<ArrayOf> {
        let mut arrays: Vec<ArrayOf> = Vec::new();
        for (path, ty) in self.parts() {
            if let Ty::Array(dimensions, element) = ty
                && !self.keeps_state(&element)
                && !matches!(*element, Ty::Array(..))
                && of.is_none_or(|of| *of == *element)
            {
                arrays.push((path, dimensions, *element));
            }
        }
        let (path, dimensions, element) = arrays.get(dice.below(arrays.len().max(1)))?.clone();
        Some((self.with_indices(dice, path), dimensions, element))
    }
}

/// Whether a number is an index of a dimension; what is computed may be one.
fn is_within(index: Index, (first, last): (i64, i64)) -> bool {
    match index {
        Index::Number(number) => (first..=last).contains(&number),
        Index::Input(..) => true,
    }
}
