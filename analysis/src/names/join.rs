//! From a parse to its [`Context`]: declarations, networks, uses, shared tags, types.

use super::at_address::AtAddress;
use super::{infer, shared, skeleton, uses};
use crate::cancel::Cancel;
use crate::names::context::Context;
use crate::other_files::others::Others;
use ladder_syntax::Parse;
use std::sync::Arc;

/// Reads a file's names, networks and blocks; none if that is cancelled. What an earlier text had as well is taken from its context.
pub(crate) fn read(
    parse: &Arc<Parse>,
    name: &str,
    others: &Others,
    before: Option<&Context>,
    cancel: &Cancel,
) -> Option<Context> {
    let mut context = skeleton::skeleton(parse, name, others, before, cancel)?;
    uses::collect(&mut context, cancel)?;
    shared::share(&mut context);
    context.at_address = AtAddress::of(&context.scopes);
    infer::infer(&mut context, cancel)?;
    Some(context)
}
