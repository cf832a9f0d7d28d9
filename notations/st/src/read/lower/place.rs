//! Tags and their parts.

use super::super::dialect::Dialect;
use super::super::scope::{Type, elementary};
use super::super::tree::{ExpressionKind, LiteralKind, Place, Step};
use super::literal::number_of;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Expression, Path};

impl Lowering<'_, '_> {
    /// What a place is that goes through an in-out of an instance: the tag that its calls hand over, where all hand over the same.
    pub(super) fn handed_over(&self, place: &Place) -> Option<Place> {
        let ([Step::Member(member), rest @ ..], Dialect::Iec | Dialect::Codesys) =
            (&place.steps[..], self.around.dialect)
        else {
            return None;
        };
        let handed = self.uses.handed_over(&place.root, member)?;
        let mut handed = handed.clone();
        handed.steps.extend(rest.iter().cloned());
        Some(handed)
    }

    /// Whether a place is inside of the state of a block.
    pub(super) fn is_in_instance(&self, place: &Place) -> bool {
        let scope = self.around.scope;
        let mut steps = place.steps.iter();
        let known = scope.known(&place.root).or_else(|| match steps.next() {
            Some(Step::Member(name)) => scope.known(name),
            _ => None,
        });
        let mut ty = known.map(|known| known.ty.clone());
        for step in steps {
            ty = match (ty, step) {
                (Some(Type::Block(_)), _) => return true,
                (Some(ty), Step::Member(name)) => ty.member(name).map(|(_, ty)| ty),
                (Some(Type::Array(_, inner)), Step::Index(_)) => Some(*inner),
                _ => return false,
            };
        }
        false
    }

    /// Where a tag or a part of one is, and its type.
    pub(super) fn path(&mut self, place: &Place) -> Lowered<(Path, Type)> {
        if let Some(handed) = self.handed_over(place) {
            return self.path(&handed);
        }
        if let Some(what) = place.steps.iter().find_map(|step| match step {
            Step::Other(what) => Some(*what),
            _ => None,
        }) {
            return Err(format!(
                "{what} works on memory by address, which ladder text does not have"
            ));
        }
        if let [Step::Member(member)] = &place.steps[..]
            && let Some(found) = self.around.scope.of_step(&place.root, member)
        {
            return Ok(found);
        }
        let (name, rest) = place.written();
        if let (Some(known), true) = (self.around.scope.known(&name), rest.len() < place.steps.len()) {
            let (mut path, mut ty) = (known.path.clone(), known.ty.clone());
            for step in rest {
                (path, ty) = self.step(path, ty, step)?;
            }
            return Ok((path, ty));
        }
        let (mut path, mut ty) = self.root(place)?;
        let mut steps = place.steps.iter();
        // A list of globals in CODESYS, a program in TIA: its name is before that of the tag.
        if self.around.scope.known(&place.root).is_none()
            && matches!(ty, Type::Unknown)
            && let Some(Step::Member(name)) = steps.next()
        {
            let known = self
                .around
                .scope
                .known(name)
                .ok_or_else(|| unknown(&place.root))?;
            (path, ty) = (known.path.clone(), known.ty.clone());
        }
        for step in steps {
            (path, ty) = self.step(path, ty, step)?;
        }
        Ok((path, ty))
    }

    /// The word and the number of a bit whose number is computed. None: it is not such a bit.
    pub(super) fn computed_bit(&mut self, place: &Place) -> Lowered<Option<(Path, Expression)>> {
        let [before @ .., Step::ComputedBit(index)] = &place.steps[..] else {
            return Ok(None);
        };
        let word = Place {
            steps: before.to_vec(),
            ..place.clone()
        };
        let (path, ty) = self.path(&word)?;
        if !ty.scalar().is_some_and(|ty| ty.is_integer() || ty.is_bits()) {
            return Err(format!("`{path}` has no bits"));
        }
        let index = self.value(index)?;
        if !index.is_integer() {
            return Err(format!("the number of a bit of `{path}` is not a whole number"));
        }
        Ok(Some((path, index.expression)))
    }

    fn root(&self, place: &Place) -> Lowered<(Path, Type)> {
        if place.root.starts_with('%') {
            let address = address(&place.root)
                .ok_or_else(|| format!("`{}` is not an address that is read", place.root))?;
            let ty = match address.as_bytes()[2] {
                b'X' => Scalar::Bool,
                b'B' => Scalar::Byte,
                b'W' => Scalar::Word,
                b'D' => Scalar::Dword,
                _ => Scalar::Lword,
            };
            return Ok((Path::tag(address), Type::Scalar(ty)));
        }
        if let Some(known) = self.around.scope.known(&place.root) {
            return Ok((known.path.clone(), known.ty.clone()));
        }
        if let [Step::Member(value)] = &place.steps[..]
            && let Some(Type::Enumeration(all)) = self.around.scope.type_named(&place.root)
            && let Some(value) = all.values.iter().find(|own| own.eq_ignore_ascii_case(value))
        {
            // The step that follows names the value; it is part of the path already.
            return Ok((
                Path::tag(all.name.clone()).member(value.clone()),
                Type::Enumeration(all.clone()),
            ));
        }
        if place.steps.is_empty() {
            return self
                .around
                .scope
                .value(&place.root)
                .ok_or_else(|| unknown(&place.root));
        }
        Ok((Path::tag(place.root.clone()), Type::Unknown))
    }

    fn step(&mut self, path: Path, ty: Type, step: &Step) -> Lowered<(Path, Type)> {
        match step {
            Step::Member(name) => {
                if let Type::Trigger(_) = ty {
                    return if name.eq_ignore_ascii_case("Q") {
                        Ok((path, Type::BOOL))
                    } else {
                        Err(format!("`{name}` of an edge detector is not kept here"))
                    };
                }
                // A value of an enumeration, which the path has already.
                if let Type::Enumeration(all) = &ty
                    && path.root == all.name
                {
                    return Ok((path, ty));
                }
                // An input of a timer that is written as a member is a tag beside it.
                if let (Type::Standard(_), Some(whole)) = (&ty, path.whole())
                    && self.uses.writes_member(whole, name)
                    && let Some((member, Type::Scalar(of))) = ty.member(name)
                {
                    return Ok((self.beside(&path, &member, of)?, Type::Scalar(of)));
                }
                let (member, of) = ty
                    .member(name)
                    .ok_or_else(|| format!("`{path}` has no member `{name}` that is read"))?;
                Ok((path.member(member), of))
            }
            Step::Bit(bit) => match ty.scalar() {
                Some(scalar) if (scalar.is_integer() || scalar.is_bits()) && *bit < scalar.width() => {
                    Ok((path.bit(*bit), Type::BOOL))
                }
                _ => Err(format!("`{path}` has no bit {bit}")),
            },
            Step::Index(indices) => {
                let mut ty = ty;
                let mut all = Vec::new();
                let Type::Array(bounds, of) = ty else {
                    return Err(format!("`{path}` is not an array"));
                };
                if bounds.len() != indices.len() {
                    return Err(format!("`{path}` has {} dimensions", bounds.len()));
                }
                for index in indices {
                    let value = self.value(index)?;
                    let is_index = value.scalar().is_some_and(|ty| ty.is_integer() || ty.is_bits());
                    if !is_index {
                        return Err(format!("an index of `{path}` is not a whole number"));
                    }
                    all.push(value.bare().clone());
                }
                ty = *of;
                Ok((path.index(all), ty))
            }
            Step::ComputedBit(_) => Err("a bit whose number is computed has no counterpart here".to_owned()),
            Step::Part(..) => Err("a part of a word is not used so here".to_owned()),
            Step::Other(what) => Err(format!("{what} has no counterpart here")),
        }
    }
}

fn unknown(name: &str) -> String {
    format!("`{name}` is not declared here")
}

/// Whether the place of a part depends on values: it may be outside of its array.
pub(super) fn is_computed(path: &Path) -> bool {
    path.indices()
        .any(|index| !matches!(index, Expression::Literal(_)))
}

/// The same of a place of the other system.
pub(super) fn has_computed_index(place: &Place) -> bool {
    place.steps.iter().any(|step| match step {
        Step::Index(indices) => indices.iter().any(|index| {
            !matches!(&index.kind, ExpressionKind::Literal(LiteralKind::Integer, text) if number_of(text).is_some())
        }),
        _ => false,
    })
}

/// An address as ladder text has it: `%IX0.3`. None: it has more levels than there are here, or none.
pub(crate) fn address(text: &str) -> Option<String> {
    let upper = text.to_ascii_uppercase();
    let rest = upper.strip_prefix('%')?;
    let area = rest.chars().next().filter(|area| "IQM".contains(*area))?;
    let rest = &rest[1..];
    let (size, number) = match rest.chars().next()? {
        size @ ('X' | 'B' | 'W' | 'D' | 'L') => (size, &rest[1..]),
        _ => ('X', rest),
    };
    let levels: Option<Vec<u32>> = number.split('.').map(|level| level.parse().ok()).collect();
    match (size, &levels?[..]) {
        ('X', [byte, bit]) if *bit < 8 => Some(format!("%{area}X{byte}.{bit}")),
        ('X', _) => None,
        (_, [at]) => Some(format!("%{area}{size}{at}")),
        _ => None,
    }
}

/// The type of a name, for conversions: `INT` of `INT_TO_REAL`.
pub(super) fn converted(name: &str) -> Option<Scalar> {
    elementary(name).filter(|ty| !matches!(ty, Scalar::Enum(_)))
}
