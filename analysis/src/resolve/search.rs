//! `[SEARCH]` with NEXT: -1 in y must mean that nothing was found, so no element may have that index.

use super::Resolver;
use crate::networks::BlockAt;
use crate::networks::facts::NodeKind;
use crate::networks::network::Formal;
use crate::rules::bad_operand;
use crate::values::types::Type;

impl Resolver<'_, '_> {
    /// Says where NEXT is given for an array that begins below 0.
    pub(super) fn check_search(&mut self, bound: BlockAt<'_>) {
        let operands = || bound.facts.operands.iter().zip(bound.formals.iter());
        let next = operands()
            .find(|(_, formal)| matches!(formal, Formal::Operand(operand) if operand.name == "NEXT"));
        let Some((next, _)) = next else { return };
        let array = operands().find_map(|(written, _)| match &written.value.kind {
            NodeKind::Range(base, ..) => Some(base),
            _ => None,
        });
        if let Some(NodeKind::Name(name)) = array.map(|base| &base.kind)
            && let Some(tag) = array.and_then(|base| self.named_tag(base))
            && let Type::Array { first, .. } = self.tag_type(tag)
            && first < 0
        {
            self.report(bad_operand::next_below_zero(
                name,
                first,
                bound.absolute(next.range),
            ));
        }
    }
}
