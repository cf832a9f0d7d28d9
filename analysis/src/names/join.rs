//! From a parse to its [`Context`]: declarations, networks, uses, shared tags, types.

use super::at_address::AtAddress;
use super::{infer, shared, skeleton, uses};
use crate::names::context::Context;
use crate::other_files::others::Others;
use crate::still_wanted::StillWanted;
use ladder_syntax::Parse;
use std::sync::Arc;

/// Reads a file's names, networks and blocks, while that is wanted. What an earlier text had as well is taken from its context.
pub(crate) fn read(
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    before: Option<&Context>,
    wanted: &StillWanted<'_>,
) -> Option<Context> {
    let mut context = skeleton::skeleton(parse, name, others, before, wanted)?;
    uses::collect(&mut context, wanted)?;
    shared::share(&mut context);
    context.at_address = AtAddress::of(&context.scopes);
    infer::infer(&mut context, wanted)?;
    Some(context)
}
