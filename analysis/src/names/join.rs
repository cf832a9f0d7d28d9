//! From a parse to its [`Context`]: declarations, networks, uses, shared tags, types.

use super::at_address::AtAddress;
use super::{infer, shared, skeleton, uses};
use crate::context::Context;
use crate::other_files::others::Others;
use crate::still_wanted::StillWanted;
use ladder_syntax::Parse;
use std::sync::Arc;

/// Reads a file's names, networks and blocks. Messages call the file by this name.
pub fn context(parse: &Arc<Parse>, name: &str, others: &Others) -> Context {
    context_after(None, parse, name, others)
}

/// As [`context()`]. What an earlier text had as well is taken from its context.
pub fn context_after(before: Option<&Context>, parse: &Arc<Parse>, name: &str, others: &Others) -> Context {
    match context_while(before, parse, name, others, &|| true) {
        Some(context) => context,
        None => unreachable!("it is always wanted"),
    }
}

/// As [`context_after()`], while `wanted` holds: that is asked between each [`BETWEEN`](crate::BETWEEN) networks, tags or
/// declarations. None once it does not.
pub fn context_while(
    before: Option<&Context>,
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    wanted: &dyn Fn() -> bool,
) -> Option<Context> {
    let wanted = StillWanted::new(wanted);
    let mut context = skeleton::skeleton(parse, name, others, before, &wanted)?;
    uses::collect(&mut context, &wanted)?;
    shared::share(&mut context);
    context.at_address = AtAddress::of(&context.scopes);
    infer::infer(&mut context, &wanted)?;
    Some(context)
}
