//! `[SEARCH]` with NEXT: -1 in y must mean that nothing was found, so no element may have that index.

use super::Resolver;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::rules::bad_operand;
use crate::written::facts::NodeKind;

impl Resolver<'_, '_> {
    /// Says where NEXT is given for an array that begins below 0.
    pub(super) fn check_search(&mut self, bound: BlockAt<'_>) {
        let operands = || bound.facts.operands.iter().zip(bound.formals.iter());
        let next = operands()
            .find(|(_, formal)| matches!(formal, Formal::Operand(operand) if operand.name == "NEXT"));
        let Some((next, _)) = next else { return };
        let Some((searched, _)) = operands().nth(3) else {
            return;
        };
        let array = match &searched.value.kind {
            NodeKind::Range(base, ..) => base,
            _ => &searched.value,
        };
        let Some((ty, given)) = self.part_type(array) else {
            return;
        };
        let Some((dimensions, _)) = ty.array() else { return };
        // Several dimensions without an index are counted from 0.
        if let [(first, _)] = dimensions[given..]
            && first < 0
        {
            let name = self.text_of(array);
            self.report(bad_operand::next_below_zero(
                &name,
                first,
                bound.absolute(next.range),
            ));
        }
    }
}
