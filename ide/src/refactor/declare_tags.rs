//! All tags that no declaration names get one, with the types and sections that follow from their uses.

use super::names::each_name;
use super::place::Selected;
use super::{Action, ActionKind, Work};
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::rules::declaration_fix::{can_be_declared, undeclared};
use ladder_analysis::written::facts::Node;
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
    let mut found = false;
    each_name(node, &mut |name, _| {
        let tag = context.scopes[scope].find(&Name::new(name));
        found |= tag.is_some_and(|tag| can_be_declared(context, scope, tag));
    });
    found
}
