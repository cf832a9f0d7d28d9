//! What the rules about the blocks, wires and power of a network see of the rest of the file: what its tags are, and the
//! program's settings. That is what the stamp of a network (`checking/stamp.rs`) stands for, so that what these rules find can be
//! kept with the network.

use crate::boolean::written;
use crate::names::context::Context;
use crate::names::operand_value::{self, Number};
use crate::networks::{BlockAt, NetworkAt};
use crate::values::types::Scalar;
use crate::written::facts::Node;
use crate::written::user_block::Parameter;
use ladder_instructions::Profile;
use ladder_syntax::{TextRange, TextSize};

/// The tags that a network names.
#[derive(Clone, Copy)]
pub(super) struct TagsShown<'c> {
    context: &'c Context,
    network: NetworkAt<'c>,
}

impl<'c> TagsShown<'c> {
    pub(super) fn of(context: &'c Context, network: NetworkAt<'c>) -> TagsShown<'c> {
        TagsShown { context, network }
    }

    /// The number that an operand is, if it is known.
    pub(super) fn number(&self, node: &Node) -> Option<Number> {
        operand_value::number(self.context, self.network.scope, node)
    }

    /// The type of an operand, if it is known.
    pub(super) fn scalar(&self, node: &Node) -> Option<Scalar> {
        operand_value::scalar(self.context, self.network.scope, node)
    }

    pub(super) fn is_real(&self, node: &Node) -> bool {
        operand_value::is_real(self.context, self.network.scope, node)
    }

    /// An operand as messages write it.
    pub(super) fn written(&self, node: &Node) -> String {
        written::written(self.context, self.network.scope, node)
    }

    /// A block as messages write it.
    pub(super) fn written_block(&self, bound: BlockAt<'_>) -> String {
        written::written_block(self.context, self.network.scope, bound)
    }

    /// The parameters of a user-defined block that the network holds.
    pub(super) fn parameters(&self, block: usize) -> &'c [Parameter] {
        &self.context.user_blocks[block].parameters
    }

    /// Where a part of a rung of the network is.
    pub(super) fn part_range(&self, rung: usize, part: usize) -> TextRange {
        self.network.part_range(&self.context.parse, rung, part)
    }

    /// Where the line of a rung of the network begins, and its text.
    pub(super) fn line_of(&self, rung: usize) -> (TextSize, &'c str) {
        let (parse, line) = (&self.context.parse, self.network.line(rung));
        (parse.line_start(line), parse.lines()[line].text())
    }

    pub(super) fn profile(&self) -> Profile {
        self.context.profile
    }
}
