//! `ladder.diagram`: the diagram of an open program, for a page next to its text. `docs/protocol.md` shows the messages.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use ladder_documents::position::Position;
use ladder_documents::{Lines, Revision};
use ladder_ide::points_of;
use ladder_live::{Failure, argument_of};
use ladder_picture::live::{self, Kind, Piece};
use ladder_syntax::{TextRange, TextSize};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const DIAGRAM: &str = "ladder.diagram";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Diagram = argument_of(DIAGRAM, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let name = revision.name().to_owned();
    let drawn = blocking(&*shared.host, move |_| draw(&revision, &asked)).await?;
    json(&drawn.ok_or_else(|| failed(format!("{name} is too large to be drawn")))?)
}

/// More lines than this are no page.
const MOST_LINES: u32 = 1000;
/// Where the right rail may be, in letters from the left one.
const RAILS: std::ops::RangeInclusive<u32> = 20..=400;
/// Where it is unless the client says so.
const RAIL: u32 = 60;

/// The argument of `ladder.diagram`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Diagram {
    /// The program, which must be open.
    pub uri: String,
    /// The lines of its text that are shown.
    pub lines: Lines,
    /// Where the right rail is to be, in letters from the left one; a wider network has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail: Option<u32>,
    /// Keys of the drawings that the client has.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<String>,
}

/// The answer to `ladder.diagram`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Drawn {
    /// The program.
    pub uri: String,
    /// The version of its text.
    pub version: i32,
    /// How many lines that has.
    pub line_count: u32,
    /// The lines of which all is sent: those that were asked for, and the rest of the pieces at their ends.
    pub lines: Lines,
    /// What is there, from top to bottom.
    pub pieces: Vec<DrawnPiece>,
}

/// A comment, heading or network.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnPiece {
    /// What it is.
    pub kind: PieceKind,
    /// Its lines in the text.
    pub lines: Lines,
    /// Its width in pixels.
    pub width: i32,
    /// Its height.
    pub height: i32,
    /// False where nothing can be drawn in it; none elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub editable: Option<bool>,
    /// Why not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// Two drawings with the same key are the same.
    pub key: String,
    /// The drawing, an SVG element; none if the client has it. Places in it are `line:character`, and lines count from
    /// the first line of the piece.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub svg: Option<String>,
}

/// What a piece is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum PieceKind {
    /// Comments on lines of their own.
    Comment,
    /// The first or last line of a user-defined block.
    Heading,
    /// A network.
    Network,
    /// A network with an error in its drawing, shown as text, and whatever is after a comment that is never closed.
    Broken,
}

/// Draws what is asked for; none if the text is too large. For a blocking thread.
pub(crate) fn draw(revision: &Revision, asked: &Diagram) -> Option<Drawn> {
    let context = revision.context()?;
    let first = asked.lines.first.min(revision.last_line());
    let last = asked
        .lines
        .last
        .clamp(first, first.saturating_add(MOST_LINES - 1));
    let last = last.min(revision.last_line());
    let start = revision.line_start(first);
    let stretch = TextRange::new(start, revision.line_start(last + 1).max(start));
    let rail = asked.rail.unwrap_or(RAIL).clamp(*RAILS.start(), *RAILS.end());
    let mut lines = Lines { first, last };
    let pieces = live::pieces(context, stretch, rail);
    let pieces = pieces.iter().map(|piece| {
        let own = lines_of(revision, piece);
        lines.first = lines.first.min(own.first);
        lines.last = lines.last.max(own.last);
        let place = |offset: TextSize| {
            let Position { line, character } = revision.range(TextRange::empty(offset)).start;
            format!("{}:{character}", line - own.first.min(line))
        };
        let points = piece.network().map(|network| points_of(context, network));
        let points = points.unwrap_or(Ok(Vec::new()));
        let svg = piece.svg(context, points.as_deref().unwrap_or(&[]), &place);
        let key = key_of(&svg);
        let (width, height) = piece.size();
        DrawnPiece {
            kind: match piece.kind(context) {
                Kind::Comment => PieceKind::Comment,
                Kind::Heading => PieceKind::Heading,
                Kind::Network => PieceKind::Network,
                Kind::Broken => PieceKind::Broken,
            },
            lines: own,
            width,
            height,
            editable: points.is_err().then_some(false),
            why: points.err(),
            svg: (!asked.known.contains(&key)).then_some(svg),
            key,
        }
    });
    let pieces = pieces.collect();
    Some(Drawn {
        uri: revision.uri.to_string(),
        version: revision.version,
        line_count: revision.last_line() + 1,
        lines,
        pieces,
    })
}

fn lines_of(revision: &Revision, piece: &Piece) -> Lines {
    let (start, end) = (piece.range.start(), piece.range.end());
    let last = end.checked_sub(1.into()).unwrap_or(start).max(start);
    Lines {
        first: revision.line_of(start),
        last: revision.line_of(last),
    }
}

/// What stands for a drawing. The same in every run of one version of the program, which is more than is promised.
fn key_of(svg: &str) -> String {
    let mut hasher = DefaultHasher::new();
    svg.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}
