//! Operands and blocks as sentences name them.

use crate::findings::excerpt::shortened;
use crate::names::context::Context;
use crate::names::operand_value::tag;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::values::literal::Literal;
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::Accepts;

/// A place, number or expression as it is written, laid out.
pub(crate) fn written(context: &Context, scope: usize, node: &Node) -> String {
    let inner = |node: &Node| written(context, scope, node);
    match &node.kind {
        NodeKind::Name(name) => match tag(context, scope, name) {
            Some((_, facts)) => facts.name.to_string(),
            None => name.to_string(),
        },
        NodeKind::Address(name) => name.to_string(),
        NodeKind::Member(base, word) => format!("{}.{}", inner(base), word.text),
        NodeKind::Index(base, index) => format!("{}[{}]", inner(base), inner(index)),
        NodeKind::Range(base, first, last) => format!("{}[{}..{}]", inner(base), inner(first), inner(last)),
        NodeKind::Paren(node) if matches!(node.kind, NodeKind::Binary(..)) => format!("({})", inner(node)),
        NodeKind::Paren(node) => inner(node),
        NodeKind::Unary(Operator::Not, node) => format!("NOT {}", inner(node)),
        NodeKind::Unary(_, node) => format!("-{}", inner(node)),
        NodeKind::Binary(operator, left, right) => {
            format!("{} {} {}", inner(left), operator.text(), inner(right))
        }
        NodeKind::Call(word, arguments) => {
            let arguments = arguments.iter().map(inner).collect::<Vec<_>>();
            format!("{}({})", word.text.to_uppercase(), arguments.join(", "))
        }
        _ => node.literal().map_or_else(|| "...".to_owned(), literal_text),
    }
}

/// A block with its operands, for a sentence: `[ ]( start )`. However it is laid out, it is the same text.
pub(crate) fn written_block(context: &Context, scope: usize, bound: BlockAt<'_>) -> String {
    let head = match bound.instruction() {
        Some(row) => row.block(),
        None => bound.head_text(),
    };
    let operands: Vec<String> = bound
        .facts
        .operands
        .iter()
        .zip(bound.formals.iter())
        .map(|(operand, formal)| match formal {
            // No name of a tag: the layout writes it in capitals.
            Formal::Operand(row) if row.accepts == Accepts::SearchOperator => {
                written(context, scope, &operand.value).to_ascii_uppercase()
            }
            _ => written(context, scope, &operand.value),
        })
        .collect();
    if operands.is_empty() {
        return head;
    }
    shortened(&format!("{head}( {} )", operands.join(", ")), 40)
}

fn literal_text(literal: &Literal) -> String {
    match literal {
        Literal::Bool(value) => if *value { "TRUE" } else { "FALSE" }.to_owned(),
        Literal::Int(n) => n.to_string(),
        Literal::Real(r) => format!("{r:?}"),
        Literal::Time(n) if n % 1_000_000_000 == 0 => format!("T#{}s", n / 1_000_000_000),
        Literal::Time(n) => format!("T#{}ms", *n as f64 / 1e6),
        Literal::Typed(_, inner) => literal_text(inner),
        Literal::Date(_) | Literal::Tod(_) | Literal::Dt(_) | Literal::Text(_) => "...".to_owned(),
    }
}
