//! Paths as they are written in text: `cell[2].zone[k].valve`, perhaps not finished.

use crate::hover::block_named;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::state_member;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_syntax::Name;
use std::ops::Range;

/// The tag of a name, or the one that it is an alias of.
pub(crate) fn tag_of<'c>(context: &'c Context, scope: usize, name: &str) -> Option<&'c TagFacts> {
    let scope = context.scopes.get(scope)?;
    let tag = &scope.tags[scope.find(&Name::new(name))?];
    Some(context.shared(tag))
}

/// What a path goes on with.
pub(crate) enum Step {
    /// `[k, 3]`: so many indices.
    Index(usize),
    /// `.valve`: where the word is.
    Member(Range<usize>),
}

/// What a path goes on with after its first word, which ends at `from`. None as the last: it is not one.
pub(crate) fn steps(text: &str, from: usize) -> impl Iterator<Item = Option<Step>> {
    let mut at = Some(from);
    std::iter::from_fn(move || {
        let from = at.take()?;
        let rest = text[from..].trim_start();
        let start = text.len() - rest.len();
        if let Some(inside) = rest.strip_prefix('[') {
            let Some((commas, end)) = index_end(inside) else {
                return Some(None);
            };
            at = Some(start + 1 + end + 1);
            return Some(Some(Step::Index(commas + 1)));
        }
        if let Some(after) = rest.strip_prefix('.') {
            let word = after.trim_start();
            let start = text.len() - word.len();
            let end = start + word.find(['[', '.']).unwrap_or(word.len());
            at = Some(end);
            let end = start + text[start..end].trim_end().len();
            return Some(Some(Step::Member(start..end)));
        }
        (!rest.is_empty()).then_some(None)
    })
}

/// What a path has come to: a type, and how many indices of it are given if it is an array.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reached {
    ty: Type,
    given: usize,
}

impl Reached {
    pub(crate) const fn new(ty: Type) -> Reached {
        Reached { ty, given: 0 }
    }

    /// With more indices.
    pub(crate) fn indexed(mut self, indices: usize) -> Option<Reached> {
        for _ in 0..indices {
            let (dimensions, element) = self.ty.array()?;
            self.given += 1;
            if self.given == dimensions.len() {
                self = Reached::new(element);
            }
        }
        Some(self)
    }

    /// The type. None: it is an array of which some indices are missing.
    pub(crate) fn whole(self) -> Option<Type> {
        (self.given == 0).then_some(self.ty)
    }
}

/// The type of what a path means. None: it means nothing, or an array of which some indices are missing.
pub(crate) fn type_of(context: &Context, scope: usize, text: &str) -> Option<Type> {
    let end = text.find(['[', '.']).unwrap_or(text.len());
    let root = tag_of(context, scope, text[..end].trim())?.ty?;
    let mut reached = Reached::new(root);
    for step in steps(text, end) {
        reached = match step? {
            Step::Index(indices) => reached.indexed(indices)?,
            Step::Member(word) => Reached::new(member_type(context, reached.whole()?, &text[word])?),
        };
    }
    reached.whole()
}

/// The type of a member.
pub(crate) fn member_type(context: &Context, ty: Type, member: &str) -> Option<Type> {
    match ty {
        Type::Scalar(scalar) => {
            (scalar.is_integer() || scalar.is_bits()).then_some(Type::Scalar(Scalar::Bool))
        }
        Type::State(state) => {
            let member = state_member(state, member)?;
            Some(Type::Scalar(member.ty(context.profile.semantics())))
        }
        Type::Compound(id) => id.with(|ty| match ty {
            Compound::Structure(structure) => structure.member(member).map(|(_, member)| member.ty),
            Compound::Block(block) => {
                let block = block_named(context, &Name::new(block))?;
                let key = Name::new(member);
                block.parameters.iter().find(|it| it.key == key)?.ty
            }
            Compound::Array(_) => None,
        }),
        Type::Array { .. } => None,
    }
}

/// How many commas are between the brackets of an index, and where the closing one is.
fn index_end(text: &str) -> Option<(usize, usize)> {
    let (mut open, mut commas) = (0u32, 0);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'[' | b'(' => open += 1,
            b']' if open == 0 => return Some((commas, at)),
            b']' | b')' => open = open.saturating_sub(1),
            b',' if open == 0 => commas += 1,
            _ => {}
        }
    }
    None
}
