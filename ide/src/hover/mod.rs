//! Hover: what the thing under the pointer is.

mod block;
mod connector;
mod declaration;
mod keyword;
mod operand;
mod other_files;
mod types;
mod user_block;
mod uses;
mod wire;

pub use other_files::used_in_other_files;

pub(crate) use block::instruction as instruction_card;
pub(crate) use keyword::card as keyword_card;
pub(crate) use operand::tag_card;
pub(crate) use user_block::{block_named, user_block_card};

use crate::locate::on_rung;
use ladder_analysis::context::Context;
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{LineKind, TextRange, TextSize};

/// What a hover shows, and for which stretch of the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    /// The thing it is about.
    pub range: TextRange,
    /// Markdown.
    pub markdown: String,
}

/// What is at an offset.
pub fn hover(context: &Context, offset: TextSize) -> Option<Hover> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    match parse.lines()[line].kind {
        LineKind::Rung => {
            let place = on_rung(context, offset)?;
            match place.drawn.kind {
                PartKind::Down | PartKind::Up => Some(connector::hover(context, &place)),
                PartKind::Block => {
                    let block = place.block?;
                    types::hover(context, offset)
                        .or_else(|| operand::hover(context, &place, block, offset))
                        .or_else(|| block::hover(context, block))
                }
                PartKind::Wire | PartKind::LeftRail | PartKind::RightRail => wire::hover(context, &place),
                _ => None,
            }
        }
        LineKind::SectionHeader
        | LineKind::SectionEnd
        | LineKind::Declaration
        | LineKind::StructHeader
        | LineKind::StructEnd
        | LineKind::BlockHeader
        | LineKind::BlockEnd => keyword::hover(parse, line, offset)
            .or_else(|| declaration::hover(context, offset))
            .or_else(|| types::hover(context, offset)),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
