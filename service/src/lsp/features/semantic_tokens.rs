//! `textDocument/semanticTokens/full`, `/full/delta` and `/range`.

use std::sync::Arc;

use ladder_documents::position::{self, Position};
use ladder_documents::sweep::Sweep;
use ladder_documents::{Revision, in_parallel};
use ladder_ide::{Modifiers, Token, TokenKind, semantic_tokens, semantic_tokens_of};
use ladder_syntax::TextRange;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult, SemanticTokensFullOptions,
    SemanticTokensLegend, SemanticTokensOptions, SemanticTokensParams, SemanticTokensRangeParams,
    SemanticTokensRangeResult, SemanticTokensResult, SemanticTokensServerCapabilities,
};

use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

/// What the server offers.
pub(crate) fn options() -> SemanticTokensServerCapabilities {
    SemanticTokensServerCapabilities::SemanticTokensOptions(SemanticTokensOptions {
        legend: SemanticTokensLegend {
            token_types: TokenKind::LEGEND
                .map(|(_, name, _)| SemanticTokenType::new(name))
                .to_vec(),
            token_modifiers: Modifiers::LEGEND
                .map(|(_, name, _)| SemanticTokenModifier::new(name))
                .to_vec(),
        },
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    })
}

pub(crate) async fn full(
    shared: &Arc<Shared>,
    params: SemanticTokensParams,
) -> Result<Option<SemanticTokensResult>> {
    let uri = params.text_document.uri.as_str();
    let Some(tokens) = tokens(shared, uri, None).await? else {
        return Ok(None);
    };
    let result_id = Some(shared.tokens_sent.keep(uri, tokens.clone()));
    Ok(Some(SemanticTokensResult::Tokens(all(result_id, &tokens))))
}

/// All of these tokens, as they are sent.
fn all(result_id: Option<String>, tokens: &[SemanticToken]) -> SemanticTokens {
    SemanticTokens {
        result_id,
        data: tokens.to_vec(),
    }
}

pub(crate) async fn delta(
    shared: &Arc<Shared>,
    params: SemanticTokensDeltaParams,
) -> Result<Option<SemanticTokensFullDeltaResult>> {
    let uri = params.text_document.uri.as_str();
    let Some(new) = tokens(shared, uri, None).await? else {
        return Ok(None);
    };
    let old = shared.tokens_sent.last(uri, &params.previous_result_id);
    let result_id = Some(shared.tokens_sent.keep(uri, new.clone()));
    let Some(old) = old else {
        return Ok(Some(SemanticTokensFullDeltaResult::Tokens(all(result_id, &new))));
    };
    Ok(Some(SemanticTokensFullDeltaResult::TokensDelta(
        SemanticTokensDelta {
            result_id,
            edits: difference(&old, &new).into_iter().collect(),
        },
    )))
}

pub(crate) async fn range(
    shared: &Arc<Shared>,
    params: SemanticTokensRangeParams,
) -> Result<Option<SemanticTokensRangeResult>> {
    let range = convert::our_range(params.range);
    let tokens = tokens(shared, params.text_document.uri.as_str(), Some(range)).await?;
    Ok(tokens.map(|tokens| SemanticTokensRangeResult::Tokens(all(None, &tokens))))
}

async fn tokens(
    shared: &Arc<Shared>,
    uri: &str,
    range: Option<position::Range>,
) -> Result<Option<Arc<Vec<SemanticToken>>>> {
    let Some(revision) = shared.documents.get(uri) else {
        return Ok(None);
    };
    let several_lines = shared.agreed().multiline_tokens;
    blocking(&*shared.host, move |_| {
        let (context, _) = revision.first_context()?;
        let encode = |tokens: &[Token]| encoded(&revision, tokens, several_lines);
        let Some(range) = range else {
            let lines = context.parse.lines().len();
            let firsts: Vec<usize> = (0..lines).step_by(STRETCH).collect();
            let stretches = in_parallel::map(&firsts, |&first| {
                Some(encode(&semantic_tokens_of(
                    context,
                    first..lines.min(first + STRETCH),
                )))
            });
            return Some(joined(stretches));
        };
        let (start, end) = (revision.offset(range.start), revision.offset(range.end));
        let tokens = semantic_tokens(context, Some(TextRange::new(start.min(end), start.max(end))));
        Some(joined(vec![encode(&tokens)]))
    })
    .await
}

/// This many lines are gone through at once. Those of a short program are too few for a second thread.
const STRETCH: usize = 256;

/// The tokens of stretches, each after the one before it.
fn joined(stretches: Vec<Encoded>) -> Arc<Vec<SemanticToken>> {
    let mut all = Vec::new();
    let mut last = Position::default();
    for stretch in stretches {
        let Some(first) = stretch.tokens.first() else {
            continue;
        };
        let same_line = first.delta_line == last.line;
        all.push(SemanticToken {
            delta_line: first.delta_line - last.line,
            delta_start: first.delta_start - if same_line { last.character } else { 0 },
            ..*first
        });
        all.extend_from_slice(&stretch.tokens[1..]);
        last = stretch.last;
    }
    Arc::new(all)
}

/// Tokens as the protocol counts them: each from the one before it, the first from the start of the text.
#[derive(Debug, Default)]
struct Encoded {
    tokens: Vec<SemanticToken>,
    /// Where the last one starts.
    last: Position,
}

fn encoded(revision: &Revision, tokens: &[Token], several_lines: bool) -> Encoded {
    let (Some(first), Some(last)) = (tokens.first(), tokens.last()) else {
        return Encoded::default();
    };
    let start = revision.range(first.range).start;
    let base = usize::from(revision.line_start(start.line));
    let text = revision.stretch(base..usize::from(last.range.end()));
    let mut sweep = Sweep::new(&text, revision.encoding(), start.line);
    let mut before = Position::default();
    let mut out = Vec::with_capacity(tokens.len());
    for token in tokens {
        let (from, to) = (
            usize::from(token.range.start()) - base,
            usize::from(token.range.end()) - base,
        );
        let mut add = |from: usize, to: usize| {
            let (start, end) = (sweep.position(from), sweep.position(to));
            // The length of one that spans lines counts their units, line ends included.
            let length = if end.line == start.line {
                end.character - start.character
            } else {
                position::length(&text[from..to], revision.encoding())
            };
            let same_line = start.line == before.line;
            out.push(SemanticToken {
                delta_line: start.line - before.line,
                delta_start: start.character - if same_line { before.character } else { 0 },
                length,
                token_type: token.kind as u32,
                token_modifiers_bitset: u32::from(token.modifiers.0),
            });
            before = start;
        };
        let written = &text[from..to];
        if several_lines || !written.contains(['\n', '\r']) {
            add(from, to);
            continue;
        }
        let mut at = from;
        for line in written.split_inclusive(['\n', '\r']) {
            let end = at + line.trim_end_matches(['\n', '\r']).len();
            if end > at {
                add(at, end);
            }
            at += line.len();
        }
    }
    Encoded {
        tokens: out,
        last: before,
    }
}

/// The one stretch that differs, in numbers: five for each token.
fn difference(old: &[SemanticToken], new: &[SemanticToken]) -> Option<SemanticTokensEdit> {
    let before = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let (old, new) = (&old[before..], &new[before..]);
    let after = old
        .iter()
        .rev()
        .zip(new.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let (old, new) = (&old[..old.len() - after], &new[..new.len() - after]);
    (!old.is_empty() || !new.is_empty()).then(|| SemanticTokensEdit {
        start: before as u32 * 5,
        delete_count: old.len() as u32 * 5,
        data: (!new.is_empty()).then(|| new.to_vec()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_differs_is_reported() {
        let tokens = |numbers: &[u32]| -> Vec<SemanticToken> {
            let token = |&delta_start| SemanticToken {
                delta_start,
                ..SemanticToken::default()
            };
            numbers.iter().map(token).collect()
        };
        let check = |old: &[u32], new: &[u32], expected: Option<(u32, u32, &[u32])>| {
            let found = difference(&tokens(old), &tokens(new));
            let expected = expected.map(|(start, delete_count, data)| SemanticTokensEdit {
                start,
                delete_count,
                data: (!data.is_empty()).then(|| tokens(data)),
            });
            assert_eq!(found, expected);
        };
        check(&[1, 2, 3], &[1, 2, 3], None);
        check(&[1, 2, 3], &[1, 4, 3], Some((5, 5, &[4])));
        check(&[1, 2, 3], &[1, 3], Some((5, 5, &[])));
        check(&[1, 1], &[1, 1, 1], Some((10, 0, &[1])));
        check(&[], &[1], Some((0, 0, &[1])));
    }
}
