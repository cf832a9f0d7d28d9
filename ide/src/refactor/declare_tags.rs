//! All tags that no declaration names get one, with the types and sections that follow from their uses.

use super::place::Selected;
use super::{Action, ActionKind, Work};
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::rules::declaration_fix::{can_be_declared, undeclared};
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_format::Edit;
use ladder_syntax::Name;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let context = place.context;
    let Some(scope) = place
        .networks
        .clone()
        .next()
        .map(|network| context.networks.at(network).scope)
    else {
        return;
    };
    let networks = context.networks.range(place.networks.clone());
    let mut blocks = networks.flat_map(NetworkAt::blocks).filter(|block| {
        let at = block.range();
        at.start() <= place.range.end() && place.range.start() <= at.end()
    });
    let needs_one = blocks.any(|block| {
        let mut operands = block.facts.operands.iter();
        operands.any(|operand| names_undeclared(context, scope, &operand.value))
    });
    let open = context
        .parse
        .structure()
        .sections
        .iter()
        .any(|section| !section.closed);
    if !needs_one || open {
        return;
    }
    let title = match scope {
        0 => "Declare the undeclared tags of the file",
        _ => "Declare the undeclared tags of the block",
    };
    out.push(Action::later(
        ActionKind::Rewrite,
        title,
        Work::Declarations(scope),
    ));
}

/// The declarations. A walk over all tags of a file takes time.
pub(super) fn edits(context: &Context, scope: usize) -> Vec<Edit> {
    let tags: Vec<_> = undeclared(context, scope)
        .into_iter()
        .map(|declared| (declared.section, declared.name, declared.ty))
        .collect();
    let places = Places::new(context, scope);
    places.declare_all(&tags).unwrap_or_default()
}

fn names_undeclared(context: &Context, scope: usize, node: &Node) -> bool {
    let any = |nodes: &[&Node]| nodes.iter().any(|node| names_undeclared(context, scope, node));
    match &node.kind {
        NodeKind::Name(name) => {
            let tag = context.scopes[scope].find(&Name::new(name));
            tag.is_some_and(|tag| can_be_declared(context, scope, tag))
        }
        NodeKind::Member(base, _) | NodeKind::Unary(_, base) | NodeKind::Paren(base) => any(&[base]),
        NodeKind::Index(base, index) => any(&[base, index]),
        NodeKind::Range(base, first, last) => any(&[base, first, last]),
        NodeKind::Binary(_, left, right) => any(&[left, right]),
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            values.iter().any(|value| names_undeclared(context, scope, value))
        }
        NodeKind::Address(_)
        | NodeKind::Members(_)
        | NodeKind::Literal(_)
        | NodeKind::NoFunction
        | NodeKind::Missing => false,
    }
}
