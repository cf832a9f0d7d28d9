//! Whether the operands of a block are what an instruction takes. A block that is not known is only then taken for a misspelt one.

use crate::networks::BlockAt;
use crate::values::literal::Literal;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Direction, Instruction, Operand};

/// Whether an instruction takes the operands of a block as they are: so many, each of its kind, and by these names.
pub(crate) fn fits(bound: BlockAt<'_>, row: &Instruction) -> bool {
    let mut by_place = 0;
    let fit = bound.facts.operands.iter().all(|operand| {
        let formal = match operand.name() {
            Some(name) => row.named(&name.text),
            None => {
                by_place += 1;
                row.positional(by_place - 1)
            }
        };
        formal.is_some_and(|formal| may_be(formal, &operand.value))
    });
    fit && row.takes(by_place)
}

fn may_be(formal: &Operand, value: &Node) -> bool {
    match &value.kind {
        NodeKind::Literal(literal) => {
            formal.direction == Direction::In
                && literal
                    .as_ref()
                    .as_ref()
                    .is_ok_and(|it| takes(formal.accepts, it))
        }
        NodeKind::Name(_) | NodeKind::Address(_) | NodeKind::Member(..) | NodeKind::Index(..) => true,
        NodeKind::Range(..) => matches!(
            formal.accepts,
            Accepts::BoolOrRange | Accepts::BoolRangeOrState | Accepts::Range | Accepts::RangeOrValue
        ),
        NodeKind::Unary(..) | NodeKind::Binary(..) | NodeKind::Paren(_) | NodeKind::Call(..) => {
            formal.accepts == Accepts::Expression
        }
        NodeKind::Array(_)
        | NodeKind::Members(_)
        | NodeKind::Repeat(..)
        | NodeKind::NoFunction
        | NodeKind::Missing => false,
    }
}

fn takes(accepts: Accepts, literal: &Literal) -> bool {
    let literal = match literal {
        Literal::Typed(_, value) => value,
        other => other,
    };
    match accepts {
        Accepts::Bool | Accepts::BoolOrRange | Accepts::BoolRangeOrState => {
            matches!(literal, Literal::Bool(_))
        }
        // A plain number is so many milliseconds here, and seconds or tenths of them elsewhere.
        Accepts::Duration | Accepts::Time => matches!(literal, Literal::Time(_)),
        Accepts::Integer | Accepts::Count | Accepts::Wrapped => matches!(literal, Literal::Int(_)),
        Accepts::Number => matches!(literal, Literal::Int(_) | Literal::Real(_)),
        Accepts::String => matches!(literal, Literal::Text(_)),
        Accepts::Value
        | Accepts::Compared
        | Accepts::Convertible
        | Accepts::Expression
        | Accepts::RangeOrValue => true,
        Accepts::State(_)
        | Accepts::TimerOrCounter
        | Accepts::Result(_)
        | Accepts::Range
        | Accepts::Label
        | Accepts::Function
        | Accepts::SearchOperator
        | Accepts::Tag => false,
    }
}
