//! Hover on a declared name: the tag's card.

use super::Hover;
use super::operand::tag_card;
use ladder_analysis::context::Context;
use ladder_syntax::TextSize;

pub(super) fn hover(context: &Context, offset: TextSize) -> Option<Hover> {
    let tag = context
        .scopes
        .iter()
        .flat_map(|scope| &scope.tags)
        .find(|tag| tag.is_declared() && context.place_of(tag).contains_inclusive(offset))?;
    Some(Hover {
        range: context.place_of(tag),
        markdown: tag_card(context, tag, None),
    })
}
