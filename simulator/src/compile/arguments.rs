//! What a block is given, by place and by name.

use super::Result;
use crate::compile_error::CompileError;
use ladder_analysis::program::{Argument, Block, Bound, Expr, Place, RangeRef, TagId};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Op, Presence};

/// The arguments of one block.
#[derive(Clone, Copy)]
pub(super) struct Arguments<'b> {
    pub(super) block: &'b Block,
}

impl<'b> Arguments<'b> {
    pub(super) fn of(block: &'b Block) -> Self {
        Arguments { block }
    }

    fn is_named(bound: &Bound) -> bool {
        bound
            .operand
            .is_some_and(|operand| operand.presence == Presence::Named)
    }

    /// Those given by place.
    pub(super) fn by_place(self) -> impl Iterator<Item = &'b Argument> {
        let positional = self.block.arguments.iter().filter(|bound| !Self::is_named(bound));
        positional.map(|bound| &bound.argument)
    }

    pub(super) fn get(self, n: usize) -> Result<&'b Argument> {
        self.by_place().nth(n).ok_or_else(|| self.mismatch())
    }

    /// Whether the first is a whole structure or array.
    pub(super) fn are_parts(self) -> bool {
        matches!(self.get(0), Ok(Argument::Parts(_)))
    }

    /// The one given under a name.
    pub(super) fn named(self, name: &str) -> Option<&'b Argument> {
        let mut named = self.block.arguments.iter().filter(|bound| Self::is_named(bound));
        named
            .find(|bound| bound.operand.is_some_and(|operand| operand.name == name))
            .map(|bound| &bound.argument)
    }

    pub(super) fn value(self, n: usize) -> Result<&'b Expr> {
        self.as_value(self.get(n)?)
    }

    /// The values from the n-th on.
    pub(super) fn values_from(self, n: usize) -> Result<Vec<&'b Expr>> {
        self.by_place()
            .skip(n)
            .map(|argument| self.as_value(argument))
            .collect()
    }

    pub(super) fn as_value(self, argument: &'b Argument) -> Result<&'b Expr> {
        match argument {
            Argument::Value(value) => Ok(value),
            _ => Err(self.mismatch()),
        }
    }

    pub(super) fn named_value(self, name: &str) -> Result<Option<&'b Expr>> {
        self.named(name)
            .map(|argument| self.as_value(argument))
            .transpose()
    }

    /// The type of a block's value before it is brought to that of its result.
    pub(super) fn formula_type(self, op: Op, result: Scalar) -> Scalar {
        match self.value(1) {
            Ok(formula) if op == Op::Calc => formula.ty,
            _ => result,
        }
    }

    pub(super) fn place(self, n: usize) -> Result<(&'b Place, Scalar)> {
        self.as_place(self.get(n)?)
    }

    pub(super) fn as_place(self, argument: &'b Argument) -> Result<(&'b Place, Scalar)> {
        match argument {
            Argument::Place(place, ty) => Ok((place, *ty)),
            _ => Err(self.mismatch()),
        }
    }

    pub(super) fn range(self, n: usize) -> Result<&'b RangeRef> {
        match self.get(n)? {
            Argument::Range(range) => Ok(range),
            _ => Err(self.mismatch()),
        }
    }

    pub(super) fn state(self, n: usize) -> Result<TagId> {
        match self.get(n)? {
            Argument::State(tag) => Ok(*tag),
            Argument::ChosenState(_) => Err(self.refused(
                "in the profile of its file part of what a timer or counter remembers belongs to the place of its block: a computed \
                 index cannot choose one, write a number"
                    .into(),
            )),
            _ => Err(self.mismatch()),
        }
    }

    /// These operands cannot be put to work.
    pub(super) fn refused(self, message: String) -> CompileError {
        CompileError {
            message,
            location: self.block.location,
        }
    }

    /// The file's profile has no such block.
    pub(super) fn not_in_profile(self) -> CompileError {
        self.refused("this block is not there in the profile of its file".into())
    }

    /// The model does not hold what the block's row asks for: an error in the analysis, not in the program.
    pub(super) fn mismatch(self) -> CompileError {
        CompileError {
            message: "the simulator cannot make sense of this block's operands; please report the program"
                .into(),
            location: self.block.location,
        }
    }
}
