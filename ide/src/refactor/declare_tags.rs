//! All tags that no declaration names get one, with the types and sections that follow from their uses.

use super::place::Place;
use super::{Action, ActionKind};
use ladder_analysis::declaration_fix::{Places, undeclared};
use ladder_analysis::scope::TagFacts;

pub(super) fn offer(place: &Place<'_>, out: &mut Vec<Action>) {
    let context = place.context;
    let scope = match place.networks.clone().next() {
        Some(network) => context.networks[network].scope,
        None => return,
    };
    let touched = |tag: &TagFacts| {
        let mut blocks = tag
            .uses
            .iter()
            .map(|found| context.networks[found.network].blocks[found.block].range());
        blocks.any(|block| block.start() <= place.range.end() && place.range.start() <= block.end())
    };
    let found = undeclared(context, scope);
    let at_one = found
        .iter()
        .any(|declared| touched(&context.scopes[scope].tags[declared.tag]));
    // One alone is mended where it is found.
    if !at_one || found.len() < 2 && scope > 0 {
        return;
    }
    let tags: Vec<_> = found
        .iter()
        .map(|declared| (declared.section, declared.name.clone(), declared.ty.clone()))
        .collect();
    let Some(edits) = Places::new(context, scope).declare_all(&tags) else {
        return;
    };
    let of = if scope == 0 { "file" } else { "block" };
    let title = match tags.len() {
        1 => format!("Declare the undeclared tag of the {of}"),
        count => format!("Declare the {count} undeclared tags of the {of}"),
    };
    out.push(Action::new(ActionKind::Rewrite, title, edits));
}
