//! From a parse to its [`Context`]: declarations, networks, uses, shared tags, types.

use super::at_address::AtAddress;
use super::{infer, shared, skeleton, uses};
use crate::names::context::Context;
use crate::other_files::others::Others;
use crate::still_wanted::StillWanted;
use ladder_syntax::Parse;
use std::sync::Arc;

/// How a file's names are read.
#[derive(Clone, Copy)]
pub struct ContextOptions<'a> {
    name: &'a str,
    others: &'a Others,
    before: Option<&'a Context>,
}

impl<'a> ContextOptions<'a> {
    /// Among the other files of its workspace. Messages call it by this name.
    pub fn new(name: &'a str, others: &'a Others) -> ContextOptions<'a> {
        ContextOptions {
            name,
            others,
            before: None,
        }
    }

    /// For a text that came from another one by edits: what both have is taken from the earlier one's context. What comes out
    /// does not depend on it.
    #[must_use]
    pub fn after(self, before: Option<&'a Context>) -> ContextOptions<'a> {
        ContextOptions { before, ..self }
    }

    /// Reads them while `wanted` holds: that is asked between each [`BETWEEN`](crate::BETWEEN) networks, tags or declarations.
    /// None once it does not.
    pub fn read_while(self, parse: &Arc<Parse>, wanted: &dyn Fn() -> bool) -> Option<Context> {
        let wanted = StillWanted::new(wanted);
        let mut context = skeleton::skeleton(parse, self.name, self.others, self.before, &wanted)?;
        uses::collect(&mut context, &wanted)?;
        shared::share(&mut context);
        context.at_address = AtAddress::of(&context.scopes);
        infer::infer(&mut context, &wanted)?;
        Some(context)
    }
}

/// Reads a file's names, networks and blocks.
pub fn context(parse: &Arc<Parse>, options: ContextOptions<'_>) -> Context {
    match options.read_while(parse, &|| true) {
        Some(context) => context,
        None => unreachable!("it is always wanted"),
    }
}
