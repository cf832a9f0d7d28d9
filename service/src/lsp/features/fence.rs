//! `ladder.fence`: ladder text of another document, coloured and drawn.

use std::sync::Arc;

use ladder_analysis::context;
use ladder_analysis::networks::BlockAt;
use ladder_ide::{Modifiers, Token, TokenKind, semantic_tokens};
use ladder_instructions::Shape;
use ladder_live::{Failure, argument_of};
use ladder_picture::{Options, Theme, picture, svg};
use ladder_syntax::TextRange;
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const FENCE: &str = "ladder.fence";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Fence = argument_of(FENCE, params.arguments).map_err(error)?;
    let drawn = blocking(&*shared.host, move |_| draw(&asked)).await?;
    json(&drawn.ok_or_else(|| error(Failure::Failed("the text is too large to be drawn".to_owned())))?)
}

/// A longer text is coloured and drawn in no document: it is a program, and has an editor.
const MOST_BYTES: usize = 64 << 10;

/// The argument of `ladder.fence`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Fence {
    /// The ladder text. It need not be in any file.
    pub text: String,
}

/// The answer to `ladder.fence`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnFence {
    /// The text in pieces, in its order and complete.
    pub words: Vec<FenceWord>,
    /// The picture as SVG, where a network is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<FencePicture>,
}

/// A piece of the text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct FenceWord {
    /// As it is written.
    pub text: String,
    /// What it is, by the types of semantic tokens; `input`, `output`, `contact` and `coil` go before those. Nothing for the
    /// drawing.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub kind: String,
}

/// A picture in both colours.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct FencePicture {
    /// Dark lines on a light ground.
    pub light: String,
    /// Light lines on a dark ground.
    pub dark: String,
}

/// Colours and draws a text. None for one that is too large.
pub(crate) fn draw(fence: &Fence) -> Option<DrawnFence> {
    let text = &fence.text;
    if text.len() > MOST_BYTES {
        return None;
    }
    let parse = Arc::new(ladder_syntax::parse(text));
    let context = context(&parse, "fence.clad");
    let mut words = Vec::new();
    let mut at = 0;
    let mut piece = |range: std::ops::Range<usize>, kind: &str| {
        if !range.is_empty() {
            words.push(FenceWord {
                text: text[range].to_owned(),
                kind: kind.to_owned(),
            });
        }
    };
    let tokens = semantic_tokens(&context, None).into_iter();
    let mut kinds: Vec<(TextRange, &str)> = tokens.map(|token| (token.range, kind_of(token))).collect();
    // The brackets of contacts and coils have their colour, too.
    let blocks = context
        .networks
        .iter()
        .flat_map(|network| network.blocks().collect::<Vec<_>>());
    let heads: Vec<(TextRange, &str)> = blocks.filter_map(head).collect();
    kinds.retain(|(range, _)| heads.binary_search_by(|(head, _)| head.ordering(*range)).is_err());
    kinds.extend(heads);
    kinds.sort_by_key(|(range, _)| range.start());
    for (range, kind) in kinds {
        let range = std::ops::Range::<usize>::from(range);
        piece(at..range.start, "");
        at = range.end;
        piece(range, kind);
    }
    piece(at..text.len(), "");
    let picture = (!context.networks.is_empty()).then(|| {
        let picture = picture(&context, &Options::default());
        FencePicture {
            light: svg(&picture, Theme::Light),
            dark: svg(&picture, Theme::Dark),
        }
    });
    Some(DrawnFence { words, picture })
}

/// The first part of a contact or coil.
fn head(block: BlockAt<'_>) -> Option<(TextRange, &'static str)> {
    let kind = match block.instruction()? {
        row if row.power.is_contact() => "contact",
        _ if block.facts.shape == Shape::Coil => "coil",
        _ => return None,
    };
    Some((block.head_range(), kind))
}

fn kind_of(token: Token) -> &'static str {
    let roles = [
        Modifiers::INPUT,
        Modifiers::OUTPUT,
        Modifiers::CONTACT,
        Modifiers::COIL,
    ];
    let role = roles.iter().find(|role| token.modifiers.0 & role.0 != 0);
    if let Some(role) = role {
        let (_, name, _) = Modifiers::LEGEND[role.0.trailing_zeros() as usize];
        return name;
    }
    TokenKind::LEGEND[token.kind as usize].1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(text: &str) -> DrawnFence {
        draw(&Fence {
            text: text.to_owned(),
        })
        .unwrap()
    }

    #[test]
    fn words_are_all_of_the_text() {
        let text = "# a <b> #\n+--[/]( a )--[TON]( t, 5s )--(S)( y )--+\n";
        let fence = drawn(text);
        let whole: String = fence.words.iter().map(|word| word.text.as_str()).collect();
        assert_eq!(whole, text);
        let kinds: Vec<(&str, &str)> = fence
            .words
            .iter()
            .filter(|word| !word.kind.is_empty())
            .map(|word| (word.text.as_str(), word.kind.as_str()))
            .collect();
        let expected = [
            ("# a <b> #", "comment"),
            ("[/]", "contact"),
            ("a", "input"),
            ("TON", "function"),
            ("t", "variable"),
            ("5s", "number"),
            ("(S)", "coil"),
            ("y", "output"),
        ];
        assert_eq!(kinds, expected);
    }

    #[test]
    fn what_a_text_says_is_no_markup_in_its_picture() {
        let picture = drawn("# </text><script>alert(1)</script> #\n+--( )( y )--+\n")
            .picture
            .unwrap();
        for svg in [&picture.light, &picture.dark] {
            assert!(svg.starts_with("<svg ") && !svg.contains("<script"), "{svg}");
        }
        assert!(picture.light != picture.dark);
        assert_eq!(drawn("no diagram").picture, None);
        let long = "x".repeat(MOST_BYTES + 1);
        assert_eq!(draw(&Fence { text: long }), None);
    }
}
