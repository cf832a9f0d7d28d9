//! Programs from texts.

use ladder_analysis::Others;
use ladder_analysis::names::join::context;
use ladder_review::Outline;
use ladder_syntax::parse;
use std::sync::Arc;

/// The entries of a text that is alone.
pub(crate) fn outline(text: &str) -> Outline {
    let context = context(&Arc::new(parse(text)), "main.clad", &Others::alone());
    Outline::new(Arc::new(context))
}
