//! Parts of words: `w.%B1`, `w.%W0`.

use super::super::tree::{Expression as Tree, Place, Step};
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Expression, Literal, Operator, Path};

/// A part of a word.
pub(super) struct Part {
    word: Path,
    /// What the word is, and the bits that it has.
    own: Scalar,
    bits: Scalar,
    size: Scalar,
    /// The number of its lowest bit.
    first: u32,
}

/// The bit string of so many bits.
pub(in super::super) fn bits_of(bits: u32) -> Option<Scalar> {
    Some(match bits {
        8 => Scalar::Byte,
        16 => Scalar::Word,
        32 => Scalar::Dword,
        64 => Scalar::Lword,
        _ => return None,
    })
}

impl Lowering<'_, '_> {
    /// The part that a place is. None: it is not one.
    pub(super) fn part(&mut self, place: &Place) -> Lowered<Option<Part>> {
        let [before @ .., Step::Part(size, number)] = &place.steps[..] else {
            return Ok(None);
        };
        let word = Place {
            steps: before.to_vec(),
            ..place.clone()
        };
        let (word, ty) = self.path(&word)?;
        let own = ty.scalar().filter(|ty| ty.is_integer() || ty.is_bits());
        let own = own.ok_or_else(|| format!("`{word}` has no parts of bits"))?;
        let first = u64::from(*size) * u64::from(*number);
        let (Some(bits), Some(size_here)) = (bits_of(own.width()), bits_of(*size)) else {
            return Err(format!("`{word}` has no parts of bits"));
        };
        if first + u64::from(*size) > u64::from(own.width()) {
            return Err(format!("`{word}` does not have so many parts"));
        }
        Ok(Some(Part {
            word,
            own,
            bits,
            size: size_here,
            first: first as u32,
        }))
    }

    /// The bits of the whole word.
    fn bits(&mut self, part: &Part) -> Lowered<Value> {
        if part.own == part.bits {
            return Ok(Value::path(part.word.clone(), part.bits));
        }
        self.made_by("WRAP", part.bits, vec![part.word.clone().into()])
    }

    pub(super) fn value_of_part(&mut self, part: &Part) -> Lowered<Value> {
        let mut value = self.bits(part)?;
        if part.first > 0 {
            let places = Literal::from(i64::from(part.first)).into();
            value = self.made_by("SHR", part.bits, vec![value.expression, places])?;
        }
        if part.bits == part.size {
            return Ok(value);
        }
        self.made_by("WRAP", part.size, vec![value.expression])
    }

    /// `w.%B1 := value`: the other bits stay.
    pub(super) fn assign_part(&mut self, part: &Part, place: &Place, tree: &Tree) -> Lowered<()> {
        let before = place.steps.len() - 1;
        self.target(&Place {
            steps: place.steps[..before].to_vec(),
            ..place.clone()
        })?;
        let value = self.value(tree)?;
        let mut value = self.settled(value, part.size)?;
        if part.bits != part.size {
            value = self.made_by("WRAP", part.bits, vec![value.expression])?;
        }
        if part.first > 0 {
            let places = Literal::from(i64::from(part.first)).into();
            value = self.made_by("SHL", part.bits, vec![value.expression, places])?;
        }
        let bits = self.bits(part)?;
        let all = u64::MAX >> (64 - part.bits.width());
        let own = (u64::MAX >> (64 - part.size.width())) << part.first;
        let others = Literal::read(format!("16#{:X}", all & !own)).map_err(|error| error.to_string())?;
        let kept = bits.expression.with(Operator::And, Expression::from(others));
        let whole = kept.with(Operator::Or, value.expression);
        if part.own == part.bits {
            self.instruction("CALC", vec![(&part.word).into(), whole.into()])?;
        } else {
            let whole = self.made_by("CALC", part.bits, vec![whole])?;
            self.instruction("WRAP", vec![(&part.word).into(), whole.expression.into()])?;
        }
        self.flush();
        Ok(())
    }
}
