//! What the list of an unread part names that is not a tag (LANGUAGE §5.9).

use crate::names::context::Context;
use crate::names::scope::{Scope, type_by_form};
use crate::networks::network::{BoundBlock, Meaning};
use crate::program::{Unread, root_of};
use ladder_syntax::Name;

/// The names in the list of an unread part that mean no tag: neither one of its body nor one where it is, as far as the file
/// shows where that is.
pub(super) fn unknown_names<'u>(context: &Context, item: usize, unread: &'u Unread) -> Vec<&'u str> {
    let mut callers: Vec<&Scope> = Vec::new();
    for network in &context.networks {
        let is_it = |block: &BoundBlock| matches!(block.meaning, Meaning::User(index) if index == item);
        if network.blocks.iter().any(is_it) {
            callers.push(&context.scopes[network.scope]);
        }
    }
    if unread.directive.at_any_time {
        callers.push(&context.scopes[0]);
    }
    let paths = unread.directive.writes.iter().flatten();
    let is_unknown = |path: &&String| {
        let root = root_of(path);
        let name = Name::new(root);
        let is_seen = |scope: &Scope| scope.find(&name).is_some();
        let is_known = is_seen(&context.scopes[item + 1])
            || callers.iter().any(|scope| is_seen(scope))
            || context.others.globals(&name).next().is_some()
            || type_by_form(root).is_some();
        !is_known && !callers.is_empty()
    };
    paths.filter(is_unknown).map(String::as_str).collect()
}
